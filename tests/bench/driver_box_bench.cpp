// Throughput of a driver box's decoders and simulator, and of the band-pass kernel beside liquid-dsp's on the same
// taps.
#include <benchmark/benchmark.h>
#include <liquid/liquid.h>

#include <random>
#include <vector>

#include "decode/driver_box_decoder.h"
#include "signal/fir_design.h"
#include "simulate/driver_box_stream.h"
#include "solve/driver_box.h"

namespace {

using namespace limbwave;

constexpr double kRate = 140000.0;
constexpr std::size_t kTaps = 129;
constexpr std::size_t kSamples = 140000;

std::vector<float> noise() {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<float> samples(kSamples);
  for (float& sample : samples) {
    sample = normal(random);
  }
  return samples;
}

std::vector<float> taps() {
  const std::vector<double> h = signal::band_pass(kTaps, 40000.0 / kRate, 2500.0 / kRate, 60.0);
  return {h.begin(), h.end()};
}

void band_pass_ours(benchmark::State& state) {
  const std::vector<float> samples = noise();
  std::vector<float> out(kSamples);
  const std::vector<float> h = taps();
  signal::SymmetricFir filter(h);
  for (auto _ : state) {
    filter.run(samples.data(), kSamples - kTaps + 1, out.data());
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * (kSamples - kTaps + 1)));
}
BENCHMARK(band_pass_ours);

void band_pass_liquid(benchmark::State& state) {
  std::vector<float> samples = noise();
  std::vector<float> out(kSamples);
  std::vector<float> h = taps();
  firfilt_rrrf filter = firfilt_rrrf_create(h.data(), static_cast<unsigned>(h.size()));
  for (auto _ : state) {
    firfilt_rrrf_execute_block(filter, samples.data(), static_cast<unsigned>(kSamples - kTaps + 1), out.data());
    benchmark::DoNotOptimize(out.data());
  }
  firfilt_rrrf_destroy(filter);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * (kSamples - kTaps + 1)));
}
BENCHMARK(band_pass_liquid);

struct Box {
  decode::DriverBoxFormat format;
  std::vector<float> samples;
};

const Box& box() {
  static const Box made = [] {
    const auto rig = body::load_rig("driver-box-body");
    const auto skeleton = body::load_skeleton(rig->skeleton);
    const auto errors = simulate::load_driver_box_errors("paper");
    const auto actor = simulate::DriverBoxActor::create("walk", 0.0, *rig, *skeleton, *errors, 1);
    simulate::DriverBoxStream stream(*rig, *actor, *errors, 22.0, 1);
    Box b;
    std::vector<std::int16_t> slot(static_cast<std::size_t>(stream.slot_samples() * stream.wires()));
    while (stream.position() < 5 * static_cast<std::int64_t>(kRate)) {
      stream.next_slot(slot);
      for (const std::int16_t sample : slot) {
        b.samples.push_back(static_cast<float>(sample) / 32768.0F);
      }
    }
    b.format = solve::driver_box_format(*rig, *skeleton, simulate::simulated_calibration(*rig, stream, *errors, 1));
    return b;
  }();
  return made;
}

// Counter "real_time": seconds of signal per second of wall clock.
void decode_everything(benchmark::State& state) {
  const Box& b = box();
  decode::DriverBoxParameters parameters;
  parameters.threads = static_cast<int>(state.range(0));
  double seconds = 0.0;
  for (auto _ : state) {
    decode::DriverBoxDecoder decoder(b.format, parameters);
    constexpr std::size_t kBlock = 28000 * 18;
    for (std::size_t i = 0; i < b.samples.size(); i += kBlock) {
      decoder.push(std::span(b.samples).subspan(i, std::min(kBlock, b.samples.size() - i)));
      benchmark::DoNotOptimize(decoder.take_ranges());
      benchmark::DoNotOptimize(decoder.take_inertial());
    }
    seconds += static_cast<double>(b.samples.size()) / 18.0 / kRate;
  }
  state.counters["real_time"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}
BENCHMARK(decode_everything)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void simulate_everything(benchmark::State& state) {
  const auto rig = body::load_rig("driver-box-body");
  const auto skeleton = body::load_skeleton(rig->skeleton);
  const auto errors = simulate::load_driver_box_errors("paper");
  const auto actor = simulate::DriverBoxActor::create("walk", 0.0, *rig, *skeleton, *errors, 1);
  simulate::DriverBoxStream stream(*rig, *actor, *errors, 22.0, 1);
  std::vector<std::int16_t> slot(static_cast<std::size_t>(stream.slot_samples() * stream.wires()));
  double seconds = 0.0;
  for (auto _ : state) {
    stream.next_slot(slot);
    (void)stream.take_pulses();
    seconds += 1120.0 / kRate;
  }
  state.counters["real_time"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}
BENCHMARK(simulate_everything)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
