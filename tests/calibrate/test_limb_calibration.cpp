#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/limb_calibration.h"
#include "calibrate/synthetic_sensor.h"

namespace limbwave::calibrate {
namespace {

using test::SyntheticSensor;
using ::testing::HasSubstr;

// An arm of three sensors, the last one mounted a quarter turn about x in the rig.
body::Rig arm() {
  body::Rig rig;
  for (const char* name : {"upper arm", "forearm", "hand"}) {
    body::Accelerometer accelerometer;
    accelerometer.name = name;
    accelerometer.serial = std::string("serial of ") + name;
    rig.accelerometers.push_back(accelerometer);
  }
  rig.accelerometers[2].R_LS = Quaterniond(Eigen::AngleAxisd(kPi / 2.0, Vector3d::UnitX()));
  body::CalibrationGroup group;
  group.name = "Right arm";
  group.sensors = {0, 1, 2};
  group.first = {"horizontal", "", -Vector3d::UnitZ()};
  group.second = {"vertical", "", Vector3d::UnitX()};
  rig.groups.push_back(group);
  return rig;
}

// What the wearer does: truly worn mountings, and how each pose is held.
struct Wearer {
  std::vector<Quaterniond> R_LS;
  SyntheticSensor sensor;
  double tremor = 0.003;  // g
  std::mt19937_64 random{1};

