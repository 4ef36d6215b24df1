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
  context_.saves().add(Words::tr("The calibration is not saved in the take"),
                       [take = std::move(take)] { return take::save_info(take); });
}

}  // namespace limbwave::ui
