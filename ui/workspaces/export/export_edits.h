/// Undo of the Export page: everything that is chosen there, and one step from one such state to another.
#pragma once

#include <QPointer>
#include <QString>
#include <QUndoCommand>
#include <optional>
#include <utility>

#include "workspaces/export/export_model.h"

namespace limbwave::ui {

/// Which of the choices an edit was about; what differs first, in this order.
enum class ExportField {
  kNone,
  kSource,
  kActors,
  kPreset,
  kFormat,
  kRate,
  kRange,
  kRoot,
  kRest,
  kNames,
  kUnit,
  kKeys,
  kBody,
  kFile
};
ExportField changed_field(const ExportState& before, const ExportState& after);
/// "frame rate of the export": what undo is going to bring back.
QString field_text(ExportField field);
/// Whether edits of this field that follow each other are one step: letters and turned numbers.
bool is_typed(ExportField field, const ExportState& before, const ExportState& after);

/// Is pushed when the edit is done already.
class ExportCommand : public QUndoCommand {
 public:
  ExportCommand(ExportModel& model, ExportState before, ExportState after);
  void redo() override;
  void undo() override;
  [[nodiscard]] int id() const override { return 0x6578; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  QPointer<ExportModel> model_;
  ExportState before_, after_;
  ExportField field_;
  bool done_ = true;
};

}  // namespace limbwave::ui
