#include "interchange/bvh_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "interchange/half_angles.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Joints whose position channels move less than this, metres, are rigid: the rest is how files round.
constexpr double kRigid = 1e-5;
// Squares of lengths this near 1 are 1: products of unit quaternions need no root then.
constexpr double kUnit = 1e-14;

Quaterniond to_file_axes(const Quaterniond& R, UpAxis up) {
  return up == UpAxis::kY ? to_y_up(R) : R;
}

Quaterniond unit(const Quaterniond& R) {
  return std::abs(R.squaredNorm() - 1.0) < kUnit ? R : R.normalized();
}

}  // namespace

BvhKeys::BvhKeys(const std::vector<BvhJoint>& joints, const std::vector<Quaterniond>& R_WL_rest, UpAxis up,
                 double scale)
    : up_(up), scale_(scale), plans_(joints.size()) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    Plan& plan = plans_[i];
    plan.first = first;
    plan.channels = joints[i].channels;
    plan.count = joints[i].channel_count;
    plan.offset = joints[i].offset;
    plan.L = R_WL_rest[i];
    plan.P_inverse = joints[i].parent < 0 ? Quaterniond::Identity()
                                          : R_WL_rest[static_cast<std::size_t>(joints[i].parent)].conjugate();
    plan.before = to_file_axes(plan.P_inverse, up);
    plan.after = to_file_axes(plan.L, up);
    for (std::size_t c = 0; c < plan.count; ++c) {
      (plan.channels[c] < BvhChannel::kXRotation ? plan.moves : plan.turns) = true;
    }
    first += plan.count;
  }
  channels_ = first;
  sines_.resize(channels_);
  cosines_.resize(channels_);
}

void BvhKeys::reserve(std::size_t frames) {
  for (Plan& plan : plans_) {
    if (plan.turns) {
      plan.rotations.reserve(frames);
    }
  }
}

void BvhKeys::add(const std::vector<double>& values) {
  half_angles(values, sines_, cosines_);
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    Plan& plan = plans_[i];
    if (plan.turns) {
      plan.rotations.push_back(unit(to_world_axes(rotation(plan), up_)));
    }
    if (plan.moves) {
      const Vector3d p = position(plan, values);
      if (i == 0) {
        root_.push_back(to_world_axes(p, up_) * scale_);
      } else {
        plan.positions.push_back(p);
        plan.sum += p;
        plan.lowest = plan.lowest.cwiseMin(p);
        plan.highest = plan.highest.cwiseMax(p);
      }
    }
  }
  ++frames_;
}

void BvhKeys::finish(motion::Clip& clip, double frame_time, Diagnostics& diagnostics) {
  std::vector<double> times(frames_);
  for (std::size_t i = 0; i < frames_; ++i) {
    times[i] = static_cast<double>(i) * frame_time;
  }
  clip.joints.resize(plans_.size());
  double worst = 0.0;
  std::size_t worst_joint = 0;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    Plan& plan = plans_[i];
    if (plan.turns && frames_ > 0) {
      clip.joints[i].rotation.values = std::move(plan.rotations);
      clip.joints[i].rotation.times = times;
    }
    if (plan.moves && i > 0 && frames_ > 0) {
      // Most programs write the whole position, some what is added to OFFSET: what lies nearer is meant.
      const Vector3d mean = plan.sum / static_cast<double>(frames_);
      const bool added = mean.norm() < (mean - plan.offset).norm();
      clip.skeleton.segments[i].p_PL =
          plan.P_inverse * to_world_axes(Vector3d(added ? plan.offset + mean : mean), up_) * scale_;
      const double movement = (plan.highest - plan.lowest).norm() * scale_;
      if (movement > kRigid) {
        for (Vector3d& p : plan.positions) {
          p = plan.P_inverse * to_world_axes(Vector3d(added ? p + plan.offset : p), up_) * scale_;
        }
        clip.joints[i].position.values = std::move(plan.positions);
        clip.joints[i].position.times = times;
      }
      if (movement > worst) {
        worst = movement;
        worst_joint = i;
      }
    }
  }
  if (!root_.empty()) {
    clip.root_position.values = std::move(root_);
    clip.root_position.times = std::move(times);
  }
  if (worst > kRigid) {
    diagnostics.push_back(
        {Severity::kWarning, "bvh.joint-slides",
         fmt::format("joints slide in their parents, \"{}\" by {:.2f} mm; the skeleton has their mean places",
                     clip.skeleton.segments[worst_joint].name, worst * 1e3),
         "", ""});
  }
}

Quaterniond BvhKeys::rotation(const Plan& plan) const {
  Quaterniond R = plan.before;
  for (std::size_t c = 0; c < plan.count; ++c) {
    if (plan.channels[c] < BvhChannel::kXRotation) {
      continue;
    }
    const double cosine = cosines_[plan.first + c];
    const double sine = sines_[plan.first + c];
    // R times the rotation about one axis, without the products that are zero.
    if (plan.channels[c] == BvhChannel::kXRotation) {
      R = {R.w() * cosine - R.x() * sine, R.x() * cosine + R.w() * sine, R.y() * cosine + R.z() * sine,
           R.z() * cosine - R.y() * sine};
    } else if (plan.channels[c] == BvhChannel::kYRotation) {
      R = {R.w() * cosine - R.y() * sine, R.x() * cosine - R.z() * sine, R.y() * cosine + R.w() * sine,
           R.z() * cosine + R.x() * sine};
    } else {
      R = {R.w() * cosine - R.z() * sine, R.x() * cosine + R.y() * sine, R.y() * cosine - R.x() * sine,
           R.z() * cosine + R.w() * sine};
    }
  }
  return R * plan.after;
}

Vector3d BvhKeys::position(const Plan& plan, const std::vector<double>& values) {
  Vector3d p = plan.offset;  // stays where a component has no channel
  for (std::size_t c = 0; c < plan.count; ++c) {
    if (plan.channels[c] < BvhChannel::kXRotation) {
      p[static_cast<int>(plan.channels[c])] = std::clamp(values[plan.first + c], -kBvhLargestLength, kBvhLargestLength);
    }
  }
  return p;
}

}  // namespace limbwave::interchange
