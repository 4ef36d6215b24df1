/// Another calibration for the open take, as one step of undo.
#pragma once

#include <QUndoCommand>
#include <optional>

#include "calibrate/calibration.h"
#include "common/studio_context.h"

namespace limbwave::ui {

class TakeCalibrationCommand : public QUndoCommand {
 public:
  /// A take is open. `context` outlives this.
  TakeCalibrationCommand(StudioContext& context, calibrate::RigCalibration calibration);
  void undo() override { set(before_); }
  void redo() override { set(after_); }

 private:
  void set(const std::optional<calibrate::RigCalibration>& calibration);
  StudioContext& context_;
  std::filesystem::path folder_;
  std::optional<calibrate::RigCalibration> before_, after_;
};

}  // namespace limbwave::ui
