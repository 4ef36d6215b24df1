#include "decode/range_trackers.h"

#include <algorithm>
#include <cmath>

namespace limbwave::decode {
namespace {

constexpr std::array kLiveliness = {0.03, 0.25, 1.5};  // of the parameters' jerk and acceleration
constexpr double kChange = 0.02;  // how likely it is, from one range to the next, that a limb moves in another way
constexpr double kCaution = 1.5;  // of variances: limbs do not move by the book
constexpr double kFloor = 1e-4;   // of a weight

}  // namespace

RangeTrackers::RangeTrackers(const RangingFormat& format, const RangingParameters& parameters) {
  for (const double liveliness : kLiveliness) {
    RangingParameters own = parameters;
    own.jerk *= liveliness;
    own.source_acceleration *= liveliness;
    trackers_.emplace_back(format, own);
  }
  weights_.fill(1.0 / kModels);
}

void RangeTrackers::advance(double time_s) {
  for (RangeTracker& tracker : trackers_) {
    tracker.advance(time_s);
  }
  for (double& weight : weights_) {
    weight = (1.0 - kChange) * weight + kChange / kModels;
  }
}

std::optional<RangeTracker::Expectation> RangeTrackers::expect(int source) const {
  std::optional<RangeTracker::Expectation> mixture;
  std::array<std::optional<RangeTracker::Expectation>, kModels> each;
  double total = 0.0;
  double mean = 0.0;
  double heaviest = -1.0;
  for (std::size_t m = 0; m < kModels; ++m) {
    each[m] = trackers_[m].expect(source);
    if (each[m]) {
      total += weights_[m];
      mean += weights_[m] * each[m]->range;
      if (weights_[m] > heaviest) {
        heaviest = weights_[m];
        mixture = each[m];
      }
    }
  }
  if (!mixture) {
    return mixture;
  }
  mixture->range = mean / total;
  mixture->variance = 0.0;
  for (std::size_t m = 0; m < kModels; ++m) {
    if (each[m]) {
      const double off = each[m]->range - mixture->range;
      mixture->variance += weights_[m] / total * (each[m]->variance + off * off);
      mixture->angle_sd = std::max(mixture->angle_sd, each[m]->angle_sd);
    }
  }
  return mixture;
}

double RangeTrackers::likelihood(int source, double range, double variance) const {
  double sum = 0.0;
  bool any = false;
  for (std::size_t m = 0; m < kModels; ++m) {
    if (const auto expected = trackers_[m].expect(source)) {
      any = true;
      const double spread = kCaution * expected->variance + variance;
      const double off = range - expected->range;
      sum += weights_[m] * std::exp(-0.5 * off * off / spread) / std::sqrt(spread);
    }
  }
  return any ? sum : 1.0;
}

void RangeTrackers::update(int source, double range, double variance) {
  std::array<double, kModels> fresh{};
  double total = 0.0;
  for (std::size_t m = 0; m < kModels; ++m) {
    double explained = 1.0;
    if (const auto expected = trackers_[m].expect(source)) {
      const double spread = expected->variance + variance;
      const double off = range - expected->range;
      explained = std::exp(-0.5 * std::min(50.0, off * off / spread)) / std::sqrt(spread);
    }
    fresh[m] = weights_[m] * explained;
    total += fresh[m];
    trackers_[m].update(source, range, variance);
  }
  for (std::size_t m = 0; m < kModels && total > 0.0; ++m) {
    weights_[m] = std::max(kFloor, fresh[m] / total);
  }
}

void RangeTrackers::contradict() {
  for (RangeTracker& tracker : trackers_) {
    tracker.contradict();
  }
}

void RangeTrackers::doubt(int source) {
  for (RangeTracker& tracker : trackers_) {
    tracker.doubt(source);
  }
}

void RangeTrackers::collect(int source, double time_s, double range, double variance) {
  for (RangeTracker& tracker : trackers_) {
    tracker.collect(source, time_s, range, variance);
  }
}

}  // namespace limbwave::decode
