#include "workspaces/export/export_plan.h"

#include <unistd.h>

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/units.h"
#include "interchange/bone_map.h"
#include "workspaces/export/export_words.h"

namespace limbwave::ui {

namespace {

struct Export {
  Q_DECLARE_TR_FUNCTIONS(Export)
};

using interchange::FileFormat;
using interchange::FileUnit;
using interchange::RestPose;
using motion::RootMotion;

const auto kLastPreset = QStringLiteral("export/preset");

QString group(const std::string& preset) {
  return QStringLiteral("export/presets/%1/").arg(QString::fromStdString(preset));
}

// A choice that is kept as a number; nothing for what the preset decides.
template <typename T>
void put(QSettings& settings, const QString& key, const std::optional<T>& value) {
  if (value) {
    settings.setValue(key, static_cast<int>(*value));
  } else {
    settings.remove(key);
  }
}

template <typename T>
std::optional<T> get(const QSettings& settings, const QString& key, int most) {
  bool ok = false;
  const int value = settings.value(key).toInt(&ok);
  return ok && value >= 0 && value <= most ? std::optional<T>(static_cast<T>(value)) : std::nullopt;
}

}  // namespace

std::vector<ExportFormat> export_formats() {
  return {{FileFormat::kFbx, QStringLiteral("fbx"), Export::tr("FBX"), QStringLiteral(".fbx"),
           Export::tr("Skeleton, motion and skinned body; Blender, Maya, MotionBuilder, Unreal and Unity read it"),
           true, true},
          {FileFormat::kGlb, QStringLiteral("glb"), Export::tr("glTF, binary (.glb)"), QStringLiteral(".glb"),
           Export::tr("Skeleton, motion and skinned body in one file; Blender, Unreal and web viewers read it"), true,
           false},
          {FileFormat::kGltf, QStringLiteral("gltf"), Export::tr("glTF, text (.gltf)"), QStringLiteral(".gltf"),
           Export::tr("The same as readable JSON, a third larger"), true, false},
          {FileFormat::kVrm, QStringLiteral("vrm"), Export::tr("VRM 1.0 (.vrm)"), QStringLiteral(".vrm"),
           Export::tr("An avatar with its bones marked, for VRM viewers"), true, false},
          {FileFormat::kBvh, QStringLiteral("bvh"), Export::tr("BVH"), QStringLiteral(".bvh"),
           Export::tr("One skeleton and its motion as text, without a body; Blender and MotionBuilder read it"), false,
           true},
          {FileFormat::kCsv, QStringLiteral("csv"), Export::tr("CSV, poses as a table"), QStringLiteral(".csv"),
           Export::tr("Where every bone is in every frame, for spreadsheets and scripts"), false, false}};
}

ExportFormat export_format(const QString& id) {
  const std::vector<ExportFormat> formats = export_formats();
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const auto& one) { return one.id == id; });
  return found == formats.end() ? formats.front() : *found;
}

std::optional<ExportFormat> format_of_file(const std::filesystem::path& file) {
  const Result<FileFormat> format = interchange::format_of(file);
  for (const ExportFormat& one : export_formats()) {
    if (format && one.format == *format) {
      return one;
    }
  }
  return std::nullopt;
}

const std::vector<double>& export_rates() {
  static const std::vector<double> kRates{23.976, 24, 25, 29.97, 30, 48, 50, 59.94, 60, 100, 120};
  return kRates;
}

double proposed_rate(double own_hz) {
  constexpr double kSame = 1e-4;  // A clock that is measured is not better known.
  for (const double rate : export_rates()) {
    if (std::abs(own_hz / rate - 1.0) < kSame) {
      return rate;
    }
  }
  for (const double rate : {120.0, 60.0, 50.0, 30.0, 25.0, 24.0}) {
    if (rate <= own_hz) {
      return rate;
    }
  }
  return own_hz;
}

