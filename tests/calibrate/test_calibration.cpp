#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/units.h"
#include "calibrate/calibration.h"
#include "calibrate/sphere_coverage.h"
#include "geometry/so3.h"

namespace limbwave::calibrate {
namespace {

using ::testing::HasSubstr;

RigCalibration example() {
  RigCalibration calibration;
  SensorCalibration sensor;
  sensor.serial = "LW-0017";
  sensor.method = "ellipsoid";
  sensor.date = "2026-02-03T04:05:06Z";
  sensor.offset = Vector3d(1.31, 1.0 / 3.0, 1.4);
  sensor.M << 29.7, 0.1, -0.2, 0.1, 30.1, 0.3, -0.2, 0.3, 1e2 / 3.0;
  sensor.residual_g = 0.0012;
  sensor.coverage = 0.9375;
  calibration.sensors = {sensor, sensor};
  MountCalibration mount;
  mount.sensor = "forearm";
  mount.method = "two poses";
  mount.date = "2026-02-03T04:06:07Z";
  mount.R_LS = Quaterniond(0.1, 0.7, -0.3, 0.4).normalized();
  mount.pose_angle_deg = 88.7;
  mount.stillness_g = 0.004;
  calibration.mounts = {mount, mount};
  return calibration;
}

TEST(Calibration, JsonRoundTripKeepsEveryBit) {
  const RigCalibration before = example();
  const std::string text = calibration_to_json(before).dump();
  const auto after = calibration_from_json(nlohmann::json::parse(text), "file.json");
  ASSERT_TRUE(after) << after.error().text();
  ASSERT_EQ(after->sensors.size(), 2U);
  EXPECT_EQ(after->sensors[0].offset, before.sensors[0].offset);
  EXPECT_EQ(after->sensors[0].M, before.sensors[0].M);
  EXPECT_EQ(after->sensors[1].serial, "LW-0017");
  EXPECT_EQ(after->sensors[1].date, before.sensors[1].date);
  EXPECT_EQ(after->sensors[1].residual_g, before.sensors[1].residual_g);
  EXPECT_EQ(after->mounts[0].R_LS.coeffs(), before.mounts[0].R_LS.coeffs());
  EXPECT_EQ(after->mounts[0].pose_angle_deg, 88.7);
  EXPECT_EQ(calibration_to_json(*after).dump(), text);
}

TEST(Calibration, ErrorsNameTheKey) {
  struct Case {
    const char* path;
    nlohmann::json value;
    const char* message;
  };
  const std::vector<Case> cases = {
      {"/sensors/1/offset_volts", {1.0, 2.0}, "2 values instead of 3"},
      {"/sensors/0/m_s2_per_volt", {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, "singular or mirrors"},
      {"/sensors/0/m_s2_per_volt", {{1, 0, 0}, {0, 1, 0}}, "three rows"},
      {"/sensors/0/coverage", 1.5, "outside 0 to 1"},
      {"/sensors/0/residual_g", "small", "not a number"},
      {"/mounts/1/R_LS", {1.0, 1.0, 0.0, 0.0}, "not a unit quaternion"},
      {"/mounts/0/sensor", 7, "not a text"},
      {"/mounts/0/colour", "red", "not a known key"},
  };
  for (const Case& bad : cases) {
    nlohmann::json json = calibration_to_json(example());
    json[nlohmann::json::json_pointer(bad.path)] = bad.value;
    const auto result = calibration_from_json(json, "file.json");
    ASSERT_FALSE(result) << bad.path;
    EXPECT_THAT(result.error().text(), HasSubstr(std::string("file.json: ") + bad.path));
    EXPECT_THAT(result.error().message, HasSubstr(bad.message));
  }
  nlohmann::json missing = calibration_to_json(example());
  missing["mounts"].erase(1);
  EXPECT_FALSE(calibration_from_json(missing, "file.json"));
  EXPECT_FALSE(calibration_from_json(nlohmann::json::array(), "file.json"));
}

TEST(Calibration, NominalTurnsVoltsIntoSpecificForce) {
  body::Rig rig;
  body::Accelerometer accelerometer;
  accelerometer.name = "hand";
  accelerometer.R_LS = Quaterniond(0.0, 1.0, 0.0, 0.0);
  rig.accelerometers = {accelerometer};
  const RigCalibration calibration = nominal_calibration(rig);
  ASSERT_EQ(calibration.sensors.size(), 1U);
  EXPECT_EQ(calibration.sensors[0].method, "nominal");
  EXPECT_EQ(calibration.mounts[0].sensor, "hand");
  EXPECT_EQ(calibration.mounts[0].R_LS.coeffs(), accelerometer.R_LS.coeffs());
  // Volts are relative to the reference slot: 0 g is 1.65 − 0.33 V, 1 g upward on z another 0.33 V.
  const Vector3d f = calibration.sensors[0].apply(Vector3d(1.32, 1.32, 1.65));
  EXPECT_LT((f - Vector3d(0.0, 0.0, kStandardGravity)).norm(), 1e-12);
}

TEST(SphereCoverage, CellsHaveEqualAreaAndContainTheirCentres) {
  std::array<int, SphereCoverage::kCells> count{};
  constexpr int kPoints = 480000;
  for (int i = 0; i < kPoints; ++i) {  // a Fibonacci lattice is uniform on the sphere
    const double z = 1.0 - (2.0 * i + 1.0) / kPoints;
    const double azimuth = i * kPi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    ++count[static_cast<std::size_t>(
        SphereCoverage::cell_of(Vector3d(r * std::cos(azimuth), r * std::sin(azimuth), z)))];
  }
  for (int cell = 0; cell < SphereCoverage::kCells; ++cell) {
    EXPECT_NEAR(count[static_cast<std::size_t>(cell)], kPoints / SphereCoverage::kCells, 100) << cell;
    EXPECT_EQ(SphereCoverage::cell_of(SphereCoverage::centre(cell)), cell);
  }
  for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(-1, 0, 0), Vector3d(-1, -0.0, 0)}) {
    const int cell = SphereCoverage::cell_of(axis);
    EXPECT_LT(degrees(geometry::angle_between(SphereCoverage::centre(cell), axis)), 30.0);
  }
}

TEST(SphereCoverage, TellsWhatIsMissing) {
  SphereCoverage coverage(0.1);
  EXPECT_EQ(coverage.fraction(), 0.0);
  EXPECT_EQ(coverage.missing().size(), 48U);
  for (int cell = 0; cell < SphereCoverage::kCells; ++cell) {
    if (SphereCoverage::centre(cell).x() > -0.5) {
      coverage.add(SphereCoverage::centre(cell), 0.06);
      coverage.add(SphereCoverage::centre(cell), 0.06);
    }
  }
  EXPECT_GT(coverage.fraction(), 0.6);
  EXPECT_LT(coverage.fraction(), 0.9);
  EXPECT_GT(coverage.missing().front().dot(-Vector3d::UnitX()), 0.8);
  EXPECT_GT(degrees(coverage.largest_hole()), 30.0);
  coverage.add(Vector3d::Zero(), 1.0);  // no direction
}

TEST(SphereCoverage, SaysDirectionsInWords) {
  EXPECT_EQ(direction_words(Vector3d(0.1, 0.0, 2.0)), "+z up");
  EXPECT_EQ(direction_words(Vector3d(-1.0, 0.2, 0.1)), "−x up");
  EXPECT_EQ(direction_words(Vector3d(1.0, 0.1, -1.0)), "between +x and −z up");
  EXPECT_EQ(direction_words(Vector3d(1.0, -1.0, 1.0)), "the corner of +x, −y and +z up");
}

}  // namespace
}  // namespace limbwave::calibrate
