#include "decode/stereo_history.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "signal/lanes.h"

namespace limbwave::decode {
namespace {

struct Facts {
  float left_peak = 0.0F, right_peak = 0.0F;
  bool finite = true;
};

/// Takes channels apart. Zero times a number is zero unless the number is not finite.
Facts take_apart(const float* interleaved, std::size_t frames, float* left, float* right) {
  signal::Lanes left_peaks{};
  signal::Lanes right_peaks{};
  signal::Lanes zeros{};
  std::size_t i = 0;
  for (; i + signal::kLanes <= frames; i += signal::kLanes) {
    const signal::Lanes a = signal::load_lanes(interleaved + 2 * i);
    const signal::Lanes b = signal::load_lanes(interleaved + 2 * i + signal::kLanes);
    const signal::Lanes l = __builtin_shufflevector(a, b, 0, 2, 4, 6);
    const signal::Lanes r = __builtin_shufflevector(a, b, 1, 3, 5, 7);
    signal::store_lanes(l, left + i);
    signal::store_lanes(r, right + i);
    left_peaks = signal::larger(signal::magnitude(l), left_peaks);
    right_peaks = signal::larger(signal::magnitude(r), right_peaks);
    zeros += 0.0F * a + 0.0F * b;
  }
  Facts facts;
  facts.left_peak = signal::largest_of(left_peaks);
  facts.right_peak = signal::largest_of(right_peaks);
  double zero = signal::sum_of(zeros);
  for (; i < frames; ++i) {
    left[i] = interleaved[2 * i];
    right[i] = interleaved[2 * i + 1];
    facts.left_peak = std::max(facts.left_peak, std::fabs(left[i]));
    facts.right_peak = std::max(facts.right_peak, std::fabs(right[i]));
    zero += 0.0F * left[i] + 0.0F * right[i];
  }
  facts.finite = zero == 0.0;
  return facts;
}

}  // namespace

void PeakMeter::add(std::int64_t position, float peak) {
  const std::int64_t block = position / length_;
  const auto tenths = static_cast<std::int64_t>(peaks_.size());
  for (std::int64_t skipped = std::max(block_ + 1, block - tenths + 1); skipped <= block; ++skipped) {
    peaks_[static_cast<std::size_t>(skipped % tenths)] = 0.0F;
  }
  block_ = block;
  float& largest = peaks_[static_cast<std::size_t>(block % tenths)];
  largest = std::max(largest, peak);
}

float PeakMeter::peak() const {
  return *std::max_element(peaks_.begin(), peaks_.end());
}

bool StereoHistory::append(std::span<const float> interleaved) {
  const std::size_t frames = interleaved.size() / 2;
  reserve(count_ + frames);
  // Peaks are only kept when all is good, so that a second try does not count twice.
  const std::size_t old_count = count_;
  PeakMeter left_peaks = left_peaks_;
  PeakMeter right_peaks = right_peaks_;
  std::size_t at = 0;
  while (at < frames) {
    const std::int64_t here = position();
    const std::size_t part = std::min(frames - at, static_cast<std::size_t>(left_peaks.room(here)));
    const Facts facts = take_apart(interleaved.data() + 2 * at, part, left_.get() + count_, right_.get() + count_);
    if (!facts.finite) {
      count_ = old_count;
      return false;
    }
    left_peaks.add(here, facts.left_peak);
    right_peaks.add(here, facts.right_peak);
    count_ += part;
    at += part;
  }
  left_peaks_ = left_peaks;
  right_peaks_ = right_peaks;
  return true;
}

void StereoHistory::restart(std::int64_t position) {
  count_ = 0;
  first_ = position;
}

void StereoHistory::drop_before(std::int64_t from) {
  // Moving what stays only when it is the smaller part keeps the cost per sample constant.
  const std::int64_t old = std::min(from - first_, static_cast<std::int64_t>(count_));
  if (old <= 4096 || 2 * old <= static_cast<std::int64_t>(count_)) {
    return;
  }
  count_ -= static_cast<std::size_t>(old);
  for (float* channel : {left_.get(), right_.get()}) {
    std::memmove(channel, channel + old, count_ * sizeof(float));
  }
  first_ += old;
}

void StereoHistory::reserve(std::size_t count) {
  if (count <= capacity_) {
    return;
  }
  const std::size_t capacity = std::max(count, 2 * capacity_);
  for (std::unique_ptr<float[]>* channel : {&left_, &right_}) {
    std::unique_ptr<float[]> larger(new float[capacity]);  // not zeroed: every sample is written before it is read
    if (count_ > 0) {
      std::memcpy(larger.get(), channel->get(), count_ * sizeof(float));
    }
    *channel = std::move(larger);
  }
  capacity_ = capacity;
}

}  // namespace limbwave::decode
