/// The adjoint of the body filter, run backward (Bryson and Frazier), and what it says about the smoother's covariance.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

#include "estimate/body_filter.h"

namespace limbwave::estimate {

/// λ before a step from λ behind it; the smoothed state is x ⊟ P λ.
void adjoint_over_step(const StepRecord& step, const body::Tree& tree, Eigen::VectorXd& lambda);

/// λ of the readings beside λ of readings drawn at random. Were the innovations the white noise that the filter takes
/// them for, Cov λ = Λ, and the smoother's covariance is P − P Λ P. Λ itself would cost more than the filter; a few
/// dozen adjoints driven by random signs have exactly Λ as their covariance, at a twentieth of the cost.
class SampledAdjoint {
 public:
  static constexpr int kSamples = 31;
  static constexpr int kWidth = 1 + kSamples;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, kWidth, Eigen::RowMajor>;

  explicit SampledAdjoint(int size);
  void over_step(const StepRecord& step, const body::Tree& tree);
  [[nodiscard]] Eigen::VectorXd lambda() const;
  /// P_θ λ for all: degrees of freedom × kWidth, those of the readings first. `P_theta`: the rows of P that belong to
  /// the joints.
  [[nodiscard]] Rows changes(const AlignedRows& P_theta) const;

 private:
  void over_update(const UpdateRecord& update);

  int size_;
  AlignedRows lambdas_, product_;
  std::mt19937_64 random_;  // from a fixed seed: the same take gives the same result
};

/// How sure a pose is.
struct PoseSigma {
  std::vector<float> joints;  ///< Per segment: of its joint's rotation, all axes together, rad.
  std::vector<float> points;  ///< Per segment: of its far end's place in the world, all axes together, m.
  Eigen::Vector3d root = Eigen::Vector3d::Zero();  ///< Of the root's place, m.
};

/// From the covariance of the degrees of freedom, `changes` (SampledAdjoint; empty: none) taken off.
PoseSigma pose_sigma(const body::Tree& tree, const body::Skeleton& skeleton, const body::TreeState& state,
                     const Eigen::MatrixXd& P_theta, const Eigen::MatrixXd& changes);

}  // namespace limbwave::estimate
