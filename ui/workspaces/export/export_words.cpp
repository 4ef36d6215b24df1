#include "workspaces/export/export_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <array>
#include <map>

#include "interchange/bone_map.h"

namespace limbwave::ui {

namespace {

struct ExportWords {
  Q_DECLARE_TR_FUNCTIONS(ExportWords)
};

using interchange::BoneAxis;
using interchange::FileFormat;
using interchange::FileUnit;
using interchange::RestPose;
using motion::RootMotion;

// What resources/presets/*.json say of themselves; looked up in the context "Preset".
[[maybe_unused]] constexpr std::array kPresetTexts{
    QT_TRANSLATE_NOOP("Preset", "Bones lie along their own y, as Blender draws them; metarig names with .L and .R."),
    QT_TRANSLATE_NOOP("Preset", "HumanIK names, joints along x, T-pose on frame 0 for characterising."),
    QT_TRANSLATE_NOOP("Preset", "HumanIK names, T-pose on frame 0, one reference above the hips."),
    QT_TRANSLATE_NOOP("Preset", "Everything as it was captured: own names, own rest pose, centimetres."),
    QT_TRANSLATE_NOOP("Preset", "Humanoid names, T-pose at rest, so that the avatar maps without help."),
    QT_TRANSLATE_NOOP("Preset", "Mannequin names under a single root, centimetres."),
    QT_TRANSLATE_NOOP("Preset", "Required humanoid bones, T-pose at rest, soles at height 0, metres."),
    QT_TRANSLATE_NOOP("Preset", "Plain")};

// Formats that a program opens as it comes, the usual one first.
const std::map<std::string, QStringList>& programs() {
  static const auto fbx = QStringLiteral("fbx"), glb = QStringLiteral("glb"), gltf = QStringLiteral("gltf"),
                    vrm = QStringLiteral("vrm"), bvh = QStringLiteral("bvh");
  static const std::map<std::string, QStringList> table{
      {"blender", {fbx, glb, gltf, bvh}}, {"maya", {fbx}},  {"motionbuilder", {fbx, bvh}},
      {"unreal", {fbx, glb, gltf}},       {"unity", {fbx}}, {"vrm", {vrm}}};
  return table;
}

QString translated(const std::string& text) {
  return QCoreApplication::translate("Preset", text.c_str());
}

QString rate_text(double hz) {
  return QLocale().toString(hz, 'g', 6);
}

}  // namespace

bool reads(const std::string& preset, const QString& format) {
  const auto found = programs().find(preset);
  return found == programs().end() || found->second.contains(format);
}

QString usual_format(const std::string& preset) {
  const auto found = programs().find(preset);
  return found == programs().end() ? QStringLiteral("fbx") : found->second.front();
}

QString preset_title(const PresetEntry& entry) {
  const QString title = entry.preset ? translated(entry.preset->title) : QString::fromStdString(entry.name);
  return entry.own ? ExportWords::tr("%1 (your own)").arg(title) : title;
}

QString preset_comment(const interchange::Preset& preset) {
  return preset.comment.empty() ? QString() : translated(preset.comment);
}

QString root_motion_text(const interchange::Preset& preset) {
  switch (preset.root_motion) {
    case RootMotion::kInPlace:
      return ExportWords::tr("in place");
    case RootMotion::kOnRoot:
      return ExportWords::tr("on the root bone");
    case RootMotion::kFree:
      break;
  }
  return ExportWords::tr("free, on the hips");
}

QString rest_text(RestPose rest) {
  return rest == RestPose::kTPose ? ExportWords::tr("T-pose") : ExportWords::tr("as captured");
}

QString unit_text(FileUnit unit) {
  return unit == FileUnit::kMetres ? ExportWords::tr("metres") : ExportWords::tr("centimetres");
}

QString bone_map_title(const std::string& name) {
  if (name.empty()) {
    return ExportWords::tr("as captured");
  }
  const Result<interchange::BoneMap> map = interchange::load_bone_map(name);
  return QString::fromStdString(map ? map->title : name);
}

QStringList preset_facts(const interchange::Preset& preset, const ExportFormat& format) {
  QStringList facts;
  facts << (preset.bone_map.empty()
                ? ExportWords::tr("Bones keep their names.")
                : ExportWords::tr("Bones are named as in %1.").arg(bone_map_title(preset.bone_map)));
  if (!format.has_frames) {
    facts << ExportWords::tr("Every bone has the world's axes.");
  } else if (preset.bone_axis != BoneAxis::kAsIs) {
    facts << ExportWords::tr("Every bone points along its own %1 axis.")
                 .arg(preset.bone_axis == BoneAxis::kX ? QLatin1Char('x') : QLatin1Char('y'));
  } else {
    facts << ExportWords::tr("Bones keep their axes.");
  }
  facts << (preset.rest == RestPose::kTPose ? ExportWords::tr("At rest the figure stands in a T-pose.")
                                            : ExportWords::tr("The rest pose stays as captured."));
  if (preset.soles_at_zero) {
    facts << ExportWords::tr("At rest the soles are at height 0.");
  }
  if (preset.rest_frame) {
    facts << ExportWords::tr("Frame 0 shows the rest pose; the motion starts on frame 1.");
  }
  if (!preset.root_bone.empty()) {
    const QString name = QString::fromStdString(preset.root_bone);
    facts << (preset.root_motion == RootMotion::kOnRoot
                  ? ExportWords::tr("The hips hang on a bone “%1”, which goes the way over the floor.").arg(name)
                  : ExportWords::tr("The hips hang on a bone “%1” at the origin.").arg(name));
  }
  if (preset.root_motion == RootMotion::kInPlace) {
    facts << ExportWords::tr("The way over the floor is taken out: the figure moves in place.");
  } else if (preset.root_motion == RootMotion::kFree) {
    facts << ExportWords::tr("The hips go the way over the floor.");
  }
  facts << ExportWords::tr("Lengths are in %1.").arg(unit_text(preset.unit));
  if (!preset.required.empty()) {
    facts << ExportWords::tr("The %1 bones that the program asks for must be there.")
                 .arg(QLocale().toString(qulonglong(preset.required.size())));
  }
  return facts;
}

QStringList export_warnings(const ExportChoices& choices, const interchange::Preset& preset,
                            const MotionFacts& motion) {
  QStringList warnings;
  const ExportFormat format = export_format(choices.format);
  const interchange::Preset chosen = effective_preset(choices, preset);
  const QString program = translated(preset.title);
  if (!reads(choices.preset, choices.format)) {
    warnings << ExportWords::tr("%1 does not open %2 files by itself. Choose %3 for it.")
                    .arg(program, format.extension, export_format(usual_format(choices.preset)).title);
  }
  if (format.format == FileFormat::kBvh && choices.preset == "blender") {
    warnings << ExportWords::tr("Blender keeps its own frame rate unless “Update Scene FPS” is on in its BVH import.");
  }
  if (format.format == FileFormat::kVrm && choices.preset != "vrm" && preset.required.empty()) {
    warnings << ExportWords::tr("Viewers refuse a .vrm without the bones and the T-pose of the VRM 1.0 preset.");
  }
  if (choices.body == ExportBody::kNone && format.has_frames) {
    if (choices.preset == "unreal") {
      warnings << ExportWords::tr("Unreal Engine refuses bones without a body. Keep the mannequin.");
    } else if (!format.has_unit) {
      warnings << ExportWords::tr("Most programs make empties instead of bones of a glTF file without a body.");
    }
  }
  if (choices.preset == "unreal" && format.has_unit && chosen.unit == FileUnit::kMetres) {
    warnings << ExportWords::tr(
        "Unreal Engine counts in centimetres: in metres the figure arrives 100 times too small.");
  }
  if (preset.rest_frame && !chosen.rest_frame && format.has_frames) {
    warnings << ExportWords::tr("%1 finds the joints of a character by the T-pose on frame 0.").arg(program);
  }
  if (!motion.person && (!chosen.bone_map.empty() || chosen.rest == RestPose::kTPose)) {
    warnings << ExportWords::tr("The bones do not look like a person's: they keep their names and their rest pose.");
  }
  constexpr double kSameRate = 1.001;
  if (motion.rate_hz > 0.0 && choices.fps.value_or(0.0) > motion.rate_hz * kSameRate) {
    warnings << ExportWords::tr("The motion has %1 frames a second; the frames in between are interpolated.")
                    .arg(rate_text(motion.rate_hz));
  }
  return warnings;
}

}  // namespace limbwave::ui
