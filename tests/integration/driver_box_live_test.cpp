// From the emulator's pseudo-terminal to poses while they happen: they follow the truth, nothing that came is lost, and
// the take solved afterwards gives the same bits.
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <thread>

#include "acquire/driver_box.h"
#include "evaluate/evaluate.h"
#include "solve/live_body_session.h"
#include "support/child_process.h"
#include "support/simulated_take.h"
#include "take/take_reader.h"

namespace limbwave {
namespace {

using testing_support::require;

// A walk of eleven seconds on the wires, with what was really done, and a box that plays it again and again.
class DriverBoxLive : public testing::Test {
 protected:
  static constexpr double kSeconds = 11.0;
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder;
    simulate::SimulateSettings settings;
    settings.rig = "driver-box-body";
    settings.motion = "walk";
    settings.errors_name = "calibrated";
    settings.seed = 11;
    settings.seconds = kSeconds;
    require(simulate::simulate_take(folder_->path() / "walk.take", settings, {}));
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  // At half speed, so that a busy machine keeps up: the samples are the same.
  void start_box(const std::vector<std::string>& more = {}) {
    link_ = (own_.path() / "box").string();
    std::vector<std::string> arguments{
        LIMBWAVE_EMULATOR, "--take", (folder_->path() / "walk.take").string(), "--link", link_, "--speed", "0.5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    emulator_ = std::make_unique<test::ChildProcess>(arguments, std::map<std::string, std::string>{},
                                                     own_.path() / "emulator.txt");
    for (int i = 0; i < 300 && !std::filesystem::exists(std::filesystem::symlink_status(link_)); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  solve::LiveBodySettings settings() {
    const take::Take take = require(take::open_take(folder_->path() / "walk.take"));
    solve::LiveBodySettings settings;
    settings.rig = take.info.rig;
    settings.skeleton = take.info.skeleton;
    settings.ranging = *take.info.ranging;
    settings.solve.root = "contacts";
    settings.solve.rate_hz = 60.0;
    settings.most_behind_s = 1e9;  // nothing is left out, however busy the machine is
    return settings;
  }
  // Lets the session record for so long; the take when it has stopped.
  static take::Take run(solve::LiveBodySession& session, const std::filesystem::path& folder, double seconds) {
    require(session.start(folder, "somebody"));
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(400);
    while (session.snapshot()->recorded_s < seconds && session.snapshot()->recording_error.empty() &&
           std::chrono::steady_clock::now() < limit) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return require(session.stop());
  }

  static test::TemporaryFolder* folder_;
  test::TemporaryFolder own_;
  std::string link_;
  std::unique_ptr<test::ChildProcess> emulator_;
};
test::TemporaryFolder* DriverBoxLive::folder_ = nullptr;

TEST_F(DriverBoxLive, PosesFollowTheTruthAndAreThoseOfTheTakeToTheBit) {
  start_box();
  const solve::LiveBodySettings how = settings();
  solve::LiveBodySession session(require(acquire::DriverBox::open(link_)), how);
  std::vector<estimate::TrackedPose> live;
  session.on_poses([&](const auto& poses, const auto&) { live.insert(live.end(), poses.begin(), poses.end()); });
  const take::Take take = run(session, own_.path() / "live.take", kSeconds - 1.0);
  const auto last = session.snapshot();
  EXPECT_EQ(last->error, "");
  EXPECT_EQ(last->late, 0) << "every reading came in time for its pose";
  EXPECT_EQ(last->skipped_s, 0.0);
  EXPECT_EQ(last->poses, static_cast<std::int64_t>(live.size()));
  EXPECT_GT(last->latency.poses, 0U);
  EXPECT_GT(last->joint_sigma_deg, 0.1);
  EXPECT_LT(last->joint_sigma_deg, 10.0);

  // Nothing that the box sent is missing, and every wire spoke all the time.
  ASSERT_EQ(last->counters.lost_frames, 0U) << "at half speed a box loses nothing";
  const double seconds = static_cast<double>(take.info.frames) / take.info.format.rate.hz;
  for (const solve::BoxWire& wire : last->wires) {
    EXPECT_TRUE(wire.locked && wire.plugged) << wire.board;
    EXPECT_EQ(wire.lost_frames, 0) << wire.board;
    EXPECT_GT(static_cast<double>(wire.frames), 140.0 * (seconds - 0.5)) << wire.board;
    EXPECT_GT(wire.level, 0.001) << wire.board;
  }

  // The readings and the poses of the take are the same to the last bit.
  solve::BodySolveSettings again = how.solve;
  again.by_past = true;
  const estimate::BodyModel model = estimate::body_model(take.info.rig, take.info.skeleton);
  const estimate::BodyReadings readings = require(solve::driver_box_readings(take, model, {}, true));
  EXPECT_EQ(last->words, static_cast<std::int64_t>(readings.inertial.size()));
  EXPECT_EQ(last->ranges, static_cast<std::int64_t>(readings.ranges.size()));
  const solve::Solve solved = require(solve::solve_body(take, readings, again, {}));
  ASSERT_EQ(solved.clip.root_position.times.size(), live.size());
  for (std::size_t i = 0; i < live.size(); ++i) {
    ASSERT_EQ(solved.clip.root_position.times[i], live[i].time_s);
    ASSERT_EQ(solved.clip.root_position.values[i], live[i].root_p_W);
    for (std::size_t s = 0; s < live[i].R_joint.size(); ++s) {
      const Eigen::Quaterniond R = (how.skeleton.segments[s].R_PL_rest * live[i].R_joint[s]).normalized();
      ASSERT_EQ(solved.clip.joints[s].rotation.values[i].coeffs(), R.coeffs()) << live[i].time_s;
    }
  }

  // And they follow the wearer. The bars of a whole solve hold with the root given; here it is found by the feet.
  motion::Clip clip = solved.clip;
  const evaluate::Truth truth = require(evaluate::load_truth(folder_->path() / "walk.take" / "truth.json"));
  const evaluate::Evaluation evaluation = require(evaluate::evaluate(clip, 0.0, truth));
  double sum = 0.0;
  for (const auto& [name, joint] : evaluation.joints) {
    sum += joint.mean_deg;
    EXPECT_LT(joint.mean_deg, 12.0) << name;
  }
  const double mean = sum / static_cast<double>(evaluation.joints.size());
  std::printf("joints %.2f deg mean, latency %.0f ms mean, %.0f ms for 95 %%\n", mean,
              1e3 * last->latency.of(solve::LatencyStage::kTotal).mean_s,
              1e3 * last->latency.of(solve::LatencyStage::kTotal).p95_s);
  EXPECT_LT(mean, 3.0);
}

// Recording may begin and end in mid-session: the take begins with a round of the sources, and its samples are the
// box's.
TEST_F(DriverBoxLive, ARecordingInMidSessionBeginsWithTheFirstSource) {
  start_box({"--faults-every", "1.5", "--seed", "4"});
  solve::LiveBodySettings how = settings();
  solve::LiveBodySession session(require(acquire::DriverBox::open(link_)), how);
  require(session.start());
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(300);
  const auto wait = [&](const auto& done) {
    while (!done() && std::chrono::steady_clock::now() < limit) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  };
  wait([&] { return session.snapshot()->stream_time_s > 1.2; });
  EXPECT_FALSE(session.mark("nothing is recorded").has_value());
  require(session.start_recording(own_.path() / "part.take", "somebody"));
  EXPECT_FALSE(session.start_recording(own_.path() / "other.take", "somebody").ok());
  EXPECT_FALSE(std::filesystem::exists(own_.path() / "other.take"));
  wait([&] { return session.snapshot()->recorded_s > 1.0; });
  const auto marker = session.mark("here");
  ASSERT_TRUE(marker.has_value());
  EXPECT_EQ(marker->count, 1);
  wait([&] { return session.snapshot()->recorded_s > 3.0; });
  const take::Take part = require(session.stop_recording());
  EXPECT_FALSE(session.stop_recording().ok());
  EXPECT_TRUE(session.snapshot()->running);
  (void)session.stop();
  EXPECT_GE(part.info.frames, static_cast<std::int64_t>(3.0 * part.info.format.rate.hz));
  EXPECT_TRUE(part.info.complete);
  EXPECT_TRUE(std::ranges::any_of(part.events, [](const take::TakeEvent& event) { return event.text == "here"; }));

  // Somewhere in the played take lies every sample that is not in a gap or on a pulled wire; at one and the same shift
  // of whole rounds.
  const take::Take played = require(take::open_take(folder_->path() / "walk.take"));
  take::TakeReader from = require(take::TakeReader::open(played));
  take::TakeReader reader = require(take::TakeReader::open(part));
  const std::int64_t round = std::int64_t{8} * 1120;
  const std::int64_t frames = from.frames() / round * round;
  const auto channels = static_cast<std::size_t>(part.info.format.channels);
  std::vector<std::int16_t> all(static_cast<std::size_t>(frames) * channels);
  std::vector<std::int16_t> got(static_cast<std::size_t>(part.info.frames) * channels);
  ASSERT_TRUE(from.read_raw(SampleIndex{0}, std::as_writable_bytes(std::span(all))).ok());
  ASSERT_TRUE(reader.read_raw(SampleIndex{0}, std::as_writable_bytes(std::span(got))).ok());
  int fits = 0;
  for (std::int64_t shift = 0; shift < frames; shift += round) {
    std::int64_t wrong = 0;
    for (std::size_t n = 0; n < got.size() && wrong == 0; ++n) {
      const auto there = (static_cast<std::int64_t>(n / channels) + shift) % frames;
      wrong += got[n] != 0 && got[n] != all[static_cast<std::size_t>(there) * channels + n % channels];
    }
    fits += wrong == 0 ? 1 : 0;
  }
  EXPECT_EQ(fits, 1);
  for (const take::TakeEvent& event : part.events) {
    EXPECT_GE(event.sample.value, 0);
    for (std::int64_t n = 0; event.kind == "dropped" && n < event.count; ++n) {
      const auto at = static_cast<std::size_t>(event.sample.value + n) * channels;
      ASSERT_TRUE(at >= got.size() || got[at] == 0);
    }
  }
}

}  // namespace
}  // namespace limbwave
