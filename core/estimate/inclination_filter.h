/// The filter behind Smoothing::kBridging: how a limb is inclined, turns and accelerates, from specific force alone.
///
/// Model, in a frame N that has its z axis up and does not spin about it relative to the limb (heading is unknown to
/// an accelerometer and does not matter here): R_NL turns with an angular velocity across the vertical,
///   f_N = R_NL f_L = g z + a + noise,
///   dw/dt = −w/τ + white angular acceleration,
///   dy/dt = a,  da/dt = −ω0² y − 2ζω0 a + b,  db/dt = −ω1 b + white,
/// so that the limb's acceleration a is smooth and the derivative of a bounded velocity y: it averages out, which
/// gravity does not. The strength of a is told by | |f| − g | around each reading; where it is nil the filter follows
/// the readings.
///
/// Only what is across the vertical is estimated. A tilt t = (t_x, t_y) of N turns the reading by as much towards x
/// and y, so both axes obey the same scalar equations and share one 5×5 covariance.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "estimate/inclination.h"

namespace limbwave::estimate {

/// How limb acceleration goes on over one step; the same for all filters of a bank.
struct AccelerationStep {
  double dt = 0.0;
  Eigen::Matrix3d transition = Eigen::Matrix3d::Identity();  ///< Of (y, a, b).
  Eigen::Matrix3d driven = Eigen::Matrix3d::Zero();          ///< Covariance that comes in, for a of unit variance.
};
AccelerationStep acceleration_step(double dt);

class InclinationFilter {
 public:
  static constexpr int kStates = 5;  ///< Tilt, its rate, y, a, b.
  using Matrix = Eigen::Matrix<double, kStates, kStates>;
  using Axes = Eigen::Matrix<double, kStates, 2>;  ///< One column per horizontal axis of N.

  struct State {
    Quaterniond R_NL = Quaterniond::Identity();
    Axes x = Axes::Zero();  ///< The first row is in R_NL and stays 0.
    Matrix P = Matrix::Zero();
  };

  /// What smoothing needs of one step.
  struct Record {
    State predicted, updated;
    Matrix F = Matrix::Zero();  ///< From the previous updated error to this predicted one.
    bool connected = false;     ///< False where the filter started anew.
  };

  /// `lever`: how limb acceleration goes with angular acceleration, metres (acceleration = lever · angular).
  InclinationFilter(const InclinationParameters& parameters, double lever) : parameters_(parameters), lever_(lever) {}

  /// One sample. `acceleration_sd` and `noise` in m/s² per axis; `step` from the sample before.
  void step(const ForceSample& sample, const AccelerationStep& step, double acceleration_sd, double noise);

  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] const Record& record() const { return record_; }
  /// Logarithm of how likely the newest sample was, given those before it; Student's t, so that a knock decides
  /// nothing. 0 where nothing was predicted.
  [[nodiscard]] double log_likelihood() const { return log_likelihood_; }

  /// Rauch-Tung-Striebel pass over records in order of time: the smoothed states.
  static std::vector<State> smooth(const std::vector<Record>& records);

  static Vector3d up_L(const State& state) { return state.R_NL.conjugate() * Vector3d::UnitZ(); }
  /// Standard deviation of the direction per axis, radians.
  static double direction_sd(const State& state);

 private:
  void start(const ForceSample& sample, double acceleration_sd, double noise);
  void predict(const AccelerationStep& step, double acceleration_sd);
  void update(const ForceSample& sample, double acceleration_sd, double noise);

  InclinationParameters parameters_;
  double lever_;
  bool started_ = false;
  double log_likelihood_ = 0.0;
  State state_;
  Record record_;
};

}  // namespace limbwave::estimate
