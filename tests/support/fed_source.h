/// A live source that gives what a test feeds it, and that can lose samples and die as devices do.
#pragma once

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "acquire/live_source.h"

namespace limbwave::test {

class FedSource : public acquire::LiveSource {
 public:
  /// `block_frames`: as many at most are given at once; 0: as many as fit.
  explicit FedSource(const acquire::StreamFormat& format, std::size_t block_frames = 0)
      : format_(format), block_frames_(block_frames) {}

  /// Makes these frames available, at once.
  void feed(std::span<const std::byte> bytes) {
    const std::scoped_lock lock(mutex_);
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    fed_ += static_cast<std::int64_t>(bytes.size() / format_.bytes_per_frame());
  }
  /// Frames are missing behind what was fed so far.
  void lose(std::uint64_t frames) {
    const std::scoped_lock lock(mutex_);
    ++counters_.overflows;
    counters_.dropped_frames += frames;
    counters_.lost_at = fed_;
  }
  void die() {
    const std::scoped_lock lock(mutex_);
    dead_ = true;
  }

  [[nodiscard]] acquire::StreamFormat format() const override { return format_; }
  [[nodiscard]] std::string title() const override { return "fed"; }
  Status start() override {
    const std::scoped_lock lock(mutex_);
    running_ = true;
    return {};
  }
  void stop() override {
    const std::scoped_lock lock(mutex_);
    running_ = false;
  }
  std::size_t pull(std::span<std::byte> out) override {
    const std::scoped_lock lock(mutex_);
    const std::size_t frame = format_.bytes_per_frame();
    const std::size_t most = block_frames_ > 0 ? std::min(block_frames_ * frame, out.size()) : out.size();
    const std::size_t count = std::min(waiting_.size() - pulled_, most / frame * frame);
    std::copy_n(waiting_.begin() + static_cast<std::ptrdiff_t>(pulled_), count, out.begin());
    pulled_ += count;
    return count;
  }
  void wait(double timeout_s) override {
    if (const std::scoped_lock lock(mutex_); pulled_ < waiting_.size()) {
      return;
    }
    acquire::LiveSource::wait(timeout_s);
  }
  [[nodiscard]] acquire::SourceCounters counters() const override {
    const std::scoped_lock lock(mutex_);
    return counters_;
  }
  /// Like a sound card's: what is not running has not died.
  [[nodiscard]] bool alive() const override {
    const std::scoped_lock lock(mutex_);
    return !running_ || !dead_;
  }
  [[nodiscard]] double device_latency_s() const override { return 0.0; }
  [[nodiscard]] double newest_frame_time_s() const override { return 0.0; }

 private:
  acquire::StreamFormat format_;
  std::size_t block_frames_;
  mutable std::mutex mutex_;
  std::vector<std::byte> waiting_;
  std::size_t pulled_ = 0;
  std::int64_t fed_ = 0;
  acquire::SourceCounters counters_;
  bool running_ = false, dead_ = false;
};

}  // namespace limbwave::test
