/// A wearer drawn from the body filter's own model.
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <random>
#include <string>

#include "base/units.h"
#include "estimate/body_filter.h"
#include "geometry/so3.h"
#include "support/random_skeleton.h"

namespace limbwave::estimate {

using Eigen::VectorXd;
using testing_support::random_skeleton;
using testing_support::random_vector;

/// A wearer who moves just as the filter's model says, from a start drawn from its prior, with readings drawn from the
/// errors that it models.
class Drawn {
 public:
  Drawn(unsigned seed, const BodyFilterParameters& parameters) : random_(seed), parameters_(parameters) {
    body::Skeleton skeleton = random_skeleton(random_, 5);
    for (body::Segment& segment : skeleton.segments) {
      segment.p_PL *= 1.5;
    }
    model.skeleton = skeleton;
    for (std::size_t s = 0; s < skeleton.segments.size(); ++s) {
      BodyBoard board;
      board.name = skeleton.segments[s].name;
      board.segment = static_cast<int>(s);
      board.R_LS = geometry::exp_so3(random_vector(random_, 1.0));
      board.p_LS = random_vector(random_, 0.1);
      board.gyroscope = board.accelerometer = board.microphone = true;
      model.boards.push_back(board);
    }
    for (int s = 0; s < 2; ++s) {
      model.sources.push_back({"source " + std::to_string(s), s, random_vector(random_, 0.3), Vector3d::UnitX()});
    }
  }

  double normal() { return normal_(random_); }

  void start(BodyFilter& filter) {
    filter.start(0.0, nullptr);
    const ErrorCovariance& P = filter.covariance();
    VectorXd x(P.size());
    for (int i = 0; i < P.size(); ++i) {
      x[i] = std::sqrt(P(i, i)) * normal();
    }
    truth = filter.state();
    filter.inject(truth, x);
  }

  void move(const BodyFilter& filter, double dt) {
    const int n = filter.layout().dofs;
    Eigen::Matrix3d Q;
    Q << std::pow(dt, 5) / 20, std::pow(dt, 4) / 8, std::pow(dt, 3) / 6, std::pow(dt, 4) / 8, std::pow(dt, 3) / 3,
        dt * dt / 2, std::pow(dt, 3) / 6, dt * dt / 2, dt;
    const Eigen::Matrix3d L = Q.llt().matrixL();
    body::TreeState& joints = truth.joints;
    VectorXd delta = dt * joints.qd + 0.5 * dt * dt * joints.qdd;
    for (const body::TreeLink& link : filter.tree().links()) {
      if (link.kind == body::LinkKind::kBall) {
        const Vector3d w = joints.qd.segment<3>(link.first);
        const Vector3d al = joints.qdd.segment<3>(link.first);
        delta.segment<3>(link.first) += dt * dt * dt / 12.0 * w.cross(al);
      }
    }
    move_skin(filter, dt);
    joints.qd += dt * joints.qdd;
    for (int i = 0; i < n; ++i) {
      const Vector3d w = parameters_.acceleration_walk * (L * Vector3d(normal(), normal(), normal()));
      delta[i] += w[0];
      joints.qd[i] += w[1];
      joints.qdd[i] += w[2];
    }
    filter.tree().add(joints, delta);
    truth.time_s += dt;
  }

  // Skin as its stochastic equation says, in small steps: dψ = (g − ψ/L) ds, dg = −g/L ds + noise (README.md).
  void move_skin(const BodyFilter& filter, double dt) {
    if (parameters_.tissue_angle <= 0.0) {
      return;
    }
    body::TreeKinematics kinematics(filter.tree());
    kinematics.update(truth.joints);
    const double L = parameters_.tissue_turn;
    const double sigma = std::sqrt(2.0) * parameters_.tissue_angle / L;
    constexpr int kSteps = 10;
    for (std::size_t b = 0; b < model.boards.size(); ++b) {
      const double ds = dt * kinematics.link(filter.tree().link_of(model.boards[b].segment)).w.norm() / kSteps;
      for (int k = 0; k < kSteps; ++k) {
        Vector3d& g = truth.tissue_gain[b];
        truth.tissue_angle[b] += (g - truth.tissue_angle[b] / L) * ds;
        g += -g / L * ds + sigma * std::sqrt(2.0 * ds / L) * Vector3d(normal(), normal(), normal());
      }
    }
  }

