/// A person of the skeleton "body" who stands for three seconds and then walks straight on, with feet that really
/// stand: legs by inverse kinematics from planted soles.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "body/skeleton.h"
#include "geometry/so3.h"

namespace limbwave::testing_support {

class WalkingPerson {
 public:
  /// `heading`: where to, radians from +x about the vertical; `side` -1 walks with the other leg first.
  explicit WalkingPerson(body::Skeleton skeleton, double heading = 0.0, double side = 1.0)
      : skeleton_(std::move(skeleton)), turn_(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ())), side_(side) {}

  static constexpr double kRest = 3.0;  // seconds

  [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }

  [[nodiscard]] std::vector<body::SegmentPose> poses(double time_s) const {
    using Eigen::Quaterniond;
    using Eigen::Vector3d;
    constexpr double kStride = 0.75;
    constexpr double kCycle = 1.0;
    // Cycles that have been walked: from nothing to full speed within a second and a half.
    const double t = std::max(0.0, time_s - kRest);
    const double ramp = std::min(1.0, t / 1.5);
    const double begun = smooth(ramp);
    // ∫ of the quintic from 0 to ramp: 2.5 r⁴ − 3 r⁵ + r⁶.
    const double phase =
        (1.5 * (2.5 * std::pow(ramp, 4) - 3.0 * std::pow(ramp, 5) + std::pow(ramp, 6)) + std::max(0.0, t - 1.5)) /
        kCycle;
    std::vector<Quaterniond> R(skeleton_.segments.size(), Quaterniond::Identity());
    const auto index = [&](const char* name) { return static_cast<std::size_t>(skeleton_.find(name)); };
    const double swing = begun * std::sin(2.0 * EIGEN_PI * phase);
    const auto about = [](const Vector3d& axis, double angle) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); };
    R[index("left_upper_arm")] = about(-Vector3d::UnitY(), -side_ * 0.35 * swing);
    R[index("right_upper_arm")] = about(-Vector3d::UnitY(), side_ * 0.35 * swing);
    R[index("left_forearm")] = about(-Vector3d::UnitY(), 0.4 * begun - side_ * 0.15 * swing);
    R[index("right_forearm")] = about(-Vector3d::UnitY(), 0.4 * begun + side_ * 0.15 * swing);
    R[index("chest")] = about(Vector3d::UnitX(), side_ * 0.1 * swing);
    R[index("abdomen")] = about(Vector3d::UnitY(), 0.06 * begun);
    R[index("neck")] = about(Vector3d::UnitY(), -0.05 * begun * (1.0 + 0.4 * std::cos(4.0 * EIGEN_PI * phase)));
    const body::Segment& pelvis = skeleton_.segments.front();
    Vector3d root = pelvis.p_PL;
    root.x() += kStride * phase;
    root.z() += begun * (-0.115 + 0.012 * std::cos(4.0 * EIGEN_PI * phase));
    const Quaterniond R_pelvis = pelvis.R_PL_rest;
    for (int leg = 0; leg < 2; ++leg) {
      const std::string name = leg == 0 ? "left_" : "right_";
      const body::Segment& thigh = skeleton_.segments[index((name + "thigh").c_str())];
      const body::Segment& shin = skeleton_.segments[index((name + "shin").c_str())];
      const body::Segment& foot = skeleton_.segments[index((name + "foot").c_str())];
      const double a = shin.p_PL.x();
      const double b = foot.p_PL.x();
      const Vector3d hip = root + R_pelvis * thigh.p_PL;
      const bool first = (leg == 0) == (side_ > 0.0);
      const Step step = foot_at(phase - (first ? 0.0 : 0.5), first ? 0.0 : 0.5, kStride);
      const double sole = pelvis.p_PL.z() - a - b;  // height of an ankle whose foot stands
      const Vector3d ankle(step.x, thigh.p_PL.y(), sole + 0.09 * step.lift);
      const Vector3d d = ankle - hip;
      const double length = std::min(d.norm(), a + b);
      const double knee = std::acos(std::clamp((length * length - a * a - b * b) / (2.0 * a * b), -1.0, 1.0));
      const double ahead = std::asin(std::clamp(b * std::sin(knee) / length, -1.0, 1.0));
      // Angles about the lateral axis; a leg that hangs straight down is at rest.
      const double down = std::atan2(d.x(), -d.z());
      const double hip_angle = -(down + ahead);
      R[index((name + "thigh").c_str())] = about(Vector3d::UnitY(), hip_angle);
      R[index((name + "shin").c_str())] = about(Vector3d::UnitY(), knee);
      R[index((name + "foot").c_str())] = about(Vector3d::UnitY(), -(hip_angle + knee) + 0.4 * step.lift);
    }
    std::vector<body::SegmentPose> out = body::poses_from_joints(skeleton_, R, root);
    for (body::SegmentPose& pose : out) {
      pose.R_WL = turn_ * pose.R_WL;
      pose.p_WL = turn_ * pose.p_WL;
    }
    return out;
  }

 private:
  struct Step {
    double x, lift;
  };
  static double smooth(double s) { return s * s * s * (10.0 + s * (-15.0 + 6.0 * s)); }

  // A foot swings for the first 0.4 of its cycle; then it stands where the hips pass over it in the middle.
  static Step foot_at(double phase, double offset, double stride) {
    if (phase <= 0.0) {
      return {0.0, 0.0};
    }
    const double cycle = std::floor(phase);
    const double s = std::min(1.0, (phase - cycle) / 0.4);
    const auto plant = [&](double n) { return n < 0.0 ? 0.0 : stride * (n + 0.7 + offset); };
    const double from = plant(cycle - 1.0);
    const double to = plant(cycle);
    return {from + (to - from) * smooth(s), 64.0 * std::pow(s * (1.0 - s), 3)};
  }

  body::Skeleton skeleton_;
  Eigen::Quaterniond turn_;
  double side_;
};

}  // namespace limbwave::testing_support
