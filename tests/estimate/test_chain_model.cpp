#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "estimate/block_band.h"
#include "estimate/chain_model.h"
#include "estimate/joint_plausibility.h"
#include "estimate/synthetic_chain.h"

namespace limbwave::estimate {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(BlockBand, SolvesAndInvertsAsTheDenseMatrixDoes) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const std::size_t blocks : {1U, 3U, 4U, 9U}) {
    constexpr Index kSize = 4;
    constexpr std::size_t kReach = 3;
    const auto n = static_cast<Index>(blocks) * kSize;
    BlockBand band(blocks, kSize, kReach);
    MatrixXd dense = MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < blocks; ++i) {
      for (std::size_t j = i - std::min(i, kReach); j <= i; ++j) {
        MatrixXd block = MatrixXd::NullaryExpr(kSize, kSize, [&] { return 0.3 * normal(random); });
        if (i == j) {
          block = (block * block.transpose() + 6.0 * MatrixXd::Identity(kSize, kSize)).eval();
        }
        band.at(i, j) = block;
        dense.block(static_cast<Index>(i) * kSize, static_cast<Index>(j) * kSize, kSize, kSize) = block;
        dense.block(static_cast<Index>(j) * kSize, static_cast<Index>(i) * kSize, kSize, kSize) = block.transpose();
      }
      band.right(i) = VectorXd::NullaryExpr(kSize, [&] { return normal(random); });
    }
    VectorXd right(n);
    for (std::size_t i = 0; i < blocks; ++i) {
      right.segment(static_cast<Index>(i) * kSize, kSize) = band.right(i);
    }
    ASSERT_TRUE(band.factor());
    const VectorXd expected = dense.ldlt().solve(right);
    const MatrixXd inverse = dense.inverse();
    const std::vector<VectorXd> x = band.solve();
    const std::vector<MatrixXd> covariances = band.covariances();
    for (std::size_t i = 0; i < blocks; ++i) {
      const Index at = static_cast<Index>(i) * kSize;
      EXPECT_LT((x[i] - expected.segment(at, kSize)).norm(), 1e-10);
      EXPECT_LT((covariances[i] - inverse.block(at, at, kSize, kSize)).norm(), 1e-10) << blocks << " " << i;
    }
  }
}

TEST(BlockBand, RefusesWhatIsNotPositiveDefinite) {
  BlockBand band(2, 2, 1);
  band.at(0, 0) = MatrixXd::Identity(2, 2);
  band.at(1, 1) = MatrixXd::Identity(2, 2);
  band.at(1, 0) = 2.0 * MatrixXd::Identity(2, 2);
  EXPECT_FALSE(band.factor());
}

TEST(JointResiduals, GradientsAreTheDerivatives) {
  std::vector<body::Joint> joints(3);
  joints[0].kind = body::JointKind::kHinge;
  joints[1].kind = body::JointKind::kUniversal;
  joints[1].axis = -Vector3d::UnitY();
  joints[1].axis2 = Vector3d::UnitX();
  for (body::Joint& joint : joints) {
    joint.minimum = {-0.4, -0.3, -0.5};
    joint.maximum = {1.2, 0.6, 0.4};
  }
  for (const body::Joint& joint : joints) {
    for (const Vector3d& turn : {Vector3d(0.1, 0.2, -0.1), Vector3d(0.9, -0.7, 0.6), Vector3d(-0.6, 1.6, 0.2)}) {
      const Quaterniond R = geometry::exp_so3(turn);
      const auto residuals = joint_residuals(joint, R, 0.3, 1.0);
      ASSERT_FALSE(residuals.empty());
      for (Index axis = 0; axis < 3; ++axis) {
        constexpr double h = 1e-6;
        const auto more = joint_residuals(joint, geometry::exp_so3(h * Vector3d::Unit(axis)) * R, 0.3, 1.0);
        const auto less = joint_residuals(joint, geometry::exp_so3(-h * Vector3d::Unit(axis)) * R, 0.3, 1.0);
        ASSERT_EQ(more.size(), residuals.size());
        for (std::size_t i = 0; i < residuals.size(); ++i) {
          EXPECT_NEAR((more[i].value - less[i].value) / (2.0 * h), residuals[i].gradient[axis], 1e-5)
              << static_cast<int>(joint.kind) << " residual " << i << " axis " << axis;
        }
      }
    }
  }
}

