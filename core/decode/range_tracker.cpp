#include "decode/range_tracker.h"

#include <algorithm>
#include <cmath>

#include "geometry/so3.h"

namespace limbwave::decode {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kLevel = 0.5;          // seconds, for gravity to tell inclination while nothing else does
constexpr double kForget = 1.5;         // seconds without a range, then the state is found anew
constexpr double kForgetUnaided = 0.4;  // the same without words

// Process noise, per √s.
constexpr double kVelocityWalk = 0.02;      // m/s: noise of the accelerometers, readings joined by lines
constexpr double kErrorTime = 0.7;          // seconds
constexpr double kErrorShare = 0.02;        // of the relative acceleration
constexpr double kLoose = 0.7;              // of what a single range's acceleration is off, that changes
constexpr double kMostLoose = 6.0;          // m/s²
constexpr double kTurnWalk = 0.001;         // rad
constexpr double kTurnShare = 0.003;        // of the rate of turn
constexpr double kBlindTurn = 1.5;          // rad: a gyroscope at the end of its range
constexpr double kBlindJerk = 60.0;         // m/s³: an accelerometer likewise
constexpr double kPlaceWalk = 0.5e-3;       // metres, of sources
constexpr double kPlaceTurn = 3e-3;         // metres per radian that the frame turns
constexpr double kOtherPlaceWalk = 1e-3;    // of sources on other segments
constexpr double kUnaidedPlaceWalk = 0.02;  // of these where no words tell how the segments move
// What bounds a state that few sources see: limbs come back to rest, slow down, and do not push for long.
constexpr double kTether = 0.120, kTetherSources = 2.0;  // seconds from one reminder to the next
constexpr double kTetherPlace = 1.0, kTetherSpeed = 2.8, kTetherAcceleration = 18.0, kTetherSource = 0.03;
constexpr double kTetherSkeleton = 0.03;  // metres, more than is said about where the skeleton puts a board,
constexpr double kTetherSkeletonSpeed = 0.08, kTetherSkeletonShare = 0.3;  // m/s, and of its speed
constexpr double kTetherGravity = 4.0;                                     // m/s², of the mean forces of two boards

double square(double x) {
  return x * x;
}

}  // namespace

RangeTracker::RangeTracker(const RangingFormat& format, const RangingParameters& parameters,
                           const Quaterniond& R_CS_rest, const Vector3d& origin)
    : format_(format),
      parameters_(parameters),
      receiver_(format.receiver - origin),
      origin_(origin),
      R_CS_rest_(R_CS_rest),
      R_CS_(R_CS_rest),
      sources_(std::min(kSources, static_cast<int>(format.sources.size()))),
      x_(State::Zero()),
      P_(Covariance::Zero()),
      wander_sums_(format.sources.size(), 0.0) {
  forget_corrections();
}

// Orientation from rates of turn, whether there are ranges or not.
void RangeTracker::orient(const TrackerStep& step) {
  const SourceStep& source = step.source;
  const double dt = source.dt;
  if (!oriented_) {
    R_CS_ = geometry::shortest_arc(R_CS_rest_ * step.board.felt.f_S, source.f_C) * R_CS_rest_;
    f_mean_ = f_mean_C_ = source.f_C;
    oriented_ = true;
    return;
  }
  const Quaterniond back = geometry::exp_so3(-dt * source.w_C);
  R_CS_ = (back * R_CS_ * geometry::exp_so3(dt * step.board.felt.w_S)).normalized();
  const double share = std::min(1.0, dt / kLevel);
  f_mean_ = back * f_mean_ + share * (R_CS_ * step.board.felt.f_S - f_mean_);
  f_mean_C_ = back * f_mean_C_ + share * (source.f_C - f_mean_C_);
  if (!running_) {
    const Vector3d level = 0.3 * share * f_mean_.normalized().cross(f_mean_C_.normalized());
    R_CS_ = (geometry::exp_so3(level) * R_CS_).normalized();
    f_mean_ += level.cross(f_mean_);
  }
}

