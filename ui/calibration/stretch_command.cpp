#include "calibration/stretch_command.h"

namespace limbwave::ui {

StretchCommand::StretchCommand(StretchModel& model, const StretchChoice& after, const QString& text, int gesture)
    : QUndoCommand(text), model_(&model), before_(model.choice()), after_(after), gesture_(gesture) {}

void StretchCommand::put(const StretchChoice& choice) {
  if (model_) {
    model_->put_choice(choice);
  } else {
    setObsolete(true);
  }
}

bool StretchCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const StretchCommand*>(other);
  if (next == nullptr || next->gesture_ != gesture_) {
    return false;
  }
  after_ = next->after_;
  setObsolete(after_ == before_);  // Dragged away and back.
  return true;
}

}  // namespace limbwave::ui
