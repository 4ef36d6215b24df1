/// Who wears the sensors and what they do in a take: calibration, then the motion; and what every sensor then feels.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/rig.h"
#include "body/skeleton.h"
#include "simulate/motions.h"
#include "simulate/recorded_forces.h"
#include "simulate/sensors.h"
#include "simulate/simulate.h"

namespace limbwave::simulate {

/// A named stretch of time: "range", "pose:Right arm:first", "capture".
struct ScriptSegment {
  std::string name;
  double start_s = 0.0, end_s = 0.0;
};

/// The whole story, known for every time from 0 on. Beyond its end the capture repeats without a jump.
class Wearer {
 public:
  /// Fails when the motion does not exist, cannot be read or does not fit the rig's skeleton.
  static Result<std::shared_ptr<const Wearer>> create(const SimulateSettings& settings, const body::Rig& rig,
                                                      const body::Skeleton& skeleton);

  [[nodiscard]] const std::vector<ActualSensor>& sensors() const { return sensors_; }
  [[nodiscard]] const std::vector<ScriptSegment>& segments() const { return segments_; }
  [[nodiscard]] double duration() const { return end_; }  ///< Seconds, as long as the take shall be.

  /// Specific force in the sensor's own frame, m/s²: what a perfect chip at the real place would feel.
  [[nodiscard]] Vector3d specific_force(int sensor, double time_s) const;
  /// True R_WL of a segment; empty while the sensors are not worn or a recording does not tell.
  [[nodiscard]] std::optional<Quaterniond> orientation(int segment, double time_s) const;
  /// World poses of all segments; of a recording's unknown segments as they stand at rest.
  [[nodiscard]] std::vector<body::SegmentPose> poses(double time_s) const;
  /// World position of a sensor's real place, metres.
  [[nodiscard]] Vector3d sensor_position(int sensor, double time_s) const;

 private:
  Wearer() = default;
  [[nodiscard]] double folded(double time_s) const;
  [[nodiscard]] Vector3d worn_force(int sensor, double time_s) const;
  struct Placement {
    VectorJet p_WS;
    QuaternionJet R_WS;
  };
  [[nodiscard]] Placement placement(int sensor, double time_s) const;
  double append_range();
  void append_poses(const body::Rig& rig, double pose_angle, std::uint64_t seed);

  body::Skeleton skeleton_;
  std::vector<ActualSensor> sensors_;
  std::vector<std::vector<int>> chains_;  // root … segment, per sensor
  std::vector<int> sensor_of_segment_;
  SequenceMotion body_;
  std::vector<ScriptSegment> segments_;
  double range_start_ = -1.0;  // negative: none
  double loop_start_ = 0.0, loop_end_ = 0.0, end_ = 0.0;
  std::shared_ptr<const RecordedForces> recording_;
  double recording_start_ = 0.0;
};

}  // namespace limbwave::simulate
