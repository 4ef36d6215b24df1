#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"
#include "simulate/body_motions.h"
#include "simulate/motions.h"
#include "simulate/random.h"

namespace limbwave::simulate {
namespace {

using body::JointKind;
using body::Skeleton;

// The right arm of the skeleton "arm" with the anatomical names of its angles; all zero: standing, arm hanging, palm to
// the rear. Degrees, because these are poses that people read.
struct Arm {
  explicit Arm(const Skeleton& skeleton)
      : motion(std::make_shared<JointMotion>(skeleton)),
        lean(add(skeleton, "torso", {0, 1, 0})),
        yaw(add(skeleton, "torso", {1, 0, 0})),
        flexion(add(skeleton, "upper_arm", {0, -1, 0})),
        abduction(add(skeleton, "upper_arm", {0, 0, -1})),
        turn(add(skeleton, "upper_arm", {1, 0, 0})),
        elbow(add(skeleton, "forearm", {0, -1, 0})),
        pronation(add(skeleton, "forearm", {1, 0, 0})),
        wrist(add(skeleton, "hand", {0, -1, 0})),
        deviation(add(skeleton, "hand", {0, 0, 1})),
        curl(add(skeleton, "fingers", {0, 1, 0})) {}

  Curve& add(const Skeleton& skeleton, const char* segment, const Vector3d& axis) const {
    return motion->turn(skeleton.find(segment), axis);
  }
  std::shared_ptr<const BodyMotion> done() const {
    double end = 0.0;
    for (const Curve* curve :
         {&lean, &yaw, &flexion, &abduction, &turn, &elbow, &pronation, &wrist, &deviation, &curl}) {
      end = std::max(end, curve->end());
    }
    motion->set_duration(end + 0.5);
    return motion;
  }

