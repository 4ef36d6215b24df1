#include "take/calibration_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

namespace fs = std::filesystem;
using calibrate::RigCalibration;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

RigCalibration measured(const body::Rig& rig, const std::string& date, double offset) {
  RigCalibration calibration = calibrate::nominal_calibration(rig);
  for (calibrate::SensorCalibration& sensor : calibration.sensors) {
    sensor.method = "ellipsoid";
    sensor.date = date;
    sensor.offset = Eigen::Vector3d(offset, 0.1, 1.0 / 3.0);
    sensor.residual_g = 0.0123;
    sensor.coverage = 0.9;
  }
  for (calibrate::MountCalibration& mount : calibration.mounts) {
    mount.method = "two poses";
    mount.date = date;
    mount.R_LS = Eigen::Quaterniond(Eigen::AngleAxisd(offset, Eigen::Vector3d::UnitX()));
    mount.pose_angle_deg = 91.0;
  }
  return calibration;
}

class Library : public testing::Test {
 protected:
  test::TemporaryFolder folder;
  CalibrationLibrary library{folder / "calibrations"};
  body::Rig rig = arm_rig();
};

TEST_F(Library, EmptySaysWhatIsMissing) {
  const LibraryLookup lookup = library.lookup(rig, "Anna");
  EXPECT_FALSE(lookup.calibration.has_value());
  EXPECT_THAT(lookup.missing, SizeIs(10));
  EXPECT_THAT(lookup.missing, Contains("forearm: no range calibration"));
  EXPECT_THAT(lookup.missing, Contains("forearm: no limb calibration"));
  EXPECT_THAT(lookup.explanation, HasSubstr("has nothing for rig \"line-in-arm\" on \"Anna\""));
  EXPECT_THAT(lookup.diagnostics, IsEmpty());
  EXPECT_FALSE(fs::exists(library.folder())) << "looking makes nothing";
}

TEST_F(Library, WhatIsSavedIsFoundExactly) {
  const RigCalibration saved = measured(rig, "2026-03-01T10:00:00Z", 0.2);
  ASSERT_TRUE(library.save(rig, "Anna", saved).ok());
  const LibraryLookup lookup = library.lookup(rig, "Anna");
  ASSERT_TRUE(lookup.calibration.has_value()) << lookup.explanation;
  ASSERT_EQ(lookup.calibration->sensors.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(lookup.calibration->sensors[i].offset, saved.sensors[i].offset);
    EXPECT_EQ(lookup.calibration->sensors[i].M, saved.sensors[i].M);
    EXPECT_EQ(lookup.calibration->sensors[i].residual_g, 0.0123);
    EXPECT_EQ(lookup.calibration->mounts[i].sensor, rig.accelerometers[i].name);
    EXPECT_EQ(lookup.calibration->mounts[i].R_LS.coeffs(), saved.mounts[i].R_LS.coeffs());
  }
  EXPECT_EQ(lookup.explanation, "calibration library: range of 2026-03-01, limbs of \"Anna\" of 2026-03-01");
}

TEST_F(Library, RangesHoldOnEveryWearerMountsOnOne) {
  const RigCalibration saved = measured(rig, "2026-03-01T10:00:00Z", 0.2);
  ASSERT_TRUE(library.save(rig, "Anna", saved).ok());
  const LibraryLookup ben = library.lookup(rig, "Ben");
  ASSERT_TRUE(ben.calibration.has_value());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(ben.calibration->sensors[i].offset, saved.sensors[i].offset);
    EXPECT_EQ(ben.calibration->mounts[i].method, "nominal");
    EXPECT_EQ(ben.calibration->mounts[i].sensor, rig.accelerometers[i].name);
  }
  EXPECT_THAT(ben.missing, SizeIs(5));
  EXPECT_EQ(ben.explanation, "calibration library: range of 2026-03-01, no limbs of \"Ben\"");
}

