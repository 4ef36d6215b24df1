/// Edits of keys that can be undone. Each holds the keys it touches before and after, and nothing else.
#pragma once

#include <QUndoCommand>
#include <QUndoStack>
#include <vector>

#include "timeline/key_model.h"

namespace limbwave::ui {

/// Edits of one gesture (a drag, a slider's travel) carry the same gesture number and become one step of undo.
inline constexpr int kNoGesture = 0;

class ChangeKeysCommand : public QUndoCommand {
 public:
  ChangeKeysCommand(KeyModel& model, std::vector<KeyChange> changes, const QString& text, int gesture = kNoGesture);
  void redo() override;
  void undo() override;
  [[nodiscard]] int id() const override { return gesture_ == kNoGesture ? -1 : 0x6b65; }
  bool mergeWith(const QUndoCommand* other) override;

 private:
  KeyModel& model_;
  std::vector<KeyChange> changes_;
  int gesture_;
};

/// What users do with keys. All push onto the stack; false when nothing was done.
class KeyEditor : public QObject {
  Q_OBJECT
 public:
  KeyEditor(KeyModel& model, QUndoStack& stack, QObject* parent = nullptr);

  [[nodiscard]] KeyModel& model() { return model_; }
  [[nodiscard]] const std::vector<KeyPlace>& selected() const { return selected_; }
  [[nodiscard]] bool is_selected(const KeyPlace& place) const;
  void select(std::vector<KeyPlace> places);

  /// A number for the edits of a new gesture.
  int begin_gesture() { return ++gestures_; }

  /// Sets the value at a time: changes the key that stands there (within half a frame) or adds one. Radians.
  bool set_value(int lane, double time_s, double value, int gesture = kNoGesture);
  /// Changes one key's value.
  bool change_value(const KeyPlace& place, double value, int gesture = kNoGesture);
  /// Moves keys by the same time, shortened so that none meets another or leaves the clip.
  bool move(const std::vector<KeyPlace>& places, double by_s, int gesture = kNoGesture);
  /// Turns the values of keys by the same angle.
  bool turn(const std::vector<KeyPlace>& places, double by, int gesture = kNoGesture);
  bool remove(const std::vector<KeyPlace>& places);

 Q_SIGNALS:
  void selection_changed();

 private:
  bool push(std::vector<KeyChange> changes, const QString& text, int gesture);
  KeyModel& model_;
  QUndoStack& stack_;
  std::vector<KeyPlace> selected_;
  int gestures_ = 0;
};

}  // namespace limbwave::ui
