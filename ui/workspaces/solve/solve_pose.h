/// Poses of a solve with the edits that need no new solving: headings and bone lengths. No widgets.
#pragma once

#include <functional>
#include <vector>

#include "evaluate/evaluate.h"
#include "motion/clip.h"
#include "solve/solve.h"

namespace limbwave::ui {

/// How much a segment's rotation about the vertical differs from the one in the clip, radians.
using HeadingChange = std::function<double(int segment, double time_s)>;

/// Poses at a time: those of the clip, every segment with a sensor turned about the vertical by `change`, the others
/// following their parents at rest, bones as long as in `skeleton` (which has the clip's segments).
void edited_pose(const motion::Clip& clip, const body::Skeleton& skeleton, const std::vector<bool>& has_sensor,
                 const HeadingChange& change, double time_s, std::vector<body::SegmentPose>& poses);

/// Which segments of the skeleton carry an accelerometer.
std::vector<bool> segments_with_sensors(const body::Rig& rig, const body::Skeleton& skeleton);

/// Poses of the truth at a time of the take, one per segment of the skeleton; segments that the truth does not know
/// follow their parents at rest. Empty without truth.
std::vector<body::SegmentPose> truth_pose(const evaluate::Truth& truth, const body::Skeleton& skeleton,
                                          double take_time_s);

/// Both ends of all bones at `instants` times spread over the clip, metres.
std::vector<Eigen::Vector3d> motion_extent(const motion::Clip& clip, int instants);

/// Where a figure may reach while its root stands: the root's bone, and a sphere about the joint of each of its
/// children, as large as what hangs on it is long when stretched. Metres.
std::vector<Eigen::Vector3d> reach_extent(const body::Skeleton& skeleton);

/// Elevation of a bone over the horizontal at every key of the clip's root, degrees; one list per segment asked for.
/// Headings do not change it.
std::vector<std::vector<float>> elevations(const motion::Clip& clip, const std::vector<int>& segments);

}  // namespace limbwave::ui
