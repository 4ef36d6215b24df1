#include "calibrate/steadiness.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

namespace limbwave::calibrate {

void SteadinessFilter::push(double time_s, const Eigen::Vector3d& value, bool usable) {
  if (!std::isfinite(time_s) || (!readings_.empty() && time_s <= readings_.back().time_s)) {
    return;
  }
  readings_.push_back({time_s, value, usable && value.allFinite()});
  advance(false);
}

void SteadinessFilter::finish() {
  advance(true);
  readings_.clear();
  fitted_.clear();
  next_ = next_steady_ = 0;
}

std::vector<SteadySample> SteadinessFilter::take() {
  return std::exchange(done_, {});
}

SteadySample SteadinessFilter::fit(std::size_t index) const {
  const Reading& middle = readings_[index];
  SteadySample sample;
  sample.time_s = middle.time_s;
  sample.value = middle.value;
  std::size_t begin = index;
  while (begin > 0 && middle.time_s - readings_[begin - 1].time_s <= parameters_.half_window_s) {
    --begin;
  }
  std::size_t end = index + 1;
  while (end < readings_.size() && readings_[end].time_s - middle.time_s <= parameters_.half_window_s) {
    ++end;
  }
  // Least squares of value = c0 + c1 t + c2 t² with t in half windows, which keeps the matrix well scaled.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d right = Eigen::Matrix3d::Zero();
  double square = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    const Reading& reading = readings_[i];
    const bool joined = i == begin || reading.time_s - readings_[i - 1].time_s <= parameters_.largest_gap_s;
    if (!reading.usable || !joined) {
      return sample;
    }
    const double t = (reading.time_s - middle.time_s) / parameters_.half_window_s;
    const Eigen::Vector3d basis(1.0, t, t * t);
    const Eigen::Vector3d difference = reading.value - middle.value;
    normal += basis * basis.transpose();
    right += basis * difference.transpose();
    square += difference.squaredNorm();
  }
  const double span = readings_[end - 1].time_s - readings_[begin].time_s;
  if (end - begin < 6 || span < 1.4 * parameters_.half_window_s) {
    return sample;  // at an end of the series
  }
  const Eigen::Matrix3d coefficients = normal.ldlt().solve(right);
  sample.value = middle.value + coefficients.row(0).transpose();
  sample.rate = coefficients.row(1).norm() / parameters_.half_window_s;
  const double left = std::max(0.0, square - coefficients.cwiseProduct(right).sum());
  sample.unsteadiness = std::sqrt(left / static_cast<double>(end - begin - 3));
  sample.whole = true;
  return sample;
}

bool SteadinessFilter::calm(const SteadySample& sample) const {
  return sample.whole && sample.unsteadiness <= parameters_.largest_unsteadiness &&
         sample.rate <= parameters_.largest_rate;
}

void SteadinessFilter::advance(bool finishing) {
  const double half = parameters_.half_window_s;
  while (next_ < readings_.size() && (finishing || readings_.back().time_s - readings_[next_].time_s > half)) {
    fitted_.push_back(fit(next_++));
  }
  // A jerk must not count with its flanks: a sample is steady when all around it are calm.
  while (next_steady_ < fitted_.size() && (finishing || fitted_.back().time_s - fitted_[next_steady_].time_s > half)) {
    SteadySample sample = fitted_[next_steady_];
    sample.steady = calm(sample);
    for (std::size_t i = next_steady_; sample.steady && i-- > 0 && sample.time_s - fitted_[i].time_s <= half;) {
      sample.steady = calm(fitted_[i]);
    }
    for (std::size_t i = next_steady_ + 1;
         sample.steady && i < fitted_.size() && fitted_[i].time_s - sample.time_s <= half; ++i) {
      sample.steady = calm(fitted_[i]);
    }
    done_.push_back(sample);
    ++next_steady_;
  }
  // What no window reaches any more.
  while (next_ > 0 && next_ < readings_.size() && readings_[next_].time_s - readings_.front().time_s > 2.0 * half) {
    readings_.pop_front();
    --next_;
  }
  while (next_steady_ > 0 && next_steady_ < fitted_.size() &&
         fitted_[next_steady_].time_s - fitted_.front().time_s > 2.0 * half) {
    fitted_.pop_front();
    --next_steady_;
  }
}

}  // namespace limbwave::calibrate
