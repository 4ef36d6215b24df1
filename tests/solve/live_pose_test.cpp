/// What the screen shows before the axes' second cycle of look-ahead has passed.
#include "solve/live_pose.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "geometry/so3.h"
#include "solve/front_end.h"
#include "support/simulated_take.h"
#include "take/take_reader.h"

namespace limbwave::solve {
namespace {

using testing_support::require;

struct Difference {
  std::size_t poses = 0;
  double mean_deg = 0.0, max_deg = 0.0;
  double cycles_behind = 0.0;  // largest distance of a shown pose from the newest decoded cycle
};

// The first version of every pose against the one that is solved when everything is there.
Difference first_against_last(const std::string& motion) {
  const test::TemporaryFolder folder;
  simulate::SimulateSettings settings;
  settings.motion = motion;
  settings.errors_name = "electronics";
  settings.errors = require(simulate::load_errors("electronics"));
  settings.prologue = false;
  settings.seconds = 20.0;
  const take::Take take = testing_support::simulated(folder / "live.take", settings);
  take::TakeReader reader = require(take::TakeReader::open(take));
  FrontEnd front(take.info.rig, take.info.format.rate, {});
  front.keep_cycles(true);
  LivePose pose(take.info.rig, take.info.skeleton, calibrate::nominal_calibration(take.info.rig), {});
  struct Shown {
    double time_s;
    std::vector<body::SegmentPose> pose;
  };
  std::vector<Shown> waiting;
  Difference result;
  double sum = 0.0;
  std::vector<float> block(2 * 480);
  while (const std::size_t count = require(reader.next(block))) {
    front.push(std::span(block).first(2 * count));
    for (const decode::AccelerationFrame& frame : front.take_frames()) {
      pose.push(frame);
      for (const Shown& shown : waiting) {
        // Half a second of settling in aside.
        if (shown.time_s == frame.time_s && frame.time_s > 0.5) {
          for (std::size_t i = 0; i < shown.pose.size(); ++i) {
            const double angle = geometry::log_so3(shown.pose[i].R_WL.conjugate() * pose.pose()[i].R_WL).norm();
            sum += angle;
            ++result.poses;
            result.max_deg = std::max(result.max_deg, angle * 180.0 / M_PI);
          }
        }
      }
      std::erase_if(waiting, [&](const Shown& shown) { return shown.time_s <= frame.time_s; });
    }
    const auto cycles = front.take_cycles();
    const auto ahead = front.frames_ahead();
    if (!cycles.empty() && !pose.pose().empty() && !ahead.empty()) {
      waiting.push_back({ahead.back().time_s, pose.ahead(ahead)});
      const decode::LineInCycle& newest = cycles.back();
      const double middle = (newest.start_sample + 0.5 * newest.period_samples) / take.info.format.rate.hz;
      result.cycles_behind = std::max(result.cycles_behind, (middle - ahead.back().time_s) * 60.0);
    }
  }
  result.mean_deg = sum / static_cast<double>(result.poses) * 180.0 / M_PI;
  std::printf("%-10s first version of a pose against the settled one: %.2f° mean, %.2f° max of %zu\n", motion.c_str(),
              result.mean_deg, result.max_deg, result.poses);
  return result;
}

TEST(LivePoseAhead, ShowsTheNewestCycleAndHardlyDiffersFromWhatFollows) {
  for (const char* motion : {"arm-raise", "walk", "reach"}) {
    const Difference difference = first_against_last(motion);
    EXPECT_GT(difference.poses, 5000U) << motion;
    EXPECT_NEAR(difference.cycles_behind, 0.0, 1e-6) << motion << ": no cycle of look-ahead";
    EXPECT_LT(difference.mean_deg, 0.5) << motion;
    EXPECT_LT(difference.max_deg, 5.0) << motion;
  }
}

TEST(LivePoseAhead, ChangesNothingThatFollows) {
  const test::TemporaryFolder folder;
  simulate::SimulateSettings settings;
  settings.motion = "box";
  settings.errors = require(simulate::load_errors("paper"));
  settings.prologue = false;
  settings.seconds = 5.0;
  const take::Take take = testing_support::simulated(folder / "live.take", settings);
  take::TakeReader reader = require(take::TakeReader::open(take));
  const auto calibration = calibrate::nominal_calibration(take.info.rig);
  FrontEnd front(take.info.rig, take.info.format.rate, {});
  LivePose looked(take.info.rig, take.info.skeleton, calibration, {});
  LivePose plain(take.info.rig, take.info.skeleton, calibration, {});
  EXPECT_TRUE(looked.ahead({}).empty());
  std::vector<float> block(2 * 480);
  std::size_t frames = 0;
  std::size_t differing = 0;
  while (const std::size_t count = require(reader.next(block))) {
    front.push(std::span(block).first(2 * count));
    for (const decode::AccelerationFrame& frame : front.take_frames()) {
      looked.push(frame);
      plain.push(frame);
      ASSERT_EQ(looked.pose().size(), plain.pose().size());
      for (std::size_t i = 0; i < plain.pose().size(); ++i) {
        ASSERT_EQ(looked.pose()[i].R_WL.coeffs(), plain.pose()[i].R_WL.coeffs());
      }
      ++frames;
    }
    const auto ahead = front.frames_ahead();
    const auto pose = looked.ahead(ahead);
    if (!ahead.empty() && frames > 60) {
      differing += pose.back().R_WL.coeffs() != looked.pose().back().R_WL.coeffs() ? 1 : 0;
    }
  }
  EXPECT_GT(frames, 200U);
  EXPECT_GT(differing, 100U) << "looking ahead must show something else";
}

}  // namespace
}  // namespace limbwave::solve
