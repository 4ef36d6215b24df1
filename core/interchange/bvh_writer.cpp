#include "interchange/bvh_writer.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

#include "base/atomic_file.h"
#include "base/byte_sink.h"
#include "base/units.h"
#include "interchange/euler.h"
#include "interchange/file_axes.h"
#include "interchange/frame_rate.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Digits after the point. A millionth of a degree moves the end of a metre by 2e-8 m.
constexpr int kAngleDigits = 6;
constexpr int kCentimetreDigits = 6;
constexpr int kMetreDigits = 8;
// Cancelling is asked for once in so many frames.
constexpr std::size_t kFramesPerReport = 1024;
// What is written at once: long clips are more text than should lie in memory.
constexpr std::size_t kPiece = std::size_t{1} << 20;

class BvhText {
 public:
  BvhText(const motion::Clip& clip, const BvhWriteOptions& options, ByteSink& sink)
      : clip_(clip),
        segments_(clip.skeleton.segments),
        fps_(options.fps > 0.0 ? options.fps : clip.frame_rate_hz),
        unit_(options.unit == BvhUnit::kCentimetres ? 100.0 : 1.0),
        digits_(options.unit == BvhUnit::kCentimetres ? kCentimetreDigits : kMetreDigits),
        order_(options.order == BvhRotationOrder::kZXY ? kZXY : kZYX),
        children_(segments_.size()),
        sink_(sink) {
    for (const body::SegmentPose& pose : motion::rest_poses(clip.skeleton)) {
      R_WL_rest_.push_back(pose.R_WL);
    }
    UniqueNames unique;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      names_.push_back(unique(plain_name(segments_[i].name)));
      if (segments_[i].parent >= 0) {
        children_[static_cast<std::size_t>(segments_[i].parent)].push_back(i);
      }
    }
  }

  void hierarchy() {
    text_ += "HIERARCHY\n";
    // Depth first without recursion: a joint is opened when it is met and closed after its last child. Files list
    // channels in this order, which need not be that of the segments.
    struct Open {
      std::size_t joint;
      std::size_t next_child;
    };
    std::vector<Open> open;
    begin_joint(0, 0);
    open.push_back({0, 0});
    while (!open.empty()) {
      Open& top = open.back();
      if (top.next_child < children_[top.joint].size()) {
        const std::size_t child = children_[top.joint][top.next_child++];
        begin_joint(child, open.size());
        open.push_back({child, 0});
      } else {
        if (children_[top.joint].empty()) {
          end_site(top.joint, open.size());
        }
        open.pop_back();
        indent(open.size());
        text_ += "}\n";
      }
    }
  }

  Status frames(const Progress& progress) {
    const std::size_t count = motion::frame_count(clip_.duration(), fps_);
    fmt::format_to(std::back_inserter(text_), "MOTION\nFrames: {}\nFrame Time: {}\n", count, 1.0 / fps_);
    text_.reserve(text_.size() + count * (segments_.size() + 1) * 36);
    std::vector<EulerAngles> previous(segments_.size(), EulerAngles{0, 0, 0});
    std::vector<body::SegmentPose> poses;
    for (std::size_t frame = 0; frame < count; ++frame) {
      if (frame % kFramesPerReport == 0 &&
          !progress.report(static_cast<double>(frame) / static_cast<double>(count), "writing")) {
        return cancelled();
      }
      motion::pose_at(clip_, static_cast<double>(frame) / fps_, poses);
      vector(to_y_up(poses[0].p_WL) * unit_, digits_);
      for (const std::size_t joint : order_written_) {
        const int parent = segments_[joint].parent;
        // World rotations away from rest have axes parallel to the file's; a joint's is relative to its parent's.
        Quaterniond R = poses[joint].R_WL * R_WL_rest_[joint].conjugate();
        if (parent >= 0) {
          const auto p = static_cast<std::size_t>(parent);
          R = (poses[p].R_WL * R_WL_rest_[p].conjugate()).conjugate() * R;
        }
        if (!R.coeffs().allFinite() || !poses[joint].p_WL.allFinite()) {
          return Error{fmt::format("the pose of \"{}\" at {:.3f} s is not a number", segments_[joint].name,
                                   static_cast<double>(frame) / fps_),
                       clip_.name, "solve the take again"};
        }
        previous[joint] = to_euler(to_y_up(R), order_, previous[joint]);
        if (slides(joint)) {
          const auto p = static_cast<std::size_t>(parent);
          const Vector3d p_PL = motion::sample(clip_.joints[joint].position, static_cast<double>(frame) / fps_);
          text_ += ' ';
          vector(to_y_up(Vector3d(R_WL_rest_[p] * p_PL)) * unit_, digits_);
        }
        for (const double angle : previous[joint]) {
          text_ += ' ';
          number(degrees(angle), kAngleDigits);
        }
      }
      text_ += '\n';
      if (text_.size() >= kPiece) {
        sink_.append(text_);
        text_.clear();
      }
    }
    sink_.append(text_);
    text_.clear();
    return {};
  }

 private:
  [[nodiscard]] bool slides(std::size_t joint) const {
    return segments_[joint].parent >= 0 && joint < clip_.joints.size() && !clip_.joints[joint].position.empty();
  }

  void indent(std::size_t depth) { text_.append(depth, '\t'); }

  // Fixed notation with a decimal point whatever the locale says; never "-0.000000".
  void number(double value, int digits) {
    char buffer[400];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr;
    const std::string_view shown(buffer, static_cast<std::size_t>(end - buffer));
    const bool negative_zero = buffer[0] == '-' && shown.find_first_not_of("-0.") == std::string_view::npos;
    text_.append(shown, negative_zero ? 1 : 0);
  }

  void vector(const Vector3d& v, int digits) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) {
        text_ += ' ';
      }
      number(v[axis], digits);
    }
  }

  void offset(const Vector3d& v_W, std::size_t depth) {
    indent(depth);
    text_ += "OFFSET ";
    vector(to_y_up(v_W) * unit_, digits_);
    text_ += '\n';
  }

  void begin_joint(std::size_t joint, std::size_t depth) {
    order_written_.push_back(joint);
    indent(depth);
    fmt::format_to(std::back_inserter(text_), "{} {}\n", depth == 0 ? "ROOT" : "JOINT", names_[joint]);
    indent(depth);
    text_ += "{\n";
    const int parent = segments_[joint].parent;
    // Readers disagree on whether the root's OFFSET adds to its position channels: zero serves both.
    offset(parent < 0 ? Vector3d(Vector3d::Zero())
                      : Vector3d(R_WL_rest_[static_cast<std::size_t>(parent)] * segments_[joint].p_PL),
           depth + 1);
    indent(depth + 1);
    text_ += depth == 0 || slides(joint) ? "CHANNELS 6 Xposition Yposition Zposition" : "CHANNELS 3";
    for (const int axis : order_) {
      text_ += ' ';
      text_ += static_cast<char>('X' + axis);
      text_ += "rotation";
    }
    text_ += '\n';
  }

  void end_site(std::size_t joint, std::size_t depth) {
    indent(depth);
    text_ += "End Site\n";
    indent(depth);
    text_ += "{\n";
    offset(R_WL_rest_[joint] * Vector3d(segments_[joint].length, 0.0, 0.0), depth + 1);
    indent(depth);
    text_ += "}\n";
  }

  const motion::Clip& clip_;
  const std::vector<body::Segment>& segments_;
  double fps_;
  double unit_;
  int digits_;
  EulerOrder order_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<Quaterniond> R_WL_rest_;
  std::vector<std::string> names_;
  std::vector<std::size_t> order_written_;
  ByteSink& sink_;
  std::string text_;
};

