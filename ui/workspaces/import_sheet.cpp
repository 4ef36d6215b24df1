#include "workspaces/import_sheet.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "common/format.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

QString import_name(const QString& takes_folder, const QString& file) {
  const QString stem = file_name_part(QFileInfo(file).completeBaseName());
  const QString wanted = stem.isEmpty() ? QStringLiteral("import") : stem;
  QString name = wanted;
  for (int n = 2; QFileInfo::exists(QDir(takes_folder).filePath(name + QStringLiteral(".take"))); ++n) {
    name = QStringLiteral("%1-%2").arg(wanted).arg(n);
  }
  return name;
}

ImportSheet::ImportSheet(StudioContext& context, const QStringList& files, QWidget* parent)
    : QDialog(parent),
      context_(context),
      name_(new QLineEdit(this)),
      rig_(new QComboBox(this)),
      subject_(new QLineEdit(this)),
      problem_(new QLabel(this)) {
  setObjectName(QStringLiteral("import_sheet"));
  setWindowTitle(tr("Import recordings"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 2 * kGrid);
  layout->setSpacing(2 * kGrid);
  QStringList names;
  for (const QString& file : files) {
    names << QFileInfo(file).fileName();
  }
  auto* what = new QLabel(files.size() == 1 ? tr("%1 becomes a take.").arg(names.first())
                                            : tr("These become one take, in this order: %1").arg(names.join(tr(", "))),
                          this);
  what->setWordWrap(true);
  layout->addWidget(what);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid);
  name_->setObjectName(QStringLiteral("import_name"));
  name_->setAccessibleName(tr("Name of the take"));
  name_->setMaxLength(200);
  name_->setText(import_name(context_.takes_folder(), files.first()));
  rig_->setObjectName(QStringLiteral("import_rig"));
  rig_->setAccessibleName(tr("Rig"));
  rig_->setToolTip(tr("What was worn where"));
  if (context_.services().list_rigs) {
    for (const RigChoice& rig : context_.services().list_rigs()) {
      rig_->addItem(QString::fromStdString(rig.title), QString::fromStdString(rig.name));
    }
  }
  const QString last =
      context_.settings().value(QStringLiteral("capture/rig"), QStringLiteral("line-in-arm")).toString();
  if (rig_->findData(last) < 0) {
    rig_->addItem(last, last);
  }
  rig_->setCurrentIndex(rig_->findData(last));
  subject_->setObjectName(QStringLiteral("import_subject"));
  subject_->setAccessibleName(tr("Subject"));
  subject_->setPlaceholderText(tr("Who wore the sensors"));
  subject_->setToolTip(tr("The mounting of this person in the calibration library is used"));
  subject_->setMaxLength(200);
  subject_->setText(context_.wearer());
  form->addRow(dim_label(tr("Take"), this), name_);
  form->addRow(dim_label(tr("Rig"), this), rig_);
  form->addRow(dim_label(tr("Subject"), this), subject_);
  layout->addLayout(form);
  problem_->setProperty("role", "danger");
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  import_ = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
  import_->setObjectName(QStringLiteral("import_button"));
  layout->addWidget(buttons);
  connect(name_, &QLineEdit::textChanged, this, &ImportSheet::check);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(56 * kGrid);
  check();
}

QString ImportSheet::take_name() const {
  return name_->text().trimmed();
}

QString ImportSheet::rig() const {
  return rig_->currentData().toString();
}

QString ImportSheet::subject() const {
  return subject_->text().trimmed();
}

void ImportSheet::check() {
  const QString problem = take_name_problem(context_.takes_folder(), take_name());
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  import_->setEnabled(problem.isEmpty());
}

}  // namespace limbwave::ui
