/// Helpers of the simulator's tests: a board with known voltages, and its samples as numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "acquire/sample_format.h"
#include "simulate/electronics.h"

namespace limbwave::simulate {

/// Voltages given by a function of slot (3 · sensor + axis) and time.
class GivenVoltages : public SlotVoltages {
 public:
  explicit GivenVoltages(std::function<double(int, double)> volts) : volts_(std::move(volts)) {}
  void begin_slot() override {}
  double volts(int sensor, int axis, double time_s) override { return volts_(3 * sensor + axis, time_s); }

 private:
  std::function<double(int, double)> volts_;
};

struct Stereo {
  std::vector<double> left, right;
  std::vector<double> cycle_starts;  // seconds
  std::vector<std::byte> bytes;
};

/// The first `frames` frames of a line, read in blocks of `block` frames.
inline Stereo record(const LineInErrors& errors, SlotVoltages& voltages, std::size_t frames,
                     acquire::StreamFormat format = {SampleRate{48000.0}, 2, acquire::SampleType::kFloat32},
                     std::uint64_t seed = 1, std::size_t block = 1000) {
  LineInStream stream(body::LineInSignal{}, errors, format, seed, voltages);
  Stereo signal;
  signal.bytes.resize(frames * format.bytes_per_frame());
  for (std::size_t at = 0; at < frames; at += block) {
    const std::size_t count = std::min(block, frames - at);
    stream.read(std::span(signal.bytes).subspan(at * format.bytes_per_frame(), count * format.bytes_per_frame()));
    const std::vector<double> starts = stream.take_cycle_starts();
    signal.cycle_starts.insert(signal.cycle_starts.end(), starts.begin(), starts.end());
  }
  std::vector<float> samples(2 * frames);
  acquire::to_float(format.type, signal.bytes, samples);
  for (std::size_t i = 0; i < frames; ++i) {
    signal.left.push_back(samples[2 * i]);
    signal.right.push_back(samples[2 * i + 1]);
  }
  return signal;
}

}  // namespace limbwave::simulate
