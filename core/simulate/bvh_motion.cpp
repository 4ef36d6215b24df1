#include "simulate/bvh_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/bvh_reader.h"
#include "motion/clip.h"
#include "simulate/bvh_body.h"
#include "simulate/bvh_links.h"

namespace limbwave::simulate {
namespace {

constexpr double kPassHz = 6.0;               // flat to here, closed from twice of it
constexpr double kFastestTurn = 40.0;         // rad/s; no limb turns faster
constexpr double kFastestMove = 12.0;         // m/s
constexpr std::size_t kArtificialStart = 12;  // frames

// A single frame that agrees with neither neighbour, while the neighbours agree with each other, is a fault of the
// file.
void remove_spikes(std::vector<Quaterniond>& R) {
  const auto angle = [&](std::size_t a, std::size_t b) { return geometry::geodesic_angle(R[a], R[b]); };
  for (std::size_t i = 1; i + 1 < R.size(); ++i) {
    const double away = std::min(angle(i - 1, i), angle(i, i + 1));
    if (away > radians(12.0) && away > 3.0 * angle(i - 1, i + 1)) {
      R[i] = R[i - 1].slerp(0.5, R[i + 1]);
    }
  }
}

// Where neighbouring frames are further apart than a body can move (`step` gives the distance over its limit), the file
// is wrong there: everything between such places, as far as they are close together, becomes one smooth way from the
// last good frame before to the first one after (`between` gives the frame at a fraction of the way).
template <typename Frame, typename Step, typename Between>
void bridge_faults(std::vector<Frame>& frames, double rate_hz, const Step& step, const Between& between) {
  const auto margin = static_cast<std::size_t>(std::ceil(0.08 * rate_hz));
  const auto together = static_cast<std::size_t>(std::ceil(0.25 * rate_hz));
  const std::vector<Frame> original = frames;
  for (std::size_t i = 0; i + 1 < original.size(); ++i) {
    if (step(original[i], original[i + 1]) <= 1.0) {
      continue;
    }
    std::size_t last = i + 1;
    for (std::size_t k = last; k + 1 < original.size() && k < last + together; ++k) {
      last = step(original[k], original[k + 1]) > 1.0 ? k + 1 : last;
    }
    const std::size_t from = i > margin ? i - margin : 0;
    const std::size_t to = std::min(last + margin, original.size() - 1);
    for (std::size_t k = from + 1; k < to; ++k) {
      const double x = static_cast<double>(k - from) / static_cast<double>(to - from);
      frames[k] = between(original[from], original[to], smooth_step(x).v);
    }
    i = last;
  }
}

// Frames at the start that stand apart from the motion: the joints jump after the last of them.
std::size_t artificial_frames(const std::vector<std::vector<Quaterniond>>& R_PL) {
  std::size_t count = 0;
  for (const std::vector<Quaterniond>& R : R_PL) {
    for (std::size_t i = 0; i < kArtificialStart && i + 2 < R.size(); ++i) {
      const double jump = geometry::geodesic_angle(R[i], R[i + 1]);
      if (jump > radians(15.0) && jump > 6.0 * geometry::geodesic_angle(R[i + 1], R[i + 2])) {
        count = std::max(count, i + 1);
      }
    }
  }
  return count;
}

// The angles of a hinge or universal joint over time: smoothed as angles, it stays what its axes allow.
struct AxisTrack {
  Quaterniond R_PL_rest = Quaterniond::Identity();
  Vector3d axis[2] = {Vector3d::Zero(), Vector3d::Zero()};
  std::vector<double> angle[2];  // empty: none
};

class BvhMotion : public BodyMotion {
 public:
  /// `axes`: one per segment, or none at all.
  BvhMotion(std::vector<std::vector<Quaterniond>> R_PL, const std::vector<Vector3d>& p, double rate_hz,
            const std::vector<AxisTrack>& axes)
      : duration_(static_cast<double>(p.size() - 1) / rate_hz) {
    for (const AxisTrack& track : axes) {
      Axes& own = axes_.emplace_back();
      own.rest = track.R_PL_rest;
      for (std::size_t k = 0; k < 2 && !track.angle[k].empty(); ++k) {
        own.axis[k] = track.axis[k];
        own.angle[k] = SampledCurve(track.angle[k], rate_hz, kPassHz);
        own.count = k + 1;
      }
    }
    for (auto& R : R_PL) {
      std::array<std::vector<double>, 4> parts;
      for (std::size_t i = 0; i < R.size(); ++i) {
        if (i > 0 && R[i].dot(R[i - 1]) < 0.0) {
          R[i].coeffs() = -R[i].coeffs();
        }
        for (std::size_t k = 0; k < 4; ++k) {
          parts[k].push_back(R[i].coeffs()[static_cast<Eigen::Index>(k)]);
        }
      }
      auto& curves = rotations_.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        curves[k] = SampledCurve(parts[k], rate_hz, kPassHz);
      }
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::vector<double> path;
      path.reserve(p.size());
      for (const Vector3d& position : p) {
        path.push_back(position[axis]);
      }
      root_[static_cast<std::size_t>(axis)] = SampledCurve(path, rate_hz, kPassHz);
    }
  }

