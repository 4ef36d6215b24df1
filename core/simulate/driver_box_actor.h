/// Who wears a driver box: the actor as he really is, what he does, and where every board and source really sits.
#pragma once

#include <memory>
#include <vector>

#include "base/result.h"
#include "body/rig.h"
#include "body/skeleton.h"
#include "simulate/driver_box_errors.h"
#include "simulate/motions.h"

namespace limbwave::simulate {

/// Where a thing really sits on its segment.
struct WornPlace {
  int segment = 0;
  Quaterniond R_LS = Quaterniond::Identity();
  Vector3d p_LS = Vector3d::Zero();
  Vector3d normal_S = Vector3d::UnitX();  ///< Of a source, in its own frame.
  /// The skin slides with the limb's inclination, as in sensors.h.
  double wobble_angle = 0.0, wobble_offset = 0.0;
  Vector3d angle_phase = Vector3d::Zero(), offset_phase = Vector3d::Zero();
};

/// A frame in the world with its derivatives.
struct FrameJet {
  VectorJet p_W;
  QuaternionJet R_W;
};

/// What a perfect chip at the real place would read.
struct ChipTruth {
  Vector3d w_S = Vector3d::Zero();  ///< Angular velocity, rad/s.
  Vector3d f_S = Vector3d::Zero();  ///< Specific force, m/s².
};

class DriverBoxActor {
 public:
  /// `motion`: a built-in one or a BVH file. Fails when it cannot be read or does not fit the rig's skeleton.
  static Result<std::shared_ptr<const DriverBoxActor>> create(const std::string& motion, double motion_metres_per_unit,
                                                              const body::Rig& rig, const body::Skeleton& skeleton,
                                                              const DriverBoxErrors& errors, std::uint64_t seed,
                                                              double rest_s = 0.0);

  [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }  ///< With his real bones.
  [[nodiscard]] double duration() const { return duration_; }                 ///< Of the motion once, seconds.
  [[nodiscard]] const std::vector<WornPlace>& boards() const { return boards_; }
  [[nodiscard]] const std::vector<WornPlace>& sources() const { return sources_; }

  /// All segments at a time; beyond the motion's end it repeats without a jump and without the rest before it.
  void frames(double time_s, std::vector<FrameJet>& frames) const;
  /// A worn thing's frame, given its segment's.
  [[nodiscard]] static FrameJet placed(const WornPlace& place, const FrameJet& segment);
  [[nodiscard]] ChipTruth chip(int board, double time_s) const;

 private:
  [[nodiscard]] FrameJet frame_of(int segment, double time_s) const;
  [[nodiscard]] double folded(double time_s) const;
  [[nodiscard]] QuaternionJet rotation(int segment, double time_s) const;

  body::Skeleton skeleton_;
  SequenceMotion motion_;
  double duration_ = 0.0, loop_start_ = 0.0, loop_end_ = 0.0;
  std::vector<Quaterniond> rest_error_;
  std::vector<WornPlace> boards_, sources_;
  std::vector<std::vector<int>> chains_;  // of segments, root first
};

}  // namespace limbwave::simulate
