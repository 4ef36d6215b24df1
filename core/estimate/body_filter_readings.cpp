// What is measured, and how it depends on the error state.
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "estimate/body_filter.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using body::TreeKinematics;
using Eigen::Matrix3d;

const Vector3d kGravity(0.0, 0.0, -kStandardGravity);

constexpr double kSpeedOfSound = 343.0;  // m/s; only for how far a microphone moves meanwhile

// Tags: what a group's result is counted for.
constexpr int kGyroscopeTag = 1 << 20;
constexpr int kAccelerometerTag = 2 << 20;
constexpr int kRangeTag = 3 << 20;
constexpr int kNumber = (1 << 20) - 1;

void append(MeasurementGroup& g, int index, const Vector3d& column) {
  g.support.push_back(index);
  g.H.insert(g.H.end(), {column.x(), column.y(), column.z()});
}

void append_block(MeasurementGroup& g, int first, const Matrix3d& block) {
  for (int i = 0; i < 3; ++i) {
    append(g, first + i, block.col(i));
  }
}

double square(double x) {
  return x * x;
}

constexpr double kClipped = 0.998;     // of its range: a reading has reached its end
constexpr double kBeyond = 0.15;       // of its range: by how much what is clipped is usually larger
constexpr double kNotMeasured = 1e12;  // a variance

// A component at the end of its range says only that the truth lies beyond: where the prediction lies short of the end
// it is drawn towards it, where it lies beyond it is left alone.
void set_rows(MeasurementGroup& g, const Vector3d& reading, const Vector3d& innovation, double variance, double range) {
  for (int r = 0; r < 3; ++r) {
    const bool clipped = std::abs(reading[r]) >= kClipped * range;
    const bool short_of_it = innovation[r] * reading[r] > 0.0;
    g.innovation[r] = clipped && !short_of_it ? 0.0 : innovation[r];
    g.variance[r] = !clipped ? variance : (short_of_it ? variance + square(kBeyond * range) : kNotMeasured);
  }
}

}  // namespace

void BodyFilter::count(const MeasurementGroup& g) {
  const auto number = static_cast<std::size_t>(g.tag & kNumber);
  ReadingCount* count = nullptr;
  switch (g.tag & ~kNumber) {
    case kGyroscopeTag:
      count = &gyroscope_counts_[number];
      break;
    case kAccelerometerTag:
      count = &accelerometer_counts_[number];
      break;
    case kRangeTag:
      count = &range_counts_[number];
      break;
    default:
      return;
  }
  count->nis_sum += g.nis / g.rows;
  ++(g.accepted && (g.gate <= 0.0 || g.nis <= g.gate) ? count->used : count->gated);
}

