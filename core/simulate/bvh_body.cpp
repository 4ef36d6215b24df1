#include "simulate/bvh_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "geometry/so3.h"

namespace limbwave::simulate {
namespace {

struct Names {
  std::string_view segment;
  std::array<std::string_view, 8> joints;
};
// For limbs the right side; the left follows.
constexpr std::array kNames = {
    Names{"pelvis", {"hips", "hip", "root", "pelvis"}},
    Names{"abdomen", {"upperback", "spine", "spine1", "abdomen", "lowerback"}},
    Names{"chest", {"thorax", "spine2", "spine1", "chest", "upperchest"}},
    Names{"neck", {"lowerneck", "neck", "neck1"}},
    Names{"head", {"head"}},
    Names{"shoulder", {"rclavicle", "rightshoulder", "rightcollar", "shoulderr", "rcollar"}},
    Names{"upper_arm", {"rhumerus", "rightarm", "rightuparm", "rightupperarm", "rupperarm", "upperarmr", "rshldr"}},
    Names{
        "forearm",
        {"rradius", "rightforearm", "rightlowarm", "rightlowerarm", "rforearm", "forearmr", "lowerarmr", "rightelbow"}},
    Names{"hand", {"rhand", "righthand", "handr", "rightwrist", "rwrist"}},
    Names{"thigh", {"rfemur", "rightupleg", "rightupperleg", "rightthigh", "thighr", "rthigh", "righthip"}},
    Names{"shin", {"rtibia", "rightleg", "rightlowerleg", "rightlowleg", "rightshin", "shinr", "rshin", "rightknee"}},
    Names{"foot", {"rfoot", "rightfoot", "footr", "rightankle"}}};

}  // namespace

std::vector<std::string> usual_body_joints(const std::string& segment) {
  const bool left = segment.starts_with("left_");
  const bool right = segment.starts_with("right_");
  const std::string part = left ? segment.substr(5) : (right ? segment.substr(6) : segment);
  std::vector<std::string> joints;
  for (const Names& names : kNames) {
    if (names.segment != part) {
      continue;
    }
    for (const std::string_view name : names.joints) {
      std::string joint(name);
      if (joint.empty()) {
        continue;
      }
      if (left && joint.starts_with("right")) {
        joint.replace(0, 5, "left");
      } else if (left && joint.front() == 'r') {
        joint.front() = 'l';
      } else if (left && joint.back() == 'r') {
        joint.back() = 'l';
      }
      joints.push_back(std::move(joint));
    }
  }
  return joints;
}

bool follows_bone(const std::string& segment) {
  for (const char* part : {"upper_arm", "forearm", "hand", "thigh", "shin"}) {
    if (segment.ends_with(part)) {
      return true;
    }
  }
  return false;
}

void project_on_joints(const body::Skeleton& skeleton, std::vector<Quaterniond>& R_PL,
                       std::vector<Eigen::Vector2d>& angles) {
  angles.resize(R_PL.size(), Eigen::Vector2d::Zero());
  std::vector<Quaterniond> wanted(R_PL.size());
  std::vector<Quaterniond> real(R_PL.size());
  for (std::size_t i = 0; i < R_PL.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    if (segment.parent < 0) {
      wanted[i] = real[i] = R_PL[i];
      continue;
    }
    const auto parent = static_cast<std::size_t>(segment.parent);
    wanted[i] = (wanted[parent] * R_PL[i]).normalized();
    Quaterniond turn = segment.R_PL_rest.conjugate() * (real[parent].conjugate() * wanted[i]);
    Eigen::Vector2d& q = angles[i];
    const body::Joint& joint = segment.joint;
    if (joint.kind == body::JointKind::kFixed) {
      turn.setIdentity();
    } else if (joint.kind == body::JointKind::kHinge) {
      // The twist about the axis, on the turn nearest to the frame before.
      const double twist = 2.0 * std::atan2(turn.vec().dot(joint.axis), turn.w());
      q[0] = twist + 2.0 * EIGEN_PI * std::round((q[0] - twist) / (2.0 * EIGEN_PI));
      q[0] = std::clamp(q[0], joint.minimum[0], joint.maximum[0]);
      turn = Quaterniond(Eigen::AngleAxisd(q[0], joint.axis));
    } else if (joint.kind == body::JointKind::kUniversal) {
      const Quaterniond goal = turn;
      for (int step = 0; step < 20; ++step) {
        const Quaterniond second(Eigen::AngleAxisd(q[1], joint.axis2));
        turn = Quaterniond(Eigen::AngleAxisd(q[0], joint.axis)) * second;
        const Vector3d off = geometry::log_so3(turn.conjugate() * goal);
        Eigen::Matrix<double, 3, 2> J;
        J << second.conjugate() * joint.axis, joint.axis2;
        // Weighted towards where it was, so that the angles move on continuously where both axes fall together.
        q += (J.transpose() * J + 1e-4 * Eigen::Matrix2d::Identity()).inverse() * (J.transpose() * off);
        q = q.cwiseMax(joint.minimum.head<2>()).cwiseMin(joint.maximum.head<2>());
      }
      turn = Quaterniond(Eigen::AngleAxisd(q[0], joint.axis)) * Quaterniond(Eigen::AngleAxisd(q[1], joint.axis2));
    }
    R_PL[i] = (segment.R_PL_rest * turn).normalized();
    real[i] = (real[parent] * R_PL[i]).normalized();
  }
}

}  // namespace limbwave::simulate
