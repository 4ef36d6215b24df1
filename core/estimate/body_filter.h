/// The body filter: an error-state extended Kalman filter in joint space for gyroscopes, accelerometers and ranges
/// (Vlasic et al. 2007, §5), with ball joints on SO(3), sensor errors and mountings among the states.
///
/// Error state: [δθ | δθ̇ | δθ̈ | skin | constants]. θ are the joint degrees of freedom of body::Tree; the constants are
/// gyroscope and accelerometer biases, mounting rotations and places of the boards, range offsets of the sources, the
/// scale of the speed of sound and bone lengths, as far as the parameters give them a standard deviation.
/// Process: θ̈ is a random walk as in the paper's eq. (1), optionally drawn back to zero.
/// Measurements: every instant is predicted to and linearised once; all readings of it are updated with, in any
/// combination of sensors, each gated by χ² (error_covariance.h).
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "base/diagnostics.h"
#include "body/tree_kinematics.h"
#include "estimate/body_model.h"
#include "estimate/error_covariance.h"

namespace limbwave::estimate {

/// How the root is known.
enum class RootMode {
  kGiven,  ///< From a file, as the paper does with an optical system.
  kFixed,  ///< Its joint stays at its place in the skeleton and turns as the skeleton says.
  kFree    ///< Free: gravity gives inclination, place and heading drift with a covariance that says so.
};

/// Standard deviations, SI and radians. 0 for a constant: it is not estimated.
struct BodyFilterParameters {
  RootMode root = RootMode::kFree;
  bool use_gyroscopes = true, use_accelerometers = true, use_ranges = true;

  // Readings. White noise, then what scales with the reading, both of the default rig (signals.md §4).
  double gyroscope_noise = 0.002;        ///< rad/s (Vlasic et al. 2007, §5.2).
  double gyroscope_relative = 0.02;      ///< Scale, and skin that does not turn with the bone.
  double accelerometer_noise = 0.02;     ///< m/s² (§5.2).
  double accelerometer_relative = 0.05;  ///< Scale, cross-axis; skin that shifts in step with the motion.
  double range_noise = 0.0025;           ///< m (§5.2), divided by the confidence.
  double range_model = 0.0043;           ///< m: skin that slides under boards and sources.
  double reading_delay_s = 0.0;          ///< By which inertial readings are late, s; poses are carried forward by it.

  // Process: growth of θ̈ per √s, rad/s² (root translation: m/s²), and the time in which it forgets, s (0: never).
  double acceleration_walk = 200.0;
  double root_acceleration_walk = 50.0;
  double acceleration_time = 0.1;

  // Constants: prior and random walk per √s.
  double gyroscope_bias = 0.002, gyroscope_bias_walk = 1e-4;
  double accelerometer_bias = 0.15, accelerometer_bias_walk = 1e-3;  ///< With what scale and cross-axis make of g.
  double mount_rotation = 0.05, mount_rotation_walk = 0.0;
  double mount_place = 0.006, mount_place_walk = 0.0;
  double source_place = 0.006;
  double tissue_angle = 0.0185;  ///< σ of a board's rotation on skin that slides, rad per axis (0: it does not).
  double tissue_turn = 1.0;      ///< While its segment turns by this, that rotation becomes another, rad.
  double range_offset = 0.0, range_offset_walk = 1e-5;
  double sound_scale = 0.005, sound_scale_walk = 1e-6;
  double bone_scale = 0.02;

  // Start: around the rest pose.
  double rest_pose = 0.07;  ///< Of each joint's rotation, all its degrees of freedom together.
  double start_rate = 0.3;  ///< rad/s.
  double start_acceleration = 5.0;

  // The root.
  double given_rotation = 0.002, given_place = 0.002;  ///< Of a root that is given.
  double root_speed = 2.0;  ///< A free root's usual speed, m/s: what keeps inclination from drifting with it.
  double root_reach = 0.0;  ///< How far a free root strays, m; 0: anywhere.

  double gate_probability = 1e-6;  ///< Of rejecting a good reading.
  double limit_softness = 0.3;     ///< Of joint limits, rad; 0: not used.
};

/// Why a reading was not used.
enum class Rejection { kNone, kGate, kClipped, kNotFinite, kBehindSource, kUnknown };

/// Per board and kind, or per source.
struct ReadingCount {
  std::int64_t used = 0, gated = 0, clipped = 0, not_finite = 0;
  double nis_sum = 0.0;  ///< Of all that were compared, gated ones included, per scalar.
};

/// Where the constants are in the error state; -1: not estimated.
struct BodyLayout {
  int dofs = 0, size = 0;
  int moving = 0;  ///< So many states in front move on of themselves: joints and skin. The others are constants.
  std::vector<int> gyroscope_bias, accelerometer_bias, mount_rotation, mount_place;  ///< First of three, per board.
  std::vector<int> tissue_angle, tissue_gain;                                        ///< The same.
  std::vector<int> source_place;                                                     ///< First of three, per source.
  std::vector<int> range_offset;                                                     ///< Per source.
  std::vector<int> bone_scale;                                                       ///< Per segment.
  int sound_scale = -1;
};

/// Everything that is estimated.
struct BodyState {
  double time_s = 0.0;
  body::TreeState joints;
  std::vector<Vector3d> gyroscope_bias, accelerometer_bias, mount_place, source_place;
  /// Rotation of a board on its skin, rad, and how it grows with the angle by which the segment turns; sensor frame.
  std::vector<Vector3d> tissue_angle, tissue_gain;
  std::vector<Quaterniond> mount_rotation;  ///< R_LS = nominal · this · exp(tissue_angle).
  std::vector<double> range_offset, bone_scale;
  double sound_scale = 0.0;
};

/// Transition of a prediction, for the smoother.
struct PredictRecord {
  double dt = 0.0;
  double va = 0.0, aa = 1.0;  ///< θ̇ += va θ̈, θ̈ *= aa.
  struct Ball {
    int first;
    std::array<double, 9> A, B, C;  ///< Row-major.
  };
  std::vector<Ball> balls;
  double c = 0.0;  ///< Of all others: θ += dt θ̇ + c θ̈.
  struct Tissue {
    int angle, gain;                             ///< First of three.
    double a, b;                                 ///< angle = a angle + b gain, gain *= a.
    double angle_noise, both_noise, gain_noise;  ///< Variances and covariance that are added, the same on all axes.
  };
  std::vector<Tissue> tissues;
};

/// What a step did, in order: the prediction, then updates.
struct StepRecord {
  bool forgets = false;  ///< Velocities and accelerations were forgotten before the prediction (body_step_hook.h).
  PredictRecord predict;
  std::vector<UpdateRecord> updates;
  /// Wanted by whoever sets it: what was measured, as it was linearised, a list per update.
  std::vector<std::vector<MeasurementGroup>>* linearised = nullptr;
};

class BodyFilter {
 public:
  BodyFilter(BodyModel model, const BodyFilterParameters& parameters);
  BodyFilter(const BodyFilter& other) = delete;
  BodyFilter& operator=(const BodyFilter& other) = delete;

