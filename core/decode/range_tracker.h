/// Where one microphone is among the sources, from all ranges to it and what its own board feels: what resolves whole
/// cycles of the carrier, and tells a first arrival from an echo.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "decode/inertial_trace.h"
#include "decode/ranging_format.h"
#include "decode/source_motion.h"

namespace limbwave::decode {

/// One slot as a microphone's tracker needs it.
struct TrackerStep {
  SourceStep source;
  BoardStep board;  ///< The microphone's own.
};

/// Error-state Kalman filter of inertial navigation relative to the sources, aided by ranges. State, in the frame C of
/// one segment with sources (origin at its board, axes turning with it):
///   p  microphone, metres
///   v  its velocity, less that of the frame's origin, not less what the frame's turning adds, m/s
///   e  what is wrong with the acceleration that the two boards tell, m/s²; without words the acceleration itself
///   θ  what is wrong with the board's orientation R_CS, radians
///   s  by source, how far it sits from where SourceMotion takes it for, metres
///   n  by source, by how much whole cycles are wrong that are counted on, but whose number is not known yet, metres
/// A board and its microphone are one piece, so that skin which slides under them is felt and does no harm.
class RangeTracker {
 public:
  /// `R_CS_rest`: the board's axes to C at rest.
  RangeTracker(const RangingFormat& format, const RangingParameters& parameters,
               const Eigen::Quaterniond& R_CS_rest = Eigen::Quaterniond::Identity(),
               const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

  /// Moves the state to the next slot's time.
  void advance(const TrackerStep& step);
  /// Moves the state from the time of `later` back to the slot before it.
  void retreat(const TrackerStep& later);
  /// What the board does at the slot that the state has been moved back to.
  void sit(const BoardStep& board) { board_ = board; }
  /// For a run backward: as uncertain as somebody who knows where this ended, not how it came there.
  void turn_round();

  struct Expectation {
    double range = 0.0;     ///< Metres.
    double variance = 0.0;  ///< m².
    double rate = 0.0;      ///< m/s.
    double angle = 0.0;     ///< Off the source's normal, radians.
    double angle_sd = 0.0;
    /// Of range, its rate, and its acceleration (m, m/s, m/s²).
    Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
  };
  /// Empty before the first ranges. `step`: the slot that the state is at.
  [[nodiscard]] std::optional<Expectation> expect(int source, const SourceStep& step) const;

  /// Takes a range with its variance; `floating`: its whole cycles are wrong by n.
  void update(int source, const SourceStep& step, double range, double variance, bool floating = false);
  /// Begins to count cycles anew: nothing is known of n.
  void set_floating(int source);
  /// n has become known to be `value`; from then on it is none.
  void fix(int source, double value);
  /// What updates have changed since the last call, as a source at `place` sees it: range, rate, acceleration.
  struct Correction {
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero(), a = Eigen::Vector3d::Zero();
    std::array<Eigen::Vector3d, 8> sources;
  };
  [[nodiscard]] bool corrected() const { return corrected_; }
  [[nodiscard]] Eigen::Vector3d correction_of(int source, const Eigen::Vector3d& place) const;
  void forget_corrections();
  /// For what is dead-reckoned along with this: the integral of jerk² by time until now, and what errors of the
  /// acceleration remember.
  [[nodiscard]] double jerk_sum() const { return jerk_sum_; }
  /// The same of how far a source wanders, m².
  [[nodiscard]] double wander_sum(int source) const { return wander_sums_[static_cast<std::size_t>(source)]; }
  static double memory_s();
  static double velocity_walk();

  /// A range that contradicts everything: after several, the state is found anew.
  void contradict();
  /// Accepted whole cycles were wrong.
  void doubt();
  /// Collects ranges until a first state can be found from them.
  void collect(int source, const SourceStep& step, double range, double variance);

 private:
  static constexpr int kSources = 8;  // at most; further ones are not tracked
  static constexpr int kMoving = 12;
  static constexpr int kFloat = kMoving + 3 * kSources;
  static constexpr int kStates = kFloat + kSources;
  static constexpr double kErrorSd = 0.12;  // m/s², of e
  using State = Eigen::Matrix<double, kStates, 1>;
  using Covariance = Eigen::Matrix<double, kStates, kStates>;
  struct Heard {
    int source;
    double time_s, range, variance;
    Eigen::Vector3d place;
  };
  struct Sight {
    Eigen::Vector3d u;
    double distance, delay_s;
  };
  [[nodiscard]] Sight sight(int source, const SourceStep& step) const;
  void feel(const TrackerStep& step);
  void propagate(double dt, const TrackerStep& step);
  void orient(const TrackerStep& step);
  [[nodiscard]] double loose_jerk(const TrackerStep& step) const;
  void remind(int state, double value, double sd);
  void bound(const TrackerStep& step);
  void corrected_by(const State& before);
  void inject();  ///< The orientation's error into the orientation.
  void start(const SourceStep& step);
  [[nodiscard]] bool solve(const Eigen::Vector3d& guess, Eigen::Vector3d& p, Eigen::Matrix3d& P, double& cost) const;

  RangingFormat format_;
  RangingParameters parameters_;
  Eigen::Vector3d receiver_, origin_;
  Eigen::Quaterniond R_CS_rest_, R_CS_;
  Eigen::Vector3d f_mean_ = Eigen::Vector3d::Zero(), f_mean_C_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d a_ = Eigen::Vector3d::Zero(), f_C_ = Eigen::Vector3d::Zero();  // relative, and of the board, in C
  int sources_;
  bool oriented_ = false, aided_ = false, running_ = false, known_sources_ = false;
  double time_s_ = 0.0, last_update_s_ = 0.0, next_reminder_s_ = 0.0, next_source_reminder_s_ = 0.0;
  int contradictions_ = 0;
  BoardStep board_;  // at the present slot
  State x_;
  Covariance P_;
  Correction correction_;
  bool corrected_ = false;
  double jerk_sum_ = 0.0;
  std::vector<double> wander_sums_;
  std::vector<Heard> heard_;
};

}  // namespace limbwave::decode
