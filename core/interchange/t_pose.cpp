// The T-pose of a skeleton whose bones' roles are known.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "interchange/bone_map.h"
#include "motion/clip.h"
#include "motion/transforms.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// A spine that leans more than this at rest is not how people stand: the whole person is set upright.
constexpr double kLeaning = std::numbers::pi / 6.0;

bool is_finger(std::string_view role) {
  for (const char* finger : {"Index", "Middle", "Ring", "Little"}) {
    if (role.find(finger) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

// Where a bone points in a T-pose, in W; nothing for bones that follow their parents.
std::optional<Vector3d> direction(std::string_view role) {
  const double left = role.starts_with("left") ? 1.0 : -1.0;
  if (role.ends_with("UpperArm") || role.ends_with("LowerArm") || role.ends_with("Hand") || is_finger(role)) {
    return Vector3d(0, left, 0);
  }
  if (role.ends_with("UpperLeg") || role.ends_with("LowerLeg")) {
    return Vector3d(0, 0, -1);
  }
  return {};
}

// The bone that continues a limb; a hand's several children (or a thigh's helper) do not say where it points.
std::string_view continuation(std::string_view role) {
  static constexpr std::pair<std::string_view, std::string_view> kNext[] = {{"UpperArm", "LowerArm"},
                                                                            {"LowerArm", "Hand"},
                                                                            {"Hand", "MiddleProximal"},
                                                                            {"UpperLeg", "LowerLeg"},
                                                                            {"LowerLeg", "Foot"}};
  for (const auto& [end, next] : kNext) {
    if (role.ends_with(end)) {
      return next;
    }
  }
  return {};
}

class Person {
 public:
  Person(const body::Skeleton& skeleton, const std::vector<std::string>& roles)
      : roles_(roles), rest_(motion::rest_poses(skeleton)) {}

  [[nodiscard]] std::optional<Vector3d> place(std::string_view role) const {
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      if (roles_[i] == role) {
        return rest_[i].p_WL;
      }
    }
    return {};
  }

  // Turns the whole person upright and towards +x.
  [[nodiscard]] Quaterniond whole() const {
    Quaterniond turn = Quaterniond::Identity();
    const auto hips = place("hips");
    const auto head = place("head");
    if (hips && head) {
      const Vector3d up = *head - *hips;
      if (up.norm() > 0.0 && std::acos(up.normalized().z()) > kLeaning) {
        turn = Quaterniond::FromTwoVectors(up, Vector3d::UnitZ());
      }
    }
    for (const char* part : {"UpperLeg", "UpperArm", "Shoulder"}) {
      const auto left = place(std::string("left") + part);
      const auto right = place(std::string("right") + part);
      if (left && right) {
        const Vector3d across = turn * (*left - *right);
        const double yaw = std::atan2(across.x(), across.y());
        return Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * turn;
      }
    }
    return turn;
  }

 private:
  const std::vector<std::string>& roles_;
  std::vector<body::SegmentPose> rest_;
};

}  // namespace

std::vector<Quaterniond> t_pose(const body::Skeleton& skeleton, const std::vector<std::string>& roles) {
  const Person person(skeleton, roles);
  const Quaterniond whole = person.whole();
  const std::vector<body::SegmentPose> rest = motion::rest_poses(skeleton);
  const std::vector<Vector3d> bones = motion::bone_directions(skeleton);
  std::vector<Quaterniond> turns(rest.size());  // of every segment, away from its orientation at rest
  std::vector<Quaterniond> R_WL(rest.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const int parent = skeleton.segments[i].parent;
    const Quaterniond carried = parent < 0 ? whole : turns[static_cast<std::size_t>(parent)];
    turns[i] = carried;
    const std::string& role = roles[i];
    if (role.ends_with("Foot") || role.ends_with("Toes")) {
      turns[i] = whole;
    } else if (const auto target = direction(role)) {
      Vector3d bone = rest[i].R_WL * bones[i];
      const std::string_view side = role.starts_with("left") ? "left" : "right";
      const std::string_view next = continuation(role);
      const auto end = next.empty() ? std::nullopt : person.place(std::string(side).append(next));
      if (end && (*end - rest[i].p_WL).norm() > 0.0) {
        bone = *end - rest[i].p_WL;
      }
      turns[i] = Quaterniond::FromTwoVectors(carried * bone, *target) * carried;
    }
    R_WL[i] = (turns[i] * rest[i].R_WL).normalized();
  }
  return R_WL;
}

}  // namespace limbwave::interchange
