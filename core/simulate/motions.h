/// Motions of a skeleton as smooth functions of time, and the built-in ones. They are of our own making.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "body/skeleton.h"
#include "simulate/curve.h"
#include "simulate/jets.h"

namespace limbwave::simulate {

/// What a body does. Defined for all times: before 0 and after `duration` it goes on smoothly (held, or extrapolated a
/// little), so that motions can be blended into each other.
class BodyMotion {
 public:
  virtual ~BodyMotion() = default;
  BodyMotion() = default;
  BodyMotion(const BodyMotion&) = delete;
  BodyMotion& operator=(const BodyMotion&) = delete;
  [[nodiscard]] virtual double duration() const = 0;  ///< Seconds.
  /// R_PL of a segment, including rest (root: R_WL), of unit length, with two derivatives.
  [[nodiscard]] virtual QuaternionJet rotation(int segment, double time_s) const = 0;
  /// p_W of the root's joint, metres.
  [[nodiscard]] virtual VectorJet root_position(double time_s) const = 0;
};

/// Joint angles as curves: R_PL = R_PL_rest · Π exp(axis · angle(t)), in the order in which they were added.
class JointMotion : public BodyMotion {
 public:
  explicit JointMotion(const body::Skeleton& skeleton);
  /// A new factor of the segment's rotation; angles in radians. The reference lives as long as the motion.
  Curve& turn(int segment, const Vector3d& axis);
  Curve& root(int axis) { return root_[static_cast<std::size_t>(axis)]; }  ///< Added to the root's offset, metres.
  void set_duration(double seconds) { duration_ = seconds; }
  [[nodiscard]] double duration() const override { return duration_; }
  [[nodiscard]] QuaternionJet rotation(int segment, double time_s) const override;
  [[nodiscard]] VectorJet root_position(double time_s) const override;

 private:
  struct Turn {
    Vector3d axis;
    Curve angle;
  };
  std::vector<Quaterniond> rest_;
  std::vector<std::vector<std::unique_ptr<Turn>>> turns_;
  Vector3d root_offset_;
  Curve root_[3];
  double duration_ = 0.0;
};

/// World orientations of all segments, held for a while; between them every joint turns about one axis.
struct HeldPose {
  std::vector<Quaterniond> R_WL;  ///< One per segment.
  double start_s = 0.0, end_s = 0.0;
};

class PoseMotion : public BodyMotion {
 public:
  /// Poses in order of time, at least one; their holds do not overlap.
  PoseMotion(const body::Skeleton& skeleton, const std::vector<HeldPose>& poses);
  [[nodiscard]] double duration() const override { return duration_; }
  [[nodiscard]] QuaternionJet rotation(int segment, double time_s) const override;
  [[nodiscard]] VectorJet root_position(double time_s) const override;

 private:
  struct Key {
    double start, end;
    std::vector<Quaterniond> R_PL;
    std::vector<Vector3d> axis;  // of the way to the next key
    std::vector<double> angle;
  };
  std::vector<Key> keys_;
  Vector3d root_offset_;
  double duration_ = 0.0;
};

/// One motion after the other; each pair blended into each other over a gap between them.
class SequenceMotion : public BodyMotion {
 public:
  /// Keeps to the joints of a skeleton between the parts, which keep to them as well.
  void keep_to_joints_of(body::Skeleton skeleton) { skeleton_ = std::move(skeleton); }
  /// Appends; its time 0 comes `gap_s` after the end of what is there. Returns when it starts.
  double append(std::shared_ptr<const BodyMotion> motion, double gap_s);
  [[nodiscard]] double duration() const override;
  [[nodiscard]] QuaternionJet rotation(int segment, double time_s) const override;
  [[nodiscard]] VectorJet root_position(double time_s) const override;

 private:
  struct Part {
    std::shared_ptr<const BodyMotion> motion;
    double start, end;
  };
  [[nodiscard]] std::size_t part_before(double time_s) const;
  std::vector<Part> parts_;
  body::Skeleton skeleton_;
};

/// World orientations when every joint rests.
std::vector<Quaterniond> standing(const body::Skeleton& skeleton);

/// "arm-raise", "wave", "reach", "walk", "box", "every-joint" or "still". The first five need a skeleton with the
/// segments of "arm"; the others go with any. `seed` varies the poses of "still" only.
Result<std::shared_ptr<const BodyMotion>> make_builtin_motion(const std::string& name, const body::Skeleton& skeleton,
                                                              std::uint64_t seed);

}  // namespace limbwave::simulate
