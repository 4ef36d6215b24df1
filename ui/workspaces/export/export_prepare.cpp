#include "workspaces/export/export_prepare.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "interchange/bone_map.h"
#include "interchange/mesh_file.h"

namespace limbwave::ui {

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using interchange::FileFormat;
using motion::Clip;

// What a preview may hold: ten minutes of a person at 200 Hz.
constexpr double kMostKeys = 3e6;
constexpr std::size_t kMostMeshes = 12;
// Directions this near to a bone's x are along it.
constexpr double kAlong = 0.99;

std::string key_of(const std::filesystem::path& file, const body::Skeleton& skeleton) {
  std::error_code ignored;
  const auto changed = std::filesystem::last_write_time(file, ignored).time_since_epoch().count();
  return file.string() + '\n' + std::to_string(changed) + '\n' + body::skeleton_to_json(skeleton).dump();
}

// How a segment's frame is to be turned so that its x runs to where its children are. Frames that are so already stay,
// also where only one of several children lies ahead.
std::vector<Quaterniond> turns_along_bones(const body::Skeleton& skeleton) {
  std::vector<Quaterniond> turns(skeleton.segments.size(), Quaterniond::Identity());
  std::vector<bool> is_along(skeleton.segments.size(), false);
  for (const body::Segment& child : skeleton.segments) {
    if (child.parent >= 0 && child.p_PL.norm() > 1e-6 && child.p_PL.normalized().x() > kAlong) {
      is_along[static_cast<std::size_t>(child.parent)] = true;
    }
  }
  const std::vector<Vector3d> directions = motion::bone_directions(skeleton);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (!is_along[i]) {
      turns[i] = Quaterniond::FromTwoVectors(Vector3d::UnitX(), directions[i]);
    }
  }
  return turns;
}

void add_actor(PreparedExport& made, const body::Skeleton& skeleton) {
  const int first = static_cast<int>(made.skeleton.segments.size());
  const std::vector<Quaterniond> turns = turns_along_bones(skeleton);
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    body::Segment segment = skeleton.segments[i];
    segment.parent = segment.parent < 0 ? -1 : segment.parent + first;
    made.skeleton.segments.push_back(std::move(segment));
    made.R_LX.push_back(turns[i]);
  }
}

}  // namespace

Result<SharedMesh> MeshCache::get(const std::filesystem::path& file, const Clip& clip, const Progress& progress) {
  const std::string key = key_of(file, clip.skeleton);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = meshes_.find(key); found != meshes_.end()) {
      return found->second;
    }
  }
  Result<SharedMesh> mesh = interchange::skinned_mesh_file(file, clip, progress);
  if (mesh) {
    const std::lock_guard lock(mutex_);
    if (meshes_.size() >= kMostMeshes) {
      meshes_.clear();
    }
    meshes_[key] = *mesh;
  }
  return mesh;
}

void PreparedExport::pose_at(double file_s, std::vector<body::SegmentPose>& poses) const {
  poses.clear();
  std::vector<body::SegmentPose> one;
  for (const Clip& clip : clips) {
    motion::pose_at(clip, file_s, one);
    poses.insert(poses.end(), one.begin(), one.end());
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].R_WL = poses[i].R_WL * R_LX[i];
  }
}

void PreparedExport::rest_pose(std::vector<body::SegmentPose>& poses) const {
  poses.clear();
  for (const Clip& clip : clips) {
    const std::vector<body::SegmentPose> one = motion::rest_poses(clip.skeleton);
    poses.insert(poses.end(), one.begin(), one.end());
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].R_WL = poses[i].R_WL * R_LX[i];
  }
}