  [[nodiscard]] const BodyModel& model() const { return model_; }
  [[nodiscard]] const BodyFilterParameters& parameters() const { return parameters_; }
  [[nodiscard]] const body::Tree& tree() const { return tree_; }
  [[nodiscard]] const BodyLayout& layout() const { return layout_; }
  [[nodiscard]] const BodyState& state() const { return state_; }
  [[nodiscard]] const ErrorCovariance& covariance() const { return P_; }
  [[nodiscard]] const std::vector<ReadingCount>& gyroscope_counts() const { return gyroscope_counts_; }
  [[nodiscard]] const std::vector<ReadingCount>& accelerometer_counts() const { return accelerometer_counts_; }
  [[nodiscard]] const std::vector<ReadingCount>& range_counts() const { return range_counts_; }
  [[nodiscard]] double log_likelihood() const { return log_likelihood_; }

  /// State and covariance, to be resumed from; a copy of the filter's mind.
  struct Snapshot {
    BodyState state;
    std::vector<double> P;  ///< Lower triangle, row by row.
    double next_prior_s = 0.0;
  };
  [[nodiscard]] Snapshot snapshot() const;
  void resume(const Snapshot& snapshot);

  /// Starts at rest at `time_s`, with a given root where there is one.
  void start(double time_s, const RootReading* root);
  /// Predicts to the instant and takes its readings in; `root` where it is given. What is measured is linearised about
  /// the prediction, or about a state that is known better (of an iterated smoother, say).
  void step(const BodyInstant& instant, const RootReading* root, StepRecord* record = nullptr,
            const BodyState* about = nullptr);
  /// Σ ν²/σ² of all readings at the states that steps were linearised about.
  [[nodiscard]] double cost() const { return cost_; }
  /// One update by groups made elsewhere; innovations relative to the state as it is.
  void update(std::vector<MeasurementGroup>& groups, std::vector<UpdateRecord>* records = nullptr);
  void set_state(const BodyState& state) { state_ = state; }
  ErrorCovariance& mutable_covariance() { return P_; }

  /// Applies an error state to a state: what `update` does at its end, and the smoother.
  void inject(BodyState& state, const Eigen::VectorXd& x) const;
  /// The error state that turns one state into the other: `inject` backward.
  [[nodiscard]] Eigen::VectorXd difference(const BodyState& from, const BodyState& to) const;

 private:
  void predict(double dt, PredictRecord* record);
  void predict_tissue(double dt);
  void predict_covariance(const PredictRecord& step);
  void move_rows(const PredictRecord& step, long columns);
  void add_process_noise(const PredictRecord& step);
  [[nodiscard]] double tissue_gain_sigma() const;
  void add_inertial(const InertialReading& reading);
  void add_range(const RangeReading& reading);
  void add_root(const RootReading& reading);
  void add_priors();
  void add_limits();
  MeasurementGroup& group(int rows, int tag);
  void flush(StepRecord* record);
  void flush_full(StepRecord* record);
  UpdateRecord& add_record(std::vector<UpdateRecord>& records);
  void count(const MeasurementGroup& group);
  [[nodiscard]] std::vector<double> place_scale() const;

  BodyModel model_;
  BodyFilterParameters parameters_;
  body::Tree tree_;
  BodyLayout layout_;
  body::TreeKinematics kinematics_;
  std::vector<std::vector<int>> bone_links_;  // per link: links on its chain whose place a bone scale moves
  BodyState state_;
  ErrorCovariance P_;
  std::vector<PredictRecord::Tissue> tissue_steps_;
  std::vector<MeasurementGroup> groups_;
  std::size_t used_groups_ = 0;
  int pending_rows_ = 0;
  Eigen::VectorXd correction_;
  bool corrected_ = false;  // there has been an update at this instant
  std::vector<UpdateRecord> spare_records_;
  body::PointJacobians jacobians_, source_jacobians_;
  std::vector<ReadingCount> gyroscope_counts_, accelerometer_counts_, range_counts_;
  double gates_[4] = {0, 0, 0, 0};  // by number of rows
  double next_prior_s_ = 0.0;
  double log_likelihood_ = 0.0;
  double cost_ = 0.0;
};

/// χ² with `freedom` degrees of freedom (1 to 3) that is exceeded with the given probability.
double chi_square_limit(int freedom, double probability);

}  // namespace limbwave::estimate