std::vector<PresetEntry> read_presets() {
  std::vector<PresetEntry> entries;
  const std::filesystem::path mine = user_data_folder() / "presets";
  for (const std::string& name : interchange::preset_names()) {
    PresetEntry entry{name, {}, {}, false};
    std::error_code ignored;
    entry.own = std::filesystem::exists(mine / (name + ".json"), ignored);
    if (Result<interchange::Preset> preset = interchange::load_preset(name)) {
      entry.preset = *std::move(preset);
    } else {
      entry.error = preset.error();
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

interchange::Preset effective_preset(const ExportChoices& choices, const interchange::Preset& preset) {
  interchange::Preset made = preset;
  made.root_motion = choices.root_motion.value_or(made.root_motion);
  made.rest = choices.rest.value_or(made.rest);
  made.rest_frame = choices.rest_frame.value_or(made.rest_frame);
  made.bone_map = choices.bone_map.value_or(made.bone_map);
  const ExportFormat format = export_format(choices.format);
  made.unit = choices.unit.value_or(format.format == FileFormat::kBvh ? made.bvh_unit : made.unit);
  if (!format.has_unit) {
    made.unit = FileUnit::kMetres;
  }
  if (!format.has_frames) {
    made.bone_axis = interchange::BoneAxis::kAsIs;
    made.root_bone.clear();
  }
  if (format.format == FileFormat::kCsv) {
    made.rest_frame = false;
  }
  if (made.root_motion == RootMotion::kOnRoot && made.root_bone.empty()) {
    made.root_motion = RootMotion::kFree;
  }
  return made;
}

interchange::ExportOptions export_options(const ExportChoices& choices, const interchange::Preset& preset,
                                          double begin_s, double end_s) {
  interchange::ExportOptions options;
  options.preset = preset;
  options.preset.rest = choices.rest.value_or(preset.rest);
  options.preset.rest_frame = choices.rest_frame.value_or(preset.rest_frame);
  options.preset.bone_map = choices.bone_map.value_or(preset.bone_map);
  options.fps = choices.fps.value_or(0.0);
  options.begin_s = begin_s;
  options.end_s = end_s;
  options.root_motion = choices.root_motion;
  options.unit = choices.unit;
  options.key_tolerance_rad = radians(choices.key_tolerance_deg);
  options.mesh = choices.body != ExportBody::kNone;
  return options;
}

ExportChoices remembered_choices(QSettings& settings, const std::string& preset, const QString& format) {
  ExportChoices choices;
  choices.preset = preset;
  const QString at = group(preset);
  const bool known = settings.contains(at + QStringLiteral("format"));
  choices.format = export_format(settings.value(at + QStringLiteral("format"), format).toString()).id;
  if (!known && !reads(preset, choices.format)) {
    choices.format = usual_format(preset);
  }
  bool number = false;
  const double fps = settings.value(at + QStringLiteral("fps")).toDouble(&number);
  if (number && (fps == 0.0 || (fps >= kLowestRate && fps <= kHighestRate))) {
    choices.fps = fps;
  }
  choices.root_motion = get<RootMotion>(settings, at + QStringLiteral("root"), 1);
  choices.rest = get<RestPose>(settings, at + QStringLiteral("rest"), 1);
  choices.rest_frame = get<bool>(settings, at + QStringLiteral("rest_frame"), 1);
  choices.unit = get<FileUnit>(settings, at + QStringLiteral("unit"), 1);
  if (settings.contains(at + QStringLiteral("names"))) {
    choices.bone_map = settings.value(at + QStringLiteral("names")).toString().toStdString();
  }
  choices.key_tolerance_deg =
      std::clamp(settings.value(at + QStringLiteral("tolerance_deg"), 0.0).toDouble(), 0.0, kMostTolerance);
  choices.body = get<ExportBody>(settings, at + QStringLiteral("body"), 2).value_or(ExportBody::kMannequin);
  choices.mesh = settings.value(at + QStringLiteral("mesh")).toString().toStdString();
  return choices;
}

void remember_choices(QSettings& settings, const ExportChoices& choices) {
  const QString at = group(choices.preset);
  settings.setValue(kLastPreset, QString::fromStdString(choices.preset));
  settings.setValue(at + QStringLiteral("format"), choices.format);
  if (choices.fps) {
    settings.setValue(at + QStringLiteral("fps"), *choices.fps);
  } else {
    settings.remove(at + QStringLiteral("fps"));
  }
  put(settings, at + QStringLiteral("root"), choices.root_motion);
  put(settings, at + QStringLiteral("rest"), choices.rest);
  put(settings, at + QStringLiteral("rest_frame"), choices.rest_frame);
  put(settings, at + QStringLiteral("unit"), choices.unit);
  if (choices.bone_map) {
    settings.setValue(at + QStringLiteral("names"), QString::fromStdString(*choices.bone_map));
  } else {
    settings.remove(at + QStringLiteral("names"));
  }
  settings.setValue(at + QStringLiteral("tolerance_deg"), choices.key_tolerance_deg);
  settings.setValue(at + QStringLiteral("body"), static_cast<int>(choices.body));
  settings.setValue(at + QStringLiteral("mesh"), QString::fromStdString(choices.mesh.string()));
}

std::string remembered_preset(const QSettings& settings) {
  return settings.value(kLastPreset, QStringLiteral("plain")).toString().toStdString();
}

std::filesystem::path default_export_file(const std::filesystem::path& origin, const std::string& solve,
                                          const QString& extension) {
  std::string name = origin.stem().string();
  if (!solve.empty() && solve != "default") {
    name += "-" + solve;
  }
  std::filesystem::path file = origin.parent_path() / (name + extension.toStdString());
  return file == origin ? origin.parent_path() / (name + "-export" + extension.toStdString()) : file;
}

QString with_extension(const QString& file, const QString& extension) {
  const std::filesystem::path path = file.toStdString();
  if (file.endsWith(extension, Qt::CaseInsensitive)) {
    return file;
  }
  if (!path.has_filename() || !path.has_extension()) {
    return path.has_filename() ? file + extension : file;
  }
  if (!format_of_file(path)) {
    return file + extension;
  }
  return file.left(file.size() - QString::fromStdString(path.extension().string()).size()) + extension;
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

QString size_text(std::uintmax_t bytes) {
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

}  // namespace limbwave::ui
