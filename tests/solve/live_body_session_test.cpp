// A driver box, live: recorded and solved at once, and the recording solved afterwards gives the same poses.
#include "solve/live_body_session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "simulate/driver_box_stream.h"
#include "support/simulated_take.h"

namespace limbwave {
namespace {

using testing_support::require;

// A simulated box that gives as fast as it is asked, and loses a stretch.
class SimulatedBox : public acquire::BoxSource {
 public:
  SimulatedBox(const body::Rig& rig, const body::Skeleton& skeleton, double seconds, std::int64_t lost_slot)
      : rig_(rig), lost_slot_(lost_slot) {
    const auto errors = require(simulate::load_driver_box_errors("calibrated"));
    const auto actor = require(simulate::DriverBoxActor::create("walk", 0.0, rig, skeleton, errors, 3, 2.0));
    stream_ = std::make_unique<simulate::DriverBoxStream>(rig, actor, errors, 22.0, 3);
    ranging = simulate::simulated_calibration(rig, *stream_, errors, 3);
    slots_ = static_cast<std::int64_t>(seconds * rig.driver_box->rate_hz / stream_->slot_samples());
  }
  [[nodiscard]] acquire::BoxHello hello() const override { return {}; }
  [[nodiscard]] acquire::StreamFormat format() const override {
    return {SampleRate{rig_.driver_box->rate_hz}, stream_->wires(), acquire::SampleType::kInt16};
  }
  [[nodiscard]] std::string title() const override { return "simulated box"; }
  Status set_schedule(const std::vector<std::uint8_t>& /*schedule*/) override { return {}; }
  Status start() override { return {}; }
  void stop() override {}
  acquire::BoxPart pull(double /*timeout_s*/) override {
    acquire::BoxPart part;
    if (slot_ >= slots_) {
      done = true;
      return part;
    }
    // Parts of uneven length.
    const std::int64_t count = 1 + slot_ % 7;
    for (std::int64_t i = 0; i < count && slot_ < slots_; ++i, ++slot_) {
      std::vector<std::int16_t> samples(static_cast<std::size_t>(stream_->slot_samples() * stream_->wires()));
      stream_->next_slot(samples);
      acquire::BoxPiece piece;
      if (lost_slot_ >= 0 && slot_ >= lost_slot_ && slot_ < lost_slot_ + 6) {
        piece.lost = stream_->slot_samples();
        part.events.push_back({SampleIndex{slot_ * stream_->slot_samples()}, "dropped", "lost", piece.lost});
      } else {
        piece.bytes.resize(samples.size() * sizeof(std::int16_t));
        std::memcpy(piece.bytes.data(), samples.data(), piece.bytes.size());
      }
      part.pieces.push_back(std::move(piece));
    }
    return part;
  }
  [[nodiscard]] acquire::BoxCounters counters() const override { return {}; }
  [[nodiscard]] acquire::BoxStatus status() const override { return {}; }
  [[nodiscard]] bool connected() const override { return true; }

  calibrate::RangingCalibration ranging;
  std::atomic<bool> done{false};

