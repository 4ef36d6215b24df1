#include "simulate/driver_box_actor.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"
#include "simulate/bvh_motion.h"
#include "simulate/random.h"

namespace limbwave::simulate {
namespace {

constexpr double kGap = 2.0;  // seconds of the way back to the beginning

double drawn(Random& random, double sigma) {
  return sigma * std::clamp(random.normal(), -3.0, 3.0);
}

Vector3d drawn_vector(Random& random, double sigma) {
  const double x = drawn(random, sigma);
  const double y = drawn(random, sigma);
  const double z = drawn(random, sigma);
  return {x, y, z};
}

// Draws how things of one kind really sit; a stream of its own for every kind and error.
class Placing {
 public:
  Placing(const DriverBoxErrors& errors, std::uint64_t seed, const std::string& kind)
      : errors_(errors),
        angle_(seed, kind + " angle"),
        offset_(seed, kind + " offset"),
        phase_(seed, kind + " tissue") {}

  WornPlace place(int segment, const Quaterniond& R_LS, const Vector3d& p_LS) {
    WornPlace place;
    place.segment = segment;
    place.R_LS = R_LS * geometry::exp_so3(drawn_vector(angle_, errors_.mount_angle));
    place.p_LS = p_LS + drawn_vector(offset_, errors_.mount_offset);
    place.wobble_angle = errors_.soft_tissue_angle;
    place.wobble_offset = errors_.soft_tissue_offset;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      place.angle_phase[axis] = phase_.uniform(0.0, 2.0 * kPi);
      place.offset_phase[axis] = phase_.uniform(0.0, 2.0 * kPi);
    }
    return place;
  }

 private:
  const DriverBoxErrors& errors_;
  Random angle_, offset_, phase_;
};

body::Skeleton real_bones(const body::Skeleton& skeleton, double sigma, std::uint64_t seed) {
  Random random(seed, "bones");
  body::Skeleton real = skeleton;
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const double factor = 1.0 + drawn(random, sigma);
    if (factor != 1.0) {
      const double length = factor * real.segments[i].length;
      real = body::with_length(std::move(real), static_cast<int>(i), length);
    }
  }
  return real;
}

}  // namespace

Result<std::shared_ptr<const DriverBoxActor>> DriverBoxActor::create(
    const std::string& motion, double motion_metres_per_unit, const body::Rig& rig, const body::Skeleton& skeleton,
    const DriverBoxErrors& errors, std::uint64_t seed, double rest_s) {
  std::shared_ptr<DriverBoxActor> actor(new DriverBoxActor);
  actor->skeleton_ = real_bones(skeleton, errors.bone_length, seed);
  std::shared_ptr<const BodyMotion> once;
  if (motion.ends_with(".bvh") || motion.ends_with(".BVH")) {
    const auto bvh = load_bvh_motion(motion, skeleton, motion_metres_per_unit);
    if (!bvh) {
      return bvh.error();
    }
    once = *bvh;
  } else {
    const auto builtin = make_builtin_motion(motion, skeleton, seed);
    if (!builtin) {
      return builtin.error();
    }
    once = *builtin;
  }
  actor->motion_.keep_to_joints_of(skeleton);
  if (rest_s > 0.0) {
    actor->motion_.append(
        std::make_shared<PoseMotion>(skeleton, std::vector<HeldPose>{{standing(skeleton), 0.0, rest_s}}), 0.0);
  }
  actor->loop_start_ = actor->motion_.append(once, rest_s > 0.0 ? kGap : 0.0);
  actor->duration_ = actor->motion_.duration();
  actor->loop_end_ = actor->motion_.append(once, kGap);

  Random rest(seed, "rest pose");
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const Vector3d axis = drawn_vector(rest, 1.0).normalized();
    // A pose is off within what the joint can do.
    const body::Joint& joint = skeleton.segments[i].joint;
    Vector3d off = i == 0 ? Vector3d::Zero() : Vector3d(axis * errors.rest_pose);
    if (joint.kind == body::JointKind::kFixed) {
      off.setZero();
    } else if (joint.kind == body::JointKind::kHinge) {
      off = joint.axis * (axis.x() < 0.0 ? -errors.rest_pose : errors.rest_pose);
    } else if (joint.kind == body::JointKind::kUniversal) {
      off = joint.axis2 * (axis.x() < 0.0 ? -errors.rest_pose : errors.rest_pose);
    }
    actor->rest_error_.push_back(geometry::exp_so3(off));
    std::vector<int> chain;
    for (int s = static_cast<int>(i); s >= 0; s = skeleton.segments[static_cast<std::size_t>(s)].parent) {
      chain.push_back(s);
    }
    std::reverse(chain.begin(), chain.end());
    actor->chains_.push_back(std::move(chain));
  }
  Placing boards(errors, seed, "board");
  for (const body::Gyroscope& board : rig.gyroscopes) {
    actor->boards_.push_back(boards.place(skeleton.find(board.segment), board.R_LS, board.p_LS));
  }
  Placing sources(errors, seed, "source");
  for (const body::Source& source : rig.sources) {
    WornPlace place = sources.place(skeleton.find(source.segment), Quaterniond::Identity(), source.p_LS);
    place.normal_S = source.normal_L;
    actor->sources_.push_back(place);
  }
  for (const auto* places : {&actor->boards_, &actor->sources_}) {
    if (std::any_of(places->begin(), places->end(), [](const WornPlace& place) { return place.segment < 0; })) {
      return Error{"is worn on a segment that the skeleton \"" + skeleton.name + "\" lacks", "rig \"" + rig.name + "\"",
                   "correct the rig"};
    }
  }
  return std::shared_ptr<const DriverBoxActor>(std::move(actor));
}

