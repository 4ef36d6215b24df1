#include "interchange/read_back.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

namespace limbwave::interchange {
namespace {

constexpr std::size_t kKeysPerReport = 4096;
constexpr const char* kRemedy = "nothing was written; choose another format or preset, and report this file";

// Indices of joints depth first, siblings in their order.
std::vector<std::size_t> depth_first(const std::vector<int>& parents) {
  std::vector<std::vector<std::size_t>> children(parents.size());
  std::vector<std::size_t> open;
  for (std::size_t i = parents.size(); i-- > 0;) {
    (parents[i] < 0 ? open : children[static_cast<std::size_t>(parents[i])]).push_back(i);
  }
  std::vector<std::size_t> order;
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    order.push_back(i);
    open.insert(open.end(), children[i].begin(), children[i].end());
  }
  return order;
}

// Remembers the worst distance; false when it is too large.
bool note(ReadBack& result, double distance, const std::string& joint, double time_s, double tolerance_m) {
  if (distance > result.worst_m || !std::isfinite(distance)) {
    result = {distance, joint, time_s};
  }
  return distance <= tolerance_m;
}

Error too_far(const ReadBack& result, double fps, const std::string& place) {
  return {fmt::format("the written file has \"{}\" {:.2f} mm away from where it belongs at frame {} ({:.3f} s)",
                      result.worst_joint, result.worst_m * 1e3, std::llround(result.worst_time_s * fps),
                      result.worst_time_s),
          place, kRemedy};
}

}  // namespace

JointPaths joint_paths(const motion::Clip& clip) {
  JointPaths paths;
  for (const body::Segment& segment : clip.skeleton.segments) {
    paths.names.push_back(segment.name);
    paths.parents.push_back(segment.parent);
  }
  paths.frame_rate_hz = clip.frame_rate_hz;
  paths.times_s = motion::key_times(clip);
  if (paths.times_s.empty()) {
    paths.times_s = {0.0};
  }
  paths.roots.reserve(paths.times_s.size());
  paths.rest.reserve(paths.times_s.size() * (paths.names.empty() ? 0 : paths.names.size() - 1));
  std::vector<body::SegmentPose> poses;
  for (const double time : paths.times_s) {
    motion::pose_at(clip, time, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (i == 0) {
        paths.roots.push_back(poses[i].p_WL);
      } else {
        paths.rest.emplace_back((poses[i].p_WL - poses[0].p_WL).cast<float>());
      }
    }
  }
  return paths;
}

Result<ReadBack> compare_paths(const std::vector<JointPaths>& meant, const std::vector<WrittenActor>& written,
                               double tolerance_m, const std::string& place, const Progress& progress) {
  if (meant.size() != written.size()) {
    return Error{fmt::format("the written file has {} actors instead of {}", written.size(), meant.size()), place,
                 kRemedy};
  }
  ReadBack result;
  std::vector<Eigen::Vector3d> p_W;
  for (std::size_t c = 0; c < meant.size(); ++c) {
    const JointPaths& paths = meant[c];
    const std::vector<std::size_t> order_a = depth_first(paths.parents);
    const std::vector<std::size_t> order_b = depth_first(written[c].parents);
    if (order_a.size() != order_b.size()) {
      return Error{fmt::format("the written file has {} bones instead of {}", order_b.size(), order_a.size()), place,
                   kRemedy};
    }
    const Progress part = progress.part(static_cast<double>(c) / static_cast<double>(meant.size()),
                                        static_cast<double>(c + 1) / static_cast<double>(meant.size()));
    const std::size_t others = order_a.empty() ? 0 : order_a.size() - 1;
    for (std::size_t k = 0; k < paths.roots.size(); ++k) {
      const double time = paths.times_s[k];
      if (k % kKeysPerReport == 0 &&
          !part.report(static_cast<double>(k) / static_cast<double>(paths.roots.size()), "checking")) {
        return cancelled();
      }
      if (const Status status = written[c].places(time, p_W); !status) {
        return status.error();
      }
      for (std::size_t i = 0; i < order_a.size(); ++i) {
        const std::size_t a = order_a[i];
        Eigen::Vector3d p = paths.roots[k];
        if (a > 0) {
          p += paths.rest[k * others + a - 1].cast<double>();
        }
        if (!note(result, (p - p_W[order_b[i]]).norm(), paths.names[a], time, tolerance_m)) {
          return too_far(result, paths.frame_rate_hz, place);
        }
      }
    }
  }
  return result;
}

Result<ReadBack> compare_csv(const motion::Clip& meant, double fps, const std::filesystem::path& path,
                             double tolerance_m, const Progress& progress) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);  // the names of the columns
  ReadBack result;
  std::vector<body::SegmentPose> poses;
  const std::size_t frames = motion::frame_count(meant.duration(), fps);
  for (std::size_t f = 0; f < frames; ++f) {
    if (f % kKeysPerReport == 0 && !progress.report(static_cast<double>(f) / static_cast<double>(frames), "checking")) {
      return cancelled();
    }
    const double time = static_cast<double>(f) / fps;
    motion::pose_at(meant, time, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (!std::getline(file, line)) {
        return Error{fmt::format("the written file ends before frame {}", f), path.string(), kRemedy};
      }
      // The last three columns; names, which may hold commas, come before.
      Eigen::Vector3d p = Eigen::Vector3d::Constant(NAN);
      std::size_t end = line.size();
      for (int axis = 2; axis >= 0 && end != std::string::npos; --axis) {
        const std::size_t comma = line.rfind(',', end - 1);
        if (comma != std::string::npos) {
          std::from_chars(line.data() + comma + 1, line.data() + end, p[axis]);
        }
        end = comma;
      }
      if (!note(result, (p - poses[i].p_WL).norm(), meant.skeleton.segments[i].name, time, tolerance_m)) {
        return too_far(result, fps, path.string());
      }
    }
  }
  return result;
}

}  // namespace limbwave::interchange
