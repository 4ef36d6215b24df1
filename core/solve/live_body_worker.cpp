#include "solve/live_body_worker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "estimate/body_adjoint.h"
#include "solve/driver_box.h"

namespace limbwave::solve {
namespace {

constexpr double kWait = 0.05;
constexpr double kPortion = 0.1;    // s of samples that are decoded before the filter has its turn
constexpr double kCaughtUp = 0.15;  // s that may wait after something was left out
constexpr double kPublishInterval = 1.0 / 30.0;
constexpr double kWordInterval = 1.0 / 140.0;  // of the wire's words: how old the oldest sample in a reading is

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

LiveBodyWorker::LiveBodyWorker(std::unique_ptr<acquire::BoxSource> source, LiveBodySettings live_settings)
    : box(std::move(source)),
      settings(std::move(live_settings)),
      format(box->format()),
      wire_pulled(settings.rig.microphones.size()),
      clock(format.rate),
      wires_(settings.rig, format.rate),
      clock_(format.rate) {
  state_.format = format;
  state_.title = box->title();
}

Status LiveBodyWorker::prepare() {
  const std::string& root = settings.solve.root;
  if (root != "free" && root != "fixed" && root != "contacts") {
    return Error{"cannot be known while recording", "root \"" + root + "\"", "choose free, fixed or contacts"};
  }
  model_ = estimate::body_model(settings.rig, settings.skeleton);
  for (const body::Gyroscope& gyroscope : settings.rig.gyroscopes) {
    board_of_chip_.push_back(model_.find_board(gyroscope.name));
  }
  for (const body::Microphone& microphone : settings.rig.microphones) {
    board_of_microphone_.push_back(model_.find_board(microphone.name));
  }
  for (const body::Source& source : settings.rig.sources) {
    source_of_.push_back(model_.find_source(source.name));
  }
  tracker_ = std::make_unique<estimate::BodyTracker>(model_, body_parameters(model_, settings.solve),
                                                     watch_parameters(model_, settings.solve),
                                                     estimate::TrackerSettings{settings.solve.rate_hz, settings.lag_s});
  if (settings.solve.align_words) {
    aligner_ = std::make_unique<WordAligner>(model_, settings.rig.driver_box->word_rate_hz);
  }
  decode::DriverBoxFormat decoded = driver_box_format(settings.rig, settings.skeleton, settings.ranging);
  decoded.rate = format.rate;
  const decode::DriverBoxParameters parameters = live_decoding();
  settled_s_ = live_settled_s(parameters, settings.rig.driver_box->word_rate_hz, aligner_ ? aligner_->delay_s() : 0.0);
  decoder_ = std::make_unique<decode::DriverBoxDecoder>(decoded, parameters);
  return {};
}

std::int64_t LiveBodyWorker::length_of(const acquire::BoxPiece& piece) const {
  return piece.lost + static_cast<std::int64_t>(piece.bytes.size() / format.bytes_per_frame());
}

// What came, to the take; a disk that fails ends the recording, not the picture.
void LiveBodyWorker::write(const acquire::BoxPart& part) {
  const std::scoped_lock lock(recording_mutex);
  if (recording && recording_error.empty()) {
    if (Status written = recording->take_in(part); !written) {
      recording_error = written.error().text();
    }
    recording->note(box->status());
    recorded_s = recording->seconds();
    disk_left_s = recording->disk_left_s();
  }
  for (const acquire::BoxPiece& piece : part.pieces) {
    pulled += length_of(piece);
  }
  for (const acquire::BoxEvent& event : part.events) {
    const bool gone = event.kind == "wire-pulled";
    if ((gone || event.kind == "wire-back") && event.count >= 0 &&
        event.count < static_cast<std::int64_t>(wire_pulled.size())) {
      wire_pulled[static_cast<std::size_t>(event.count)] = gone;
    }
  }
}

void LiveBodyWorker::queue_up(acquire::BoxPart part, double arrived_s) {
  const std::lock_guard lock(queue_mutex);
  std::int64_t frames = 0;
  for (const acquire::BoxPiece& piece : part.pieces) {
    frames += length_of(piece);
  }
  // Positions of a box that was away are by our own clock: the capture clock begins again.
  const auto away = [](const acquire::BoxEvent& event) {
    return event.kind == "line-back" || event.kind == "box-restarted";
  };
  if (std::ranges::any_of(part.events, away)) {
    clock.restart();
  }
  if (frames > 0) {
    clock.arrived(pulled, arrived_s);
  }
  for (acquire::BoxPiece& piece : part.pieces) {
    waiting_frames += length_of(piece) - piece.lost;
    queue.push_back({std::move(piece), arrived_s});
  }
  queue_events.insert(queue_events.end(), part.events.begin(), part.events.end());
  queue_changed.notify_one();
}

void LiveBodyWorker::pull() {
  while (true) {
    const bool last = stopping;
    if (last) {
      box->stop();
    }
    acquire::BoxPart part = box->pull(last ? 0.0 : kWait);
    const double arrived_s = now_s();
    write(part);
    queue_up(std::move(part), arrived_s);
    if (last || arrived_s - pulled_published_s_ >= kPublishInterval) {
      pulled_published_s_ = arrived_s;
      publish_pulled(last);
    }
    if (last) {
      break;
    }
  }
  const std::lock_guard lock(queue_mutex);
  ended = true;
  queue_changed.notify_one();
}

void LiveBodyWorker::take_in(const Fresh& fresh) {
  const acquire::BoxPiece& piece = fresh.piece;
  if (piece.lost > 0) {
    decoder_->gap(SampleCount{piece.lost});
    wires_.gap(piece.lost);
    position_ += piece.lost;
  }
  const std::size_t frames = piece.bytes.size() / format.bytes_per_frame();
  samples_.resize(frames * static_cast<std::size_t>(format.channels));
  acquire::to_float(format.type, piece.bytes, samples_);
  if (frames > 0) {
    decoder_->push(samples_);
    wires_.push(samples_);
    position_ += static_cast<std::int64_t>(frames);
  }
  arrived_s_ = fresh.arrived_s;
}

void LiveBodyWorker::show(const estimate::TrackedPose& pose) {
  state_.pose = body::poses_from_joints(settings.skeleton, pose.R_joint, pose.root_p_W);
  state_.pose_time_s = pose.time_s;
  auto next = std::make_shared<LiveFigure>();
  next->number = ++figures_;
  next->pose = state_.pose;
  next->time_s = pose.time_s;
  if (clock_.known()) {
    // The pose waits for what may still come out of the decoder with its time.
    next->times.oldest_slot = clock_.time_of((pose.time_s - (aligner_ ? 2.0 : 1.0) * kWordInterval) * format.rate.hz);
    next->times.instant = clock_.time_of(pose.time_s * format.rate.hz);
    next->times.cycle_end = std::min(arrived_s_, clock_.time_of((pose.time_s + settled_s_) * format.rate.hz));
    next->times.arrived = arrived_s_;
    next->times.solved = now_s();
    latency_.add(next->times);
  }
  {
    const std::lock_guard lock(published_mutex);
    figure = std::move(next);
  }
  if (told) {
    told();
  }
}

// What has been decoded goes to the filter; one that refuses to start is asked no more.
void LiveBodyWorker::hand_on(bool all) {
  const std::vector<decode::RangeReading> heard = decoder_->take_ranges();
  const std::vector<decode::InertialReading> spoken = decoder_->take_inertial();
  wires_.note(heard, spoken);
  if (!state_.error.empty()) {
    return;
  }
  std::vector<estimate::RangeReading> ranges;
  for (const decode::RangeReading& range : heard) {
    if (range.verdict == decode::RangeVerdict::kAccepted) {
      ranges.push_back({range.emission_time.value, source_of_.at(static_cast<std::size_t>(range.source)),
                        board_of_microphone_.at(static_cast<std::size_t>(range.receiver)), range.range,
                        range.confidence(), range.variance});
    }
  }
  std::vector<estimate::InertialReading> words;
  for (const decode::InertialReading& word : spoken) {
    if (word.valid) {
      words.push_back(
          {word.time.value, board_of_chip_.at(static_cast<std::size_t>(word.board)), word.w_WS_S, word.f_S});
    }
  }
  state_.ranges += static_cast<std::int64_t>(ranges.size());
  if (aligner_) {
    words = aligner_->push(words);
  }
  state_.words += static_cast<std::int64_t>(words.size());
  Status pushed = tracker_->push(words, ranges, static_cast<double>(position_) / format.rate.hz - settled_s_);
  if (pushed && all) {
    pushed = tracker_->finish();
  }
  if (!pushed) {
    state_.error = pushed.error().text();
    return;
  }
  const std::vector<estimate::TrackedPose> poses = tracker_->take_poses();
  const std::vector<estimate::TrackedPose> smoothed = tracker_->take_smoothed();
  if (told_poses && (!poses.empty() || !smoothed.empty())) {
    told_poses(poses, smoothed);
  }
  if (!smoothed.empty()) {
    state_.smoothed = body::poses_from_joints(settings.skeleton, smoothed.back().R_joint, smoothed.back().root_p_W);
    state_.smoothed_time_s = smoothed.back().time_s;
  }
  if (!poses.empty()) {
    state_.poses += static_cast<std::int64_t>(poses.size());
    pose_times_.insert(pose_times_.end(), poses.size(), now_s());
    show(poses.back());
  }
}

double LiveBodyWorker::joint_sigma_deg() const {
  const estimate::BodyFilter& filter = tracker_->filter();
  const int dofs = filter.layout().dofs;
  Eigen::MatrixXd P_theta(dofs, dofs);
  for (int d = 0; d < dofs; ++d) {
    std::copy_n(filter.covariance().row(d), dofs, P_theta.col(d).data());
  }
  const estimate::PoseSigma sigma =
      estimate::pose_sigma(filter.tree(), settings.skeleton, filter.state().joints, P_theta, {});
  double sum = 0.0;
  int count = 0;
  for (const float joint : sigma.joints) {
    if (joint > 0.0F) {
      sum += static_cast<double>(joint);
      ++count;
    }
  }
  return count > 0 ? degrees(sum / count) : 0.0;
}

void LiveBodyWorker::publish() {
  published_s_ = now_s();
  while (!pose_times_.empty() && pose_times_.front() < published_s_ - 1.0) {
    pose_times_.pop_front();
  }
  state_.poses_hz = static_cast<double>(pose_times_.size());
  state_.stream_time_s = static_cast<double>(position_) / format.rate.hz;
  state_.started = tracker_->started();
  state_.late = tracker_->late();
  state_.diagnostics = tracker_->findings();
  state_.latency = latency_.report();
  state_.wires = wires_.state(*decoder_);
  for (std::size_t w = 0; w < state_.wires.size(); ++w) {
    if (const int board = board_of_microphone_[w]; board >= 0 && state_.started) {
      state_.wires[w].state = tracker_->watch().sensors().board(static_cast<std::size_t>(board));
    }
  }
  state_.standing.clear();
  const estimate::FootContacts& contacts = tracker_->watch().contacts();
  for (std::size_t i = 0; i < contacts.soles().size(); ++i) {
    if (contacts.standing(i)) {
      state_.standing.push_back(contacts.soles()[i].name);
    }
  }
  if (state_.started) {
    state_.joint_sigma_deg = joint_sigma_deg();
    if (tracker_->filter().tree().root_motion() == body::RootMotion::kFree) {
      const estimate::FootContacts* feet = tracker_->watch().feet();
      for (int i = 0; i < 3; ++i) {
        state_.root_sigma[i] = feet != nullptr ? feet->place(tracker_->filter().state().time_s).sigma[i]
                                               : std::sqrt(tracker_->filter().covariance()(i, i));
      }
    }
  }
  auto next = std::make_shared<LiveBodySnapshot>(state_);
  {
    const std::lock_guard lock(queue_mutex);
    next->behind_s = static_cast<double>(waiting_frames) / format.rate.hz;
    next->skipped_s = static_cast<double>(skipped_frames) / format.rate.hz;
  }
  if (next->skipped_s > 0.0) {
    next->diagnostics.push_back({Severity::kWarning, "live.too-slow",
                                 "this computer is too slow for the live picture, which has left something out",
                                 "the recording is whole: solve it afterwards", ""});
  }
  const std::lock_guard lock(published_mutex);
  const LiveBodySnapshot& old = *published;
  next->connected = old.connected;
  next->counters = old.counters;
  next->status = old.status;
  next->running = old.running;
  next->recording = old.recording;
  next->take_folder = old.take_folder;
  next->recorded_s = old.recorded_s;
  next->disk_left_s = old.disk_left_s;
  next->recording_error = old.recording_error;
  next->version = old.version + 1;
  published = std::move(next);
}

void LiveBodyWorker::publish_pulled(bool last) {
  LiveBodySnapshot now;
  {
    const std::scoped_lock lock(recording_mutex);
    now.recording = recording != nullptr && recording_error.empty();
    now.take_folder = take_folder;
    now.recording_error = recording_error;
    now.recorded_s = recorded_s;
    now.disk_left_s = disk_left_s;
  }
  const std::lock_guard lock(published_mutex);
  auto next = std::make_shared<LiveBodySnapshot>(*published);
  next->title = state_.title;  // never changes
  next->format = format;
  next->connected = box->connected();
  next->counters = box->counters();
  next->status = box->status();
  next->running = !last;
  next->recording = now.recording;
  next->take_folder = now.take_folder;
  next->recording_error = now.recording_error;
  next->recorded_s = now.recorded_s;
  next->disk_left_s = now.disk_left_s;
  ++next->version;
  published = std::move(next);
}

// Leaves out the oldest of what waits, so that only so much is left.
void LiveBodyWorker::skip_to(std::int64_t left) {
  std::int64_t frames = waiting_frames;
  for (Fresh& one : queue) {
    if (frames <= left) {
      break;
    }
    const std::int64_t length = length_of(one.piece);
    frames -= length - one.piece.lost;
    skipped_frames += length - one.piece.lost;
    one.piece = {length, {}};
  }
  waiting_frames = frames;
}

void LiveBodyWorker::solve() {
  bool last = false;
  while (!last) {
    std::deque<Fresh> fresh;
    std::vector<acquire::BoxEvent> events;
    {
      std::unique_lock lock(queue_mutex);
      queue_changed.wait_for(lock, std::chrono::milliseconds(200), [&] { return ended || !queue.empty(); });
      // Raw samples are recorded; the picture may skip what it could only show too late.
      if (static_cast<double>(waiting_frames) > settings.most_behind_s * format.rate.hz) {
        skip_to(static_cast<std::int64_t>(std::min(kCaughtUp, settings.most_behind_s) * format.rate.hz));
      }
      for (std::int64_t frames = 0; !queue.empty() && static_cast<double>(frames) < kPortion * format.rate.hz;) {
        const std::int64_t length = length_of(queue.front().piece);
        frames += length;
        waiting_frames -= length - queue.front().piece.lost;
        fresh.push_back(std::move(queue.front()));
        queue.pop_front();
      }
      events.swap(queue_events);
      clock_ = clock;
      last = ended && queue.empty();
    }
    wires_.note(events);
    for (const Fresh& one : fresh) {
      take_in(one);
    }
    if (last) {
      decoder_->finish();
    }
    hand_on(last);
    if (last || now_s() - published_s_ >= kPublishInterval) {
      publish();
    }
  }
}

}  // namespace limbwave::solve
