/// A live session with a signal to feed it, recording into a folder of the test.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "solve/live_session.h"
#include "support/fed_source.h"
#include "support/simulated_take.h"
#include "take/take_reader.h"

namespace limbwave::solve {

using testing_support::require;

class LiveRecording : public testing::Test {
 protected:
  // A signal to feed, as a take of its own and as bytes.
  void simulate(const simulate::LineInErrors& errors, double seconds, std::size_t block_frames = 0,
                const SolveSettings& solve = {}) {
    simulate::SimulateSettings settings;
    settings.motion = "box";
    settings.errors = errors;
    settings.seconds = seconds;
    settings.prologue = false;
    signal = testing_support::simulated(folder / "signal.take", settings);
    take::TakeReader reader = require(take::TakeReader::open(signal));
    bytes.resize(static_cast<std::size_t>(signal.info.frames) * signal.info.format.bytes_per_frame());
    ASSERT_EQ(require(reader.read_raw(SampleIndex{0}, bytes)), static_cast<std::size_t>(signal.info.frames));
    open(block_frames, solve);
  }
  void open(std::size_t block_frames, const SolveSettings& solve) {
    auto feeding = std::make_unique<test::FedSource>(signal.info.format, block_frames);
    source = feeding.get();
    fed = 0;
    LiveSettings live{signal.info.rig, signal.info.skeleton, calibrate::nominal_calibration(signal.info.rig), solve};
    session = std::make_unique<LiveSession>(std::move(feeding), live);
    require(session->start());
  }

  [[nodiscard]] std::int64_t frame_at(double seconds) const {
    return std::min(signal.info.format.rate.index(Seconds{seconds}).value, signal.info.frames);
  }
  [[nodiscard]] std::span<const std::byte> part(double from_s, double to_s) const {
    const std::size_t frame = signal.info.format.bytes_per_frame();
    const auto from = static_cast<std::size_t>(frame_at(from_s)) * frame;
    const auto to = static_cast<std::size_t>(frame_at(to_s)) * frame;
    return std::span(bytes).subspan(from, to - from);
  }
  template <typename Condition>
  void wait_for(const Condition& condition) const {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (!condition(*session->snapshot())) {
      if (std::chrono::steady_clock::now() > until) {
        throw std::runtime_error("the session did not get there");
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  void feed(double from_s, double to_s) {
    source->feed(part(from_s, to_s));
    fed += frame_at(to_s) - frame_at(from_s);
    const double fed_s = signal.info.format.rate.seconds(SampleIndex{fed}).value;
    wait_for([&](const LiveSnapshot& now) { return now.stream_time_s >= fed_s - 1e-9; });
  }
  [[nodiscard]] std::vector<take::TakeEvent> events(const take::Take& take, const std::string& kind) const {
    std::vector<take::TakeEvent> found;
    std::copy_if(take.events.begin(), take.events.end(), std::back_inserter(found),
                 [&](const take::TakeEvent& event) { return event.kind == kind; });
    return found;
  }

  test::TemporaryFolder folder;
  take::Take signal;
  std::vector<std::byte> bytes;
  test::FedSource* source = nullptr;
  std::unique_ptr<LiveSession> session;
  std::int64_t fed = 0;
};

}  // namespace limbwave::solve
