/// What boards on a moving body read, by numerical differentiation of its poses: shares nothing with the kinematics
/// that is to be tested.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "base/units.h"
#include "estimate/body_model.h"
#include "geometry/so3.h"

namespace limbwave::testing_support {

/// World poses of all segments at a time.
using PosesAt = std::function<std::vector<body::SegmentPose>(double time_s)>;

/// Errors of boards, standard deviations (SI, radians); all zero: perfect ones.
struct BoardErrors {
  double rate_noise = 0.0, force_noise = 0.0, rate_bias = 0.0, force_bias = 0.0, mount = 0.0, range_noise = 0.0;

  static BoardErrors worn() { return {0.002, 0.02, 0.001, 0.03, radians(2.0), 0.0025}; }
};

/// Readings of all boards and sources of a model at `rate_hz`; ranges of one source every 8 ms in turn. Also the root's
/// path.
inline estimate::BodyReadings read_poses(const PosesAt& poses, const estimate::BodyModel& model, double seconds,
                                         double rate_hz, const BoardErrors& errors = {}, unsigned seed = 1) {
  using Eigen::Quaterniond;
  using Eigen::Vector3d;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&](double sigma) {
    const double x = normal(random);
    const double y = normal(random);
    return Vector3d(sigma * Vector3d(x, y, normal(random)));
  };
  std::vector<Quaterniond> mount;
  std::vector<Vector3d> rate_bias, force_bias;
  for (std::size_t b = 0; b < model.boards.size(); ++b) {
    mount.push_back(geometry::exp_so3(draw(errors.mount)));
    rate_bias.push_back(draw(errors.rate_bias));
    force_bias.push_back(draw(errors.force_bias));
  }
  constexpr double h = 1.5e-3;
  estimate::BodyReadings readings;
  for (std::int64_t k = 0; static_cast<double>(k) / rate_hz <= seconds; ++k) {
    const double t = static_cast<double>(k) / rate_hz;
    std::vector<body::SegmentPose> at[5];
    for (int i = 0; i < 5; ++i) {
      at[i] = poses(t + h * (i - 2));
    }
    for (std::size_t b = 0; b < model.boards.size(); ++b) {
      const estimate::BodyBoard& board = model.boards[b];
      const auto s = static_cast<std::size_t>(board.segment);
      const auto place = [&](int i) { return Vector3d(at[i][s].p_WL + at[i][s].R_WL * board.p_LS); };
      const Quaterniond R_LS = board.R_LS * mount[b];
      const auto turn = [&](int i) { return at[i][s].R_WL * R_LS; };
      const Vector3d a = (-place(0) + 16.0 * place(1) - 30.0 * place(2) + 16.0 * place(3) - place(4)) / (12.0 * h * h);
      const Vector3d w =
          (8.0 * geometry::log_so3(turn(1).conjugate() * turn(3)) - geometry::log_so3(turn(0).conjugate() * turn(4))) /
          (12.0 * h);
      estimate::InertialReading reading;
      reading.time_s = t;
      reading.board = static_cast<int>(b);
      // The two differences are seen in frames to both sides; their middle is this one to the third order.
      const Vector3d rate = w + rate_bias[b] + draw(errors.rate_noise);
      const Vector3d force =
          turn(2).conjugate() * (a + Vector3d(0.0, 0.0, kStandardGravity)) + force_bias[b] + draw(errors.force_noise);
      if (board.gyroscope) {
        reading.w_S = rate;
      }
      if (board.accelerometer) {
        reading.f_S = force;
      }
      readings.inertial.push_back(reading);
    }
    readings.root.push_back({t, at[2].front().R_WL, at[2].front().p_WL});
  }
  constexpr double kSlot = 0.008;
  for (std::int64_t k = 0; !model.sources.empty() && static_cast<double>(k) * kSlot <= seconds; ++k) {
    const double t = static_cast<double>(k) * kSlot;
    const auto s = static_cast<std::size_t>(k) % model.sources.size();
    const auto now = poses(t);
    const auto& source = model.sources[s];
    const auto& from = now[static_cast<std::size_t>(source.segment)];
    const Vector3d p = from.p_WL + from.R_WL * source.p_LS;
    for (std::size_t b = 0; b < model.boards.size(); ++b) {
      if (!model.boards[b].microphone) {
        continue;
      }
      const auto segment = static_cast<std::size_t>(model.boards[b].segment);
      double distance = 0.0;
      for (int i = 0; i < 3; ++i) {
        const auto heard = poses(t + distance / 343.0);
        distance = (heard[segment].p_WL + heard[segment].R_WL * model.boards[b].p_LS - p).norm();
      }
      if (distance < 2.0) {
        readings.ranges.push_back(
            {t, static_cast<int>(s), static_cast<int>(b), distance + errors.range_noise * normal(random), 1.0});
      }
    }
  }
  return readings;
}

}  // namespace limbwave::testing_support
