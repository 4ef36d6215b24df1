#include "interchange/export_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "interchange/bvh_writer.h"
#include "interchange/clip_check.h"
#include "interchange/csv_poses.h"
#include "interchange/export_check.h"
#include "interchange/fbx_writer.h"
#include "interchange/frame_rate.h"
#include "interchange/gltf_file.h"
#include "interchange/preset.h"
#include "motion/key_reduction.h"
#include "motion/mannequin.h"
#include "motion/transforms.h"

namespace limbwave::interchange {
namespace {

namespace fs = std::filesystem;
using motion::Clip;

// Keys this close to the multiples of the frame rate are captured frames.
constexpr double kOnFrame = 1e-3;

bool has_bone_frames(FileFormat format) {
  return format != FileFormat::kBvh && format != FileFormat::kCsv;
}

// Whether a track has a linear key on every frame, as captures have: its keys are samples of a smooth movement.
template <typename T>
bool is_captured(const motion::Track<T>& track, double fps) {
  if (track.times.size() < 4 || !track.key_interpolation.empty() ||
      track.interpolation != motion::Interpolation::kLinear) {
    return false;
  }
  for (std::size_t i = 1; i < track.times.size(); ++i) {
    if (std::abs((track.times[i] - track.times[i - 1]) * fps - 1.0) > kOnFrame) {
      return false;
    }
  }
  return true;
}

// At 50 frames a second from 60, straight lines between samples cut the corners of fast movements by millimetres.
// Track after track, each in the place of the old one: whole clips may be hours long.
Clip resampled_smoothly(Clip clip, double fps) {
  const std::size_t frames = motion::frame_count(clip.duration(), fps);
  const auto resample = [&](auto& track) {
    if (is_captured(track, clip.frame_rate_hz)) {
      track.interpolation = motion::Interpolation::kCubic;
    }
    track = motion::resampled(track, frames, fps);
  };
  for (motion::JointTracks& joint : clip.joints) {
    resample(joint.rotation);
    resample(joint.position);
  }
  resample(clip.root_position);
  clip.frame_rate_hz = fps;
  return clip;
}

// Blender takes a joint that lies where its parent's bone ends (on its own y, as far away as its children are on
// average) as connected, and connected joints do not move there. One that does move is put this far beside it at rest.
constexpr double kLoose = 5e-6;     // m
constexpr double kTouching = 1e-4;  // m

Clip loosened(Clip clip) {
  std::vector<body::Segment>& segments = clip.skeleton.segments;
  std::vector<double> sums(segments.size(), 0.0);
  std::vector<int> children(segments.size(), 0);
  for (const body::Segment& segment : segments) {
    if (segment.parent >= 0) {
      sums[static_cast<std::size_t>(segment.parent)] += segment.p_PL.norm();
      ++children[static_cast<std::size_t>(segment.parent)];
    }
  }
  for (std::size_t i = 1; i < segments.size() && i < clip.joints.size(); ++i) {
    const auto parent = static_cast<std::size_t>(segments[i].parent);
    // Files' own y is our z (file_axes.h).
    const Eigen::Vector3d end(0.0, 0.0, sums[parent] / children[parent]);
    if (!clip.joints[i].position.empty() && (segments[i].p_PL - end).norm() < kTouching) {
      segments[i].p_PL.x() += kLoose;
    }
  }
  return clip;
}

std::size_t count_keys(const Clip& clip) {
  std::size_t keys = clip.root_position.times.size();
  for (const motion::JointTracks& joint : clip.joints) {
    keys += joint.rotation.times.size() + joint.position.times.size();
  }
  return keys;
}

// The preset as this export wants it.
Preset adapted(const ExportOptions& options, FileFormat format) {
  Preset preset = options.preset;
  preset.root_motion = options.root_motion.value_or(preset.root_motion);
  preset.unit = options.unit.value_or(format == FileFormat::kBvh ? preset.bvh_unit : preset.unit);
  preset.rest_frame = preset.rest_frame && options.rest_frame;
  if (!has_bone_frames(format)) {
    // These files have one root and the world's axes in every joint.
    preset.bone_axis = BoneAxis::kAsIs;
    preset.root_bone.clear();
  }
  if (format == FileFormat::kCsv) {
    preset.rest_frame = false;
  }
  if (preset.root_motion == motion::RootMotion::kOnRoot && preset.root_bone.empty()) {
    preset.root_motion = motion::RootMotion::kFree;
  }
  return preset;
}

Result<Clip> cut(Clip clip, const ExportOptions& options) {
  const double end = std::min(options.end_s, clip.duration());
  if (options.begin_s <= 0.0 && end >= clip.duration()) {
    return clip;
  }
  if (!(options.begin_s >= 0.0 && options.begin_s < end)) {
    return Error{fmt::format("from {:.3f} s to {:.3f} s there is nothing; it is {:.3f} s long", options.begin_s,
                             std::max(end, options.begin_s), clip.duration()),
                 clip.name, "choose a part inside the clip"};
  }
  return motion::trimmed(clip, options.begin_s, end);
}

// Where a file is made and checked before it gets its name.
fs::path part_path(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.part{}{}", path.stem().string(), ::getpid(), path.extension().string());
}

Status write(const std::vector<Clip>& clips, FileFormat format, const Preset& preset, const fs::path& path,
             const Progress& progress) {
  std::vector<const Clip*> pointers;
  pointers.reserve(clips.size());
  for (const Clip& clip : clips) {
    pointers.push_back(&clip);
  }
  const double fps = clips.front().frame_rate_hz;
  const bool metres = preset.unit == FileUnit::kMetres;
  switch (format) {
    case FileFormat::kFbx: {
      FbxWriteOptions fbx;
      fbx.metres_per_unit = metres ? 1.0 : 0.01;
      return write_fbx(pointers, path, fbx, progress);
    }
    case FileFormat::kBvh: {
      BvhWriteOptions bvh;
      bvh.fps = fps;
      bvh.unit = metres ? BvhUnit::kMetres : BvhUnit::kCentimetres;
      return write_bvh(clips.front(), path, bvh, progress);
    }
    case FileFormat::kCsv:
      return write_csv_poses(clips.front(), path, {.fps = fps}, progress);
    default:
      if (format == FileFormat::kVrm) {
        // Whatever the preset: without these bones no program takes it for a VRM.
        const Result<Preset> vrm = load_preset("vrm");
        for (std::size_t i = 0; vrm && i < clips.size(); ++i) {
          if (Status whole = check_required(clips[i], *vrm); !whole) {
            return whole;
          }
        }
      }
      return write_gltf(pointers, path, {.vrm = format == FileFormat::kVrm}, progress);
  }
}

// The file is made and checked beside `path` and appears there when all is right.
Result<ExportReport> write_checked(std::vector<Clip> meant, FileFormat format, const fs::path& path,
                                   const ExportOptions& options, ExportReport report, const Progress& progress) {
  const Preset preset = adapted(options, format);
  const fs::path part = part_path(path);
  const auto give_up = [&](Error error) {
    std::error_code ignored;
    fs::remove(part, ignored);
    if (error.place == part.string()) {
      error.place = path.string();
    }
    return error;
  };
  if (const Status written = write(meant, format, preset, part, progress.part(0.2, 0.6)); !written) {
    return give_up(written.error());
  }
  const Result<ReadBack> same = check_export(std::move(meant), format, preset.unit, part, progress.part(0.6, 1.0));
  if (!same) {
    return give_up(same.error());
  }
  std::error_code error;
  fs::rename(part, path, error);
  if (error) {
    return give_up({"cannot be written (" + error.message() + ")", path.string(), "choose another file"});
  }
  report.file = path;
  report.bytes = fs::file_size(path, error);
  report.worst_m = same->worst_m;
  report.worst_joint = same->worst_joint;
  return report;
}

}  // namespace

Result<FileFormat> format_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  static const std::pair<const char*, FileFormat> kEndings[] = {
      {".fbx", FileFormat::kFbx}, {".glb", FileFormat::kGlb}, {".gltf", FileFormat::kGltf},
      {".vrm", FileFormat::kVrm}, {".bvh", FileFormat::kBvh}, {".csv", FileFormat::kCsv}};
  for (const auto& [ending, format] : kEndings) {
    if (extension == ending) {
      return format;
    }
  }
  return Error{"has an ending that cannot be written", path.string(), "use .fbx, .glb, .gltf, .vrm, .bvh or .csv"};
}

