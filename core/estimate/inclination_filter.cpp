#include "estimate/inclination_filter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using Eigen::Matrix3d;
using Matrix = InclinationFilter::Matrix;
using Vector = InclinationFilter::Vector;

// A limb cannot turn the same way for long; its rate is forgotten in about a second.
constexpr double kRateTime = 1.0;
// Angular acceleration of unhurried limbs, rad/s²: half a radian of amplitude at half a hertz.
constexpr double kCalmAngularAcceleration = 4.0;
// Limbs accelerate by turning about joints; sensors sit about this far from the joint that moves them, metres.
constexpr double kLever = 0.4;
// For how long angular acceleration keeps its sign, seconds; makes a white noise density of its variance.
constexpr double kAngularAccelerationTime = 0.2;
// An acceleration of limbs keeps its sign for at most half a second (line-in paper §5), typically a third.
constexpr double kAccelerationOmega = 2.0 * kPi * 1.5;
constexpr double kAccelerationDamping = 0.7;
// Limb acceleration that is always possible, m/s²; keeps covariances positive, is 0.006° of direction.
constexpr double kLeastAcceleration = 1e-3;
// Nothing is bridged over more than this without readings, seconds.
constexpr double kLongestGap = 1.0;
// 0.1 % of χ² with two degrees of freedom.
constexpr double kGate = 13.8;

constexpr int kTheta = 0;
constexpr int kRate = 2;
constexpr int kVelocity = 4;
constexpr int kAcceleration = 7;

void symmetrise(Matrix& P) {
  P = 0.5 * (P + P.transpose()).eval();
}

void correct(InclinationFilter::State& state, const Vector& dx) {
  state.R_NL = geometry::exp_so3({dx[0], dx[1], 0.0}) * state.R_NL;
  state.R_NL.normalize();
  state.w += dx.segment<2>(kRate);
  state.y += dx.segment<3>(kVelocity);
  state.a += dx.segment<3>(kAcceleration);
}

}  // namespace

void InclinationFilter::start(const ForceSample& sample, double acceleration_sd, double noise) {
  state_ = State{};
  state_.R_NL = geometry::shortest_arc(sample.f_L, Vector3d::UnitZ());
  const double direction = std::hypot(acceleration_sd, noise) / kStandardGravity;
  const double a = std::max(acceleration_sd, kLeastAcceleration);
  state_.P.diagonal() << direction * direction + 1e-10, direction * direction + 1e-10, 1.0, 1.0,
      Vector3d::Constant(std::pow(a / kAccelerationOmega, 2)), Vector3d::Constant(a * a);
  record_ = Record{};
  record_.predicted = record_.updated = state_;
  started_ = true;
}

void InclinationFilter::predict(double dt, double acceleration_sd) {
  Matrix& F = record_.F;
  F.setIdentity();
  const double decay = std::exp(-dt / kRateTime);
  const double turned = kRateTime * (1.0 - decay);
  F.block<2, 2>(kTheta, kRate) = turned * Eigen::Matrix2d::Identity();
  F.block<2, 2>(kRate, kRate) = decay * Eigen::Matrix2d::Identity();
  const double damping = kAccelerationDamping * kAccelerationOmega;
  const double damped = kAccelerationOmega * std::sqrt(1.0 - kAccelerationDamping * kAccelerationDamping);
  const double e = std::exp(-damping * dt);
  const double c = std::cos(damped * dt);
  const double s = std::sin(damped * dt) / damped;
  Eigen::Matrix2d oscillator;
  oscillator << e * (c + damping * s), e * s, -e * kAccelerationOmega * kAccelerationOmega * s, e * (c - damping * s);
  F.block<3, 3>(kVelocity, kVelocity) = oscillator(0, 0) * Matrix3d::Identity();
  F.block<3, 3>(kVelocity, kAcceleration) = oscillator(0, 1) * Matrix3d::Identity();
  F.block<3, 3>(kAcceleration, kVelocity) = oscillator(1, 0) * Matrix3d::Identity();
  F.block<3, 3>(kAcceleration, kAcceleration) = oscillator(1, 1) * Matrix3d::Identity();

  const double lever_rate = acceleration_sd / kLever;
  // Smoothing over longer times means slower turning: the density goes with the third power of time.
  const double slower = std::pow(0.08 / parameters_.smoothing_s, 3);
  const double q = slower * kAngularAccelerationTime *
                   (kCalmAngularAcceleration * kCalmAngularAcceleration + lever_rate * lever_rate);
  Matrix Q = Matrix::Zero();
  Q.block<2, 2>(kTheta, kTheta) = q * dt * dt * dt / 3.0 * Eigen::Matrix2d::Identity();
  Q.block<2, 2>(kTheta, kRate) = q * dt * dt / 2.0 * Eigen::Matrix2d::Identity();
  Q.block<2, 2>(kRate, kTheta) = Q.block<2, 2>(kTheta, kRate);
  Q.block<2, 2>(kRate, kRate) = q * dt * Eigen::Matrix2d::Identity();
  // What the oscillator needs to keep its stationary covariance diag(σ²/ω0², σ²).
  const double a = std::max(acceleration_sd, kLeastAcceleration);
  const Eigen::Matrix2d stationary =
      Eigen::Vector2d(std::pow(a / kAccelerationOmega, 2), a * a).asDiagonal().toDenseMatrix();
  const Eigen::Matrix2d driven = stationary - oscillator * stationary * oscillator.transpose();
  Q.block<3, 3>(kVelocity, kVelocity) = driven(0, 0) * Matrix3d::Identity();
  Q.block<3, 3>(kVelocity, kAcceleration) = driven(0, 1) * Matrix3d::Identity();
  Q.block<3, 3>(kAcceleration, kVelocity) = driven(1, 0) * Matrix3d::Identity();
  Q.block<3, 3>(kAcceleration, kAcceleration) = driven(1, 1) * Matrix3d::Identity();

  state_.R_NL = geometry::exp_so3({turned * state_.w.x(), turned * state_.w.y(), 0.0}) * state_.R_NL;
  state_.w *= decay;
  const Vector3d velocity = state_.y;
  state_.y = oscillator(0, 0) * velocity + oscillator(0, 1) * state_.a;
  state_.a = oscillator(1, 0) * velocity + oscillator(1, 1) * state_.a;
  state_.P = F * state_.P * F.transpose() + Q;
  symmetrise(state_.P);
}

