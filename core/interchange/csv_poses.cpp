#include "interchange/csv_poses.h"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "base/atomic_file.h"
#include "base/byte_sink.h"
#include "interchange/frame_rate.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

constexpr std::size_t kFramesPerReport = 1024;

std::string quoted(const std::string& name) {
  std::string text = to_utf8(name);
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) {
    text.insert(i, 1, '"');
  }
  return '"' + text + '"';
}

// What is written at once: long clips are more text than should lie in memory.
constexpr std::size_t kPiece = std::size_t{1} << 20;

Status put_rows(const motion::Clip& clip, const CsvPosesOptions& options, const Progress& progress, ByteSink& sink) {
  const double fps = options.fps > 0.0 ? options.fps : clip.frame_rate_hz;
  if (!(fps > 0.0 && fps <= kHighestFrameRate)) {
    return Error{fmt::format("{} is not a frame rate", fps), clip.name, "give the frames per second, for example 60"};
  }
  if (clip.duration() * fps * static_cast<double>(clip.skeleton.segments.size()) > kMostNumbers / 8.0) {
    return Error{fmt::format("{:.0f} s at {} frames per second are too many rows", clip.duration(), fps), clip.name,
                 "write fewer frames per second or a part of it"};
  }
  std::string text = "time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m\n";
  std::vector<std::string> names;
  for (const body::Segment& segment : clip.skeleton.segments) {
    names.push_back(quoted(segment.name));
  }
  std::vector<Eigen::Quaterniond> previous(names.size(), Eigen::Quaterniond::Identity());
  std::vector<body::SegmentPose> poses;
  const std::size_t frames = motion::frame_count(clip.duration(), fps);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (frame % kFramesPerReport == 0 &&
        !progress.report(static_cast<double>(frame) / static_cast<double>(frames), "writing")) {
      return cancelled();
    }
    const double time = static_cast<double>(frame) / fps;
    motion::pose_at(clip, time, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      Eigen::Quaterniond q = poses[i].R_WL;
      const Eigen::Vector3d& p = poses[i].p_WL;
      if (!q.coeffs().allFinite() || !p.allFinite()) {
        return Error{
            fmt::format("the pose of \"{}\" at {:.3f} s is not a number", clip.skeleton.segments[i].name, time),
            clip.name, "solve the take again"};
      }
      if (q.dot(previous[i]) < 0.0) {
        q.coeffs() *= -1.0;
      }
      previous[i] = q;
      fmt::format_to(std::back_inserter(text), "{:.6f},{},{:.9f},{:.9f},{:.9f},{:.9f},{:.6f},{:.6f},{:.6f}\n", time,
                     names[i], q.w(), q.x(), q.y(), q.z(), p.x(), p.y(), p.z());
    }
    if (text.size() >= kPiece) {
      sink.append(text);
      text.clear();
    }
  }
  sink.append(text);
  return {};
}

}  // namespace

Result<std::string> csv_poses_text(const motion::Clip& clip, const CsvPosesOptions& options, const Progress& progress) {
  MemorySink sink;
  if (Status status = put_rows(clip, options, progress, sink); !status) {
    return status.error();
  }
  return sink.take();
}

Status write_csv_poses(const motion::Clip& clip, const std::filesystem::path& path, const CsvPosesOptions& options,
                       const Progress& progress) {
  AtomicFile file(path);
  if (Status status = put_rows(clip, options, progress, file); !status) {
    return status;
  }
  return file.commit();
}

}  // namespace limbwave::interchange
