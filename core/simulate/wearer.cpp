#include "simulate/wearer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/units.h"
#include "geometry/so3.h"
#include "simulate/bvh_motion.h"
#include "simulate/random.h"
#include "simulate/range_turns.h"

namespace limbwave::simulate {
namespace {

constexpr double kGap = 2.0;       // seconds from one thing to the next
constexpr double kPoseMove = 1.5;  // seconds from pose to pose
constexpr double kPoseHold = 3.0;  // seconds of standing still in a pose
constexpr double kBeforeRange = 1.0;

// Standing still for a while.
std::shared_ptr<const BodyMotion> stand(const body::Skeleton& skeleton, double seconds) {
  return std::make_shared<PoseMotion>(skeleton, std::vector<HeldPose>{{standing(skeleton), 0.0, seconds}});
}

bool ends_with(const std::string& text, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return text.ends_with(ending); });
}

}  // namespace

// Appends one pose sequence for all calibration groups and names the holds.
void Wearer::append_poses(const body::Rig& rig, double pose_angle, std::uint64_t seed) {
  Random random(seed, "poses");
  std::vector<HeldPose> poses{{standing(skeleton_), 0.0, 0.5}};
  std::vector<ScriptSegment> holds;
  double t = 0.5;
  for (const body::CalibrationGroup& group : rig.groups) {
    for (const bool first : {true, false}) {
      const body::LimbPose& asked = first ? group.first : group.second;
      t += kPoseMove;
      HeldPose pose{standing(skeleton_), t, t + kPoseHold};
      for (const int sensor : group.sensors) {
        const Quaterniond exact = geometry::shortest_arc(asked.gravity_L, -Vector3d::UnitZ());
        // Off by that angle about a level axis: about the vertical it would not matter.
        const double heading = random.uniform(0.0, 2.0 * kPi);
        const Vector3d axis(std::cos(heading), std::sin(heading), 0.0);
        const auto segment = static_cast<std::size_t>(sensors_[static_cast<std::size_t>(sensor)].segment);
        pose.R_WL[segment] = geometry::exp_so3(axis * pose_angle) * exact;
      }
      poses.push_back(std::move(pose));
      holds.push_back({"pose:" + group.name + (first ? ":first" : ":second"), t, t + kPoseHold});
      t += kPoseHold;
    }
  }
  t += kPoseMove;
  poses.push_back({standing(skeleton_), t, t + 0.5});
  const double start = body_.append(std::make_shared<PoseMotion>(skeleton_, poses), kGap);
  for (const ScriptSegment& hold : holds) {
    segments_.push_back({hold.name, start + hold.start_s, start + hold.end_s});
  }
}

double Wearer::append_range() {
  range_start_ = body_.append(stand(skeleton_, range_seconds()), kBeforeRange);
  segments_.push_back({"range", range_start_, range_start_ + range_seconds()});
  return range_start_;
}

Result<std::shared_ptr<const Wearer>> Wearer::create(const SimulateSettings& settings, const body::Rig& rig,
                                                     const body::Skeleton& skeleton) {
  std::shared_ptr<Wearer> wearer(new Wearer);
  wearer->skeleton_ = skeleton;
  wearer->sensors_ = draw_sensors(rig, skeleton, settings.errors, settings.seed);
  wearer->sensor_of_segment_.assign(skeleton.segments.size(), -1);
  for (std::size_t s = 0; s < wearer->sensors_.size(); ++s) {
    const int segment = wearer->sensors_[s].segment;
    if (segment < 0) {
      return Error{"is worn on a segment that the skeleton \"" + skeleton.name + "\" lacks",
                   "sensor \"" + wearer->sensors_[s].name + "\"", "correct the rig"};
    }
    wearer->sensor_of_segment_[static_cast<std::size_t>(segment)] = static_cast<int>(s);
    std::vector<int> chain;
    for (int i = segment; i >= 0; i = skeleton.segments[static_cast<std::size_t>(i)].parent) {
      chain.push_back(i);
    }
    std::reverse(chain.begin(), chain.end());
    wearer->chains_.push_back(std::move(chain));
  }

  // Read the motion first: it is what can go wrong.
  const std::string& name = settings.motion;
  std::shared_ptr<const BodyMotion> motion;
  if (ends_with(name, {".bvh", ".BVH"})) {
    const auto bvh = load_bvh_motion(name, skeleton, settings.motion_metres_per_unit);
    if (!bvh) {
      return bvh.error();
    }
    motion = *bvh;
  } else if (std::error_code ignored;
             ends_with(name, {".csv", ".csv.gz", ".txt"}) || std::filesystem::is_directory(name, ignored)) {
    Result<std::vector<ForceLog>> logs = read_force_logs(name, static_cast<int>(wearer->sensors_.size()));
    if (!logs) {
      return logs.error();
    }
    wearer->recording_ = std::make_shared<RecordedForces>(*std::move(logs), static_cast<int>(wearer->sensors_.size()));
    motion = stand(skeleton, wearer->recording_->duration());
  } else if (name != "range" && name != "poses") {
    const auto builtin = make_builtin_motion(name, skeleton, settings.seed);
    if (!builtin) {
      return builtin.error();
    }
    motion = *builtin;
  }

  if (settings.prologue && motion) {
    wearer->body_.append(stand(skeleton, 0.0), 0.0);
    wearer->append_range();
    wearer->append_poses(rig, settings.errors.pose_angle, settings.seed);
  }
  double start = 0.0;
  if (motion) {
    start = wearer->body_.append(motion, kGap);
    wearer->recording_start_ = start;
  } else if (name == "range") {
    wearer->body_.append(stand(skeleton, 0.0), 0.0);
    wearer->append_range();
  } else {
    wearer->append_poses(rig, settings.errors.pose_angle, settings.seed);
  }
  wearer->loop_start_ = start;
  const double own_end = wearer->body_.duration();
  wearer->loop_end_ = own_end;
  if (wearer->recording_) {
    wearer->loop_end_ = std::numeric_limits<double>::infinity();  // every log repeats by itself
  } else if (motion) {
    wearer->loop_end_ = wearer->body_.append(motion, kGap);  // with the way back to the beginning
  }
  wearer->end_ = settings.seconds > 0.0 ? start + settings.seconds : own_end;
  wearer->segments_.push_back({"capture", start, wearer->end_});
  return std::shared_ptr<const Wearer>(std::move(wearer));
}

