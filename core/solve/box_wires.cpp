#include "solve/box_wires.h"

#include <algorithm>
#include <cmath>

namespace limbwave::solve {
namespace {

constexpr double kLevelStretch_s = 0.1;  // above a round of the sources, so that every pulse is in one
constexpr double kCountStretch_s = 0.5;
constexpr float kFullScale = 0.9995F;

}  // namespace

BoxWires::BoxWires(const body::Rig& rig, SampleRate rate) : rate_hz_(rate.hz) {
  for (const body::Microphone& microphone : rig.microphones) {
    names_.push_back(microphone.name);
  }
  wires_.resize(names_.size());
}

void BoxWires::advance(std::int64_t frames) {
  level_frames_ += frames;
  count_frames_ += frames;
  if (static_cast<double>(level_frames_) >= kLevelStretch_s * rate_hz_) {
    level_frames_ = 0;
    for (Count& wire : wires_) {
      wire.shown_peak = wire.peak;
      wire.peak = 0.0F;
    }
  }
  if (const double seconds = static_cast<double>(count_frames_) / rate_hz_; seconds >= kCountStretch_s) {
    count_frames_ = 0;
    for (Count& wire : wires_) {
      wire.words_hz = wire.words / seconds;
      wire.ranges_hz = wire.ranges / seconds;
      wire.words = wire.ranges = 0;
    }
  }
}

void BoxWires::push(std::span<const float> samples) {
  const std::size_t count = wires_.size();
  for (std::size_t first = 0; first + count <= samples.size(); first += count) {
    for (std::size_t w = 0; w < count; ++w) {
      wires_[w].peak = std::max(wires_[w].peak, std::abs(samples[first + w]));
    }
  }
  advance(static_cast<std::int64_t>(samples.size() / std::max<std::size_t>(1, count)));
}

void BoxWires::note(std::span<const acquire::BoxEvent> events) {
  for (const acquire::BoxEvent& event : events) {
    const bool back = event.kind == "wire-back";
    if ((back || event.kind == "wire-pulled") && event.count >= 0 &&
        event.count < static_cast<std::int64_t>(wires_.size())) {
      wires_[static_cast<std::size_t>(event.count)].plugged = back;
    }
  }
}

void BoxWires::note(std::span<const decode::RangeReading> ranges, std::span<const decode::InertialReading> words) {
  for (const decode::RangeReading& range : ranges) {
    wires_.at(static_cast<std::size_t>(range.receiver)).ranges += range.verdict == decode::RangeVerdict::kAccepted;
  }
  for (const decode::InertialReading& word : words) {
    wires_.at(static_cast<std::size_t>(word.board)).words += word.valid;
  }
}

std::vector<BoxWire> BoxWires::state(const decode::DriverBoxDecoder& decoder) const {
  std::vector<BoxWire> state(wires_.size());
  for (std::size_t w = 0; w < wires_.size(); ++w) {
    state[w].board = names_[w];
    state[w].level = static_cast<double>(wires_[w].shown_peak);
    state[w].clipped = wires_[w].shown_peak >= kFullScale;
    state[w].plugged = wires_[w].plugged;
    state[w].words_hz = wires_[w].words_hz;
    state[w].ranges_hz = wires_[w].ranges_hz;
    const decode::WordStatus& words = decoder.words(static_cast<int>(w));
    state[w].locked = words.locked;
    state[w].frames = words.counters.frames;
    state[w].lost_frames = words.counters.lost;
    state[w].bit_errors = words.counters.bit_errors;
  }
  return state;
}

}  // namespace limbwave::solve