Status put_text(const motion::Clip& clip, const BvhWriteOptions& options, const Progress& progress, ByteSink& sink) {
  if (clip.skeleton.segments.empty()) {
    return Error{"the clip has no skeleton", clip.name, "solve the take first"};
  }
  const double fps = options.fps > 0.0 ? options.fps : clip.frame_rate_hz;
  if (!(fps > 0.0 && fps <= kHighestFrameRate)) {
    return Error{fmt::format("{} is not a frame rate", fps), clip.name, "give the frames per second, for example 60"};
  }
  if (clip.duration() * fps * static_cast<double>(clip.skeleton.segments.size()) > kMostNumbers / 3.0) {
    return Error{fmt::format("{:.0f} s at {} frames per second are too many frames", clip.duration(), fps), clip.name,
                 "write fewer frames per second or a part of it"};
  }
  BvhText writer(clip, options, sink);
  writer.hierarchy();
  return writer.frames(progress);
}

}  // namespace

Result<std::string> bvh_text(const motion::Clip& clip, const BvhWriteOptions& options, const Progress& progress) {
  MemorySink sink;
  if (Status status = put_text(clip, options, progress, sink); !status) {
    return status.error();
  }
  return sink.take();
}

Status write_bvh(const motion::Clip& clip, const std::filesystem::path& path, const BvhWriteOptions& options,
                 const Progress& progress) {
  AtomicFile file(path);
  if (Status status = put_text(clip, options, progress, file); !status) {
    return status;
  }
  return file.commit();
}

}  // namespace limbwave::interchange
