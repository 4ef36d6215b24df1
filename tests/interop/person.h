/// A person of 22 joints who does everything that files can lose: turns in and past gimbal lock, jumps over the floor.
#pragma once

#include <array>

#include "interchange/random_clip.h"

namespace limbwave::test {

struct PersonBone {
  const char* name;
  int parent;
  Eigen::Vector3d joint;  ///< Where it is at rest: W, metres.
  Eigen::Vector3d end;    ///< Where the bone ends.
};

/// Arms half down, so that a T-pose is another pose.
inline const std::array<PersonBone, 22>& person_bones() {
  static const std::array<PersonBone, 22> kBones = {{
      {"hips", -1, {0.00, 0.00, 0.95}, {-0.01, 0.00, 1.05}},
      {"spine", 0, {-0.01, 0.00, 1.05}, {-0.02, 0.00, 1.18}},
      {"chest", 1, {-0.02, 0.00, 1.18}, {-0.02, 0.00, 1.30}},
      {"upperChest", 2, {-0.02, 0.00, 1.30}, {-0.01, 0.00, 1.46}},
      {"neck", 3, {-0.01, 0.00, 1.46}, {0.01, 0.00, 1.55}},
      {"head", 4, {0.01, 0.00, 1.55}, {0.01, 0.00, 1.75}},
      {"leftShoulder", 3, {-0.01, 0.03, 1.42}, {-0.02, 0.17, 1.41}},
      {"leftUpperArm", 6, {-0.02, 0.17, 1.41}, {-0.02, 0.37, 1.21}},
      {"leftLowerArm", 7, {-0.02, 0.37, 1.21}, {0.04, 0.54, 1.05}},
      {"leftHand", 8, {0.04, 0.54, 1.05}, {0.09, 0.65, 0.94}},
      {"rightShoulder", 3, {-0.01, -0.03, 1.42}, {-0.02, -0.17, 1.41}},
      {"rightUpperArm", 10, {-0.02, -0.17, 1.41}, {-0.02, -0.37, 1.21}},
      {"rightLowerArm", 11, {-0.02, -0.37, 1.21}, {0.04, -0.54, 1.05}},
      {"rightHand", 12, {0.04, -0.54, 1.05}, {0.09, -0.65, 0.94}},
      {"leftUpperLeg", 0, {0.00, 0.09, 0.91}, {0.01, 0.10, 0.50}},
      {"leftLowerLeg", 14, {0.01, 0.10, 0.50}, {-0.02, 0.11, 0.09}},
      {"leftFoot", 15, {-0.02, 0.11, 0.09}, {0.11, 0.12, 0.02}},
      {"leftToes", 16, {0.11, 0.12, 0.02}, {0.18, 0.13, 0.01}},
      {"rightUpperLeg", 0, {0.00, -0.09, 0.91}, {0.01, -0.10, 0.50}},
      {"rightLowerLeg", 18, {0.01, -0.10, 0.50}, {-0.02, -0.11, 0.09}},
      {"rightFoot", 19, {-0.02, -0.11, 0.09}, {0.11, -0.12, 0.02}},
      {"rightToes", 20, {0.11, -0.12, 0.02}, {0.18, -0.13, 0.01}},
  }};
  return kBones;
}

inline body::Skeleton person_skeleton() {
  body::Skeleton skeleton;
  skeleton.name = "person";
  skeleton.height = 1.75;
  std::vector<Eigen::Quaterniond> R_WL;
  for (const PersonBone& bone : person_bones()) {
    const Eigen::Vector3d along = bone.end - bone.joint;
    R_WL.push_back(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), along));
    body::Segment segment;
    segment.name = bone.name;
    segment.parent = bone.parent;
    segment.length = along.norm();
    const auto parent = static_cast<std::size_t>(std::max(bone.parent, 0));
    const Eigen::Quaterniond to_parent = bone.parent < 0 ? Eigen::Quaterniond::Identity() : R_WL[parent].conjugate();
    segment.R_PL_rest = (to_parent * R_WL.back()).normalized();
    segment.p_PL = bone.parent < 0 ? bone.joint : to_parent * (bone.joint - person_bones()[parent].joint);
    skeleton.segments.push_back(segment);
  }
  return skeleton;
}

/// The person with random_clip's turns away from rest, and its way over the floor.
inline motion::Clip person_clip(std::size_t frames, double fps, unsigned seed) {
  motion::Clip clip = random_clip(person_bones().size(), frames, fps, seed);
  const body::Skeleton person = person_skeleton();
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    const Eigen::Quaterniond back = clip.skeleton.segments[i].R_PL_rest.conjugate();
    for (Eigen::Quaterniond& R : clip.joints[i].rotation.values) {
      R = (person.segments[i].R_PL_rest * (back * R)).normalized();
    }
  }
  clip.name = "person";
  clip.skeleton = person;
  return clip;
}

}  // namespace limbwave::test