TEST_F(Library, OneMissingEntryLeavesTheOthers) {
  const RigCalibration saved = measured(rig, "2026-03-01T10:00:00Z", 0.2);
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(library.save_sensor(sensor_key(rig, rig.accelerometers[i]), saved.sensors[i]).ok());
  }
  ASSERT_TRUE(library.save_mounts(rig, "Anna", {saved.mounts[1]}).ok());
  const LibraryLookup lookup = library.lookup(rig, "Anna");
  ASSERT_TRUE(lookup.calibration.has_value());
  EXPECT_EQ(lookup.calibration->sensors[3].offset, saved.sensors[3].offset);
  EXPECT_EQ(lookup.calibration->sensors[4].method, "nominal");
  EXPECT_EQ(lookup.calibration->mounts[1].R_LS.coeffs(), saved.mounts[1].R_LS.coeffs());
  EXPECT_EQ(lookup.calibration->mounts[2].method, "nominal");
  EXPECT_THAT(lookup.missing, SizeIs(5));
  EXPECT_EQ(
      lookup.explanation,
      "calibration library: range of 2026-03-01, but none of fingers; limbs of \"Anna\" of 2026-03-01, but none of "
      "torso, forearm, hand, fingers");
}

TEST_F(Library, RecordsWithoutKeysStillCount) {
  const RigCalibration saved = measured(rig, "2026-03-01T10:00:00Z", 0.2);
  const fs::path file = library.save_mounts(rig, "Anna", saved.mounts).value();
  std::string text = read_file(file).value();
  const std::size_t keys = text.find("\"keys\"");
  ASSERT_NE(keys, std::string::npos);
  text.erase(keys, text.find(']', keys) + 2 - keys);  // with the comma
  test::write_bytes(file, text);
  const LibraryLookup lookup = library.lookup(rig, "Anna");
  EXPECT_THAT(lookup.diagnostics, IsEmpty());
  EXPECT_THAT(lookup.missing, SizeIs(5));
}

TEST_F(Library, TheNewestCountsAndTheHistoryStays) {
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-02T10:00:00Z", 0.3)).ok());
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-01T10:00:00Z", 0.1)).ok());
  EXPECT_EQ(library.lookup(rig, "Anna").calibration.value().sensors[2].offset.x(), 0.3);
  EXPECT_THAT(library.list().sensors, SizeIs(10));
  EXPECT_THAT(library.list().mounts, SizeIs(2));
  EXPECT_EQ(library.list().mounts[0].date, "2026-03-02T10:00:00Z");
  // Twice in one second: the later one counts.
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-02T10:00:00Z", 0.4)).ok());
  EXPECT_EQ(library.lookup(rig, "Anna").calibration.value().sensors[2].offset.x(), 0.4);
  EXPECT_NEAR(library.lookup(rig, "Anna").calibration.value().mounts[2].R_LS.x(), std::sin(0.2), 1e-15);
}

TEST_F(Library, OneSensorIsRepeatedAlone) {
  ASSERT_TRUE(library.save(rig, "", measured(rig, "2026-03-01T10:00:00Z", 0.1)).ok());
  RigCalibration again = measured(rig, "2026-04-01T10:00:00Z", 0.5);
  ASSERT_TRUE(library.save_sensor(sensor_key(rig, rig.accelerometers[1]), again.sensors[1]).ok());
  ASSERT_TRUE(library.save_mounts(rig, "", {again.mounts[3]}).ok());
  const LibraryLookup lookup = library.lookup(rig, "");
  ASSERT_TRUE(lookup.calibration.has_value());
  EXPECT_EQ(lookup.calibration->sensors[0].offset.x(), 0.1);
  EXPECT_EQ(lookup.calibration->sensors[1].offset.x(), 0.5);
  EXPECT_EQ(lookup.calibration->mounts[3].date, "2026-04-01T10:00:00Z");
  EXPECT_EQ(lookup.calibration->mounts[4].date, "2026-03-01T10:00:00Z");
  EXPECT_THAT(lookup.explanation, HasSubstr("of 2026-03-01 to 2026-04-01"));
}

TEST_F(Library, SavingWhatIsThereAlreadyAddsNothing) {
  RigCalibration calibration = measured(rig, "2026-03-01T10:00:00Z", 0.1);
  ASSERT_TRUE(library.save(rig, "Anna", calibration).ok());
  ASSERT_TRUE(library.save(rig, "Anna", calibration).ok());
  EXPECT_THAT(library.list().sensors, SizeIs(5));
  EXPECT_THAT(library.list().mounts, SizeIs(1));
  calibration.mounts[2] = measured(rig, "2026-03-02T10:00:00Z", 0.2).mounts[2];
  ASSERT_TRUE(library.save(rig, "Anna", calibration).ok());
  EXPECT_THAT(library.list().sensors, SizeIs(5));
  ASSERT_THAT(library.list().mounts, SizeIs(2));
  EXPECT_THAT(library.list().mounts[0].mounts, SizeIs(1));
  ASSERT_TRUE(library.save(rig, "Ben", calibration).ok());
  EXPECT_THAT(library.list().mounts, SizeIs(3)) << "another wearer's mounting is another one";
}

