/// The paper's way to an arrival (Vlasic et al. 2007, §4.1): band pass, square, low pass, steepest point of the first
/// rising power envelope, minus an offset.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/time.h"
#include "decode/ranging_format.h"
#include "signal/fir_design.h"

namespace limbwave::decode {

class SteepestPoint {
 public:
  SteepestPoint(const RangingFormat& format, SampleRate rate);

  /// Samples that `find` needs before and after the slot.
  [[nodiscard]] std::size_t margin() const { return margin_; }

  struct Found {
    double delay_s = 0.0;  ///< From the slot's start to the pulse's beginning.
    double peak = 0.0;     ///< Amplitude of the first envelope peak.
    double noise = 0.0;    ///< In-band power of the slot's quiet part.
  };
  /// `samples` start `margin()` before the slot and end as much after it.
  [[nodiscard]] std::optional<Found> find(std::span<const float> samples);

 private:
  [[nodiscard]] std::optional<Found> steepest(std::span<const float> samples);

  double rate_hz_;
  signal::SymmetricFir band_, low_;
  std::size_t margin_ = 0;
  double offset_s_ = 0.0;
  std::vector<float> power_, envelope_, sorted_;
};

}  // namespace limbwave::decode
