/// Another calibration in use, and what it put into the library, as one step of
/// undo.
#pragma once

#include <QPointer>
#include <QUndoCommand>
#include <memory>
#include <optional>

#include "calibration/calibration_desk.h"

namespace limbwave::ui {

/// Files of the library that one calibration made. Shared with the work that
/// writes them.
struct LibraryEntry {
  std::vector<std::pair<std::string, calibrate::SensorCalibration>> ranges;  ///< By the sensor's key.
  std::vector<calibrate::MountCalibration> mounts;
  body::Rig rig;
  std::string subject;
  std::vector<std::filesystem::path> files;  ///< Those that are there now.

  /// Writes what is not there; fails with nothing half done left in `files`.
  Status save(const take::CalibrationLibrary& library);
  /// Takes out what `save` put in.
  Status remove(const take::CalibrationLibrary& library);
};

/// Who wears the sensors, as it was said in a wizard.
class WearerCommand : public QUndoCommand {
 public:
  WearerCommand(StudioContext& context, QString after, const QString& text);
  void undo() override { context_.set_wearer(before_); }
  void redo() override { context_.set_wearer(after_); }

 private:
  StudioContext& context_;
  QString before_, after_;
};

class CalibrationCommand : public QUndoCommand {
 public:
  /// `entry` may be null; otherwise it is in the library already.
  CalibrationCommand(CalibrationDesk& desk, CalibrationDesk::Target target,
                     std::optional<calibrate::RigCalibration> before, calibrate::RigCalibration after,
                     std::shared_ptr<LibraryEntry> entry, const QString& text);
  void undo() override;
  void redo() override;

 private:
  QPointer<CalibrationDesk> desk_;
  CalibrationDesk::Target target_;
  std::optional<calibrate::RigCalibration> before_, after_;
  std::shared_ptr<LibraryEntry> entry_;
  bool in_library_ = true;
};

}  // namespace limbwave::ui