  void measure(const BodyFilter& filter, bool ranges, BodyReadings& readings) {
    body::TreeKinematics kinematics(filter.tree());
    std::vector<double> scale;
    for (const body::TreeLink& link : filter.tree().links()) {
      scale.push_back(link.parent < 0
                          ? 1.0
                          : 1.0 + truth.bone_scale[static_cast<std::size_t>(
                                      filter.tree().links()[static_cast<std::size_t>(link.parent)].segment)]);
    }
    kinematics.update(truth.joints, scale);
    const auto noise = [&](double sigma) { return Vector3d(sigma * Vector3d(normal(), normal(), normal())); };
    std::vector<body::TreeKinematics::PointMotion> places;
    for (std::size_t b = 0; b < model.boards.size(); ++b) {
      const BodyBoard& board = model.boards[b];
      const int link = filter.tree().link_of(board.segment);
      const auto point = kinematics.point(link, board.p_LS + truth.mount_place[b]);
      places.push_back(point);
      const Eigen::Matrix3d R_SW =
          (kinematics.link(link).R_WL *
           (board.R_LS * truth.mount_rotation[b] * geometry::exp_so3(truth.tissue_angle[b])).toRotationMatrix())
              .transpose();
      InertialReading reading;
      reading.time_s = truth.time_s;
      reading.board = static_cast<int>(b);
      reading.w_S = R_SW * kinematics.link(link).w + kinematics.link(link).w.norm() * truth.tissue_gain[b] +
                    truth.gyroscope_bias[b] + noise(parameters_.gyroscope_noise);
      reading.f_S = R_SW * (point.a + Vector3d(0, 0, kStandardGravity)) + truth.accelerometer_bias[b] +
                    noise(parameters_.accelerometer_noise);
      readings.inertial.push_back(reading);
    }
    for (std::size_t s = 0; ranges && s < model.sources.size(); ++s) {
      const int link = filter.tree().link_of(model.sources[s].segment);
      const Vector3d from = kinematics.point(link, model.sources[s].p_LS + truth.source_place[s]).p;
      for (std::size_t b = 0; b < places.size(); ++b) {
        const double flight = (places[b].p - from).norm() / 343.0;
        readings.ranges.push_back({truth.time_s, static_cast<int>(s), static_cast<int>(b),
                                   (1.0 + truth.sound_scale) * (places[b].p + flight * places[b].v - from).norm() +
                                       parameters_.range_noise * normal(),
                                   1.0});
      }
    }
  }

  // The filter's error as an error state.
  [[nodiscard]] VectorXd error(const BodyFilter& filter) const { return filter.difference(filter.state(), truth); }

  BodyModel model;
  BodyState truth;

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  BodyFilterParameters parameters_;
};

inline BodyFilterParameters modelled_errors_only() {
  BodyFilterParameters p;
  p.root = RootMode::kFixed;
  p.gyroscope_noise = 0.02;
  p.accelerometer_noise = 0.2;
  p.range_noise = 0.005;
  p.range_model = 0.0;
  p.gyroscope_relative = p.accelerometer_relative = 0.0;
  // Small enough that products of two errors, which no extended Kalman filter models, stay below the noise.
  p.acceleration_walk = 2.0;
  p.start_rate = 0.05;
  p.start_acceleration = 0.5;
  p.bone_scale = 0.01;
  p.gyroscope_bias_walk = p.accelerometer_bias_walk = p.mount_rotation_walk = p.mount_place_walk = 0.0;
  p.range_offset_walk = p.sound_scale_walk = 0.0;
  p.mount_rotation = 0.01;
  p.accelerometer_bias = 0.05;
  p.tissue_angle = 0.0;
  p.acceleration_time = 0.0;
  p.rest_pose = 0.035;
  p.limit_softness = 0.0;
  p.gate_probability = 0.0;
  return p;
}

}  // namespace limbwave::estimate
