#include "solve/live_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "solve/front_end.h"
#include "solve/live_pose.h"
#include "take/markers.h"
#include "take/recorder.h"

namespace limbwave::solve {
namespace {

constexpr auto kPollInterval = std::chrono::milliseconds(2);
constexpr double kPublishInterval_s = 1.0 / 60.0;
constexpr double kScope_s = 0.1;
constexpr std::size_t kKeptFrames = 600;  // ten seconds at the nominal cycle rate
constexpr std::size_t kKeptDiagnostics = 100;
constexpr double kLatencyWindow_s = 5.0;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The newest elements of a stream, the older ones forgotten in batches.
template <typename T>
void keep_newest(std::vector<T>& items, std::size_t count) {
  if (items.size() > 2 * count) {
    items.erase(items.begin(), items.end() - static_cast<std::ptrdiff_t>(count));
  }
}

}  // namespace

struct LiveSession::Impl {
  std::unique_ptr<acquire::LiveSource> source;
  LiveSettings settings;
  acquire::StreamFormat format;
  FrontEnd front;
  LivePose pose;

  std::thread worker;
  std::mutex wake_mutex;
  std::condition_variable wake;
  bool stopping = false;

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

  mutable std::mutex snapshot_mutex;
  std::shared_ptr<const LiveSnapshot> published = std::make_shared<LiveSnapshot>();

  // The worker's own.
  std::int64_t frames_pulled = 0;
  std::vector<float> scope;
  std::vector<decode::LineInCycle> cycles;
  std::vector<decode::AccelerationFrame> frames;
  Diagnostics diagnostics;
  acquire::SourceCounters counters;
  std::deque<std::pair<double, double>> latencies;  // time of measurement, latency
  double pose_time_s = 0.0;
  double pose_capture_time_s = 0.0;
  std::uint64_t version = 0;
  double last_publish_s = 0.0;

  Impl(std::unique_ptr<acquire::LiveSource> live_source, LiveSettings live_settings)
      : source(std::move(live_source)),
        settings(std::move(live_settings)),
        format(source->format()),
        front(settings.rig, format.rate, settings.solve.line_in),
        pose(settings.rig, settings.skeleton, settings.calibration, settings.solve) {
    front.keep_cycles(true);
  }

