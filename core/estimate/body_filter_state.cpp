// The state and its error: how one is added to the other, taken off again, kept and resumed from.
#include "estimate/body_filter.h"
#include "geometry/so3.h"

namespace limbwave::estimate {

using Eigen::VectorXd;

void BodyFilter::inject(BodyState& state, const VectorXd& x) const {
  const int n = layout_.dofs;
  tree_.add(state.joints, x.head(n));
  state.joints.qd += x.segment(n, n);
  state.joints.qdd += x.segment(2 * n, n);
  const auto add = [&](std::vector<Vector3d>& values, const std::vector<int>& first) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (first[i] >= 0) {
        values[i] += x.segment<3>(first[i]);
      }
    }
  };
  add(state.gyroscope_bias, layout_.gyroscope_bias);
  add(state.accelerometer_bias, layout_.accelerometer_bias);
  add(state.mount_place, layout_.mount_place);
  add(state.tissue_angle, layout_.tissue_angle);
  add(state.tissue_gain, layout_.tissue_gain);
  add(state.source_place, layout_.source_place);
  for (std::size_t i = 0; i < state.mount_rotation.size(); ++i) {
    if (const int first = layout_.mount_rotation[i]; first >= 0) {
      state.mount_rotation[i] = (state.mount_rotation[i] * geometry::exp_so3(x.segment<3>(first))).normalized();
    }
  }
  for (std::size_t i = 0; i < state.range_offset.size(); ++i) {
    state.range_offset[i] += layout_.range_offset[i] >= 0 ? x[layout_.range_offset[i]] : 0.0;
  }
  for (std::size_t i = 0; i < state.bone_scale.size(); ++i) {
    state.bone_scale[i] += layout_.bone_scale[i] >= 0 ? x[layout_.bone_scale[i]] : 0.0;
  }
  state.sound_scale += layout_.sound_scale >= 0 ? x[layout_.sound_scale] : 0.0;
}

VectorXd BodyFilter::difference(const BodyState& from, const BodyState& to) const {
  VectorXd x = VectorXd::Zero(layout_.size);
  const int n = layout_.dofs;
  x.head(n) = tree_.difference(from.joints, to.joints);
  x.segment(n, n) = to.joints.qd - from.joints.qd;
  x.segment(2 * n, n) = to.joints.qdd - from.joints.qdd;
  const auto put = [&](const std::vector<int>& first, const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] >= 0) {
        x.segment<3>(first[i]) = b[i] - a[i];
      }
    }
  };
  put(layout_.gyroscope_bias, from.gyroscope_bias, to.gyroscope_bias);
  put(layout_.accelerometer_bias, from.accelerometer_bias, to.accelerometer_bias);
  put(layout_.mount_place, from.mount_place, to.mount_place);
  put(layout_.tissue_angle, from.tissue_angle, to.tissue_angle);
  put(layout_.tissue_gain, from.tissue_gain, to.tissue_gain);
  put(layout_.source_place, from.source_place, to.source_place);
  for (std::size_t i = 0; i < layout_.mount_rotation.size(); ++i) {
    if (const int first = layout_.mount_rotation[i]; first >= 0) {
      x.segment<3>(first) = geometry::log_so3(from.mount_rotation[i].conjugate() * to.mount_rotation[i]);
    }
  }
  const auto put_one = [&](int index, double a, double b) {
    if (index >= 0) {
      x[index] = b - a;
    }
  };
  for (std::size_t i = 0; i < layout_.range_offset.size(); ++i) {
    put_one(layout_.range_offset[i], from.range_offset[i], to.range_offset[i]);
  }
  for (std::size_t i = 0; i < layout_.bone_scale.size(); ++i) {
    put_one(layout_.bone_scale[i], from.bone_scale[i], to.bone_scale[i]);
  }
  put_one(layout_.sound_scale, from.sound_scale, to.sound_scale);
  return x;
}

std::vector<double> BodyFilter::place_scale() const {
  std::vector<double> scale(tree_.links().size(), 1.0);
  for (std::size_t l = 0; l < scale.size(); ++l) {
    if (const int parent = tree_.links()[l].parent; parent >= 0) {
      const auto segment = static_cast<std::size_t>(tree_.links()[static_cast<std::size_t>(parent)].segment);
      scale[l] = 1.0 + state_.bone_scale[segment];
    }
  }
  return scale;
}

BodyFilter::Snapshot BodyFilter::snapshot() const {
  Snapshot snapshot{state_, {}, next_prior_s_};
  snapshot.P.reserve(static_cast<std::size_t>(layout_.size) * static_cast<std::size_t>(layout_.size + 1) / 2);
  for (int i = 0; i < layout_.size; ++i) {
    snapshot.P.insert(snapshot.P.end(), P_.row(i), P_.row(i) + i + 1);
  }
  return snapshot;
}

void BodyFilter::resume(const Snapshot& snapshot) {
  state_ = snapshot.state;
  next_prior_s_ = snapshot.next_prior_s;
  const double* from = snapshot.P.data();
  for (int i = 0; i < layout_.size; ++i) {
    for (int j = 0; j <= i; ++j) {
      P_.row(i)[j] = P_.row(j)[i] = *from++;
    }
  }
}

}  // namespace limbwave::estimate
