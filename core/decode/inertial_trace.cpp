#include "decode/inertial_trace.h"

#include <algorithm>

namespace limbwave::decode {

void InertialTrace::add(const InertialReading& reading) {
  if (reading.valid && (samples_.empty() || reading.time.value > samples_.back().time_s)) {
    samples_.push_back({reading.time.value, reading.w_WS_S, reading.f_S, reading.saturated});
  }
}

FeltMotion InertialTrace::at(double time_s) const {
  FeltMotion felt;
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), time_s,
                                      [](const Sample& sample, double t) { return sample.time_s < t; });
  if (after == samples_.begin() || after == samples_.end()) {
    return felt;
  }
  const Sample& b = *after;
  const Sample& a = *(after - 1);
  if (b.time_s - a.time_s > longest_s_) {
    return felt;
  }
  const double u = (time_s - a.time_s) / (b.time_s - a.time_s);
  felt.w_S = a.w_S + u * (b.w_S - a.w_S);
  felt.f_S = a.f_S + u * (b.f_S - a.f_S);
  felt.saturated = a.saturated || b.saturated;
  felt.known = true;
  return felt;
}

FeltMotion InertialTrace::over(double from_s, double to_s) const {
  const FeltMotion a = at(from_s);
  const FeltMotion m = at(0.5 * (from_s + to_s));
  const FeltMotion b = at(to_s);
  FeltMotion felt;
  felt.known = a.known && m.known && b.known;
  if (felt.known) {
    felt.w_S = (a.w_S + 4.0 * m.w_S + b.w_S) / 6.0;
    felt.f_S = (a.f_S + 4.0 * m.f_S + b.f_S) / 6.0;
    felt.saturated = a.saturated || m.saturated || b.saturated;
  }
  return felt;
}

void InertialTrace::forget(double before_s) {
  while (samples_.size() > 2 && samples_[1].time_s < before_s) {
    samples_.pop_front();
  }
}

}  // namespace limbwave::decode
