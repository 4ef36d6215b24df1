/// A person for tests: turns a box of sensors, holds poses, well or badly, and a source that passes the readings on.
#pragma once

#include <QSettings>
#include <cmath>
#include <random>
#include <set>

#include "calibrate/synthetic_sensor.h"
#include "calibration/calibration_source.h"

namespace limbwave::ui::testing {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A source whose readings the test makes.
class FakeSource : public CalibrationSource {
 public:
  FakeSource() {
    rig_ = body::load_rig("line-in-arm").value();
    skeleton_ = body::load_skeleton(rig_.skeleton).value();
    for (std::size_t s = 0; s < rig_.accelerometers.size(); ++s) {
      rig_.accelerometers[s].serial = "LW-00" + std::to_string(s + 1);
    }
    calibration_ = calibrate::nominal_calibration(rig_);
  }
  [[nodiscard]] bool running() const override { return running_; }
  [[nodiscard]] QString title() const override { return QStringLiteral("Test device"); }
  [[nodiscard]] QString problem() const override { return {}; }
  [[nodiscard]] QString remedy() const override { return {}; }
  [[nodiscard]] const body::Rig& rig() const override { return rig_; }
  [[nodiscard]] const body::Skeleton& skeleton() const override { return skeleton_; }
  [[nodiscard]] const calibrate::RigCalibration& calibration() const override { return calibration_; }
  void set_calibration(const calibrate::RigCalibration& calibration) override {
    calibration_ = calibration;
    Q_EMIT changed();
  }
  bool start_recording(const std::filesystem::path& folder, const QString&) override {
    if (!can_record) {
      return false;
    }
    recorded_folder = folder;
    return true;
  }
  void stop_recording() override { ++recordings_stopped; }
  [[nodiscard]] double recording_start_s() const override { return 0.0; }

  void set_running(bool running) {
    running_ = running;
    Q_EMIT changed();
  }

  std::filesystem::path recorded_folder;
  int recordings_stopped = 0;
  bool can_record = true;

 private:
  bool running_ = true;
  body::Rig rig_;
  body::Skeleton skeleton_;
  calibrate::RigCalibration calibration_;
};

/// Sensors 10 % of g off, each mounted a little differently from the rig; feeds a FakeSource at 60 Hz.
class SimulatedWearer {
 public:
  explicit SimulatedWearer(FakeSource& source, std::uint64_t seed = 7) : source_(source), random_(seed) {
    std::normal_distribution<double> normal;
    for (std::size_t s = 0; s < source.rig().accelerometers.size(); ++s) {
      sensors_.push_back(test::SyntheticSensor::off_by(0.1, random_));
      const Vector3d tilt = 0.15 * Vector3d(normal(random_), normal(random_), normal(random_));
      mounts_.push_back(Quaterniond(Eigen::AngleAxisd(tilt.norm(), tilt.normalized())));
    }
  }

  /// Sensor whose cable is out; its readings are unusable.
  std::set<int> unplugged;
  /// Of the true mounting: R_LS.
  [[nodiscard]] const Quaterniond& mount(int sensor) const { return mounts_.at(static_cast<std::size_t>(sensor)); }

  /// Turns all sensors in one box through all directions.
  void turn(double seconds, double rate = 0.9) {
    feed(seconds, [this, rate](double t, int) -> Vector3d {
      phase_ = t;
      return test::hand_turn(t, rate).conjugate() * up();
    });
  }
  /// The same with knocks.
  void turn_jerkily(double seconds, double period_s = 0.25) {
    feed(seconds, [period_s](double t, int) -> Vector3d {
      return test::hand_turn(t, 1.2).conjugate() * (up() + test::jerks(t, period_s));
    });
  }
  /// Only about the z axis of the box, which lies on its side: +z and −z never look up.
  void turn_about_z(double seconds) {
    feed(seconds, [](double t, int) -> Vector3d {
      return kStandardGravity * Vector3d(std::cos(0.5 * t), std::sin(0.5 * t), 0.0);
    });
  }
  /// Holds a pose of a group: `off_deg` beside what the rig asks for, swaying by `sway_g` (RMS) in `movers` (empty:
  /// all).
  void hold(int group, int pose, double seconds, double off_deg = 0.0, double sway_g = 0.0,
            const std::set<int>& movers = {}) {
    const body::CalibrationGroup& limb = source_.rig().groups.at(static_cast<std::size_t>(group));
    const Vector3d up_L = -(pose == 0 ? limb.first.gravity_L : limb.second.gravity_L);
    const Vector3d axis = limb.first.gravity_L.cross(limb.second.gravity_L);
    const Vector3d held_L = Eigen::AngleAxisd(off_deg * kPi / 180.0, axis) * up_L;
    feed(seconds, [&](double t, int s) -> Vector3d {
      const bool moves = sway_g > 0.0 && (movers.empty() || movers.count(s) > 0);
      const double sway = moves ? std::sqrt(2.0) * sway_g * std::sin(2.0 * kPi * 2.3 * t) : 0.0;
      return mount(s).conjugate() * (kStandardGravity * (held_L + sway * axis));
    });
  }

  /// The range calibrations that undo these sensors, as a good range wizard would have found them.
  [[nodiscard]] calibrate::RigCalibration true_ranges() const {
    calibrate::RigCalibration calibration = source_.calibration();
    for (std::size_t s = 0; s < sensors_.size(); ++s) {
      calibration.sensors[s].method = "ellipsoid";
      calibration.sensors[s].date = "2026-11-01T09:30:00Z";
      calibration.sensors[s].residual_g = 0.003;
      calibration.sensors[s].offset = sensors_[s].offset;
      calibration.sensors[s].M = sensors_[s].volts_per_force.inverse();
    }
    return calibration;
  }
  [[nodiscard]] double now_s() const { return time_s_; }

 private:
  static Vector3d up() { return kStandardGravity * Vector3d::UnitZ(); }

  template <typename Force>
  void feed(double seconds, const Force& force_S) {
    const double begin = time_s_;
    std::vector<decode::AccelerationFrame> block;
    while (time_s_ - begin < seconds) {
      decode::AccelerationFrame frame;
      frame.time_s = time_s_;
      for (int s = 0; s < static_cast<int>(sensors_.size()); ++s) {
        const auto at = static_cast<std::size_t>(s);
        frame.volts.at(at) = sensors_[at].volts(force_S(time_s_ - begin + offset_s_, s), random_);
        if (unplugged.count(s) == 0) {
          frame.usable |= 1U << at;
        }
      }
      block.push_back(frame);
      time_s_ += 1.0 / 60.0;
      // Blocks as a face sees them: a few readings at a time.
      if (block.size() == 4) {
        Q_EMIT source_.arrived(block);
        block.clear();
      }
    }
    Q_EMIT source_.arrived(block);
    offset_s_ += seconds;
  }

  FakeSource& source_;
  std::mt19937_64 random_;
  std::vector<test::SyntheticSensor> sensors_;
  std::vector<Quaterniond> mounts_;
  double time_s_ = 10.0, offset_s_ = 0.0, phase_ = 0.0;
};

}  // namespace limbwave::ui::testing
