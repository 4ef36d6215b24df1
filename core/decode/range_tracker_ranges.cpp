// How a tracker begins, and what ranges do to it.
#include <algorithm>
#include <cmath>

#include "decode/range_tracker.h"

namespace limbwave::decode {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kContradictions = 10;
constexpr double kMostBend = 0.3e-3;                          // metres
constexpr double kFloatSd = 0.030;                            // metres
constexpr double kSkeletonSd = 0.03, kSkeletonSpeedSd = 0.4;  // metres, m/s, of where the skeleton puts a board

}  // namespace

Vector3d RangeTracker::correction_of(int source, const Vector3d& place) const {
  const Vector3d way = x_.head<3>() - place;
  const double distance = std::max(way.norm(), 0.02);
  const Vector3d u = way / distance;
  const double delay = distance / format_.speed_of_sound;
  const auto s = static_cast<std::size_t>(source);
  return {u.dot(correction_.p + delay * correction_.v - correction_.sources[s]), u.dot(correction_.v),
          u.dot(correction_.a)};
}

RangeTracker::Sight RangeTracker::sight(int source, const SourceStep& step) const {
  // The microphone moves on while sound is under way.
  const Vector3d from = step.place + x_.segment<3>(kMoving + 3 * source);
  const double delay = (x_.head<3>() - from).norm() / format_.speed_of_sound;
  const Vector3d way = x_.head<3>() + delay * x_.segment<3>(3) - from;
  const double distance = std::max(way.norm(), 0.02);
  return {way / distance, distance, delay};
}

std::optional<RangeTracker::Expectation> RangeTracker::expect(int source, const SourceStep& step) const {
  if (!running_ || source >= sources_) {
    return std::nullopt;
  }
  const Sight to = sight(source, step);
  const int s = kMoving + 3 * source;
  State h = State::Zero();
  h.head<3>() = to.u;
  h.segment<3>(3) = to.delay_s * to.u;
  h.segment<3>(s) = -to.u;
  const State PH = P_.leftCols<6>() * h.head<6>() + P_.middleCols<3>(s) * h.segment<3>(s);
  const Matrix3d P = P_.topLeftCorner<3, 3>() + P_.block<3, 3>(s, s) - P_.block<3, 3>(0, s) - P_.block<3, 3>(s, 0);
  const double across = std::max(0.0, P.trace() - to.u.dot(P * to.u));
  // What a straight line leaves of the sphere about the source.
  const double bend = 0.5 * across / to.distance;
  Expectation e;
  e.range = to.distance;
  e.variance = std::max(0.0, h.dot(PH)) + bend * bend;
  e.rate = to.u.dot(x_.segment<3>(3) - step.w_C.cross(step.place));
  State g = State::Zero();  // rate
  g.segment<3>(3) = to.u;
  State a = State::Zero();  // acceleration
  a.segment<3>(6) = to.u;
  a.segment<3>(9) = f_C_.cross(to.u);
  const State Pg = P_.middleCols<3>(3) * to.u;
  const State Pa = P_.middleCols<6>(6) * a.segment<6>(6);
  e.P << e.variance, h.dot(Pg), h.dot(Pa), h.dot(Pg), g.dot(Pg), g.dot(Pa), h.dot(Pa), g.dot(Pa), a.dot(Pa);
  e.angle = std::acos(std::clamp(to.u.dot(step.normal), -1.0, 1.0));
  e.angle_sd = std::sqrt(across) / to.distance;
  return e;
}

void RangeTracker::set_floating(int source) {
  if (source < sources_) {
    const int n = kFloat + source;
    x_[n] = 0.0;
    P_.row(n).setZero();
    P_.col(n).setZero();
    P_(n, n) = kFloatSd * kFloatSd;
  }
}

void RangeTracker::fix(int source, double value) {
  if (!running_ || source >= sources_) {
    return;
  }
  const int n = kFloat + source;
  if (P_(n, n) > 0.0) {
    const State before = x_;
    remind(n, value, 1e-5);
    corrected_by(before);
    inject();
  }
  x_[n] = 0.0;
  P_.row(n).setZero();
  P_.col(n).setZero();
}

