#include "estimate/body_adjoint.h"

#include <algorithm>
#include <cmath>

#include "body/tree_kinematics.h"

namespace limbwave::estimate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the filter's variance, what is left at the least: samples may err by more than the difference.
constexpr double kLeastLeft = 0.04;

// λ −= Hᵀ y.
void take_off(const UpdateRecord& update, const VectorXd& y, VectorXd& lambda) {
  const int* index = update.support.data();
  const double* h = update.H.data();
  Index row = 0;
  for (const UpdateRecord::Rows& group : update.groups) {
    for (int s = 0; s < group.support; ++s, ++index) {
      for (int r = 0; r < group.rows; ++r) {
        lambda[*index] -= *h++ * y[row + r];
      }
    }
    row += group.rows;
  }
}

// y ← U⁻¹ y.
void solve_upper(const UpdateRecord& update, VectorXd& y) {
  for (Index i = y.size(); i-- > 0;) {
    const double* u = update.U.row(i);
    for (Index k = i + 1; k < y.size(); ++k) {
      y[i] -= u[k] * y[k];
    }
    y[i] *= update.inverse[static_cast<std::size_t>(i)];
  }
}

// Fᵀ λ.
template <typename Lambda>
void back_over_predict(const PredictRecord& predict, const body::Tree& tree, Lambda& lambda) {
  if (predict.dt <= 0.0) {
    return;
  }
  for (const PredictRecord::Tissue& t : predict.tissues) {
    lambda.template middleRows<3>(t.gain) =
        t.a * lambda.template middleRows<3>(t.gain) + t.b * lambda.template middleRows<3>(t.angle);
    lambda.template middleRows<3>(t.angle) *= t.a;
  }
  const int n = tree.dofs();
  lambda.middleRows(2 * n, n) = predict.aa * lambda.middleRows(2 * n, n) + predict.va * lambda.middleRows(n, n);
  auto ball = predict.balls.begin();
  using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  for (const body::TreeLink& link : tree.links()) {
    const int f = link.first;
    if (link.kind == body::LinkKind::kBall) {
      const auto at = lambda.template middleRows<3>(f).eval();
      lambda.template middleRows<3>(f) = Eigen::Map<const Block>(ball->A.data()).transpose() * at;
      lambda.template middleRows<3>(n + f) += Eigen::Map<const Block>(ball->B.data()).transpose() * at;
      lambda.template middleRows<3>(2 * n + f) += Eigen::Map<const Block>(ball->C.data()).transpose() * at;
      ++ball;
    } else {
      for (int i = f; i < f + link.count; ++i) {
        lambda.row(n + i) += predict.dt * lambda.row(i);
        lambda.row(2 * n + i) += predict.c * lambda.row(i);
      }
    }
  }
}

template <typename Lambda, typename BackOverUpdate>
void back_over_step(const StepRecord& step, const body::Tree& tree, Lambda& lambda, const BackOverUpdate& back) {
  for (std::size_t u = step.updates.size(); u-- > 0;) {
    back(step.updates[u]);
  }
  back_over_predict(step.predict, tree, lambda);
  if (step.forgets) {
    lambda.middleRows(tree.dofs(), 2 * tree.dofs()).setZero();
  }
}

}  // namespace

// Over an update λ becomes λ − Hᵀ U⁻¹ (e + W λ).
void adjoint_over_step(const StepRecord& step, const body::Tree& tree, VectorXd& lambda) {
  back_over_step(step, tree, lambda, [&](const UpdateRecord& update) {
    const auto m = static_cast<Index>(update.e.size());
    VectorXd y = Eigen::Map<const VectorXd>(update.e.data(), m);
    for (Index i = 0; i < m; ++i) {
      y[i] += Eigen::Map<const VectorXd>(update.W.row(i), lambda.size()).dot(lambda);
    }
    solve_upper(update, y);
    take_off(update, y, lambda);
  });
}

SampledAdjoint::SampledAdjoint(int size) : size_(size) {
  lambdas_.resize(size, kWidth);
  std::fill_n(lambdas_.row(0), size * kWidth, 0.0);
}

VectorXd SampledAdjoint::lambda() const {
  return Eigen::Map<const Rows>(lambdas_.row(0), size_, kWidth).col(0);
}