// Everything over dt, which may be negative; a_ and the rates are means over it.
void RangeTracker::propagate(double dt, const TrackerStep& step) {
  const bool known = aided_;
  const double age = std::abs(dt);
  const Matrix3d E = known ? geometry::exp_so3(-dt * step.source.w_C).toRotationMatrix() : Matrix3d::Identity();
  const double keep = known ? std::exp(-age / kErrorTime) : 1.0;
  const Matrix3d turned =
      known ? geometry::exp_so3(0.5 * dt * step.source.w_C).toRotationMatrix() : Matrix3d::Identity();
  const Vector3d a = turned * a_ + x_.segment<3>(6);
  x_.head<3>() = E * (x_.head<3>() + dt * x_.segment<3>(3) + 0.5 * dt * dt * a);
  x_.segment<3>(3) = E * (x_.segment<3>(3) + dt * a);
  x_.segment<3>(6) *= keep;
  // F P, then (F P) Fᵀ, by blocks of three: most of F is zero.
  const Matrix3d fx = known ? Matrix3d(-geometry::skew(turned * f_C_)) : Matrix3d::Zero();
  const double square_half = 0.5 * dt * dt;
  {
    const Eigen::Matrix<double, 3, kStates> pushed = P_.middleRows<3>(6) + fx * P_.middleRows<3>(9);
    const Eigen::Matrix<double, 3, kStates> p =
        E * (P_.middleRows<3>(0) + dt * P_.middleRows<3>(3) + square_half * pushed);
    const Eigen::Matrix<double, 3, kStates> v = E * (P_.middleRows<3>(3) + dt * pushed);
    const Eigen::Matrix<double, 3, kStates> theta = E * P_.middleRows<3>(9);
    P_.middleRows<3>(0) = p;
    P_.middleRows<3>(3) = v;
    P_.middleRows<3>(6) *= keep;
    P_.middleRows<3>(9) = theta;
  }
  {
    const Matrix3d Et = E.transpose();
    const Eigen::Matrix<double, kStates, 3> pushed = P_.middleCols<3>(6) + P_.middleCols<3>(9) * fx.transpose();
    const Eigen::Matrix<double, kStates, 3> p =
        (P_.middleCols<3>(0) + dt * P_.middleCols<3>(3) + square_half * pushed) * Et;
    const Eigen::Matrix<double, kStates, 3> v = (P_.middleCols<3>(3) + dt * pushed) * Et;
    const Eigen::Matrix<double, kStates, 3> theta = P_.middleCols<3>(9) * Et;
    P_.middleCols<3>(0) = p;
    P_.middleCols<3>(3) = v;
    P_.middleCols<3>(6) *= keep;
    P_.middleCols<3>(9) = theta;
  }

  // A white jerk for e, white accelerations for v.
  double jerk = parameters_.jerk;
  double turn = kTurnWalk;
  if (known) {
    const double sd = kErrorSd + kErrorShare * a_.norm();
    jerk = step.board.felt.saturated ? kBlindJerk : sd * std::sqrt(2.0 / kErrorTime);
    turn += step.board.felt.saturated ? kBlindTurn : kTurnShare * (step.board.felt.w_S.norm() + step.source.w_C.norm());
  }
  const double q = jerk * jerk;
  jerk_sum_ += age * square(jerk + loose_jerk(step));
  const double w = kVelocityWalk * kVelocityWalk;
  const double d2 = age * age;
  const double sign = dt < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i) {
    P_(i, i) += q * d2 * d2 * age / 20.0 + w * d2 * age / 3.0;
    P_(3 + i, 3 + i) += q * d2 * age / 3.0 + w * age;
    P_(6 + i, 6 + i) += q * age;
    P_(9 + i, 9 + i) += turn * turn * age;
    const double pv = sign * (q * d2 * d2 / 8.0 + w * d2 / 2.0);
    const double pe = q * d2 * age / 6.0;
    const double ve = sign * q * d2 / 2.0;
    P_(i, 3 + i) += pv;
    P_(3 + i, i) += pv;
    P_(i, 6 + i) += pe;
    P_(6 + i, i) += pe;
    P_(3 + i, 6 + i) += ve;
    P_(6 + i, 3 + i) += ve;
  }
  for (int j = 0; j < sources_; ++j) {
    const RangingSource& source = format_.sources[static_cast<std::size_t>(j)];
    const bool fixed = source.fixed;
    double walk = fixed ? kPlaceWalk + kPlaceTurn * step.source.w_C.norm()
                        : kOtherPlaceWalk + source.wander * step.source.turning[static_cast<std::size_t>(j)];
    walk = known || fixed ? walk : kUnaidedPlaceWalk;
    for (int i = 0; i < 3; ++i) {
      P_(kMoving + 3 * j + i, kMoving + 3 * j + i) += walk * walk * age;
    }
    wander_sums_[static_cast<std::size_t>(j)] += walk * walk * age;
  }
}

