#include "workspaces/export/export_plan.h"

#include <unistd.h>

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "interchange/bvh_reader.h"

namespace limbwave::ui {

namespace {

struct Export {
  Q_DECLARE_TR_FUNCTIONS(Export)
};

/// Leaves nothing behind, however the export ends.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path path) : path_(std::move(path)) {}
  ~PartFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

 private:
  std::filesystem::path path_;
};

}  // namespace

std::vector<ExportFormat> export_formats() {
  return {{QStringLiteral("bvh"), Export::tr("BVH"), QStringLiteral(".bvh"),
           Export::tr("Skeleton and motion as text, for Blender, Maya, MotionBuilder and others")}};
}

const std::vector<double>& export_rates() {
  static const std::vector<double> kRates{24, 25, 30, 50, 60, 120};
  return kRates;
}

std::filesystem::path default_export_file(const std::filesystem::path& take_folder, const std::string& solve,
                                          const QString& extension) {
  std::string name = take_folder.stem().string();
  if (!solve.empty() && solve != "default") {
    name += "-" + solve;
  }
  return take_folder.parent_path() / (name + extension.toStdString());
}

QString export_file_problem(const std::filesystem::path& file, const QString& extension) {
  if (file.empty() || !file.has_filename()) {
    return Export::tr("Choose where the file goes.");
  }
  std::error_code error;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, error)) {
    return Export::tr("The folder %1 does not exist. Choose another one.").arg(QString::fromStdString(folder.string()));
  }
  if (std::filesystem::is_directory(file, error)) {
    return Export::tr("%1 is a folder. Give the file a name.").arg(QString::fromStdString(file.string()));
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    return Export::tr("You may not write into %1. Choose another folder.").arg(QString::fromStdString(folder.string()));
  }
  if (QString::fromStdString(file.extension().string()).compare(extension, Qt::CaseInsensitive) != 0) {
    return Export::tr("The name must end in %1, or other programs will not find the file.").arg(extension);
  }
  return {};
}

Result<ExportResult> export_clip(const motion::Clip& clip, const ExportPlan& plan, const BvhWriter& write,
                                 const Progress& progress) {
  interchange::BvhWriteOptions options;
  options.fps = plan.fps;
  options.unit = plan.unit == ExportUnit::kMetres ? interchange::BvhUnit::kMetres : interchange::BvhUnit::kCentimetres;
  // Beside the target, so that what is there stays until the new file is known to be good.
  const std::filesystem::path part =
      plan.file.parent_path() / ("." + plan.file.stem().string() + ".part" + plan.file.extension().string());
  const PartFile part_file(part);
  const Status written = write(clip, part, options, progress.part(0.0, 0.7));
  if (!written) {
    Error error = written.error();
    if (error.place == part.string()) {
      error.place = plan.file.string();
    }
    return error;
  }
  if (!progress.report(0.7, "checking")) {
    return cancelled();
  }
  interchange::BvhReadOptions read;
  read.metres_per_unit = plan.unit == ExportUnit::kMetres ? 1.0 : interchange::kMetresPerCentimetre;
  const Result<motion::Clip> back = interchange::load_bvh(part, read);
  if (!back) {
    return Error{"the written file cannot be read back: " + back.error().message, plan.file.string(),
                 "check the disk and export again"};
  }
  ExportResult result;
  result.file = plan.file;
  std::error_code error;
  result.bytes = std::filesystem::file_size(part, error);
  result.frames = back->joints.empty() ? 0 : back->joints.front().rotation.times.size();
  result.bones = back->skeleton.segments.size();
  result.fps = back->frame_rate_hz;
  result.duration_s = back->duration();
  const std::size_t wanted = motion::frame_count(clip.duration(), plan.fps);
  if (result.frames != wanted || result.bones != clip.skeleton.segments.size()) {
    return Error{"the written file has " + std::to_string(result.frames) + " frames and " +
                     std::to_string(result.bones) + " bones instead of " + std::to_string(wanted) + " and " +
                     std::to_string(clip.skeleton.segments.size()),
                 plan.file.string(), "check the disk and export again"};
  }
  if (!progress.report(0.95, "checking")) {
    return cancelled();
  }
  std::filesystem::rename(part, plan.file, error);
  if (error) {
    return Error{"cannot be written (" + error.message() + ")", plan.file.string(), "choose another name or folder"};
  }
  return result;
}

QString size_text(std::uintmax_t bytes) {
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

}  // namespace limbwave::ui