TEST(JointResiduals, SayNothingWhereAJointIsAsItShouldBe) {
  body::Joint hinge;
  hinge.kind = body::JointKind::kHinge;
  hinge.minimum.setConstant(-0.5);
  hinge.maximum.setConstant(0.5);
  for (const JointResidual& residual : joint_residuals(hinge, Quaterniond::Identity(), 0.1, 1.0)) {
    EXPECT_NEAR(residual.value, 0.0, 1e-12);
  }
  // Off its axis by 0.2 rad; beyond its limit by 0.3 rad.
  const auto off = joint_residuals(hinge, geometry::exp_so3(Vector3d(0.2, 0.0, 0.0)), 0.1, 1.0);
  EXPECT_NEAR(std::hypot(off[0].value, off[1].value), 2.0, 1e-9);
  double beyond = 0.0;
  for (const JointResidual& residual : joint_residuals(hinge, geometry::exp_so3(Vector3d(0.0, 0.8, 0.0)), 0.1, 1.0)) {
    beyond = std::max(beyond, residual.value);
  }
  EXPECT_NEAR(beyond, 3.0, 1e-9);
}

ChainModel model_of(const test::ChainSeries& series) {
  return {series.chain, series.times, series.samples, ChainPriors{}};
}

ChainState truth_of(const test::ChainSeries& series) {
  return {series.R_WL, {std::vector<Vector3d>(series.times.size(), Vector3d::Zero())}};
}

// The hurried arm accelerates its sensors by several m/s²; the model explains all of it.
TEST(ChainModel, ExplainsAPendulumsReadingsExactly) {
  const LimbChain chain = test::three_links();
  const auto series = test::felt_by_chain(6.0, test::swinging, 0.0, chain, chain);
  const ChainModel model = model_of(series);
  const ChainState state = truth_of(series);
  double strongest = 0.0;
  for (std::size_t link = 0; link < 3; ++link) {
    for (std::size_t k = 1; k + 1 < series.times.size(); ++k) {
      Vector3d residual;
      ASSERT_TRUE(model.force_residual(state, link, k, residual));
      EXPECT_LT(residual.norm(), 1e-3) << link << " " << k;
      strongest = std::max(strongest, std::abs(series.samples[link][k].f_L.norm() - kStandardGravity));
    }
  }
  EXPECT_GT(strongest, 3.0);
}

// The right side is the downhill slope of the cost, for every unknown and every residual.
TEST(ChainModel, EquationsAreTheDerivativesOfTheCost) {
  const LimbChain chain = test::three_links();
  auto series = test::felt_by_chain(4.0, test::swinging, 0.3, chain, chain);
  // A short piece, with a clipped reading, and a state that is wrong in everything.
  const auto shorten = [](auto& all) { all = {all.begin() + 150, all.begin() + 157}; };
  shorten(series.times);
  series.times[3] += 0.002;  // clocks wander
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < 3; ++i) {
    shorten(series.samples[i]);
    shorten(series.R_WL[i]);
    for (Quaterniond& R : series.R_WL[i]) {
      R = geometry::exp_so3(0.3 * Vector3d(normal(random), normal(random), normal(random))) * R;
    }
  }
  series.samples[1][5].usable = false;
  const ChainModel model = model_of(series);
  ChainState state = truth_of(series);
  for (Vector3d& q : state.q_W[0]) {
    q = 0.01 * Vector3d(normal(random), normal(random), normal(random));
  }
  const std::vector<std::vector<double>> ones(3, std::vector<double>(series.times.size(), 1.3));
  ChainWeights weights;
  weights.force_sd = weights.turning_sd = weights.rate_sd = ones;
  weights.root_sd = {ones.front()};
  BlockBand system(series.times.size(), model.block_size(), ChainModel::kReach);
  const double cost = model.linearise(state, weights, system);
  EXPECT_NEAR(cost, model.cost(state, weights), 1e-9 * cost);
  for (std::size_t k = 0; k < series.times.size(); ++k) {
    for (Index c = 0; c < model.block_size(); ++c) {
      constexpr double h = 1e-6;
      std::vector<VectorXd> step(series.times.size(), VectorXd::Zero(model.block_size()));
      step[k][c] = h;
      const double more = model.cost(model.moved(state, step), weights);
      step[k][c] = -h;
      const double less = model.cost(model.moved(state, step), weights);
      const double slope = (more - less) / (2.0 * h);
      EXPECT_NEAR(-system.right(k)[c], slope, 1e-4 * std::abs(slope) + 0.02) << k << " " << c;
    }
  }
}

}  // namespace
}  // namespace limbwave::estimate
