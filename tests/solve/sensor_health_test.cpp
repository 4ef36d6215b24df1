#include "solve/sensor_health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/units.h"
#include "support/simulated_take.h"

namespace limbwave::solve {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing_support::require;

constexpr std::size_t kSensor = 2;

class SensorHealthTest : public testing::Test {
 protected:
  // One second of readings at the board, volts above the ground.
  SensorHealth of(const Vector3d& board_volts, double swing_volts = 0.0, double usable = 1.0) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.0004);  // of a line at -60 dB
    std::vector<decode::AccelerationFrame> frames;
    for (int i = 0; i < 60; ++i) {
      decode::AccelerationFrame frame;
      frame.time_s = i / 60.0;
      for (Vector3d& volts : frame.volts) {
        volts = Vector3d(noise(random), noise(random), noise(random));
      }
      frame.volts[kSensor] += board_volts - Vector3d::Constant(rig.line_in.reference_volts) +
                              swing_volts * std::sin(0.6 * i) * Vector3d(1.0, -0.5, 0.3);
      frame.usable = i < 60.0 * usable ? ~0U : ~(1U << kSensor);
      frames.push_back(frame);
    }
    return sensor_health(rig, calibration, static_cast<int>(kSensor), frames);
  }
  // The sensor's output for a force in g.
  Vector3d output(const Vector3d& force_g) const {
    return Vector3d::Constant(rig.line_in.zero_g_volts) + rig.line_in.volts_per_g * force_g;
  }
  body::Rig rig = require(body::load_rig("line-in-arm"));
  calibrate::SensorCalibration calibration = [this] {
    calibrate::SensorCalibration sensor = calibrate::nominal_calibration(rig).sensors[kSensor];
    sensor.method = "ellipsoid";
    return sensor;
  }();
};

TEST_F(SensorHealthTest, RestingInAnyDirectionIsGood) {
  for (const Vector3d& up :
       {Vector3d(0, 0, 1), Vector3d(-1, 0, 0), Vector3d(1, 1, 1), Vector3d(-1, -1, -1), Vector3d(0.3, -0.9, 0.4)}) {
    EXPECT_EQ(of(output(up.normalized())).code, "good") << up.transpose();
  }
  calibration.method = "nominal";
  EXPECT_EQ(of(output(Vector3d::UnitZ())).code, "no-calibration");
}

TEST_F(SensorHealthTest, AnInputThatNothingDrivesIsNoSignalHoweverItWasCalibrated) {
  calibration.M *= 1.07;
  calibration.offset += Vector3d(0.03, -0.04, 0.02);
  for (const double level : {0.0, rig.line_in.reference_volts, 3.3, rig.line_in.zero_g_volts}) {
    const SensorHealth health = of(Vector3d::Constant(level));
    EXPECT_EQ(health.code, "no-signal") << level << " V: " << health.text;
    EXPECT_EQ(health.state, HealthState::kBad);
    EXPECT_THAT(health.text, HasSubstr("plugged in"));
  }
}

TEST_F(SensorHealthTest, RestingAtAnotherLengthAsksForWhatCanMendIt) {
  const SensorHealth drifted = of(output(Vector3d(0, 0, 1.2)));
  EXPECT_EQ(drifted.code, "not-plausible");
  EXPECT_EQ(drifted.state, HealthState::kWarning);
  EXPECT_THAT(drifted.text, HasSubstr("repeat its range calibration"));
  const SensorHealth broken = of(output(Vector3d(-3.2, 0, 0.9)));  // one wire is off
  EXPECT_EQ(broken.code, "not-plausible");
  EXPECT_EQ(broken.state, HealthState::kBad);
  EXPECT_THAT(broken.text, HasSubstr("check its cable"));
}

TEST_F(SensorHealthTest, MovingIsGoodUpToTheLimitOfTheSensor) {
  EXPECT_EQ(of(output(Vector3d(0, 0, 1)), 0.3).code, "good");
  EXPECT_EQ(of(output(Vector3d(0, 0, 1)), 1.34).code, "saturated");
  EXPECT_EQ(of(output(Vector3d(4.0, 0, 1)), 0.5).code, "not-plausible");
}

TEST_F(SensorHealthTest, LostReadings) {
  EXPECT_EQ(of(output(Vector3d(0, 0, 1)), 0.0, 0.9).code, "gaps");
  EXPECT_EQ(of(output(Vector3d(0, 0, 1)), 0.0, 0.4).code, "unusable");
  EXPECT_EQ(sensor_health(rig, calibration, 0, {}).state, HealthState::kUnknown);
}

}  // namespace
}  // namespace limbwave::solve
