#include "simulate/wearer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::simulate {
namespace {

const Vector3d kGravityUp(0.0, 0.0, kStandardGravity);

std::shared_ptr<const Wearer> wearer(const SimulateSettings& settings) {
  const auto rig = body::load_rig("line-in-arm");
  EXPECT_TRUE(rig) << rig.error().text();
  const auto made = Wearer::create(settings, *rig, *body::load_skeleton(rig->skeleton));
  EXPECT_TRUE(made) << made.error().text();
  return made ? *made : nullptr;
}

SimulateSettings just(const std::string& motion) {
  SimulateSettings settings;
  settings.motion = motion;
  settings.prologue = false;
  return settings;
}

// The acceleration that the sensor's path really has, by the five-point formula.
Vector3d differenced(const Wearer& w, int sensor, double t) {
  const double h = 2e-4;
  const auto p = [&](int k) { return w.sensor_position(sensor, t + k * h); };
  return (-p(-2) + 16.0 * p(-1) - 30.0 * p(0) + 16.0 * p(1) - p(2)) / (12.0 * h * h);
}

// Specific force in the world from the sensor's own numbers: without soft tissue R_WS is R_WL · R_LS.
Vector3d felt_in_world(const Wearer& w, int sensor, double t) {
  const ActualSensor& actual = w.sensors()[static_cast<std::size_t>(sensor)];
  return *w.orientation(actual.segment, t) * (actual.R_LS * w.specific_force(sensor, t));
}

void expect_newton(const Wearer& w, double from, double to, double step) {
  for (double t = from; t < to; t += step) {
    for (int sensor = 0; sensor < 5; ++sensor) {
      const Vector3d expected = differenced(w, sensor, t) + kGravityUp;
      ASSERT_LT((felt_in_world(w, sensor, t) - expected).norm(), 2e-3 + 1e-4 * expected.norm())
          << "sensor " << sensor << " at " << t;
    }
  }
}

TEST(Wearer, FeelsTheSecondDerivativeOfItsPathMinusGravity) {
  for (const char* motion : {"arm-raise", "wave", "reach", "walk", "box", "every-joint", "still"}) {
    SimulateSettings settings = just(motion);
    settings.errors.mount_angle = 0.1;
    settings.errors.mount_offset = 0.02;
    const auto w = wearer(settings);
    SCOPED_TRACE(motion);
    expect_newton(*w, 0.01, w->duration(), 0.097);
  }
}

TEST(Wearer, StillPosesFeelExactlyGravity) {
  const auto w = wearer(just("still"));
  for (int pose = 0; pose < 17; ++pose) {
    for (int sensor = 0; sensor < 5; ++sensor) {
      const double t = pose * 3.5 + 1.0;
      EXPECT_LT((felt_in_world(*w, sensor, t) - kGravityUp).norm(), 1e-9);
      EXPECT_NEAR(w->specific_force(sensor, t).norm(), kStandardGravity, 1e-9);
    }
  }
}

TEST(Wearer, BoxingIsRoughAndWavingIsNot) {
  const auto strongest = [](const Wearer& w) {
    double peak = 0.0;
    for (double t = 0.0; t < w.duration(); t += 0.005) {
      peak = std::max(peak, (w.specific_force(3, t)).norm());
    }
    return peak / kStandardGravity;
  };
  EXPECT_GT(strongest(*wearer(just("box"))), 3.0);  // beyond the sensor's range
  EXPECT_LT(strongest(*wearer(just("arm-raise"))), 1.5);
}

TEST(Wearer, ProloguePosesShowGravityWhereTheRigSays) {
  SimulateSettings settings;
  settings.motion = "reach";
  const auto w = wearer(settings);
  const auto rig = body::load_rig("line-in-arm");
  int poses = 0;
  for (const ScriptSegment& segment : w->segments()) {
    for (const body::CalibrationGroup& group : rig->groups) {
      for (const bool first : {true, false}) {
        if (segment.name != "pose:" + group.name + (first ? ":first" : ":second")) {
          continue;
        }
        ++poses;
        EXPECT_NEAR(segment.end_s - segment.start_s, 3.0, 1e-9);
        const Vector3d gravity = first ? group.first.gravity_L : group.second.gravity_L;
        for (const int sensor : group.sensors) {
          for (const double t : {segment.start_s + 0.01, segment.end_s - 0.01}) {
            EXPECT_LT((w->specific_force(sensor, t) / kStandardGravity + gravity).norm(), 1e-9) << segment.name;
          }
        }
      }
    }
  }
  EXPECT_EQ(poses, 4);
  EXPECT_EQ(w->segments().front().name, "range");
  EXPECT_EQ(w->segments().back().name, "capture");
  for (std::size_t i = 1; i < w->segments().size(); ++i) {
    EXPECT_GT(w->segments()[i].start_s, w->segments()[i - 1].end_s);
  }
}

TEST(Wearer, PosesOfAnInexactWearerAreOffByThatAngle) {
  SimulateSettings settings;
  settings.errors.pose_angle = radians(5.0);
  const auto w = wearer(settings);
  const auto rig = body::load_rig("line-in-arm");
  for (const ScriptSegment& segment : w->segments()) {
    if (segment.name == "pose:Right arm:first") {
      for (const int sensor : rig->groups[0].sensors) {
        const Vector3d f = w->specific_force(sensor, segment.start_s + 1.0);
        EXPECT_NEAR(degrees(geometry::angle_between(f, -rig->groups[0].first.gravity_L)), 5.0, 1e-6);
      }
    }
  }
}

TEST(Wearer, RangeCalibrationTurnsEverySensorInPlace) {
  const auto w = wearer(just("range"));
  const ScriptSegment range = w->segments().front();
  ASSERT_EQ(range.name, "range");
  int exact = 0;
  int total = 0;
  Vector3d low = Vector3d::Zero();
  Vector3d high = Vector3d::Zero();
  for (double t = range.start_s; t < range.end_s; t += 0.01) {
    const Vector3d f = w->specific_force(2, t) / kStandardGravity;
    exact += std::abs(f.norm() - 1.0) < 1e-9 ? 1 : 0;
    ++total;
    if (std::abs(f.norm() - 1.0) < 1e-9) {
      low = low.cwiseMin(f);
      high = high.cwiseMax(f);
    }
    EXPECT_FALSE(w->orientation(2, t));
  }
  EXPECT_GT(exact, total * 97 / 100);
  EXPECT_LT(exact, total);  // the jerks
  EXPECT_LT((low + Vector3d::Ones()).norm(), 1e-3);
  EXPECT_LT((high - Vector3d::Ones()).norm(), 1e-3);
}

TEST(Wearer, NothingJumpsFromBeginningToEndAndIntoTheNextRound) {
  SimulateSettings settings;
  settings.motion = "wave";
  settings.errors.soft_tissue_angle = radians(1.5);
  settings.errors.soft_tissue_offset = 0.004;
  const auto w = wearer(settings);
  const double h = 1e-3;
  for (int sensor = 0; sensor < 5; ++sensor) {
    Vector3d before = w->specific_force(sensor, 0.0);
    for (double t = h; t < w->duration() + 20.0; t += h) {
      const Vector3d now = w->specific_force(sensor, t);
      ASSERT_LT((now - before).norm(), 2.0) << "sensor " << sensor << " at " << t;  // jerks: 15 m/s² in 20 ms
      before = now;
    }
  }
}

TEST(Wearer, SoftTissueMovesInStepWithTheLimb) {
  SimulateSettings settings = just("reach");
  const auto firm = wearer(settings);
  settings.errors.soft_tissue_angle = radians(1.5);
  settings.errors.soft_tissue_offset = 0.004;
  const auto soft = wearer(settings);
  double largest = 0.0;
  double smallest = 10.0;
  double moved = 0.0;
  for (double t = 0.0; t < soft->duration(); t += 0.05) {
    const double angle = geometry::angle_between(firm->specific_force(2, t), soft->specific_force(2, t));
    largest = std::max(largest, angle);
    smallest = std::min(smallest, angle);
    moved = std::max(moved, (firm->sensor_position(2, t) - soft->sensor_position(2, t)).norm());
    ASSERT_LT(geometry::geodesic_angle(*firm->orientation(2, t), *soft->orientation(2, t)), 1e-9);  // bones don't
  }
  EXPECT_GT(degrees(largest), 0.7);
  EXPECT_LT(degrees(largest), 4.0);
  EXPECT_GT(moved, 0.002);
  EXPECT_LT(moved, 0.004 * 1.8);
  EXPECT_EQ((soft->specific_force(2, 0.1) - soft->specific_force(2, 0.2)).norm(), 0.0) << "still when the limb is";
}

TEST(Wearer, LengthIsTheMotionsOwnOrAsAsked) {
  SimulateSettings settings = just("wave");
  const double own = wearer(settings)->duration();
  EXPECT_GT(own, 8.0);
  settings.seconds = 3.0;
  EXPECT_DOUBLE_EQ(wearer(settings)->duration(), 3.0);
  settings.seconds = 60.0;
  const auto longer = wearer(settings);
  EXPECT_DOUBLE_EQ(longer->duration(), 60.0);
  const double round = own + 2.0;  // with the way back to the beginning
  EXPECT_LT((longer->specific_force(3, 5.0) - longer->specific_force(3, 5.0 + round)).norm(), 1e-6);
}

class Bvh : public testing::TestWithParam<const char*> {};

TEST_P(Bvh, GivesSmoothMotionsThatObeyNewton) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  const std::filesystem::path file = std::filesystem::path(data == nullptr ? "" : data) / "motions" / GetParam();
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "needs " << file;
  }
  const auto w = wearer(just(file.string()));
  ASSERT_TRUE(w);
  expect_newton(*w, 0.0, w->duration(), 0.31);
  // It stays a human: upright at least half of the time, never beyond 20 g at the hand.
  int upright = 0;
  int total = 0;
  for (double t = 0.0; t < w->duration(); t += 0.05) {
    upright += (*w->orientation(0, t) * Vector3d::UnitX()).z() > 0.7 ? 1 : 0;
    ++total;
    ASSERT_LT(w->specific_force(3, t).norm(), 20.0 * kStandardGravity) << t;
  }
  EXPECT_GT(upright, total / 2);
  const Vector3d forward = *w->orientation(0, 0.0) * -Vector3d::UnitZ();
  EXPECT_GT(Vector3d(forward.x(), forward.y(), 0.0).normalized().x(), 0.95);
}

