#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "body/skeleton.h"
#include "solve/take_calibration.h"
#include "support/temporary_folder.h"
#include "take/calibration_library.h"

namespace limbwave::solve {
namespace {

using testing::HasSubstr;

/// A take without calibration movements, and a user's library of its own.
class LibraryChoice : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("LIMBWAVE_HOME", home.path().c_str(), 1);
    take.info.rig = *body::load_rig("line-in-arm");
    take.info.skeleton = *body::load_skeleton(take.info.rig.skeleton);
    take.info.subject = "Anna";
  }
  void TearDown() override { ::unsetenv("LIMBWAVE_HOME"); }

  calibrate::SensorCalibration range(double offset) const {
    calibrate::SensorCalibration range = calibrate::nominal_calibration(take.info.rig).sensors[0];
    range.method = "ellipsoid";
    range.date = "2026-03-01T10:00:00Z";
    range.offset.x() = offset;
    return range;
  }
  calibrate::MountCalibration mount(std::size_t sensor) const {
    calibrate::MountCalibration mount = calibrate::nominal_calibration(take.info.rig).mounts[sensor];
    mount.method = "two poses";
    mount.date = "2026-03-02T10:00:00Z";
    return mount;
  }
  void keep_range(std::size_t sensor, double offset) const {
    const std::string key = take::sensor_key(take.info.rig, take.info.rig.accelerometers[sensor]);
    ASSERT_TRUE(take::CalibrationLibrary().save_sensor(key, range(offset)).ok());
  }

  test::TemporaryFolder home;
  take::Take take;
  DecodedTake decoded;
};

TEST_F(LibraryChoice, WhatTheLibraryHasIsUsedAndTheRestIsNamed) {
  for (std::size_t s = 0; s < 4; ++s) {
    keep_range(s, 0.1 + 0.01 * static_cast<double>(s));
  }
  const auto chosen = choose_calibration(take, decoded, "auto");
  ASSERT_TRUE(chosen.ok()) << chosen.error().text();
  EXPECT_EQ(chosen->source, "library");
  EXPECT_EQ(chosen->calibration.sensors[3].offset.x(), 0.13);
  EXPECT_EQ(chosen->calibration.sensors[4].method, "nominal");
  ASSERT_EQ(chosen->diagnostics.size(), 1U);
  EXPECT_EQ(chosen->diagnostics[0].code, "calibration.partial");
  EXPECT_THAT(chosen->diagnostics[0].message, HasSubstr("the range of fingers; the mounting of torso, upper arm"));
  EXPECT_TRUE(choose_calibration(take, decoded, "library").ok());
  const RecordingCalibration recording = calibration_for_recording(take.info.rig, "Zoe");
  EXPECT_EQ(recording.calibration.sensors[0].offset.x(), 0.1) << "a range holds on every wearer";
  EXPECT_THAT(recording.explanation, HasSubstr("none of fingers; no limbs of \"Zoe\""));
}

TEST_F(LibraryChoice, ASnapshotIsCompletedNotReplaced) {
  take.info.calibration = calibrate::nominal_calibration(take.info.rig);
  take.info.calibration->sensors[0] = range(0.5);
  keep_range(0, 0.1);
  keep_range(1, 0.2);
  ASSERT_TRUE(take::CalibrationLibrary().save_mounts(take.info.rig, "Anna", {mount(2)}).ok());
  ASSERT_TRUE(take::CalibrationLibrary().save_mounts(take.info.rig, "Zoe", {mount(3)}).ok());
  const auto chosen = choose_calibration(take, decoded, "auto");
  ASSERT_TRUE(chosen.ok()) << chosen.error().text();
  EXPECT_EQ(chosen->source, "snapshot");
  EXPECT_EQ(chosen->calibration.sensors[0].offset.x(), 0.5);
  EXPECT_EQ(chosen->calibration.sensors[1].offset.x(), 0.2);
  EXPECT_EQ(chosen->calibration.mounts[2].method, "two poses");
  EXPECT_EQ(chosen->calibration.mounts[3].method, "nominal") << "another wearer's mounting";
  EXPECT_THAT(chosen->explanation, HasSubstr("completed by the calibration library"));
  const auto alone = choose_calibration(take, decoded, "snapshot");
  ASSERT_TRUE(alone.ok());
  EXPECT_EQ(alone->calibration.sensors[1].method, "nominal") << "asked for as it is";
}

TEST_F(LibraryChoice, AnEmptyLibraryIsOneShortSentence) {
  const auto chosen = choose_calibration(take, decoded, "library");
  ASSERT_FALSE(chosen.ok());
  EXPECT_EQ(chosen.error().message, "the calibration library has nothing for rig \"line-in-arm\" on \"Anna\"");
  EXPECT_EQ(choose_calibration(take, decoded, "auto")->source, "nominal");
}

}  // namespace
}  // namespace limbwave::solve
