/// Believes or refuses ranges that come as bare numbers, without the signal they were found in: radio ranging, logs of
/// other people's sensors. What comes out is what ultrasonic decoding gives: readings with variance, factors, verdict.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/time.h"
#include "decode/range_reading.h"

namespace limbwave::decode {

struct RangeGateParameters {
  double acceleration = 1.5;  ///< White acceleration of the receiver, m/s² √s.
  double offset_sd = 0.3;     ///< Of what all ranges of a pair are off by, metres: delays of antennas and electronics.
  double wander_sd = 0.05;    ///< Of what they are off by for a while, metres: reflections that come and go.
  double wander_s = 2.0;      ///< For how long.
  double noise_sd = 0.03;     ///< First guess of the noise of one range, metres; it is then estimated for every pair.
  double least_noise_sd = 1e-3;  ///< Of that estimate.
  double surprise = 2.5;         ///< Standard deviations up to which a range is fully believed.
  double least_confidence = 0.1;
  /// Where the receiver is, roughly: what sources in one plane do not tell. Metres.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d place_sd = Eigen::Vector3d::Constant(10.0);
};

/// One receiver among sources at known places. An extended Kalman filter of its place and velocity, a constant and a
/// wandering offset for every source; the noise of every pair is estimated from its innovations (Mehra 1970). A range
/// is weighed by its continuity factor, as ranges of sound are (Vlasic et al. 2007, §4.1), and refused below the least
/// confidence. Streaming: the result of a range depends on those before it alone.
class RangeGate {
 public:
  RangeGate(std::vector<Eigen::Vector3d> sources, int receiver, const RangeGateParameters& parameters = {});

  /// The next range; times do not decrease. The reading's range is without the estimated offset, its variance what is
  /// left of offset and noise. `envelope_range` is the range as it came. Not a number, or not above 0: kNothingHeard;
  /// before the receiver's place is known: kAmbiguous.
  RangeReading push(int source, Seconds time, double range);

  [[nodiscard]] bool running() const { return running_; }
  [[nodiscard]] Eigen::Vector3d place() const { return x_.head<3>(); }  ///< Of the receiver.
  [[nodiscard]] double noise_sd(int source) const;                      ///< As estimated, metres.

 private:
  struct Heard {
    int source;
    double time_s, range;
  };
  void advance(double time_s);
  void remind();
  void collect(int source, double time_s, double range);
  void start(double time_s);
  [[nodiscard]] Eigen::Index offset(int source) const { return 6 + source; }
  [[nodiscard]] Eigen::Index wander(int source) const { return 6 + count() + source; }
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(sources_.size()); }

  std::vector<Eigen::Vector3d> sources_;
  int receiver_;
  RangeGateParameters parameters_;
  std::vector<double> noise_;  // variances
  bool running_ = false;
  double time_s_ = 0.0, last_accepted_s_ = 0.0, next_reminder_s_ = 0.0;
  int refused_ = 0;  // in a row
  Eigen::VectorXd x_;
  Eigen::MatrixXd P_;
  std::vector<Heard> heard_;
};

}  // namespace limbwave::decode