double Wearer::folded(double time_s) const {
  if (time_s < loop_end_) {
    return time_s;
  }
  return loop_start_ + std::fmod(time_s - loop_start_, loop_end_ - loop_start_);
}

// Position of a sensor on the moving body, and how it is turned.
Wearer::Placement Wearer::placement(int sensor, double time_s) const {
  const auto s = static_cast<std::size_t>(sensor);
  const ActualSensor& actual = sensors_[s];
  VectorJet p;
  QuaternionJet R_WL;
  for (const int i : chains_[s]) {
    const body::Segment& segment = skeleton_.segments[static_cast<std::size_t>(i)];
    if (segment.parent < 0) {
      p = body_.root_position(time_s);
      R_WL = body_.rotation(i, time_s);
    } else {
      p = p + rotate(R_WL, segment.p_PL);
      R_WL = R_WL * body_.rotation(i, time_s);
    }
  }
  if (actual.wobble_angle == 0.0 && actual.wobble_offset == 0.0) {
    return {p + rotate(R_WL, actual.p_LS), R_WL * actual.R_LS};
  }
  // The skin slides with the direction of "up" in the limb's frame.
  const VectorJet up = rotate(conjugate(R_WL), Vector3d::UnitZ());
  VectorJet slide;
  QuaternionJet tilt;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Jet u{2.0 * up.v[k], 2.0 * up.d[k], 2.0 * up.dd[k]};
    const Jet angle = actual.wobble_angle * sin(u + Jet{actual.angle_phase[k], 0.0, 0.0});
    const Jet shift = actual.wobble_offset * sin(u + Jet{actual.offset_phase[k], 0.0, 0.0});
    tilt = tilt * rotation(Vector3d::Unit(k), angle);
    slide.v[k] = actual.p_LS[k] + shift.v;
    slide.d[k] = shift.d;
    slide.dd[k] = shift.dd;
  }
  return {p + rotate(R_WL, slide), R_WL * tilt * actual.R_LS};
}

Vector3d Wearer::worn_force(int sensor, double time_s) const {
  const Placement at = placement(sensor, time_s);
  return at.R_WS.v.conjugate() * Vector3d(at.p_WS.dd + Vector3d(0.0, 0.0, kStandardGravity));
}

Vector3d Wearer::specific_force(int sensor, double time_s) const {
  const double t = folded(time_s);
  if (range_start_ >= 0.0 && t >= range_start_ && t < range_start_ + range_seconds()) {
    const QuaternionJet R_WS = range_rotation(t - range_start_, placement(sensor, t).R_WS.v);
    return R_WS.v.conjugate() * (range_jerk(t - range_start_) + Vector3d(0.0, 0.0, kStandardGravity));
  }
  if (recording_ && t > recording_start_ - kGap) {
    Vector3d felt = recording_->force(sensor, t - recording_start_);
    if (t >= recording_start_) {
      return felt;
    }
    const double s = smooth_step(t, recording_start_ - kGap, kGap).v;
    return (1.0 - s) * worn_force(sensor, t) + s * felt;
  }
  return worn_force(sensor, t);
}

std::optional<Quaterniond> Wearer::orientation(int segment, double time_s) const {
  const double t = folded(time_s);
  if (range_start_ >= 0.0 && t >= range_start_ && t < range_start_ + range_seconds()) {
    return std::nullopt;
  }
  if (recording_ && t > recording_start_ - kGap) {
    const int sensor = sensor_of_segment_[static_cast<std::size_t>(segment)];
    const auto R_WS =
        sensor < 0 || t < recording_start_ ? std::nullopt : recording_->orientation(sensor, t - recording_start_);
    if (!R_WS) {
      return std::nullopt;
    }
    return (*R_WS * sensors_[static_cast<std::size_t>(sensor)].R_LS.conjugate()).normalized();
  }
  Quaterniond R_WL = Quaterniond::Identity();
  for (int i = segment; i >= 0; i = skeleton_.segments[static_cast<std::size_t>(i)].parent) {
    R_WL = body_.rotation(i, t).v * R_WL;
  }
  return R_WL.normalized();
}

std::vector<body::SegmentPose> Wearer::poses(double time_s) const {
  std::vector<Quaterniond> R_WL = standing(skeleton_);
  for (std::size_t i = 0; i < R_WL.size(); ++i) {
    R_WL[i] = orientation(static_cast<int>(i), time_s).value_or(R_WL[i]);
  }
  return body::poses_from_orientations(skeleton_, R_WL, body_.root_position(folded(time_s)).v);
}

Vector3d Wearer::sensor_position(int sensor, double time_s) const {
  return placement(sensor, folded(time_s)).p_WS.v;
}

}  // namespace limbwave::simulate