namespace {

// `owned`: the same clips, where each may be used up; null: they are copied.
Result<std::vector<Clip>> prepare(std::span<const Clip* const> clips, std::vector<Clip>* owned, FileFormat format,
                                  const ExportOptions& options, ExportReport& report, const Progress& progress) {
  if (clips.empty()) {
    return Error{"nothing is to be exported", "", "choose a clip"};
  }
  if (!has_bone_frames(format) && clips.size() > 1) {
    return Error{"one file of this format holds one actor", clips[1]->name, "export every actor to a file of its own"};
  }
  const double fps = exact_frame_rate(options.fps > 0.0 ? options.fps : clips.front()->frame_rate_hz);
  if (!(fps > 0.0 && fps <= kHighestFrameRate)) {
    return Error{fmt::format("{} is not a frame rate", fps), clips.front()->name, "give the frames per second"};
  }
  const Preset preset = adapted(options, format);
  std::vector<Clip> result;
  for (const Clip* source : clips) {
    if (!progress.report(static_cast<double>(result.size()) / static_cast<double>(clips.size()), "preparing")) {
      return cancelled();
    }
    if (const Status valid = check_clip(*source); !valid) {
      return valid.error();
    }
    Result<Clip> clip = cut(owned != nullptr ? std::move((*owned)[result.size()]) : Clip(*source), options);
    if (!clip) {
      return clip.error();
    }
    if (options.fps > 0.0 || !has_bone_frames(format)) {
      clip = resampled_smoothly(*std::move(clip), fps);
    }
    clip->frame_rate_hz = fps;
    const bool with_mesh = options.mesh && has_bone_frames(format);
    if (!with_mesh) {
      clip->meshes.clear();
    }
    clip = arranged(*std::move(clip), preset);
    if (!clip) {
      return clip.error();
    }
    if (format == FileFormat::kGlb || format == FileFormat::kGltf || format == FileFormat::kVrm) {
      // Blender and others do not read the tangents of glTF's curves. (FBX is written densely anyway.)
      clip = motion::with_straight_pieces(*std::move(clip));
    }
    if (format == FileFormat::kFbx) {
      clip = loosened(*std::move(clip));
    }
    // Importers take the pose in which meshes are bound for the skeleton's rest pose.
    clip = motion::with_meshes_at_rest(*std::move(clip));
    if (with_mesh && clip->meshes.empty()) {
      clip->meshes.push_back(motion::mannequin(clip->skeleton, bone_axis(preset)));
    }
    report.keys_before += count_keys(*clip);
    if (options.key_tolerance_rad > 0.0 && has_bone_frames(format)) {
      motion::KeyReduction limits;
      limits.rotation_rad = options.key_tolerance_rad;
      Result<motion::ReducedClip> fewer = motion::reduced(*clip, limits);
      if (!fewer) {
        return fewer.error();
      }
      clip = std::move(fewer->clip);
    }
    report.keys_after += count_keys(*clip);
    report.bones += clip->skeleton.segments.size();
    report.duration_s = std::max(report.duration_s, clip->duration());
    result.push_back(*std::move(clip));
  }
  report.actors = result.size();
  report.fps = fps;
  report.frames = motion::frame_count(report.duration_s, fps);
  return result;
}

}  // namespace

