/// A running capture: source → recorder (raw first) → decoder → solver, on one worker thread of its own. Faces poll
/// snapshots at their own pace (25–60 Hz) and never wait for the worker.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/live_source.h"
#include "base/diagnostics.h"
#include "base/result.h"
#include "decode/slot_alignment.h"
#include "solve/sensor_health.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::solve {

/// What a face shows. Vectors hold the most recent part only.
struct LiveSnapshot {
  std::uint64_t version = 0;   ///< Changes whenever anything else does.
  double stream_time_s = 0.0;  ///< Of the newest sample.
  acquire::StreamFormat format;
  decode::LineInStatus line;
  std::vector<float> scope;                                  ///< Interleaved stereo, the newest 100 ms.
  double scope_first_sample = 0.0;                           ///< Position of scope[0] in the stream.
  std::vector<decode::LineInCycle> scope_cycles;             ///< Cycles that overlap the scope.
  std::vector<decode::AccelerationFrame> frames;             ///< Newest 10 s of volts.
  std::vector<std::vector<Eigen::Vector3d>> specific_force;  ///< Per sensor, same instants, m/s², S frame.
  std::vector<SensorHealth> health;                          ///< Per accelerometer.
  std::vector<body::SegmentPose> pose;  ///< Newest solved pose of the skeleton; empty before the first.
  double pose_time_s = 0.0;
  Diagnostics diagnostics;  ///< Of the last 100, newest last.
  acquire::SourceCounters counters;
  bool source_alive = true;
  // Recording.
  bool recording = false;
  std::filesystem::path take_folder;
  double recorded_s = 0.0;
  double disk_left_s = 0.0;     ///< How long the disk lasts at this rate.
  std::string recording_error;  ///< Why recording stopped by itself; empty: it did not.
  /// Capture to pose ready, beyond the device's buffer: mean and largest of the last seconds, seconds.
  double latency_mean_s = 0.0, latency_max_s = 0.0, device_latency_s = 0.0;
  /// Monotonic time at which the newest sample that this pose used was captured (steady_clock seconds); a viewer adds
  /// its own drawing time to report capture-to-screen latency.
  double pose_capture_time_s = 0.0;
};

struct LiveSettings {
  body::Rig rig;
  body::Skeleton skeleton;
  calibrate::RigCalibration calibration;
  SolveSettings solve;
};

/// All functions may be called from any thread; the work happens on the session's own. `start_recording` and
/// `stop_recording` touch the disk: a GUI calls them from a job.
class LiveSession {
 public:
  LiveSession(std::unique_ptr<acquire::LiveSource> source, LiveSettings settings);
  ~LiveSession();  ///< Stops, closing a recording properly.

  Status start();
  void stop();

  /// Starts recording into a new take folder; raw samples from now on. Fails when the folder exists or cannot be made.
  Status start_recording(const std::filesystem::path& folder, const std::string& subject);
  /// Ends the recording; the take is complete on disk when this returns.
  Result<take::Take> stop_recording();
  /// Sets a marker at the newest sample of the recording and gives it a number; empty when nothing is recorded.
  std::optional<take::TakeEvent> mark(const std::string& text);
  /// Writes a line of the recording's events: another state of a marker, or its removal (take/markers.h). False when
  /// nothing is recorded.
  bool write_event(const take::TakeEvent& event);

  /// Takes effect from the next frame on.
  void set_calibration(const calibrate::RigCalibration& calibration);
  void set_headings(const std::vector<std::vector<HeadingKey>>& headings);

  /// A copy of the newest state, when it changed since `seen_version`; never blocks for longer than the copy.
  [[nodiscard]] std::shared_ptr<const LiveSnapshot> snapshot() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::solve
