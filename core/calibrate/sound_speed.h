/// The speed of sound from ranges whose true lengths are known: between sources and microphones on one rigid segment.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/rig.h"
#include "decode/range_reading.h"
#include "decode/ranging.h"

namespace limbwave::calibrate {

/// A source and a microphone that keep their distance whatever the wearer does.
struct RigidPair {
  int source = 0, receiver = 0;
  double length = 0.0;  ///< Metres, by the rig.
  double angle = 0.0;   ///< Of the microphone off the source's normal, radians.
};

/// Pairs on one segment, or on segments with nothing but fixed joints between them.
std::vector<RigidPair> rigid_pairs(const body::Rig& rig, const body::Skeleton& skeleton);

/// What a decoder may be told about one microphone's pairs: length and direction (decode::RangingDecoder).
decode::RangingDecoder::Predict rigid_prediction(const std::vector<RigidPair>& pairs, int receiver);

struct SoundSpeedSettings {
  double length_sd = 1e-3;    ///< How well the rig knows a pair's length, metres.
  double system_sd = 0.3e-3;  ///< What every range of a pair may be off by, metres: phase of a source off its axis.
  int least_readings = 20;    ///< Of a pair that counts.
  double least_snr_db = 6.0;  ///< Of a reading. Sources radiate little to the side, where such pairs are.
};

struct SoundSpeed {
  double speed = 0.0;         ///< m/s.
  double sd = 0.0;            ///< Of that; grows when pairs disagree by more than their lengths may be wrong.
  int pairs = 0;              ///< That it is from.
  std::vector<int> left_out;  ///< Indices of pairs that contradict the others.
  /// A line for people: the number, its uncertainty, from what.
  [[nodiscard]] std::string text() const;
};

/// Takes readings as they come: their carrier's phase, whose whole cycles the pair's length tells, so that readings
/// count that are too weak for anything else. c = Σ w L t / Σ w t² over the pairs' median times of flight t and lengths
/// L; pairs that contradict the others (a cover over a source, a rig that says it wrong) are left out one at a time.
class SoundSpeedEstimator {
 public:
  /// `pulse_hz` is the carrier.
  SoundSpeedEstimator(std::vector<RigidPair> pairs, double pulse_hz, const SoundSpeedSettings& settings = {});

  /// `assumed` is the speed of sound with which the reading's range was computed. The decoder knew the pair's direction
  /// (`rigid_prediction`).
  void add(const decode::RangeReading& reading, double assumed);
  /// Fails with fewer than two pairs that have been heard often enough.
  [[nodiscard]] Result<SoundSpeed> estimate() const;

 private:
  struct Times {
    std::vector<float> seconds;  // every `stride`-th
    std::size_t stride = 1, seen = 0;
  };
  std::vector<RigidPair> pairs_;
  double pulse_hz_;
  SoundSpeedSettings settings_;
  std::map<std::pair<int, int>, std::size_t> index_;
  std::vector<Times> times_;
};

}  // namespace limbwave::calibrate
