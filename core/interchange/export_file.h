/// Clips to files as programs want them, checked before they count as written.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/progress.h"
#include "base/result.h"
#include "interchange/preset.h"
#include "motion/clip.h"

namespace limbwave::interchange {

enum class FileFormat { kFbx, kGlb, kGltf, kVrm, kBvh, kCsv };

/// The format that a file name's ending asks for, whatever its case. Fails with the list of endings.
Result<FileFormat> format_of(const std::filesystem::path& path);

struct ExportOptions {
  Preset preset;         ///< Default: plain.
  double fps = 0.0;      ///< Frames a second; 0: those of the first clip. 23.976 means 24/1.001, and so on.
  double begin_s = 0.0;  ///< The part of the clips that is written; what is outside them is left out.
  double end_s = std::numeric_limits<double>::infinity();
  std::optional<motion::RootMotion> root_motion;  ///< Instead of the preset's.
  std::optional<FileUnit> unit;                   ///< Instead of the preset's.
  bool rest_frame = true;                         ///< False: no rest pose on frame 0 even where the preset has it.
  double key_tolerance_rad = 0.0;  ///< Keys are left out as long as no joint turns away by more; 0: all stay.
  bool mesh = true;                ///< Skinned meshes, where the format holds them.
};

struct ExportReport {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  std::size_t actors = 0;
  std::size_t bones = 0;  ///< Of all actors.
  std::size_t frames = 0;
  double fps = 0.0;
  double duration_s = 0.0;
  std::size_t keys_before = 0;  ///< Before and after key reduction; equal without it.
  std::size_t keys_after = 0;
  double worst_m = 0.0;  ///< Largest distance between a joint that was meant and the one read back.
  std::string worst_joint;
};

/// A file read back may be this far off, metres.
inline constexpr double kExportTolerance = 1e-3;

/// The clips as they will be in the file: cut, resampled to the frame rate (captured keys along the curve through
/// their neighbours, others along their own interpolation), arranged by the preset and reduced. What `export_file`
/// writes, and what a preview shows.
Result<std::vector<motion::Clip>> prepared(std::span<const motion::Clip* const> clips, FileFormat format,
                                           const ExportOptions& options, ExportReport& report,
                                           const Progress& progress = {});

/// Writes the clips as actors of one file (BVH and CSV: one clip), reads it back with an own reader and compares every
/// joint at every key. A difference above kExportTolerance is an error that names joint and frame. The file appears,
/// or replaces an older one, only when all is right. Fails also when cancelled.
Result<ExportReport> export_file(std::span<const motion::Clip* const> clips, const std::filesystem::path& path,
                                 const ExportOptions& options = {}, const Progress& progress = {});
/// The same for clips that nobody needs afterwards: their memory is given back before the file is read again.
Result<ExportReport> export_and_release(std::vector<motion::Clip>&& clips, const std::filesystem::path& path,
                                        const ExportOptions& options = {}, const Progress& progress = {});

}  // namespace limbwave::interchange
