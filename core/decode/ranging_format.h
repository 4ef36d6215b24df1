/// What ranging needs to know about a driver box and who wears it, for one wire.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace limbwave::decode {

struct RangingSource {
  Eigen::Vector3d position =
      Eigen::Vector3d::Zero();  ///< At rest, in the frame of the segment that most sources sit on.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< Likewise, unit length.
  bool fixed = true;                                  ///< Sits on that segment itself; the others move against it.
  double delay_s = 0.0;                               ///< It starts later than its slot by this.
  double phase = 0.0,
         phase_2 = 0.0;   ///< Phase at u = angle off the normal / 60 degrees: phase u² + phase_2 u³, radians.
  double level = 1.0;     ///< Amplitude relative to `level_m`.
  double wander = 3e-3;   ///< How uncertain its place becomes where its segment turns against the others: metres per
                          ///< radian, √s.
  double reach = 10.0;    ///< No limb takes this wire's microphone further away, metres.
  double foremost = 0.0;  ///< Nor nearer to the source's normal, radians.
};

struct RangingFormat {
  int slot_samples = 1120;
  double pulse_hz = 40000.0;
  int pulse_cycles = 10;
  double transducer_q = 20.0;
  double microphone_bandwidth_hz = 12000.0;
  double level_m = 0.08;  ///< Amplitude of a source on its axis times distance, fraction of full scale.
  double absorption_db_m = 1.3;
  std::vector<double> radiation;  ///< Relative amplitude at 0, 10, ... 180 degrees off a normal.
  double speed_of_sound = 344.6;  ///< m/s.
  std::vector<RangingSource> sources;
  Eigen::Vector3d receiver = Eigen::Vector3d::Zero();  ///< This wire's microphone, at rest, in the same frame.
};

/// How arrivals become ranges.
enum class RangingMethod {
  kPaper,     ///< Steepest point of the first rising power envelope (Vlasic et al. 2007, §4.1).
  kEnvelope,  ///< Envelope matched filter.
  kCarrier,   ///< Carrier phase, with whole cycles resolved.
};

struct RangingParameters {
  RangingMethod method = RangingMethod::kCarrier;
  double detection = 16.0;     ///< Energy of an arrival over the noise's after the matched filter.
  double phase_sd = 0.15e-3;   ///< What calibration leaves of the sources' phases, metres.
  double finest = 0.55e-3;     ///< A carrier whose phase is known worse than this is none, metres.
  double placement_sd = 6e-3;  ///< How far sources and boards sit from where the rig says, metres.
  double jerk = 40.0;          ///< White jerk of a limb whose words are not heard, m/s³ √s.
  double failure = 5e-4;       ///< Probability of another whole number of cycles up to which one is accepted.
  /// The same of past and future together, where each is less sure, but both tell the same number: the product of
  /// both failures, which are not quite independent of each other.
  double joint_failure = 3e-4;
  double caution = 1.3;           ///< Of the envelope's variance: echoes that overlap, shapes that are not quite so.
  double stray = 0.01;            ///< Probability that an expectation is far worse than it thinks,
  double stray_m = 8e-3;          ///< and by how much then, metres.
  double least_confidence = 0.1;  ///< Of an accepted range.
  double look_ahead_s = 1.0;      ///< A pulse is judged by what comes up to this later, too; 0: at once.
};

}  // namespace limbwave::decode
