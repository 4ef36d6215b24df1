#include "calibrate/range_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calibrate/sphere_coverage.h"

namespace limbwave::calibrate {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kUnknowns = 10;  // 9 of the ellipsoid and the gain after a step
using Parameters = Eigen::Matrix<double, kUnknowns, 1>;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// Highest value of the parabola that runs through most of the readings of an axis, on their stretch of time: least
// absolute deviations by reweighting, so that a peak within it changes nothing.
double summit(std::span<const RangeObservation> observations, int axis, double sign, double middle_s, double scale_s) {
  Vector3d c = Vector3d::Zero();
  for (int iteration = 0; iteration < 20; ++iteration) {
    Matrix3d normal = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const RangeObservation& observation : observations) {
      const double t = (observation.time_s - middle_s) / scale_s;
      const Vector3d basis(1.0, t, t * t);
      const double x = sign * observation.x[axis];
      const double weight = iteration == 0 ? 1.0 : 1.0 / std::max(std::abs(x - c.dot(basis)), 1e-4);
      normal += weight * basis * basis.transpose();
      right += weight * x * basis;
    }
    c = normal.ldlt().solve(right);
  }
  const double first = (observations.front().time_s - middle_s) / scale_s;
  const double last = (observations.back().time_s - middle_s) / scale_s;
  const double top = c[2] < 0.0 ? std::clamp(-0.5 * c[1] / c[2], first, last) : last;
  const auto at = [&](double t) { return c[0] + t * (c[1] + t * c[2]); };
  return std::max({at(first), at(last), at(top)});
}

// The highest value of an axis that is no short peak; `sign` −1 gives the lowest.
std::optional<double> robust_highest(std::span<const RangeObservation> observations, int axis, double sign,
                                     const ExtremesParameters& parameters) {
  // Erosion: the smallest value of every window of opening_s within a run. The highest of these is the opening's
  // maximum, so the following dilation need not be done.
  struct Eroded {
    double value = 0.0;
    double seconds = 0.0;  // that it stands for
    std::size_t first = 0, last = 0;
  };
  std::vector<Eroded> eroded;
  const auto joined = [&](std::size_t i) {
    return i > 0 && observations[i].time_s - observations[i - 1].time_s <= parameters.largest_gap_s;
  };
  std::size_t begin = 0;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const double step = i == 0 ? 0.0 : observations[i].time_s - observations[i - 1].time_s;
    if (i > 0 && !joined(i)) {
      begin = i;
    }
    std::size_t first = i;
    double lowest = sign * observations[i].x[axis];
    while (first > begin && observations[i].time_s - observations[first].time_s < parameters.opening_s - 1e-9) {
      --first;
      lowest = std::min(lowest, sign * observations[first].x[axis]);
    }
    if (observations[i].time_s - observations[first].time_s >= parameters.opening_s - 1e-9) {
      eroded.push_back({lowest, step, first, i});
    }
  }
  std::sort(eroded.begin(), eroded.end(), [](const Eroded& a, const Eroded& b) {
    return a.value != b.value ? a.value > b.value : a.first < b.first;
  });
  double seconds = 0.0;
  for (const Eroded& place : eroded) {
    seconds += place.seconds;
    if (seconds < parameters.percentile_s) {
      continue;
    }
    const double middle = 0.5 * (observations[place.first].time_s + observations[place.last].time_s);
    std::size_t first = place.first;
    while (joined(first) && middle - observations[first - 1].time_s <= parameters.summit_s) {
      --first;
    }
    std::size_t last = place.last;
    while (last + 1 < observations.size() && joined(last + 1) &&
           observations[last + 1].time_s - middle <= parameters.summit_s) {
      ++last;
    }
    const auto around = observations.subspan(first, last - first + 1);
    // What was kept for a while is reached at least.
    return sign * (around.size() < 6 ? place.value
                                     : std::max(place.value, summit(around, axis, sign, middle, parameters.summit_s)));
  }
  return std::nullopt;
}

