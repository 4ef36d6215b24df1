#include "estimate/inclination_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Matrix = InclinationFilter::Matrix;
using Axes = InclinationFilter::Axes;
using Column = Eigen::Matrix<double, InclinationFilter::kStates, 1>;

// Limbs turn back and forth: a movement once a second keeps the sign of its rate for half a second, so the rate is
// forgotten in half of that.
constexpr double kRateTime = 0.25;
// Angular acceleration of unhurried limbs, rad/s²: half a radian of amplitude at half a hertz.
constexpr double kCalmAngularAcceleration = 4.0;
// For how long angular acceleration keeps its sign, seconds; makes a white noise density of its variance.
constexpr double kAngularAccelerationTime = 0.2;
// An acceleration of limbs keeps its sign for at most half a second (line-in paper §5), typically a quarter; above
// some 4 Hz muscles do little.
constexpr double kAccelerationOmega = 2.0 * kPi * 2.0;
constexpr double kAccelerationDamping = 0.7;
constexpr double kAccelerationRolloff = 2.0 * kPi * 4.0;
// Limb acceleration that is always possible, m/s²; keeps covariances positive, is 0.006° of direction.
constexpr double kLeastAcceleration = 1e-3;
// How far the very first reading is believed, radians.
constexpr double kFirstReadingSd = 0.5;
// Beyond this disagreement in calm readings the filter starts anew, radians.
constexpr double kLostAngle = 1.0;
// Nothing is bridged over more than this without readings, seconds.
constexpr double kLongestGap = 1.0;
// 0.1 % of χ² with two degrees of freedom.
constexpr double kGate = 13.8;
// Degrees of freedom of Student's t in the likelihood of a sample.
constexpr double kStudent = 4.0;

constexpr int kTilt = 0;
constexpr int kRate = 1;
constexpr int kAcceleration = 3;

Matrix3d acceleration_dynamics() {
  Matrix3d A;
  A << 0.0, 1.0, 0.0, -kAccelerationOmega * kAccelerationOmega, -2.0 * kAccelerationDamping * kAccelerationOmega, 1.0,
      0.0, 0.0, -kAccelerationRolloff;
  return A;
}

// The covariance that (y, a, b) settles at, for a of unit variance: A S + S Aᵀ + B Bᵀ = 0 with B along b.
Matrix3d stationary_covariance() {
  const Matrix3d A = acceleration_dynamics();
  Eigen::Matrix<double, 9, 9> system = Eigen::Matrix<double, 9, 9>::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        system(3 * i + j, 3 * k + j) += A(i, k);
        system(3 * i + j, 3 * i + k) += A(j, k);
      }
    }
  }
  Eigen::Matrix<double, 9, 1> right = Eigen::Matrix<double, 9, 1>::Zero();
  right[8] = -1.0;
  const Eigen::Matrix<double, 9, 1> solution = system.partialPivLu().solve(right);
  Matrix3d S = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(solution.data());
  S = 0.5 * (S + S.transpose()).eval();
  return S / S(1, 1);
}

const Matrix3d& stationary() {
  static const Matrix3d covariance = stationary_covariance();
  return covariance;
}

// exp(A t) by Taylor's series on a short step, squared up.
Matrix3d exponential(const Matrix3d& A, double t) {
  int squarings = 0;
  while (A.norm() * t > 0.5 && squarings < 20) {
    t *= 0.5;
    ++squarings;
  }
  Matrix3d term = Matrix3d::Identity();
  Matrix3d sum = Matrix3d::Identity();
  for (int k = 1; k <= 10; ++k) {
    term = (term * A * (t / k)).eval();
    sum += term;
  }
  for (int k = 0; k < squarings; ++k) {
    sum = (sum * sum).eval();
  }
  return sum;
}

void symmetrise(Matrix& P) {
  P = 0.5 * (P + P.transpose()).eval();
}

// A tilt t = (t_x, t_y, 0) is put in by the rotation vector t × (0, 0, 1) = (t_y, −t_x, 0): the up direction of N moves
// by −t.
Quaterniond tilted(const Quaterniond& R_NL, const Vector2d& tilt) {
  return (geometry::exp_so3({tilt.y(), -tilt.x(), 0.0}) * R_NL).normalized();
}

// Puts the tilt of a correction into the rotation.
void correct(InclinationFilter::State& state, const Axes& dx) {
  state.x += dx;
  state.R_NL = tilted(state.R_NL, state.x.row(kTilt));
  state.x.row(kTilt).setZero();
}

// Joseph form of a scalar measurement with row h, the same for both axes.
void measure(InclinationFilter::State& state, const Column& h, double variance, const Eigen::RowVector2d& innovation) {
  const Column Ph = state.P * h;
  const double s = h.dot(Ph) + variance;
  const Column K = Ph / s;
  const Matrix A = Matrix::Identity() - K * h.transpose();
  state.P = A * state.P * A.transpose() + variance * K * K.transpose();
  symmetrise(state.P);
  correct(state, K * innovation);
}

}  // namespace

AccelerationStep acceleration_step(double dt) {
  static const Matrix3d A = acceleration_dynamics();
  AccelerationStep step;
  step.dt = dt;
  step.transition = exponential(A, std::min(dt, kLongestGap));
  step.driven = stationary() - step.transition * stationary() * step.transition.transpose();
  return step;
}

