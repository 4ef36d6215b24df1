#include "decode/cycle_decoder.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/units.h"

namespace limbwave::decode {
namespace {

// Until hum on the counter is found, it looks as if somebody turned the knob a little to and fro.
constexpr int kHumIsFound = 60;     // cycles
constexpr double kHumAtMost = 0.1;  // of the swing

}  // namespace

CycleDecoder::CycleDecoder(const LineInFormat& format, SampleRate rate, const LineInParameters& parameters,
                           double memory_cycles, FindingLog& log)
    : format_(format),
      rate_(rate),
      parameters_(parameters),
      meter_(format, parameters.settle_fraction),
      coupling_(memory_cycles),
      hum_(rate),
      counter_hum_(rate),
      monitor_(format, rate, log) {}

void CycleDecoder::start(const LineJudgement& judgement, std::int64_t judged_until) {
  coupling_ = judgement.coupling;
  noise_ = judgement.noise;
  clicks_ = ClickGuard(noise_);
  swing_ = SwingTracker(judgement.swing, judgement.right_inverted);
  reference_ = ReferenceFilter();
  hum_ = HumTracker(rate_);
  counter_hum_ = HumTracker(rate_);
  first_swing_ = judgement.swing;
  cycles_ = 0;
  meter_.unlink();
  left_inverted_ = judgement.left_inverted;
  judged_until_ = static_cast<double>(judged_until);
}

void CycleDecoder::unlink() {
  meter_.unlink();
  hum_.unlink();
  counter_hum_.unlink();
  reference_.restart();
  coupling_.unlink();
}

DecayRegression::Estimate CycleDecoder::data_coupling() const {
  DecayRegression::Estimate estimate = coupling_.data();
  if (parameters_.coupling_hz) {
    estimate.kappa = 2.0 * std::tan(kPi * *parameters_.coupling_hz / rate_.hz);
    estimate.sd = 0.0;
  }
  return estimate;
}

// The counter's halves are slots of a channel whose reference is its high half; its height should not move either.
void CycleDecoder::still_counter(CycleMeasurement& measured, double kappa) {
  CycleMeasurement halves;
  halves.bounds = measured.bounds;
  halves.linked = measured.linked;
  halves.slots[0] = measured.low;
  halves.slots[1] = measured.high;
  counter_hum_.step(halves, 2, kappa, !measured.counter_clipped);
  measured.low.mean = halves.slots[0].mean;
  measured.high.mean = halves.slots[1].mean;
}

void CycleDecoder::decode(const CycleBounds& bounds, const ChannelView& data, const ChannelView& counter,
                          LineInCycle& out) {
  const int slots = format_.slots;
  const auto last = static_cast<std::size_t>(slots - 1);
  CycleMeasurement measured = meter_.measure(bounds, data, counter);
  const DecayRegression::Estimate counter_coupling = coupling_.counter();
  still_counter(measured, counter_coupling.kappa);
  SwingTracker::Reading gain = swing_.step(measured, counter_coupling);
  // The reference does not move: when it seems to, the gain or a plug did.
  const double restless = std::sqrt(measured.slots[last].variance);
  gain.usable = gain.usable && restless < std::max(6.0 * noise_, kRestless * gain.swing);
  if (!gain.usable || !was_usable_) {
    reference_.restart();  // levels before and after a change of gain are not comparable
    coupling_.unlink();
  }
  const std::uint32_t clicks = clicks_.step(measured, slots, gain.swing);
  measured.broken = measured.clipped | clicks;
  const DecayRegression::Estimate estimate = data_coupling();
  hum_.step(measured, slots, estimate.kappa, gain.usable);
  const auto line = reference_.step(measured, slots, estimate, noise_, kRestless * gain.swing);
  gain.usable = gain.usable && !line.jumped;
  const auto levels = relative_levels(measured, line, estimate.kappa, slots);
  if (bounds.start >= judged_until_ && gain.usable && !gain.moved) {
    coupling_.add(measured, levels, slots);
  }

  const double scale = (left_inverted_ ? -1.0 : 1.0) * format_.supply_volts / std::max(gain.swing, 1e-12);
  double variance = 0.0;
  for (std::size_t j = 0; j <= last; ++j) {
    out.sample[j] = measured.slots[j].centre;
    out.volts[j] = scale * levels[j];
    variance += measured.slots[j].variance / slots;
  }
  const std::uint32_t reference_bit = std::uint32_t{1} << last;
  // Every value is relative to the reference: without it there is none.
  out.clipped = (measured.clipped & reference_bit) != 0 ? (reference_bit << 1U) - 1U : measured.clipped;
  out.uncertain = (line.uncertain | clicks) & ~out.clipped;
  out.valid = gain.usable;
  if (out.valid && measured.broken == 0) {
    noise_ = std::sqrt(noise_ * noise_ + (variance - noise_ * noise_) / 30.0);
  }
  clipped_slots_ += std::popcount(out.clipped);
  was_usable_ = gain.usable;

  SwingTracker::Reading told = gain;
  if (cycles_ < kHumIsFound && std::fabs(gain.swing / first_swing_ - 1.0) < kHumAtMost) {
    told.moved = false;
    told.usable = true;
  }
  ++cycles_;
  monitor_.step(out, measured.counter_clipped, told);
  if (out.valid) {
    monitor_.watch_clicks(out, clicks);
  }
  if (!parameters_.coupling_hz) {
    monitor_.watch_hum(out, hum_, reference_.unrest(), noise_ * std::sqrt(measured.data_noise_gain), gain.swing);
  }
}

void CycleDecoder::tell(LineInStatus& status) const {
  const auto corner = [&](double kappa) { return rate_.hz / kPi * std::atan(0.5 * kappa); };
  const DecayRegression::Estimate estimate = data_coupling();
  status.right_swing = swing_.swing();
  status.left_coupling_hz = corner(estimate.kappa);
  status.right_coupling_hz = corner(std::max(0.0, coupling_.counter().kappa));
  status.coupling_sd_hz = corner(estimate.sd);
  status.noise = noise_;
  status.clipped_slots = clipped_slots_;
}

}  // namespace limbwave::decode