// What a single range's movement is known worse than all of them together: by orientation and speed across.
double RangeTracker::loose_jerk(const TrackerStep& step) const {
  if (!aided_) {
    return 0.0;
  }
  const Vector3d way = x_.head<3>() - step.source.place;
  const double r = std::max(0.2, way.norm());
  const Vector3d u = way.normalized();
  const auto sd = [&](int block, const Vector3d& h) {
    return std::sqrt(std::max(0.0, h.dot(P_.block<3, 3>(block, block) * h)));
  };
  const auto across = [&](const Vector3d& h) { return Vector3d(h - u.dot(h) * u); };
  const double turned = sd(9, a_.cross(u));
  const double swung = 2.0 * sd(3, across(x_.segment<3>(3))) / r;
  const double aside = sd(0, across(a_)) / r;
  const double loose = kLoose * std::hypot(turned, swung, aside);
  return std::min(loose, kMostLoose) * std::sqrt(2.0 / kErrorTime);
}

double RangeTracker::memory_s() {
  return kErrorTime;
}
double RangeTracker::velocity_walk() {
  return kVelocityWalk;
}

// The acceleration that words tell. Where they begin or end, what e means changes.
void RangeTracker::feel(const TrackerStep& step) {
  const bool aided = step.source.known && step.board.felt.known;
  if (running_ && aided != aided_) {
    x_.segment<3>(6) = aided ? Vector3d::Zero() : a_;
    P_.middleRows<3>(6).setZero();
    P_.middleCols<3>(6).setZero();
    const double sd = aided ? 2.0 * kErrorSd : 3.0;
    P_.block<3, 3>(6, 6) = sd * sd * Matrix3d::Identity();
  }
  aided_ = aided;
  // Means over the step belong to its middle, orientation to its end.
  const double half = 0.5 * step.source.dt;
  const Quaterniond R_middle =
      geometry::exp_so3(half * step.source.w_C) * R_CS_ * geometry::exp_so3(-half * step.board.felt.w_S);
  f_C_ = aided ? Vector3d(R_middle * step.board.felt.f_S) : Vector3d::Zero();
  a_ = aided ? Vector3d(f_C_ - step.source.f_C) : Vector3d::Zero();
}

void RangeTracker::advance(const TrackerStep& step) {
  const double dt = step.source.time_s - time_s_;
  const bool aided = step.source.known && step.board.felt.known;
  if (aided) {
    orient(step);
  } else {
    oriented_ = oriented_ && dt < 0.2;
  }
  if (running_ && step.source.time_s - last_update_s_ > (aided ? kForget : kForgetUnaided)) {
    running_ = false;
    heard_.clear();
  }
  feel(step);
  board_ = step.board;
  time_s_ = std::max(time_s_, step.source.time_s);
  if (running_ && dt > 0.0) {
    propagate(dt, step);
    if (time_s_ >= next_reminder_s_) {
      next_reminder_s_ = time_s_ + kTether;
      bound(step);
    }
  }
}

