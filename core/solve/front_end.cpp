#include "solve/front_end.h"

#include <fmt/format.h>

#include <iterator>

namespace limbwave::solve {

decode::LineInFormat line_in_format(const body::LineInSignal& signal) {
  decode::LineInFormat format;
  format.cycle_rate_hz = signal.cycle_rate_hz;
  format.cycle_rate_tolerance = signal.cycle_rate_tolerance;
  format.slots = signal.slots;
  format.supply_volts = signal.supply_volts;
  format.reference_volts = signal.reference_volts;
  format.zero_g_volts = signal.zero_g_volts;
  format.volts_per_g = signal.volts_per_g;
  return format;
}

Status check_rate(const body::LineInSignal& signal, SampleRate rate) {
  constexpr double kLeastSamples = 4.0;  // one that settles, two to average, one that rings before the next slot
  const double slots_hz = signal.cycle_rate_hz * (1.0 + signal.cycle_rate_tolerance) * signal.slots;
  const double samples = rate.hz / slots_hz;
  if (samples < kLeastSamples) {
    return Error{
        fmt::format("a slot of the board lasts only {:.1f} samples at {:.0f} samples a second", samples, rate.hz), "",
        fmt::format("record at {:.0f} at least, or correct the rig's cycle rate", kLeastSamples * slots_hz)};
  }
  return {};
}

bool saturated(const body::LineInSignal& signal, const Eigen::Vector3d& volts) {
  constexpr double kNear = 0.985;  // noise must not hide it
  const double zero = signal.zero_g_volts - signal.reference_volts;
  return ((volts.array() - zero).abs() > kNear * signal.volts_per_g * signal.range_g).any();
}

FrontEnd::FrontEnd(const body::Rig& rig, SampleRate rate, const decode::LineInParameters& parameters)
    : decoder_(line_in_format(rig.line_in), rate, parameters), aligner_(line_in_format(rig.line_in).sensors(), rate) {}

void FrontEnd::push(std::span<const float> interleaved) {
  decoder_.push(interleaved);
  align();
}

void FrontEnd::finish() {
  decoder_.finish();
  align();
  aligner_.finish();
}

void FrontEnd::align() {
  std::vector<decode::LineInCycle> cycles = decoder_.take_cycles();
  for (const decode::LineInCycle& cycle : cycles) {
    aligner_.push(cycle);
  }
  if (keep_cycles_) {
    cycles_.insert(cycles_.end(), std::make_move_iterator(cycles.begin()), std::make_move_iterator(cycles.end()));
  }
}

std::vector<decode::AccelerationFrame> FrontEnd::take_frames() {
  return aligner_.take_frames();
}

std::vector<decode::LineInCycle> FrontEnd::take_cycles() {
  return std::exchange(cycles_, {});
}

}  // namespace limbwave::solve