Result<PreparedExport> prepare_export(const std::vector<SharedClip>& clips, FileFormat format,
                                      const interchange::ExportOptions& options, const std::vector<SharedMesh>& meshes,
                                      const Progress& progress) {
  PreparedExport made;
  interchange::ExportOptions wanted = options;
  // Poses do not depend on it, and bones along x can be drawn.
  wanted.preset.bone_axis = interchange::BoneAxis::kAsIs;
  std::vector<const Clip*> pointers;
  double bones = 0.0, whole_s = 0.0;
  for (const SharedClip& clip : clips) {
    pointers.push_back(clip.get());
    bones += static_cast<double>(clip->skeleton.segments.size());
    whole_s = std::max(whole_s, std::min(options.end_s, clip->duration()) - options.begin_s);
  }
  const double rate = options.fps > 0.0 ? options.fps : (clips.empty() ? 60.0 : clips.front()->frame_rate_hz);
  const double most_s = kMostKeys / std::max(1.0, bones * std::max(1.0, rate));
  made.partial = whole_s > most_s;
  if (made.partial) {
    wanted.end_s = options.begin_s + most_s;
  }
  Result<std::vector<Clip>> prepared = interchange::prepared(pointers, format, wanted, made.report, progress);
  if (!prepared) {
    return prepared.error();
  }
  made.clips = *std::move(prepared);
  interchange::ExportReport& report = made.report;
  const bool rest_frame = wanted.preset.rest_frame && wanted.rest_frame && format != FileFormat::kCsv;
  made.lead_s = rest_frame ? 1.0 / report.fps : 0.0;
  if (made.partial) {
    const double part = whole_s / most_s;
    report.duration_s = whole_s + made.lead_s;
    report.frames = motion::frame_count(report.duration_s, report.fps);
    report.keys_before = static_cast<std::size_t>(part * static_cast<double>(report.keys_before));
    report.keys_after = static_cast<std::size_t>(part * static_cast<double>(report.keys_after));
  }
  std::size_t triangles = 0;
  const auto count = [&](const SharedMesh& mesh) {
    made.vertices += mesh->positions.size();
    triangles += mesh->triangles.size();
  };
  for (Clip& clip : made.clips) {
    if (meshes.empty()) {
      std::for_each(clip.meshes.begin(), clip.meshes.end(), count);
    }
    clip.meshes.clear();
    add_actor(made, clip.skeleton);
  }
  if (options.mesh && format != FileFormat::kBvh && format != FileFormat::kCsv) {
    std::for_each(meshes.begin(), meshes.end(), count);
  }
  made.bytes = estimated_bytes(format, report, made.vertices, triangles);
  made.source_rate_hz = clips.front()->frame_rate_hz;
  const std::vector<std::string> roles = interchange::roles_of(clips.front()->skeleton);
  made.person = std::any_of(roles.begin(), roles.end(), [](const std::string& role) { return !role.empty(); });
  return made;
}

std::uintmax_t estimated_bytes(FileFormat format, const interchange::ExportReport& report, std::size_t vertices,
                               std::size_t triangles) {
  const auto bones = static_cast<double>(report.bones), frames = static_cast<double>(report.frames);
  const auto keys = static_cast<double>(report.keys_after);
  const bool reduced = report.keys_after < report.keys_before;
  const auto v = static_cast<double>(vertices), t = static_cast<double>(triangles);
  double bytes = 0.0;
  // Bytes a bone, key, vertex and triangle as the writers make them. FBX packs its numbers; how well, was measured on
  // recorded walks.
  switch (format) {
    case FileFormat::kFbx:
      bytes = 3200.0 * bones + (reduced ? 50.0 : 25.0) * keys + 30.0 * v + 8.0 * t;
      break;
    case FileFormat::kGltf:
      bytes = 400.0 * bones + 4.0 / 3.0 * ((reduced ? 22.0 : 16.0) * keys + 48.0 * v + 12.0 * t);
      break;
    case FileFormat::kGlb:
    case FileFormat::kVrm:
      bytes = 400.0 * bones + (reduced ? 22.0 : 16.0) * keys + 48.0 * v + 12.0 * t;
      break;
    case FileFormat::kBvh:
      bytes = 150.0 * bones + 30.0 * (bones + 1.0) * frames;
      break;
    case FileFormat::kCsv:
      bytes = 94.0 * bones * frames;
      break;
  }
  return static_cast<std::uintmax_t>(std::llround(bytes));
}

}  // namespace limbwave::ui
