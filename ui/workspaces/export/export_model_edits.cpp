// What users change on the Export page, with the way back.
#include <utility>

#include "workspaces/export/export_edits.h"
#include "workspaces/export/export_model.h"

namespace limbwave::ui {

void ExportModel::choose_preset(const std::string& name) {
  ExportChoices wanted = remembered_choices(context_.settings(), name, choices_.format);
  wanted.range = choices_.range;
  wanted.begin_s = choices_.begin_s;
  wanted.end_s = choices_.end_s;
  change(wanted);
}

// Whatever comes of a change, the file's name for example, belongs to it.
void ExportModel::edit(const std::function<void()>& change) {
  if (editing_) {
    change();
    return;
  }
  ExportState before = state();
  editing_ = true;
  change();
  editing_ = false;
  if (ExportState after = state(); after != before) {
    context_.undo_stack().push(new ExportCommand(*this, std::move(before), std::move(after)));
  }
}

ExportState ExportModel::state() const {
  return {sources_.state(), choices_, file_ == suggested_ ? std::nullopt : std::optional(file_)};
}

void ExportModel::put(const ExportState& state) {
  sources_.put(state.sources);
  if (state.choices != choices_) {
    put_choices(state.choices);
  }
  put_file(state.file.value_or(suggested_));
}

void ExportModel::change(const ExportChoices& choices) {
  if (choices == choices_) {
    return;
  }
  edit([&] {
    const bool renamed = choices.format != choices_.format && file_ != suggested_;
    put_choices(choices);
    if (renamed) {
      put_file(with_extension(file_, export_format(choices_.format).extension));
    }
  });
}

void ExportModel::put_choices(const ExportChoices& choices) {
  choices_ = choices;
  remember_choices(context_.settings(), choices_);
  touch();
  Q_EMIT choices_changed();
  suggest_file();
}

void ExportModel::set_file(const QString& file) {
  edit([&] { put_file(file); });
}

void ExportModel::put_file(const QString& file) {
  if (file != file_) {
    file_ = file;
    Q_EMIT file_changed();
  }
}

void ExportModel::suggest_file() {
  if (!has_source()) {
    return;
  }
  const bool follows = file_ == suggested_;
  const ExportSource& source = *sources_.source();
  suggested_ = QString::fromStdString(
      default_export_file(source.origin, source.solve, export_format(choices_.format).extension).string());
  if (follows) {
    put_file(suggested_);
  }
}

}  // namespace limbwave::ui
