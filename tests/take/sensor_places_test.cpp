#include "take/sensor_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "take/board_book.h"
#include "take/calibration_library.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SensorPlaces : public testing::Test {
 protected:
  // torso, upper arm, forearm, hand, fingers; the arm is group 0, the torso group 1.
  body::Rig rig = arm_rig();
  std::vector<std::string> own = places_of(rig);
  std::vector<std::string> hand_and_forearm{"torso", "upper arm", "hand", "forearm", "fingers"};
  std::vector<std::string> hand_and_torso{"hand", "upper arm", "forearm", "torso", "fingers"};

  TakeInfo calibrated() const {
    TakeInfo info = arm_info({SampleRate{48000.0}, 2, acquire::SampleType::kInt16});
    info.calibration = calibrate::nominal_calibration(info.rig);
    for (std::size_t s = 0; s < own.size(); ++s) {
      info.calibration->sensors[s].method = "ellipsoid";
      info.calibration->sensors[s].residual_g = 0.001 * static_cast<double>(s + 1);
      info.calibration->mounts[s].method = "two poses";
      info.calibration->mounts[s].pose_angle_deg = 90.0 + static_cast<double>(s);
    }
    return info;
  }
};

TEST_F(SensorPlaces, WhatIsSaidOfAPlaceHangsOnAnotherSocket) {
  const body::Rig worn = with_places(rig, hand_and_torso).value();
  EXPECT_EQ(worn.accelerometers[0].segment, "hand");
  EXPECT_EQ(worn.accelerometers[3].segment, "torso");
  EXPECT_TRUE(worn.accelerometers[0].p_LS.isApprox(rig.accelerometers[3].p_LS));
  // The arm's group still has upper arm, forearm, hand and fingers, the torso's the torso.
  EXPECT_THAT(worn.groups[0].sensors, ElementsAre(1, 2, 0, 4));
  EXPECT_THAT(worn.groups[1].sensors, ElementsAre(3));
  EXPECT_EQ(worn.accelerometers[0].serial, "line-in-arm: torso") << "the sensor keeps its key in the library";
  EXPECT_EQ(sensor_key(worn, worn.accelerometers[0]), sensor_key(rig, rig.accelerometers[0]));
  EXPECT_EQ(worn.accelerometers[1].serial, "");
  const body::Rig back = with_places(worn, own).value();
  EXPECT_EQ(places_of(back), own);
  EXPECT_EQ(back.groups[0].sensors, rig.groups[0].sensors);
}

TEST_F(SensorPlaces, EveryPlaceIsNamedOnce) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"torso"},
                                                {"torso", "torso", "forearm", "hand", "fingers"},
                                                {"torso", "upper arm", "forearm", "hand", "nose"}}) {
    const Result<body::Rig> refused = with_places(rig, wrong);
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().text(), HasSubstr("every place"));
  }
}

TEST_F(SensorPlaces, ATakeKeepsTheRangesOfItsSensorsAndTheMountingsOfTheSamePoses) {
  const TakeInfo info = calibrated();
  const TakeInfo arm = with_sensors(info, hand_and_forearm, {"", "", "", "", ""}).value();
  ASSERT_TRUE(calibrate::check_calibration(*arm.calibration, arm.rig).ok());
  for (std::size_t s = 0; s < own.size(); ++s) {
    EXPECT_EQ(arm.calibration->sensors[s].residual_g, info.calibration->sensors[s].residual_g) << s;
    EXPECT_EQ(arm.calibration->mounts[s].pose_angle_deg, info.calibration->mounts[s].pose_angle_deg) << s;
  }
  EXPECT_EQ(arm.calibration->mounts[2].sensor, "hand");
  const TakeInfo torso = with_sensors(info, hand_and_torso, {"", "", "", "", ""}).value();
  ASSERT_TRUE(calibrate::check_calibration(*torso.calibration, torso.rig).ok());
  EXPECT_EQ(torso.calibration->mounts[0].method, "nominal") << "the torso's poses were others than the arm's";
  EXPECT_EQ(torso.calibration->mounts[1].method, "two poses");
  EXPECT_EQ(torso.calibration->sensors[0].method, "ellipsoid");
}

TEST_F(SensorPlaces, RangesGoWithSerials) {
  TakeInfo info = with_sensors(calibrated(), own, {"A", "B", "C", "", ""}).value();
  EXPECT_EQ(info.calibration->sensors[0].method, "ellipsoid") << "naming a sensor does not make it another one";
  EXPECT_EQ(info.calibration->sensors[0].serial, "A");
  info = with_sensors(info, own, {"B", "A", "D", "", ""}).value();
  EXPECT_EQ(info.calibration->sensors[0].residual_g, 0.002);
  EXPECT_EQ(info.calibration->sensors[1].residual_g, 0.001);
  EXPECT_EQ(info.calibration->sensors[2].method, "nominal") << "nothing is known of D";
  EXPECT_EQ(info.calibration->sensors[3].residual_g, 0.004);
  EXPECT_FALSE(with_sensors(info, own, {"A", "A", "", "", ""}).ok());
}

TEST_F(SensorPlaces, ABoardRemembersThem) {
  const test::TemporaryFolder folder;
  const BoardBook book(folder / "boards.json");
  const Board board{"Lab 2", {"K7"}, hand_and_torso};
  ASSERT_TRUE(book.set_board("card", rig.name, board).ok());
  EXPECT_EQ(book.board("card", rig.name).value(), board);
  const body::Rig worn = rig_with_board(rig, board);
  EXPECT_EQ(worn.accelerometers[0].name, "hand");
  EXPECT_EQ(worn.accelerometers[0].serial, "K7");
  EXPECT_EQ(worn.accelerometers[3].serial, "Lab 2: hand") << "named by its socket, wherever it is worn";
  EXPECT_EQ(places_of(rig_with_board(rig, {"", {}, {"nose"}})), own) << "places of another rig say nothing";
}

}  // namespace
}  // namespace limbwave::take
