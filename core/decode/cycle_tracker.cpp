#include "decode/cycle_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limbwave::decode {
namespace {

constexpr double kLeast = 1e-7;          // of all weights; less likely hypotheses are dropped
constexpr double kSameRate = 0.008;      // m/s
constexpr double kSameForce = 0.4;       // m/s²
constexpr double kLost = 1e-14;          // mean likelihood, below which nothing explains a reading
constexpr double kEnvelopeStray = 2e-3;  // of envelopes are three times as bad as they say

double envelope_likelihood(double off, double variance) {
  const double z = off * off / variance;
  return std::exp(-0.5 * z) + kEnvelopeStray * std::exp(-0.5 * z / 9.0);
}

}  // namespace

void CycleTracker::start(const Eigen::Matrix3d& P) {
  hypotheses_.assign(1, {Eigen::Vector3d::Zero(), P, 1.0, 0, 0});
  fresh_ = true;
}

void CycleTracker::shift(const Eigen::Vector3d& by) {
  for (Hypothesis& h : hypotheses_) {
    h.x += by;
  }
}

void CycleTracker::advance(double dt, double memory_s, double jerk, double acceleration_walk, double wandered) {
  const double age = std::abs(dt);
  const double keep = std::exp(-age / memory_s);
  Eigen::Matrix3d F;
  F << 1.0, dt, 0.5 * dt * dt, 0.0, 1.0, dt, 0.0, 0.0, keep;
  const double q = jerk * jerk;
  const double w = acceleration_walk * acceleration_walk;
  const double sign = dt < 0.0 ? -1.0 : 1.0;
  const double d2 = age * age;
  Eigen::Matrix3d Q;
  Q(0, 0) = q * d2 * d2 * age / 20.0 + w * d2 * age / 3.0 + wandered;
  Q(0, 1) = Q(1, 0) = sign * (q * d2 * d2 / 8.0 + w * d2 / 2.0);
  Q(0, 2) = Q(2, 0) = q * d2 * age / 6.0;
  Q(1, 1) = q * d2 * age / 3.0 + w * age;
  Q(1, 2) = Q(2, 1) = sign * q * d2 / 2.0;
  Q(2, 2) = q * age;
  for (Hypothesis& h : hypotheses_) {
    h.x = F * h.x;
    h.P = F * h.P * F.transpose() + Q;
  }
}

CycleResult CycleTracker::take(const CycleReading& r) {
  const double nearest = std::round((r.envelope - r.phase) / wavelength_);
  const int reach = 1 + static_cast<int>(std::ceil(4.0 * std::sqrt(r.envelope_variance) / wavelength_));
  next_.clear();
  double total = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double range = r.phase + (nearest + k) * wavelength_;
    double likelihood = envelope_likelihood(range - r.envelope, r.envelope_variance);
    if (r.told_variance >= 0.0) {
      const double z = (range - r.told) * (range - r.told);
      const double near = r.told_variance + r.phase_variance;
      const double far = 9.0 * r.told_variance + stray_m_ * stray_m_;
      likelihood *= (1.0 - stray_) * std::exp(-0.5 * z / near) / std::sqrt(near) +
                    stray_ * std::exp(-0.5 * z / far) / std::sqrt(far);
    }
    if (likelihood < 1e-12) {
      continue;
    }
    for (const Hypothesis& h : hypotheses_) {
      const double off = range - r.nominal - h.x[0];
      // Now and then a limb does what nothing let expect.
      const double near = h.P(0, 0) + r.phase_variance;
      const double far = 9.0 * h.P(0, 0) + stray_m_ * stray_m_;
      const double usual = (1.0 - stray_) * std::exp(-0.5 * off * off / near) / std::sqrt(near);
      const double stray = stray_ * std::exp(-0.5 * off * off / far) / std::sqrt(far);
      Hypothesis child = h;
      child.cycles = static_cast<std::int64_t>(nearest) + k;
      child.moved = child.cycles - h.cycles;
      child.weight = h.weight * likelihood * (usual + stray);
      if (child.weight <= kLeast * total) {
        continue;
      }
      total += child.weight;
      if (stray > usual) {
        child.P *= 9.0;
        child.P(0, 0) += stray_m_ * stray_m_;
        child.P(1, 1) += 0.1 * 0.1;
        child.P(2, 2) += 1.0;
      }
      const Eigen::Vector3d PH = child.P.col(0);
      const Eigen::Vector3d K = PH / (PH[0] + r.phase_variance);
      child.x += K * off;
      child.P -= K * PH.transpose();
      next_.push_back(child);
    }
  }
  CycleResult result;
  result.range = r.envelope;
  if (!(total > kLost)) {
    hypotheses_.clear();
    return result;
  }
  std::sort(next_.begin(), next_.end(), [](const Hypothesis& a, const Hypothesis& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.cycles < b.cycles;
  });
  hypotheses_.clear();
  double kept = 0.0;
  for (const Hypothesis& h : next_) {
    if (h.weight < kLeast * total) {
      break;
    }
    const auto same = std::find_if(hypotheses_.begin(), hypotheses_.end(), [&](const Hypothesis& other) {
      return other.cycles == h.cycles && std::abs(other.x[1] - h.x[1]) < kSameRate &&
             std::abs(other.x[2] - h.x[2]) < kSameForce;
    });
    if (same != hypotheses_.end()) {
      same->weight += h.weight;
    } else if (hypotheses_.size() < kMost) {
      hypotheses_.push_back(h);
    } else {
      continue;
    }
    kept += h.weight;
  }
  // What was dropped for want of room counts as failure.
  const auto likeliest = [&](std::int64_t Hypothesis::*number) {
    std::pair<std::int64_t, double> best{0, -1.0};
    for (const Hypothesis& h : hypotheses_) {
      double weight = 0.0;
      for (const Hypothesis& other : hypotheses_) {
        weight += other.*number == h.*number ? other.weight : 0.0;
      }
      best = weight > best.second ? std::pair(h.*number, weight) : best;
    }
    return best;
  };
  const auto best = likeliest(&Hypothesis::cycles);
  const auto moved = likeliest(&Hypothesis::moved);
  result.cycles = best.first;
  result.range = r.phase + static_cast<double>(best.first) * wavelength_;
  result.failure = std::max(0.0, 1.0 - best.second / total);
  result.moved = moved.first;
  result.moved_failure = fresh_ ? 1.0 : std::max(0.0, 1.0 - moved.second / total);
  fresh_ = false;
  for (Hypothesis& h : hypotheses_) {
    h.weight /= kept;
  }
  return result;
}

}  // namespace limbwave::decode