double DriverBoxActor::folded(double time_s) const {
  return time_s < loop_end_ ? time_s : loop_start_ + std::fmod(time_s - loop_start_, loop_end_ - loop_start_);
}

QuaternionJet DriverBoxActor::rotation(int segment, double time_s) const {
  return motion_.rotation(segment, time_s) * rest_error_[static_cast<std::size_t>(segment)];
}

void DriverBoxActor::frames(double time_s, std::vector<FrameJet>& frames) const {
  const double t = folded(time_s);
  frames.resize(skeleton_.segments.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const body::Segment& segment = skeleton_.segments[i];
    const QuaternionJet R = rotation(static_cast<int>(i), t);
    if (segment.parent < 0) {
      frames[i] = {motion_.root_position(t), R};
    } else {
      const FrameJet& parent = frames[static_cast<std::size_t>(segment.parent)];
      frames[i] = {parent.p_W + rotate(parent.R_W, segment.p_PL), parent.R_W * R};
    }
  }
}

FrameJet DriverBoxActor::frame_of(int segment, double time_s) const {
  const double t = folded(time_s);
  FrameJet frame;
  for (const int i : chains_[static_cast<std::size_t>(segment)]) {
    const body::Segment& own = skeleton_.segments[static_cast<std::size_t>(i)];
    if (own.parent < 0) {
      frame = {motion_.root_position(t), rotation(i, t)};
    } else {
      frame.p_W = frame.p_W + rotate(frame.R_W, own.p_PL);
      frame.R_W = frame.R_W * rotation(i, t);
    }
  }
  return frame;
}

FrameJet DriverBoxActor::placed(const WornPlace& place, const FrameJet& segment) {
  if (place.wobble_angle == 0.0 && place.wobble_offset == 0.0) {
    return {segment.p_W + rotate(segment.R_W, place.p_LS), segment.R_W * place.R_LS};
  }
  const VectorJet up = rotate(conjugate(segment.R_W), Vector3d::UnitZ());
  VectorJet slide;
  QuaternionJet tilt;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Jet u{2.0 * up.v[k], 2.0 * up.d[k], 2.0 * up.dd[k]};
    const Jet angle = place.wobble_angle * sin(u + Jet{place.angle_phase[k], 0.0, 0.0});
    const Jet shift = place.wobble_offset * sin(u + Jet{place.offset_phase[k], 0.0, 0.0});
    tilt = tilt * simulate::rotation(Vector3d::Unit(k), angle);
    slide.v[k] = place.p_LS[k] + shift.v;
    slide.d[k] = shift.d;
    slide.dd[k] = shift.dd;
  }
  return {segment.p_W + rotate(segment.R_W, slide), segment.R_W * tilt * place.R_LS};
}

ChipTruth DriverBoxActor::chip(int board, double time_s) const {
  const WornPlace& place = boards_[static_cast<std::size_t>(board)];
  const FrameJet frame = placed(place, frame_of(place.segment, time_s));
  const Quaterniond back = frame.R_W.v.conjugate();
  // w_S = 2 (q* dq/dt)_vec (Vlasic et al. 2007, §5.2).
  return {2.0 * (back * frame.R_W.d).vec(), back * Vector3d(frame.p_W.dd + Vector3d(0.0, 0.0, kStandardGravity))};
}

}  // namespace limbwave::simulate
