#include "solve/live_body_session.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "decode/driver_box_decoder.h"
#include "estimate/body_tracker.h"
#include "solve/driver_box.h"
#include "take/driver_box_recording.h"

namespace limbwave::solve {
namespace {

constexpr double kSettled = 0.06;  // s behind the newest sample every reading has come out of the decoder
constexpr double kWait = 0.05;

// A box that lets somebody listen to what is pulled from it.
class TappedBox : public acquire::BoxSource {
 public:
  using Listen = std::function<void(const acquire::BoxPart&)>;
  TappedBox(acquire::BoxSource& box, Listen listen) : box_(box), listen_(std::move(listen)) {}
  [[nodiscard]] acquire::BoxHello hello() const override { return box_.hello(); }
  [[nodiscard]] acquire::StreamFormat format() const override { return box_.format(); }
  [[nodiscard]] std::string title() const override { return box_.title(); }
  Status set_schedule(const std::vector<std::uint8_t>& schedule) override { return box_.set_schedule(schedule); }
  Status start() override { return box_.start(); }
  void stop() override { box_.stop(); }
  acquire::BoxPart pull(double timeout_s) override {
    acquire::BoxPart part = box_.pull(timeout_s);
    listen_(part);
    return part;
  }
  [[nodiscard]] acquire::BoxCounters counters() const override { return box_.counters(); }
  [[nodiscard]] acquire::BoxStatus status() const override { return box_.status(); }
  [[nodiscard]] bool connected() const override { return box_.connected(); }

 private:
  acquire::BoxSource& box_;
  Listen listen_;
};

}  // namespace

struct LiveBodySession::Impl {
  Impl(std::unique_ptr<acquire::BoxSource> source, LiveBodySettings live_settings)
      : box(std::move(source)), settings(std::move(live_settings)) {}

  void record(const std::filesystem::path& folder, const std::string& subject);
  void solve();
  void take_in(const acquire::BoxPiece& piece, decode::DriverBoxDecoder& decoder);
  bool hand_on(decode::DriverBoxDecoder& decoder, bool all);
  void publish();
  void end_with(const std::string& text);

  std::unique_ptr<acquire::BoxSource> box;
  LiveBodySettings settings;
  std::function<void()> told;
  LiveBodySession::Poses told_poses;
  std::thread recorder, solver;
  std::atomic<bool> stopping{false};
  bool was_started = false, was_stopped = false;

  // Between the two threads.
  std::mutex queue_mutex;
  std::condition_variable queue_changed;
  std::deque<acquire::BoxPiece> queue;
  std::int64_t waiting_frames = 0, skipped_frames = 0;
  bool ended = false;  // nothing more comes into the queue
  std::optional<Result<take::Take>> taken;
  LiveBodySnapshot of_recording;  // what the recorder's thread says, under queue_mutex

  // The solver's own.
  estimate::BodyModel model;
  std::unique_ptr<estimate::BodyTracker> tracker;
  std::vector<int> board_of_chip, board_of_microphone, source_of;
  double rate_hz = 1.0;
  std::int64_t position = 0;
  std::vector<float> samples;
  LiveBodySnapshot state;
  std::uint64_t figures = 0;

