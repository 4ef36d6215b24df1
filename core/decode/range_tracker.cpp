#include "decode/range_tracker.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::decode {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kRestSd = 0.30;             // metres, of a microphone about its place at rest
constexpr double kOwnWalk = 1.5e-3;          // m/√s, of ranges of sources that sit still in the frame
constexpr double kOtherSd = 0.02;            // metres, of sources on other segments
constexpr double kOtherRate = 0.10;          // m/s
constexpr double kStartSpeed = 1.2;          // m/s
constexpr double kStartAcceleration = 12.0;  // m/s²
constexpr double kForget = 0.4;              // seconds without a range, then the state is found anew
constexpr double kCollect = 0.075;           // seconds of ranges that make a first state
constexpr int kContradictions = 10;
constexpr double kMostBend = 0.3e-3;  // metres
// What bounds a state that few sources see: limbs come back to rest, slow down, and do not push for long.
constexpr double kTether = 0.060;             // seconds from one reminder to the next
constexpr double kTetherPlace = 1.2;          // metres, standard deviation of a reminder
constexpr double kTetherSpeed = 2.2;          // m/s
constexpr double kTetherAcceleration = 25.0;  // m/s²
constexpr double kTetherRate = 0.5;           // m/s, of sources on other segments

}  // namespace

RangeTracker::RangeTracker(const RangingFormat& format, const RangingParameters& parameters)
    : format_(format),
      parameters_(parameters),
      sources_(std::min(kSources, static_cast<int>(format.sources.size()))),
      x_(State::Zero()),
      P_(Covariance::Zero()) {}

void RangeTracker::advance(double time_s) {
  const double dt = time_s - time_s_;
  if (running_ && time_s - last_update_s_ > kForget) {
    running_ = false;
    heard_.clear();
  }
  if (!running_ || dt <= 0.0) {
    time_s_ = std::max(time_s_, time_s);
    return;
  }
  time_s_ = time_s;
  const double half = 0.5 * dt * dt;
  for (int i = 0; i < 3; ++i) {
    x_[i] += dt * x_[3 + i] + half * x_[6 + i];
    x_[3 + i] += dt * x_[6 + i];
  }
  for (int j = 0; j < sources_; ++j) {
    x_[9 + j] += dt * x_[9 + kSources + j];
  }
  // P = F P Fᵀ by rows, then by columns; only the moving blocks differ from the identity.
  for (int i = 0; i < 3; ++i) {
    P_.row(i) += dt * P_.row(3 + i) + half * P_.row(6 + i);
    P_.row(3 + i) += dt * P_.row(6 + i);
  }
  for (int j = 0; j < sources_; ++j) {
    if (!format_.sources[static_cast<std::size_t>(j)].fixed) {
      P_.row(9 + j) += dt * P_.row(9 + kSources + j);
    }
  }
  for (int i = 0; i < 3; ++i) {
    P_.col(i) += dt * P_.col(3 + i) + half * P_.col(6 + i);
    P_.col(3 + i) += dt * P_.col(6 + i);
  }
  const double jerk = parameters_.jerk * parameters_.jerk;
  for (int j = 0; j < sources_; ++j) {
    const bool fixed = format_.sources[static_cast<std::size_t>(j)].fixed;
    if (!fixed) {
      P_.col(9 + j) += dt * P_.col(9 + kSources + j);
      const double q = parameters_.source_acceleration * parameters_.source_acceleration;
      P_(9 + j, 9 + j) += q * dt * dt * dt / 3.0;
      P_(9 + j, 9 + kSources + j) += q * dt * dt / 2.0;
      P_(9 + kSources + j, 9 + j) += q * dt * dt / 2.0;
      P_(9 + kSources + j, 9 + kSources + j) += q * dt;
    } else {
      P_(9 + j, 9 + j) += kOwnWalk * kOwnWalk * dt;
    }
  }
  const double d2 = dt * dt;
  for (int i = 0; i < 3; ++i) {
    const double terms[3][3] = {{d2 * d2 * dt / 20.0, d2 * d2 / 8.0, d2 * dt / 6.0},
                                {d2 * d2 / 8.0, d2 * dt / 3.0, d2 / 2.0},
                                {d2 * dt / 6.0, d2 / 2.0, dt}};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        P_(3 * a + i, 3 * b + i) += jerk * terms[a][b];
      }
    }
  }
  if (time_s_ < next_reminder_s_) {
    return;
  }
  next_reminder_s_ = time_s_ + kTether;
  for (int i = 0; i < 3; ++i) {
    remind(i, format_.receiver[i], kTetherPlace);
    remind(3 + i, 0.0, kTetherSpeed);
    remind(6 + i, 0.0, kTetherAcceleration);
  }
  for (int j = 0; j < sources_; ++j) {
    if (!format_.sources[static_cast<std::size_t>(j)].fixed) {
      remind(9 + kSources + j, 0.0, kTetherRate);
      remind(9 + j, 0.0, kTetherPlace);
    }
  }
}

void RangeTracker::remind(int state, double value, double sd) {
  const State PH = P_.col(state);
  const State K = PH / (PH[state] + sd * sd);
  x_ += K * (value - x_[state]);
  P_.noalias() -= K * PH.transpose();
}

