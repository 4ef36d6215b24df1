#include "estimate/soles.h"

#include <algorithm>
#include <cmath>

namespace limbwave::estimate {
namespace {

constexpr double kFootReach = 0.06;  // m: leaves that high above the lowest point are feet

}  // namespace

std::vector<Sole> find_soles(const BodyModel& model) {
  const body::Skeleton& skeleton = model.skeleton;
  const std::vector<Quaterniond> rest(skeleton.segments.size(), Quaterniond::Identity());
  const auto poses = body::poses_from_joints(skeleton, rest, skeleton.segments.front().p_PL);
  std::vector<Sole> soles;
  double lowest = INFINITY;
  for (std::size_t s = 1; s < skeleton.segments.size(); ++s) {
    const body::Segment& segment = skeleton.segments[s];
    const bool leaf = std::none_of(skeleton.segments.begin(), skeleton.segments.end(),
                                   [&](const body::Segment& other) { return other.parent == static_cast<int>(s); });
    const Vector3d up_L = poses[s].R_WL.conjugate() * Vector3d::UnitZ();
    std::vector<Vector3d> points;
    for (const body::Capsule& capsule : segment.capsules) {
      points.push_back(capsule.from_L - capsule.radius * up_L);
      points.push_back(capsule.to_L - capsule.radius * up_L);
    }
    if (points.empty()) {
      points = {Vector3d::Zero(), Vector3d(segment.length, 0.0, 0.0)};
    }
    const auto height = [&](const Vector3d& p) { return (poses[s].p_WL + poses[s].R_WL * p).z(); };
    double low = INFINITY;
    for (const Vector3d& p : points) {
      low = std::min(low, height(p));
    }
    lowest = std::min(lowest, low);
    if (!leaf) {
      continue;
    }
    // The middle of what is about as low: a flat sole's middle.
    Sole sole;
    sole.segment = static_cast<int>(s);
    sole.name = segment.name;
    std::vector<Vector3d> lows;
    for (const Vector3d& p : points) {
      if (height(p) < low + 0.01) {
        sole.p_L += p;
        lows.push_back(p);
      }
    }
    sole.p_L /= static_cast<double>(lows.size());
    sole.heel_L = sole.toe_L = lows.front();
    for (const Vector3d& a : lows) {
      for (const Vector3d& b : lows) {
        if ((b - a).norm() > (sole.toe_L - sole.heel_L).norm()) {
          sole.heel_L = a;
          sole.toe_L = b;
        }
      }
    }
    for (std::size_t b = 0; b < model.boards.size(); ++b) {
      if (model.boards[b].segment == sole.segment && (model.boards[b].gyroscope || model.boards[b].accelerometer)) {
        sole.board = static_cast<int>(b);
      }
    }
    soles.push_back(sole);
  }
  std::erase_if(soles, [&](const Sole& sole) {
    const auto s = static_cast<std::size_t>(sole.segment);
    return (poses[s].p_WL + poses[s].R_WL * sole.p_L).z() > lowest + kFootReach;
  });
  return soles;
}

}  // namespace limbwave::estimate
