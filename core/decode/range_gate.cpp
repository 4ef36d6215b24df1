#include "decode/range_gate.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace limbwave::decode {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNearest = 0.02;    // metres
constexpr double kCollect = 0.2;     // seconds of ranges that make a first place
constexpr int kFewest = 4;           // sources in them
constexpr double kForget = 1.0;      // seconds without an accepted range
constexpr double kReminder = 0.5;    // seconds
constexpr double kStartSpeed = 1.0;  // m/s
constexpr double kMemory = 0.004;    // of the noise's estimate, per range: longer than bursts of wrong ones
constexpr int kRefusals = 6;         // in a row for every source, then the place is wrong

}  // namespace

RangeGate::RangeGate(std::vector<Vector3d> sources, int receiver, const RangeGateParameters& parameters)
    : sources_(std::move(sources)),
      receiver_(receiver),
      parameters_(parameters),
      noise_(sources_.size(), parameters.noise_sd * parameters.noise_sd),
      x_(VectorXd::Zero(6 + 2 * count())),
      P_(Eigen::MatrixXd::Zero(6 + 2 * count(), 6 + 2 * count())) {}

double RangeGate::noise_sd(int source) const {
  return std::sqrt(noise_.at(static_cast<std::size_t>(source)));
}

void RangeGate::advance(double time_s) {
  const double dt = time_s - time_s_;
  time_s_ = std::max(time_s_, time_s);
  if (!running_ || dt <= 0.0) {
    return;
  }
  x_.head<3>() += dt * x_.segment<3>(3);
  P_.topRows<3>() += dt * P_.middleRows<3>(3);
  P_.leftCols<3>() += dt * P_.middleCols<3>(3);
  const double q = parameters_.acceleration * parameters_.acceleration;
  for (Eigen::Index i = 0; i < 3; ++i) {
    P_(i, i) += q * dt * dt * dt / 3.0;
    P_(i, 3 + i) += q * dt * dt / 2.0;
    P_(3 + i, i) += q * dt * dt / 2.0;
    P_(3 + i, 3 + i) += q * dt;
  }
  // First-order Gauss–Markov.
  const double keep = std::exp(-dt / parameters_.wander_s);
  const Eigen::Index n = count();
  x_.tail(n) *= keep;
  P_.bottomRows(n) *= keep;
  P_.rightCols(n) *= keep;
  P_.diagonal().tail(n).array() += (1.0 - keep * keep) * parameters_.wander_sd * parameters_.wander_sd;
  if (time_s_ >= next_reminder_s_) {
    next_reminder_s_ = time_s_ + kReminder;
    remind();
  }
}

// The place is about where it can be; weakly, and seldom.
void RangeGate::remind() {
  for (Eigen::Index i = 0; i < 3; ++i) {
    const VectorXd PH = P_.col(i);
    const double sd = parameters_.place_sd[i];
    const VectorXd K = PH / (PH[i] + sd * sd);
    x_ += K * (parameters_.place[i] - x_[i]);
    P_.noalias() -= K * PH.transpose();
  }
}

void RangeGate::collect(int source, double time_s, double range) {
  heard_.push_back({source, time_s, range});
  std::erase_if(heard_, [&](const Heard& h) { return h.time_s < time_s - 2.0 * kCollect; });
  std::vector<bool> seen(sources_.size());
  for (const Heard& h : heard_) {
    seen[static_cast<std::size_t>(h.source)] = true;
  }
  const auto sources = std::count(seen.begin(), seen.end(), true);
  if (time_s - heard_.front().time_s >= kCollect && sources >= std::min<std::ptrdiff_t>(kFewest, count())) {
    start(time_s);
  }
}

