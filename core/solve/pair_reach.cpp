#include "solve/pair_reach.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::solve {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr int kPoses = 4000;
constexpr std::size_t kMostAngles = 6;           // of all joints between; more are not sampled
constexpr double kBeyondLimits = radians(10.0);  // people are not all alike

// Segments from `segment` up to, not including, `common`.
std::vector<int> way_up(const body::Skeleton& skeleton, int segment, int common) {
  std::vector<int> way;
  for (int i = segment; i != common; i = skeleton.segments[static_cast<std::size_t>(i)].parent) {
    way.push_back(i);
  }
  return way;
}

int common_segment(const body::Skeleton& skeleton, int a, int b) {
  // Parents come before children.
  while (a != b) {
    int& later = a > b ? a : b;
    later = skeleton.segments[static_cast<std::size_t>(later)].parent;
  }
  return a;
}

class Poser {
 public:
  explicit Poser(const body::Skeleton& skeleton) : skeleton_(skeleton) {}

  // A point and a direction of the first segment of `way`, in the frame that the last one hangs on.
  void carry(const std::vector<int>& way, Vector3d& point, Vector3d& direction) {
    for (const int i : way) {
      const body::Segment& segment = skeleton_.segments[static_cast<std::size_t>(i)];
      const Quaterniond R = segment.R_PL_rest * turn(segment.joint);
      point = segment.p_PL + R * point;
      direction = R * direction;
    }
  }

 private:
  // Half of all angles lie at a limit: what is sought mostly does.
  double angle(const body::Joint& joint, Eigen::Index axis) {
    const double low = joint.minimum[axis] - kBeyondLimits;
    const double high = joint.maximum[axis] + kBeyondLimits;
    const double at = share_(random_);
    return at < 0.25 ? low : at < 0.5 ? high : low + 2.0 * (at - 0.5) * (high - low);
  }
  Quaterniond turn(const body::Joint& joint) {
    switch (joint.kind) {
      case body::JointKind::kFixed:
        return Quaterniond::Identity();
      case body::JointKind::kHinge:
        return geometry::exp_so3(angle(joint, 0) * joint.axis);
      case body::JointKind::kUniversal: {
        const Quaterniond first = geometry::exp_so3(angle(joint, 0) * joint.axis);
        return first * geometry::exp_so3(angle(joint, 1) * joint.axis2);
      }
      case body::JointKind::kSpherical:
        break;
    }
    const double x = angle(joint, 0);
    const double y = angle(joint, 1);
    return geometry::exp_so3(Vector3d(x, y, angle(joint, 2)));
  }
  const body::Skeleton& skeleton_;
  std::mt19937_64 random_{1};
  std::uniform_real_distribution<double> share_{0.0, 1.0};
};

}  // namespace

PairReach pair_reach(const body::Skeleton& skeleton, int s, const Vector3d& p_LS, const Vector3d& normal_L, int m,
                     const Vector3d& p_LM) {
  const int common = common_segment(skeleton, s, m);
  const std::vector<int> up = way_up(skeleton, s, common);
  const std::vector<int> down = way_up(skeleton, m, common);
  std::size_t angles = 0;
  double stretched_up = p_LS.norm();
  double stretched_down = p_LM.norm();
  const auto follow = [&](const std::vector<int>& way, double& stretched) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      const body::Segment& segment = skeleton.segments[static_cast<std::size_t>(way[i])];
      angles += body::degrees_of_freedom(segment.joint.kind);
      stretched += i + 1 < way.size() ? segment.p_PL.norm() : 0.0;
    }
  };
  follow(up, stretched_up);
  follow(down, stretched_down);
  const auto hangs_at = [&](const std::vector<int>& way, const Vector3d& own) {
    return way.empty() ? own : skeleton.segments[static_cast<std::size_t>(way.back())].p_PL;
  };
  PairReach reach;
  reach.farthest = (up.empty() ? 0.0 : stretched_up) + (down.empty() ? 0.0 : stretched_down) +
                   (hangs_at(up, p_LS) - hangs_at(down, p_LM)).norm();
  if (angles > kMostAngles) {
    return reach;
  }
  Poser poser(skeleton);
  double farthest = 0.0;
  reach.foremost = kPi;
  for (int i = 0; i < (angles > 0 ? kPoses : 1); ++i) {
    Vector3d source = p_LS;
    Vector3d normal = normal_L;
    poser.carry(up, source, normal);
    Vector3d microphone = p_LM;
    Vector3d ignored = Vector3d::UnitX();
    poser.carry(down, microphone, ignored);
    const Vector3d way = microphone - source;
    farthest = std::max(farthest, way.norm());
    if (way.norm() > 1e-6) {
      reach.foremost = std::min(reach.foremost, std::acos(std::clamp(way.normalized().dot(normal), -1.0, 1.0)));
    }
  }
  reach.farthest = std::min(reach.farthest, farthest);
  return reach;
}

}  // namespace limbwave::solve