 private:
  body::Rig rig_;
  std::int64_t lost_slot_;
  std::unique_ptr<simulate::DriverBoxStream> stream_;
  std::int64_t slot_ = 0, slots_ = 0;
};

TEST(LiveBodySession, RecordsAndSolvesAndTheRecordingSolvesToTheSameBits) {
  const test::TemporaryFolder folder;
  solve::LiveBodySettings settings;
  settings.rig = require(body::load_rig("driver-box-body"));
  settings.skeleton = require(body::load_skeleton(settings.rig.skeleton));
  auto box = std::make_unique<SimulatedBox>(settings.rig, settings.skeleton, 4.5, 400);
  SimulatedBox& simulated = *box;
  settings.ranging = box->ranging;
  settings.solve.root = "contacts";
  settings.solve.rate_hz = 60.0;
  settings.most_behind_s = 1e9;  // it comes faster than in real time
  settings.lag_s = 0.1;
  solve::LiveBodySession session(std::move(box), settings);
  std::vector<estimate::TrackedPose> live;
  std::size_t smoothed = 0;
  session.on_poses([&](const auto& poses, const auto& later) {
    live.insert(live.end(), poses.begin(), poses.end());
    smoothed += later.size();
  });
  std::atomic<int> told{0};
  double behind_s = 0.0;  // of what figures show, against the newest pose
  session.on_figure([&] {
    ++told;
    if (!live.empty()) {
      behind_s = std::max(behind_s, live.back().time_s - session.figure()->time_s);
    }
  });
  ASSERT_TRUE(session.start(folder.path() / "live.take", "somebody").ok());
  EXPECT_FALSE(session.start().ok());
  while (!simulated.done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const take::Take take = require(session.stop());
  const auto last = session.snapshot();
  EXPECT_EQ(last->late, 0);
  EXPECT_EQ(last->skipped_s, 0.0);
  EXPECT_TRUE(last->error.empty()) << last->error;
  EXPECT_FALSE(last->running);
  EXPECT_EQ(last->wires.size(), 18U);
  EXPECT_EQ(last->pose.size(), settings.skeleton.segments.size());
  EXPECT_TRUE(last->root_sigma.norm() > 0.0);
  ASSERT_NE(session.figure(), nullptr);
  EXPECT_EQ(session.figure()->time_s, live.back().time_s);
  EXPECT_GT(told, 0);
  EXPECT_GT(behind_s, settings.lag_s);
  EXPECT_EQ(smoothed, live.size());

  solve::BodySolveSettings again = settings.solve;
  again.name = "again";
  again.by_past = true;
  const solve::Solve solved = require(solve::solve_sensors(take, again, {}));
  ASSERT_EQ(solved.clip.root_position.times.size(), live.size());
  for (std::size_t i = 0; i < live.size(); ++i) {
    ASSERT_EQ(solved.clip.root_position.times[i], live[i].time_s);
    ASSERT_EQ(solved.clip.root_position.values[i], live[i].root_p_W);
    for (std::size_t s = 0; s < live[i].R_joint.size(); ++s) {
      const Eigen::Quaterniond R = (settings.skeleton.segments[s].R_PL_rest * live[i].R_joint[s]).normalized();
      ASSERT_EQ(solved.clip.joints[s].rotation.values[i].coeffs(), R.coeffs()) << live[i].time_s;
    }
  }
}

TEST(LiveBodySession, WhatCannotBeLiveIsRefused) {
  solve::LiveBodySettings settings;
  settings.rig = require(body::load_rig("driver-box-body"));
  settings.skeleton = require(body::load_skeleton(settings.rig.skeleton));
  settings.solve.root = "truth";
  solve::LiveBodySession session(std::make_unique<SimulatedBox>(settings.rig, settings.skeleton, 0.1, -1), settings);
  const Status refused = session.start();
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().text().find("while recording"), std::string::npos);
  EXPECT_FALSE(session.stop().ok());
}

// A picture that cannot follow leaves something out and says so; the recording is whole.
TEST(LiveBodySession, ATooSlowComputerSkipsThePictureAndRecordsEverything) {
  const test::TemporaryFolder folder;
  solve::LiveBodySettings settings;
  settings.rig = require(body::load_rig("driver-box-body"));
  settings.skeleton = require(body::load_skeleton(settings.rig.skeleton));
  auto box = std::make_unique<SimulatedBox>(settings.rig, settings.skeleton, 3.0, -1);
  SimulatedBox& simulated = *box;
  settings.ranging = box->ranging;
  settings.solve.root = "free";
  settings.most_behind_s = 0.0;  // whatever waits is too much
  solve::LiveBodySession session(std::move(box), settings);
  ASSERT_TRUE(session.start(folder.path() / "slow.take").ok());
  while (!simulated.done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const take::Take take = require(session.stop());
  EXPECT_GE(take.info.frames, static_cast<std::int64_t>(2.99 * settings.rig.driver_box->rate_hz));
  const auto last = session.snapshot();
  EXPECT_GT(last->skipped_s, 0.0);
  EXPECT_EQ(last->diagnostics.back().code, "live.too-slow");
}

}  // namespace
}  // namespace limbwave