  mutable std::mutex published_mutex;  // held for a copy of a pointer only
  std::shared_ptr<const LiveBodySnapshot> published = std::make_shared<LiveBodySnapshot>();
  std::shared_ptr<const LiveFigure> figure;
};

void LiveBodySession::Impl::end_with(const std::string& text) {
  const std::lock_guard lock(queue_mutex);
  if (of_recording.error.empty()) {
    of_recording.error = text;
  }
}

void LiveBodySession::Impl::record(const std::filesystem::path& folder, const std::string& subject) {
  const std::size_t frame_bytes = box->format().bytes_per_frame();
  TappedBox tapped(*box, [&](const acquire::BoxPart& part) {
    const std::lock_guard lock(queue_mutex);
    for (const acquire::BoxPiece& piece : part.pieces) {
      queue.push_back(piece);
      waiting_frames += piece.lost + static_cast<std::int64_t>(piece.bytes.size() / frame_bytes);
    }
    of_recording.connected = box->connected();
    of_recording.counters = box->counters();
    queue_changed.notify_one();
  });
  if (!folder.empty()) {
    Result<take::Take> take = take::record_driver_box(folder, tapped, settings.rig, settings.skeleton, subject,
                                                      settings.ranging, [&](const take::DriverBoxProgress& now) {
                                                        const std::lock_guard lock(queue_mutex);
                                                        of_recording.recording = true;
                                                        of_recording.take_folder = folder;
                                                        of_recording.recorded_s = now.seconds;
                                                        of_recording.disk_left_s = now.disk_left_s;
                                                        return !stopping;
                                                      });
    if (!take) {
      end_with(take.error().text());
    }
    const std::lock_guard lock(queue_mutex);
    taken = std::move(take);
  } else if (const Status status = tapped.start(); !status) {
    end_with(status.error().text());
  } else {
    while (!stopping) {
      (void)tapped.pull(kWait);
    }
    tapped.stop();
    (void)tapped.pull(0.0);
  }
  const std::lock_guard lock(queue_mutex);
  of_recording.recording = false;
  ended = true;
  queue_changed.notify_one();
}

void LiveBodySession::Impl::take_in(const acquire::BoxPiece& piece, decode::DriverBoxDecoder& decoder) {
  if (piece.lost > 0) {
    decoder.gap(SampleCount{piece.lost});
    position += piece.lost;
  }
  const acquire::StreamFormat format = box->format();
  const std::size_t frames = piece.bytes.size() / format.bytes_per_frame();
  samples.resize(frames * static_cast<std::size_t>(format.channels));
  acquire::to_float(format.type, piece.bytes, samples);
  if (frames > 0) {
    decoder.push(samples);
    position += static_cast<std::int64_t>(frames);
  }
}

// What has been decoded goes to the filter; false when it refuses to start.
bool LiveBodySession::Impl::hand_on(decode::DriverBoxDecoder& decoder, bool all) {
  std::vector<estimate::RangeReading> ranges;
  for (const decode::RangeReading& heard : decoder.take_ranges()) {
    if (heard.verdict == decode::RangeVerdict::kAccepted) {
      ranges.push_back({heard.emission_time.value, source_of.at(static_cast<std::size_t>(heard.source)),
                        board_of_microphone.at(static_cast<std::size_t>(heard.receiver)), heard.range,
                        heard.confidence(), heard.variance});
    }
  }
  std::vector<estimate::InertialReading> words;
  for (const decode::InertialReading& word : decoder.take_inertial()) {
    if (word.valid) {
      words.push_back({word.time.value, board_of_chip.at(static_cast<std::size_t>(word.board)), word.w_WS_S, word.f_S});
    }
  }
  Status status = tracker->push(words, ranges, static_cast<double>(position) / rate_hz - kSettled);
  if (status && all) {
    status = tracker->finish();
  }
  if (!status) {
    end_with(status.error().text());
    return false;
  }
  const std::vector<estimate::TrackedPose> poses = tracker->take_poses();
  const std::vector<estimate::TrackedPose> smoothed = tracker->take_smoothed();
  const auto placed = [&](const estimate::TrackedPose& pose) {
    return body::poses_from_joints(settings.skeleton, pose.R_joint, pose.root_p_W);
  };
  if (told_poses && (!poses.empty() || !smoothed.empty())) {
    told_poses(poses, smoothed);
  }
  if (!smoothed.empty()) {
    state.smoothed = placed(smoothed.back());
    state.smoothed_time_s = smoothed.back().time_s;
  }
  if (!poses.empty()) {
    state.pose = placed(poses.back());
    state.pose_time_s = poses.back().time_s;
    auto next = std::make_shared<LiveFigure>();
    next->number = ++figures;
    next->pose = state.pose;
    next->time_s = state.pose_time_s;
    {
      const std::lock_guard lock(published_mutex);
      figure = next;
    }
    if (told) {
      told();
    }
  }
  return true;
}

void LiveBodySession::Impl::publish() {
  state.stream_time_s = static_cast<double>(position) / rate_hz;
  state.started = tracker->started();
  state.late = tracker->late();
  state.diagnostics = tracker->findings();
  state.boards.clear();
  for (std::size_t b = 0; b < model.boards.size(); ++b) {
    state.boards.push_back(tracker->watch().sensors().board(b));
  }
  state.standing.clear();
  const estimate::FootContacts& contacts = tracker->watch().contacts();
  for (std::size_t i = 0; i < contacts.soles().size(); ++i) {
    if (contacts.standing(i)) {
      state.standing.push_back(contacts.soles()[i].name);
    }
  }
  if (tracker->filter().tree().root_motion() == body::RootMotion::kFree) {
    for (int i = 0; i < 3; ++i) {
      state.root_sigma[i] = std::sqrt(tracker->filter().covariance()(i, i));
    }
  }
  auto next = std::make_shared<LiveBodySnapshot>(state);
  {
    const std::lock_guard lock(queue_mutex);
    next->connected = of_recording.connected;
    next->counters = of_recording.counters;
    next->recording = of_recording.recording;
    next->take_folder = of_recording.take_folder;
    next->recorded_s = of_recording.recorded_s;
    next->disk_left_s = of_recording.disk_left_s;
    next->error = of_recording.error;
    next->running = !ended && of_recording.error.empty();
    next->skipped_s = static_cast<double>(skipped_frames) / rate_hz;
  }
  if (next->skipped_s > 0.0) {
    next->diagnostics.push_back({Severity::kWarning, "live.too-slow",
                                 "this computer is too slow for the live picture, which has left something out",
                                 "the recording is whole: solve it afterwards", ""});
  }
  next->version = ++state.version;
  const std::lock_guard lock(published_mutex);
  published = std::move(next);
}

void LiveBodySession::Impl::solve() {
  decode::DriverBoxFormat format = driver_box_format(settings.rig, settings.skeleton, settings.ranging);
  format.rate = box->format().rate;
  decode::DriverBoxParameters parameters;
  parameters.ranging.look_ahead_s = 0.0;  // A picture cannot wait for what comes later.
  decode::DriverBoxDecoder decoder(format, parameters);
  const std::size_t frame_bytes = box->format().bytes_per_frame();
  bool solving = true;
  while (true) {
    std::deque<acquire::BoxPiece> fresh;
    bool last = false;
    {
      std::unique_lock lock(queue_mutex);
      queue_changed.wait_for(lock, std::chrono::milliseconds(200), [&] { return ended || !queue.empty(); });
      // Raw samples are recorded; the picture may skip what it could only show too late.
      const auto most = static_cast<std::int64_t>(settings.most_behind_s * rate_hz);
      for (acquire::BoxPiece& piece : queue) {
        const auto frames = static_cast<std::int64_t>(piece.bytes.size() / frame_bytes);
        const std::int64_t length = piece.lost + frames;
        if (waiting_frames > most && frames > 0) {
          piece.lost = length;
          piece.bytes.clear();
          skipped_frames += frames;
        }
        waiting_frames -= length;
      }
      fresh.swap(queue);
      last = ended;
    }
    for (const acquire::BoxPiece& piece : fresh) {
      take_in(piece, decoder);
    }
    if (last) {
      decoder.finish();
    }
    solving = solving && hand_on(decoder, last);
    publish();
    if (last) {
      return;
    }
  }
}

LiveBodySession::LiveBodySession(std::unique_ptr<acquire::BoxSource> box, LiveBodySettings settings)
    : impl_(std::make_unique<Impl>(std::move(box), std::move(settings))) {}

LiveBodySession::~LiveBodySession() {
  if (impl_->was_started && !impl_->was_stopped) {
    (void)stop();
  }
}

Status LiveBodySession::start(const std::filesystem::path& folder, const std::string& subject) {
  Impl& d = *impl_;
  if (d.was_started) {
    return Error{"a session runs only once", "", "make another"};
  }
  const body::Rig& rig = d.settings.rig;
  if (!rig.driver_box || static_cast<std::size_t>(d.box->format().channels) != rig.microphones.size()) {
    return Error{"is no rig of this driver box", "rig \"" + rig.name + "\"", "use the rig that belongs to this box"};
  }
  const std::string& root = d.settings.solve.root;
  if (root != "free" && root != "fixed" && root != "contacts") {
    return Error{"cannot be known while recording", "root \"" + root + "\"", "choose free, fixed or contacts"};
  }
  d.model = estimate::body_model(rig, d.settings.skeleton);
  for (const body::Gyroscope& gyroscope : rig.gyroscopes) {
    d.board_of_chip.push_back(d.model.find_board(gyroscope.name));
  }
  for (const body::Microphone& microphone : rig.microphones) {
    d.board_of_microphone.push_back(d.model.find_board(microphone.name));
  }
  for (const body::Source& source : rig.sources) {
    d.source_of.push_back(d.model.find_source(source.name));
  }
  d.rate_hz = d.box->format().rate.hz;
  d.tracker = std::make_unique<estimate::BodyTracker>(
      d.model, body_parameters(d.model, d.settings.solve), watch_parameters(d.model, d.settings.solve),
      estimate::TrackerSettings{d.settings.solve.rate_hz, d.settings.lag_s});
  d.was_started = true;
  d.solver = std::thread([&d] { d.solve(); });
  d.recorder = std::thread([&d, folder, subject] { d.record(folder, subject); });
  return {};
}

Result<take::Take> LiveBodySession::stop() {
  Impl& d = *impl_;
  if (!d.was_started || d.was_stopped) {
    return Error{"no session runs", "", "start one"};
  }
  d.was_stopped = true;
  d.stopping = true;
  d.recorder.join();
  d.solver.join();
  if (!d.taken) {
    return Error{"nothing was recorded", "", "start with the folder of a take"};
  }
  return std::move(*d.taken);
}

std::shared_ptr<const LiveBodySnapshot> LiveBodySession::snapshot() const {
  const std::lock_guard lock(impl_->published_mutex);
  return impl_->published;
}

std::shared_ptr<const LiveFigure> LiveBodySession::figure() const {
  const std::lock_guard lock(impl_->published_mutex);
  return impl_->figure;
}

void LiveBodySession::on_figure(std::function<void()> told) {
  impl_->told = std::move(told);
}

void LiveBodySession::on_poses(Poses told) {
  impl_->told_poses = std::move(told);
}

}  // namespace limbwave::solve
