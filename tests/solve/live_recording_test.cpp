/// Recording out of a running session: what gets into the take, whatever happens meanwhile.
#include "solve/live_recording.h"

#include <gmock/gmock.h>

#include <atomic>

namespace limbwave::solve {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

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
    fed += frame_at(6.1) - frame_at(2.0);
  }
  feed(6.1, 8.0);
  const take::Take take = require(session->stop_recording());
  ASSERT_EQ(take.info.frames, frame_at(8.0) - frame_at(1.0)) << "what follows keeps its time";
  take::TakeReader reader = require(take::TakeReader::open(take));
  std::vector<std::byte> recorded(part(1.0, 8.0).size());
  require(reader.read_raw(SampleIndex{0}, recorded));
  std::vector<std::byte> expected(part(1.0, 8.0).begin(), part(1.0, 8.0).end());
  const std::size_t silence = part(1.0, 6.0).size();
  std::fill_n(expected.begin() + static_cast<std::ptrdiff_t>(silence), part(6.0, 6.1).size(), std::byte{0});
  EXPECT_TRUE(recorded == expected);
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

// A device that only says that it lost something: nothing can stand in for it.
TEST_F(LiveRecording, LossesOfUnknownLengthAreTold) {
  simulate({}, 4.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(0.0, 2.0);
  source->lose(0);
  feed(2.0, 4.0);
  const take::Take take = require(session->stop_recording());
  EXPECT_EQ(take.info.frames, frame_at(4.0));
  const std::vector<take::TakeEvent> lost = events(take, "dropped");
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost.front().sample, SampleIndex{frame_at(2.0)});
  EXPECT_THAT(lost.front().text, HasSubstr("does not say how many"));
}

}  // namespace
}  // namespace limbwave::solve
