#include "simulate/bvh_links.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "geometry/so3.h"
#include "simulate/bvh_body.h"
#include "simulate/motions.h"

namespace limbwave::simulate {
namespace {

// What the joints of a right arm are called, in order of preference, letters and digits only.
struct UsualNames {
  std::string_view segment;
  std::array<std::string_view, 10> joints;
};
constexpr std::array kUsualNames = {
    UsualNames{"torso",
               {"thorax", "chest", "upperchest", "spine2", "spine1", "upperback", "chest2", "spine", "hips", "root"}},
    UsualNames{
        "upperarm",
        {"rhumerus", "rightarm", "rightuparm", "rightupperarm", "rupperarm", "upperarmr", "rshldr", "rightshoulder"}},
    UsualNames{"forearm",
               {"rradius", "rightforearm", "rightlowarm", "rightlowerarm", "rforearm", "rlowerarm", "forearmr",
                "lowerarmr", "rightelbow"}},
    UsualNames{"hand", {"rhand", "righthand", "handr", "rightwrist", "rwrist"}},
    UsualNames{"fingers",
               {"rfingers", "rightfingers", "righthandmiddle1", "righthandindex1", "rightfingerbase", "fingersr",
                "middle1r", "index1r"}},
};

// "mixamorig:RightArm" and "upper_arm.R" → "rightarm", "upperarmr".
std::string plain(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos) {
    name.remove_prefix(colon + 1);
  }
  std::string letters;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters.starts_with("mixamorig") ? letters.substr(9) : letters;
}

int find_plain(const body::Skeleton& file, std::string_view name) {
  for (std::size_t i = 0; i < file.segments.size(); ++i) {
    if (plain(file.segments[i].name) == name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

int find_usual(const body::Skeleton& file, const std::string& segment) {
  for (const UsualNames& usual : kUsualNames) {
    if (usual.segment == plain(segment)) {
      for (const std::string_view name : usual.joints) {
        if (const int joint = name.empty() ? -1 : find_plain(file, name); joint >= 0) {
          return joint;
        }
      }
    }
  }
  return -1;
}

Quaterniond from_columns(const Vector3d& x, const Vector3d& up) {
  Eigen::Matrix3d R;
  R.col(0) = x;
  R.col(1) = up.cross(x).normalized();
  R.col(2) = x.cross(R.col(1));
  return Quaterniond(R);
}

// The figure's right at rest, from its two shoulders or hips, else from where the arm points.
Vector3d right_at_rest(const std::vector<body::SegmentPose>& rest, const body::Skeleton& file, const Vector3d& arm) {
  for (const auto& [right, left] :
       {std::array{"rhumerus", "lhumerus"}, std::array{"rightarm", "leftarm"}, std::array{"upperarmr", "upperarml"},
        std::array{"rightupleg", "leftupleg"}, std::array{"rfemur", "lfemur"}}) {
    const int r = find_plain(file, right);
    const int l = find_plain(file, left);
    if (r >= 0 && l >= 0) {
      Vector3d across = rest[static_cast<std::size_t>(r)].p_WL - rest[static_cast<std::size_t>(l)].p_WL;
      across.z() = 0.0;
      if (across.norm() > 1e-3) {
        return across.normalized();
      }
    }
  }
  const Vector3d level(arm.x(), arm.y(), 0.0);
  return level.norm() > 0.1 ? Vector3d(level.normalized()) : Vector3d(-Vector3d::UnitY());
}

}  // namespace

std::vector<BvhLink> link_segments(const body::Skeleton& skeleton, const body::Skeleton& file) {
  std::vector<BvhLink> links(skeleton.segments.size());
  const std::vector<Quaterniond> R_WL_rest = standing(skeleton);
  std::size_t own = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    links[i].joint = find_plain(file, plain(skeleton.segments[i].name));
    links[i].R_JL = R_WL_rest[i];
    own += links[i].joint >= 0 ? 1 : 0;
  }
  if (own == links.size()) {
    return links;  // a file of this very skeleton, whose rest pose is the skeleton's
  }
  const std::vector<Quaterniond> identity(file.segments.size(), Quaterniond::Identity());
  const auto rest = body::poses_from_joints(file, identity, Vector3d::Zero());
  std::vector<Vector3d> bone(links.size(), Vector3d::Zero());  // direction at rest, world
  const bool whole_body = skeleton.find("pelvis") >= 0 && skeleton.find("left_thigh") >= 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (whole_body) {
      links[i].joint = -1;
      for (const std::string& name : usual_body_joints(skeleton.segments[i].name)) {
        if (links[i].joint = find_plain(file, name); links[i].joint >= 0) {
          break;
        }
      }
    } else if (const int usual = find_usual(file, skeleton.segments[i].name); usual >= 0) {
      links[i].joint = usual;
    }
    for (std::size_t child = 0; child < file.segments.size() && links[i].joint >= 0; ++child) {
      if (file.segments[child].parent == links[i].joint && file.segments[child].p_PL.norm() > 1e-6) {
        bone[i] = file.segments[child].p_PL.normalized();
        break;
      }
    }
  }
  const int upper_arm = skeleton.find("upper_arm");
  const Vector3d right =
      right_at_rest(rest, file, upper_arm < 0 ? Vector3d::Zero() : bone[static_cast<std::size_t>(upper_arm)]);
  const Vector3d forward = Vector3d::UnitZ().cross(right);
  const Quaterniond facing(Eigen::AngleAxisd(std::atan2(forward.y(), forward.x()), Vector3d::UnitZ()));
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].joint < 0) {
      continue;
    }
    if (whole_body) {
      // Standing as at rest; a limb that the file's figure holds elsewhere is taken there by the shortest way.
      links[i].R_JL = facing * R_WL_rest[i];
      if (follows_bone(skeleton.segments[i].name)) {
        const auto parent = static_cast<std::size_t>(skeleton.segments[i].parent);
        bone[i] = bone[i].isZero() ? bone[parent] : bone[i];
        links[i].R_JL = geometry::shortest_arc(links[i].R_JL * Vector3d::UnitX(), bone[i], forward) * links[i].R_JL;
      }
      continue;
    }
    if (skeleton.segments[i].parent < 0) {
      // The trunk stands at rest; our own frame turned to where the file's figure looks.
      links[i].R_JL =
          Quaterniond(Eigen::AngleAxisd(std::atan2(forward.y(), forward.x()), Vector3d::UnitZ())) * R_WL_rest[i];
      continue;
    }
    // The arm stretched sideways with the palm down, taken to where the file's arm points at rest by the shortest way.
    // A last bone goes on where its parent points.
    const auto parent = static_cast<std::size_t>(skeleton.segments[i].parent);
    if (bone[i].isZero()) {
      bone[i] = bone[parent].isZero() ? right : bone[parent];
    }
    links[i].R_JL = geometry::shortest_arc(right, bone[i], forward) * from_columns(right, Vector3d::UnitZ());
  }
  return links;
}

}  // namespace limbwave::simulate
