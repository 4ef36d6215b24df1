/// Which calibration a solve uses, and what it says about it.
#include "solve/take_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/units.h"
#include "solve/codes.h"
#include "solve/solve.h"
#include "support/simulated_take.h"
#include "take/calibration_library.h"

namespace limbwave::solve {
namespace {

using test::codes;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing_support::require;

class TakeCalibration : public testing::Test {
 protected:
  // No test sees the library of whoever runs it.
  void SetUp() override { ::setenv("LIMBWAVE_HOME", (folder / "home").c_str(), 1); }
  void TearDown() override { ::unsetenv("LIMBWAVE_HOME"); }

  // A short take with its own calibration movements, decoded.
  void simulate(double pose_angle_deg, bool prologue = true) {
    simulate::SimulateSettings settings;
    settings.errors = require(simulate::load_errors("accurate"));
    settings.errors.pose_angle = radians(pose_angle_deg);
    settings.seconds = 2.0;
    settings.prologue = prologue;
    take = testing_support::simulated(folder / "wave.take", settings);
    decoded = require(decode_take(take, {}, {}));
  }

  [[nodiscard]] ChosenCalibration chosen(const std::string& wanted) const {
    return require(choose_calibration(take, decoded, wanted));
  }
  [[nodiscard]] std::vector<std::string> mount_methods(const calibrate::RigCalibration& calibration) const {
    std::vector<std::string> methods;
    for (const calibrate::MountCalibration& mount : calibration.mounts) {
      methods.push_back(mount.method);
    }
    return methods;
  }
  calibrate::RigCalibration measured() const {
    calibrate::RigCalibration calibration = calibrate::nominal_calibration(take.info.rig);
    for (std::size_t s = 0; s < calibration.sensors.size(); ++s) {
      calibration.sensors[s].method = "ellipsoid";
      calibration.sensors[s].date = "2026-02-03T04:05:06Z";
      calibration.mounts[s].method = "two poses";
      calibration.mounts[s].date = "2026-02-03T04:05:06Z";
    }
    return calibration;
  }

