#include "workspaces/export/export_edits.h"

#include <QCoreApplication>
#include <algorithm>

namespace limbwave::ui {

namespace {

struct ExportEdits {
  Q_DECLARE_TR_FUNCTIONS(ExportEdits)
};

bool is_listed(const std::optional<double>& fps) {
  const std::vector<double>& rates = export_rates();
  return !fps || *fps == 0.0 || std::find(rates.begin(), rates.end(), *fps) != rates.end();
}

bool same_range(const ExportChoices& a, const ExportChoices& b) {
  return a.range == b.range && a.begin_s == b.begin_s && a.end_s == b.end_s;
}

bool same_rest(const ExportChoices& a, const ExportChoices& b) {
  return a.rest == b.rest && a.rest_frame == b.rest_frame;
}

}  // namespace

ExportField changed_field(const ExportState& before, const ExportState& after) {
  const ExportChoices &a = before.choices, &b = after.choices;
  const std::pair<bool, ExportField> fields[] = {
      {before.sources.chosen != after.sources.chosen || before.sources.animations != after.sources.animations,
       ExportField::kSource},
      {before.sources.others != after.sources.others, ExportField::kActors},
      {a.preset != b.preset, ExportField::kPreset},
      {a.format != b.format, ExportField::kFormat},
      {a.fps != b.fps, ExportField::kRate},
      {!same_range(a, b), ExportField::kRange},
      {a.root_motion != b.root_motion, ExportField::kRoot},
      {!same_rest(a, b), ExportField::kRest},
      {a.bone_map != b.bone_map, ExportField::kNames},
      {a.unit != b.unit, ExportField::kUnit},
      {a.key_tolerance_deg != b.key_tolerance_deg, ExportField::kKeys},
      {a.body != b.body || a.mesh != b.mesh, ExportField::kBody},
      {before.file != after.file, ExportField::kFile}};
  const auto* found = std::find_if(std::begin(fields), std::end(fields), [](const auto& one) { return one.first; });
  return found == std::end(fields) ? ExportField::kNone : found->second;
}

QString field_text(ExportField field) {
  switch (field) {
    case ExportField::kSource:
      return ExportEdits::tr("motion of the export");
    case ExportField::kActors:
      return ExportEdits::tr("actors of the export");
    case ExportField::kPreset:
      return ExportEdits::tr("program of the export");
    case ExportField::kFormat:
      return ExportEdits::tr("format of the export");
    case ExportField::kRate:
      return ExportEdits::tr("frame rate of the export");
    case ExportField::kRange:
      return ExportEdits::tr("range of the export");
    case ExportField::kRoot:
      return ExportEdits::tr("way over the floor in the export");
    case ExportField::kRest:
      return ExportEdits::tr("rest pose of the export");
    case ExportField::kNames:
      return ExportEdits::tr("bone names of the export");
    case ExportField::kUnit:
      return ExportEdits::tr("unit of the export");
    case ExportField::kKeys:
      return ExportEdits::tr("keys of the export");
    case ExportField::kBody:
      return ExportEdits::tr("body of the export");
    case ExportField::kFile:
      return ExportEdits::tr("file of the export");
    case ExportField::kNone:
      break;
  }
  return {};
}

bool is_typed(ExportField field, const ExportState& before, const ExportState& after) {
  switch (field) {
    case ExportField::kFile:
    case ExportField::kKeys:
      return true;
    case ExportField::kRange:
      return before.choices.range == ExportRange::kPart && after.choices.range == ExportRange::kPart;
    case ExportField::kRate:
      return !is_listed(before.choices.fps) && !is_listed(after.choices.fps);
    default:
      return false;
  }
}

ExportCommand::ExportCommand(ExportModel& model, ExportState before, ExportState after)
    : model_(&model), before_(std::move(before)), after_(std::move(after)), field_(changed_field(before_, after_)) {
  setText(field_text(field_));
}

void ExportCommand::redo() {
  if (std::exchange(done_, false)) {
    return;
  }
  if (model_) {
    model_->put(after_);
  }
  setObsolete(model_ == nullptr);
}

void ExportCommand::undo() {
  if (model_) {
    model_->put(before_);
  }
  setObsolete(model_ == nullptr);
}

bool ExportCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const ExportCommand*>(other);
  if (next == nullptr || next->model_ != model_ || next->field_ != field_ || !is_typed(field_, before_, after_) ||
      !is_typed(field_, next->before_, next->after_) || next->before_ != after_) {
    return false;
  }
  after_ = next->after_;
  setObsolete(before_ == after_);
  return true;
}

}  // namespace limbwave::ui