  std::shared_ptr<JointMotion> motion;
  Curve &lean, &yaw, &flexion, &abduction, &turn, &elbow, &pronation, &wrist, &deviation, &curl;
};

// Key values in degrees.
void keys(Curve& curve, std::initializer_list<std::array<double, 2>> values) {
  for (const auto& [time, angle] : values) {
    curve.key(time, radians(angle));
  }
}

std::shared_ptr<const BodyMotion> arm_raise(const Skeleton& skeleton) {
  const Arm arm(skeleton);
  keys(arm.flexion, {{0.5, 0}, {2.5, 90}, {3.5, 90}, {5.5, 0}, {6.0, 0}, {8.5, 160}, {9.0, 160}, {11.5, 0}});
  keys(arm.abduction, {{12.0, 0}, {14.0, 85}, {15.0, 85}, {17.0, 0}});
  keys(arm.elbow, {{0.5, 0}, {2.5, 8}, {5.5, 0}, {6.0, 0}, {8.5, 25}, {11.5, 0}, {12.0, 0}, {14.0, 10}, {17.0, 0}});
  keys(arm.wrist, {{2.5, 0}, {3.2, 15}, {4.0, 0}});
  return arm.done();
}

std::shared_ptr<const BodyMotion> wave(const Skeleton& skeleton) {
  const Arm arm(skeleton);
  keys(arm.flexion, {{0.5, 0}, {2.0, 70}, {9.5, 70}, {11.0, 0}});
  keys(arm.abduction, {{0.5, 0}, {2.0, 25}, {9.5, 25}, {11.0, 0}});
  keys(arm.elbow, {{0.5, 0}, {2.0, 85}, {9.5, 85}, {11.0, 0}});
  arm.turn.oscillate(2.0, 9.5, 1.0, 1.3, radians(25));
  arm.deviation.oscillate(2.0, 9.5, 1.0, 1.3, radians(12), -0.8);
  keys(arm.wrist, {{0.8, 0}, {2.2, 15}, {9.5, 15}, {10.5, 0}});
  arm.curl.oscillate(2.0, 9.5, 1.0, 1.3, radians(4), -1.2);
  arm.lean.oscillate(2.0, 9.5, 2.0, 0.4, radians(1.5));
  return arm.done();
}

// Reaches for a glass on a table, drinks, puts it back.
std::shared_ptr<const BodyMotion> reach(const Skeleton& skeleton) {
  const Arm arm(skeleton);
  keys(arm.lean, {{0.5, 0}, {2.5, 22}, {3.5, 22}, {5.0, 0}, {8.0, 0}, {9.5, 22}, {10.3, 22}, {12.0, 0}});
  keys(arm.flexion, {{0.5, 0}, {2.5, 62}, {3.5, 62}, {5.5, 48}, {7.5, 52}, {9.5, 62}, {10.3, 62}, {12.3, 0}});
  keys(arm.abduction, {{0.5, 0}, {2.0, 6}, {5.5, 20}, {7.5, 20}, {9.5, 6}, {12.0, 0}});
  keys(arm.elbow, {{0.4, 0},
                   {1.4, 70},
                   {2.5, 28},
                   {3.5, 28},
                   {5.5, 128},
                   {7.5, 134},
                   {9.5, 28},
                   {10.3, 28},
                   {11.2, 70},
                   {12.3, 0}});
  keys(arm.pronation, {{0.5, 0}, {2.0, 75}, {10.5, 75}, {12.0, 0}});
  keys(arm.wrist, {{1.5, 0}, {2.5, 12}, {5.5, -10}, {6.5, 18}, {7.5, 18}, {9.5, 12}, {11.0, 0}});
  keys(arm.curl, {{1.5, 10}, {2.4, -5}, {3.4, 55}, {9.8, 55}, {10.3, 0}, {12.0, 10}});
  return arm.done();
}

// Walking on the spot: the body bobs twice per stride, the arm swings once.
std::shared_ptr<const BodyMotion> walk(const Skeleton& skeleton) {
  const Arm arm(skeleton);
  const double stride = 0.92;  // Hz
  const double end = 20.0;
  arm.flexion.oscillate(0.5, end, 2.0, stride, radians(24));
  keys(arm.flexion, {{0.5, 0}, {2.5, 6}, {end - 2.0, 6}, {end, 0}});
  keys(arm.elbow, {{0.5, 0}, {2.5, 20}, {end - 2.0, 20}, {end, 0}});
  arm.elbow.oscillate(0.5, end, 2.0, stride, radians(12), -0.5);
  keys(arm.abduction, {{0.5, 0}, {2.5, 8}, {end - 2.0, 8}, {end, 0}});
  arm.wrist.oscillate(0.5, end, 2.0, stride, radians(5), -1.0);
  keys(arm.curl, {{0.0, 15}, {end, 15}});
  arm.yaw.oscillate(0.5, end, 2.0, stride, radians(5), kPi);
  keys(arm.lean, {{0.5, 0}, {2.5, 4}, {end - 2.0, 4}, {end, 0}});
  arm.lean.oscillate(0.5, end, 2.0, 2.0 * stride, radians(1));
  arm.motion->root(0).oscillate(0.5, end, 2.0, 2.0 * stride, 0.010, 1.0);
  arm.motion->root(1).oscillate(0.5, end, 2.0, stride, 0.018);
  arm.motion->root(2).oscillate(0.5, end, 2.0, 2.0 * stride, 0.022, 0.5);
  return arm.done();
}

std::shared_ptr<const BodyMotion> box(const Skeleton& skeleton) {
  const Arm arm(skeleton);
  keys(arm.curl, {{0.3, 10}, {1.2, 80}, {15.0, 80}, {16.0, 10}});
  keys(arm.lean, {{0.5, 0}, {1.8, 12}, {14.0, 12}, {15.5, 0}});
  keys(arm.pronation, {{0.5, 0}, {1.8, 40}, {14.0, 40}, {15.5, 0}});
  arm.flexion.key(0.5, 0).key(1.8, radians(35));
  arm.elbow.key(0.5, 0).key(1.8, radians(125));
  arm.yaw.key(0.5, 0).key(1.8, radians(-20));
  double t = 2.4;
  for (int punch = 0; punch < 8; ++punch) {
    const double out = punch % 3 == 2 ? 0.24 : 0.34;  // every third is fast
    arm.flexion.key(t, radians(35)).key(t + out, radians(88)).key(t + 2.2 * out, radians(35));
    arm.elbow.key(t, radians(125)).key(t + out, radians(12)).key(t + 2.2 * out, radians(125));
    arm.yaw.key(t, radians(-20)).key(t + 1.1 * out, radians(25)).key(t + 2.4 * out, radians(-20));
    t += 1.4;
  }
  arm.flexion.key(14.0, radians(35)).key(15.5, 0);
  arm.elbow.key(14.0, radians(125)).key(15.5, 0);
  arm.yaw.key(14.0, radians(-20)).key(15.5, 0);
  arm.motion->root(2).oscillate(1.8, 14.0, 1.5, 1.6, 0.012);
  arm.motion->root(1).oscillate(1.8, 14.0, 1.5, 0.8, 0.030);
  return arm.done();
}

// One degree of freedom after the other, through most of its range.
std::shared_ptr<const BodyMotion> every_joint(const Skeleton& skeleton) {
  auto motion = std::make_shared<JointMotion>(skeleton);
  double t = 0.5;
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const body::Joint& joint = skeleton.segments[i].joint;
    std::vector<Vector3d> axes;
    if (joint.kind == JointKind::kHinge) {
      axes = {joint.axis};
    } else if (joint.kind == JointKind::kUniversal) {
      axes = {joint.axis, joint.axis2};
    } else if (joint.kind == JointKind::kSpherical) {
      axes = {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
    }
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const double high = 0.95 * joint.maximum[static_cast<Eigen::Index>(a)];
      const double low = 0.95 * joint.minimum[static_cast<Eigen::Index>(a)];
      Curve& angle = motion->turn(static_cast<int>(i), axes[a]);
      for (const auto& [from, to] : {std::array{0.0, high}, std::array{high, low}, std::array{low, 0.0}}) {
        angle.key(t, from);
        t += 0.4 + std::abs(to - from) / 1.2;  // about 70° a second on average
        angle.key(t, to);
      }
      t += 0.3;
    }
  }
  motion->set_duration(t + 0.3);
  return motion;
}

// Poses in many inclinations, each held for two seconds.
std::shared_ptr<const BodyMotion> still(const Skeleton& skeleton, std::uint64_t seed) {
  Random random(seed, "still");
  const int poses = 16;
  const double hold = 2.0;
  const double move = 1.5;
  std::vector<HeldPose> held{{standing(skeleton), 0.0, hold}};
  for (int p = 1; p < poses; ++p) {
    std::vector<Quaterniond> R_joint;
    for (const body::Segment& segment : skeleton.segments) {
      const Vector3d low = 0.7 * segment.joint.minimum;
      const Vector3d high = 0.7 * segment.joint.maximum;
      const auto draw = [&](int axis) { return random.uniform(low[axis], high[axis]); };
      Vector3d phi = Vector3d::Zero();
      if (segment.joint.kind == JointKind::kHinge) {
        phi = segment.joint.axis * draw(0);
      } else if (segment.joint.kind == JointKind::kUniversal) {
        phi = segment.joint.axis * draw(0) + segment.joint.axis2 * draw(1);
      } else if (segment.joint.kind == JointKind::kSpherical) {
        phi = Vector3d(draw(0), draw(1), draw(2));
      }
      R_joint.push_back(geometry::exp_so3(phi));
    }
    HeldPose pose{{}, p * (hold + move), p * (hold + move) + hold};
    for (const body::SegmentPose& segment : body::poses_from_joints(skeleton, R_joint, Vector3d::Zero())) {
      pose.R_WL.push_back(segment.R_WL);
    }
    held.push_back(std::move(pose));
  }
  held.push_back({standing(skeleton), poses * (hold + move), poses * (hold + move) + hold});
  return std::make_shared<PoseMotion>(skeleton, held);
}

}  // namespace

