/// What is exported how: formats, frame rates, file names, and the check of the written file. No widgets.
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "interchange/bvh_writer.h"
#include "motion/clip.h"

namespace limbwave::ui {

enum class ExportUnit { kCentimetres, kMetres };

struct ExportFormat {
  QString id;         ///< "bvh"
  QString title;      ///< "BVH"
  QString extension;  ///< ".bvh"
  QString hint;       ///< Who reads it.
};

/// Those that can be written now.
std::vector<ExportFormat> export_formats();
/// The usual frame rates, hertz, increasing.
const std::vector<double>& export_rates();

inline constexpr double kLowestRate = 1.0, kHighestRate = 1000.0;

struct ExportPlan {
  std::filesystem::path file;
  double fps = 60.0;
  ExportUnit unit = ExportUnit::kCentimetres;
  double begin_s = 0.0, end_s = 0.0;  ///< Part of the clip; end 0: all of it.
};

struct ExportRange {
  double begin_s = 0.0, end_s = 0.0;
  [[nodiscard]] double duration_s() const { return end_s - begin_s; }
};
/// The plan's part of a clip of that duration; all of it when the plan's is empty or beyond its end.
ExportRange range_of(const ExportPlan& plan, double duration_s);

/// What a written file holds, read back from the file itself.
struct ExportResult {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  std::size_t frames = 0;
  std::size_t bones = 0;
  double fps = 0.0;
  double duration_s = 0.0;
};

/// TAKE's parent folder / TAKE.bvh; another solve than "default" adds its name.
std::filesystem::path default_export_file(const std::filesystem::path& take_folder, const std::string& solve,
                                          const QString& extension);
/// Why this file cannot be written, before trying; empty: it can.
QString export_file_problem(const std::filesystem::path& file, const QString& extension);

using BvhWriter = std::function<Status(const motion::Clip&, const std::filesystem::path&,
                                       const interchange::BvhWriteOptions&, const Progress&)>;

/// Writes the plan's part, reads back and compares: frame count, bones, rate. Fails with what is wrong; then no new
/// file is left.
Result<ExportResult> export_clip(const motion::Clip& whole, const ExportPlan& plan, const BvhWriter& write,
                                 const Progress& progress);

/// "1.2 MB", "640 kB"
QString size_text(std::uintmax_t bytes);

}  // namespace limbwave::ui