TEST_F(Library, NominalValuesAreNotCalibrations) {
  ASSERT_TRUE(library.save(rig, "Anna", calibrate::nominal_calibration(rig)).ok());
  EXPECT_THAT(library.list().sensors, IsEmpty());
  EXPECT_THAT(library.list().mounts, IsEmpty());
}

TEST_F(Library, SensorsWithASerialFollowItFromRigToRig) {
  rig.accelerometers[0].serial = "A/17 #2";
  EXPECT_EQ(sensor_key(rig, rig.accelerometers[0]), "A/17 #2");
  EXPECT_EQ(sensor_key(rig, rig.accelerometers[1]), "line-in-arm: upper arm");
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-01T10:00:00Z", 0.1)).ok());
  body::Rig other = rig;
  other.name = "other";
  EXPECT_THAT(library.lookup(other, "Anna").missing, testing::Not(Contains("torso: no range calibration")));
  EXPECT_THAT(library.lookup(other, "Anna").missing, Contains("upper arm: no range calibration"));
}

TEST_F(Library, AnyNameIsSafeOnDisk) {
  for (const char* name : {"../../etc", "", ".", "..", "a/b", "Zoë", "a\nb", "%41"}) {
    ASSERT_TRUE(library.save_mounts(rig, name, measured(rig, "2026-03-01T10:00:00Z", 0.1).mounts).ok()) << name;
  }
  EXPECT_THAT(library.list().mounts, SizeIs(8));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("calibrations"));
  EXPECT_THAT(names_in(library.folder()), ElementsAre("mounts"));
  EXPECT_THAT(names_in(library.folder() / "mounts" / "line-in-arm"), SizeIs(8));
}

TEST_F(Library, CorruptFilesAreSaidAndPassedOver) {
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-01T10:00:00Z", 0.1)).ok());
  const LibraryListing whole = library.list();
  const fs::path where = whole.sensors[0].file.parent_path();
  test::write_bytes(where / "2026-05-01.json", "");
  test::write_bytes(where / "2026-05-02.json", "{\"schema\": 1, \"key\": \"x\", \"calibration\": {\"a\": 1}}");
  test::write_bytes(where / "2026-05-03.json", std::string(5 << 20, ' '));
  test::write_bytes(where / "notes.txt", "mine");
  fs::create_directory(where / "folder.json");
  const LibraryLookup lookup = library.lookup(rig, "Anna");
  EXPECT_TRUE(lookup.calibration.has_value());
  EXPECT_THAT(codes(lookup.diagnostics), ElementsAre("library.unreadable", "library.unreadable", "library.unreadable"));
}

TEST_F(Library, RecordsAreDeletedOneByOne) {
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-01T10:00:00Z", 0.1)).ok());
  const LibraryListing listing = library.list();
  ASSERT_TRUE(library.remove(listing.mounts[0].file).ok());
  EXPECT_THAT(library.list().mounts, IsEmpty());
  EXPECT_FALSE(library.remove(listing.mounts[0].file).ok());
  test::write_bytes(folder / "other.json", "{}");
  EXPECT_THAT(library.remove(folder / "other.json").error().text(), HasSubstr("is not in the calibration library"));
  EXPECT_FALSE(library.remove(library.folder() / ".." / "other.json").ok());
  EXPECT_TRUE(fs::exists(folder / "other.json"));
}

TEST_F(Library, TheUsersOwnIsInTheirDataFolder) {
  ::setenv("LIMBWAVE_HOME", folder.path().c_str(), 1);
  EXPECT_EQ(CalibrationLibrary().folder(), folder / "calibrations");
  ASSERT_TRUE(library.save(rig, "Anna", measured(rig, "2026-03-01T10:00:00Z", 0.1)).ok());
  EXPECT_TRUE(library_calibration(rig, "Anna").calibration.has_value());
  ::unsetenv("LIMBWAVE_HOME");
}

}  // namespace
}  // namespace limbwave::take