Result<std::vector<Clip>> prepared(std::span<const Clip* const> clips, FileFormat format, const ExportOptions& options,
                                   ExportReport& report, const Progress& progress) {
  return prepare(clips, nullptr, format, options, report, progress);
}

Result<ExportReport> export_file(std::span<const Clip* const> clips, const fs::path& path, const ExportOptions& options,
                                 const Progress& progress) {
  const Result<FileFormat> format = format_of(path);
  if (!format) {
    return format.error();
  }
  ExportReport report;
  Result<std::vector<Clip>> meant = prepared(clips, *format, options, report, progress.part(0.0, 0.2));
  return meant ? write_checked(*std::move(meant), *format, path, options, report, progress) : meant.error();
}

Result<ExportReport> export_and_release(std::vector<Clip>&& clips, const fs::path& path, const ExportOptions& options,
                                        const Progress& progress) {
  const Result<FileFormat> format = format_of(path);
  if (!format) {
    return format.error();
  }
  std::vector<Clip> sources = std::move(clips);
  std::vector<const Clip*> pointers;
  pointers.reserve(sources.size());
  for (const Clip& clip : sources) {
    pointers.push_back(&clip);
  }
  ExportReport report;
  Result<std::vector<Clip>> meant = prepare(pointers, &sources, *format, options, report, progress.part(0.0, 0.2));
  return meant ? write_checked(*std::move(meant), *format, path, options, report, progress) : meant.error();
}

}  // namespace limbwave::interchange