// Eqs. (2) and (3) of the paper, with biases and the error of the mounting.
void BodyFilter::add_inertial(const InertialReading& reading) {
  const auto b = static_cast<std::size_t>(reading.board);
  const BodyBoard& board = model_.boards[b];
  const BodyFilterParameters& p = parameters_;
  const int n = layout_.dofs;
  const int link = tree_.link_of(board.segment);
  const std::vector<int>& dofs = tree_.chain_dofs(link);
  const body::LinkMotion& m = kinematics_.link(link);
  const Vector3d p_LS = board.p_LS + state_.mount_place[b];
  const Matrix3d R_skin = geometry::exp_so3(state_.tissue_angle[b]).toRotationMatrix();
  const Matrix3d R_SW = (m.R_WL * (board.R_LS * state_.mount_rotation[b]).toRotationMatrix() * R_skin).transpose();
  const bool gyroscope = p.use_gyroscopes && board.gyroscope && !std::isnan(reading.w_S.x());
  const bool accelerometer = p.use_accelerometers && board.accelerometer && !std::isnan(reading.f_S.x());
  const auto usable = [](const Vector3d& v, double range, ReadingCount& count) {
    if (!v.allFinite()) {
      ++count.not_finite;
      return false;
    }
    count.clipped += v.cwiseAbs().maxCoeff() >= kClipped * range ? 1 : 0;
    return true;
  };
  const TreeKinematics::PointMotion point = kinematics_.point(link, p_LS);
  kinematics_.jacobians(link, point, accelerometer ? TreeKinematics::kAcceleration : TreeKinematics::kPosition,
                        jacobians_);
  if (gyroscope && usable(reading.w_S, model_.gyroscope_range, gyroscope_counts_[b])) {
    MeasurementGroup& g = group(3, kGyroscopeTag | reading.board);
    g.softened = true;
    const Vector3d w_S = R_SW * m.w;
    // The skin turns with a part of the segment's own speed.
    const double speed = m.w.norm();
    const Vector3d w_skin = speed * state_.tissue_gain[b];
    Matrix3d along = R_SW;
    if (speed > 1e-6) {
      along += state_.tissue_gain[b] * (m.w / speed).transpose();
    }
    for (std::size_t c = 0; c < dofs.size(); ++c) {
      const auto column = static_cast<Eigen::Index>(c);
      const Vector3d s = jacobians_.J_phi_theta.col(column);
      append(g, dofs[c], along * jacobians_.J_w_theta.col(column) - R_SW * s.cross(m.w));
      append(g, n + dofs[c], along * s);
    }
    if (const int first = layout_.gyroscope_bias[b]; first >= 0) {
      append_block(g, first, Matrix3d::Identity());
    }
    if (const int first = layout_.mount_rotation[b]; first >= 0) {
      append_block(g, first, geometry::skew(w_S) * R_skin.transpose());
    }
    if (const int first = layout_.tissue_angle[b]; first >= 0) {
      append_block(g, first, geometry::skew(w_S) * geometry::right_jacobian(state_.tissue_angle[b]));
      append_block(g, layout_.tissue_gain[b], speed * Matrix3d::Identity());
    }
    const double variance = square(p.gyroscope_noise) + square(p.gyroscope_relative * reading.w_S.norm());
    const Vector3d innovation = reading.w_S - w_S - w_skin - state_.gyroscope_bias[b];
    set_rows(g, reading.w_S, innovation, variance, model_.gyroscope_range);
  }
  if (accelerometer && usable(reading.f_S, model_.accelerometer_range, accelerometer_counts_[b])) {
    MeasurementGroup& g = group(3, kAccelerometerTag | reading.board);
    g.softened = true;
    const Vector3d f = point.a - kGravity;
    const Vector3d f_S = R_SW * f;
    for (std::size_t c = 0; c < dofs.size(); ++c) {
      const auto column = static_cast<Eigen::Index>(c);
      const Vector3d s = jacobians_.J_phi_theta.col(column);
      append(g, dofs[c], R_SW * (jacobians_.J_a_theta.col(column) - s.cross(f)));
      append(g, n + dofs[c], R_SW * jacobians_.J_a_thetad.col(column));
      append(g, 2 * n + dofs[c], R_SW * jacobians_.J_p_theta.col(column));
    }
    if (const int first = layout_.accelerometer_bias[b]; first >= 0) {
      append_block(g, first, Matrix3d::Identity());
    }
    if (const int first = layout_.mount_rotation[b]; first >= 0) {
      append_block(g, first, geometry::skew(f_S) * R_skin.transpose());
    }
    if (const int first = layout_.tissue_angle[b]; first >= 0) {
      append_block(g, first, geometry::skew(f_S) * geometry::right_jacobian(state_.tissue_angle[b]));
    }
    if (const int first = layout_.mount_place[b]; first >= 0) {
      for (int i = 0; i < 3; ++i) {
        append(g, first + i, R_SW * kinematics_.offset_acceleration(link, m.R_WL.col(i)));
      }
    }
    for (const int l : bone_links_[static_cast<std::size_t>(link)]) {
      const body::TreeLink& moved = tree_.links()[static_cast<std::size_t>(l)];
      const int segment = tree_.links()[static_cast<std::size_t>(moved.parent)].segment;
      const Vector3d offset = kinematics_.link(moved.parent).R_WL * moved.p_PL;
      append(g, layout_.bone_scale[static_cast<std::size_t>(segment)],
             R_SW * kinematics_.offset_acceleration(moved.parent, offset));
    }
    const double variance = square(p.accelerometer_noise) + square(p.accelerometer_relative * reading.f_S.norm());
    const Vector3d innovation = reading.f_S - f_S - state_.accelerometer_bias[b];
    set_rows(g, reading.f_S, innovation, variance, model_.accelerometer_range);
  }
}

