// How the state moves on from one instant to the next.
#include <algorithm>
#include <cmath>

#include "estimate/body_filter.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using body::LinkKind;
using body::TreeLink;
using Eigen::Matrix3d;
using Eigen::VectorXd;
using RowMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// How skin moves on while its segment turns by s (in lengths of its memory): ψ' = a (ψ + s g), g' = a g, and what
// chance adds to their variances, for g of variance 1.
struct TissueStep {
  double a, psi, psi_g, g;
};
TissueStep tissue_step(double s) {
  const double x = 2.0 * s;
  const double kept = std::exp(-x);
  if (x < 1e-2) {
    // The first terms of what follows, which loses digits here.
    return {std::exp(-s), x * x * x / 12.0 * (1.0 - 0.75 * x), x * x / 4.0 * (1.0 - 2.0 / 3.0 * x), 1.0 - kept};
  }
  return {std::exp(-s), 0.25 * (2.0 - kept * (2.0 + x * (2.0 + x))), 0.5 * (1.0 - kept * (1.0 + x)), 1.0 - kept};
}

}  // namespace

double BodyFilter::tissue_gain_sigma() const {
  return std::sqrt(2.0) * parameters_.tissue_angle / parameters_.tissue_turn;
}

// The rotation ψ of a board on its skin has, as a function of the angle its segment has turned, a slope g, and both are
// forgotten within `tissue_turn`: skin slides in step with the motion and keeps still with it.
void BodyFilter::predict_tissue(double dt) {
  const double memory = parameters_.tissue_turn;
  const double sigma = tissue_gain_sigma();
  tissue_steps_.clear();
  for (std::size_t b = 0; b < model_.boards.size(); ++b) {
    if (layout_.tissue_angle[b] < 0) {
      continue;
    }
    const double s = dt * kinematics_.link(tree_.link_of(model_.boards[b].segment)).w.norm() / memory;
    const TissueStep step = tissue_step(s);
    const double q = sigma * sigma;
    tissue_steps_.push_back({layout_.tissue_angle[b], layout_.tissue_gain[b], step.a, step.a * s * memory,
                             q * memory * memory * step.psi, q * memory * step.psi_g, q * step.g});
    state_.tissue_angle[b] = step.a * (state_.tissue_angle[b] + s * memory * state_.tissue_gain[b]);
    state_.tissue_gain[b] *= step.a;
  }
}

// Rows of P that move become F times themselves, over so many columns.
void BodyFilter::move_rows(const PredictRecord& step, long columns) {
  const CovarianceKernel& kernel = P_.kernel();
  const long stride = P_.stride();
  const int n = layout_.dofs;
  double* P = P_.row(0);
  const auto row = [&](int i) { return P + i * stride; };
  auto ball = step.balls.begin();
  for (const TreeLink& link : tree_.links()) {
    if (link.kind == LinkKind::kBall) {
      kernel.mix_rows(row(link.first), row(n + link.first), row(2 * n + link.first), ball->A.data(), ball->B.data(),
                      ball->C.data(), stride, columns);
      ++ball;
    }
    for (int i = link.first; i < link.first + link.count; ++i) {
      if (link.kind != LinkKind::kBall) {
        kernel.subtract(row(i), row(n + i), -step.dt, columns);
        kernel.subtract(row(i), row(2 * n + i), -step.c, columns);
      }
      kernel.subtract(row(n + i), row(2 * n + i), -step.va, columns);
      if (step.aa != 1.0) {
        kernel.subtract(row(2 * n + i), row(2 * n + i), 1.0 - step.aa, columns);
      }
    }
  }
  for (const PredictRecord::Tissue& t : step.tissues) {
    for (int i = 0; i < 3; ++i) {
      kernel.blend(row(t.angle + i), row(t.gain + i), t.a, t.b, columns);
      kernel.subtract(row(t.gain + i), row(t.gain + i), 1.0 - t.a, columns);
    }
  }
}

