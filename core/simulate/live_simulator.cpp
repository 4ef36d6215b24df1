#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/spsc_ring.h"
#include "base/wake_signal.h"
#include "simulate/simulate.h"
#include "simulate/simulation.h"

namespace limbwave::simulate {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBlockSeconds = 0.010;  // like a sound card's period
constexpr double kRingSeconds = 4.0;

double now_s() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

class LiveSimulator : public acquire::LiveSource {
 public:
  LiveSimulator(std::unique_ptr<Simulation> simulation, const SimulateSettings& settings)
      : simulation_(std::move(simulation)),
        format_(settings.format),
        title_("Simulator: " + settings.motion),
        ring_(static_cast<std::size_t>(kRingSeconds * format_.rate.hz) * format_.bytes_per_frame()) {}
  ~LiveSimulator() override { LiveSimulator::stop(); }
  LiveSimulator(const LiveSimulator&) = delete;
  LiveSimulator& operator=(const LiveSimulator&) = delete;

  [[nodiscard]] acquire::StreamFormat format() const override { return format_; }
  [[nodiscard]] std::string title() const override { return title_; }

  Status start() override {
    if (thread_.joinable()) {
      return {};
    }
    stopping_ = false;
    try {
      thread_ = std::thread([this] { run(); });
    } catch (const std::system_error& error) {
      return Error{std::string("cannot start its thread: ") + error.what(), title_, "close other programs"};
    }
    return {};
  }

  void stop() override {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  std::size_t pull(std::span<std::byte> out) override {
    const std::size_t frame = format_.bytes_per_frame();
    // The ring holds whole frames only, so that a whole number of them is read.
    return ring_.read(out.first(out.size() / frame * frame));
  }

  void wait(double timeout_s) override { (void)arrived_.wait_for(std::chrono::duration<double>(timeout_s)); }
  [[nodiscard]] acquire::SourceCounters counters() const override {
    acquire::SourceCounters counters;
    counters.overflows = overflows_.load(std::memory_order_acquire);
    counters.dropped_frames = dropped_.load(std::memory_order_acquire);
    counters.lost_at = lost_at_.load(std::memory_order_relaxed);
    return counters;
  }
  [[nodiscard]] bool alive() const override { return true; }
  [[nodiscard]] double device_latency_s() const override { return kBlockSeconds; }
  [[nodiscard]] double newest_frame_time_s() const override { return newest_.load(std::memory_order_acquire); }
  void ask(const std::string& what) override {
    const std::lock_guard lock(asked_mutex_);
    asked_ = what;
  }

 private:
  // The wearer hears what is asked between two blocks.
  void listen() {
    if (simulation_->obliging) {
      const std::lock_guard lock(asked_mutex_);
      const LineInStream& stream = *simulation_->stream;
      simulation_->obliging->ask(asked_, stream.real_time(static_cast<double>(stream.position())));
    }
  }
  void run() {
    const auto block_frames = static_cast<std::size_t>(std::ceil(kBlockSeconds * format_.rate.hz));
    std::vector<std::byte> block(block_frames * format_.bytes_per_frame());
    const double begin = now_s();
    double made = 0.0;         // frames, since the start
    std::int64_t written = 0;  // of them into the ring
    std::unique_lock lock(mutex_);
    while (!stopping_) {
      lock.unlock();
      listen();
      simulation_->stream->read(block);
      simulation_->stream->take_cycle_starts();
      made += static_cast<double>(block_frames);
      // A block exists once its last frame would have been sampled.
      const double due = begin + made / format_.rate.hz;
      lock.lock();
      if (wake_.wait_for(lock, std::chrono::duration<double>(due - now_s()), [this] { return stopping_; })) {
        break;  // this block has not been sampled yet
      }
      newest_.store(due, std::memory_order_release);
      if (ring_.write(std::span<const std::byte>(block))) {
        written += static_cast<std::int64_t>(block_frames);
        arrived_.notify();
      } else {
        lost_at_.store(written, std::memory_order_relaxed);
        dropped_.fetch_add(block_frames, std::memory_order_release);
        overflows_.fetch_add(1, std::memory_order_release);
      }
    }
  }

  std::unique_ptr<Simulation> simulation_;
  acquire::StreamFormat format_;
  std::string title_;
  SpscRing<std::byte> ring_;
  std::thread thread_;
  std::mutex mutex_;  // of stopping_ alone: the consumer never takes it
  std::condition_variable wake_;
  bool stopping_ = false;
  std::mutex asked_mutex_;
  std::string asked_;
  std::atomic<std::uint64_t> overflows_{0}, dropped_{0};
  std::atomic<std::int64_t> lost_at_{0};
  std::atomic<double> newest_{0.0};
  WakeSignal arrived_;
};

}  // namespace

Result<std::unique_ptr<acquire::LiveSource>> open_simulator(const SimulateSettings& settings) {
  auto simulation = make_simulation(settings);
  if (!simulation) {
    return simulation.error();
  }
  return std::unique_ptr<acquire::LiveSource>(std::make_unique<LiveSimulator>(*std::move(simulation), settings));
}

}  // namespace limbwave::simulate