// Eq. (4): the distance of two points of the body, times the error of the speed of sound, plus the source's offset.
void BodyFilter::add_range(const RangeReading& reading) {
  const BodyFilterParameters& p = parameters_;
  const auto b = static_cast<std::size_t>(reading.board);
  const auto s = static_cast<std::size_t>(reading.source);
  const BodyBoard& board = model_.boards[b];
  const BodySource& source = model_.sources[s];
  ReadingCount& counts = range_counts_[s];
  if (!p.use_ranges || !board.microphone || !(reading.confidence > 0.0)) {
    return;
  }
  if (!std::isfinite(reading.range)) {
    ++counts.not_finite;
    return;
  }
  const int ends[2] = {tree_.link_of(board.segment), tree_.link_of(source.segment)};
  const Vector3d places[2] = {board.p_LS + state_.mount_place[b], source.p_LS + state_.source_place[s]};
  const TreeKinematics::PointMotion points[2] = {kinematics_.point(ends[0], places[0]),
                                                 kinematics_.point(ends[1], places[1])};
  // The microphone moves on while sound is under way.
  const double flight = std::clamp(reading.range, 0.0, 10.0) / kSpeedOfSound;
  const Vector3d between = points[0].p + flight * points[0].v - points[1].p;
  const double distance = between.norm();
  if (distance < 1e-3) {
    return;
  }
  const Vector3d u = between / distance;
  const double scale = 1.0 + state_.sound_scale;
  MeasurementGroup& g = group(1, kRangeTag | reading.source);
  const auto put = [&](int index, double value) {
    // The two ends share joints: entries of the same state add up.
    const auto at = std::find(g.support.begin(), g.support.end(), index);
    if (at == g.support.end()) {
      g.support.push_back(index);
      g.H.push_back(value);
    } else {
      g.H[static_cast<std::size_t>(at - g.support.begin())] += value;
    }
  };
  for (int end = 0; end < 2; ++end) {
    const double sign = end == 0 ? scale : -scale;
    const auto link = static_cast<std::size_t>(ends[end]);
    kinematics_.jacobians(ends[end], points[end], TreeKinematics::kPosition, source_jacobians_);
    const std::vector<int>& dofs = tree_.chain_dofs(ends[end]);
    for (std::size_t c = 0; c < dofs.size(); ++c) {
      const double along = sign * u.dot(source_jacobians_.J_p_theta.col(static_cast<Eigen::Index>(c)));
      put(dofs[c], along);
      if (end == 0) {
        put(layout_.dofs + dofs[c], flight * along);
      }
    }
    const int first = end == 0 ? layout_.mount_place[b] : layout_.source_place[s];
    for (int i = 0; first >= 0 && i < 3; ++i) {
      put(first + i, sign * u.dot(kinematics_.link(ends[end]).R_WL.col(i)));
    }
    for (const int l : bone_links_[link]) {
      const body::TreeLink& moved = tree_.links()[static_cast<std::size_t>(l)];
      const int segment = tree_.links()[static_cast<std::size_t>(moved.parent)].segment;
      put(layout_.bone_scale[static_cast<std::size_t>(segment)],
          sign * u.dot(kinematics_.link(moved.parent).R_WL * moved.p_PL));
    }
  }
  if (layout_.range_offset[s] >= 0) {
    put(layout_.range_offset[s], 1.0);
  }
  if (layout_.sound_scale >= 0) {
    put(layout_.sound_scale, distance);
  }
  g.innovation[0] = reading.range - scale * distance - state_.range_offset[s];
  const double noise =
      reading.variance > 0.0 ? reading.variance : square(p.range_noise / std::min(reading.confidence, 1.0));
  g.variance[0] = noise + square(p.range_model);
}

