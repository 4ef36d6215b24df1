#include "simulate/motions.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/so3.h"
#include "simulate/range_turns.h"

namespace limbwave::simulate {
namespace {

body::Skeleton arm() {
  const auto skeleton = body::load_skeleton("arm");
  EXPECT_TRUE(skeleton) << skeleton.error().text();
  return *skeleton;
}

std::shared_ptr<const BodyMotion> builtin(const std::string& name, std::uint64_t seed = 1) {
  const auto motion = make_builtin_motion(name, arm(), seed);
  EXPECT_TRUE(motion) << motion.error().text();
  return *motion;
}

constexpr const char* kNames[] = {"arm-raise", "wave", "reach", "walk", "box", "every-joint", "still"};

TEST(Motions, StartAndEndAtRestInTheSamePlace) {
  for (const char* name : kNames) {
    const auto motion = builtin(name);
    ASSERT_GT(motion->duration(), 5.0) << name;
    for (int segment = 0; segment < 5; ++segment) {
      for (const double t : {0.0, motion->duration()}) {
        const QuaternionJet q = motion->rotation(segment, t);
        EXPECT_LT(q.d.norm(), 1e-9) << name;
        EXPECT_LT(q.dd.norm(), 1e-9) << name;
      }
    }
    EXPECT_LT((motion->root_position(0.0).v - motion->root_position(motion->duration()).v).norm(), 1e-9) << name;
  }
}

TEST(Motions, RotationsStayUnitWithTheirDerivatives) {
  for (const char* name : kNames) {
    const auto motion = builtin(name);
    const double h = 1e-4;
    for (double t = 0.1; t < motion->duration(); t += 0.173) {
      for (int segment = 0; segment < 5; ++segment) {
        const QuaternionJet q = motion->rotation(segment, t);
        ASSERT_NEAR(q.v.norm(), 1.0, 1e-9);
        const Eigen::Vector4d before = motion->rotation(segment, t - h).v.coeffs();
        const Eigen::Vector4d after = motion->rotation(segment, t + h).v.coeffs();
        ASSERT_LT((q.d.coeffs() - (after - before) / (2 * h)).norm(), 1e-3) << name << " at " << t;
        ASSERT_LT((q.dd.coeffs() - (after - 2 * q.v.coeffs() + before) / (h * h)).norm(), 0.05) << name << " at " << t;
      }
    }
  }
}

TEST(Motions, MoveTheArmAsTheirNamesSay) {
  const body::Skeleton skeleton = arm();
  const int hand = skeleton.find("hand");
  const auto hand_at = [&](const BodyMotion& motion, double t) {
    std::vector<Quaterniond> R_WL;
    for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
      const int parent = skeleton.segments[i].parent;
      const Quaterniond R = motion.rotation(static_cast<int>(i), t).v;
      R_WL.push_back(parent < 0 ? R : R_WL[static_cast<std::size_t>(parent)] * R);
    }
    return body::poses_from_orientations(skeleton, R_WL, motion.root_position(t).v)[static_cast<std::size_t>(hand)]
        .p_WL;
  };
  const auto raise = builtin("arm-raise");
  const Vector3d hanging = hand_at(*raise, 0.0);
  const Vector3d forward = hand_at(*raise, 3.0);
  EXPECT_GT(forward.x(), hanging.x() + 0.45);  // stretched forward ...
  EXPECT_GT(forward.z(), hanging.z() + 0.45);  // ... and level
  const Vector3d sideways = hand_at(*raise, 14.5);
  EXPECT_LT(sideways.y(), hanging.y() - 0.45);  // the right arm goes to the right, −y

  const auto reach = builtin("reach");
  const Vector3d glass = hand_at(*reach, 3.0);
  const Vector3d mouth = hand_at(*reach, 6.5);
  EXPECT_GT(glass.x(), mouth.x() + 0.2);
  EXPECT_GT(mouth.z(), 1.3);
}

TEST(Motions, EveryJointVisitsEveryDegreeOfFreedom) {
  const body::Skeleton skeleton = arm();
  const auto motion = builtin("every-joint");
  std::vector<Vector3d> low(5, Vector3d::Zero());
  std::vector<Vector3d> high(5, Vector3d::Zero());
  for (double t = 0.0; t < motion->duration(); t += 0.01) {
    for (std::size_t i = 0; i < 5; ++i) {
      const Vector3d phi =
          geometry::log_so3(skeleton.segments[i].R_PL_rest.conjugate() * motion->rotation(static_cast<int>(i), t).v);
      low[i] = low[i].cwiseMin(phi);
      high[i] = high[i].cwiseMax(phi);
    }
  }
  for (std::size_t i = 0; i < 5; ++i) {
    const body::Joint& joint = skeleton.segments[i].joint;
    if (joint.kind == body::JointKind::kSpherical) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(low[i][axis], 0.95 * joint.minimum[axis], 0.02) << skeleton.segments[i].name;
        EXPECT_NEAR(high[i][axis], 0.95 * joint.maximum[axis], 0.02) << skeleton.segments[i].name;
      }
    } else {
      EXPECT_GT((high[i] - low[i]).maxCoeff(), 0.9 * (joint.maximum[0] - joint.minimum[0]))
          << skeleton.segments[i].name;
    }
  }
}

