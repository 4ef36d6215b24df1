/// Where one microphone is among the sources, from all ranges to it: what resolves whole cycles of the carrier, and
/// tells a first arrival from an echo.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "decode/ranging_format.h"

namespace limbwave::decode {

/// State: position, velocity and acceleration of the microphone in the frame of the segment that most sources sit on;
/// and for every source how far its range is off that geometry (placement; movement of its own segment), with a rate.
/// An extended Kalman filter, one range at a time.
class RangeTracker {
 public:
  RangeTracker(const RangingFormat& format, const RangingParameters& parameters);

  /// Moves the state to a time, seconds; times do not decrease.
  void advance(double time_s);

  struct Expectation {
    double range = 0.0;     ///< Metres.
    double variance = 0.0;  ///< m².
    double angle = 0.0;     ///< Off the source's normal, radians.
    double angle_sd = 0.0;
  };
  /// Empty before the first ranges.
  [[nodiscard]] std::optional<Expectation> expect(int source) const;

  /// Takes a range with its variance.
  void update(int source, double range, double variance);
  /// A range that contradicts everything: after several, the state is found anew.
  void contradict();
  /// The envelope of accepted ranges is off on average: their whole cycles were wrong.
  void doubt(int source);

  /// Collects ranges until a first state can be found from them.
  void collect(int source, double time_s, double range, double variance);

 private:
  static constexpr int kSources = 8;  // at most; further ones are not tracked
  static constexpr int kStates = 9 + 2 * kSources;
  using State = Eigen::Matrix<double, kStates, 1>;
  using Covariance = Eigen::Matrix<double, kStates, kStates>;
  struct Heard {
    int source;
    double time_s, range, variance;
  };
  /// Takes one state for about a value, weakly.
  void remind(int state, double value, double sd);
  void start(double time_s);
  [[nodiscard]] bool solve(const Eigen::Vector3d& guess, Eigen::Vector3d& p, Eigen::Matrix3d& P, double& cost) const;

  const RangingFormat& format_;
  RangingParameters parameters_;
  int sources_;
  bool running_ = false;
  double time_s_ = 0.0;
  double last_update_s_ = 0.0, next_reminder_s_ = 0.0;
  int contradictions_ = 0;
  State x_;
  Covariance P_;
  std::vector<Heard> heard_;
};

}  // namespace limbwave::decode