SampledAdjoint::Rows SampledAdjoint::changes(const AlignedRows& P_theta) const {
  AlignedRows product;
  product.resize(P_theta.rows(), kWidth);
  covariance_kernel().product(P_theta.row(0), P_theta.columns(), P_theta.rows(), size_, lambdas_.row(0), product.row(0),
                              kWidth);
  return Eigen::Map<const Rows>(product.row(0), P_theta.rows(), kWidth);
}

void SampledAdjoint::over_update(const UpdateRecord& update) {
  const auto m = static_cast<Index>(update.e.size());
  product_.resize(m, kWidth);
  covariance_kernel().product(update.W.row(0), update.W.columns(), m, size_, lambdas_.row(0), product_.row(0), kWidth);
  Eigen::Map<Rows, Eigen::AlignedMax> y(product_.row(0), m, kWidth);
  for (Index i = 0; i < m; ++i) {
    y(i, 0) += update.e[static_cast<std::size_t>(i)];
    std::uint64_t signs = random_();
    for (Index k = 1; k <= kSamples; ++k, signs >>= 1U) {
      y(i, k) += (signs & 1U) != 0 ? 1.0 : -1.0;
    }
  }
  covariance_kernel().solve_upper(update.U.row(0), update.U.columns(), update.inverse.data(), product_.row(0), m,
                                  kWidth);
  const int* index = update.support.data();
  const double* h = update.H.data();
  Index row = 0;
  for (const UpdateRecord::Rows& group : update.groups) {
    covariance_kernel().take_off(lambdas_.row(0), index, group.support, h, group.rows, product_.row(row), kWidth);
    index += group.support;
    h += group.support * group.rows;
    row += group.rows;
  }
}

void SampledAdjoint::over_step(const StepRecord& step, const body::Tree& tree) {
  Eigen::Map<Rows, Eigen::AlignedMax> lambda(lambdas_.row(0), size_, kWidth);
  back_over_step(step, tree, lambda, [&](const UpdateRecord& update) { over_update(update); });
}

PoseSigma pose_sigma(const body::Tree& tree, const body::Skeleton& skeleton, const body::TreeState& state,
                     const MatrixXd& P_theta, const MatrixXd& changes) {
  PoseSigma sigma;
  const auto segments = static_cast<std::size_t>(tree.segments());
  std::vector<double> variance(segments, 0.0);
  const double samples = static_cast<double>(std::max<Index>(1, changes.cols()));
  const auto left = [&](double before, double taken) { return std::max(before - taken, kLeastLeft * before); };
  for (const body::TreeLink& link : tree.links()) {
    for (int i = link.first; i < link.first + link.count; ++i) {
      const double own = left(P_theta(i, i), changes.cols() > 0 ? changes.row(i).squaredNorm() / samples : 0.0);
      if (link.kind == body::LinkKind::kTranslation) {
        sigma.root[i - link.first] = std::sqrt(own);
      } else {
        variance[static_cast<std::size_t>(link.segment)] += own;
      }
    }
  }
  body::TreeKinematics kinematics(tree);
  kinematics.update(state);
  body::PointJacobians jacobians;
  for (std::size_t s = 0; s < segments; ++s) {
    sigma.joints.push_back(static_cast<float>(std::sqrt(variance[s])));
    const int link = tree.link_of(static_cast<int>(s));
    const auto point = kinematics.point(link, Eigen::Vector3d(skeleton.segments[s].length, 0.0, 0.0));
    kinematics.jacobians(link, point, body::TreeKinematics::kPosition, jacobians);
    const std::vector<int>& dofs = tree.chain_dofs(link);
    const auto count = static_cast<Index>(dofs.size());
    MatrixXd P(count, count);
    MatrixXd moved(count, changes.cols());
    for (Index a = 0; a < count; ++a) {
      for (Index b = 0; b < count; ++b) {
        P(a, b) = P_theta(dofs[static_cast<std::size_t>(a)], dofs[static_cast<std::size_t>(b)]);
      }
      if (changes.cols() > 0) {
        moved.row(a) = changes.row(dofs[static_cast<std::size_t>(a)]);
      }
    }
    const double before = (jacobians.J_p_theta * P * jacobians.J_p_theta.transpose()).trace();
    const double taken = changes.cols() > 0 ? (jacobians.J_p_theta * moved).squaredNorm() / samples : 0.0;
    sigma.points.push_back(static_cast<float>(std::sqrt(std::max(0.0, left(before, taken)))));
  }
  return sigma;
}

}  // namespace limbwave::estimate
