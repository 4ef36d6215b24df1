/// The way of the data that calibrations stand for: sensors 10 % of g off, calibrated in range and on the limb, then
/// still poses whose inclination is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "calibrate/limb_calibration.h"
#include "calibrate/range_calibration.h"
#include "calibrate/synthetic_sensor.h"
#include "estimate/inclination.h"

namespace limbwave {
namespace {

using calibrate::RigCalibration;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using test::SyntheticSensor;

constexpr int kSensors = 4;

body::Rig arm() {
  body::Rig rig;
  body::CalibrationGroup group;
  for (int s = 0; s < kSensors; ++s) {
    body::Accelerometer accelerometer;
    accelerometer.name = fmt::format("sensor {}", s);
    rig.accelerometers.push_back(accelerometer);
    group.sensors.push_back(s);
  }
  group.name = "Right arm";
  group.first = {"horizontal", "", -Vector3d::UnitZ()};
  group.second = {"vertical", "", Vector3d::UnitX()};
  rig.groups = {group};
  return rig;
}

// One physical arm with its sensors, turned by hand, worn, and held in poses.
class Arm {
 public:
  explicit Arm(std::uint64_t seed) : random_(seed) {
    std::normal_distribution<double> normal(0.0, radians(5.0));
    for (int s = 0; s < kSensors; ++s) {
      sensors_.push_back(SyntheticSensor::off_by(0.1, random_));
      R_LS_.push_back(geometry::exp_so3(Vector3d(normal(random_), normal(random_), normal(random_))));
    }
  }

  // Range calibration of every sensor, with jerks and the acceleration of a hand.
  void calibrate_range(RigCalibration& calibration) {
    for (std::size_t s = 0; s < kSensors; ++s) {
      const auto turn = [s](double t) { return test::hand_turn(t + 3.0 * static_cast<double>(s), 1.0); };
      const auto hand = [&](double t) -> Vector3d {
        constexpr double h = 1e-3;
        const Vector3d p(0.08, 0.03, 0.0);  // the sensor is off the wrist that turns it
        return (turn(t + h) * p - 2.0 * (turn(t) * p) + turn(t - h) * p) / (h * h) + test::jerks(t, 3.1);
      };
      calibrate::RangeCalibrator calibrator(test::nominal_signal(), fmt::format("{}", s));
      calibrator.push(test::record(sensors_[s], 75.0, turn, hand, random_));
      const auto result = calibrator.finish();
      ASSERT_TRUE(result) << result.error().text();
      calibration.sensors[s] = result->calibration;
    }
  }

  // Limb calibration by two poses that are each `off` radians wrong in a random direction.
  void calibrate_limb(const body::Rig& rig, RigCalibration& calibration, double off) {
    calibrate::LimbCalibrator calibrator(rig, calibration, 0);
    const Vector3d gravity[2] = {rig.groups[0].first.gravity_L, rig.groups[0].second.gravity_L};
    for (const int pose : {0, 1}) {
      const Quaterniond wrong = wrongly(off);
      calibrator.push(pose, hold(wrong * Vector3d(-gravity[pose]), 2.0));
    }
    const auto result = calibrator.finish();
    ASSERT_TRUE(result) << result.error().text();
    for (const calibrate::SensorLimbResult& sensor : result->sensors) {
      calibration.mounts[static_cast<std::size_t>(sensor.sensor)] = sensor.mount;
    }
  }

  // Errors in degrees over random still poses of all sensors.
  std::vector<double> still_pose_errors(const RigCalibration& calibration, int poses) {
    std::vector<double> errors;
    std::normal_distribution<double> normal;
    for (int i = 0; i < poses; ++i) {
      const Vector3d up_L = Vector3d(normal(random_), normal(random_), normal(random_)).normalized();
      const auto frames = hold(up_L, 1.0);
      for (std::size_t s = 0; s < kSensors; ++s) {
        std::vector<estimate::ForceSample> samples;
        for (const decode::AccelerationFrame& frame : frames) {
          samples.push_back(
              {frame.time_s, calibration.mounts[s].R_LS * calibration.sensors[s].apply(frame.volts[s]), true});
        }
        const auto estimates = estimate::estimate_inclinations(samples, estimate::Smoothing::kBridging);
        errors.push_back(degrees(geometry::angle_between(estimates[estimates.size() / 2].up_L, up_L)));
      }
    }
    return errors;
  }

 private:
  Quaterniond wrongly(double off) {
    std::normal_distribution<double> normal;
    const Vector3d axis = Vector3d(normal(random_), normal(random_), normal(random_)).normalized();
    return Quaterniond(Eigen::AngleAxisd(off, axis));
  }

  std::vector<decode::AccelerationFrame> hold(const Vector3d& up_L, double seconds) {
    std::vector<decode::AccelerationFrame> frames;
    for (int i = 0; i < static_cast<int>(60.0 * seconds); ++i) {
      decode::AccelerationFrame frame;
      frame.time_s = time_s_;
      time_s_ += 1.0 / 60.0;
      for (std::size_t s = 0; s < kSensors; ++s) {
        frame.volts[s] = sensors_[s].volts(R_LS_[s].conjugate() * (kStandardGravity * up_L), random_);
        frame.usable |= 1U << s;
      }
      frames.push_back(frame);
    }
    return frames;
  }

  std::mt19937_64 random_;
  std::vector<SyntheticSensor> sensors_;
  std::vector<Quaterniond> R_LS_;
  double time_s_ = 0.0;
};

struct Summary {
  double mean = 0.0, highest = 0.0;
};

Summary summary_of(const std::vector<double>& errors) {
  Summary summary;
  for (const double error : errors) {
    summary.mean += error / static_cast<double>(errors.size());
    summary.highest = std::max(summary.highest, error);
  }
  return summary;
}

std::vector<double> errors_of_arms(double pose_off, bool range_calibrated) {
  std::vector<double> errors;
  const body::Rig rig = arm();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Arm wearer(seed);
    RigCalibration calibration = calibrate::nominal_calibration(rig);
    if (range_calibrated) {
      wearer.calibrate_range(calibration);
    }
    wearer.calibrate_limb(rig, calibration, pose_off);
    const auto of_this = wearer.still_pose_errors(calibration, 25);
    errors.insert(errors.end(), of_this.begin(), of_this.end());
  }
  return errors;
}

TEST(CalibratedPath, StillPosesAfterAccurateCalibrationMeetTheBar) {
  const Summary accurate = summary_of(errors_of_arms(0.0, true));
  const Summary none = summary_of(errors_of_arms(0.0, false));
  fmt::print(
      "still poses, sensors 10 % of g off: {:.2f}° mean, {:.2f}° max after accurate calibration "
      "(paper: 2°, 4°); {:.2f}°, {:.2f}° without range calibration\n",
      accurate.mean, accurate.highest, none.mean, none.highest);
  EXPECT_LE(accurate.mean, 0.5);
  EXPECT_LE(accurate.highest, 1.5);
  EXPECT_GT(none.mean, 2.0);  // the test would notice if the errors were not there
}

TEST(CalibratedPath, QuickPosesBesideThePapersFigures) {
  const Summary quick = summary_of(errors_of_arms(radians(5.0), true));
  fmt::print(
      "still poses after a wearer's quick calibration, each pose 5° off: {:.2f}° mean, {:.2f}° max "
      "(paper: 6°, 13°)\n",
      quick.mean, quick.highest);
  EXPECT_LE(quick.mean, 6.0);
  EXPECT_LE(quick.highest, 13.0);
}

}  // namespace
}  // namespace limbwave
