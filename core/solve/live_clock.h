/// When a sample of a live stream was captured, on the computer's own clock.
#pragma once

#include <cstdint>
#include <limits>

#include "base/time.h"

namespace limbwave::solve {

/// Blocks of samples arrive when the device, the sound server and the scheduler get round to it; never too early. So
/// the earliest of them tell where the stream's clock stands, and whatever comes later than these is late. What this
/// cannot see is the delay that even the earliest block has: the device's own buffer.
///
/// The reference is the earliest arrival of the last 5 to 10 seconds: a device clock that is off by 100 ppm moves it by
/// at most 1 ms.
class CaptureClock {
 public:
  explicit CaptureClock(SampleRate rate) : rate_(rate) {}

  /// `frames` samples of the stream have been captured and handed over at `time_s` (steady_clock, seconds) or before.
  void arrived(std::int64_t frames, double time_s);
  /// Samples were lost: positions no longer tell the time.
  void restart() { *this = CaptureClock(rate_); }

  [[nodiscard]] bool known() const { return current_ < kNever; }
  /// Time at which the stream stood at `sample`, steady_clock seconds, the device's buffer aside. Needs `known()`.
  [[nodiscard]] double time_of(double sample) const;

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  SampleRate rate_;
  double current_ = kNever, previous_ = kNever;  // earliest start of the stream, by the arrivals of two windows of time
  double window_from_ = 0.0;
};

}  // namespace limbwave::solve
