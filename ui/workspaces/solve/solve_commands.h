/// Edits of a solve that can be undone, besides keys (timeline/key_commands.h).
#pragma once

#include <QUndoCommand>

#include "timeline/key_commands.h"
#include "workspaces/solve/solve_model.h"

namespace limbwave::ui {

/// Another length of a bone.
class ChangeLengthCommand : public QUndoCommand {
 public:
  ChangeLengthCommand(SolveModel& model, int segment, double before, double after, const QString& text, int gesture)
      : QUndoCommand(text), model_(model), segment_(segment), before_(before), after_(after), gesture_(gesture) {}
  void redo() override { model_.set_length(segment_, after_); }
  void undo() override { model_.set_length(segment_, before_); }
  [[nodiscard]] int id() const override { return gesture_ == kNoGesture ? -1 : 0x6c65; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const ChangeLengthCommand*>(other);
    if (next == nullptr || next->gesture_ != gesture_ || next->segment_ != segment_) {
      return false;
    }
    after_ = next->after_;
    return true;
  }

 private:
  SolveModel& model_;
  int segment_;
  double before_, after_;
  int gesture_;
};

/// Other settings, which need a new solve.
class ChangeSettingsCommand : public QUndoCommand {
 public:
  ChangeSettingsCommand(SolveModel& model, solve::SolveSettings before, solve::SolveSettings after, const QString& text,
                        int gesture)
      : QUndoCommand(text), model_(model), before_(std::move(before)), after_(std::move(after)), gesture_(gesture) {}
  void redo() override { model_.set_settings(after_); }
  void undo() override { model_.set_settings(before_); }
  [[nodiscard]] int id() const override { return gesture_ == kNoGesture ? -1 : 0x7365; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const ChangeSettingsCommand*>(other);
    if (next == nullptr || next->gesture_ != gesture_) {
      return false;
    }
    after_ = next->after_;
    return true;
  }

 private:
  SolveModel& model_;
  solve::SolveSettings before_, after_;
  int gesture_;
};

}  // namespace limbwave::ui
