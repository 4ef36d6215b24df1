#include "solve/pair_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/units.h"
#include "body/rig.h"
#include "geometry/so3.h"
#include "solve/driver_box.h"

namespace limbwave::solve {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Worn {
  body::Rig rig = body::load_rig("driver-box-body").value();
  body::Skeleton skeleton = body::load_skeleton(rig.skeleton).value();
  [[nodiscard]] int on(const std::string& segment) const { return skeleton.find(segment); }
  [[nodiscard]] const body::Microphone& microphone(const std::string& name) const {
    return *std::find_if(rig.microphones.begin(), rig.microphones.end(),
                         [&](const body::Microphone& m) { return m.name == name; });
  }
  [[nodiscard]] PairReach of(const body::Source& source, const body::Microphone& microphone) const {
    return pair_reach(skeleton, on(source.segment), source.p_LS, source.normal_L, on(microphone.segment),
                      microphone.p_LS);
  }
};

TEST(PairReach, OnOneSegmentIsRigid) {
  const Worn worn;
  const body::Source& source = worn.rig.sources[0];  // on the chest
  const body::Microphone& microphone = worn.microphone("chest");
  const Vector3d way = microphone.p_LS - source.p_LS;
  const PairReach reach = worn.of(source, microphone);
  EXPECT_NEAR(reach.farthest, way.norm(), 1e-12);
  EXPECT_NEAR(reach.foremost, std::acos(way.normalized().dot(source.normal_L)), 1e-9);
}

// Poses within the limits, made by the skeleton itself, never leave what was sampled, and come near its ends.
TEST(PairReach, HoldsAllPosesWithinTheLimits) {
  const Worn worn;
  std::mt19937_64 random(5);
  for (const char* name : {"pelvis", "abdomen", "left shoulder", "right upper arm"}) {
    const body::Microphone& microphone = worn.microphone(name);
    for (const body::Source& source : worn.rig.sources) {
      if (source.segment != "chest") {
        continue;
      }
      const PairReach reach = worn.of(source, microphone);
      double farthest = 0.0;
      double foremost = kPi;
      for (int pose = 0; pose < 300; ++pose) {
        std::vector<Quaterniond> turned;
        for (const body::Segment& segment : worn.skeleton.segments) {
          const body::Joint& joint = segment.joint;
          const auto angle = [&](Eigen::Index axis) {
            return std::uniform_real_distribution<double>(joint.minimum[axis], joint.maximum[axis])(random);
          };
          Quaterniond turn = Quaterniond::Identity();
          if (joint.kind == body::JointKind::kHinge) {
            turn = geometry::exp_so3(angle(0) * joint.axis);
          } else if (joint.kind == body::JointKind::kUniversal) {
            turn = geometry::exp_so3(angle(0) * joint.axis) * geometry::exp_so3(angle(1) * joint.axis2);
          } else if (joint.kind == body::JointKind::kSpherical) {
            turn = geometry::exp_so3(Vector3d(angle(0), angle(1), angle(2)));
          }
          turned.push_back(turn);
        }
        const auto poses = body::poses_from_joints(worn.skeleton, turned, Vector3d::Zero());
        const body::SegmentPose& s = poses[static_cast<std::size_t>(worn.on(source.segment))];
        const body::SegmentPose& m = poses[static_cast<std::size_t>(worn.on(microphone.segment))];
        const Vector3d way = m.p_WL + m.R_WL * microphone.p_LS - (s.p_WL + s.R_WL * source.p_LS);
        farthest = std::max(farthest, way.norm());
        foremost = std::min(foremost, std::acos(std::clamp(way.normalized().dot(s.R_WL * source.normal_L), -1.0, 1.0)));
      }
      // Ends are sampled, not solved for; decoding adds 5 degrees and 20 mm.
      EXPECT_LE(farthest, reach.farthest + 1e-3) << name << ", " << source.name;
      EXPECT_GE(foremost, reach.foremost - radians(0.5)) << name << ", " << source.name;
      EXPECT_GT(farthest, 0.75 * reach.farthest) << name << ", " << source.name;
    }
  }
}

// A shoulder cannot be as far from the chest's sources as bones in one line would be.
TEST(PairReach, LimitsTellMoreThanBones) {
  const Worn worn;
  const body::Microphone& microphone = worn.microphone("left shoulder");
  const body::Source& source = worn.rig.sources[0];
  const Vector3d joint = worn.skeleton.segments[static_cast<std::size_t>(worn.on("left_shoulder"))].p_PL;
  const double in_one_line = (source.p_LS - joint).norm() + microphone.p_LS.norm();
  const PairReach reach = worn.of(source, microphone);
  EXPECT_LT(reach.farthest, in_one_line - 0.05);
  EXPECT_GT(reach.foremost, radians(80.0));
}

TEST(PairReach, OverManyJointsIsThatOfBones) {
  const Worn worn;
  const body::Source& source = worn.rig.sources[0];
  const body::Microphone& hand = worn.microphone("left hand");
  const auto offset = [&](const char* segment) {
    return worn.skeleton.segments[static_cast<std::size_t>(worn.on(segment))].p_PL;
  };
  const PairReach reach = worn.of(source, hand);
  const double bones = (source.p_LS - offset("left_shoulder")).norm() + offset("left_upper_arm").norm() +
                       offset("left_forearm").norm() + offset("left_hand").norm() + hand.p_LS.norm();
  EXPECT_NEAR(reach.farthest, bones, 1e-12);
  EXPECT_EQ(reach.foremost, 0.0);
}

// What decoding is told: never less than the joints' own reach.
TEST(PairReach, ReachesDecoding) {
  const Worn worn;
  const decode::DriverBoxFormat format = driver_box_format(worn.rig, worn.skeleton, {});
  for (std::size_t w = 0; w < worn.rig.microphones.size(); ++w) {
    for (std::size_t s = 0; s < worn.rig.sources.size(); ++s) {
      const PairReach reach = worn.of(worn.rig.sources[s], worn.rig.microphones[w]);
      EXPECT_GT(format.wires[w].sources[s].reach, reach.farthest + 0.015);
      EXPECT_LE(format.wires[w].sources[s].foremost, reach.foremost);
    }
  }
}

}  // namespace
}  // namespace limbwave::solve
