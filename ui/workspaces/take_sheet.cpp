#include "workspaces/take_sheet.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "common/widgets.h"
#include "take/sensor_places.h"
#include "workspaces/sensor_table.h"

namespace limbwave::ui {

TakeSheet::TakeSheet(StudioContext& context, QWidget* parent)
    : FormSheet(tr("Details of the take"),
                tr("The signals stay as they were recorded. When sensors were mixed up, say here which one was worn "
                   "where: the take is solved anew."),
                tr("Apply"), parent),
      context_(context),
      opening_(context.document().opening()) {
  setObjectName(QStringLiteral("take_sheet"));
  const take::Take& take = *context_.document().take();
  name_ = add_line(tr("Take"), QStringLiteral("take_name"), context_.document().name(), {});
  subject_ = add_line(tr("Subject"), QStringLiteral("take_subject"), QString::fromStdString(take.info.subject),
                      tr("Who wore the sensors"));
  std::vector<std::string> serials;
  for (const body::Accelerometer& sensor : take.info.rig.accelerometers) {
    serials.push_back(sensor.serial);
  }
  sensors_ = new SensorTable(take::places_of(take.info.rig), serials, {}, this);
  add_wide(sensors_);
  sensors_->setVisible(!serials.empty());
  verb()->setObjectName(QStringLiteral("apply_take"));
  connect(name_, &QLineEdit::textChanged, this, &TakeSheet::check);
  connect(sensors_, &SensorTable::changed, this, &TakeSheet::check);
  connect(this, &QDialog::accepted, this, &TakeSheet::apply);
}

void TakeSheet::check() {
  const QString problem = context_.take_edits().name_problem(name_->text().trimmed());
  set_problem(problem.isEmpty() ? sensors_->problem() : problem);
}

void TakeSheet::apply() {
  if (context_.document().is_open() && context_.document().opening() == opening_) {
    context_.take_edits().change(name_->text().trimmed(), subject_->text(), sensors_->places(), sensors_->serials());
  }
}

}  // namespace limbwave::ui
