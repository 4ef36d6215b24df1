/// The worker of a live session: what it owns, and what it shares with the session's callers.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "solve/front_end.h"
#include "solve/live_clock.h"
#include "solve/live_latency.h"
#include "solve/live_pose.h"
#include "solve/live_session.h"
#include "take/recorder.h"

namespace limbwave::solve {

struct LiveWorker {
  LiveWorker(std::unique_ptr<acquire::LiveSource> live_source, LiveSettings live_settings);

  void run();
  /// Writes what callers have put into `pending_events`.
  void write_pending_events();

  std::unique_ptr<acquire::LiveSource> source;
  LiveSettings settings;
  acquire::StreamFormat format;
  std::thread thread;
  std::atomic<bool> stopping{false};
  std::function<void()> told;  // of a new figure; set before the thread runs

  // Shared with callers, under `mutex`.
  std::mutex mutex;
  std::unique_ptr<take::Recorder> recorder;
  std::int64_t recording_start = 0;             // stream frame of the take's sample 0
  std::vector<take::TakeEvent> pending_events;  // of the user; the worker writes them, so that no caller waits
  std::int64_t next_marker = 1;
  std::optional<calibrate::RigCalibration> new_calibration;
  std::optional<std::vector<std::vector<HeadingKey>>> new_headings;
  std::string recording_error;
  std::filesystem::path take_folder;

  // Handed over, under `published_mutex`, which is held for a copy of a pointer only.
  mutable std::mutex published_mutex;
  std::shared_ptr<const LiveSnapshot> published = std::make_shared<LiveSnapshot>();
  std::shared_ptr<const LiveFigure> figure;

 private:
  bool step();
  void record(std::span<const std::byte> bytes);
  void note(const Diagnostics& found);
  void note_losses();
  void solve_frames(double arrived_s);
  void hand_over(const decode::LineInCycle& newest, double arrived_s);
  void publish();

  FrontEnd front_;
  LivePose pose_;
  CaptureClock clock_;
  LatencyMeter latency_;
  std::vector<std::byte> bytes_;
  std::vector<float> samples_;
  std::int64_t frames_pulled_ = 0;
  std::vector<float> scope_;
  std::vector<decode::LineInCycle> cycles_;
  std::vector<decode::AccelerationFrame> frames_;
  Diagnostics diagnostics_;
  acquire::SourceCounters counters_;
  std::uint64_t version_ = 0, figures_ = 0;
  double last_publish_s_ = 0.0;
  bool preferred_ = false;
};

}  // namespace limbwave::solve
