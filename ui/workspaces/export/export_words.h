/// What an export's choices mean, in plain words: what a preset sets, and what to look out for. No widgets.
#pragma once

#include <QString>
#include <QStringList>

#include "workspaces/export/export_plan.h"

namespace limbwave::ui {

/// Whether the program that a preset is for opens files of this format by itself. Presets of the user's own are for
/// programs that we know nothing of: they are trusted.
bool reads(const std::string& preset, const QString& format);
/// The format that one hands to that program.
QString usual_format(const std::string& preset);

/// "Unreal Engine"; of a preset that cannot be read its name.
QString preset_title(const PresetEntry& entry);
/// The preset's sentence about itself, in the user's language where it is a shipped one.
QString preset_comment(const interchange::Preset& preset);
/// What the preset, as chosen, does to the file: a short sentence each.
QStringList preset_facts(const interchange::Preset& preset, const ExportFormat& format);

QString root_motion_text(const interchange::Preset& preset);
QString rest_text(interchange::RestPose rest);
QString unit_text(interchange::FileUnit unit);
/// "HumanIK" of the map "humanik"; for none "as captured".
QString bone_map_title(const std::string& name);

/// What is known of the motion that is exported.
struct MotionFacts {
  double rate_hz = 0.0;
  bool person = true;  ///< Bones of a person were found by their names.
};

/// What the user should know before the file goes to somebody else; empty: all is well.
QStringList export_warnings(const ExportChoices& choices, const interchange::Preset& preset, const MotionFacts& motion);

}  // namespace limbwave::ui
