#include "workspaces/capture/board_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <set>

#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

BoardDialog::BoardDialog(const QString& device_title, const body::Rig& rig, const take::Board& board, QWidget* parent)
    : QDialog(parent), name_(new QLineEdit(QString::fromStdString(board.name), this)), problem_(new QLabel(this)) {
  setObjectName(QStringLiteral("board_dialog"));
  setWindowTitle(tr("Sensor board"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 2 * kGrid);
  layout->setSpacing(2 * kGrid);
  auto* what =
      new QLabel(tr("Calibrations are kept per sensor. Name the board on %1, so that another board's are never "
                    "taken for its own. Where the sensors carry serials, enter them: they then keep their "
                    "calibration on any board.")
                     .arg(device_title),
                 this);
  what->setWordWrap(true);
  layout->addWidget(what);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid);
  name_->setObjectName(QStringLiteral("board_name"));
  name_->setAccessibleName(tr("Name of the board"));
  name_->setPlaceholderText(tr("As written on it, such as “Lab 2”"));
  name_->setMaxLength(60);
  form->addRow(dim_label(tr("Board"), this), name_);
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    const QString sensor = QString::fromStdString(rig.accelerometers[s].name);
    auto* serial = new QLineEdit(this);
    serial->setObjectName(QStringLiteral("serial_%1").arg(s));
    serial->setAccessibleName(tr("Serial of %1").arg(sensor));
    serial->setMaxLength(60);
    serial->setPlaceholderText(
        rig.accelerometers[s].serial.empty() ? tr("none") : QString::fromStdString(rig.accelerometers[s].serial));
    if (s < board.serials.size()) {
      serial->setText(QString::fromStdString(board.serials[s]));
    }
    connect(serial, &QLineEdit::textChanged, this, &BoardDialog::check);
    form->addRow(dim_label(sensor, this), serial);
    serials_.push_back(serial);
  }
  layout->addLayout(form);
  problem_->setProperty("role", "danger");
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  keep_ = buttons->addButton(tr("Keep"), QDialogButtonBox::AcceptRole);
  keep_->setObjectName(QStringLiteral("keep_board"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(60 * kGrid);
  check();
}

take::Board BoardDialog::board() const {
  take::Board board;
  board.name = name_->text().trimmed().toStdString();
  for (const QLineEdit* serial : serials_) {
    board.serials.push_back(serial->text().trimmed().toStdString());
  }
  return board;
}

void BoardDialog::check() {
  std::set<std::string> seen;
  QString problem;
  for (const std::string& serial : board().serials) {
    if (!serial.empty() && !seen.insert(serial).second) {
      problem = tr("%1 is entered for two sensors.").arg(QString::fromStdString(serial));
    }
  }
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  keep_->setEnabled(problem.isEmpty());
}

}  // namespace limbwave::ui
