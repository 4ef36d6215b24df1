/// What a LiveBodySession consists of. Inside core/solve only.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "decode/driver_box_decoder.h"
#include "solve/live_body_session.h"
#include "solve/live_clock.h"
#include "solve/word_alignment.h"
#include "take/driver_box_recording.h"

namespace limbwave::solve {

struct LiveBodyWorker {
  LiveBodyWorker(std::unique_ptr<acquire::BoxSource> source, LiveBodySettings live_settings);

  /// The body model, who hangs where, and the filter. Fails when the root cannot be had live.
  Status prepare();
  void pull();   ///< Of the thread that empties the box: raw samples to the take, then to the other thread.
  void solve();  ///< Of the thread that decodes and filters.

  std::unique_ptr<acquire::BoxSource> box;
  LiveBodySettings settings;
  acquire::StreamFormat format;
  std::function<void()> told;
  LiveBodySession::Poses told_poses;
  std::thread puller, solver;
  std::atomic<bool> stopping{false};
  bool was_started = false, was_stopped = false;

  // The recording; held while samples are written.
  std::mutex recording_mutex;
  std::unique_ptr<take::BoxRecording> recording;
  bool preparing = false;
  std::int64_t next_marker = 1;
  std::int64_t pulled = 0;  // samples of the box
  std::vector<bool> wire_pulled;
  std::filesystem::path take_folder;
  std::string recording_error;
  double recorded_s = 0.0, disk_left_s = 0.0;

  // Between the two threads.
  struct Fresh {
    acquire::BoxPiece piece;
    double arrived_s = 0.0;  // steady_clock
  };
  std::mutex queue_mutex;
  std::condition_variable queue_changed;
  std::deque<Fresh> queue;
  std::vector<acquire::BoxEvent> queue_events;
  std::int64_t waiting_frames = 0, skipped_frames = 0;  // lost ones aside
  CaptureClock clock;
  bool ended = false;  // nothing more comes into the queue

  mutable std::mutex published_mutex;  // held for a copy of a snapshot only
  std::shared_ptr<const LiveBodySnapshot> published = std::make_shared<LiveBodySnapshot>();
  std::shared_ptr<const LiveFigure> figure;

 private:
  void queue_up(acquire::BoxPart part, double arrived_s);
  void write(const acquire::BoxPart& part);
  void skip_to(std::int64_t left);
  [[nodiscard]] std::int64_t length_of(const acquire::BoxPiece& piece) const;
  void take_in(const Fresh& fresh);
  void hand_on(bool all);
  void show(const std::vector<body::SegmentPose>& pose, double time_s);
  /// What the filter knows now, with what the puller said last.
  void publish();
  /// What the puller knows now: faces see it however far the filter is behind.
  void publish_pulled(bool last);
  [[nodiscard]] double joint_sigma_deg() const;

  // The solver's own.
  estimate::BodyModel model_;
  std::unique_ptr<estimate::BodyTracker> tracker_;
  std::unique_ptr<decode::DriverBoxDecoder> decoder_;
  std::unique_ptr<WordAligner> aligner_;  // null: words stay at their own instants
  double settled_s_ = 0.0;                // behind the newest sample no reading of before will come any more
  BoxWires wires_;
  std::vector<int> board_of_chip_, board_of_microphone_, source_of_;
  CaptureClock clock_;
  LatencyMeter latency_;
  std::int64_t position_ = 0;
  double arrived_s_ = 0.0;  // of the newest piece that was decoded
  std::vector<float> samples_;
  LiveBodySnapshot state_;
  std::deque<double> pose_times_;  // steady_clock, of the last second
  double published_s_ = 0.0;
  double pulled_published_s_ = 0.0;  // the puller's own
  std::uint64_t figures_ = 0;
};

}  // namespace limbwave::solve
