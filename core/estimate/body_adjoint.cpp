#include "estimate/body_adjoint.h"

#include <algorithm>
#include <cmath>

#include "body/tree_kinematics.h"

namespace limbwave::estimate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Rows = SampledAdjoint::Rows;

// Of the filter's variance, what is left at the least: samples may err by more than the difference.
constexpr double kLeastLeft = 0.04;

// λ ← λ − Gᵀ (e + W λ), a column for every λ; `e` gives the drive of row i.
template <typename Lambda, typename Drive>
void back_over_update(const UpdateRecord& update, Lambda& lambda, const Drive& drive) {
  const Index m = update.W.rows();
  const Eigen::Map<const Rows, 0, Eigen::OuterStride<>> W(update.W.row(0), m, lambda.rows(),
                                                          Eigen::OuterStride<>(update.W.columns()));
  Rows product = W * lambda;
  drive(product);
  for (Index i = 0; i < m; ++i) {
    const double* g = update.G.row(i);
    for (std::size_t s = 0; s < update.support.size(); ++s) {
      lambda.row(update.support[s]) -= g[s] * product.row(i);
    }
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

template <typename Lambda, typename Drive>
void over_step(const StepRecord& step, const body::Tree& tree, Lambda& lambda, const Drive& drive) {
  for (std::size_t u = step.updates.size(); u-- > 0;) {
    back_over_update(step.updates[u], lambda, [&](Rows& product) { drive(step.updates[u], product); });
  }
  back_over_predict(step.predict, tree, lambda);
  if (step.forgets) {
    lambda.middleRows(tree.dofs(), 2 * tree.dofs()).setZero();
  }
}

void add_innovations(const UpdateRecord& update, Rows& product) {
  product.col(0) += Eigen::Map<const VectorXd>(update.e.data(), static_cast<Index>(update.e.size()));
}

}  // namespace

void adjoint_over_step(const StepRecord& step, const body::Tree& tree, VectorXd& lambda) {
  over_step(step, tree, lambda, add_innovations);
}

void SampledAdjoint::over_step(const StepRecord& step, const body::Tree& tree) {
  estimate::over_step(step, tree, lambdas_, [&](const UpdateRecord& update, Rows& product) {
    add_innovations(update, product);
    for (Index i = 0; i < product.rows(); ++i) {
      std::uint64_t signs = random_();
      for (Index k = 1; k <= kSamples; ++k, signs >>= 1U) {
        product(i, k) += (signs & 1U) != 0 ? 1.0 : -1.0;
      }
    }
  });
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
