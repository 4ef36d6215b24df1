/// An edit of what is calibrated from a recording, as one step of undo.
#pragma once

#include <QPointer>
#include <QUndoCommand>

#include "calibration/stretch_model.h"

namespace limbwave::ui {

/// Another movement, or other stretches. Edits of one gesture (a drag) are one step.
class StretchCommand : public QUndoCommand {
 public:
  StretchCommand(StretchModel& model, const StretchChoice& after, const QString& text, int gesture);
  void undo() override { put(before_); }
  void redo() override { put(after_); }
  [[nodiscard]] int id() const override { return gesture_ < 0 ? -1 : 0x7374; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  void put(const StretchChoice& choice);

  QPointer<StretchModel> model_;
  StretchChoice before_, after_;
  int gesture_;
};

}  // namespace limbwave::ui
