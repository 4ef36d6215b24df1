/// The two ways to find an accelerometer's offset and scale from gravity alone, as pure functions on steady readings.
///
/// Readings x are in nominal g: x = (volts − nominal offset) / nominal volts per g, which keeps every unknown near 0
/// or 1. The model is f/g = A (x − b).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace limbwave::calibrate {

/// A steady reading.
struct RangeObservation {
  double time_s = 0.0;
  Eigen::Vector3d x = Eigen::Vector3d::Zero();  ///< Low-passed, nominal g.
};

struct RangeModel {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();  ///< Dimensionless.
  Eigen::Vector3d b = Eigen::Vector3d::Zero();      ///< Nominal g.
  /// |f|/g − 1 of a reading.
  [[nodiscard]] double residual(const Eigen::Vector3d& x) const { return (A * (x - b)).norm() - 1.0; }
};

struct ExtremesParameters {
  double opening_s = 0.15;    ///< Peaks shorter than this do not count (grey-scale opening).
  double percentile_s = 0.2;  ///< The extreme lies where a value is reached for this long in all.
  double summit_s = 0.25;  ///< Around that place a parabola is fitted, this far to both sides, for its highest value.
  double largest_gap_s = 0.1;  ///< A run of readings ends at a longer gap.
};

/// Line-in paper §4: lowest and highest value per axis, short peaks suppressed, mapped to ±1 g; A is diagonal. What
/// suppresses peaks only finds the place: its value would be too small by 1 % at 45°/s, and for an axis that was held
/// still at one end and passed quickly at the other the offset would be wrong.
/// Observations in order of time, at full rate. Empty when an axis never lasts long enough or spans less than 0.2 g.
std::optional<RangeModel> fit_extremes(std::span<const RangeObservation> observations,
                                       const ExtremesParameters& parameters = {});

/// Result of `fit_ellipsoid`.
struct EllipsoidFit {
  RangeModel model;         ///< A is symmetric.
  double sigma = 0.0;       ///< Robust standard deviation of the residuals, g.
  double offset_sd = 0.0;   ///< Standard error of b, root mean square of its axes, nominal g.
  double gain_after = 1.0;  ///< Gain after `step_s` relative to before; 1 when no step was asked for.
  int iterations = 0;
};

/// A step of the whole chain's gain (a moved volume) to be found along with the ellipsoid.
struct GainStep {
  double time_s = 0.0;                               ///< Readings after it have another gain.
  Eigen::Vector3d zero_x = Eigen::Vector3d::Zero();  ///< Nominal 0 g voltage in nominal g: the gain acts on x + zero_x.
};

/// Minimises Σ w ρ(|A (x − b)| − 1) over b and symmetric A (9 unknowns) by Levenberg-Marquardt from `start`.
/// Gravity's length cannot tell A from Q·A with any rotation Q; the symmetric one is the convention, the sensor frame
/// that turns least from the chip's axes. What rotation remains is part of the mounting R_LS. ρ is Tukey's biweight
/// with the scale of the residuals, which drops what jerks left over. Each direction of the sphere has the same
/// weight, however long it was held. Empty when there are fewer than 20 observations or the solution is degenerate.
std::optional<EllipsoidFit> fit_ellipsoid(std::span<const RangeObservation> observations, const RangeModel& start,
                                          const std::optional<GainStep>& step = {});

/// Partial derivatives of |A y| − 1 with y = x − b by (b, A_xx, A_yy, A_zz, A_xy, A_xz, A_yz), for symmetric A.
Eigen::Matrix<double, 1, 9> J_residual_model(const RangeModel& model, const Eigen::Vector3d& x);

}  // namespace limbwave::calibrate
