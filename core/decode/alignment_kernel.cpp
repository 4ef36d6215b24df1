#include "decode/alignment_kernel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::decode {
namespace {

constexpr double kMeanPower = 1e9;  // of the steady part: gravity

double sinc(double x) {
  return std::fabs(x) < 1e-9 ? 1.0 : std::sin(x) / x;
}

}  // namespace

AlignmentKernel::AlignmentKernel() {
  using Matrix = Eigen::Matrix<double, kTaps, kTaps>;
  using Vector = Eigen::Matrix<double, kTaps, 1>;
  // Covariance of the assumed signal over a distance of `cycles`, in units of the noise's variance.
  const auto covariance = [](double cycles) {
    return kMeanPower + kPassPower * sinc(2.0 * kPi * kPassband * cycles) +
           kEdgePower * sinc(2.0 * kPi * kEdge * cycles) + kRestPower * sinc(kPi * cycles);
  };
  Matrix between;
  for (Eigen::Index k = 0; k < between.rows(); ++k) {
    for (Eigen::Index l = 0; l < between.cols(); ++l) {
      between(k, l) = covariance(static_cast<double>(k - l)) + (k == l ? 1.0 : 0.0);
    }
  }
  const Eigen::LDLT<Matrix> factors(between);
  weights_.resize(kSteps + 1);
  for (int step = 0; step <= kSteps; ++step) {
    const double offset = static_cast<double>(step) / kSteps - 0.5;
    Vector to_zero;
    for (Eigen::Index k = 0; k < to_zero.size(); ++k) {
      to_zero[k] = covariance(static_cast<double>(k) - static_cast<double>(kBefore) + offset);
    }
    Vector solution = factors.solve(to_zero);
    solution /= solution.sum();  // what does not move comes out exactly
    for (std::size_t k = 0; k < kTaps; ++k) {
      weights_[static_cast<std::size_t>(step)][k] = solution[static_cast<Eigen::Index>(k)];
    }
  }
}

double AlignmentKernel::at_zero(const Values& instants, const Values& values) const {
  const int step = std::clamp(static_cast<int>(std::lround((instants[kBefore] + 0.5) * kSteps)), 0, kSteps);
  const double offset = static_cast<double>(step) / kSteps - 0.5;
  const Values& weights = weights_[static_cast<std::size_t>(step)];
  double sum = 0.0;
  for (std::size_t k = 0; k < kTaps; ++k) {
    // Where the weights assume this value, and how fast the signal changes there.
    const double late = instants[k] - (static_cast<double>(k) - static_cast<double>(kBefore) + offset);
    const double rate = k == 0           ? -1.5 * values[0] + 2.0 * values[1] - 0.5 * values[2]
                        : k == kTaps - 1 ? 1.5 * values[k] - 2.0 * values[k - 1] + 0.5 * values[k - 2]
                                         : 0.5 * (values[k + 1] - values[k - 1]);
    sum += weights[k] * (values[k] - late * rate);
  }
  return sum;
}

}  // namespace limbwave::decode