void InclinationFilter::start(const ForceSample& sample, double acceleration_sd, double noise) {
  state_ = State{};
  state_.R_NL = geometry::shortest_arc(sample.f_L, Vector3d::UnitZ());
  const double direction = std::hypot(acceleration_sd, noise) / kStandardGravity;
  const double a = std::max(acceleration_sd, kLeastAcceleration);
  // One reading alone may be anything; those after it shall decide.
  state_.P(kTilt, kTilt) = direction * direction + kFirstReadingSd * kFirstReadingSd;
  state_.P(kRate, kRate) = 1.0;
  state_.P.bottomRightCorner<3, 3>() = a * a * stationary();
  record_ = Record{};
  record_.predicted = record_.updated = state_;
  started_ = true;
}

void InclinationFilter::predict(const AccelerationStep& step, double acceleration_sd) {
  const double dt = std::min(step.dt, kLongestGap);
  const double decay = std::exp(-dt / kRateTime);
  const double turned = kRateTime * (1.0 - decay);
  Matrix& F = record_.F;
  F.setIdentity();
  F(kTilt, kRate) = turned;
  F(kRate, kRate) = decay;
  F.bottomRightCorner<3, 3>() = step.transition;

  const double lever_rate = acceleration_sd / lever_;
  // Smoothing over longer times means slower turning: the density goes with the third power of time.
  const double smoothing = std::max(kLeastSmoothing_s, parameters_.smoothing_s);
  const double slower = std::pow(InclinationParameters{}.smoothing_s / smoothing, 3);
  const double q = slower * kAngularAccelerationTime *
                   (kCalmAngularAcceleration * kCalmAngularAcceleration + lever_rate * lever_rate);
  const double a = std::max(acceleration_sd, kLeastAcceleration);
  state_.P = F * state_.P * F.transpose();
  state_.P(kTilt, kTilt) += q * dt * dt * dt / 3.0;
  state_.P(kTilt, kRate) += q * dt * dt / 2.0;
  state_.P(kRate, kTilt) += q * dt * dt / 2.0;
  state_.P(kRate, kRate) += q * dt;
  state_.P.bottomRightCorner<3, 3>() += a * a * step.driven;
  symmetrise(state_.P);
  const Axes moved = F * state_.x;
  state_.x.setZero();
  correct(state_, moved);
}

void InclinationFilter::update(const ForceSample& sample, double acceleration_sd, double noise) {
  // The reading should point along (a_x, a_y, what is left of its length). How far it is turned from there, times its
  // length, is what tilt and acceleration explain; unlike its x and y this also says when the filter is upside down.
  const double length = sample.f_L.norm();
  const Vector3d f_N = state_.R_NL * sample.f_L;
  const Vector2d a = state_.x.row(kAcceleration);
  const double upward = std::sqrt(std::max(length * length - a.squaredNorm(), 0.1 * length * length));
  const Vector3d turn = geometry::log_so3(geometry::shortest_arc({a.x(), a.y(), upward}, f_N));
  const Eigen::RowVector2d innovation = length * Eigen::RowVector2d(turn.y(), -turn.x());
  Column h = Column::Zero();
  h[kTilt] = length;
  h[kAcceleration] = length / upward;
  const double r = noise * noise;
  const double s = h.dot(state_.P * h) + r;
  const double nis = innovation.squaredNorm() / s;
  log_likelihood_ = -std::log(s) - 0.5 * (kStudent + 2.0) * std::log1p(nis / kStudent);

  // An acceleration that turns the reading by this much and leaves its length alone all the time does not exist: what
  // the filter believed was wrong.
  if (acceleration_sd <= 0.0 && innovation.norm() > kLostAngle * length) {
    start(sample, acceleration_sd, noise);
    return;
  }
  // A turn that no limb can do in one cycle is an acceleration that |f| has not shown yet.
  const bool jump = nis > kGate;
  if (jump) {
    state_.P(kAcceleration, kAcceleration) += innovation.squaredNorm() / kGate;
    record_.predicted.P = state_.P;
  }
  measure(state_, h, r, innovation);
  // Where nothing hints at acceleration there is none.
  if (acceleration_sd <= 0.0 && !jump) {
    Column none = Column::Zero();
    none[kAcceleration] = 1.0;
    measure(state_, none, kLeastAcceleration * kLeastAcceleration, -state_.x.row(kAcceleration));
  }
}

void InclinationFilter::step(const ForceSample& sample, const AccelerationStep& step, double acceleration_sd,
                             double noise) {
  log_likelihood_ = 0.0;
  const bool usable = sample.usable && sample.f_L.allFinite() && sample.f_L.squaredNorm() > 1e-6;
  if (!started_ || (usable && step.dt > kLongestGap)) {
    if (usable) {
      start(sample, acceleration_sd, noise);
    }
    return;
  }
  record_.connected = step.dt <= kLongestGap;
  predict(step, acceleration_sd);
  record_.predicted = state_;
  if (usable) {
    update(sample, acceleration_sd, noise);
  }
  record_.updated = state_;  // after a new start its record is not connected and the same
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
    const Vector3d turn = geometry::log_so3(ahead.R_NL * next.predicted.R_NL.conjugate());
    Axes difference = ahead.x - next.predicted.x;
    difference.row(kTilt) << -turn.y(), turn.x();
    correct(state, C * difference);
    state.P += C * (ahead.P - next.predicted.P) * C.transpose();
    symmetrise(state.P);
  }
  return states;
}

double InclinationFilter::direction_sd(const State& state) {
  return std::sqrt(std::max(0.0, state.P(kTilt, kTilt)));
}

}  // namespace limbwave::estimate