Result<std::shared_ptr<const BodyMotion>> make_builtin_motion(const std::string& name, const Skeleton& skeleton,
                                                              std::uint64_t seed) {
  if (name == "every-joint") {
    return every_joint(skeleton);
  }
  if (name == "still") {
    return still(skeleton, seed);
  }
  if (is_whole_body(skeleton)) {
    if (auto motion = make_body_motion(name, skeleton)) {
      return motion;
    }
    return Error{"is not a built-in motion of a whole body", "\"" + name + "\"", "see limbwave simulate --help"};
  }
  for (const char* segment : {"torso", "upper_arm", "forearm", "hand", "fingers"}) {
    if (skeleton.find(segment) < 0) {
      return Error{
          "needs a segment \"" + std::string(segment) + "\", which the skeleton \"" + skeleton.name + "\" lacks",
          "motion \"" + name + "\"", "use every-joint or still, or the rig line-in-arm"};
    }
  }
  if (name == "arm-raise") {
    return arm_raise(skeleton);
  }
  if (name == "wave") {
    return wave(skeleton);
  }
  if (name == "reach") {
    return reach(skeleton);
  }
  if (name == "walk") {
    return walk(skeleton);
  }
  if (name == "box") {
    return box(skeleton);
  }
  return Error{"is not a built-in motion", "\"" + name + "\"", "see limbwave simulate --help"};
}

}  // namespace limbwave::simulate
