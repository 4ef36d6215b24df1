/// A running capture: source → recorder (raw first) → decoder → solver, on one worker thread of its own that the source
/// wakes. Faces take snapshots at their own pace and figures when they come, and never wait for the worker.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/live_source.h"
#include "base/diagnostics.h"
#include "base/result.h"
#include "decode/slot_alignment.h"
#include "solve/live_latency.h"
#include "solve/sensor_health.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::solve {

struct LiveBodySnapshot;

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
  std::vector<body::SegmentPose> pose;                       ///< The newest; empty before the first.
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
  /// Capture of the oldest slot of the newest cycle → pose ready, beyond the device's buffer: of the last seconds.
  LatencyReport latency;
  double latency_mean_s = 0.0, latency_max_s = 0.0;  ///< Of its total.
  double device_latency_s = 0.0;                     ///< What the device says of its own buffer.
  bool preferred = false;                            ///< The worker runs before ordinary threads.
  /// Of a driver box (solve/live_body_session.h): what there is beyond the above; null: it is none. `line`, `scope`,
  /// `frames` and `specific_force` are a sound card's.
  std::shared_ptr<const LiveBodySnapshot> box;
};

/// The newest pose, handed over as soon as it is there.
struct LiveFigure {
  std::uint64_t number = 0;  ///< Counts poses.
  /// Of all segments, from every cycle that has been decoded: LivePose::ahead.
  std::vector<body::SegmentPose> pose;
  double time_s = 0.0;  ///< The instant it shows, on the stream's clock.
  PoseTimes times;      ///< Up to `solved`; zeros while the clock of the stream is not known.
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

  /// Starts recording into a new take folder; raw samples from now on. Where the source is known to have lost some,
  /// silence stands in for them, so that the rest keeps its time, and an event tells. Fails when the folder exists or
  /// cannot be made, or when a recording runs or is being started.
  Status start_recording(const std::filesystem::path& folder, const std::string& subject);
  /// Ends the recording; the take is complete on disk when this returns.
  Result<take::Take> stop_recording();
  /// Sets a marker at the newest sample of the recording and gives it a number; empty when nothing is recorded.
  std::optional<take::TakeEvent> mark(const std::string& text);
  /// Writes a line of the recording's events: another state of a marker, or its removal (take/markers.h). False when
  /// nothing is recorded.
  bool write_event(const take::TakeEvent& event);

  /// As LiveSource::ask.
  void ask(const std::string& what);

  /// Takes effect from the next frame on.
  void set_calibration(const calibrate::RigCalibration& calibration);
  void set_headings(const std::vector<std::vector<HeadingKey>>& headings);

  /// The newest state, which never changes any more: `version` tells whether it is another. Never blocks.
  [[nodiscard]] std::shared_ptr<const LiveSnapshot> snapshot() const;

  /// The newest pose; null before the first.
  [[nodiscard]] std::shared_ptr<const LiveFigure> figure() const;
  /// Called on the session's thread whenever there is a new `figure()`: shall only pass the word on. Set before
  /// `start`.
  void on_figure(std::function<void()> told);

 private:
  std::unique_ptr<struct LiveWorker> worker_;
};

}  // namespace limbwave::solve