void InclinationFilter::update(const ForceSample& sample, double acceleration_sd, double noise) {
  // With R_NL = exp(θ) R̂_NL the model R_NL f_L = g z + a + noise becomes f̂_N − g z − â = f̂_N × θ + δa + noise.
  const Vector3d f_N = state_.R_NL * sample.f_L;
  const Vector3d innovation = f_N - kStandardGravity * Vector3d::UnitZ() - state_.a;
  const Matrix3d cross = geometry::skew(f_N);
  Eigen::Matrix<double, 6, kStates> H = Eigen::Matrix<double, 6, kStates>::Zero();
  H.block<3, 2>(0, kTheta) = cross.leftCols<2>();
  H.block<3, 3>(0, kAcceleration) = Matrix3d::Identity();
  H.block<3, 3>(3, kAcceleration) = Matrix3d::Identity();
  const double r = noise * noise;

  // A turn that no limb can do in one cycle is an acceleration that |f| has not shown yet.
  const Eigen::Matrix<double, 2, kStates> H2 = H.topRows<2>();
  const Eigen::Matrix2d S2 = H2 * state_.P * H2.transpose() + r * Eigen::Matrix2d::Identity();
  const double nis = innovation.head<2>().dot(S2.ldlt().solve(innovation.head<2>()));
  const bool jump = nis > kGate;
  if (jump) {
    const double burst = innovation.head<2>().squaredNorm() / kGate;
    state_.P.diagonal().segment<3>(kAcceleration).array() += burst;
    record_.predicted.P = state_.P;
  }
  // Where nothing hints at acceleration there is none, and the limb's velocity has come to rest as far as we can tell.
  const bool calm = acceleration_sd <= 0.0 && !jump;
  const int rows = calm ? 6 : 3;
  Eigen::Matrix<double, 6, 1> z;
  z << innovation, -state_.a;
  const Eigen::MatrixXd Hn = H.topRows(rows);
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(rows, rows);
  R.diagonal().head(3).setConstant(r);
  if (calm) {
    R.diagonal().tail(3).setConstant(kLeastAcceleration * kLeastAcceleration);
  }
  const Eigen::MatrixXd PHt = state_.P * Hn.transpose();
  const Eigen::MatrixXd S = Hn * PHt + R;
  const Eigen::MatrixXd K = S.ldlt().solve(PHt.transpose()).transpose();
  const Vector dx = K * z.head(rows);
  correct(state_, dx);
  const Matrix A = Matrix::Identity() - K * Hn;
  state_.P = A * state_.P * A.transpose() + K * R * K.transpose();
  symmetrise(state_.P);
}

void InclinationFilter::step(const ForceSample& sample, double acceleration_sd, double noise) {
  const double dt = sample.time_s - time_s_;
  const bool usable = sample.usable && sample.f_L.allFinite() && sample.f_L.squaredNorm() > 1e-6;
  if (!started_) {
    if (usable) {
      start(sample, acceleration_sd, noise);
    }
    time_s_ = sample.time_s;
    return;
  }
  record_.connected = dt <= kLongestGap;
  if (!record_.connected && usable) {
    start(sample, acceleration_sd, noise);
    time_s_ = sample.time_s;
    return;
  }
  predict(std::min(dt, kLongestGap), acceleration_sd);
  time_s_ = sample.time_s;
  record_.predicted = state_;
  if (usable) {
    update(sample, acceleration_sd, noise);
  }
  record_.updated = state_;
}

std::vector<InclinationFilter::State> InclinationFilter::smooth(const std::vector<Record>& records) {
  std::vector<State> states(records.size());
  for (std::size_t k = records.size(); k-- > 0;) {
    State& state = states[k];
    state = records[k].updated;
    if (k + 1 == records.size() || !records[k + 1].connected) {
      continue;
    }
    const Record& next = records[k + 1];
    const State& ahead = states[k + 1];
    const Matrix C = next.predicted.P.ldlt().solve(next.F * records[k].updated.P).transpose();
    Vector difference;
    const Vector3d turn = geometry::log_so3(ahead.R_NL * next.predicted.R_NL.conjugate());
    difference << turn.x(), turn.y(), ahead.w - next.predicted.w, ahead.y - next.predicted.y,
        ahead.a - next.predicted.a;
    correct(state, C * difference);
    state.P += C * (ahead.P - next.predicted.P) * C.transpose();
    symmetrise(state.P);
  }
  return states;
}

double InclinationFilter::direction_sd(const State& state) {
  return std::sqrt(std::max(0.0, 0.5 * (state.P(0, 0) + state.P(1, 1))));
}

}  // namespace limbwave::estimate
