#include "solve/decoded_take.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "solve/front_end.h"
#include "take/take_reader.h"

namespace limbwave::solve {
namespace {

constexpr std::size_t kBlockFrames = 65536;

// Why there is nothing to solve: the decoder's own words where it has some.
Error no_signal(const take::Take& take, const Diagnostics& diagnostics) {
  const auto found = std::max_element(diagnostics.begin(), diagnostics.end(),
                                      [](const auto& a, const auto& b) { return a.severity < b.severity; });
  const std::string place = take.folder.string();
  if (found == diagnostics.end()) {
    return {"is too short to find the multiplexer's clock in it", place, "record at least a second"};
  }
  return {found->message, place, found->remedy};
}

}  // namespace

std::span<const decode::AccelerationFrame> DecodedTake::between(double begin_s, double end_s) const {
  const auto earlier = [](const decode::AccelerationFrame& frame, double time) { return frame.time_s < time; };
  const auto first = std::lower_bound(frames.begin(), frames.end(), begin_s, earlier);
  const auto last = std::lower_bound(first, frames.end(), end_s, earlier);
  return {first, last};
}

std::span<const decode::AccelerationFrame> DecodedTake::of(const take::Take& take,
                                                           const take::TakeSegment& segment) const {
  const SampleRate rate = take.info.format.rate;
  return between(rate.seconds(segment.first).value, rate.seconds(segment.first + segment.count).value);
}

Result<DecodedTake> decode_take(const take::Take& take, const decode::LineInParameters& parameters,
                                const Progress& progress) {
  if (take.info.format.channels != 2) {
    return Error{fmt::format("has {} channels, but the line-in path needs two", take.info.format.channels),
                 take.folder.string(), "record in stereo"};
  }
  if (const Status status = check_rate(take.info.rig.line_in, take.info.format.rate); !status) {
    return Error{status.error().message, take.folder.string(), status.error().remedy};
  }
  Result<take::TakeReader> reader = take::TakeReader::open(take);
  if (!reader) {
    return reader.error();
  }
  const auto start = std::chrono::steady_clock::now();
  FrontEnd front(take.info.rig, take.info.format.rate, parameters);
  DecodedTake decoded;
  const auto collect = [&] {
    const std::vector<decode::AccelerationFrame> fresh = front.take_frames();
    decoded.frames.insert(decoded.frames.end(), fresh.begin(), fresh.end());
    const Diagnostics found = front.take_diagnostics();
    decoded.diagnostics.insert(decoded.diagnostics.end(), found.begin(), found.end());
  };
  std::vector<float> block(2 * kBlockFrames);
  const double total = std::max<double>(1.0, static_cast<double>(reader->frames()));
  while (true) {
    if (!progress.report(static_cast<double>(reader->position().value) / total, "decoding")) {
      return cancelled();
    }
    const Result<std::size_t> count = reader->next(block);
    if (!count) {
      return count.error();
    }
    if (*count == 0) {
      break;
    }
    front.push(std::span(block).first(2 * *count));
    collect();
  }
  front.finish();
  collect();
  decoded.line = front.status();
  decoded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (decoded.frames.empty()) {
    return no_signal(take, decoded.diagnostics);
  }
  return decoded;
}

}  // namespace limbwave::solve
