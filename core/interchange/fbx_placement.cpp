#include <array>

#include "base/units.h"
#include "interchange/euler.h"
#include "interchange/fbx_scene.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// R = third · second · first, as multiplied.
constexpr std::array<EulerOrder, 6> kOrders = {
    EulerOrder{2, 1, 0}, EulerOrder{1, 2, 0}, EulerOrder{0, 2, 1},
    EulerOrder{2, 0, 1}, EulerOrder{1, 0, 2}, EulerOrder{0, 1, 2},
};

}  // namespace

Quaterniond fbx_rotation(const Vector3d& in_degrees, int order) {
  const EulerOrder& axes = kOrders[static_cast<std::size_t>(order)];
  const auto angle = [&](int axis) { return radians(in_degrees[axis]); };
  return from_euler({angle(axes[0]), angle(axes[1]), angle(axes[2])}, axes);
}

FbxPlacement FbxModel::placement(const FbxChannels& values) const {
  // World = T · Roff · Rp · Rpre · R · Rpost⁻¹ · Rp⁻¹ · Soff · Sp · S · Sp⁻¹ (FBX SDK, "Computing transformation
  // matrices").
  FbxPlacement result;
  result.R = (pre * fbx_rotation(values[kFbxRotation], rotation_order) * post.conjugate()).normalized();
  result.scale = values[kFbxScaling];
  const Vector3d inside =
      scaling_offset + scaling_pivot - rotation_pivot - values[kFbxScaling].cwiseProduct(scaling_pivot);
  result.translation = values[kFbxTranslation] + rotation_offset + rotation_pivot + result.R * inside;
  return result;
}

}  // namespace limbwave::interchange