void BodyFilter::add_root(const RootReading& reading) {
  if (tree_.root_motion() != body::RootMotion::kFree) {
    return;
  }
  const body::LinkMotion& m = kinematics_.link(tree_.link_of(0));
  MeasurementGroup& turn = group(3, 0);
  append_block(turn, 3, Matrix3d::Identity());
  const Vector3d off = geometry::log_so3(Quaterniond(m.R_WL).conjugate() * reading.R_WL);
  MeasurementGroup& place = group(3, 0);
  append_block(place, 0, Matrix3d::Identity());
  const Vector3d away = reading.p_W - m.p;
  for (int r = 0; r < 3; ++r) {
    groups_[used_groups_ - 2].innovation[r] = off[r];
    groups_[used_groups_ - 2].variance[r] = square(parameters_.given_rotation);
    place.innovation[r] = away[r];
    place.variance[r] = square(parameters_.given_place);
  }
  groups_[used_groups_ - 2].gate = place.gate = 0.0;
}

// A body does not fly off. Ten times a second, with the weight of one independent observation every two correlation
// times: speed changes its mind within a second, place within five.
void BodyFilter::add_priors() {
  const BodyFilterParameters& p = parameters_;
  if (p.root == RootMode::kFixed || p.root == RootMode::kGiven) {
    return;
  }
  const auto hold = [&](int first, const Vector3d& value, double sigma) {
    MeasurementGroup& g = group(3, 0);
    append_block(g, first, Matrix3d::Identity());
    g.gate = 0.0;
    for (int r = 0; r < 3; ++r) {
      g.innovation[r] = -value[r];
      g.variance[r] = sigma * sigma;
    }
  };
  if (p.root_speed > 0.0) {
    hold(layout_.dofs, state_.joints.qd.head<3>(), p.root_speed * std::sqrt(2.0 * 1.0 * 10.0));
  }
  if (p.root_reach > 0.0) {
    hold(0, state_.joints.q.head<3>() - model_.skeleton.segments.front().p_PL,
         p.root_reach * std::sqrt(2.0 * 5.0 * 10.0));
  }
}

// Beyond a limit the joint is pulled back, as strongly as the softness says; inside nothing happens.
void BodyFilter::add_limits() {
  const double softness = parameters_.limit_softness;
  if (softness <= 0.0) {
    return;
  }
  for (std::size_t l = 0; l < tree_.links().size(); ++l) {
    const body::TreeLink& link = tree_.links()[l];
    if (link.count == 0 || link.parent < 0 || link.kind == body::LinkKind::kTranslation ||
        (link.segment == 0 && tree_.root_motion() == body::RootMotion::kFree)) {
      continue;
    }
    const body::Joint& joint = model_.skeleton.segments[static_cast<std::size_t>(link.segment)].joint;
    const bool ball = link.kind == body::LinkKind::kBall;
    const Vector3d phi =
        ball ? geometry::log_so3(state_.joints.R_joint[l]) : Vector3d(state_.joints.q[link.first], 0, 0);
    const Matrix3d J = ball ? geometry::right_jacobian_inverse(phi) : Matrix3d::Identity();
    for (int i = 0; i < link.count; ++i) {
      const int axis = ball ? i : link.axis_index;
      const double beyond = phi[i] > joint.maximum[axis]
                                ? joint.maximum[axis] - phi[i]
                                : (phi[i] < joint.minimum[axis] ? joint.minimum[axis] - phi[i] : 0.0);
      if (beyond == 0.0) {
        continue;
      }
      MeasurementGroup& g = group(1, 0);
      g.gate = 0.0;
      g.innovation[0] = beyond;
      g.variance[0] = square(softness);
      for (int c = 0; c < link.count; ++c) {
        g.support.push_back(link.first + c);
        g.H.push_back(J(i, c));
      }
    }
  }
}

}  // namespace limbwave::estimate
