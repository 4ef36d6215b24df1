#include <gtest/gtest.h>

#include "calibrate/gain_check.h"
#include "calibrate/synthetic_sensor.h"

namespace limbwave::calibrate {
namespace {

using test::SyntheticSensor;

struct Board {
  std::vector<SyntheticSensor> sensors;
  std::vector<SensorCalibration> calibrations;
  std::mt19937_64 random;

  explicit Board(std::uint64_t seed) : random(seed) {
    for (int s = 0; s < 5; ++s) {
      sensors.push_back(SyntheticSensor::off_by(0.1, random));
      SensorCalibration calibration;
      calibration.offset = sensors.back().offset;
      calibration.M = sensors.back().symmetric_M();
      calibrations.push_back(calibration);
    }
  }
  // Three poses held for two seconds with movement between, all volts multiplied by `factor`.
  std::vector<decode::AccelerationFrame> poses(double factor) {
    std::vector<decode::AccelerationFrame> frames;
    for (int i = 0; i < 600; ++i) {
      decode::AccelerationFrame frame;
      frame.time_s = i / 60.0;
      const bool moving = i % 200 < 80;
      for (std::size_t s = 0; s < sensors.size(); ++s) {
        const Quaterniond pose = test::hand_turn(3.0 * (i / 200) + static_cast<double>(s), 1.0);
        Vector3d f = pose.conjugate() * Vector3d(0.0, 0.0, kStandardGravity);
        if (moving) {
          f += 3.0 * Vector3d(std::sin(0.3 * i), std::cos(0.21 * i), 0.5);
        }
        frame.volts[s] = factor * sensors[s].volts(f, random);
        frame.usable |= 1U << s;
      }
      frames.push_back(frame);
    }
    return frames;
  }
};

TEST(GainCheck, FindsAndUndoesAMovedBalance) {
  for (const double factor : {0.85, 0.97, 1.01, 1.2}) {
    Board board(7);
    const auto readings = still_readings(board.poses(factor), board.calibrations);
    ASSERT_GE(readings.size(), 15U);
    const auto result = estimate_gain(readings, board.calibrations);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_NEAR(result->gain, 1.0 / factor, 3e-4);
    EXPECT_LT(std::abs(result->gain - 1.0 / factor), 5.0 * result->standard_error + 1e-6);
    EXPECT_TRUE(result->moved) << factor;
    EXPECT_LT(result->residual_g, 0.002);
    EXPECT_GT(result->before_g, 0.01);
    for (const StillReading& reading : readings) {
      const SensorCalibration changed =
          with_gain(board.calibrations[static_cast<std::size_t>(reading.sensor)], result->gain);
      EXPECT_NEAR(changed.apply(reading.volts).norm(), kStandardGravity, 0.05);
    }
  }
}

TEST(GainCheck, UnmovedGainIsNotReported) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Board board(seed);
    const auto result = estimate_gain(still_readings(board.poses(1.0), board.calibrations), board.calibrations);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_FALSE(result->moved) << result->gain << " +- " << result->standard_error;
  }
}

TEST(GainCheck, OneBrokenSensorDoesNotMoveTheGain) {
  Board board(8);
  auto frames = board.poses(1.0);
  for (decode::AccelerationFrame& frame : frames) {
    frame.volts[3].z() = 1.7;
  }
  const auto result = estimate_gain(still_readings(frames, board.calibrations), board.calibrations);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_NEAR(result->gain, 1.0, 2e-3);
}

TEST(GainCheck, RefusesWithoutReadings) {
  Board board(9);
  EXPECT_FALSE(estimate_gain({}, board.calibrations));
}

}  // namespace
}  // namespace limbwave::calibrate