void RangeTracker::update(int source, const SourceStep& step, double range, double variance, bool floating) {
  if (!running_ || source >= sources_) {
    return;
  }
  const Sight to = sight(source, step);
  const int s = kMoving + 3 * source;
  Eigen::Matrix<double, 6, 1> h;
  h.head<3>() = to.u;
  h.tail<3>() = to.delay_s * to.u;
  State PH = P_.leftCols<6>() * h - P_.middleCols<3>(s) * to.u;
  if (floating) {
    PH += P_.col(kFloat + source);
  }
  const Matrix3d P = P_.topLeftCorner<3, 3>();
  const double across = std::max(0.0, P.trace() - to.u.dot(P * to.u));
  const double bend = std::min(kMostBend, 0.5 * across / to.distance);
  const double n = floating ? x_[kFloat + source] : 0.0;
  const double S = h.dot(PH.head<6>()) - to.u.dot(PH.segment<3>(s)) + (floating ? PH[kFloat + source] : 0.0) +
                   variance + bend * bend;
  const State K = PH / S;
  const State before = x_;
  x_ += K * (range - to.distance - n);
  P_.noalias() -= K * PH.transpose();
  corrected_by(before);
  inject();
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

void RangeTracker::doubt() {
  for (int i = 0; i < 3; ++i) {
    P_(i, i) += 36e-6;
    P_(3 + i, 3 + i) += 0.01;
  }
  for (int i = kMoving; i < kMoving + 3 * sources_; ++i) {
    P_(i, i) += 36e-6;
  }
}

void RangeTracker::collect(int source, const SourceStep& step, double range, double variance) {
  if (running_ || source >= sources_) {
    return;
  }
  constexpr double kCollect = 0.075;  // seconds of ranges that make a first state
  heard_.push_back({source, step.time_s, range, variance, step.place});
  std::erase_if(heard_, [&](const Heard& h) { return std::abs(h.time_s - step.time_s) > 2.0 * kCollect; });
  if (std::abs(step.time_s - heard_.front().time_s) >= 0.75 * kCollect && heard_.size() >= 2) {
    start(step);
  }
}

// Gauss–Newton with the place at rest as a weak prior.
bool RangeTracker::solve(const Vector3d& guess, Vector3d& p, Matrix3d& P, double& cost) const {
  // Metres, of a microphone about where the skeleton puts it, or about its place at rest.
  const double rest_sd = board_.placed ? kSkeletonSd + board_.place_sd : 0.30;
  const Vector3d about = board_.placed ? board_.place : receiver_;
  p = guess;
  for (int round = 0; round < 15; ++round) {
    Matrix3d A = Matrix3d::Identity() / (rest_sd * rest_sd);
    Vector3d g = (about - p) / (rest_sd * rest_sd);
    cost = (about - p).squaredNorm() / (rest_sd * rest_sd);
    for (const Heard& h : heard_) {
      const double sd = 2.0 * parameters_.placement_sd;
      // Also what it moved meanwhile.
      const double weight = 1.0 / (h.variance + sd * sd + 0.02 * 0.02);
      const Vector3d way = p - h.place;
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

void RangeTracker::start(const SourceStep& step) {
  Vector3d best = receiver_;
  Matrix3d best_P = Matrix3d::Identity() * 0.09;
  double best_cost = INFINITY;
  // From where the skeleton puts it; else from the place at rest, and from places in front of the body where limbs may
  // be.
  const Vector3d forward = format_.sources.front().normal;
  std::vector<Vector3d> guesses = {board_.place};
  if (!board_.placed) {
    guesses = {receiver_, receiver_ + 0.4 * forward, 0.5 * receiver_ + 0.3 * forward};
  }
  for (const Vector3d& guess : guesses) {
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
  constexpr double kStartSpeed = 1.2;          // m/s
  constexpr double kStartAcceleration = 12.0;  // m/s², without words
  constexpr double kStartTilt = 0.12;          // radians
  constexpr double kStartHeading = 0.35;
  const double speed_sd = board_.placed ? kSkeletonSpeedSd + 0.2 * board_.velocity.norm() : kStartSpeed;
  x_.head<kMoving>().setZero();
  P_.topRows<kMoving>().setZero();
  P_.leftCols<kMoving>().setZero();
  x_.head<3>() = best;
  P_.topLeftCorner<3, 3>() = best_P;
  const double sd = aided_ ? 2.0 * kErrorSd : kStartAcceleration;
  if (board_.placed) {
    x_.segment<3>(3) = board_.velocity;
    R_CS_ = board_.R_CS;
  }
  P_.block<3, 3>(3, 3) = speed_sd * speed_sd * Matrix3d::Identity();
  P_.block<3, 3>(6, 6) = sd * sd * Matrix3d::Identity();
  const Vector3d up = f_mean_C_.norm() > 1.0 ? f_mean_C_.normalized() : Vector3d::UnitX();
  P_.block<3, 3>(9, 9) = kStartTilt * kStartTilt * Matrix3d::Identity() +
                         (kStartHeading * kStartHeading - kStartTilt * kStartTilt) * up * up.transpose();
  for (int j = 0; j < sources_ && !known_sources_; ++j) {
    const bool fixed = format_.sources[static_cast<std::size_t>(j)].fixed;
    const double place = (fixed ? 1.4 : 2.5) * parameters_.placement_sd;
    P_.block<3, 3>(kMoving + 3 * j, kMoving + 3 * j) = place * place * Matrix3d::Identity();
  }
  for (int j = 0; j < sources_; ++j) {
    set_floating(j);
  }
  known_sources_ = true;
  running_ = true;
  contradictions_ = 0;
  last_update_s_ = time_s_ = step.time_s;
  heard_.clear();
}

}  // namespace limbwave::decode
