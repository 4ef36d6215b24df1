#include "interchange/export_check.h"

#include <utility>

#include "base/files.h"
#include "interchange/bvh_playback.h"
#include "interchange/fbx_playback.h"
#include "interchange/fbx_reader.h"
#include "interchange/gltf_playback.h"

namespace limbwave::interchange {
namespace {

namespace fs = std::filesystem;
using motion::Clip;

Error unreadable(const Error& error, const fs::path& path) {
  return {"the written file cannot be read back: " + error.message, path.string(),
          "check that the disk has room, and export again"};
}

// Bones and meshes are read as any program would; the movement, which may be hours long, as it is played.
Result<ReadBack> check_fbx(const std::vector<JointPaths>& meant, const fs::path& path, const Progress& progress) {
  const Result<std::string> bytes = read_file(path, std::size_t{1} << 32);
  if (!bytes) {
    return unreadable(bytes.error(), path);
  }
  FbxReadOptions still;
  still.animation = false;
  if (const auto read = read_fbx(*bytes, path.string(), still); !read) {
    return unreadable(read.error(), path);
  }
  Result<FbxPlayback> playback = FbxPlayback::open(*bytes, path.string());
  if (!playback) {
    return unreadable(playback.error(), path);
  }
  std::vector<WrittenActor> actors;
  for (std::size_t a = 0; a < playback->actors(); ++a) {
    actors.push_back({playback->parents(a), [&playback, a](double time_s, std::vector<Eigen::Vector3d>& p_W) {
                        return playback->places(a, time_s, p_W);
                      }});
  }
  return compare_paths(meant, actors, kExportTolerance, path.string(), progress);
}

Result<ReadBack> check_bvh(const std::vector<JointPaths>& meant, FileUnit unit, const fs::path& path,
                           const Progress& progress) {
  BvhReadOptions options;
  options.metres_per_unit = unit == FileUnit::kMetres ? 1.0 : kMetresPerCentimetre;
  Result<BvhPlayback> playback = BvhPlayback::open(path, options);
  if (!playback) {
    return unreadable(playback.error(), path);
  }
  WrittenActor actor;
  for (const body::Segment& segment : playback->skeleton().segments) {
    actor.parents.push_back(segment.parent);
  }
  actor.places = [&playback](double time_s, std::vector<Eigen::Vector3d>& p_W) {
    return playback->places(time_s, p_W);
  };
  return compare_paths(meant, {actor}, kExportTolerance, path.string(), progress);
}

Result<ReadBack> check_gltf(const std::vector<JointPaths>& meant, const fs::path& path, const Progress& progress) {
  Result<GltfPlayback> playback = GltfPlayback::open(path);
  if (!playback) {
    return unreadable(playback.error(), path);
  }
  std::vector<WrittenActor> actors;
  for (std::size_t a = 0; a < playback->clips().size(); ++a) {
    WrittenActor& actor = actors.emplace_back();
    for (const body::Segment& segment : playback->clips()[a].skeleton.segments) {
      actor.parents.push_back(segment.parent);
    }
    actor.places = [&playback, a](double time_s, std::vector<Eigen::Vector3d>& p_W) {
      return playback->places(a, time_s, p_W);
    };
  }
  return compare_paths(meant, actors, kExportTolerance, path.string(), progress);
}

}  // namespace

Result<ReadBack> check_export(std::vector<Clip> meant, FileFormat format, FileUnit unit, const fs::path& path,
                              const Progress& progress) {
  if (format == FileFormat::kCsv) {
    return compare_csv(meant.front(), meant.front().frame_rate_hz, path, kExportTolerance, progress);
  }
  // What is compared takes a third of the memory; the file needs the rest.
  std::vector<JointPaths> paths;
  for (Clip& clip : meant) {
    paths.push_back(joint_paths(clip));
    clip = {};
  }
  const Progress comparing = progress.part(0.5, 1.0);
  if (format == FileFormat::kFbx) {
    return check_fbx(paths, path, comparing);
  }
  if (format == FileFormat::kBvh) {
    return check_bvh(paths, unit, path, comparing);
  }
  return check_gltf(paths, path, comparing);
}

}  // namespace limbwave::interchange
