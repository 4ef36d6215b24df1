#include "take/board_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/calibration_library.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

using testing::HasSubstr;

class Boards : public testing::Test {
 protected:
  test::TemporaryFolder folder;
  BoardBook book{folder / "home" / "boards.json"};
  body::Rig rig = arm_rig();
};

TEST_F(Boards, EachDeviceKeepsItsOwn) {
  EXPECT_EQ(book.board("card A", rig.name).value(), Board{});
  ASSERT_TRUE(book.set_board("card A", rig.name, {"Lab 1", {}}).ok());
  ASSERT_TRUE(book.set_board("card B", rig.name, {"Lab 2", {"K7", "", "K9"}}).ok());
  ASSERT_TRUE(book.set_board("card A", rig.name, {"Lab 3", {}}).ok());
  EXPECT_EQ(book.board("card A", rig.name).value().name, "Lab 3");
  EXPECT_EQ(book.board("card B", rig.name).value(), (Board{"Lab 2", {"K7", "", "K9"}}));
  EXPECT_EQ(book.board("card B", "other").value(), Board{}) << "another rig is another board";
  ASSERT_TRUE(book.set_board("card A", rig.name, {}).ok());
  EXPECT_EQ(book.board("card A", rig.name).value(), Board{});
}

TEST_F(Boards, SensorsGetSerials) {
  rig.accelerometers[3].serial = "of the rig";
  const body::Rig named = rig_with_board(rig, {"Lab 2", {"K7", ""}});
  EXPECT_EQ(named.accelerometers[0].serial, "K7");
  EXPECT_EQ(named.accelerometers[1].serial, "Lab 2: upper arm");
  EXPECT_EQ(named.accelerometers[3].serial, "of the rig");
  EXPECT_EQ(rig_with_board(rig, {}).accelerometers[0].serial, "");
}

TEST_F(Boards, CalibrationsOfTwoBoardsStayApart) {
  const CalibrationLibrary library(folder / "calibrations");
  const body::Rig one = rig_with_board(rig, {"Lab 1", {}}), two = rig_with_board(rig, {"Lab 2", {}});
  calibrate::RigCalibration calibration = calibrate::nominal_calibration(rig);
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    calibration.sensors[s].method = "ellipsoid";
    calibration.sensors[s].date = calibration.mounts[s].date = "2026-03-01T10:00:00Z";
    calibration.mounts[s].method = "two poses";
  }
  ASSERT_TRUE(library.save(one, "Anna", calibration).ok());
  EXPECT_TRUE(library.lookup(one, "Anna").missing.empty());
  EXPECT_FALSE(library.lookup(two, "Anna").calibration.has_value()) << library.lookup(two, "Anna").explanation;
  EXPECT_FALSE(library.lookup(rig, "Anna").calibration.has_value()) << "neither is an unnamed board's";
  ASSERT_TRUE(library.save(two, "Anna", calibration).ok()) << "equal values of another board are not known already";
  EXPECT_TRUE(library.lookup(two, "Anna").missing.empty());
}

TEST_F(Boards, OneSerialForTwoSensorsAndDamagedFilesAreRefused) {
  const Status status = book.set_board("card A", rig.name, {"", {"K7", "K7"}});
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().text(), HasSubstr("two sensors"));
  ASSERT_TRUE(book.set_board("card A", rig.name, {"Lab 1", {}}).ok());
  test::write_bytes(folder / "home" / "boards.json", "{");
  EXPECT_FALSE(book.board("card A", rig.name).ok());
  EXPECT_FALSE(book.set_board("card B", rig.name, {"Lab 2", {}}).ok()) << "what cannot be read is not written over";
}

TEST_F(Boards, TheUsersOwnIsInTheirDataFolder) {
  ::setenv("LIMBWAVE_HOME", folder.path().c_str(), 1);
  ASSERT_TRUE(BoardBook().set_board("card A", rig.name, {"Lab 1", {}}).ok());
  EXPECT_EQ(rig_on_device(rig, "card A").accelerometers[2].serial, "Lab 1: forearm");
  EXPECT_EQ(rig_on_device(rig, "card B").accelerometers[2].serial, "");
  ::unsetenv("LIMBWAVE_HOME");
}

}  // namespace
}  // namespace limbwave::take