// What chance adds to the rows that move, right of the diagonal: a white jerk, and skin.
void BodyFilter::add_process_noise(const PredictRecord& step) {
  const BodyFilterParameters& p = parameters_;
  const int n = layout_.dofs;
  const double dt = step.dt;
  const double dt2 = dt * dt;
  const bool free_root = tree_.root_motion() == body::RootMotion::kFree;
  for (int i = 0; i < n; ++i) {
    const double walk = free_root && i < 3 ? p.root_acceleration_walk : p.acceleration_walk;
    const double q = walk * walk;
    P_.add_variance(2 * n + i, q * dt);
    P_.add_variance(n + i, q * dt2 * dt / 3.0);
    P_.add_variance(i, q * dt2 * dt2 * dt / 20.0);
    P_.row(n + i)[2 * n + i] += q * dt2 / 2.0;
    P_.row(i)[2 * n + i] += q * dt2 * dt / 6.0;
    P_.row(i)[n + i] += q * dt2 * dt2 / 8.0;
  }
  for (const PredictRecord::Tissue& t : step.tissues) {
    for (int i = 0; i < 3; ++i) {
      P_.add_variance(t.angle + i, t.angle_noise);
      P_.add_variance(t.gain + i, t.gain_noise);
      P_.row(t.angle + i)[t.gain + i] += t.both_noise;
    }
  }
}

// P = F P Fᵀ + Q. Only the first rows of P move: F P is made of rows; what of it lies right of them is mirrored, and
// the square at their crossing is transposed and made of rows once more.
void BodyFilter::predict_covariance(const PredictRecord& step) {
  const CovarianceKernel& kernel = P_.kernel();
  const long stride = P_.stride();
  const long moving = (layout_.moving + 7) / 8 * 8;
  double* P = P_.row(0);
  const long width = P_.width();
  move_rows(step, width);
  kernel.transpose_square(P, stride, moving);
  move_rows(step, moving);
  add_process_noise(step);
  kernel.mirror(P, stride, moving);
  kernel.transpose(P + moving, moving, width - moving, stride, P + moving * stride, stride);
  const auto walk = [&](const std::vector<int>& first, int count, double sigma) {
    for (const int f : first) {
      for (int i = 0; f >= 0 && i < count; ++i) {
        P_.add_variance(f + i, sigma * sigma * step.dt);
      }
    }
  };
  const BodyFilterParameters& p = parameters_;
  walk(layout_.gyroscope_bias, 3, p.gyroscope_bias_walk);
  walk(layout_.accelerometer_bias, 3, p.accelerometer_bias_walk);
  walk(layout_.mount_rotation, 3, p.mount_rotation_walk);
  walk(layout_.mount_place, 3, p.mount_place_walk);
  walk(layout_.range_offset, 1, p.range_offset_walk);
  walk({layout_.sound_scale}, 1, p.sound_scale_walk);
}

// θ ⊞ (dt θ̇ + c θ̈), θ̇ + va θ̈, aa θ̈: the paper's eq. (1), with Singer's memory where the acceleration has one.
void BodyFilter::predict(double dt, PredictRecord* record) {
  PredictRecord own;
  PredictRecord& step = record != nullptr ? *record : own;
  step = {};
  step.dt = step.va = dt;
  step.c = 0.5 * dt * dt;
  if (parameters_.acceleration_time > 0.0) {
    const double b = 1.0 / parameters_.acceleration_time;
    step.aa = std::exp(-b * dt);
    step.va = (1.0 - step.aa) / b;
    step.c = (b * dt - 1.0 + step.aa) / (b * b);
  }
  body::TreeState& joints = state_.joints;
  kinematics_.update(joints, place_scale());
  VectorXd delta = dt * joints.qd + step.c * joints.qdd;
  for (const TreeLink& link : tree_.links()) {
    if (link.kind != LinkKind::kBall) {
      continue;
    }
    const Vector3d w = joints.qd.segment<3>(link.first);
    const Vector3d al = joints.qdd.segment<3>(link.first);
    // The third-order term of coning.
    const Vector3d phi = dt * w + step.c * al + dt * dt * dt / 12.0 * w.cross(al);
    delta.segment<3>(link.first) = phi;
    PredictRecord::Ball& ball = step.balls.emplace_back();
    ball.first = link.first;
    const Matrix3d J = geometry::right_jacobian(phi);
    Eigen::Map<RowMatrix3>(ball.A.data()) = geometry::exp_so3(-phi).toRotationMatrix();
    Eigen::Map<RowMatrix3>(ball.B.data()) = dt * J;
    Eigen::Map<RowMatrix3>(ball.C.data()) = step.c * J;
  }
  predict_tissue(dt);
  step.tissues = tissue_steps_;
  predict_covariance(step);

  tree_.add(joints, delta);
  joints.qd += step.va * joints.qdd;
  joints.qdd *= step.aa;
  state_.time_s += dt;
}

}  // namespace limbwave::estimate