INSTANTIATE_TEST_SUITE_P(Files, Bvh, testing::Values("02_01.bvh", "02_05.bvh", "12_01_walk.bvh", "01_08.bvh"));

TEST(Wearer, ArmHangsWhileWalkingInAnyFilesFrames) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  for (const char* name : {"02_01.bvh", "12_01_walk.bvh"}) {
    const std::filesystem::path file = std::filesystem::path(data == nullptr ? "" : data) / "motions" / name;
    if (!std::filesystem::exists(file)) {
      GTEST_SKIP() << "needs " << file;
    }
    const auto w = wearer(just(file.string()));
    for (double t = 0.0; t < w->duration(); t += 0.1) {
      const Vector3d upper_arm = *w->orientation(1, t) * Vector3d::UnitX();
      const Vector3d forearm = *w->orientation(2, t) * Vector3d::UnitX();
      EXPECT_LT(upper_arm.z(), -0.7) << name << " " << t;
      EXPECT_LT(forearm.z(), 0.2) << name << " " << t;
    }
  }
}

TEST(Wearer, RefusesMotionsItCannotFind) {
  const auto rig = body::load_rig("line-in-arm");
  const auto skeleton = body::load_skeleton(rig->skeleton);
  for (const char* motion : {"somersault", "missing.bvh", "missing.csv", "missing.csv.gz", "a.csv;b.csv", "/"}) {
    const auto made = Wearer::create(just(motion), *rig, *skeleton);
    ASSERT_FALSE(made) << motion;
    EXPECT_FALSE(made.error().message.empty());
  }
}

}  // namespace
}  // namespace limbwave::simulate