  explicit Wearer(const body::Rig& rig) {
    for (const body::Accelerometer& accelerometer : rig.accelerometers) {
      R_LS.push_back(accelerometer.R_LS);
    }
  }
  // Moves for a second, holds for two, moves again. `off` turns every limb in the limb frame.
  std::vector<decode::AccelerationFrame> hold(const Vector3d& gravity_L,
                                              const Quaterniond& off = Quaterniond::Identity()) {
    std::vector<decode::AccelerationFrame> frames;
    std::normal_distribution<double> normal;
    for (int i = 0; i < 240; ++i) {
      decode::AccelerationFrame frame;
      frame.time_s = time_s;
      time_s += 1.0 / 60.0;
      const bool moving = i < 60 || i >= 180;
      const double swing = moving ? 0.4 * std::sin(0.2 * i) : 0.0;
      for (std::size_t s = 0; s < R_LS.size(); ++s) {
        const Quaterniond sway(Eigen::AngleAxisd(swing, Vector3d(1.0, 1.0, 0.3).normalized()));
        Vector3d f_L = off * sway * Vector3d(-kStandardGravity * gravity_L);
        f_L += tremor * kStandardGravity * Vector3d(normal(random), normal(random), normal(random));
        frame.volts[s] = sensor.volts(R_LS[s].conjugate() * f_L, random);
        frame.usable |= 1U << s;
      }
      frames.push_back(frame);
    }
    time_s += 5.0;
    return frames;
  }
  double time_s = 3.0;
};

Quaterniond turn(double degrees_about, const Vector3d& axis) {
  return Quaterniond(Eigen::AngleAxisd(radians(degrees_about), axis.normalized()));
}

Result<LimbResult> calibrated(Wearer& wearer, const Quaterniond& off_first = Quaterniond::Identity(),
                              const Quaterniond& off_second = Quaterniond::Identity(),
                              const std::vector<int>& sensors = {}) {
  const body::Rig rig = arm();
  LimbCalibrator calibrator(rig, nominal_calibration(rig), 0, sensors);
  calibrator.push(0, wearer.hold(rig.groups[0].first.gravity_L, off_first));
  calibrator.push(1, wearer.hold(rig.groups[0].second.gravity_L, off_second));
  return calibrator.finish("2026-01-01T00:00:00Z");
}

TEST(MountingFromGravity, IsThePapersEquationForItsPoses) {
  const Vector3d a = Vector3d(0.2, -0.5, 0.8).normalized();
  const Vector3d b = a.cross(Vector3d(0.3, 0.9, 0.1)).normalized();
  const auto R_LS = mounting_from_gravity(a, b, -Vector3d::UnitZ(), Vector3d::UnitX());
  ASSERT_TRUE(R_LS);
  Matrix3d paper;
  paper.row(0) = b.transpose();
  paper.row(1) = -a.cross(b).transpose();
  paper.row(2) = -a.transpose();
  EXPECT_LT((R_LS->toRotationMatrix() - paper).norm(), 1e-12);
  EXPECT_LT((*R_LS * a + Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((*R_LS * b - Vector3d::UnitX()).norm(), 1e-12);
}

TEST(MountingFromGravity, RecoversAnyRotationFromAnyPerpendicularPair) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    const Quaterniond R_LS = Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    const Vector3d first_L = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Vector3d second_L = first_L.cross(Vector3d(normal(random), normal(random), normal(random))).normalized();
    const auto found =
        mounting_from_gravity(R_LS.conjugate() * first_L, 2.0 * (R_LS.conjugate() * second_L), first_L, second_L);
    ASSERT_TRUE(found);
    EXPECT_LT(geometry::geodesic_angle(*found, R_LS), 1e-12);
  }
}

TEST(MountingFromGravity, SplitsTheErrorEqually) {
  const Vector3d a = -Vector3d::UnitZ();
  const Vector3d b = turn(6.0, Vector3d::UnitY()) * Vector3d::UnitX();  // tilted towards a: 84° or 96° apart
  const auto R_LS = mounting_from_gravity(a, b, -Vector3d::UnitZ(), Vector3d::UnitX());
  ASSERT_TRUE(R_LS);
  EXPECT_NEAR(degrees(geometry::angle_between(*R_LS * a, -Vector3d::UnitZ())), 3.0, 1e-9);
  EXPECT_NEAR(degrees(geometry::angle_between(*R_LS * b, Vector3d::UnitX())), 3.0, 1e-9);
}

TEST(MountingFromGravity, RefusesParallelAndOpposite) {
  const Vector3d x = Vector3d::UnitX();
  EXPECT_FALSE(mounting_from_gravity(x, x, -Vector3d::UnitZ(), x));
  EXPECT_FALSE(mounting_from_gravity(x, -x, -Vector3d::UnitZ(), x));
  EXPECT_FALSE(mounting_from_gravity(x, Vector3d::UnitY(), x, x));
}

TEST(LimbCalibration, FindsMountingsOfAWholeGroup) {
  Wearer wearer(arm());
  wearer.R_LS[0] = turn(20.0, Vector3d(1.0, 2.0, -1.0)) * wearer.R_LS[0];
  wearer.R_LS[2] = turn(-35.0, Vector3d(0.2, -1.0, 0.4)) * wearer.R_LS[2];
  const auto result = calibrated(wearer);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->verdict, Verdict::kGood);
  ASSERT_EQ(result->sensors.size(), 3U);
  for (const SensorLimbResult& sensor : result->sensors) {
    const auto s = static_cast<std::size_t>(sensor.sensor);
    EXPECT_LT(degrees(geometry::geodesic_angle(sensor.mount.R_LS, wearer.R_LS[s])), 0.1);
    EXPECT_NEAR(sensor.mount.pose_angle_deg, 90.0, 0.2);
    EXPECT_EQ(sensor.mount.method, "two poses");
    EXPECT_EQ(sensor.mount.date, "2026-01-01T00:00:00Z");
    EXPECT_LT(sensor.movement_g, 0.01);
  }
  EXPECT_NEAR(result->sensors[0].from_nominal_deg, 20.0, 0.2);
  // The still second was found although the wearer moved before and after it.
  EXPECT_GE(result->windows[0].begin, 58U);
  EXPECT_LE(result->windows[0].end, 182U);
  EXPECT_TRUE(result->diagnostics.empty());
}

TEST(LimbCalibration, VerdictSaysHowFarThePosesWereOff) {
  struct Case {
    double off_deg;
    Verdict verdict;
  };
  for (const Case& expected : {Case{2.0, Verdict::kGood}, Case{5.0, Verdict::kUsable}, Case{12.0, Verdict::kRepeat}}) {
    Wearer wearer(arm());
    const auto result = calibrated(wearer, Quaterniond::Identity(), turn(expected.off_deg, Vector3d::UnitY()));
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(result->verdict, expected.verdict);
    EXPECT_NEAR(std::abs(result->sensors[1].angle_error_deg), expected.off_deg, 0.2) << result->sensors[1].text;
    EXPECT_THAT(result->sensors[1].text, HasSubstr("° apart"));
  }
}

TEST(LimbCalibration, OneBadSensorIsToldApartAndRepeatedAlone) {
  Wearer wearer(arm());
  const body::Rig rig = arm();
  LimbCalibrator calibrator(rig, nominal_calibration(rig), 0);
  calibrator.push(0, wearer.hold(rig.groups[0].first.gravity_L));
  wearer.R_LS[1] = turn(25.0, Vector3d::UnitY()) * wearer.R_LS[1];  // slipped between the poses
  calibrator.push(1, wearer.hold(rig.groups[0].second.gravity_L));
  const auto result = calibrator.finish();
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->sensors[0].verdict, Verdict::kGood);
  EXPECT_EQ(result->sensors[1].verdict, Verdict::kRepeat) << result->sensors[1].text;
  EXPECT_EQ(result->sensors[2].verdict, Verdict::kGood);
  const auto alone = calibrated(wearer, Quaterniond::Identity(), Quaterniond::Identity(), {1});
  ASSERT_TRUE(alone) << alone.error().text();
  ASSERT_EQ(alone->sensors.size(), 1U);
  EXPECT_EQ(alone->sensors[0].sensor, 1);
  EXPECT_EQ(alone->sensors[0].verdict, Verdict::kGood);
}