  [[nodiscard]] double duration() const override { return duration_; }

  [[nodiscard]] QuaternionJet rotation(int segment, double time_s) const override {
    QuaternionJet q;
    if (!axes_.empty() && axes_[static_cast<std::size_t>(segment)].count > 0) {
      const Axes& own = axes_[static_cast<std::size_t>(segment)];
      q.v = own.rest;
      for (std::size_t k = 0; k < own.count; ++k) {
        q = q * simulate::rotation(own.axis[k], own.angle[k].at(time_s));
      }
      return q;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const Jet c = rotations_[static_cast<std::size_t>(segment)][k].at(time_s);
      const auto i = static_cast<Eigen::Index>(k);
      q.v.coeffs()[i] = c.v;
      q.d.coeffs()[i] = c.d;
      q.dd.coeffs()[i] = c.dd;
    }
    return normalized(q);
  }

  [[nodiscard]] VectorJet root_position(double time_s) const override {
    VectorJet p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Jet c = root_[axis].at(time_s);
      const auto i = static_cast<Eigen::Index>(axis);
      p.v[i] = c.v;
      p.d[i] = c.d;
      p.dd[i] = c.dd;
    }
    return p;
  }

 private:
  struct Axes {
    Quaterniond rest = Quaterniond::Identity();
    Vector3d axis[2];
    SampledCurve angle[2];
    std::size_t count = 0;
  };
  std::vector<std::array<SampledCurve, 4>> rotations_;
  std::vector<Axes> axes_;
  std::array<SampledCurve, 3> root_;
  double duration_;
};

}  // namespace

