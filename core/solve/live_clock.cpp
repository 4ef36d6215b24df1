#include "solve/live_clock.h"

#include <algorithm>

namespace limbwave::solve {

namespace {
constexpr double kWindow_s = 5.0;
}

void CaptureClock::arrived(std::int64_t frames, double time_s) {
  if (!known()) {
    window_from_ = time_s;
  } else if (time_s - window_from_ > kWindow_s) {
    previous_ = current_;
    current_ = kNever;
    window_from_ = time_s;
  }
  current_ = std::min(current_, time_s - static_cast<double>(frames) / rate_.hz);
}

double CaptureClock::time_of(double sample) const {
  return std::min(current_, previous_) + sample / rate_.hz;
}

}  // namespace limbwave::solve
