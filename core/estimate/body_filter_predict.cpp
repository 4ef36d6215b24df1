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
void BodyFilter::predict_tissue(double dt, PredictRecord* record) {
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
    const PredictRecord::Tissue& t = tissue_steps_.back();
    for (int i = 0; i < 3; ++i) {
      double* angle = P_.row(t.angle + i);
      double* gain = P_.row(t.gain + i);
      for (int k = 0; k < layout_.size; ++k) {
        angle[k] = t.a * angle[k] + t.b * gain[k];
        gain[k] *= t.a;
      }
    }
  }
  for (int k = 0; k < layout_.size; ++k) {
    double* x = P_.row(k);
    for (const PredictRecord::Tissue& t : tissue_steps_) {
      for (int i = 0; i < 3; ++i) {
        x[t.angle + i] = t.a * x[t.angle + i] + t.b * x[t.gain + i];
        x[t.gain + i] *= t.a;
      }
    }
  }
  for (const PredictRecord::Tissue& t : tissue_steps_) {
    for (int i = 0; i < 3; ++i) {
      P_.add_variance(t.angle + i, t.angle_noise);
      P_.add_variance(t.gain + i, t.gain_noise);
      P_.row(t.angle + i)[t.gain + i] += t.both_noise;
      P_.row(t.gain + i)[t.angle + i] += t.both_noise;
    }
  }
  if (record != nullptr) {
    record->tissues = tissue_steps_;
  }
}

// θ ⊞ (dt θ̇ + c θ̈), θ̇ + va θ̈, aa θ̈: the paper's eq. (1), with Singer's memory where the acceleration has one.
void BodyFilter::predict(double dt, PredictRecord* record) {
  const BodyFilterParameters& p = parameters_;
  const int n = layout_.dofs;
  double va = dt;
  double aa = 1.0;
  double c = 0.5 * dt * dt;
  if (p.acceleration_time > 0.0) {
    const double b = 1.0 / p.acceleration_time;
    aa = std::exp(-b * dt);
    va = (1.0 - aa) / b;
    c = (b * dt - 1.0 + aa) / (b * b);
  }
  if (record != nullptr) {
    record->dt = dt;
    record->va = va;
    record->aa = aa;
    record->c = c;
    record->balls.clear();
  }
  body::TreeState& joints = state_.joints;
  kinematics_.update(joints, place_scale());
  VectorXd delta = dt * joints.qd + c * joints.qdd;
  const CovarianceKernel& kernel = P_.kernel();
  const long stride = P_.stride();
  double* P = P_.row(0);
  const auto row = [&](int i) { return P + i * stride; };
  std::vector<PredictRecord::Ball> balls;
  // Rows: F P.
  for (const TreeLink& link : tree_.links()) {
    if (link.kind == LinkKind::kBall) {
      const Vector3d w = joints.qd.segment<3>(link.first);
      const Vector3d al = joints.qdd.segment<3>(link.first);
      // The third-order term of coning.
      const Vector3d phi = dt * w + c * al + dt * dt * dt / 12.0 * w.cross(al);
      delta.segment<3>(link.first) = phi;
      PredictRecord::Ball ball;
      ball.first = link.first;
      const Matrix3d J = geometry::right_jacobian(phi);
      Eigen::Map<RowMatrix3>(ball.A.data()) = geometry::exp_so3(-phi).toRotationMatrix();
      Eigen::Map<RowMatrix3>(ball.B.data()) = dt * J;
      Eigen::Map<RowMatrix3>(ball.C.data()) = c * J;
      kernel.mix_rows(row(link.first), row(n + link.first), row(2 * n + link.first), ball.A.data(), ball.B.data(),
                      ball.C.data(), stride);
      balls.push_back(ball);
    } else {
      for (int i = link.first; i < link.first + link.count; ++i) {
        kernel.subtract(row(i), row(n + i), -dt, stride);
        kernel.subtract(row(i), row(2 * n + i), -c, stride);
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    kernel.subtract(row(n + i), row(2 * n + i), -va, stride);
    if (aa != 1.0) {
      kernel.subtract(row(2 * n + i), row(2 * n + i), 1.0 - aa, stride);
    }
  }
  // Columns of the dynamic rows: (F P) Fᵀ.
  for (int i = 0; i < 3 * n; ++i) {
    double* x = row(i);
    double* v = x + n;
    double* a = x + 2 * n;
    auto ball = balls.begin();
    for (const TreeLink& link : tree_.links()) {
      const int f = link.first;
      if (link.kind == LinkKind::kBall) {
        const double t0 = x[f];
        const double t1 = x[f + 1];
        const double t2 = x[f + 2];
        for (std::size_t r = 0; r < 3; ++r) {
          x[f + static_cast<int>(r)] = ball->A[3 * r] * t0 + ball->A[3 * r + 1] * t1 + ball->A[3 * r + 2] * t2 +
                                       ball->B[3 * r] * v[f] + ball->B[3 * r + 1] * v[f + 1] +
                                       ball->B[3 * r + 2] * v[f + 2] + ball->C[3 * r] * a[f] +
                                       ball->C[3 * r + 1] * a[f + 1] + ball->C[3 * r + 2] * a[f + 2];
        }
        ++ball;
      } else {
        for (int k = f; k < f + link.count; ++k) {
          x[k] += dt * v[k] + c * a[k];
        }
      }
    }
    for (int k = 0; k < n; ++k) {
      v[k] += va * a[k];
      a[k] *= aa;
    }
  }
  // Process noise of a white jerk, and exact symmetry.
  const bool free_root = tree_.root_motion() == body::RootMotion::kFree;
  for (int i = 0; i < n; ++i) {
    const double walk = free_root && i < 3 ? p.root_acceleration_walk : p.acceleration_walk;
    const double q = walk * walk;
    const double dt2 = dt * dt;
    P_.add_variance(2 * n + i, q * dt);
    P_.add_variance(n + i, q * dt2 * dt / 3.0);
    P_.add_variance(i, q * dt2 * dt2 * dt / 20.0);
    row(n + i)[2 * n + i] += q * dt2 / 2.0;
    row(i)[2 * n + i] += q * dt2 * dt / 6.0;
    row(i)[n + i] += q * dt2 * dt2 / 8.0;
  }
  predict_tissue(dt, record);
  for (int i = 0; i < 3 * n; ++i) {
    const double* from = row(i);
    for (int k = i + 1; k < layout_.size; ++k) {
      row(k)[i] = from[k];
    }
  }
  const auto walk = [&](const std::vector<int>& first, int count, double sigma) {
    for (const int f : first) {
      for (int i = 0; f >= 0 && i < count; ++i) {
        P_.add_variance(f + i, sigma * sigma * dt);
      }
    }
  };
  walk(layout_.gyroscope_bias, 3, p.gyroscope_bias_walk);
  walk(layout_.accelerometer_bias, 3, p.accelerometer_bias_walk);
  walk(layout_.mount_rotation, 3, p.mount_rotation_walk);
  walk(layout_.mount_place, 3, p.mount_place_walk);
  walk(layout_.range_offset, 1, p.range_offset_walk);
  walk({layout_.sound_scale}, 1, p.sound_scale_walk);

  tree_.add(joints, delta);
  joints.qd += va * joints.qdd;
  joints.qdd *= aa;
  state_.time_s += dt;
  if (record != nullptr) {
    record->balls = std::move(balls);
  }
}

}  // namespace limbwave::estimate
