// How much memory an export takes: a person of 22 joints at 120 Hz, written and read back in every format, each in a
// process of its own. Usage: export_memory [MINUTES] (default 120)
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "geometry/so3.h"
#include "interchange/export_file.h"
#include "interchange/random_clip.h"
#include "support/temporary_folder.h"

namespace {

using namespace limbwave;

motion::Clip person(double minutes) {
  motion::Clip clip = test::random_clip(22, 1, 120.0, 52);
  const auto frames = static_cast<std::size_t>(minutes * 60.0 * 120.0) + 1;
  clip.root_position = {};
  for (std::size_t i = 0; i < clip.joints.size(); ++i) {
    motion::RotationTrack& track = clip.joints[i].rotation;
    const Eigen::Quaterniond rest = clip.skeleton.segments[i].R_PL_rest;
    track = {};
    track.times.reserve(frames);
    track.values.reserve(frames);
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = static_cast<double>(f) / 120.0;
      const double s = static_cast<double>(i);
      track.times.push_back(t);
      track.values.push_back(rest * geometry::exp_so3({std::sin(2.1 * t + s), 0.7 * std::sin(1.3 * t + 2.0 * s),
                                                       0.5 * std::cos(3.7 * t + s)}));
    }
  }
  for (std::size_t f = 0; f < frames; ++f) {
    const double t = static_cast<double>(f) / 120.0;
    clip.root_position.times.push_back(t);
    clip.root_position.values.emplace_back(std::cos(0.3 * t), std::sin(0.3 * t), 1.0 + 0.05 * std::sin(6.0 * t));
  }
  return clip;
}

double megabytes(const motion::Clip& clip) {
  double bytes = 0.0;
  for (const motion::JointTracks& joint : clip.joints) {
    bytes += static_cast<double>(joint.rotation.times.size() * (sizeof(double) + sizeof(Eigen::Quaterniond)));
  }
  return (bytes + static_cast<double>(clip.root_position.times.size()) * 32.0) * 1e-6;
}

int export_one(double minutes, const std::filesystem::path& path) {
  std::vector<motion::Clip> clips;
  clips.push_back(person(minutes));
  std::printf("%-6s clip %.0f MB", path.extension().c_str(), megabytes(clips.front()));
  const auto report = interchange::export_and_release(std::move(clips), path);
  if (!report) {
    std::printf("  %s\n", report.error().text().c_str());
    return 1;
  }
  std::printf("  file %.0f MB", static_cast<double>(report->bytes) * 1e-6);
  std::fflush(stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const double minutes = argc > 1 ? std::atof(argv[1]) : 120.0;
  const test::TemporaryFolder folder;
  int failed = 0;
  for (const char* name : {"a.bvh", "a.csv", "a.glb", "a.gltf", "a.fbx"}) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::_Exit(export_one(minutes, folder / name));
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    std::printf("  peak %.0f MB  %.0f s\n", static_cast<double>(used.ru_maxrss) * 1e-3,
                static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec));
    std::fflush(stdout);
    failed += status == 0 ? 0 : 1;
    std::filesystem::remove(folder / name);
  }
  return failed == 0 ? 0 : 1;
}
