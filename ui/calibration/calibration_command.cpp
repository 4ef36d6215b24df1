#include "calibration/calibration_command.h"

#include <utility>

namespace limbwave::ui {

Status LibraryEntry::save(const take::CalibrationLibrary& library) {
  std::vector<std::filesystem::path> written;
  const auto keep = [&](Result<std::filesystem::path> file) -> Status {
    if (!file) {
      for (const std::filesystem::path& path : written) {
        (void)library.remove(path);
      }
      return file.error();
    }
    written.push_back(std::move(file).value());
    return {};
  };
  for (const auto& [key, range] : ranges) {
    if (Status status = keep(library.save_sensor(key, range)); !status) {
      return status;
    }
  }
  if (!mounts.empty()) {
    if (Status status = keep(library.save_mounts(rig, subject, mounts)); !status) {
      return status;
    }
  }
  files = std::move(written);
  return {};
}

Status LibraryEntry::remove(const take::CalibrationLibrary& library) {
  Status first;
  for (const std::filesystem::path& path : std::exchange(files, {})) {
    if (Status status = library.remove(path); !status && first) {
      first = status;
    }
  }
  return first;
}

WearerCommand::WearerCommand(StudioContext& context, QString after, const QString& text)
    : QUndoCommand(text), context_(context), before_(context.wearer()), after_(std::move(after)) {}

CalibrationCommand::CalibrationCommand(CalibrationDesk& desk, CalibrationDesk::Target target,
                                       std::optional<calibrate::RigCalibration> before, calibrate::RigCalibration after,
                                       std::shared_ptr<LibraryEntry> entry, const QString& text)
    : QUndoCommand(text),
      desk_(&desk),
      target_(std::move(target)),
      before_(std::move(before)),
      after_(std::move(after)),
      entry_(std::move(entry)) {}

void CalibrationCommand::redo() {
  if (!desk_) {
    setObsolete(true);
    return;
  }
  desk_->put_in_use(target_, after_);
  if (entry_ && !std::exchange(in_library_, true)) {
    desk_->change_library(entry_, true);
  }
}

void CalibrationCommand::undo() {
  if (!desk_) {
    setObsolete(true);
    return;
  }
  desk_->put_in_use(target_, before_);
  if (entry_ && std::exchange(in_library_, false)) {
    desk_->change_library(entry_, false);
    // It may be done from another page, and another step may follow that makes it final.
    desk_->context().notifications().post(
        Severity::kWarning, CalibrationDesk::tr("Undone: %1. It is not used any more.").arg(text()),
        CalibrationDesk::tr("Redo brings it back. Its file stays in the library's folder, ending in \".removed\"."));
  }
}

}  // namespace limbwave::ui