  void run();
  bool step(std::vector<std::byte>& bytes, std::vector<float>& samples);
  void record(std::span<const std::byte> bytes);
  void write_pending_events();
  void note(const Diagnostics& found);
  void note_losses();
  void solve_frames();
  void publish();
};

void LiveSession::Impl::run() {
  std::vector<std::byte> bytes(format.bytes_per_frame() * 8192);
  std::vector<float> samples;
  bool was_alive = true;
  while (true) {
    {
      std::unique_lock lock(wake_mutex);
      wake.wait_for(lock, kPollInterval, [this] { return stopping; });
      if (stopping) {
        break;
      }
    }
    while (step(bytes, samples)) {
    }
    write_pending_events();  // Also of a device that gives nothing any more.
    if (was_alive && !source->alive()) {
      was_alive = false;
      note({{Severity::kError, "source.gone", fmt::format("{} has stopped giving samples", source->title()),
             "check the cable and the sound server, then choose the device again", source->title(), -1.0}});
    }
    if (now_s() - last_publish_s >= kPublishInterval_s) {
      publish();
    }
  }
  while (step(bytes, samples)) {
  }
  publish();
}

bool LiveSession::Impl::step(std::vector<std::byte>& bytes, std::vector<float>& samples) {
  const std::size_t count = source->pull(bytes);
  if (count == 0) {
    return false;
  }
  const std::span<const std::byte> fresh(bytes.data(), count);
  record(fresh);
  samples.resize(count / acquire::bytes_per_sample(format.type));
  acquire::to_float(format.type, fresh, samples);
  frames_pulled += static_cast<std::int64_t>(count / format.bytes_per_frame());
  scope.insert(scope.end(), samples.begin(), samples.end());
  keep_newest(scope, 2 * static_cast<std::size_t>(kScope_s * format.rate.hz));
  note_losses();
  front.push(samples);
  note(front.take_diagnostics());
  solve_frames();
  return count == bytes.size();
}

void LiveSession::Impl::record(std::span<const std::byte> bytes) {
  const std::scoped_lock lock(mutex);
  if (new_calibration) {
    pose.set_calibration(*std::exchange(new_calibration, {}));
  }
  if (new_headings) {
    pose.set_headings(*std::exchange(new_headings, {}));
  }
  if (!recorder) {
    return;
  }
  if (recording_start < 0) {
    recording_start = frames_pulled;
  }
  if (recording_error.empty()) {
    if (Status status = recorder->write(bytes); !status) {
      recording_error = status.error().text();
    }
  }
}

void LiveSession::Impl::write_pending_events() {
  const std::scoped_lock lock(mutex);
  for (const take::TakeEvent& event : std::exchange(pending_events, {})) {
    if (recorder) {
      (void)recorder->add_event(event);
    }
  }
}

void LiveSession::Impl::note(const Diagnostics& found) {
  if (found.empty()) {
    return;
  }
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  keep_newest(diagnostics, kKeptDiagnostics);
  const std::scoped_lock lock(mutex);
  if (!recorder) {
    return;
  }
  for (const Diagnostic& diagnostic : found) {
    const std::int64_t stream =
        diagnostic.time_s >= 0.0 ? format.rate.index(Seconds{diagnostic.time_s}).value : frames_pulled;
    const std::int64_t sample =
        std::clamp<std::int64_t>(stream - std::max<std::int64_t>(recording_start, 0), 0, recorder->frames());
    std::string text = diagnostic.message;
    if (!diagnostic.remedy.empty()) {
      text += "; " + diagnostic.remedy;
    }
    (void)recorder->add_event({SampleIndex{sample}, diagnostic.code, text, 0});
  }
}

void LiveSession::Impl::note_losses() {
  const acquire::SourceCounters seen = source->counters();
  if (seen.overflows == counters.overflows && seen.dropped_frames == counters.dropped_frames) {
    return;
  }
  const std::uint64_t dropped = seen.dropped_frames - counters.dropped_frames;
  counters = seen;
  const std::string amount = dropped > 0 ? fmt::format("{} samples were lost", dropped)
                                         : std::string("samples were lost, the device does not say how many");
  note({{Severity::kWarning, "dropped", amount,
         "close programs that keep the computer busy, or choose a larger buffer of the sound card", source->title(),
         format.rate.seconds(SampleIndex{frames_pulled}).value}});
}

void LiveSession::Impl::solve_frames() {
  const std::vector<decode::AccelerationFrame> fresh = front.take_frames();
  for (const decode::AccelerationFrame& frame : fresh) {
    pose.push(frame);
  }
  frames.insert(frames.end(), fresh.begin(), fresh.end());
  keep_newest(frames, kKeptFrames);
  const std::vector<decode::LineInCycle> fresh_cycles = front.take_cycles();
  cycles.insert(cycles.end(), fresh_cycles.begin(), fresh_cycles.end());
  keep_newest(cycles, std::size_t{64});
  if (fresh.empty()) {
    return;
  }
  pose_time_s = fresh.back().time_s;
  const double newest = source->newest_frame_time_s();
  if (newest > 0.0) {
    // The ring was emptied just now, so the newest frame pulled is the newest captured.
    pose_capture_time_s = newest - (format.rate.seconds(SampleIndex{frames_pulled}).value - pose_time_s);
    const double now = now_s();
    latencies.emplace_back(now, now - pose_capture_time_s);
    while (now - latencies.front().first > kLatencyWindow_s) {
      latencies.pop_front();
    }
  }
}

void LiveSession::Impl::publish() {
  last_publish_s = now_s();
  auto snapshot = std::make_shared<LiveSnapshot>();
  snapshot->version = ++version;
  snapshot->format = format;
  snapshot->stream_time_s = format.rate.seconds(SampleIndex{frames_pulled}).value;
  snapshot->line = front.status();
  const std::size_t scope_size = std::min(scope.size(), 2 * static_cast<std::size_t>(kScope_s * format.rate.hz));
  snapshot->scope.assign(scope.end() - static_cast<std::ptrdiff_t>(scope_size), scope.end());
  snapshot->scope_first_sample = static_cast<double>(frames_pulled - static_cast<std::int64_t>(scope_size / 2));
  for (const decode::LineInCycle& cycle : cycles) {
    if (cycle.start_sample + cycle.period_samples > snapshot->scope_first_sample) {
      snapshot->scope_cycles.push_back(cycle);
    }
  }
  snapshot->frames.assign(frames.end() - static_cast<std::ptrdiff_t>(std::min(frames.size(), kKeptFrames)),
                          frames.end());
  const calibrate::RigCalibration& calibration = pose.calibration();
  snapshot->specific_force.resize(settings.rig.accelerometers.size());
  for (std::size_t s = 0; s < settings.rig.accelerometers.size(); ++s) {
    snapshot->specific_force[s].reserve(snapshot->frames.size());
    for (const decode::AccelerationFrame& frame : snapshot->frames) {
      snapshot->specific_force[s].push_back(calibration.sensors[s].apply(frame.volts[s]));
    }
    snapshot->health.push_back(
        sensor_health(settings.rig, calibration.sensors[s], static_cast<int>(s), snapshot->frames));
  }
  snapshot->pose = pose.pose();
  snapshot->pose_time_s = pose_time_s;
  snapshot->pose_capture_time_s = pose_capture_time_s;
  snapshot->diagnostics.assign(
      diagnostics.end() - static_cast<std::ptrdiff_t>(std::min(diagnostics.size(), kKeptDiagnostics)),
      diagnostics.end());
  snapshot->counters = counters;
  snapshot->source_alive = source->alive();
  snapshot->device_latency_s = source->device_latency_s();
  for (const auto& [time, latency] : latencies) {
    snapshot->latency_mean_s += latency / static_cast<double>(latencies.size());
    snapshot->latency_max_s = std::max(snapshot->latency_max_s, latency);
  }
  {
    const std::scoped_lock lock(mutex);
    snapshot->recording = recorder != nullptr && recording_error.empty();
    snapshot->take_folder = take_folder;
    snapshot->recording_error = recording_error;
    if (recorder) {
      snapshot->recorded_s = recorder->seconds();
      snapshot->disk_left_s = recorder->disk_left_s();
    }
  }
  const std::scoped_lock lock(snapshot_mutex);
  published = std::move(snapshot);
}

LiveSession::LiveSession(std::unique_ptr<acquire::LiveSource> source, LiveSettings settings)
    : impl_(std::make_unique<Impl>(std::move(source), std::move(settings))) {}

LiveSession::~LiveSession() {
  stop();
  if (impl_->recorder) {
    (void)stop_recording();
  }
}

Status LiveSession::start() {
  if (impl_->worker.joinable()) {
    return {};
  }
  if (Status status = impl_->source->start(); !status) {
    return status;
  }
  impl_->stopping = false;
  impl_->worker = std::thread([impl = impl_.get()] { impl->run(); });
  return {};
}

void LiveSession::stop() {
  if (!impl_->worker.joinable()) {
    return;
  }
  impl_->source->stop();
  {
    const std::scoped_lock lock(impl_->wake_mutex);
    impl_->stopping = true;
  }
  impl_->wake.notify_all();
  impl_->worker.join();
}

Status LiveSession::start_recording(const std::filesystem::path& folder, const std::string& subject) {
  take::TakeInfo info;
  info.subject = subject;
  info.source = impl_->source->title();
  info.format = impl_->format;
  info.rig = impl_->settings.rig;
  info.skeleton = impl_->settings.skeleton;
  {
    const std::scoped_lock lock(impl_->mutex);
    if (impl_->recorder) {
      return Error{"is being recorded already", impl_->take_folder.string(), "stop that recording first"};
    }
    info.calibration = impl_->new_calibration ? impl_->new_calibration : impl_->settings.calibration;
  }
  Result<std::unique_ptr<take::Recorder>> recorder = take::Recorder::create(folder, std::move(info));
  if (!recorder) {
    return recorder.error();
  }
  const std::scoped_lock lock(impl_->mutex);
  impl_->recorder = std::move(*recorder);
  impl_->recording_start = -1;
  impl_->recording_error.clear();
  impl_->pending_events.clear();
  impl_->next_marker = 1;
  impl_->take_folder = folder;
  return {};
}

Result<take::Take> LiveSession::stop_recording() {
  std::unique_ptr<take::Recorder> recorder;
  impl_->write_pending_events();
  {
    const std::scoped_lock lock(impl_->mutex);
    recorder = std::move(impl_->recorder);
  }
  if (!recorder) {
    return Error{"nothing is being recorded", "", "start a recording first"};
  }
  return recorder->close();
}

std::optional<take::TakeEvent> LiveSession::mark(const std::string& text) {
  const std::scoped_lock lock(impl_->mutex);
  if (!impl_->recorder) {
    return std::nullopt;
  }
  const take::TakeEvent event{SampleIndex{impl_->recorder->frames()}, take::kMarker, text, impl_->next_marker++};
  impl_->pending_events.push_back(event);
  return event;
}

bool LiveSession::write_event(const take::TakeEvent& event) {
  const std::scoped_lock lock(impl_->mutex);
  if (!impl_->recorder) {
    return false;
  }
  impl_->pending_events.push_back(event);
  return true;
}

void LiveSession::set_calibration(const calibrate::RigCalibration& calibration) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->new_calibration = calibration;
  impl_->settings.calibration = calibration;
}

void LiveSession::set_headings(const std::vector<std::vector<HeadingKey>>& headings) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->new_headings = headings;
}

std::shared_ptr<const LiveSnapshot> LiveSession::snapshot() const {
  const std::scoped_lock lock(impl_->snapshot_mutex);
  return impl_->published;
}

}  // namespace limbwave::solve
