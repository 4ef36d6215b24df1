#include "calibration/take_calibration_command.h"

#include <QCoreApplication>

namespace limbwave::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(TakeCalibrationCommand)
};

}  // namespace

TakeCalibrationCommand::TakeCalibrationCommand(StudioContext& context, calibrate::RigCalibration calibration)
    : QUndoCommand(Words::tr("Calibration")),
      context_(context),
      folder_(context.document().take()->folder),
      before_(context.document().take()->info.calibration),
      after_(std::move(calibration)) {}

void TakeCalibrationCommand::set(const std::optional<calibrate::RigCalibration>& calibration) {
  if (!context_.document().is_open() || context_.document().take()->folder != folder_) {
    return;
  }
  take::Take take = *context_.document().take();
  take.info.calibration = calibration;
  context_.document().set(take);
  context_.jobs().start(
      Words::tr("Saving the take"), &context_,
      [take = std::move(take)](const Progress&) { return take::save_info(take); },
      [&context = context_](const Status& status) {
        if (!status) {
          context.notifications().post_error(Words::tr("The calibration is not saved in the take"), status.error());
        }
      });
}

}  // namespace limbwave::ui
