#include "workspaces/sensor_table.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <algorithm>
#include <set>

#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

SensorTable::SensorTable(const std::vector<std::string>& places, const std::vector<std::string>& serials,
                         const std::vector<std::string>& hints, QWidget* parent)
    : QWidget(parent), places_(places) {
  setObjectName(QStringLiteral("sensor_table"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(2 * kGrid);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  grid->addWidget(heading_label(tr("Socket"), this), 0, 0);
  grid->addWidget(heading_label(tr("Worn on"), this), 0, 1);
  grid->addWidget(heading_label(tr("Serial"), this), 0, 2);
  for (std::size_t s = 0; s < places_.size(); ++s) {
    const int row = static_cast<int>(s) + 1;
    grid->addWidget(dim_label(QString::number(row), this), row, 0);
    auto* box = new QComboBox(this);
    box->setObjectName(QStringLiteral("place_%1").arg(s));
    box->setAccessibleName(tr("Where the sensor in socket %1 is worn").arg(row));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(14);
    for (const std::string& place : places) {
      box->addItem(QString::fromStdString(place));
    }
    box->setCurrentText(QString::fromStdString(places_[s]));
    connect(box, &QComboBox::textActivated, this, [this, s](const QString& place) { choose(s, place); });
    grid->addWidget(box, row, 1);
    boxes_.push_back(box);
    auto* serial = new QLineEdit(this);
    serial->setObjectName(QStringLiteral("serial_%1").arg(s));
    serial->setAccessibleName(tr("Serial of the sensor in socket %1").arg(row));
    serial->setMaxLength(60);
    serial->setPlaceholderText(s < hints.size() && !hints[s].empty() ? QString::fromStdString(hints[s]) : tr("none"));
    if (s < serials.size()) {
      serial->setText(QString::fromStdString(serials[s]));
      serial->setCursorPosition(0);
    }
    connect(serial, &QLineEdit::textChanged, this, &SensorTable::changed);
    grid->addWidget(serial, row, 2);
    serials_.push_back(serial);
  }
}

void SensorTable::choose(std::size_t row, const QString& place) {
  const auto other = std::find(places_.begin(), places_.end(), place.toStdString());
  if (other == places_.end()) {
    return;
  }
  const auto at = static_cast<std::size_t>(other - places_.begin());
  std::swap(places_[row], places_[at]);
  boxes_[at]->setCurrentText(QString::fromStdString(places_[at]));
  boxes_[row]->setCurrentText(place);
  Q_EMIT changed();
}

std::vector<std::string> SensorTable::serials() const {
  std::vector<std::string> list;
  for (const QLineEdit* serial : serials_) {
    list.push_back(serial->text().trimmed().toStdString());
  }
  return list;
}

QString SensorTable::problem() const {
  std::set<std::string> seen;
  for (const std::string& serial : serials()) {
    if (!serial.empty() && !seen.insert(serial).second) {
      return tr("%1 is entered for two sensors.").arg(QString::fromStdString(serial));
    }
  }
  return {};
}

}  // namespace limbwave::ui
