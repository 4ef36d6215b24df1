#include "simulate/motions.h"

#include <algorithm>
#include <cassert>

#include "geometry/so3.h"
#include "simulate/joint_blend.h"

namespace limbwave::simulate {

JointMotion::JointMotion(const body::Skeleton& skeleton)
    : turns_(skeleton.segments.size()), root_offset_(skeleton.segments.front().p_PL) {
  for (const body::Segment& segment : skeleton.segments) {
    rest_.push_back(segment.R_PL_rest);
  }
}

Curve& JointMotion::turn(int segment, const Vector3d& axis) {
  auto& turns = turns_[static_cast<std::size_t>(segment)];
  turns.push_back(std::make_unique<Turn>(Turn{axis.normalized(), {}}));
  return turns.back()->angle;
}

QuaternionJet JointMotion::rotation(int segment, double time_s) const {
  QuaternionJet R;
  R.v = rest_[static_cast<std::size_t>(segment)];
  for (const auto& turn : turns_[static_cast<std::size_t>(segment)]) {
    R = R * simulate::rotation(turn->axis, turn->angle.at(time_s));
  }
  return R;
}

VectorJet JointMotion::root_position(double time_s) const {
  VectorJet p;
  p.v = root_offset_;
  for (int i = 0; i < 3; ++i) {
    const Jet c = root_[i].at(time_s);
    p.v[i] += c.v;
    p.d[i] = c.d;
    p.dd[i] = c.dd;
  }
  return p;
}

PoseMotion::PoseMotion(const body::Skeleton& skeleton, const std::vector<HeldPose>& poses)
    : root_offset_(skeleton.segments.front().p_PL) {
  assert(!poses.empty());
  for (const HeldPose& pose : poses) {
    assert(pose.R_WL.size() == skeleton.segments.size());
    Key key{pose.start_s, pose.end_s, {}, {}, {}};
    for (std::size_t i = 0; i < pose.R_WL.size(); ++i) {
      const int parent = skeleton.segments[i].parent;
      const Quaterniond R_PW =
          parent < 0 ? Quaterniond::Identity() : pose.R_WL[static_cast<std::size_t>(parent)].conjugate();
      key.R_PL.push_back((R_PW * pose.R_WL[i]).normalized());
    }
    keys_.push_back(std::move(key));
  }
  for (std::size_t k = 0; k + 1 < keys_.size(); ++k) {
    for (std::size_t i = 0; i < keys_[k].R_PL.size(); ++i) {
      const Vector3d way = geometry::log_so3(keys_[k].R_PL[i].conjugate() * keys_[k + 1].R_PL[i]);
      keys_[k].angle.push_back(way.norm());
      keys_[k].axis.emplace_back(way.norm() > 0.0 ? Vector3d(way.normalized()) : Vector3d::UnitX());
    }
  }
  duration_ = keys_.back().end;
}

QuaternionJet PoseMotion::rotation(int segment, double time_s) const {
  const auto i = static_cast<std::size_t>(segment);
  const auto next =
      std::upper_bound(keys_.begin(), keys_.end(), time_s, [](double t, const Key& key) { return t < key.start; });
  QuaternionJet R;
  const Key& key = next == keys_.begin() ? keys_.front() : *(next - 1);
  R.v = key.R_PL[i];
  if (next != keys_.begin() && next != keys_.end() && time_s > key.end) {
    R = key.R_PL[i] *
        simulate::rotation(key.axis[i], key.angle[i] * smooth_step(time_s, key.end, next->start - key.end));
  }
  return R;
}

VectorJet PoseMotion::root_position(double /*time_s*/) const {
  return {root_offset_, Vector3d::Zero(), Vector3d::Zero()};
}

double SequenceMotion::append(std::shared_ptr<const BodyMotion> motion, double gap_s) {
  const double start = parts_.empty() ? 0.0 : parts_.back().end + gap_s;
  const double length = motion->duration();
  parts_.push_back({std::move(motion), start, start + length});
  return start;
}

double SequenceMotion::duration() const {
  return parts_.empty() ? 0.0 : parts_.back().end;
}

std::size_t SequenceMotion::part_before(double time_s) const {
  std::size_t index = 0;
  while (index + 1 < parts_.size() && time_s >= parts_[index + 1].start) {
    ++index;
  }
  return index;
}

QuaternionJet SequenceMotion::rotation(int segment, double time_s) const {
  const std::size_t i = part_before(time_s);
  const Part& a = parts_[i];
  QuaternionJet qa = a.motion->rotation(segment, time_s - a.start);
  if (time_s <= a.end || i + 1 == parts_.size()) {
    return qa;
  }
  const Part& b = parts_[i + 1];
  const QuaternionJet qb = b.motion->rotation(segment, time_s - b.start);
  const Jet weight = smooth_step(time_s, a.end, b.start - a.end);
  return skeleton_.segments.empty() ? blend(qa, qb, weight)
                                    : blend(skeleton_.segments[static_cast<std::size_t>(segment)], qa, qb, weight);
}

VectorJet SequenceMotion::root_position(double time_s) const {
  const std::size_t i = part_before(time_s);
  const Part& a = parts_[i];
  VectorJet pa = a.motion->root_position(time_s - a.start);
  if (time_s <= a.end || i + 1 == parts_.size()) {
    return pa;
  }
  const Part& b = parts_[i + 1];
  const Jet s = smooth_step(time_s, a.end, b.start - a.end);
  return Jet{1.0 - s.v, -s.d, -s.dd} * pa + s * b.motion->root_position(time_s - b.start);
}

std::vector<Quaterniond> standing(const body::Skeleton& skeleton) {
  const std::vector<Quaterniond> rest(skeleton.segments.size(), Quaterniond::Identity());
  std::vector<Quaterniond> R_WL;
  for (const body::SegmentPose& pose : body::poses_from_joints(skeleton, rest, Vector3d::Zero())) {
    R_WL.push_back(pose.R_WL);
  }
  return R_WL;
}

}  // namespace limbwave::simulate