TEST(LimbCalibration, RefusesSwappedRepeatedAndOppositePoses) {
  const body::Rig rig = arm();
  const Vector3d horizontal = rig.groups[0].first.gravity_L;
  const Vector3d vertical = rig.groups[0].second.gravity_L;
  struct Case {
    Vector3d first, second;
    const char* message;
  };
  for (const Case& bad : {Case{vertical, horizontal, "wrong order"}, Case{horizontal, horizontal, "are the same"},
                          Case{horizontal, -horizontal, "are opposite"}}) {
    Wearer wearer(rig);
    LimbCalibrator calibrator(rig, nominal_calibration(rig), 0);
    calibrator.push(0, wearer.hold(bad.first));
    calibrator.push(1, wearer.hold(bad.second));
    const auto result = calibrator.finish();
    ASSERT_FALSE(result) << bad.message;
    EXPECT_THAT(result.error().message, HasSubstr(bad.message));
    EXPECT_THAT(result.error().remedy, HasSubstr("\"horizontal\""));
  }
}

TEST(LimbCalibration, RefusesMovementAndLostSignal) {
  const body::Rig rig = arm();
  Wearer wearer(rig);
  wearer.tremor = 0.3;
  LimbCalibrator calibrator(rig, nominal_calibration(rig), 0);
  EXPECT_FALSE(calibrator.finish());
  calibrator.push(0, wearer.hold(rig.groups[0].first.gravity_L));
  const auto moved = calibrator.finish();
  ASSERT_FALSE(moved);
  EXPECT_THAT(moved.error().message, HasSubstr("never held still"));
  EXPECT_THAT(moved.error().place, HasSubstr("horizontal"));
  EXPECT_FALSE(calibrator.progress(0).ready);
  calibrator.clear(0);
  wearer.tremor = 0.003;
  calibrator.push(0, wearer.hold(rig.groups[0].first.gravity_L));
  EXPECT_TRUE(calibrator.progress(0).ready);
  EXPECT_FALSE(calibrator.progress(0).still_now);
  auto lost = wearer.hold(rig.groups[0].second.gravity_L);
  for (std::size_t i = 0; i < lost.size(); i += 20) {
    lost[i].usable = 0;
  }
  calibrator.push(1, lost);
  const auto result = calibrator.finish();
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("lost or clipped"));
}

TEST(LimbCalibration, PoseCheckMeasuresTheErrorAfterwards) {
  const body::Rig rig = arm();
  Wearer wearer(rig);
  const auto result = calibrated(wearer);
  ASSERT_TRUE(result) << result.error().text();
  RigCalibration calibration = nominal_calibration(rig);
  for (const SensorLimbResult& sensor : result->sensors) {
    calibration.mounts[static_cast<std::size_t>(sensor.sensor)] = sensor.mount;
  }
  LimbCalibrator again(rig, calibration, 0);
  again.push(1, wearer.hold(rig.groups[0].second.gravity_L, turn(4.0, Vector3d::UnitZ())));
  const auto checks = again.check(1, calibration);
  ASSERT_TRUE(checks);
  for (const PoseCheck& check : *checks) {
    EXPECT_NEAR(check.error_deg, 4.0, 0.2);
    EXPECT_EQ(check.verdict, Verdict::kUsable);
  }
}

TEST(LimbCalibration, RangeErrorShowsInTheVerdict) {
  Wearer wearer(arm());
  wearer.sensor.offset += Vector3d(0.0, 0.0, 0.05);  // 0.15 g
  const auto result = calibrated(wearer);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(result->sensors[0].verdict, Verdict::kRepeat);
  EXPECT_THAT(result->sensors[0].text, HasSubstr("g at rest"));
}

}  // namespace
}  // namespace limbwave::calibrate
