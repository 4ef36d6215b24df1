/// The textbook's extended Kalman filter with dense matrices, fed with the same linearisations as the body filter: what
/// it is compared with for its answer and its speed. x = x + K ν, P = (I − K H) P, P = F P Fᵀ + Q.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "estimate/body_filter.h"

namespace limbwave::testing_support {

/// F and Q of a prediction. Q: a white jerk on every degree of freedom, walks of constants, skin.
inline void dense_process(const estimate::BodyFilter& filter, const estimate::PredictRecord& predict,
                          Eigen::MatrixXd& F, Eigen::MatrixXd& Q) {
  using Row = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const estimate::BodyFilterParameters& p = filter.parameters();
  const estimate::BodyLayout& layout = filter.layout();
  const int n = layout.dofs;
  const double dt = predict.dt;
  F.setIdentity(layout.size, layout.size);
  Q.setZero(layout.size, layout.size);
  auto ball = predict.balls.begin();
  for (const body::TreeLink& link : filter.tree().links()) {
    if (link.kind == body::LinkKind::kBall) {
      F.block<3, 3>(link.first, link.first) = Eigen::Map<const Row>(ball->A.data());
      F.block<3, 3>(link.first, n + link.first) = Eigen::Map<const Row>(ball->B.data());
      F.block<3, 3>(link.first, 2 * n + link.first) = Eigen::Map<const Row>(ball->C.data());
      ++ball;
    } else {
      for (int i = link.first; i < link.first + link.count; ++i) {
        F(i, n + i) = dt;
        F(i, 2 * n + i) = predict.c;
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    F(n + i, 2 * n + i) = predict.va;
    F(2 * n + i, 2 * n + i) = predict.aa;
    const bool place = filter.tree().root_motion() == body::RootMotion::kFree && i < 3;
    const double q = std::pow(place ? p.root_acceleration_walk : p.acceleration_walk, 2);
    Q(i, i) = q * std::pow(dt, 5) / 20.0;
    Q(i, n + i) = Q(n + i, i) = q * std::pow(dt, 4) / 8.0;
    Q(i, 2 * n + i) = Q(2 * n + i, i) = q * std::pow(dt, 3) / 6.0;
    Q(n + i, n + i) = q * std::pow(dt, 3) / 3.0;
    Q(n + i, 2 * n + i) = Q(2 * n + i, n + i) = q * dt * dt / 2.0;
    Q(2 * n + i, 2 * n + i) = q * dt;
  }
  const auto walk = [&](const std::vector<int>& first, int count, double sigma) {
    for (const int f : first) {
      for (int i = 0; f >= 0 && i < count; ++i) {
        Q(f + i, f + i) = sigma * sigma * dt;
      }
    }
  };
  walk(layout.gyroscope_bias, 3, p.gyroscope_bias_walk);
  walk(layout.accelerometer_bias, 3, p.accelerometer_bias_walk);
  walk(layout.mount_rotation, 3, p.mount_rotation_walk);
  walk(layout.mount_place, 3, p.mount_place_walk);
  walk(layout.range_offset, 1, p.range_offset_walk);
  walk({layout.sound_scale}, 1, p.sound_scale_walk);
  for (const estimate::PredictRecord::Tissue& t : predict.tissues) {
    for (int i = 0; i < 3; ++i) {
      F(t.angle + i, t.angle + i) = F(t.gain + i, t.gain + i) = t.a;
      F(t.angle + i, t.gain + i) = t.b;
      Q(t.angle + i, t.angle + i) = t.angle_noise;
      Q(t.gain + i, t.gain + i) = t.gain_noise;
      Q(t.angle + i, t.gain + i) = Q(t.gain + i, t.angle + i) = t.both_noise;
    }
  }
}

/// The rows of an update, those that the body filter accepted.
inline void dense_rows(const std::vector<estimate::MeasurementGroup>& groups, long size, Eigen::MatrixXd& H,
                       Eigen::VectorXd& nu, Eigen::VectorXd& R) {
  long rows = 0;
  for (const auto& g : groups) {
    rows += g.rows;
  }
  H.setZero(rows, size);
  nu.resize(rows);
  R.resize(rows);
  long at = 0;
  for (const auto& g : groups) {
    for (int r = 0; r < g.rows; ++r, ++at) {
      for (std::size_t s = 0; s < g.support.size(); ++s) {
        H(at, g.support[s]) += g.H[s * static_cast<std::size_t>(g.rows) + static_cast<std::size_t>(r)];
      }
      nu[at] = g.innovation[r];
      R[at] = g.variance[r];
    }
  }
}

class DenseEkf {
 public:
  Eigen::MatrixXd P;
  Eigen::VectorXd x;  ///< Sum of this step's corrections.

  void predict(const Eigen::MatrixXd& F, const Eigen::MatrixXd& Q) {
    P = F * P * F.transpose() + Q;
    x.setZero(P.rows());
  }
  void update(const Eigen::MatrixXd& H, const Eigen::VectorXd& nu, const Eigen::VectorXd& R) {
    Eigen::MatrixXd S = H * P * H.transpose();
    S.diagonal() += R;
    const Eigen::MatrixXd K = S.llt().solve(H * P).transpose();
    x += K * nu;
    P = (Eigen::MatrixXd::Identity(P.rows(), P.cols()) - K * H) * P;
  }
};

}  // namespace limbwave::testing_support
