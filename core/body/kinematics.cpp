#include <cassert>

#include "body/skeleton.h"

namespace limbwave::body {

std::vector<SegmentPose> poses_from_orientations(const Skeleton& skeleton, const std::vector<Quaterniond>& R_WL,
                                                 const Vector3d& root_p_W) {
  assert(R_WL.size() == skeleton.segments.size());
  std::vector<SegmentPose> poses(skeleton.segments.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Segment& segment = skeleton.segments[i];
    poses[i].R_WL = R_WL[i];
    if (segment.parent < 0) {
      poses[i].p_WL = root_p_W;
    } else {
      const SegmentPose& parent = poses[static_cast<std::size_t>(segment.parent)];
      poses[i].p_WL = parent.p_WL + parent.R_WL * segment.p_PL;
    }
  }
  return poses;
}

std::vector<SegmentPose> poses_from_joints(const Skeleton& skeleton, const std::vector<Quaterniond>& R_joint,
                                           const Vector3d& root_p_W) {
  assert(R_joint.size() == skeleton.segments.size());
  std::vector<Quaterniond> R_WL(skeleton.segments.size());
  for (std::size_t i = 0; i < R_WL.size(); ++i) {
    const Segment& segment = skeleton.segments[i];
    const Quaterniond R_PL = segment.R_PL_rest * R_joint[i];
    R_WL[i] = segment.parent < 0 ? R_PL : (R_WL[static_cast<std::size_t>(segment.parent)] * R_PL).normalized();
  }
  return poses_from_orientations(skeleton, R_WL, root_p_W);
}

}  // namespace limbwave::body
