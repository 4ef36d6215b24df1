#include "interchange/read_back.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "interchange/frame_rate.h"

namespace limbwave::interchange {
namespace {

constexpr std::size_t kKeysPerReport = 4096;
constexpr const char* kRemedy = "nothing was written; choose another format or preset, and report this file";

// Indices of a skeleton's segments depth first, siblings in their order.
std::vector<std::size_t> depth_first(const body::Skeleton& skeleton) {
  std::vector<std::vector<std::size_t>> children(skeleton.segments.size());
  std::vector<std::size_t> open;
  for (std::size_t i = skeleton.segments.size(); i-- > 0;) {
    const int parent = skeleton.segments[i].parent;
    (parent < 0 ? open : children[static_cast<std::size_t>(parent)]).push_back(i);
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

Result<ReadBack> compare_clips(const std::vector<motion::Clip>& meant, const std::vector<motion::Clip>& read,
                               bool single_times, double tolerance_m, const std::string& place,
                               const Progress& progress) {
  if (meant.size() != read.size()) {
    return Error{fmt::format("the written file has {} actors instead of {}", read.size(), meant.size()), place,
                 kRemedy};
  }
  ReadBack result;
  std::vector<body::SegmentPose> a;
  std::vector<body::SegmentPose> b;
  for (std::size_t c = 0; c < meant.size(); ++c) {
    const std::vector<std::size_t> order_a = depth_first(meant[c].skeleton);
    const std::vector<std::size_t> order_b = depth_first(read[c].skeleton);
    if (order_a.size() != order_b.size()) {
      return Error{fmt::format("the written file has {} bones instead of {}", order_b.size(), order_a.size()), place,
                   kRemedy};
    }
    std::vector<double> times = motion::key_times(meant[c]);
    if (times.empty()) {
      times = {0.0};
    }
    const Progress part = progress.part(static_cast<double>(c) / static_cast<double>(meant.size()),
                                        static_cast<double>(c + 1) / static_cast<double>(meant.size()));
    for (std::size_t k = 0; k < times.size(); ++k) {
      if (k % kKeysPerReport == 0 &&
          !part.report(static_cast<double>(k) / static_cast<double>(times.size()), "checking")) {
        return cancelled();
      }
      motion::pose_at(meant[c], times[k], a);
      motion::pose_at(read[c], single_times ? single_time(times[k], read[c].frame_rate_hz) : times[k], b);
      for (std::size_t i = 0; i < order_a.size(); ++i) {
        const double distance = (a[order_a[i]].p_WL - b[order_b[i]].p_WL).norm();
        if (!note(result, distance, meant[c].skeleton.segments[order_a[i]].name, times[k], tolerance_m)) {
          return too_far(result, meant[c].frame_rate_hz, place);
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
