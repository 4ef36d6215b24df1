#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/units.h"
#include "estimate/body_filter.h"
#include "estimate/body_smoother.h"
#include "support/dense_ekf.h"
#include "support/drawn_wearer.h"

namespace limbwave::estimate {
namespace {

using Eigen::MatrixXd;

MatrixXd random_covariance(int n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  MatrixXd A(n, n);
  for (double& a : A.reshaped()) {
    a = normal(random);
  }
  return A * A.transpose() / n + 0.1 * MatrixXd::Identity(n, n);
}

MeasurementGroup random_group(int rows, int n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  MeasurementGroup group;
  group.rows = rows;
  for (int i = 0; i < n; ++i) {
    if (normal(random) > 0.3) {
      group.support.push_back(i);
      for (int r = 0; r < rows; ++r) {
        group.H.push_back(normal(random));
      }
    }
  }
  for (int r = 0; r < rows; ++r) {
    group.innovation[r] = normal(random);
    group.variance[r] = 0.5 + std::abs(normal(random));
  }
  return group;
}

// The textbook's update, in Joseph's form.
void dense_update(const std::vector<MeasurementGroup>& groups, MatrixXd& P, VectorXd& x) {
  for (const MeasurementGroup& g : groups) {
    MatrixXd H = MatrixXd::Zero(g.rows, P.rows());
    MatrixXd R = MatrixXd::Zero(g.rows, g.rows);
    VectorXd nu(g.rows);
    for (int r = 0; r < g.rows; ++r) {
      for (std::size_t s = 0; s < g.support.size(); ++s) {
        H(r, g.support[s]) += g.H[s * static_cast<std::size_t>(g.rows) + static_cast<std::size_t>(r)];
      }
      R(r, r) = g.variance[r];
      nu[r] = g.innovation[r];
    }
    const MatrixXd S = H * P * H.transpose() + R;
    const MatrixXd K = P * H.transpose() * S.inverse();
    x += K * (nu - H * x);
    const MatrixXd I_KH = MatrixXd::Identity(P.rows(), P.cols()) - K * H;
    P = I_KH * P * I_KH.transpose() + K * R * K.transpose();
  }
}

TEST(ErrorCovariance, UpdatesAsTheTextbookDoes) {
  std::mt19937 random(3);
  for (const int n : {5, 8, 17, 70}) {
    MatrixXd P = random_covariance(n, random);
    ErrorCovariance fast(n);
    fast.set_dense(P);
    std::vector<MeasurementGroup> groups;
    for (const int rows : {3, 1, 3, 3, 1}) {
      groups.push_back(random_group(rows, n, random));
    }
    VectorXd x = VectorXd::Zero(n);
    VectorXd correction = VectorXd::Zero(n);
    dense_update(groups, P, x);
    fast.update(groups.data(), groups.data() + groups.size(), correction);
    EXPECT_LT((fast.dense() - P).norm(), 1e-11 * P.norm());
    EXPECT_LT((correction - x).norm(), 1e-11 * (1.0 + x.norm()));
    EXPECT_EQ((fast.dense() - fast.dense().transpose()).norm(), 0.0);
  }
}

TEST(ErrorCovariance, AGatedGroupChangesNothing) {
  std::mt19937 random(4);
  const int n = 12;
  const MatrixXd P = random_covariance(n, random);
  std::vector<MeasurementGroup> groups{random_group(3, n, random), random_group(1, n, random)};
  ErrorCovariance with(n);
  ErrorCovariance without(n);
  with.set_dense(P);
  without.set_dense(P);
  VectorXd a = VectorXd::Zero(n);
  VectorXd b = a;
  groups[0].innovation[1] = 1e3;
  groups[0].gate = 20.0;
  with.update(groups.data(), groups.data() + 2, a);
  without.update(groups.data() + 1, groups.data() + 2, b);
  EXPECT_FALSE(groups[0].accepted);
  EXPECT_EQ((with.dense() - without.dense()).norm(), 0.0);
  EXPECT_EQ((a - b).norm(), 0.0);
}

TEST(ErrorCovariance, AgreesToRoundingOnEveryProcessor) {
  std::mt19937 random(5);
  const int n = 77;
  const MatrixXd P = random_covariance(n, random);
  std::vector<MeasurementGroup> groups;
  for (int i = 0; i < 5; ++i) {
    groups.push_back(random_group(3, n, random));
  }
  MatrixXd results[2];
  for (int i = 0; i < 2; ++i) {
    ErrorCovariance covariance(n);
    covariance.use(i == 0 ? covariance_kernel() : portable_covariance_kernel());
    covariance.set_dense(P);
    VectorXd x = VectorXd::Zero(n);
    covariance.update(groups.data(), groups.data() + groups.size(), x);
    results[i] = covariance.dense();
  }
  EXPECT_LT((results[0] - results[1]).norm(), 1e-14 * n * P.norm());
}

// The normalised estimation error squared is χ² with as many degrees of freedom as there are states: its mean over runs
// lies within its 95 % bounds. A wrong Jacobian, a missing term of the process or a wrong variance would show.
class Consistency : public testing::TestWithParam<double> {};

TEST_P(Consistency, ErrorsAreAsLargeAsTheFilterSays) {
  BodyFilterParameters p = modelled_errors_only();
  p.tissue_angle = GetParam();
  constexpr int kRuns = 30;
  constexpr double kRate = 100.0;
  double sum[3] = {0, 0, 0};
  double skin[3] = {0, 0, 0};
  double freedom = 0.0;
  double skin_freedom = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    Drawn drawn(static_cast<unsigned>(run), p);
    BodyFilter filter(drawn.model, p);
    drawn.start(filter);
    const int first = 3 * filter.layout().dofs;
    const int moving = filter.layout().moving - first;
    freedom += filter.layout().size;
    skin_freedom += moving;
    for (int k = 1; k <= 150; ++k) {
      drawn.move(filter, 1.0 / kRate);
      BodyReadings readings;
      drawn.measure(filter, k % 5 == 0, readings);
      for (const BodyInstant& instant : instants_of(readings)) {
        filter.step(instant, nullptr);
      }
      if (k % 50 == 0) {
        const VectorXd e = drawn.error(filter);
        const MatrixXd P = filter.covariance().dense();
        sum[k / 50 - 1] += e.dot(P.ldlt().solve(e));
        if (moving > 0) {
          const VectorXd own = e.segment(first, moving);
          skin[k / 50 - 1] += own.dot(P.block(first, first, moving, moving).ldlt().solve(own));
        }
      }
    }
  }
  const auto bound = [](double n) { return 1.96 * std::sqrt(2.0 / n); };
  for (const double nees : sum) {
    EXPECT_NEAR(nees / freedom, 1.0, bound(freedom)) << nees << " of " << freedom;
  }
  for (const double nees : skin) {
    if (skin_freedom > 0.0) {
      EXPECT_NEAR(nees / skin_freedom, 1.0, bound(skin_freedom)) << "skin: " << nees << " of " << skin_freedom;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(BodyFilter, Consistency, testing::Values(0.0, 0.0185),
                         [](const auto& skin) { return skin.param > 0.0 ? "SkinSlides" : "SkinHolds"; });

TEST(BodySmoother, IsBetterThanTheFilterAndEqualAtTheEnd) {
  BodyFilterParameters p = modelled_errors_only();
  double filter_square = 0.0;
  double smoother_square = 0.0;
  for (unsigned seed = 40; seed < 46; ++seed) {
    Drawn drawn(seed, p);
    BodyFilter filter(drawn.model, p);
    drawn.start(filter);
    BodyReadings readings;
    std::vector<std::vector<Eigen::Quaterniond>> truth;
    for (int k = 1; k <= 200; ++k) {
      drawn.move(filter, 0.01);
      drawn.measure(filter, k % 10 == 0, readings);
      truth.push_back(filter.tree().segment_rotations(drawn.truth.joints));
    }
    // Root kFixed starts at rest in both; stretches shorter than the recording.
    const auto forward = filter_body(drawn.model, p, readings, 1000.0, {});
    const auto both = smooth_body(drawn.model, p, readings, 1000.0, {}, 0.3);
    const auto other_stretches = smooth_body(drawn.model, p, readings, 1000.0, {}, 10.0);
    ASSERT_TRUE(forward.ok() && both.ok() && other_stretches.ok());
    ASSERT_EQ(both->track.times.size(), truth.size());
    ASSERT_EQ(forward->track.times.size(), truth.size());
    for (std::size_t k = 0; k < truth.size(); ++k) {
      for (std::size_t s = 0; s < truth[k].size(); ++s) {
        const double f = geometry::geodesic_angle(truth[k][s], forward->track.R_joint[k][s]);
        const double b = geometry::geodesic_angle(truth[k][s], both->track.R_joint[k][s]);
        filter_square += f * f;
        smoother_square += b * b;
        EXPECT_LT(geometry::geodesic_angle(both->track.R_joint[k][s], other_stretches->track.R_joint[k][s]), 1e-9);
        if (k + 1 == truth.size()) {
          EXPECT_LT(geometry::geodesic_angle(forward->track.R_joint[k][s], both->track.R_joint[k][s]), 1e-9);
        }
      }
    }
  }
  EXPECT_LT(std::sqrt(smoother_square), 0.85 * std::sqrt(filter_square));
}

// The same linearisations through dense matrices, F P Fᵀ + Q and (I − K H) P: the same covariance and correction.
TEST(BodyFilter, GivesTheTextbooksAnswer) {
  BodyFilterParameters p = modelled_errors_only();
  p.tissue_angle = 0.02;
  p.acceleration_time = 0.1;
  p.gyroscope_bias_walk = p.mount_place_walk = 1e-3;
  Drawn drawn(21, p);
  BodyFilter filter(drawn.model, p);
  drawn.start(filter);
  testing_support::DenseEkf dense;
  dense.P = filter.covariance().dense();
  for (int k = 1; k <= 60; ++k) {
    drawn.move(filter, 0.01);
    BodyReadings readings;
    drawn.measure(filter, k % 5 == 0, readings);
    const BodyState before = filter.state();
    StepRecord record;
    std::vector<std::vector<MeasurementGroup>> linearised;
    record.linearised = &linearised;
    for (const BodyInstant& instant : instants_of(readings)) {
      filter.step(instant, nullptr, &record);
    }
    MatrixXd F;
    MatrixXd Q;
    testing_support::dense_process(filter, record.predict, F, Q);
    dense.predict(F, Q);
    for (const auto& groups : linearised) {
      MatrixXd H;
      VectorXd nu;
      VectorXd R;
      testing_support::dense_rows(groups, filter.layout().size, H, nu, R);
      dense.update(H, nu, R);
    }
    const MatrixXd P = filter.covariance().dense();
    ASSERT_LT((P - dense.P).norm(), 1e-9 * P.norm()) << k;
    // Biases are corrected by plain sums: the correction shows in them.
    for (std::size_t b = 0; b < drawn.model.boards.size(); ++b) {
      const Vector3d moved = filter.state().gyroscope_bias[b] - before.gyroscope_bias[b];
      ASSERT_LT((moved - dense.x.segment<3>(filter.layout().gyroscope_bias[b])).norm(), 1e-10);
    }
  }
}

// The smoother's own statement of its uncertainty against its errors, which are those it models.
TEST(BodySmoother, StatesItsUncertainty) {
  const BodyFilterParameters p = modelled_errors_only();
  double error = 0.0;
  double stated = 0.0;
  double filters = 0.0;
  for (unsigned seed = 60; seed < 72; ++seed) {
    Drawn drawn(seed, p);
    BodyFilter filter(drawn.model, p);
    drawn.start(filter);
    BodyReadings readings;
    std::vector<std::vector<Eigen::Quaterniond>> truth;
    for (int k = 1; k <= 150; ++k) {
      drawn.move(filter, 0.01);
      drawn.measure(filter, k % 10 == 0, readings);
      truth.push_back(filter.tree().segment_rotations(drawn.truth.joints));
    }
    const auto forward = filter_body(drawn.model, p, readings, 1000.0, {});
    const auto both = smooth_body(drawn.model, p, readings, 1000.0, {});
    ASSERT_TRUE(forward.ok() && both.ok());
    for (std::size_t k = 0; k < truth.size(); ++k) {
      for (std::size_t s = 0; s < truth[k].size(); ++s) {
        error += std::pow(geometry::geodesic_angle(truth[k][s], both->track.R_joint[k][s]), 2);
        stated += std::pow(both->track.sigma[k][s], 2);
        filters += std::pow(forward->track.sigma[k][s], 2);
        ASSERT_GE(both->track.point_sigma[k][s], 0.0F);
      }
    }
  }
  EXPECT_LT(stated, 0.9 * filters);
  EXPECT_NEAR(std::sqrt(stated / error), 1.0, 0.2);
}

TEST(BodyFilter, ResumesFromItsSnapshotBitByBit) {
  const BodyFilterParameters p = modelled_errors_only();
  Drawn drawn(77, p);
  BodyFilter whole(drawn.model, p);
  BodyFilter second(drawn.model, p);
  drawn.start(whole);
  BodyReadings readings;
  for (int k = 1; k <= 60; ++k) {
    drawn.move(whole, 0.01);
    drawn.measure(whole, k % 10 == 0, readings);
  }
  const auto instants = instants_of(readings);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    if (i == instants.size() / 2) {
      second.resume(whole.snapshot());
    }
    whole.step(instants[i], nullptr);
    if (i >= instants.size() / 2) {
      second.step(instants[i], nullptr);
    }
  }
  EXPECT_EQ((whole.covariance().dense() - second.covariance().dense()).norm(), 0.0);
  EXPECT_EQ(whole.tree().difference(whole.state().joints, second.state().joints).norm(), 0.0);
}

TEST(BodyFilter, OutliersAndMissingReadingsDoNotHarm) {
  BodyFilterParameters p = modelled_errors_only();
  p.gate_probability = 1e-6;
  Drawn drawn(5, p);
  BodyFilter filter(drawn.model, p);
  drawn.start(filter);
  for (int k = 1; k <= 300; ++k) {
    drawn.move(filter, 0.01);
    BodyReadings readings;
    drawn.measure(filter, true, readings);
    for (std::size_t i = 0; i < readings.ranges.size(); ++i) {
      if ((i + static_cast<std::size_t>(k)) % 3 == 0) {
        readings.ranges[i].range += 0.3;
      }
    }
    readings.inertial[1].w_S.setConstant(kMissing);
    readings.inertial[2].f_S.x() = INFINITY;
    for (const BodyInstant& instant : instants_of(readings)) {
      filter.step(instant, nullptr);
    }
  }
  const VectorXd e = drawn.error(filter);
  ASSERT_TRUE(e.allFinite());
  EXPECT_LT(e.head(filter.layout().dofs).norm() / std::sqrt(filter.layout().dofs), radians(3.0));
  EXPECT_GT(filter.range_counts()[0].gated, 100);
  EXPECT_GT(filter.accelerometer_counts()[2].not_finite, 250);
}

TEST(ChiSquare, HasTheTablesQuantiles) {
  EXPECT_NEAR(chi_square_limit(1, 0.01), 6.6349, 1e-3);
  EXPECT_NEAR(chi_square_limit(2, 0.05), 5.9915, 1e-3);
  EXPECT_NEAR(chi_square_limit(3, 0.01), 11.3449, 1e-3);
  EXPECT_NEAR(chi_square_limit(3, 1e-4), 21.1075, 1e-3);
}

}  // namespace
}  // namespace limbwave::estimate
