/// From the samples of one wire to what is heard in each slot: arrivals and noise, without any knowledge of where the
/// microphone is. A streaming stage: results do not depend on how the samples are cut into blocks.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/time.h"
#include "decode/pulse_finder.h"
#include "decode/pulse_shape.h"
#include "decode/ranging_format.h"
#include "decode/steepest_point.h"

namespace limbwave::decode {

/// One slot of one wire.
struct HeardSlot {
  static constexpr std::size_t kMost = 4;
  std::int64_t slot = 0;
  int source = 0;                         ///< That fires in it.
  bool cut = false;                       ///< Samples are missing.
  double noise = 0.0;                     ///< Power of a complex value, over several slots.
  double noise_now = 0.0;                 ///< In this slot.
  std::array<Arrival, kMost> arrivals{};  ///< Delays are from the source's start; the first one first.
  std::size_t count = 0;
  std::optional<SteepestPoint::Found> steepest;  ///< By the paper's method, where it is asked for.
};

class PulseListener {
 public:
  PulseListener(const RangingFormat& format, SampleRate rate, const RangingParameters& parameters,
                std::shared_ptr<const PulseShape> shape);

  [[nodiscard]] const std::shared_ptr<const PulseShape>& shape() const { return shape_; }
  void push(const float* samples, std::size_t count, std::size_t stride);
  void gap(SampleCount count);
  /// Silence that completes the last slots; slots that began after the last sample are not given.
  void finish();
  std::vector<HeardSlot> take();
  [[nodiscard]] std::int64_t slots() const { return slot_; }  ///< Since the beginning.

 private:
  [[nodiscard]] std::int64_t end() const { return samples_start_ + static_cast<std::int64_t>(samples_.size()); }
  [[nodiscard]] std::size_t lead_values() const { return shape_->lead() + 4; }
  void filter();
  void advance();
  void one_slot(std::int64_t first);
  void measure_noise();
  double cut_window(std::int64_t first);

  RangingFormat format_;
  SampleRate rate_;
  RangingParameters parameters_;
  BasebandPlan plan_;
  std::shared_ptr<const PulseShape> shape_;
  PulseFinder finder_;
  std::unique_ptr<SteepestPoint> paper_;
  double longest_reach_ = 0.0;
  std::vector<float> samples_;
  std::int64_t samples_start_ = 0;
  std::vector<std::complex<float>> values_;  // value n is about sample n · step, carrier not yet turned back
  std::int64_t values_start_ = 0, next_value_ = 0;
  std::int64_t slot_ = 0;
  double noise_ = -1.0, noise_now_ = 0.0;
  std::vector<std::pair<std::int64_t, std::int64_t>> missing_;  // samples
  std::vector<std::complex<float>> window_;
  std::vector<float> powers_;
  std::vector<HeardSlot> heard_;
};

}  // namespace limbwave::decode
