/// What the chain-aware smoother knows: how limbs, sensors and joints go together, as residuals with their Jacobians.
///
/// The unknowns of every instant k are the orientation R_WL of every link and the position q of every root joint. All
/// residuals are written in W. With D the second difference over the instants k−1, k, k+1 and M their weighted mean
/// (1/12, 10/12, 1/12) (Numerov), a sensor at x_S = q + Σ R_j p_j + R_L p_LS feels
///   M(R_WL f_L) = g z + D(x_S) + noise,
/// exactly to the fourth order in the step: a limb's own tangential and centripetal acceleration is signal here.
/// Orientations turn by small vectors in W from the left: R → exp(δ) R.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "estimate/block_band.h"
#include "estimate/inclination.h"
#include "estimate/limb_chain.h"

namespace limbwave::estimate {

/// The unknowns at all instants; [link][instant] and [root][instant].
struct ChainState {
  std::vector<std::vector<Quaterniond>> R_WL;
  std::vector<std::vector<Vector3d>> q_W;  ///< Metres, from anywhere.
};

/// What is assumed, per link and instant.
struct ChainWeights {
  std::vector<std::vector<double>> force_sd;    ///< Of a reading, per axis, m/s².
  std::vector<std::vector<double>> turning_sd;  ///< Of angular acceleration, per axis, rad/s².
  std::vector<std::vector<double>> rate_sd;     ///< Of angular velocity, per axis, rad/s.
  std::vector<std::vector<double>> root_sd;     ///< Of a root's acceleration, per axis, m/s²; [root][instant].
};

struct ChainPriors {
  double turning_memory_s = 0.08;       ///< How long an angular acceleration goes on.
  double turning_rate_memory_s = 0.5;   ///< How long an angular velocity goes on.
  double root_memory_s = 0.10;          ///< How long a root's acceleration goes on.
  double root_velocity_s = 0.35;        ///< A root's velocity by its acceleration: it sways and does not fly away.
  double root_velocity_memory_s = 0.5;  ///< How long a root's velocity goes on.
  /// How far a joint may be off its axes and beyond its limits, radians. Weak: limbs' frames are calibrated by hand,
  /// and a joint that is taken at its word leads to headings from which there is no way back.
  double joint_sd = 2.0;
  double joint_middle = 0.7;    ///< Standard deviation from the middle of a joint's limits, in half-ranges.
  double joint_memory_s = 1.0;  ///< For how long what is known of a joint is one and the same thing.
};

class ChainModel {
 public:
  static constexpr std::size_t kReach = 3;  ///< Instants that one residual ties together, less one.

  /// `times` strictly increasing, at least four; `samples` [link][instant].
  ChainModel(const LimbChain& chain, std::vector<double> times, std::vector<std::vector<ForceSample>> samples,
             const ChainPriors& priors);

  [[nodiscard]] std::size_t instants() const { return times_.size(); }
  [[nodiscard]] Eigen::Index block_size() const { return size_; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const LimbChain& chain() const { return chain_; }
  [[nodiscard]] const std::vector<std::vector<ForceSample>>& samples() const { return samples_; }

  /// Half the sum of squared weighted residuals, robust for the readings (Student's t).
  [[nodiscard]] double cost(const ChainState& state, const ChainWeights& weights) const;
  /// Its parts: what every instant adds.
  [[nodiscard]] std::vector<double> costs(const ChainState& state, const ChainWeights& weights) const;
  /// Gauss-Newton equations for a step from `state`: `system` is overwritten. Returns the cost.
  double linearise(const ChainState& state, const ChainWeights& weights, BlockBand& system) const;
  /// `state` moved by a solution of the equations.
  [[nodiscard]] ChainState moved(const ChainState& state, const std::vector<Eigen::VectorXd>& step) const;

  /// Residual of one reading, m/s², W; false where it or a neighbour is unusable.
  bool force_residual(const ChainState& state, std::size_t link, std::size_t instant, Vector3d& residual) const;
  /// Angular acceleration of a link at an inner instant, rad/s², W; angular velocity after it, rad/s.
  [[nodiscard]] Vector3d turning(const ChainState& state, std::size_t link, std::size_t instant) const;
  [[nodiscard]] Vector3d rate(const ChainState& state, std::size_t link, std::size_t instant) const;
  [[nodiscard]] Vector3d root_acceleration(const ChainState& state, std::size_t root, std::size_t instant) const;

  /// Degrees of freedom of Student's t for the readings.
  static constexpr double kStudent = 4.0;

 private:
  template <typename Sink>
  void visit(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const;
  template <typename Sink>
  void visit_forces(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const;
  template <typename Sink>
  void visit_turning(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const;
  template <typename Sink>
  void visit_root(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const;
  template <typename Sink>
  void visit_joints(const ChainState& state, std::size_t k, Sink& sink) const;

  LimbChain chain_;
  std::vector<double> times_;
  std::vector<std::vector<ForceSample>> samples_;
  ChainPriors priors_;
  Eigen::Index size_;
  double step_s_;                              // usual distance of instants
  std::vector<std::vector<int>> path_;         // link: itself, parent, ...
  std::vector<int> root_of_;                   // link: number of its root
  std::vector<std::array<double, 3>> second_;  // weights of the second difference, per instant
};

}  // namespace limbwave::estimate