  test::TemporaryFolder folder;
  take::Take take;
  DecodedTake decoded;
};

TEST_F(TakeCalibration, AutoTakesTheMovementsOfTheTake) {
  simulate(0.0);
  const ChosenCalibration calibration = chosen("auto");
  EXPECT_EQ(calibration.source, "segments");
  EXPECT_THAT(mount_methods(calibration.calibration), Each("two poses"));
  EXPECT_THAT(calibration.explanation, HasSubstr("range of 5 of 5 sensors"));
  EXPECT_THAT(calibration.explanation, HasSubstr("mounting of 5"));
  EXPECT_THAT(codes(calibration.diagnostics), Not(Contains("calibration.limb-poor")));
  for (const calibrate::SensorCalibration& sensor : calibration.calibration.sensors) {
    EXPECT_NE(sensor.method, "nominal");
  }
}

TEST_F(TakeCalibration, PosesThatTheirProcedureWouldRepeatAreUsedButTold) {
  simulate(14.0);
  const ChosenCalibration calibration = chosen("auto");
  int poor = 0;
  for (std::size_t g = 0; g < take.info.rig.groups.size(); ++g) {
    const auto pose = [&](int index) {
      const std::string name = pose_segment(take.info.rig.groups[g], index);
      return decoded.of(take, *std::find_if(take.info.segments.begin(), take.info.segments.end(),
                                            [&](const take::TakeSegment& segment) { return segment.name == name; }));
    };
    const calibrate::LimbResult limb =
        require(calibrate_limb(take, static_cast<int>(g), pose(0), pose(1), calibration.calibration));
    for (const calibrate::SensorLimbResult& sensor : limb.sensors) {
      if (sensor.verdict == calibrate::Verdict::kRepeat) {
        ++poor;
        const std::string name = take.info.rig.accelerometers[static_cast<std::size_t>(sensor.sensor)].name;
        EXPECT_THAT(calibration.diagnostics,
                    Contains(testing::AllOf(testing::Field(&Diagnostic::code, "calibration.limb-poor"),
                                            testing::Field(&Diagnostic::place, name),
                                            testing::Field(&Diagnostic::severity, Severity::kWarning),
                                            testing::Field(&Diagnostic::message, HasSubstr(sensor.text)))));
      }
    }
  }
  ASSERT_GT(poor, 0) << "poses 14° off are not poor enough for this test";
  EXPECT_EQ(std::count_if(calibration.diagnostics.begin(), calibration.diagnostics.end(),
                          [](const Diagnostic& finding) { return finding.code == "calibration.limb-poor"; }),
            poor);
  // The solve passes it on.
  EXPECT_THAT(codes(require(solve_take(take, {}, {})).report.diagnostics), Contains("calibration.limb-poor"));
}

TEST_F(TakeCalibration, AMountingThatThePosesDidNotGiveIsNotInstalled) {
  simulate(0.0);
  // The second sensor of the first group reads the same in both poses, as one that was held still by hand would.
  const body::CalibrationGroup& group = take.info.rig.groups.front();
  const auto sensor = static_cast<std::size_t>(group.sensors.at(1));
  Eigen::Vector3d volts = Eigen::Vector3d::Zero();
  for (int pose = 0; pose < 2; ++pose) {
    const auto segment =
        std::find_if(take.info.segments.begin(), take.info.segments.end(),
                     [&](const take::TakeSegment& other) { return other.name == pose_segment(group, pose); });
    ASSERT_NE(segment, take.info.segments.end());
    const double begin = take.info.format.rate.seconds(segment->first).value;
    const double end = take.info.format.rate.seconds(segment->first + segment->count).value;
    for (decode::AccelerationFrame& frame : decoded.frames) {
      if (frame.time_s >= begin && frame.time_s < end) {
        volts = volts.isZero() ? frame.volts[sensor] : volts;
        frame.volts[sensor] = volts;
      }
    }
  }
  const ChosenCalibration calibration = chosen("auto");
  std::vector<std::string> expected(5, "two poses");
  expected[sensor] = "nominal";
  EXPECT_EQ(mount_methods(calibration.calibration), expected);
  EXPECT_THAT(calibration.explanation, HasSubstr("mounting of 4"));
  EXPECT_THAT(calibration.diagnostics,
              Contains(testing::AllOf(testing::Field(&Diagnostic::code, "calibration.limb-poor"),
                                      testing::Field(&Diagnostic::place, take.info.rig.accelerometers[sensor].name))));
}

TEST_F(TakeCalibration, MovementsThatGiveNothingAreToldOf) {
  simulate(0.0);
  // Every sensor reads the same all the time, as on a table.
  for (decode::AccelerationFrame& frame : decoded.frames) {
    frame.volts = decoded.frames.front().volts;
  }
  const ChosenCalibration calibration = chosen("auto");
  EXPECT_EQ(calibration.source, "nominal");
  EXPECT_THAT(codes(calibration.diagnostics),
              testing::IsSupersetOf({"calibration.range-failed", "calibration.limb-failed", "calibration.none"}));
  EXPECT_THAT(choose_calibration(take, decoded, "segments").error().message, HasSubstr("range calibration failed"));

  require(take::CalibrationLibrary().save(take.info.rig, take.info.subject, measured()));
  EXPECT_EQ(chosen("auto").source, "library");
  EXPECT_THAT(codes(chosen("auto").diagnostics), Contains("calibration.range-failed"));
}

TEST_F(TakeCalibration, EverySourceByName) {
  simulate(0.0, false);
  EXPECT_THAT(choose_calibration(take, decoded, "segments").error().message, HasSubstr("no calibration segments"));
  EXPECT_THAT(choose_calibration(take, decoded, "snapshot").error().message, HasSubstr("no calibration in it"));
  EXPECT_THAT(choose_calibration(take, decoded, "library").error().message, HasSubstr("library has nothing for rig"));
  EXPECT_FALSE(choose_calibration(take, decoded, "oracle"));
  EXPECT_EQ(chosen("nominal").source, "nominal");
  EXPECT_THAT(codes(chosen("nominal").diagnostics), testing::IsEmpty()) << "asked for";
  EXPECT_EQ(chosen("auto").source, "nominal");
  EXPECT_THAT(codes(chosen("auto").diagnostics), Contains("calibration.none"));

  require(take::CalibrationLibrary().save(take.info.rig, take.info.subject, measured()));
  EXPECT_EQ(chosen("auto").source, "library");
  EXPECT_EQ(chosen("library").source, "library");

  take.info.calibration = calibrate::nominal_calibration(take.info.rig);
  EXPECT_EQ(chosen("auto").source, "library") << "a nominal snapshot says nothing";
  take.info.calibration = measured();
  EXPECT_EQ(chosen("auto").source, "snapshot");
  EXPECT_THAT(chosen("snapshot").explanation, HasSubstr("2026-02-03"));
}

TEST_F(TakeCalibration, ASnapshotIsCompletedFromTheMovementsAndOtherwiseKept) {
  simulate(0.0);
  take.info.calibration = measured();
  EXPECT_EQ(chosen("auto").source, "snapshot") << "nothing is missing";
  take.info.calibration->sensors[2].method = "nominal";
  take.info.calibration->mounts[4].method = "nominal";
  const ChosenCalibration calibration = chosen("auto");
  EXPECT_EQ(calibration.source, "segments");
  for (std::size_t s = 0; s < 5; ++s) {
    const bool is_kept = calibration.calibration.sensors[s].date == "2026-02-03T04:05:06Z";
    EXPECT_EQ(is_kept, s != 2) << s;
    EXPECT_NE(calibration.calibration.sensors[s].method, "nominal") << s;
    EXPECT_EQ(calibration.calibration.mounts[s].date == "2026-02-03T04:05:06Z", s != 4) << s;
    EXPECT_EQ(calibration.calibration.mounts[s].method, "two poses") << s;
  }
}

}  // namespace
}  // namespace limbwave::solve
