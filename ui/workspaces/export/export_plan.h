/// What can be chosen for an export: formats, frame rates, presets, and the file's name. No widgets.
#pragma once

#include <QSettings>
#include <QString>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "interchange/export_file.h"

namespace limbwave::ui {

struct ExportFormat {
  interchange::FileFormat format;
  QString id;         ///< "fbx": stable, for settings.
  QString title;      ///< "FBX"
  QString extension;  ///< ".fbx"
  QString hint;       ///< What is in it and who reads it.
  bool has_frames;    ///< Bones with axes of their own, meshes and keys; else one root, every frame, the world's axes.
  bool has_unit;      ///< Lengths are in centimetres or metres as one likes.
};

std::vector<ExportFormat> export_formats();
/// By id; the first one for unknown ids.
ExportFormat export_format(const QString& id);
/// The format that a file's ending means; empty: none.
std::optional<ExportFormat> format_of_file(const std::filesystem::path& file);
/// The usual frame rates, hertz, increasing.
const std::vector<double>& export_rates();
/// The rate that is proposed for a motion that was measured at `own_hz`: its own where that is a usual one, else the
/// next of 24, 25, 30, 50, 60 and 120 below it, for programs know no 62.071 Hz; slower ones keep theirs. 0: not known.
double proposed_rate(double own_hz);

inline constexpr double kLowestRate = 1.0, kHighestRate = 1000.0;
inline constexpr double kMostTolerance = 45.0;  ///< Degrees.

enum class ExportRange { kAll, kVisible, kPart };
enum class ExportBody { kMannequin, kOwnMesh, kNone };

/// Where something is empty, the preset's own counts.
struct ExportChoices {
  std::string preset = "plain";
  QString format = QStringLiteral("fbx");
  std::optional<double> fps;  ///< 0: as the motion has it; nothing: what is proposed for it.
  ExportRange range = ExportRange::kAll;
  double begin_s = 0.0, end_s = 0.0;  ///< For kPart, time of the clip.
  std::optional<motion::RootMotion> root_motion;
  std::optional<interchange::RestPose> rest;
  std::optional<bool> rest_frame;
  std::optional<std::string> bone_map;  ///< Empty name: bones keep their own.
  std::optional<interchange::FileUnit> unit;
  double key_tolerance_deg = 0.0;
  ExportBody body = ExportBody::kMannequin;
  std::filesystem::path mesh;  ///< For kOwnMesh.
  bool operator==(const ExportChoices&) const = default;
};

/// A preset file, shipped or the user's own; without `preset` it could not be read, and `error` says why.
struct PresetEntry {
  std::string name;
  std::optional<interchange::Preset> preset;
  std::optional<Error> error;
  bool own = false;
};
/// All that are there now, "plain" first.
std::vector<PresetEntry> read_presets();

/// The preset with what the choices say otherwise, as the format can hold it.
interchange::Preset effective_preset(const ExportChoices& choices, const interchange::Preset& preset);
/// What the core is asked for. `begin_s`, `end_s`: the range in seconds of the clip.
interchange::ExportOptions export_options(const ExportChoices& choices, const interchange::Preset& preset,
                                          double begin_s, double end_s);

/// What was chosen for this preset last time; for a new one the format stays if the program reads it, and everything
/// else is as the preset has it. Ranges are not remembered: they belong to a clip.
ExportChoices remembered_choices(QSettings& settings, const std::string& preset, const QString& format);
void remember_choices(QSettings& settings, const ExportChoices& choices);
/// The preset that was used last; "plain" at first.
std::string remembered_preset(const QSettings& settings);

/// STEM with the format's ending beside `origin` (a take's folder or an animation); never `origin` itself. Another
/// solve than "default" adds its name.
std::filesystem::path default_export_file(const std::filesystem::path& origin, const std::string& solve,
                                          const QString& extension);
/// The file with the ending of another format; endings of no format stay where they are, in front.
QString with_extension(const QString& file, const QString& extension);
/// Why this file cannot be written, before trying; empty: it can.
QString export_file_problem(const std::filesystem::path& file, const QString& extension);

/// "1.2 MB", "640 kB"
QString size_text(std::uintmax_t bytes);

}  // namespace limbwave::ui