void RangeTracker::retreat(const TrackerStep& later) {
  const double dt = later.source.dt;
  const bool aided = later.source.known && later.board.felt.known;
  feel(later);
  if (running_ && dt > 0.0) {
    propagate(-dt, later);
  }
  if (aided) {
    R_CS_ =
        (geometry::exp_so3(dt * later.source.w_C) * R_CS_ * geometry::exp_so3(-dt * later.board.felt.w_S)).normalized();
  }
  time_s_ -= dt;
  if (running_ && std::abs(time_s_ - last_update_s_) > (aided ? kForget : kForgetUnaided)) {
    running_ = false;
    heard_.clear();
  }
}

void RangeTracker::turn_round() {
  for (int i = 0; i < 3; ++i) {
    P_(i, i) += 1e-6;
    P_(3 + i, 3 + i) += 0.02 * 0.02;
    P_(6 + i, 6 + i) += 0.1 * 0.1;
  }
  for (int j = 0; j < sources_; ++j) {
    set_floating(j);
  }
  heard_.clear();
}

void RangeTracker::bound(const TrackerStep& step) {
  const State before = x_;
  const BoardStep& board = step.board;
  for (int i = 0; i < 3; ++i) {
    remind(i, board.placed ? board.place[i] : receiver_[i],
           board.placed ? std::min(kTetherPlace, board.place_sd + kTetherSkeleton) : kTetherPlace);
    remind(3 + i, board.placed ? board.velocity[i] : 0.0,
           board.placed ? kTetherSkeletonSpeed + kTetherSkeletonShare * board.velocity.norm() : kTetherSpeed);
    if (!aided_) {
      remind(6 + i, 0.0, kTetherAcceleration);
    }
  }
  if (time_s_ >= next_source_reminder_s_) {
    next_source_reminder_s_ = time_s_ + kTetherSources;
    for (int j = kMoving; j < kMoving + 3 * sources_; ++j) {
      remind(j, 0.0, kTetherSource);
    }
  }
  if (aided_) {
    // Whoever stays near the sources is not accelerated away from them for long: mean forces are the same.
    const Vector3d off = f_mean_C_ - f_mean_;
    const Matrix3d H = -geometry::skew(f_mean_);
    for (int i = 0; i < 3; ++i) {
      State h = State::Zero();
      h.segment<3>(9) = H.row(i).transpose();
      const State PH = P_.middleCols<3>(9) * h.segment<3>(9);
      const double S = h.segment<3>(9).dot(PH.segment<3>(9)) + kTetherGravity * kTetherGravity;
      const State K = PH / S;
      x_ += K * (off[i] - h.segment<3>(9).dot(x_.segment<3>(9)));
      P_.noalias() -= K * PH.transpose();
    }
  }
  corrected_by(before);
  inject();
}

void RangeTracker::corrected_by(const State& before) {
  const State by = x_ - before;
  correction_.p += by.head<3>();
  correction_.v += by.segment<3>(3);
  correction_.a += by.segment<3>(6) + by.segment<3>(9).cross(f_C_);
  for (int j = 0; j < kSources; ++j) {
    correction_.sources[static_cast<std::size_t>(j)] += by.segment<3>(kMoving + 3 * j);
  }
  corrected_ = true;
}

void RangeTracker::forget_corrections() {
  correction_.p = correction_.v = correction_.a = Vector3d::Zero();
  correction_.sources.fill(Vector3d::Zero());
  corrected_ = false;
}

void RangeTracker::inject() {
  const Vector3d theta = x_.segment<3>(9);
  R_CS_ = (geometry::exp_so3(theta) * R_CS_).normalized();
  f_mean_ += theta.cross(f_mean_);
  a_ += theta.cross(f_C_);
  f_C_ += theta.cross(f_C_);
  x_.segment<3>(9).setZero();
}

void RangeTracker::remind(int state, double value, double sd) {
  const State PH = P_.col(state);
  const State K = PH / (PH[state] + sd * sd);
  x_ += K * (value - x_[state]);
  P_.noalias() -= K * PH.transpose();
}

}  // namespace limbwave::decode
