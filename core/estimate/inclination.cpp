#include "estimate/inclination.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::estimate {

double trust_of(const Vector3d& f, const InclinationParameters& parameters) {
  const double deviation = std::abs(f.norm() - kStandardGravity);
  if (!std::isfinite(deviation)) {
    return 0.0;
  }
  const double excess = std::max(0.0, deviation - parameters.free_deviation) / parameters.half_trust_deviation;
  return 1.0 / (1.0 + excess * excess);
}

Quaterniond orientation(const Vector3d& up_L, double heading, const Quaterniond& previous_R_WL) {
  // The axis of the previous simplest rotation serves where this one has none.
  const Quaterniond previous_arc =
      geometry::shortest_arc(previous_R_WL.conjugate() * Vector3d::UnitZ(), Vector3d::UnitZ());
  const Vector3d axis =
      previous_arc.vec().norm() > 1e-9 ? Vector3d(previous_arc.vec().normalized()) : Vector3d(Vector3d::UnitY());
  const Quaterniond about_z(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
  return about_z * geometry::shortest_arc(up_L, Vector3d::UnitZ(), axis);
}

std::vector<Quaterniond> orientations(std::span<const Inclination> inclinations, std::span<const double> headings) {
  std::vector<Quaterniond> result;
  result.reserve(inclinations.size());
  Quaterniond previous = Quaterniond::Identity();
  for (std::size_t i = 0; i < inclinations.size(); ++i) {
    // The simplest rotation is continued without the heading, which must not turn its axis.
    previous = orientation(inclinations[i].up_L, 0.0, previous);
    const double heading = headings.empty() ? 0.0 : headings[i];
    result.push_back(Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ())) * previous);
  }
  return result;
}

}  // namespace limbwave::estimate
