#include "interchange/bvh_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/files.h"
#include "geometry/so3.h"
#include "interchange/bvh_hierarchy.h"
#include "interchange/bvh_keys.h"
#include "interchange/frame_rate.h"
#include "interchange/text_scan.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Where each bone points at rest, in world axes and file units; zero when nothing says.
std::vector<Vector3d> bone_vectors(const std::vector<BvhJoint>& joints, UpAxis up) {
  std::vector<Vector3d> sums(joints.size(), Vector3d::Zero());
  std::vector<int> children(joints.size(), 0);
  for (const BvhJoint& joint : joints) {
    if (joint.parent >= 0) {
      sums[static_cast<std::size_t>(joint.parent)] += to_world_axes(joint.offset, up);
      ++children[static_cast<std::size_t>(joint.parent)];
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (children[i] > 0) {
      sums[i] /= children[i];
    } else if (joints[i].end) {
      sums[i] = to_world_axes(*joints[i].end, up);
    }
  }
  return sums;
}

// Orientations of all frames L at rest, in the world.
std::vector<Quaterniond> rest_frames(const std::vector<BvhJoint>& joints, const std::vector<Vector3d>& bones,
                                     BoneFrames frames) {
  std::vector<Quaterniond> R_WL(joints.size(), Quaterniond::Identity());
  if (frames == BoneFrames::kFile) {
    return R_WL;
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    // Turned from the parent's frame by the smallest angle, so that rolls follow the chain.
    const Quaterniond parent =
        joints[i].parent < 0 ? Quaterniond::Identity() : R_WL[static_cast<std::size_t>(joints[i].parent)];
    const bool has_direction = bones[i].norm() > 1e-9;
    R_WL[i] =
        has_direction ? (geometry::shortest_arc(parent * Vector3d::UnitX(), bones[i]) * parent).normalized() : parent;
  }
  return R_WL;
}

struct MotionHead {
  std::size_t frames = 0;
  double frame_time = 0.0;
  double rate = 0.0;
};

// "Frames: N" and "Frame Time: T".
Result<MotionHead> read_head(TextScanner& scanner) {
  MotionHead head;
  bool has_frames = false;
  bool has_time = false;
  while (!has_frames || !has_time) {
    const std::string_view word = scanner.word();
    const bool frames = same_word(word, "Frames");
    const bool time = same_word(word, "Frame") && same_word(scanner.word(), "Time");
    if (!frames && !time) {
      return scanner.error("\"Frames:\" and \"Frame Time:\" must follow MOTION", "check that the file is whole");
    }
    if (scanner.peek_word() == ":") {
      scanner.word();
    }
    scanner.skip_blanks();
    double value = 0.0;
    const std::string_view digits = scanner.peek_word();
    if (!scanner.number(value)) {
      return scanner.error(fmt::format("{} stands where a number belongs", scanner.here()), "correct it there");
    }
    if (frames) {
      if (!(value >= 0.0) || value != std::floor(value)) {
        return scanner.error(fmt::format("{} is not a number of frames", value), "count the lines that follow");
      }
      // What is more than a double counts exactly is more than any file holds.
      head.frames = static_cast<std::size_t>(std::min(value, 9e15));
      has_frames = true;
    } else {
      if (!(value >= 1e-7 && value <= 1e4)) {
        return scanner.error(fmt::format("a Frame Time of {} s makes no sense", value),
                             "give the seconds from frame to frame, for example 0.0166667");
      }
      head.rate = frame_rate_from_text(value, digits);
      head.frame_time = 1.0 / head.rate;
      has_time = true;
    }
  }
  return head;
}

enum class Line { kWhole, kBrokenOff };

// One frame, which is one line.
Result<Line> read_line(TextScanner& scanner, std::size_t frame, std::vector<double>& values) {
  for (std::size_t c = 0; c < values.size(); ++c) {
    scanner.skip_blanks();
    if (scanner.at_line_end()) {
      const Error error = scanner.error(fmt::format("frame {} has {} values instead of {}", frame, c, values.size()),
                                        "check the CHANNELS of the hierarchy and that the file is whole");
      scanner.skip_space();
      return scanner.at_end() ? Result<Line>(Line::kBrokenOff) : Result<Line>(error);
    }
    if (!scanner.number(values[c])) {
      return scanner.error(fmt::format("{} is not a number", scanner.here()),
                           "write numbers with a decimal point and spaces between them");
    }
  }
  scanner.skip_blanks();
  if (!scanner.at_line_end()) {
    return scanner.error(fmt::format("frame {} has more than {} values", frame, values.size()),
                         "check the CHANNELS of the hierarchy");
  }
  return Line::kWhole;
}

// All frames; the count that was declared is only a hint.
Status read_frames(TextScanner& scanner, const MotionHead& head, std::size_t skip, BvhKeys& keys,
                   Diagnostics& diagnostics) {
  std::vector<double> values(keys.channels());
  // Every value takes at least two characters: no more can come.
  const std::size_t possible = std::min(head.frames, scanner.left() / (2 * values.size()) + 1);
  keys.reserve(possible > skip ? possible - skip : 0);
  std::size_t frames = 0;
  for (scanner.skip_space(); !scanner.at_end(); scanner.skip_space()) {
    const Result<Line> line = read_line(scanner, frames + 1, values);
    if (!line) {
      return line.error();
    }
    if (*line == Line::kBrokenOff) {
      diagnostics.push_back({Severity::kWarning, "bvh.truncated", "the file breaks off inside its last frame",
                             "check that it was copied whole", fmt::format("line {}", scanner.line())});
      break;
    }
    if (frames++ >= skip) {
      keys.add(values);
    }
  }
  if (frames != head.frames) {
    diagnostics.push_back({Severity::kWarning, "bvh.frame-count",
                           fmt::format("the file says {} frames and has {}", head.frames, frames),
                           "check that it was copied whole", ""});
  }
  return {};
}

void set_scale(body::Skeleton& skeleton, double scale) {
  for (body::Segment& segment : skeleton.segments) {
    segment.p_PL *= scale;
    segment.length *= scale;
  }
}

}  // namespace

