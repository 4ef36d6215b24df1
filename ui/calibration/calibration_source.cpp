#include "calibration/calibration_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limbwave::ui {

std::vector<decode::AccelerationFrame> newer_frames(const std::vector<decode::AccelerationFrame>& all, double after_s) {
  const auto first =
      std::partition_point(all.begin(), all.end(), [after_s](const auto& frame) { return frame.time_s <= after_s; });
  return {first, all.end()};
}

LiveCalibrationSource::LiveCalibrationSource(LiveModel& live, QObject* parent)
    : CalibrationSource(parent), live_(live) {
  connect(&live_, &LiveModel::snapshot_changed, this, &LiveCalibrationSource::read_snapshot);
  connect(&live_, &LiveModel::state_changed, this, [this] {
    last_time_s_ = -1.0;
    Q_EMIT changed();
  });
  connect(&live_, &LiveModel::calibration_changed, this, &CalibrationSource::changed);
  connect(&live_, &LiveModel::recording_changed, this, &LiveCalibrationSource::follow_recording);
  connect(&live_, &LiveModel::aside_finished, this, &CalibrationSource::recording_closed);
  connect(&live_, &LiveModel::recording_failed, this, &CalibrationSource::recording_failed);
}

bool LiveCalibrationSource::running() const {
  return live_.running() && (!live_.snapshot() || live_.snapshot()->source_alive);
}

void LiveCalibrationSource::set_calibration(const calibrate::RigCalibration& calibration) {
  live_.set_calibration(calibration);
}

bool LiveCalibrationSource::start_recording(const std::filesystem::path& folder, const QString& subject) {
  if (live_.recording() || live_.starting() || !live_.running()) {
    return false;
  }
  stop_wanted_ = false;
  if (live_.finishing()) {
    wanted_folder_ = folder;
    wanted_subject_ = subject;
    return true;
  }
  // Until the recording tells its own: the next sample that comes is its first.
  recording_start_s_ = live_.snapshot() ? live_.snapshot()->stream_time_s : 0.0;
  awaits_recording_ = live_.start_recording(folder, subject, true);
  return awaits_recording_;
}

void LiveCalibrationSource::stop_recording() {
  wanted_folder_.clear();
  stop_wanted_ = live_.starting();
  live_.stop_recording();
}

void LiveCalibrationSource::follow_recording() {
  if (live_.recording() && stop_wanted_) {
    stop_wanted_ = false;
    live_.stop_recording();
  } else if (!live_.recording() && !live_.finishing() && !wanted_folder_.empty()) {
    const std::filesystem::path folder = std::exchange(wanted_folder_, {});
    start_recording(folder, wanted_subject_);
  }
}

void LiveCalibrationSource::read_snapshot() {
  const auto& snapshot = live_.snapshot();
  if (!snapshot) {
    return;
  }
  if (snapshot->recording) {
    recording_start_s_ = snapshot->stream_time_s - snapshot->recorded_s;
  }
  if (awaits_recording_) {
    // What comes before the recording has begun is not kept, so it does not count: on a busy computer that is a second.
    if (!snapshot->recording && (live_.starting() || live_.recording())) {
      return;
    }
    awaits_recording_ = false;
    if (snapshot->recording) {
      last_time_s_ = std::max(last_time_s_, std::nextafter(recording_start_s_, 0.0));
    }
  }
  const std::vector<decode::AccelerationFrame> fresh = newer_frames(snapshot->frames, last_time_s_);
  if (!fresh.empty()) {
    last_time_s_ = fresh.back().time_s;
    Q_EMIT arrived(fresh);
  }
}

}  // namespace limbwave::ui
