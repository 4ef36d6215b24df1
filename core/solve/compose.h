/// From inclinations to a clip: headings about the vertical and the kinematic chain (line-in paper §5).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/clip.h"
#include "solve/solve.h"

namespace limbwave::solve {

/// A segment's heading at a time: linear between keys, held outside, 0 without keys. Radians.
double heading_at(const std::vector<HeadingKey>& keys, double time_s);

/// World orientations of all segments at one instant, live and offline: Rz(heading) · inclined[s] for segments that
/// carry a sensor (`sensed`), others follow their parent at rest.
void set_orientations(const body::Skeleton& skeleton, const std::vector<bool>& sensed,
                      std::span<const Eigen::Quaterniond> inclined,
                      const std::vector<std::vector<HeadingKey>>& headings, double time_s,
                      std::vector<Eigen::Quaterniond>& R_WL);

/// R_WL = Rz(heading) · R_WL_inclination for segments that carry a sensor; others follow their parent at rest.
/// `inclinations[segment]` is empty for segments without a sensor, else one rotation per time.
motion::Clip compose_clip(const body::Skeleton& skeleton, const std::vector<double>& times,
                          const std::vector<std::vector<Eigen::Quaterniond>>& inclinations,
                          const std::vector<std::vector<HeadingKey>>& headings, double frame_rate_hz);

/// Rotations of one limb, without headings (estimate::orientations). Fails when one of its inclinations is not a
/// number: as a rotation that would be a limb at rest, and nobody would notice.
Result<std::vector<Eigen::Quaterniond>> limb_orientations(std::span<const estimate::Inclination> inclinations,
                                                          const std::string& sensor);

/// Which segment each accelerometer of the rig is worn on: index into the skeleton.
std::vector<int> sensor_segments(const body::Rig& rig, const body::Skeleton& skeleton);

/// Turns segments about the vertical by `turns` (radians, by segment), in place: those that carry a sensor (`sensed`)
/// each by its own; others stay as they are to their parent.
void turn_segments(const body::Skeleton& skeleton, const std::vector<bool>& sensed, std::span<const double> turns,
                   std::vector<Eigen::Quaterniond>& R_WL);

/// Changes the headings of a solve in place, without solving again: every world orientation turns by the difference.
void apply_headings(Solve& solve, const std::vector<int>& sensor_segments,
                    const std::vector<std::vector<HeadingKey>>& headings);

/// World orientations of all segments at every key of the clip's root track; [frame][segment].
std::vector<std::vector<Eigen::Quaterniond>> world_orientations(const motion::Clip& clip);

}  // namespace limbwave::solve
