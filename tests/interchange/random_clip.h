/// A clip that leaves nothing out: branches, zero-length and kinked bones, rest rotations, keys in and past gimbal
/// lock, a moving root.
#pragma once

#include <random>

#include "base/units.h"
#include "geometry/so3.h"
#include "motion/clip.h"

namespace limbwave::test {

inline motion::Clip random_clip(std::size_t joints, std::size_t frames, double fps, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * normal(random), size * normal(random), size * normal(random));
  };
  motion::Clip clip;
  clip.name = "random";
  clip.frame_rate_hz = fps;
  clip.skeleton.name = "random";
  for (std::size_t i = 0; i < joints; ++i) {
    body::Segment segment;
    segment.name = "joint" + std::to_string(i);
    // Mostly chains, now and then a branch; segments of one branch need not be neighbours in the list.
    segment.parent = i == 0 ? -1 : static_cast<int>(uniform(random) < 0.6 ? i - 1 : random() % i);
    segment.p_PL = i == 0 ? Eigen::Vector3d(0.1, 0.2, 0.9) : (i % 7 == 3 ? Eigen::Vector3d(0, 0, 0) : vector(0.15));
    segment.R_PL_rest = geometry::exp_so3(vector(1.0));
    segment.length = i % 5 == 4 ? 0.0 : 0.1 + 0.3 * uniform(random);
    clip.skeleton.segments.push_back(segment);
  }
  clip.joints.resize(joints);
  for (std::size_t i = 0; i < joints; ++i) {
    if (i % 11 == 10) {
      continue;  // stays at rest
    }
    Eigen::Quaterniond R = clip.skeleton.segments[i].R_PL_rest;
    const Eigen::Vector3d rate = vector(0.2);
    for (std::size_t f = 0; f < frames; ++f) {
      clip.joints[i].rotation.times.push_back(static_cast<double>(f) / fps);
      clip.joints[i].rotation.values.push_back(R);
      R = (R * geometry::exp_so3(rate + vector(0.05))).normalized();
      if (f % 13 == 5) {  // Exactly and almost into the lock of ZXY (about x) and ZYX (about y).
        const double off = f % 2 == 0 ? 0.0 : 1e-8 * normal(random);
        const Eigen::Vector3d axis = i % 2 == 0 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
        R = clip.skeleton.segments[i].R_PL_rest *
            Eigen::Quaterniond(Eigen::AngleAxisd((f % 3 == 0 ? -0.5 : 0.5) * kPi + off, axis));
      }
    }
  }
  Eigen::Vector3d p(0, 0, 1);
  for (std::size_t f = 0; f < frames; ++f) {
    clip.root_position.times.push_back(static_cast<double>(f) / fps);
    clip.root_position.values.push_back(p);
    p += vector(0.02) + Eigen::Vector3d(0.03, 0, 0);
  }
  return clip;
}

}  // namespace limbwave::test