double guess_metres_per_unit(const body::Skeleton& in_file_units) {
  if (in_file_units.segments.empty()) {
    return kMetresPerCentimetre;
  }
  Vector3d lowest = Vector3d::Constant(INFINITY);
  Vector3d highest = Vector3d::Constant(-INFINITY);
  const std::vector<body::SegmentPose> poses = motion::rest_poses(in_file_units);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector3d end = poses[i].p_WL + poses[i].R_WL * Vector3d(in_file_units.segments[i].length, 0.0, 0.0);
    lowest = lowest.cwiseMin(poses[i].p_WL).cwiseMin(end);
    highest = highest.cwiseMax(poses[i].p_WL).cwiseMax(end);
  }
  const double size = (highest - lowest).maxCoeff();
  if (!(size > 0.0)) {
    return kMetresPerCentimetre;
  }
  const bool person = in_file_units.segments.size() >= 12;
  const double expected = person ? 1.7 : 0.7;
  double best = kMetresPerCentimetre;
  double best_distance = INFINITY;
  for (const double unit : {1.0, kMetresPerCentimetre, 0.001, kMetresPerCmuUnit}) {
    const double distance = std::abs(std::log(size * unit / expected));
    if (distance < best_distance && (person || unit != kMetresPerCmuUnit)) {
      best_distance = distance;
      best = unit;
    }
  }
  return best;
}

Result<motion::Clip> read_bvh(std::string_view text, const std::string& place, const BvhReadOptions& options) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return Error{"is UTF-16 text", place, "save it as UTF-8"};
  }
  if (text.starts_with("\xEF\xBB\xBF")) {
    text.remove_prefix(3);
  }
  Diagnostics unread;
  Diagnostics& diagnostics = options.diagnostics != nullptr ? *options.diagnostics : unread;
  const std::size_t diagnostics_before = diagnostics.size();
  TextScanner scanner(text, place);
  const Result<std::vector<BvhJoint>> joints = read_bvh_hierarchy(scanner, diagnostics);
  if (!joints) {
    return joints.error();
  }

  motion::Clip clip;
  const std::vector<Vector3d> bones = bone_vectors(*joints, options.up);
  const std::vector<Quaterniond> R_WL_rest = rest_frames(*joints, bones, options.frames);
  for (std::size_t i = 0; i < joints->size(); ++i) {
    const BvhJoint& joint = (*joints)[i];
    const Quaterniond P_inverse =
        joint.parent < 0 ? Quaterniond::Identity() : R_WL_rest[static_cast<std::size_t>(joint.parent)].conjugate();
    body::Segment segment;
    segment.name = joint.name;
    segment.parent = joint.parent;
    segment.joint.kind = joint.channel_count == 0 && i > 0 ? body::JointKind::kFixed : body::JointKind::kSpherical;
    segment.p_PL = P_inverse * to_world_axes(joint.offset, options.up);
    segment.R_PL_rest = (P_inverse * R_WL_rest[i]).normalized();
    segment.length = bones[i].norm();
    clip.skeleton.segments.push_back(std::move(segment));
  }
  const double scale = options.metres_per_unit.value_or(guess_metres_per_unit(clip.skeleton));
  if (!(std::isfinite(scale) && scale > 0.0)) {
    return Error{fmt::format("{} metres per unit is not a scale", scale), place, "give a positive number"};
  }
  set_scale(clip.skeleton, scale);

  BvhKeys keys(*joints, R_WL_rest, options.up, scale);
  const Result<MotionHead> head = read_head(scanner);
  if (!head) {
    return head.error();
  }
  if (keys.channels() == 0) {
    return scanner.error("no joint has channels", "check the CHANNELS of the hierarchy");
  }
  if (Status status = read_frames(scanner, *head, options.skip_frames, keys, diagnostics); !status) {
    return status.error();
  }
  clip.frame_rate_hz = head->rate;
  keys.finish(clip, head->frame_time, diagnostics);
  for (std::size_t i = diagnostics_before; i < diagnostics.size(); ++i) {
    std::string& where = diagnostics[i].place;
    where.insert(0, where.empty() ? place : fmt::format("{}, ", place));
  }
  return clip;
}

Result<motion::Clip> load_bvh(const std::filesystem::path& path, const BvhReadOptions& options) {
  const Result<std::string> text = read_file(path);
  if (!text) {
    return text.error();
  }
  Result<motion::Clip> clip = read_bvh(*text, path.string(), options);
  if (clip) {
    clip->name = path.stem().string();
    clip->skeleton.name = clip->name;
  }
  return clip;
}

}  // namespace limbwave::interchange
