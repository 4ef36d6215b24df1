// How long decoding a recording takes, beside merely reading it: three minutes of 16 bit stereo at 48 kHz.
// The bar is a ratio of five, both from one run.
#include <benchmark/benchmark.h>
#include <sndfile.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "decode/line_in.h"
#include "decode/slot_alignment.h"
#include "support/line_in_signal.h"

namespace limbwave {
namespace {

constexpr int kRate = 48000;
constexpr std::size_t kBlock = 4096;
const double kMinutes = 3.0;

struct CloseSound {
  void operator()(SNDFILE* file) const { sf_close(file); }
};
using Sound = std::unique_ptr<SNDFILE, CloseSound>;

/// A recording of the board with moving sensors, written once.
const std::filesystem::path& recording() {
  static const std::filesystem::path path = [] {
    test::LineInSignalSpec spec = test::paper_electronics(kRate, 5.0);
    spec.overshoot = 0.0;
    spec.anti_alias = false;  // takes long to make and does not matter here
    spec.seconds = 60.0 * kMinutes;
    spec.volts = [](int axis, double t) { return 1.65 + 0.3 * std::sin(0.7 * axis + 3.0 * t); };
    const auto signal = test::make_line_in_signal(spec);
    std::filesystem::path file = std::filesystem::temp_directory_path() / "limbwave_decode_bench.wav";
    SF_INFO info{};
    info.samplerate = kRate;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    const Sound sound(sf_open(file.c_str(), SFM_WRITE, &info));
    sf_write_float(sound.get(), signal.interleaved.data(), static_cast<sf_count_t>(signal.interleaved.size()));
    return file;
  }();
  return path;
}

/// Reads everything, block by block, and gives each block to `use`.
template <typename Use>
void read_all(const Use& use) {
  SF_INFO info{};
  const Sound sound(sf_open(recording().c_str(), SFM_READ, &info));
  std::vector<float> block(2 * kBlock);
  for (;;) {
    const sf_count_t frames = sf_readf_float(sound.get(), block.data(), kBlock);
    if (frames <= 0) {
      return;
    }
    use(std::span<const float>(block).first(2 * static_cast<std::size_t>(frames)));
  }
}

void read_wav(benchmark::State& state) {
  recording();
  for (auto _ : state) {
    double sum = 0.0;
    read_all([&](std::span<const float> block) { sum += block[0]; });
    benchmark::DoNotOptimize(sum);
  }
  state.counters["x_real_time"] = benchmark::Counter(60.0 * kMinutes, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(read_wav)->Unit(benchmark::kMillisecond)->MinTime(1.0);

void decode_wav(benchmark::State& state) {
  recording();
  for (auto _ : state) {
    decode::LineInDecoder decoder(decode::LineInFormat{}, SampleRate{kRate});
    decode::SlotAligner aligner(5, SampleRate{kRate});
    std::size_t frames = 0;
    const auto collect = [&] {
      for (const decode::LineInCycle& cycle : decoder.take_cycles()) {
        aligner.push(cycle);
      }
      frames += aligner.take_frames().size();
    };
    read_all([&](std::span<const float> block) {
      decoder.push(block);
      collect();
    });
    decoder.finish();
    collect();
    if (frames < 10000) {
      state.SkipWithError("the recording was not decoded");
    }
  }
  state.counters["x_real_time"] = benchmark::Counter(60.0 * kMinutes, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(decode_wav)->Unit(benchmark::kMillisecond)->MinTime(1.0);

}  // namespace
}  // namespace limbwave

BENCHMARK_MAIN();
