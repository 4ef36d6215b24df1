/// Recording out of a running session: what gets into the take, whatever happens meanwhile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "base/units.h"
#include "solve/decoded_take.h"
#include "solve/live_session.h"
#include "support/fed_source.h"
#include "support/simulated_take.h"
#include "take/take_reader.h"

namespace limbwave::solve {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing_support::require;

class LiveRecording : public testing::Test {
 protected:
  // A signal to feed, as a take of its own and as bytes.
  void simulate(const simulate::LineInErrors& errors, double seconds) {
    simulate::SimulateSettings settings;
    settings.motion = "box";
    settings.errors = errors;
    settings.seconds = seconds;
    settings.prologue = false;
    signal = testing_support::simulated(folder / "signal.take", settings);
    take::TakeReader reader = require(take::TakeReader::open(signal));
    bytes.resize(static_cast<std::size_t>(signal.info.frames) * signal.info.format.bytes_per_frame());
    ASSERT_EQ(require(reader.read_raw(SampleIndex{0}, bytes)), static_cast<std::size_t>(signal.info.frames));
    auto fed = std::make_unique<test::FedSource>(signal.info.format);
    source = fed.get();
    LiveSettings live{signal.info.rig, signal.info.skeleton, calibrate::nominal_calibration(signal.info.rig), {}};
    session = std::make_unique<LiveSession>(std::move(fed), live);
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

TEST_F(LiveRecording, HoldsTheBytesThatCame) {
  simulate({}, 6.0);
  feed(0.0, 2.0);
  require(session->start_recording(folder / "x.take", "Anna"));
  feed(2.0, 3.1);
  feed(3.1, 5.0);
  const take::Take take = require(session->stop_recording());
  feed(5.0, 6.0);
  EXPECT_TRUE(take.info.complete);
  EXPECT_EQ(take.info.subject, "Anna");
  ASSERT_EQ(take.info.frames, frame_at(5.0) - frame_at(2.0));
  take::TakeReader reader = require(take::TakeReader::open(take));
  const std::span<const std::byte> expected = part(2.0, 5.0);
  std::vector<std::byte> recorded(expected.size());
  require(reader.read_raw(SampleIndex{0}, recorded));
  EXPECT_TRUE(std::equal(recorded.begin(), recorded.end(), expected.begin()));
  EXPECT_FALSE(session->stop_recording()) << "nothing is recorded any more";
}

// Hours of rehearsal before it must not use up what is told of a recording.
TEST_F(LiveRecording, HasEveryFaultOfItsOwnAndTheStateOfTheLine) {
  simulate::LineInErrors errors;
  errors.swapped = true;
  errors.drop_every_s = 0.5;
  errors.drop_frames = 1500;
  simulate(errors, 16.0);
  feed(0.0, 8.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(8.0, 16.0);
  const take::Take take = require(session->stop_recording());
  const std::vector<take::TakeEvent> swapped = events(take, "line-in.swapped");
  ASSERT_EQ(swapped.size(), 1U) << "told long before, and still so";
  EXPECT_EQ(swapped.front().sample, SampleIndex{0});
  const std::vector<take::TakeEvent> lost = events(take, "line-in.sync-lost");
  ASSERT_EQ(lost.size(), 6U) << "five, and a sum of all";
  for (std::size_t i = 1; i + 1 < lost.size(); ++i) {
    EXPECT_GT(lost[i].sample, lost[i - 1].sample);
  }
  EXPECT_THAT(lost.back().text, HasSubstr("times in all, 5 of them told"));
}

TEST_F(LiveRecording, SumsUpForTheDisplayWhenTheSessionStops) {
  simulate::LineInErrors errors;
  errors.drop_every_s = 0.5;
  errors.drop_frames = 1500;
  simulate(errors, 8.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(0.0, 8.0);
  session->stop();
  const Diagnostics shown = session->snapshot()->diagnostics;
  ASSERT_FALSE(shown.empty());
  EXPECT_THAT(shown.back().message, HasSubstr("times in all, 5 of them told"));
  const take::Take take = require(session->stop_recording());
  EXPECT_EQ(events(take, "line-in.sync-lost").size(), 6U) << "summed up once";
}

TEST_F(LiveRecording, MarksTheNewestSample) {
  simulate({}, 4.0);
  session->mark("before");  // nothing is recorded
  feed(0.0, 1.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(1.0, 2.0);
  session->mark("one");
  feed(2.0, 3.0);
  session->mark("two");
  const take::Take take = require(session->stop_recording());
  const std::vector<take::TakeEvent> marks = events(take, "marker");
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].text, "one");
  EXPECT_GE(marks[0].sample, SampleIndex{frame_at(1.0)});
  EXPECT_LE(marks[0].sample, SampleIndex{frame_at(1.0) + 8192});
  EXPECT_EQ(marks[1].text, "two") << "also when nothing came after it";
  EXPECT_EQ(marks[1].sample, SampleIndex{frame_at(2.0)});
}

TEST_F(LiveRecording, ACalibrationThatIsMadeMeanwhileIsInTheTake) {
  simulate({}, 4.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(0.0, 1.0);
  calibrate::RigCalibration calibration = calibrate::nominal_calibration(signal.info.rig);
  calibration.sensors[3].method = "ellipsoid";
  calibration.sensors[3].M *= 2.0;
  session->set_calibration(calibration);
  feed(1.0, 2.0);
  wait_for([&](const LiveSnapshot& now) {
    return !now.specific_force[3].empty() &&
           now.specific_force[3].back().norm() > 1.5 * now.specific_force[2].back().norm();
  });
  // A program that is killed now leaves it too.
  EXPECT_EQ(require(take::open_take(folder / "x.take")).info.calibration->sensors[3].method, "ellipsoid");
  calibration.mounts[1].method = "two poses";
  session->set_calibration(calibration);  // and no sample after it
  const take::Take take = require(session->stop_recording());
  ASSERT_TRUE(take.info.calibration.has_value());
  EXPECT_EQ(take.info.calibration->sensors[3].method, "ellipsoid");
  EXPECT_EQ(take.info.calibration->mounts[1].method, "two poses");
}

TEST_F(LiveRecording, ADeviceThatDiesIsKnownForGood) {
  simulate({}, 3.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(0.0, 2.0);
  EXPECT_TRUE(session->snapshot()->source_alive);
  source->die();
  wait_for([](const LiveSnapshot& now) { return !now.source_alive; });
  session->stop();
  EXPECT_FALSE(session->snapshot()->source_alive) << "stopping does not bring it back";
  const take::Take take = require(session->stop_recording());
  EXPECT_TRUE(take.info.complete);
  EXPECT_EQ(take.info.frames, frame_at(2.0));
  EXPECT_EQ(events(take, "source.gone").size(), 1U);
}

// The samples that did not fit are missing behind everything that waits, seconds later than where reading is.
TEST_F(LiveRecording, LostSamplesAreWhereTheyAreMissing) {
  simulate({}, 8.0);
  feed(0.0, 1.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(1.0, 2.0);
  {
    std::vector<std::byte> stalled(part(2.0, 6.0).begin(), part(2.0, 6.0).end());
    // All at once, as a reader that was held up finds it.
    source->feed(stalled);
    source->lose(4800);
    fed += frame_at(6.0) - frame_at(2.0);
  }
  feed(6.1, 8.0);
  const take::Take take = require(session->stop_recording());
  const std::vector<take::TakeEvent> lost = events(take, "dropped");
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost.front().sample, SampleIndex{frame_at(6.0) - frame_at(1.0)});
  EXPECT_THAT(lost.front().text, HasSubstr("4800 samples were lost"));
}

TEST_F(LiveRecording, OneAtATime) {
  simulate({}, 1.0);
  for (int round = 0; round < 10; ++round) {
    std::atomic<int> started{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i) {
      threads.emplace_back([&, i] {
        const fs::path path = folder / (std::to_string(round) + "-" + std::to_string(i) + ".take");
        started += session->start_recording(path, "").ok() ? 1 : 0;
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    EXPECT_EQ(started, 1);
    const take::Take take = require(session->stop_recording());
    for (int i = 0; i < 3; ++i) {
      const fs::path path = folder / (std::to_string(round) + "-" + std::to_string(i) + ".take");
      EXPECT_EQ(fs::exists(path), path == take.folder) << "a recording that was refused leaves nothing";
    }
  }
}

TEST_F(LiveRecording, StoppingTwiceAtOnceIsFine) {
  simulate({}, 1.0);
  std::thread other([this] { session->stop(); });
  session->stop();
  other.join();
  require(session->start());
  session->stop();
}

// The same frames, live and from the file, bit by bit.
TEST_F(LiveRecording, DecodesLikeTheTakeIsDecoded) {
  simulate(require(simulate::load_errors("electronics")), 9.0);
  require(session->start_recording(folder / "x.take", ""));
  for (double at = 0.0; at < 9.0; at += 0.37) {
    feed(at, std::min(at + 0.37, 9.0));
  }
  session->stop();
  const std::vector<decode::AccelerationFrame> live = session->snapshot()->frames;
  const DecodedTake offline = require(decode_take(require(session->stop_recording()), {}, {}));
  ASSERT_GT(live.size(), 450U);
  ASSERT_LE(live.size(), offline.frames.size());
  EXPECT_LE(offline.frames.size() - live.size(), 3U) << "the end of the take needs no look-ahead";
  for (std::size_t i = 0; i < live.size(); ++i) {
    ASSERT_EQ(live[i].time_s, offline.frames[i].time_s) << i;
    ASSERT_EQ(live[i].usable, offline.frames[i].usable) << i;
    for (std::size_t s = 0; s < signal.info.rig.accelerometers.size(); ++s) {
      ASSERT_EQ(live[i].volts[s], offline.frames[i].volts[s]) << i;
    }
  }
}

}  // namespace
}  // namespace limbwave::solve
