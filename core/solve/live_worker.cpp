#include "solve/live_worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/thread_priority.h"

namespace limbwave::solve {
namespace {

constexpr double kLongestWait_s = 0.02;  // a source that has gone quiet wakes nobody
constexpr double kPublishInterval_s = 1.0 / 30.0;
constexpr double kScope_s = 0.1;
constexpr std::size_t kKeptFrames = 600;  // ten seconds at the nominal cycle rate
constexpr std::size_t kKeptCycles = 64;
constexpr std::size_t kKeptDiagnostics = 100;

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

LiveWorker::LiveWorker(std::unique_ptr<acquire::LiveSource> live_source, LiveSettings live_settings)
    : source(std::move(live_source)),
      settings(std::move(live_settings)),
      format(source->format()),
      front_(settings.rig, format.rate, settings.solve.line_in),
      pose_(settings.rig, settings.skeleton, settings.calibration, settings.solve),
      clock_(format.rate),
      bytes_(format.bytes_per_frame() * 8192) {
  front_.keep_cycles(true);
}

void LiveWorker::run() {
  preferred_ = prefer_this_thread();
  while (!stopping) {
    source->wait(kLongestWait_s);
    while (step()) {
    }
    write_pending_events();  // also of a device that gives nothing any more
    if (!is_gone_ && !source->alive()) {
      is_gone_ = true;
      note({{Severity::kError, "source.gone", fmt::format("{} has stopped giving samples", source->title()),
             "check the cable and the sound server, then choose the device again", source->title(), -1.0}});
    }
    if (now_s() - last_publish_s_ >= kPublishInterval_s) {
      publish();
    }
  }
  while (step()) {
  }
  {
    const std::scoped_lock lock(front_mutex_);
    front_.sum_up_findings();
    note(front_.take_diagnostics());
  }
  publish();
}

void LiveWorker::restart_findings() {
  const std::scoped_lock lock(front_mutex_);
  front_.restart_findings();
  write_events(front_.take_diagnostics());
}

void LiveWorker::sum_up_findings() {
  const std::scoped_lock lock(front_mutex_);
  front_.sum_up_findings();
  write_events(front_.take_diagnostics());
}

bool LiveWorker::step() {
  // Before the pull: a ring that overflows holds more than one pull takes, so that no loss is reached unseen.
  look_for_losses();
  const std::size_t count = source->pull(bytes_);
  if (count == 0) {
    return false;
  }
  // After the pull: what came meanwhile makes this later than it need be, which the clock does not mind.
  const double newest_s = source->newest_frame_time_s();
  // Later than that, so that nothing seems to have arrived before it was captured.
  const double arrived_s = now_s();
  std::span<const std::byte> fresh(bytes_.data(), count);
  while (!losses_.empty()) {
    const Loss loss = losses_.front();
    const std::size_t before =
        static_cast<std::size_t>(std::max<std::int64_t>(loss.at - frames_given_, 0)) * format.bytes_per_frame();
    if (before > fresh.size()) {
      break;
    }
    losses_.pop_front();
    take_in(fresh.first(before), arrived_s);
    fresh = fresh.subspan(before);
    frames_given_ = std::max(frames_given_, loss.at);
    make_up_for(loss, arrived_s);
  }
  const auto rest = static_cast<std::int64_t>(fresh.size() / format.bytes_per_frame());
  frames_given_ += rest;
  if (newest_s > 0.0) {
    clock_.arrived(frames_pulled_ + rest, newest_s);
  }
  take_in(fresh, arrived_s);
  return count == bytes_.size();
}

void LiveWorker::take_in(std::span<const std::byte> bytes, double arrived_s) {
  if (bytes.empty()) {
    return;
  }
  record(bytes);
  samples_.resize(bytes.size() / acquire::bytes_per_sample(format.type));
  acquire::to_float(format.type, bytes, samples_);
  frames_pulled_ += static_cast<std::int64_t>(bytes.size() / format.bytes_per_frame());
  scope_.insert(scope_.end(), samples_.begin(), samples_.end());
  keep_newest(scope_, 2 * static_cast<std::size_t>(kScope_s * format.rate.hz));
  {
    const std::scoped_lock lock(front_mutex_);
    front_.push(samples_);
    note(front_.take_diagnostics());
  }
  solve_frames(arrived_s);
}

void LiveWorker::record(std::span<const std::byte> bytes) {
  const std::scoped_lock lock(mutex);
  if (new_calibration) {
    if (recorder) {
      (void)recorder->set_calibration(*new_calibration);  // a disk that fails shows when samples are written
    }
    pose_.set_calibration(*std::exchange(new_calibration, {}));
  }
  if (new_headings) {
    pose_.set_headings(*std::exchange(new_headings, {}));
  }
  if (!recorder) {
    return;
  }
  if (recording_start < 0) {
    recording_start = frames_pulled_;
  }
  if (recording_error.empty()) {
    if (Status status = recorder->write(bytes); !status) {
      recording_error = status.error().text();
    }
  }
}

void LiveWorker::write_pending_events() {
  const std::scoped_lock lock(mutex);
  for (const take::TakeEvent& event : std::exchange(pending_events, {})) {
    if (recorder) {
      (void)recorder->add_event(event);
    }
  }
}

void LiveWorker::note(const Diagnostics& found) {
  if (found.empty()) {
    return;
  }
  diagnostics_.insert(diagnostics_.end(), found.begin(), found.end());
  keep_newest(diagnostics_, kKeptDiagnostics);
  write_events(found);
}

void LiveWorker::write_events(const Diagnostics& found) {
  const std::scoped_lock lock(mutex);
  if (!recorder) {
    return;
  }
  for (const Diagnostic& diagnostic : found) {
    const std::int64_t stream =
        diagnostic.time_s >= 0.0 ? format.rate.index(Seconds{diagnostic.time_s}).value : frames_pulled_;
    const std::int64_t sample =
        std::clamp<std::int64_t>(stream - std::max<std::int64_t>(recording_start, 0), 0, recorder->frames());
    std::string text = diagnostic.message;
    if (!diagnostic.remedy.empty()) {
      text += "; " + diagnostic.remedy;
    }
    (void)recorder->add_event({SampleIndex{sample}, diagnostic.code, text, 0});
  }
}

void LiveWorker::look_for_losses() {
  const acquire::SourceCounters seen = source->counters();
  if (seen.overflows == counters_.overflows && seen.dropped_frames == counters_.dropped_frames) {
    return;
  }
  const std::uint64_t dropped = seen.dropped_frames - counters_.dropped_frames;
  counters_ = seen;
  if (!losses_.empty() && losses_.back().at == seen.lost_at) {
    losses_.back().dropped += dropped;
  } else {
    losses_.push_back({seen.lost_at, dropped});
  }
}

// Silence for what is known to be missing, in the take as in the decoder: everything after it keeps its time.
void LiveWorker::make_up_for(const Loss& loss, double arrived_s) {
  clock_.restart();
  const std::string amount = loss.dropped > 0 ? fmt::format("{} samples were lost", loss.dropped)
                                              : std::string("samples were lost, the device does not say how many");
  note({{Severity::kWarning, "dropped", amount,
         "close programs that keep the computer busy, or choose a larger buffer of the sound card", source->title(),
         format.rate.seconds(SampleIndex{frames_pulled_}).value}});
  const std::size_t frame = format.bytes_per_frame();
  const std::vector<std::byte> silence(std::min<std::uint64_t>(loss.dropped, bytes_.size() / frame) * frame);
  for (std::uint64_t left = loss.dropped; left > 0;) {
    const std::uint64_t count = std::min<std::uint64_t>(left, silence.size() / frame);
    take_in(std::span(silence).first(count * frame), arrived_s);
    left -= count;
  }
}

void LiveWorker::solve_frames(double arrived_s) {
  const std::vector<decode::AccelerationFrame> fresh = front_.take_frames();
  for (const decode::AccelerationFrame& frame : fresh) {
    pose_.push(frame);
  }
  frames_.insert(frames_.end(), fresh.begin(), fresh.end());
  keep_newest(frames_, kKeptFrames);
  const std::vector<decode::LineInCycle> fresh_cycles = front_.take_cycles();
  cycles_.insert(cycles_.end(), fresh_cycles.begin(), fresh_cycles.end());
  keep_newest(cycles_, kKeptCycles);
  if (!fresh_cycles.empty() && !pose_.pose().empty()) {
    hand_over(fresh_cycles.back(), arrived_s);
  }
}

void LiveWorker::hand_over(const decode::LineInCycle& newest, double arrived_s) {
  auto next = std::make_shared<LiveFigure>();
  next->number = ++figures_;
  const std::vector<decode::AccelerationFrame> ahead = front_.frames_ahead();
  next->pose = pose_.ahead(ahead);
  next->time_s = ahead.empty() ? frames_.back().time_s : ahead.back().time_s;
  if (clock_.known()) {
    next->times.oldest_slot = clock_.time_of(newest.sample[0]);
    next->times.instant = clock_.time_of(next->time_s * format.rate.hz);
    next->times.cycle_end = clock_.time_of(newest.start_sample + newest.period_samples);
    next->times.arrived = arrived_s;
    next->times.solved = now_s();
    latency_.add(next->times);
  }
  {
    const std::scoped_lock lock(published_mutex);
    figure = std::move(next);
  }
  if (told) {
    told();
  }
}

void LiveWorker::publish() {
  last_publish_s_ = now_s();
  auto snapshot = std::make_shared<LiveSnapshot>();
  snapshot->version = ++version_;
  snapshot->format = format;
  snapshot->stream_time_s = format.rate.seconds(SampleIndex{frames_pulled_}).value;
  snapshot->line = front_.status();
  const std::size_t scope_size = std::min(scope_.size(), 2 * static_cast<std::size_t>(kScope_s * format.rate.hz));
  snapshot->scope.assign(scope_.end() - static_cast<std::ptrdiff_t>(scope_size), scope_.end());
  snapshot->scope_first_sample = static_cast<double>(frames_pulled_ - static_cast<std::int64_t>(scope_size / 2));
  for (const decode::LineInCycle& cycle : cycles_) {
    if (cycle.start_sample + cycle.period_samples > snapshot->scope_first_sample) {
      snapshot->scope_cycles.push_back(cycle);
    }
  }
  snapshot->frames.assign(frames_.end() - static_cast<std::ptrdiff_t>(std::min(frames_.size(), kKeptFrames)),
                          frames_.end());
  const calibrate::RigCalibration& calibration = pose_.calibration();
  snapshot->specific_force.resize(settings.rig.accelerometers.size());
  for (std::size_t s = 0; s < settings.rig.accelerometers.size(); ++s) {
    snapshot->specific_force[s].reserve(snapshot->frames.size());
    for (const decode::AccelerationFrame& frame : snapshot->frames) {
      snapshot->specific_force[s].push_back(calibration.sensors[s].apply(frame.volts[s]));
    }
    snapshot->health.push_back(
        sensor_health(settings.rig, calibration.sensors[s], static_cast<int>(s), snapshot->frames));
  }
  if (figure) {  // only this thread changes it
    snapshot->pose = figure->pose;
    snapshot->pose_time_s = figure->time_s;
  }
  snapshot->diagnostics.assign(
      diagnostics_.end() - static_cast<std::ptrdiff_t>(std::min(diagnostics_.size(), kKeptDiagnostics)),
      diagnostics_.end());
  snapshot->counters = counters_;
  snapshot->source_alive = !is_gone_ && source->alive();
  snapshot->device_latency_s = source->device_latency_s();
  snapshot->latency = latency_.report();
  snapshot->latency_mean_s = snapshot->latency.of(LatencyStage::kTotal).mean_s;
  snapshot->latency_max_s = snapshot->latency.of(LatencyStage::kTotal).max_s;
  snapshot->preferred = preferred_;
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
  const std::scoped_lock lock(published_mutex);
  published = std::move(snapshot);
}

}  // namespace limbwave::solve
