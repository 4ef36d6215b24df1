#include "acquire/channel_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace limbwave::acquire {
namespace {

constexpr std::size_t kBlockFrames = 4096;

class ChannelPair : public LiveSource {
 public:
  ChannelPair(std::unique_ptr<LiveSource> source, int left, int right)
      : source_(std::move(source)), inner_(source_->format()), sample_(bytes_per_sample(inner_.type)) {
    left_ = static_cast<std::size_t>(left) * sample_;
    right_ = static_cast<std::size_t>(right) * sample_;
    block_.resize(kBlockFrames * inner_.bytes_per_frame());
  }

  [[nodiscard]] StreamFormat format() const override { return {inner_.rate, 2, inner_.type}; }
  [[nodiscard]] std::string title() const override { return source_->title(); }
  Status start() override { return source_->start(); }
  void stop() override { source_->stop(); }
  std::size_t pull(std::span<std::byte> out) override;
  void wait(double timeout_s) override { source_->wait(timeout_s); }
  [[nodiscard]] SourceCounters counters() const override { return source_->counters(); }
  [[nodiscard]] bool alive() const override { return source_->alive(); }
  [[nodiscard]] double device_latency_s() const override { return source_->device_latency_s(); }
  [[nodiscard]] double newest_frame_time_s() const override { return source_->newest_frame_time_s(); }

 private:
  std::unique_ptr<LiveSource> source_;
  StreamFormat inner_;
  std::size_t sample_, left_ = 0, right_ = 0;
  std::vector<std::byte> block_;
};

std::size_t ChannelPair::pull(std::span<std::byte> out) {
  const std::size_t frame = inner_.bytes_per_frame();
  std::size_t done = 0;
  while (out.size() - done >= 2 * sample_) {
    const std::size_t wanted = std::min(kBlockFrames, (out.size() - done) / (2 * sample_));
    const std::size_t got = source_->pull(std::span(block_).first(wanted * frame)) / frame;
    for (std::size_t i = 0; i < got; ++i) {
      std::memcpy(out.data() + done, block_.data() + i * frame + left_, sample_);
      std::memcpy(out.data() + done + sample_, block_.data() + i * frame + right_, sample_);
      done += 2 * sample_;
    }
    if (got < wanted) {
      break;
    }
  }
  return done;
}

}  // namespace

Result<std::unique_ptr<LiveSource>> pick_channels(std::unique_ptr<LiveSource> source, int left, int right) {
  const int channels = source->format().channels;
  if (std::min(left, right) < 0 || std::max(left, right) >= channels) {
    return Error{fmt::format("has no inputs {} and {}, only {}", left + 1, right + 1, channels), source->title(),
                 "choose other inputs"};
  }
  if (channels == 2 && left == 0 && right == 1) {
    return source;
  }
  return std::unique_ptr<LiveSource>(std::make_unique<ChannelPair>(std::move(source), left, right));
}

}  // namespace limbwave::acquire