// Gauss–Newton with Huber's weights, from where the receiver may be.
void RangeGate::start(double time_s) {
  const double sd = std::hypot(parameters_.offset_sd, parameters_.wander_sd, parameters_.noise_sd);
  Vector3d p = parameters_.place;
  Matrix3d A = Matrix3d::Identity();
  for (int round = 0; round < 30; ++round) {
    const Vector3d prior = parameters_.place_sd.cwiseAbs2().cwiseInverse();
    A = prior.asDiagonal();
    Vector3d g = prior.cwiseProduct(parameters_.place - p);
    for (const Heard& h : heard_) {
      const Vector3d way = p - sources_[static_cast<std::size_t>(h.source)];
      const double distance = std::max(way.norm(), kNearest);
      const double left = h.range - distance;
      const double weight = std::min(1.0, sd / std::max(std::abs(left), 1e-9)) / (sd * sd);
      const Vector3d u = way / distance;
      A += weight * u * u.transpose();
      g += weight * left * u;
    }
    const Vector3d step = A.ldlt().solve(g);
    p += step;
    if (step.norm() < 1e-6) {
      break;
    }
  }
  // Half of the ranges fit, or this was no place.
  std::vector<double> left;
  for (const Heard& h : heard_) {
    left.push_back(std::abs(h.range - (p - sources_[static_cast<std::size_t>(h.source)]).norm()));
  }
  const auto middle = left.begin() + static_cast<std::ptrdiff_t>(left.size() / 2);
  std::nth_element(left.begin(), middle, left.end());
  heard_.clear();
  if (!p.allFinite() || *middle > 2.0 * sd) {
    return;
  }
  x_.setZero();
  P_.setZero();
  x_.head<3>() = p;
  // Ranges of one pair are off together: one of each counts.
  P_.topLeftCorner<3, 3>() = A.inverse() * 4.0;
  P_.diagonal().segment<3>(3).setConstant(kStartSpeed * kStartSpeed);
  P_.diagonal().segment(6, count()).setConstant(parameters_.offset_sd * parameters_.offset_sd);
  P_.diagonal().tail(count()).setConstant(parameters_.wander_sd * parameters_.wander_sd);
  running_ = true;
  refused_ = 0;
  last_accepted_s_ = time_s;
  next_reminder_s_ = time_s + kReminder;
}

RangeReading RangeGate::push(int source, Seconds time, double range) {
  RangeReading reading;
  reading.source = source;
  reading.receiver = receiver_;
  reading.emission_time = time;
  reading.range = reading.envelope_range = reading.phase_range = reading.expected = kNone;
  reading.variance = reading.envelope_variance = reading.expected_variance = kNever;
  advance(time.value);
  if (!std::isfinite(range) || range <= 0.0 || source < 0 || source >= count()) {
    return reading;
  }
  double& noise = noise_[static_cast<std::size_t>(source)];
  reading.envelope_range = reading.range = range;
  reading.factors = {1.0, 1.0, 1.0};
  if (running_ && time.value - last_accepted_s_ > kForget) {
    running_ = false;
    heard_.clear();
  }
  if (!running_) {
    reading.verdict = RangeVerdict::kAmbiguous;
    reading.variance = reading.envelope_variance =
        noise + parameters_.wander_sd * parameters_.wander_sd + parameters_.offset_sd * parameters_.offset_sd;
    collect(source, time.value, range);
    return reading;
  }
  const Vector3d way = x_.head<3>() - sources_[static_cast<std::size_t>(source)];
  const double distance = std::max(way.norm(), kNearest);
  const Vector3d u = way / distance;
  const Eigen::Index c = offset(source);
  const Eigen::Index g = wander(source);
  const VectorXd PH = P_.leftCols<3>() * u + P_.col(c) + P_.col(g);
  const Matrix3d P = P_.topLeftCorner<3, 3>();
  // What a straight line leaves of the sphere about the source.
  const double bend = 0.5 * std::max(0.0, P.trace() - u.dot(P * u)) / distance;
  const double model = u.dot(PH.head<3>()) + PH[c] + PH[g] + bend * bend;
  const double innovation = range - distance - x_[c] - x_[g];
  const double off_variance = P_(c, c) + P_(g, g) + 2.0 * P_(c, g);
  reading.expected = distance;
  reading.expected_variance = u.dot(P * u) + bend * bend;
  reading.range = range - x_[c] - x_[g];
  reading.variance = noise + off_variance;
  reading.envelope_variance = noise + parameters_.wander_sd * parameters_.wander_sd + P_(c, c);
  const double z = std::abs(innovation) / std::sqrt(model + noise);
  const double surprise = parameters_.surprise;
  reading.factors.continuity = z <= surprise ? 1.0 : std::pow(surprise / z, 4);
  // Innovation-based estimate of the noise; far ones count as just surprising, so that none of them rules.
  const double clipped = std::min(z, surprise);
  const double least = parameters_.least_noise_sd * parameters_.least_noise_sd;
  noise += kMemory * (std::max(least, clipped * clipped * (model + noise) - model) - noise);
  if (reading.confidence() < parameters_.least_confidence) {
    reading.verdict = RangeVerdict::kInconsistent;
    if (++refused_ > kRefusals * count()) {
      running_ = false;
      heard_.clear();
    }
    return reading;
  }
  reading.verdict = RangeVerdict::kAccepted;
  refused_ = 0;
  last_accepted_s_ = time.value;
  const VectorXd K = PH / (model + noise / reading.confidence());
  x_ += K * innovation;
  P_.noalias() -= K * PH.transpose();
  return reading;
}

}  // namespace limbwave::decode