std::optional<RangeTracker::Expectation> RangeTracker::expect(int source) const {
  if (!running_ || source >= sources_) {
    return std::nullopt;
  }
  const RangingSource& from = format_.sources[static_cast<std::size_t>(source)];
  const Vector3d way = x_.head<3>() - from.position;
  const double distance = std::max(way.norm(), 0.02);
  const Vector3d u = way / distance;
  const int b = 9 + source;
  const Matrix3d P = P_.topLeftCorner<3, 3>();
  Expectation e;
  e.range = distance + x_[b];
  const double across = std::max(0.0, P.trace() - u.dot(P * u));
  // What a straight line leaves of the sphere about the source.
  const double bend = 0.5 * across / distance;
  e.variance = u.dot(P * u) + 2.0 * u.dot(P_.block<3, 1>(0, b)) + P_(b, b) + bend * bend;
  e.angle = std::acos(std::clamp(u.dot(from.normal), -1.0, 1.0));
  e.angle_sd = std::sqrt(across) / distance;
  return e;
}

void RangeTracker::update(int source, double range, double variance) {
  if (!running_ || source >= sources_) {
    return;
  }
  const RangingSource& from = format_.sources[static_cast<std::size_t>(source)];
  const Vector3d way = x_.head<3>() - from.position;
  const double distance = std::max(way.norm(), 0.02);
  const Vector3d u = way / distance;
  const int b = 9 + source;
  const State PH = P_.leftCols<3>() * u + P_.col(b);
  const double across = std::max(0.0, P_.topLeftCorner<3, 3>().trace() - u.dot(P_.topLeftCorner<3, 3>() * u));
  const double bend = std::min(kMostBend, 0.5 * across / distance);
  const double S = u.dot(PH.head<3>()) + PH[b] + variance + bend * bend;
  const State K = PH / S;
  x_ += K * (range - distance - x_[b]);
  P_.noalias() -= K * PH.transpose();
  last_update_s_ = time_s_;
  contradictions_ = 0;
}

void RangeTracker::contradict() {
  if (running_ && ++contradictions_ >= kContradictions) {
    running_ = false;
    contradictions_ = 0;
    heard_.clear();
  }
}

void RangeTracker::doubt(int source) {
  if (source >= sources_) {
    return;
  }
  const int b = 9 + source;
  P_.row(b).setZero();
  P_.col(b).setZero();
  P_(b, b) = 0.02 * 0.02;
  P_.topLeftCorner<3, 3>() += Matrix3d::Identity() * 1e-5;
}

void RangeTracker::collect(int source, double time_s, double range, double variance) {
  if (running_ || source >= sources_) {
    return;
  }
  heard_.push_back({source, time_s, range, variance});
  std::erase_if(heard_, [&](const Heard& h) { return h.time_s < time_s - 2.0 * kCollect; });
  if (time_s - heard_.front().time_s >= 0.75 * kCollect && heard_.size() >= 3) {
    start(time_s);
  }
}

// Gauss–Newton with the place at rest as a weak prior.
bool RangeTracker::solve(const Vector3d& guess, Vector3d& p, Matrix3d& P, double& cost) const {
  p = guess;
  for (int round = 0; round < 15; ++round) {
    Matrix3d A = Matrix3d::Identity() / (kRestSd * kRestSd);
    Vector3d g = (format_.receiver - p) / (kRestSd * kRestSd);
    cost = (format_.receiver - p).squaredNorm() / (kRestSd * kRestSd);
    for (const Heard& h : heard_) {
      const RangingSource& from = format_.sources[static_cast<std::size_t>(h.source)];
      const double sd = from.fixed ? parameters_.placement_sd : kOtherSd;
      // Also what it moved meanwhile.
      const double weight = 1.0 / (h.variance + sd * sd + 0.02 * 0.02);
      const Vector3d way = p - from.position;
      const double distance = std::max(way.norm(), 0.02);
      const Vector3d u = way / distance;
      A += weight * u * u.transpose();
      g += weight * (h.range - distance) * u;
      cost += weight * (h.range - distance) * (h.range - distance);
    }
    const Vector3d step = A.ldlt().solve(g);
    p += step.norm() > 0.3 ? Vector3d(step * (0.3 / step.norm())) : step;
    P = A.inverse();
    if (step.norm() < 1e-5) {
      return p.allFinite();
    }
  }
  return p.allFinite();
}

void RangeTracker::start(double time_s) {
  Vector3d best = format_.receiver;
  Matrix3d best_P = Matrix3d::Identity() * kRestSd * kRestSd;
  double best_cost = INFINITY;
  // From the place at rest, and from places in front of the body where limbs may be.
  const Vector3d forward = format_.sources.front().normal;
  for (const Vector3d& guess : {format_.receiver, Vector3d(format_.receiver + 0.4 * forward),
                                Vector3d(0.5 * format_.receiver + 0.3 * forward)}) {
    Vector3d p;
    Matrix3d P;
    double cost = 0.0;
    if (solve(guess, p, P, cost) && cost < best_cost) {
      best_cost = cost;
      best = p;
      best_P = P;
    }
  }
  if (best_cost > 6.0 * static_cast<double>(heard_.size()) + 12.0) {
    heard_.erase(heard_.begin());
    return;
  }
  x_.setZero();
  P_.setZero();
  x_.head<3>() = best;
  P_.topLeftCorner<3, 3>() = best_P;
  for (int i = 3; i < 6; ++i) {
    P_(i, i) = kStartSpeed * kStartSpeed;
    P_(i + 3, i + 3) = kStartAcceleration * kStartAcceleration;
  }
  for (int j = 0; j < sources_; ++j) {
    const bool fixed = format_.sources[static_cast<std::size_t>(j)].fixed;
    const double sd = fixed ? parameters_.placement_sd : kOtherSd;
    P_(9 + j, 9 + j) = sd * sd;
    P_(9 + kSources + j, 9 + kSources + j) = fixed ? 0.0 : kOtherRate * kOtherRate;
  }
  running_ = true;
  contradictions_ = 0;
  time_s_ = time_s;
  last_update_s_ = time_s;
  heard_.clear();
}

}  // namespace limbwave::decode
