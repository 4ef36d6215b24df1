// How fast BVH is read: the whole reader, against merely turning the same text into numbers with strtod, in one run.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/random_clip.h"

namespace {

// Thirty seconds of a whole body at 120 Hz, as our writer and as CMU's converters format numbers.
const std::string& sample_text() {
  static const std::string text = *limbwave::interchange::bvh_text(limbwave::test::random_clip(31, 3600, 120.0, 51));
  return text;
}

void BM_StrtodPerNumber(benchmark::State& state) {
  const std::string& text = sample_text();
  const std::size_t data = text.find('\n', text.find("Frame Time")) + 1;
  for (auto _ : state) {
    double sum = 0.0;
    const char* p = text.c_str() + data;
    char* end = nullptr;
    for (double value = std::strtod(p, &end); end != p; value = std::strtod(p, &end)) {
      sum += value;
      p = end;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text.size() - data));
}
BENCHMARK(BM_StrtodPerNumber)->Unit(benchmark::kMillisecond);

void BM_ReadBvh(benchmark::State& state) {
  const std::string& text = sample_text();
  for (auto _ : state) {
    const auto clip = limbwave::interchange::read_bvh(text, "bench");
    if (!clip) {
      state.SkipWithError(clip.error().text().c_str());
      break;
    }
    benchmark::DoNotOptimize(clip->duration());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(BM_ReadBvh)->Unit(benchmark::kMillisecond);

void BM_WriteBvh(benchmark::State& state) {
  const auto clip = limbwave::test::random_clip(31, 3600, 120.0, 51);
  std::size_t bytes = 0;
  for (auto _ : state) {
    const auto text = limbwave::interchange::bvh_text(clip);
    bytes += text->size();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}
BENCHMARK(BM_WriteBvh)->Unit(benchmark::kMillisecond);

}  // namespace
