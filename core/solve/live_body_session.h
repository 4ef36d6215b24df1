/// A running capture from a driver box with the body filter behind it: box → recorder (raw first), and beside it
/// box → decoder → filter → newest pose, each on a thread of its own, so that recording never waits for the filter.
/// The box's own thread reads the line and nothing else. Faces take snapshots at their own pace and figures when they
/// come, as from a LiveSession.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/box_source.h"
#include "base/diagnostics.h"
#include "base/result.h"
#include "calibrate/ranging_calibration.h"
#include "estimate/body_tracker.h"
#include "solve/body_solve.h"
#include "solve/box_wires.h"
#include "solve/live_session.h"
#include "take/take.h"

namespace limbwave::solve {

struct LiveBodySettings {
  body::Rig rig;  ///< With a driver box.
  body::Skeleton skeleton;
  calibrate::RangingCalibration ranging;
  /// Sensors, root ("free", "fixed" or "contacts"), start, and poses a second; the rest has no meaning here.
  BodySolveSettings solve;
  double lag_s = 0.0;          ///< Of the fixed-lag smoother, whose poses figures then show; 0: none, the filter's.
  double most_behind_s = 1.0;  ///< So much may wait for decoder and filter; beyond it the live picture skips.
};

/// What a face shows.
struct LiveBodySnapshot {
  std::uint64_t version = 0;            ///< Changes whenever anything else does.
  double stream_time_s = 0.0;           ///< Of the newest sample that was decoded.
  bool started = false;                 ///< The filter runs: the first second of rest is over.
  std::vector<body::SegmentPose> pose;  ///< The filter's newest; empty before the first.
  double pose_time_s = 0.0;
  std::vector<body::SegmentPose> smoothed;  ///< The fixed-lag smoother's newest.
  double smoothed_time_s = 0.0;
  Eigen::Vector3d root_sigma = Eigen::Vector3d::Zero();  ///< Of a free root's place, m.
  double joint_sigma_deg = 0.0;        ///< Of the joints' rotations in the newest pose, mean of those that move, 1 σ.
  double poses_hz = 0.0;               ///< Poses of the last second.
  std::int64_t poses = 0;              ///< Since the start.
  std::int64_t words = 0, ranges = 0;  ///< Readings that went to the filter since the start.
  /// From the oldest sample of a pose's newest word to the pose, beyond the box's own delay: of the last seconds.
  LatencyReport latency;
  std::vector<BoxWire> wires;         ///< By wire.
  std::vector<std::string> standing;  ///< Names of the feet that stand.
  Diagnostics diagnostics;            ///< The start's, and what happened since.
  std::int64_t late = 0;              ///< Readings that came out of the decoder behind their time.
  double behind_s = 0.0;              ///< Of what has been pulled, not yet decoded.
  double skipped_s = 0.0;             ///< What the live picture left out because the computer was too slow.
  acquire::StreamFormat format;
  std::string title;  ///< Of the box.
  bool connected = true;
  acquire::BoxCounters counters;
  acquire::BoxStatus status;
  bool running = false;  ///< False when stopped.
  std::string error;     ///< Why there are no poses any more; empty: there are. The recording goes on.
  // Recording.
  bool recording = false;
  std::filesystem::path take_folder;
  double recorded_s = 0.0, disk_left_s = 0.0;
  std::string recording_error;  ///< Why recording stopped by itself; empty: it did not.
};

/// All functions may be called from any thread.
class LiveBodySession {
 public:
  LiveBodySession(std::unique_ptr<acquire::BoxSource> box, LiveBodySettings settings);
  ~LiveBodySession();  ///< Stops, closing a recording properly.
  LiveBodySession(const LiveBodySession&) = delete;
  LiveBodySession& operator=(const LiveBodySession&) = delete;

  /// Starts the box; with a folder, recording into a new take from the box's first sample on. Once in a session's life.
  /// Fails when the rig is not this box's, the root cannot be had live, the take cannot be made, or the box does not
  /// start.
  Status start(const std::filesystem::path& folder = {}, const std::string& subject = {});
  /// Stops the box and waits until everything that came has been written and solved. The take, where one was still
  /// being recorded; else an error that says so. Once.
  Result<take::Take> stop();

  /// Records into a new take from the next round of the sources on. Fails when the folder exists or cannot be made, or
  /// when a recording runs or is being started.
  Status start_recording(const std::filesystem::path& folder, const std::string& subject);
  /// Ends the recording; the take is complete on disk when this returns.
  Result<take::Take> stop_recording();
  /// Sets a marker at the newest sample of the recording and gives it a number; empty when nothing is recorded.
  std::optional<take::TakeEvent> mark(const std::string& text);
  /// Writes a line of the recording's events (take/markers.h). False when nothing is recorded.
  bool write_event(const take::TakeEvent& event);

  /// The newest state, which never changes any more. Never blocks.
  [[nodiscard]] std::shared_ptr<const LiveBodySnapshot> snapshot() const;
  /// The newest pose; null before the first.
  [[nodiscard]] std::shared_ptr<const LiveFigure> figure() const;
  /// Called on the filter's thread whenever there is a new `figure()`: shall only pass the word on. Before `start`.
  void on_figure(std::function<void()> told);
  /// Called there with every pose, in order; smoothed ones in the second. Before `start`.
  using Poses = std::function<void(const std::vector<estimate::TrackedPose>& poses,
                                   const std::vector<estimate::TrackedPose>& smoothed)>;
  void on_poses(Poses told);

 private:
  std::unique_ptr<struct LiveBodyWorker> worker_;
};

}  // namespace limbwave::solve