RangeModel model_of(const Parameters& p) {
  RangeModel model;
  model.b = p.head<3>();
  model.A << p[3], p[6], p[7], p[6], p[4], p[8], p[7], p[8], p[5];
  return model;
}

// A direction that was held long must not outweigh the rest of the sphere.
std::vector<double> direction_weights(std::span<const RangeObservation> observations, const RangeModel& start) {
  std::array<double, SphereCoverage::kCells> count{};
  std::vector<std::size_t> cells;
  cells.reserve(observations.size());
  for (const RangeObservation& observation : observations) {
    cells.push_back(static_cast<std::size_t>(SphereCoverage::cell_of(start.A * (observation.x - start.b))));
    count[cells.back()] += 1.0;
  }
  std::vector<double> occupied;
  std::copy_if(count.begin(), count.end(), std::back_inserter(occupied), [](double n) { return n > 0.0; });
  const auto middle = occupied.begin() + static_cast<std::ptrdiff_t>(occupied.size() / 2);
  std::nth_element(occupied.begin(), middle, occupied.end());
  std::vector<double> weights;
  weights.reserve(cells.size());
  for (const std::size_t cell : cells) {
    weights.push_back(std::min(1.0, *middle / count[cell]));
  }
  return weights;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class EllipsoidProblem {
 public:
  EllipsoidProblem(std::span<const RangeObservation> observations, const RangeModel& start,
                   const std::optional<GainStep>& step)
      : observations_(observations), step_(step), weights_(direction_weights(observations, start)) {}

  [[nodiscard]] Vector3d undone(const RangeObservation& observation, double gain) const {
    if (!step_ || observation.time_s <= step_->time_s) {
      return observation.x;
    }
    return (observation.x + step_->zero_x) / gain - step_->zero_x;
  }

  [[nodiscard]] std::vector<double> residuals(const Parameters& p) const {
    const RangeModel model = model_of(p);
    std::vector<double> r;
    r.reserve(observations_.size());
    for (const RangeObservation& observation : observations_) {
      r.push_back(model.residual(undone(observation, p[9])));
    }
    return r;
  }

  // Tukey's biweight: ρ(r) = c²/6 (1 − (1 − (r/c)²)³), c²/6 beyond c.
  [[nodiscard]] double cost(const std::vector<double>& r, double c) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double s = std::min(1.0, r[i] * r[i] / (c * c));
      sum += weights_[i] * (c * c / 6.0) * (1.0 - (1.0 - s) * (1.0 - s) * (1.0 - s));
    }
    return sum;
  }

  void linearise(const Parameters& p, const std::vector<double>& r, double c, Normal& N, Parameters& gradient) const {
    N.setZero();
    gradient.setZero();
    const RangeModel model = model_of(p);
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      const double s = r[i] * r[i] / (c * c);
      if (s >= 1.0) {
        continue;
      }
      const Vector3d x = undone(observations_[i], p[9]);
      Eigen::Matrix<double, 1, kUnknowns> J = Eigen::Matrix<double, 1, kUnknowns>::Zero();
      J.head<9>() = J_residual_model(model, x);
      if (step_ && observations_[i].time_s > step_->time_s) {
        const Vector3d f = model.A * (x - model.b);
        J[9] = -f.normalized().dot(model.A * (x + step_->zero_x)) / p[9];
      }
      const double w = weights_[i] * (1.0 - s) * (1.0 - s);
      N += w * J.transpose() * J;
      gradient += w * r[i] * J.transpose();
    }
    if (!step_) {
      N(9, 9) = 1.0;  // not an unknown
    }
  }

 private:
  std::span<const RangeObservation> observations_;
  const std::optional<GainStep>& step_;
  std::vector<double> weights_;
};

double robust_sigma(const std::vector<double>& r) {
  std::vector<double> size;
  size.reserve(r.size());
  std::transform(r.begin(), r.end(), std::back_inserter(size), [](double v) { return std::abs(v); });
  return std::max(1.4826 * median_of(std::move(size)), 1e-7);
}

}  // namespace

