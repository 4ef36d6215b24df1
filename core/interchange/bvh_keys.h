/// The second half of a BVH file: frames of numbers turned into keys. Used by the reader alone.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

#include "base/diagnostics.h"
#include "interchange/bvh_hierarchy.h"
#include "interchange/bvh_reader.h"
#include "interchange/file_axes.h"
#include "motion/clip.h"

namespace limbwave::interchange {

inline Eigen::Vector3d to_world_axes(const Eigen::Vector3d& v, UpAxis up) {
  return up == UpAxis::kY ? from_y_up(v) : v;
}
inline Eigen::Quaterniond to_world_axes(const Eigen::Quaterniond& R, UpAxis up) {
  return up == UpAxis::kY ? from_y_up(R) : R;
}

class BvhKeys {
 public:
  /// `R_WL_rest`: the frames L of all joints at rest. `scale`: metres per unit.
  BvhKeys(const std::vector<BvhJoint>& joints, const std::vector<Eigen::Quaterniond>& R_WL_rest, UpAxis up,
          double scale);

  /// Values per frame.
  [[nodiscard]] std::size_t channels() const { return channels_; }
  void reserve(std::size_t frames);
  /// One frame; `values` has `channels()` numbers.
  void add(const std::vector<double>& values);
  /// Moves the keys into the clip, whose skeleton is there already, at multiples of `frame_time` seconds.
  void finish(motion::Clip& clip, double frame_time, Diagnostics& diagnostics);

 private:
  struct Plan {
    std::size_t first = 0;  // index of its first value in a frame
    std::array<BvhChannel, 6> channels{};
    std::size_t count = 0;
    bool moves = false;
    bool turns = false;
    Eigen::Vector3d offset{0, 0, 0};
    Eigen::Quaterniond P_inverse = Eigen::Quaterniond::Identity();  // the parent's frame at rest, inverted
    Eigen::Quaterniond L = Eigen::Quaterniond::Identity();          // the own frame at rest
    // Both in the file's axes: what stands before and after its rotation.
    Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
    Eigen::Quaterniond after = Eigen::Quaterniond::Identity();
    std::vector<Eigen::Quaterniond> rotations;
    std::vector<Eigen::Vector3d> positions;  // as the file has them; of all joints but the root
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d lowest = Eigen::Vector3d::Constant(INFINITY);
    Eigen::Vector3d highest = Eigen::Vector3d::Constant(-INFINITY);
  };

  // Its rotation in the parent's frame L, in the file's axes.
  [[nodiscard]] Eigen::Quaterniond rotation(const Plan& plan) const;
  static Eigen::Vector3d position(const Plan& plan, const std::vector<double>& values);

  UpAxis up_;
  double scale_;
  std::vector<Plan> plans_;
  std::size_t channels_ = 0;
  std::size_t frames_ = 0;
  std::vector<double> sines_;  // of half of every value of a frame, in degrees
  std::vector<double> cosines_;
  std::vector<Eigen::Vector3d> root_;
};

}  // namespace limbwave::interchange
