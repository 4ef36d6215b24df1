#include "plots/take_overview.h"

#include <span>
#include <utility>
#include <vector>

#include "take/take_reader.h"

namespace limbwave::ui {

Result<std::shared_ptr<const TakeOverview>> load_overview(const take::Take& take, const Progress& progress) {
  Result<take::TakeReader> reader = take::TakeReader::open(take);
  if (!reader) {
    return reader.error();
  }
  auto overview = std::make_shared<TakeOverview>();
  if (take.info.kind == "driver-box") {
    Result<BoxHistory> box = BoxHistory::of_take(take, progress);
    if (!box) {
      return box.error();
    }
    overview->box = std::move(box).value();
    overview->rate_hz = reader->format().rate.hz;
    overview->frames = reader->frames();
    return std::shared_ptr<const TakeOverview>(overview);
  }
  const auto channels = static_cast<std::size_t>(reader->format().channels);
  overview->rate_hz = reader->format().rate.hz;
  const std::int64_t total = reader->frames();
  constexpr std::size_t kBlock = 1 << 15;
  std::vector<float> block(kBlock * channels);
  while (true) {
    const Result<std::size_t> frames = reader->next(block);
    if (!frames) {
      return frames.error();
    }
    if (*frames == 0) {
      break;
    }
    const std::span<const float> samples(block.data(), *frames * channels);
    overview->left.append(samples, channels);
    overview->right.append(samples.subspan(channels > 1 ? 1 : 0), channels);
    overview->frames += static_cast<std::int64_t>(*frames);
    if (!progress.report(total > 0 ? static_cast<double>(overview->frames) / static_cast<double>(total) : 0.0)) {
      return cancelled();
    }
  }
  return std::shared_ptr<const TakeOverview>(overview);
}

}  // namespace limbwave::ui