TEST(Motions, StillHoldsPosesOfManyInclinations) {
  const auto motion = builtin("still", 3);
  std::vector<Vector3d> ups;
  for (int pose = 0; pose < 17; ++pose) {
    const double begin = pose * 3.5;
    Quaterniond R = Quaterniond::Identity();
    for (int segment = 0; segment < 2; ++segment) {
      for (double t = begin + 0.01; t < begin + 1.99; t += 0.2) {
        ASSERT_EQ(motion->rotation(segment, t).d.norm(), 0.0);
      }
      R = R * motion->rotation(segment, begin + 1.0).v;
    }
    ups.emplace_back(R.conjugate() * Vector3d::UnitZ());
  }
  double widest = 0.0;
  for (const Vector3d& a : ups) {
    for (const Vector3d& b : ups) {
      widest = std::max(widest, geometry::angle_between(a, b));
    }
  }
  EXPECT_GT(widest, radians(90.0));
  EXPECT_GT(geometry::geodesic_angle(motion->rotation(1, 4.0).v, builtin("still", 4)->rotation(1, 4.0).v), 0.01);
}

TEST(Motions, RefuseWhatTheyCannotDo) {
  EXPECT_FALSE(make_builtin_motion("somersault", arm(), 1));
  body::Skeleton stick = arm();
  stick.segments.resize(1);
  EXPECT_FALSE(make_builtin_motion("wave", stick, 1));
  EXPECT_TRUE(make_builtin_motion("every-joint", stick, 1));
}

TEST(RangeTurns, CoverTheSphereAndPassExactlyThroughTheAxes) {
  const Quaterniond rest = geometry::exp_so3({0.4, -1.0, 0.3});
  std::vector<Vector3d> ups;
  Vector3d low = Vector3d::Zero();
  Vector3d high = Vector3d::Zero();
  double fastest = 0.0;
  for (double t = 0.0; t < range_seconds(); t += 0.005) {
    const QuaternionJet R = range_rotation(t, rest);
    ASSERT_NEAR(R.v.norm(), 1.0, 1e-9);
    ups.emplace_back(R.v.conjugate() * Vector3d::UnitZ());
    low = low.cwiseMin(ups.back());
    high = high.cwiseMax(ups.back());
    fastest = std::max(fastest, 2.0 * R.d.norm());
  }
  EXPECT_LT((low + Vector3d::Ones()).norm(), 1e-4);
  EXPECT_LT((high - Vector3d::Ones()).norm(), 1e-4);
  EXPECT_LT(degrees(fastest), 180.0);  // slowly
  EXPECT_LT(geometry::geodesic_angle(range_rotation(0.0, rest).v, rest), 1e-9);
  EXPECT_LT(geometry::geodesic_angle(range_rotation(range_seconds(), rest).v, rest), 1e-9);
  // Every direction, on a grid about 12° apart, has been nearly visited.
  for (int k = 0; k < 300; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / 300.0;
    const double a = k * kPi * (3.0 - std::sqrt(5.0));
    const Vector3d direction(std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z);
    double nearest = kPi;
    for (const Vector3d& up : ups) {
      nearest = std::min(nearest, geometry::angle_between(direction, up));
    }
    EXPECT_LT(degrees(nearest), 24.0) << direction.transpose();
  }
}

TEST(RangeTurns, JerksAreShortAndLeaveNoSpeed) {
  Vector3d speed = Vector3d::Zero();
  double moving = 0.0;
  double peak = 0.0;
  for (double t = 0.0; t < range_seconds(); t += 1e-4) {
    const Vector3d a = range_jerk(t);
    speed += a * 1e-4;
    moving += a.norm() > 0.1 ? 1e-4 : 0.0;
    peak = std::max(peak, a.norm());
  }
  EXPECT_LT(speed.norm(), 1e-3);
  EXPECT_LT(moving, 0.6);
  EXPECT_GT(peak, kStandardGravity);
}

}  // namespace
}  // namespace limbwave::simulate
