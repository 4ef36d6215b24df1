/// The worker of a live session: what it owns, and what it shares with the session's callers.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
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
  /// Findings anew for a recording that begins: what is so of the line is told first. Any thread, without locks held.
  void restart_findings();
  /// Into the events of the recording: what was only counted. Any thread, without locks held.
  void sum_up_findings();

  std::unique_ptr<acquire::LiveSource> source;
  LiveSettings settings;
  acquire::StreamFormat format;
  std::mutex running;  // held while the thread is started or joined
  std::thread thread;
  std::atomic<bool> stopping{false};
  std::function<void()> told;  // of a new figure; set before the thread runs

  // Shared with callers, under `mutex`.
  std::mutex mutex;
  std::unique_ptr<take::Recorder> recorder;
  bool is_preparing = false;                    // a recorder is being made
  std::int64_t recording_start = 0;             // stream frame of the take's sample 0
  std::vector<take::TakeEvent> pending_events;  // of the user; the worker writes them, so that no caller waits
  std::int64_t next_marker = 1;
  std::optional<calibrate::RigCalibration> new_calibration;
  std::int64_t calibrations = 0;  // counts those that were set
  std::optional<std::vector<std::vector<HeadingKey>>> new_headings;
  std::string recording_error;
  std::filesystem::path take_folder;

  // Handed over, under `published_mutex`, which is held for a copy of a pointer only.
  mutable std::mutex published_mutex;
  std::shared_ptr<const LiveSnapshot> published = std::make_shared<LiveSnapshot>();
  std::shared_ptr<const LiveFigure> figure;

 private:
  // Frames that are missing in what the source gives.
  struct Loss {
    std::int64_t at = 0;        // so many of the source's frames come before
    std::uint64_t dropped = 0;  // 0: the device does not say how many
  };

  bool step();
  void take_in(std::span<const std::byte> bytes, double arrived_s);
  void record(std::span<const std::byte> bytes);
  void note(const Diagnostics& found);
  void write_events(const Diagnostics& found);
  void look_for_losses();
  void make_up_for(const Loss& loss, double arrived_s);
  void solve_frames(double arrived_s);
  void hand_over(const decode::LineInCycle& newest, double arrived_s);
  void publish();

  std::mutex front_mutex_;  // of the front end's findings and what becomes of them; taken before `mutex`
  FrontEnd front_;
  LivePose pose_;
  CaptureClock clock_;
  LatencyMeter latency_;
  std::vector<std::byte> bytes_;
  std::deque<Loss> losses_;        // that reading has not reached yet
  std::int64_t frames_given_ = 0;  // by the source; the stream has the silence for lost ones too
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
  bool is_gone_ = false;  // the source was found dead, which stopping it would make forget
};

}  // namespace limbwave::solve
