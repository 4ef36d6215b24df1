/// The filter behind Smoothing::kBridging: how a limb is inclined, turns and accelerates, from specific force alone.
///
/// Model, in a frame N that has its z axis up and does not spin about it relative to the limb (heading is unknown to
/// an accelerometer and does not matter here): R_NL turns with the angular velocity w = (w_x, w_y, 0),
///   f_N = R_NL f_L = g z + a + noise,
///   dw/dt = −w/τ + white angular acceleration,
///   dy/dt = a,  da/dt = −ω0² y − 2ζω0 a + white,
/// so that the limb's acceleration a is the derivative of a bounded velocity y: it averages out, which gravity does
/// not. The strength of a is told by | |f| − g | around each reading; where it is nil the filter follows the readings.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "estimate/inclination.h"

namespace limbwave::estimate {

class InclinationFilter {
 public:
  static constexpr int kStates = 10;  ///< Error state: turning about N's x, y; w (2); y (3); a (3).
  using Vector = Eigen::Matrix<double, kStates, 1>;
  using Matrix = Eigen::Matrix<double, kStates, kStates>;

  struct State {
    Quaterniond R_NL = Quaterniond::Identity();
    Eigen::Vector2d w = Eigen::Vector2d::Zero();  ///< rad/s
    Vector3d y = Vector3d::Zero();                ///< m/s
    Vector3d a = Vector3d::Zero();                ///< m/s²
    Matrix P = Matrix::Zero();
  };

  /// What smoothing needs of one step.
  struct Record {
    State predicted, updated;
    Matrix F = Matrix::Zero();  ///< From the previous updated error to this predicted one.
    bool connected = false;     ///< False where the filter started anew.
  };

  explicit InclinationFilter(const InclinationParameters& parameters) : parameters_(parameters) {}

  /// One sample. `acceleration_sd` and `noise` in m/s² per axis, for this sample.
  void step(const ForceSample& sample, double acceleration_sd, double noise);

  [[nodiscard]] bool started() const { return started_; }
  [[nodiscard]] const Record& record() const { return record_; }

  /// Rauch-Tung-Striebel pass over records in order of time: the smoothed states.
  static std::vector<State> smooth(const std::vector<Record>& records);

  static Vector3d up_L(const State& state) { return state.R_NL.conjugate() * Vector3d::UnitZ(); }
  /// Standard deviation of the direction per axis, radians.
  static double direction_sd(const State& state);

 private:
  void start(const ForceSample& sample, double acceleration_sd, double noise);
  void predict(double dt, double acceleration_sd);
  void update(const ForceSample& sample, double acceleration_sd, double noise);

  InclinationParameters parameters_;
  bool started_ = false;
  double time_s_ = 0.0;
  State state_;
  Record record_;
};

}  // namespace limbwave::estimate
