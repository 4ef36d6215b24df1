#include "simulate/analog_line.h"

#include <cmath>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

constexpr double kWarmUp = 1.5;           // seconds before the first period
constexpr double kWanderSeconds = 5.0;    // correlation time of the clock's drift
constexpr double kSlowestRelative = 0.2;  // a slot never gets shorter than this fraction

}  // namespace

AnalogLine::AnalogLine(const body::LineInSignal& board, const LineInErrors& errors, std::uint64_t seed,
                       SlotVoltages& voltages, double rate_hz, std::int64_t first)
    : board_(board),
      errors_(errors),
      voltages_(voltages),
      wander_random_(seed, "clock wander"),
      jitter_random_(seed, "clock jitter"),
      period_(1.0 / rate_hz),
      number_(first - static_cast<std::int64_t>(std::ceil(kWarmUp * rate_hz))),
      time_((static_cast<double>(number_) - 0.5) * period_),
      coupling_(2.0 * kPi * errors.coupling_hz) {
  if (errors_.ringing > 0.0) {
    ring_pole_ = {-1.0 / errors_.ringing_decay_s, 2.0 * kPi * errors_.ringing_hz};
    ring_step_ = std::exp(ring_pole_ * period_);
  }
  wander_ = errors_.clock_wander * wander_random_.normal();
  // Somewhere in the middle of a cycle, the same place whatever the rate: the board knows nothing of the recorder.
  Random start(seed, "clock start");
  const double slot_seconds = 1.0 / (board_.cycle_rate_hz * board_.slots);
  slot_ = static_cast<int>(start.uniform() * board_.slots);
  slot_end_ = -kWarmUp - (2.0 + start.uniform()) * slot_seconds;
  left_mean_ = (board_.zero_g_volts * (board_.slots - 1) + board_.reference_volts) / board_.slots;
  right_mean_ = 0.5 * board_.supply_volts;
  a_ = board_.zero_g_volts;
  while (slot_end_ <= time_) {
    next_slot();
  }
  settle_ = 0.0;
  left_ring_ = right_ring_ = 0.0;
  while (number_ < first) {
    next();
  }
}

std::vector<double> AnalogLine::take_cycle_starts() {
  return std::exchange(cycle_starts_, {});
}

void AnalogLine::next_slot() {
  const double length = slot_end_ - slot_start_;
  const double old_left = a_ + length * (b_ + length * c_);
  const double old_right = right_level_;
  slot_ = (slot_ + 1) % board_.slots;
  slot_start_ = slot_end_;
  const double nominal = 1.0 / (board_.cycle_rate_hz * board_.slots);
  if (errors_.clock_wander > 0.0) {
    const double keep = std::exp(-nominal / kWanderSeconds);
    wander_ = keep * wander_ + errors_.clock_wander * std::sqrt(1.0 - keep * keep) * wander_random_.normal();
  }
  const double jitter = errors_.clock_jitter > 0.0 ? errors_.clock_jitter * jitter_random_.normal() : 0.0;
  const double rate = (1.0 + errors_.clock_offset) * (1.0 + wander_) * (1.0 + jitter);
  const double duration = nominal / std::max(rate, kSlowestRelative);
  slot_end_ = slot_start_ + duration;
  if (slot_ == 0) {
    cycle_starts_.push_back(slot_start_);
  }
  right_level_ = slot_ < board_.slots / 2 ? 0.0 : board_.supply_volts;

  const int sensor = slot_ / 3;
  if (slot_ == board_.slots - 1) {
    a_ = board_.reference_volts;
    b_ = c_ = 0.0;
  } else {
    voltages_.begin_slot();
    const double v0 = voltages_.volts(sensor, slot_ % 3, slot_start_);
    const double vm = voltages_.volts(sensor, slot_ % 3, slot_start_ + 0.5 * duration);
    const double v1 = voltages_.volts(sensor, slot_ % 3, slot_end_);
    a_ = v0;
    b_ = (-3.0 * v0 + 4.0 * vm - v1) / duration;
    c_ = 2.0 * (v0 - 2.0 * vm + v1) / (duration * duration);
  }
  settle_ -= a_ - old_left;
  left_ring_ += errors_.ringing * (a_ - old_left);
  right_ring_ += errors_.ringing * (right_level_ - old_right);
}

// First-order high pass: the state x follows x' = ω (v − x), the output is v − x, whose integral is (Δx)/ω. Exact for a
// constant v; v is replaced by its mean over the stretch, which is a sampling period or less.
double AnalogLine::high_pass(double& state, double mean, double duration, double decay) const {
  const double change = (mean - state) * (1.0 - decay);
  state += change;
  return coupling_ * duration > 1e-9 ? change / coupling_ : (mean - state) * duration;
}

void AnalogLine::integrate(double duration, bool whole_period, Pair& sum) {
  const double middle = time_ - slot_start_ + 0.5 * duration;
  double left = duration * (a_ + b_ * middle + c_ * (middle * middle + duration * duration / 12.0));
  double right = duration * right_level_;
  if (errors_.settle_s > 0.0) {
    const double rest = settle_ * std::exp(-duration / errors_.settle_s);
    left += (settle_ - rest) * errors_.settle_s;
    settle_ = rest;
  }
  if (errors_.ringing > 0.0) {
    const std::complex<double> turn = whole_period ? ring_step_ : std::exp(ring_pole_ * duration);
    const std::complex<double> integral = (turn - 1.0) / ring_pole_;
    left += (left_ring_ * integral).imag();
    right += (right_ring_ * integral).imag();
    left_ring_ *= turn;
    right_ring_ *= turn;
  }
  if (coupling_ > 0.0) {
    const double decay = std::exp(-coupling_ * duration);
    sum.left += high_pass(left_mean_, left / duration, duration, decay);
    sum.right += high_pass(right_mean_, right / duration, duration, decay);
  } else {
    // A DC-coupled card whose zero lies in the middle of the supply.
    sum.left += left - board_.zero_g_volts * duration;
    sum.right += right - 0.5 * board_.supply_volts * duration;
  }
}

AnalogLine::Pair AnalogLine::next() {
  const double end = (static_cast<double>(number_) + 0.5) * period_;
  Pair sum;
  bool whole = true;
  while (slot_end_ < end) {
    whole = false;
    if (slot_end_ > time_) {
      integrate(slot_end_ - time_, false, sum);
      time_ = slot_end_;
    }
    next_slot();
  }
  if (end > time_) {
    integrate(end - time_, whole, sum);
  }
  time_ = end;
  ++number_;
  return {sum.left / period_, sum.right / period_};
}

}  // namespace limbwave::simulate
