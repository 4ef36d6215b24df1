/// Live equals offline, bit for bit, whatever the block size.
#include <gtest/gtest.h>

#include <span>

#include "solve/front_end.h"
#include "solve/live_pose.h"
#include "support/simulated_take.h"
#include "take/take_reader.h"

namespace limbwave {
namespace {

using testing_support::require;
using testing_support::simulated;
using testing_support::TemporaryFolder;

struct Outcome {
  std::vector<decode::AccelerationFrame> frames;
  std::vector<body::SegmentPose> poses;  // all segments of all frames in a row
};

Outcome run(const take::Take& take, std::size_t block_frames) {
  take::TakeReader reader = require(take::TakeReader::open(take));
  solve::FrontEnd front(take.info.rig, take.info.format.rate, {});
  solve::LivePose pose(take.info.rig, take.info.skeleton, calibrate::nominal_calibration(take.info.rig), {});
  Outcome result;
  const auto collect = [&] {
    for (const decode::AccelerationFrame& frame : front.take_frames()) {
      pose.push(frame);
      result.frames.push_back(frame);
      result.poses.insert(result.poses.end(), pose.pose().begin(), pose.pose().end());
    }
  };
  std::vector<float> block(2 * block_frames);
  while (const std::size_t count = require(reader.next(block))) {
    front.push(std::span(block).first(2 * count));
    collect();
  }
  front.finish();
  collect();
  return result;
}

TEST(LiveEqualsOffline, BitForBitAtEveryBlockSize) {
  const TemporaryFolder folder;
  simulate::SimulateSettings settings;
  settings.motion = "box";
  settings.errors_name = "paper";
  settings.errors = require(simulate::load_errors("paper"));
  settings.errors.drop_every_s = 3.1;  // sync is lost and found again meanwhile
  settings.errors.drop_frames = 1234;
  settings.prologue = false;
  const take::Take take = simulated(folder / "box.take", settings);
  const Outcome whole = run(take, 1U << 20);
  ASSERT_GT(whole.frames.size(), 300U);
  for (const std::size_t block : {1U, 17U, 480U, 4096U}) {
    const Outcome blocks = run(take, block);
    ASSERT_EQ(blocks.frames.size(), whole.frames.size()) << block;
    for (std::size_t i = 0; i < whole.frames.size(); ++i) {
      ASSERT_EQ(blocks.frames[i].time_s, whole.frames[i].time_s) << "block " << block << " frame " << i;
      ASSERT_EQ(blocks.frames[i].usable, whole.frames[i].usable) << "block " << block << " frame " << i;
      for (std::size_t s = 0; s < 5; ++s) {
        ASSERT_EQ(blocks.frames[i].volts[s], whole.frames[i].volts[s]) << "block " << block << " frame " << i;
      }
    }
    ASSERT_EQ(blocks.poses.size(), whole.poses.size());
    for (std::size_t i = 0; i < whole.poses.size(); ++i) {
      ASSERT_EQ(blocks.poses[i].R_WL.coeffs(), whole.poses[i].R_WL.coeffs());
      ASSERT_EQ(blocks.poses[i].p_WL, whole.poses[i].p_WL);
    }
  }
}

}  // namespace
}  // namespace limbwave