std::optional<RangeModel> fit_extremes(std::span<const RangeObservation> observations,
                                       const ExtremesParameters& parameters) {
  RangeModel model;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> high = robust_highest(observations, axis, 1.0, parameters);
    const std::optional<double> low = robust_highest(observations, axis, -1.0, parameters);
    if (!high || !low || *high - *low < 0.2) {
      return std::nullopt;
    }
    model.b[axis] = 0.5 * (*high + *low);
    model.A(axis, axis) = 2.0 / (*high - *low);
  }
  return model;
}

Eigen::Matrix<double, 1, 9> J_residual_model(const RangeModel& model, const Vector3d& x) {
  const Vector3d y = x - model.b;
  const Vector3d u = (model.A * y).normalized();
  Eigen::Matrix<double, 1, 9> J;
  J.head<3>() = -u.transpose() * model.A;
  J.segment<3>(3) = u.cwiseProduct(y).transpose();
  J[6] = u.x() * y.y() + u.y() * y.x();
  J[7] = u.x() * y.z() + u.z() * y.x();
  J[8] = u.y() * y.z() + u.z() * y.y();
  return J;
}

std::optional<EllipsoidFit> fit_ellipsoid(std::span<const RangeObservation> observations, const RangeModel& start,
                                          const std::optional<GainStep>& step) {
  if (observations.size() < 20) {
    return std::nullopt;
  }
  const EllipsoidProblem problem(observations, start, step);
  const Matrix3d symmetric = 0.5 * (start.A + start.A.transpose());
  Parameters p;
  p << start.b, symmetric(0, 0), symmetric(1, 1), symmetric(2, 2), symmetric(0, 1), symmetric(0, 2), symmetric(1, 2),
      1.0;
  EllipsoidFit fit;
  double damping = 1e-4;
  std::vector<double> r = problem.residuals(p);
  Normal N;
  Parameters gradient;
  for (fit.iterations = 0; fit.iterations < 60; ++fit.iterations) {
    // The cut-off follows the residuals down, so that a poor start does not lose good readings.
    const double c = 4.685 * robust_sigma(r);
    problem.linearise(p, r, c, N, gradient);
    const double before = problem.cost(r, c);
    double change = 0.0;
    bool better = false;
    for (int attempt = 0; attempt < 8 && !better; ++attempt) {
      Normal damped = N;
      damped.diagonal() *= 1.0 + damping;
      const Parameters delta = -damped.ldlt().solve(gradient);
      if (!delta.allFinite()) {
        return std::nullopt;
      }
      const Parameters candidate = p + delta;
      std::vector<double> candidate_r = problem.residuals(candidate);
      if (problem.cost(candidate_r, c) <= before) {
        p = candidate;
        r = std::move(candidate_r);
        change = delta.norm();
        better = true;
        damping = std::max(damping * 0.1, 1e-12);
      } else {
        damping *= 10.0;
      }
    }
    if (!better || change < 1e-12) {
      break;
    }
  }
  fit.model = model_of(p);
  fit.gain_after = p[9];
  fit.sigma = robust_sigma(r);
  problem.linearise(p, r, 4.685 * fit.sigma, N, gradient);
  const Eigen::SelfAdjointEigenSolver<Normal> eigen(N);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(fit.model.A, Eigen::EigenvaluesOnly);
  if (!p.allFinite() || eigen.eigenvalues()[0] < 1e-9 * eigen.eigenvalues()[kUnknowns - 1] ||
      axes.eigenvalues()[0] <= 0.0) {
    return std::nullopt;
  }
  const Normal covariance = fit.sigma * fit.sigma * N.inverse();
  fit.offset_sd = std::sqrt(covariance.topLeftCorner<3, 3>().trace() / 3.0);
  return fit;
}

}  // namespace limbwave::calibrate