Result<std::shared_ptr<const BodyMotion>> load_bvh_motion(const std::filesystem::path& path,
                                                          const body::Skeleton& skeleton, double metres_per_unit) {
  interchange::BvhReadOptions options;
  options.metres_per_unit = metres_per_unit > 0.0 ? std::optional(metres_per_unit) : std::nullopt;
  options.frames = interchange::BoneFrames::kFile;
  const Result<motion::Clip> clip = interchange::load_bvh(path, options);
  if (!clip) {
    return clip.error();
  }
  const std::vector<BvhLink> links = link_segments(skeleton, clip->skeleton);
  if (std::all_of(links.begin(), links.end(), [](const BvhLink& link) { return link.joint < 0; })) {
    return Error{"has no joint that fits a segment of the skeleton \"" + skeleton.name + "\"", path.string(),
                 "name its joints like the skeleton's segments, or RightArm, RightForeArm, RightHand"};
  }
  const double rate = clip->frame_rate_hz;
  auto frames = static_cast<std::size_t>(std::floor(clip->duration() * rate + 1e-3)) + 1;
  std::vector<std::vector<Quaterniond>> R_PL(links.size());
  std::vector<Vector3d> p;
  std::vector<Eigen::Vector2d> angles;
  std::vector<AxisTrack> axes;
  const bool whole_body = skeleton.find("pelvis") >= 0 && skeleton.find("left_thigh") >= 0;
  for (std::size_t f = 0; f < frames; ++f) {
    const auto poses = motion::pose_at(*clip, static_cast<double>(f) / rate);
    std::vector<Quaterniond> R_WL(links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      const int parent = skeleton.segments[i].parent;
      const Quaterniond R_WP = parent < 0 ? Quaterniond::Identity() : R_WL[static_cast<std::size_t>(parent)];
      const BvhLink& link = links[i];
      R_WL[i] = link.joint < 0 ? R_WP * skeleton.segments[i].R_PL_rest
                               : poses[static_cast<std::size_t>(link.joint)].R_WL * link.R_JL;
      R_PL[i].push_back((R_WP.conjugate() * R_WL[i]).normalized());
    }
    if (whole_body) {
      std::vector<Quaterniond> frame;
      frame.reserve(R_PL.size());
      for (const auto& R : R_PL) {
        frame.push_back(R.back());
      }
      const std::vector<Eigen::Vector2d> before = angles;
      project_on_joints(skeleton, frame, angles);
      axes.resize(links.size());
      for (std::size_t i = 1; i < links.size(); ++i) {
        const body::Segment& segment = skeleton.segments[i];
        const int count = segment.joint.kind == body::JointKind::kHinge       ? 1
                          : segment.joint.kind == body::JointKind::kUniversal ? 2
                                                                              : 0;
        axes[i].R_PL_rest = segment.R_PL_rest;
        axes[i].axis[0] = segment.joint.axis;
        axes[i].axis[1] = segment.joint.axis2;
        for (int k = 0; k < count; ++k) {
          if (!before.empty()) {  // no joint turns faster
            angles[i][k] =
                std::clamp(angles[i][k], before[i][k] - kFastestTurn / rate, before[i][k] + kFastestTurn / rate);
          }
          axes[i].angle[k].push_back(angles[i][k]);
        }
      }
      for (std::size_t i = 0; i < links.size(); ++i) {
        R_PL[i].back() = frame[i];
      }
    }
    p.push_back(poses.front().p_WL);
  }
  const auto artificial = static_cast<std::ptrdiff_t>(artificial_frames(R_PL));
  for (auto& R : R_PL) {
    R.erase(R.begin(), R.begin() + artificial);
  }
  p.erase(p.begin(), p.begin() + artificial);
  for (AxisTrack& track : axes) {
    for (std::vector<double>& angle : track.angle) {
      if (!angle.empty()) {
        angle.erase(angle.begin(), angle.begin() + artificial);
      }
    }
  }
  frames = p.size();
  if (frames < 4) {
    return Error{"has too few frames to move", path.string(), "use a file with at least four"};
  }
  for (auto& R : R_PL) {
    remove_spikes(R);
    bridge_faults(
        R, rate,
        [&](const Quaterniond& a, const Quaterniond& b) {
          return geometry::geodesic_angle(a, b) * rate / kFastestTurn;
        },
        [](const Quaterniond& a, const Quaterniond& b, double x) { return a.slerp(x, b); });
  }
  bridge_faults(
      p, rate, [&](const Vector3d& a, const Vector3d& b) { return (b - a).norm() * rate / kFastestMove; },
      [](const Vector3d& a, const Vector3d& b, double x) { return Vector3d(a + x * (b - a)); });
  // To the skeleton's place, looking along +x as it does at rest.
  const Vector3d forward = R_PL.front().front() * (standing(skeleton).front().conjugate() * Vector3d::UnitX());
  const Quaterniond turn(Eigen::AngleAxisd(-std::atan2(forward.y(), forward.x()), Vector3d::UnitZ()));
  const Vector3d start = p.front();
  const Vector3d place = skeleton.segments.front().p_PL;
  for (std::size_t f = 0; f < frames; ++f) {
    R_PL.front()[f] = turn * R_PL.front()[f];
    p[f] = turn * Vector3d(p[f] - start) + place;
  }
  return std::shared_ptr<const BodyMotion>(std::make_shared<BvhMotion>(std::move(R_PL), p, rate, axes));
}

}  // namespace limbwave::simulate
