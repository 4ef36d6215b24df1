#include "timeline/key_commands.h"

#include <algorithm>
#include <cmath>

#include "timeline/timeline_geometry.h"

namespace limbwave::ui {

ChangeKeysCommand::ChangeKeysCommand(KeyModel& model, std::vector<KeyChange> changes, const QString& text, int gesture)
    : QUndoCommand(text), model_(model), changes_(std::move(changes)), gesture_(gesture) {}

void ChangeKeysCommand::redo() {
  if (!model_.apply(changes_)) {
    setObsolete(true);
  }
}

void ChangeKeysCommand::undo() {
  std::vector<KeyChange> back = changes_;
  for (KeyChange& change : back) {
    std::swap(change.before, change.after);
  }
  if (!model_.apply(back)) {
    setObsolete(true);
  }
}

bool ChangeKeysCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const ChangeKeysCommand*>(other);
  if (next == nullptr || next->gesture_ != gesture_ || &next->model_ != &model_) {
    return false;
  }
  for (const KeyChange& change : next->changes_) {
    // The same key again: its first state before, its last one after.
    const auto mine = std::find_if(changes_.begin(), changes_.end(), [&](const KeyChange& c) {
      return c.lane == change.lane && c.after && change.before && c.after->id == change.before->id;
    });
    if (mine != changes_.end()) {
      mine->after = change.after;
    } else {
      changes_.push_back(change);
    }
  }
  return true;
}

KeyEditor::KeyEditor(KeyModel& model, QUndoStack& stack, QObject* parent)
    : QObject(parent), model_(model), stack_(stack) {
  // Undo may take away what is selected.
  connect(&model_, &KeyModel::keys_changed, this, [this] {
    std::vector<KeyPlace> left;
    std::copy_if(selected_.begin(), selected_.end(), std::back_inserter(left),
                 [this](const KeyPlace& place) { return model_.find(place.lane, place.id) != nullptr; });
    select(std::move(left));
  });
}

bool KeyEditor::is_selected(const KeyPlace& place) const {
  return std::find(selected_.begin(), selected_.end(), place) != selected_.end();
}

void KeyEditor::select(std::vector<KeyPlace> places) {
  if (places != selected_) {
    selected_ = std::move(places);
    Q_EMIT selection_changed();
  }
}

bool KeyEditor::push(std::vector<KeyChange> changes, const QString& text, int gesture) {
  if (changes.empty()) {
    return false;
  }
  auto* command = new ChangeKeysCommand(model_, std::move(changes), text, gesture);
  // A command that changed nothing is dropped by the stack. What was undone before goes in any case, so the count tells
  // nothing.
  const int before = stack_.index();
  stack_.push(command);
  return gesture != kNoGesture || stack_.index() > before;
}

bool KeyEditor::set_value(int lane, double time_s, double value, int gesture) {
  if (lane < 0 || lane >= model_.lane_count()) {
    return false;
  }
  const double time = std::clamp(snapped_to_frame(time_s, model_.frame_s()), 0.0, model_.duration_s());
  for (const LaneKey& key : model_.keys(lane)) {
    if (std::abs(key.time_s - time) < model_.smallest_gap_s() - 1e-9) {
      return change_value({lane, key.id}, value, gesture);
    }
  }
  const LaneKey added{model_.new_id(), time, value};
  const bool done = push({{lane, std::nullopt, added}}, tr("set key of %1").arg(model_.lane_name(lane)), gesture);
  if (done) {
    select({{lane, added.id}});
  }
  return done;
}

bool KeyEditor::change_value(const KeyPlace& place, double value, int gesture) {
  const LaneKey* key = model_.find(place.lane, place.id);
  if (key == nullptr || key->value == value) {
    return false;
  }
  return push({{place.lane, *key, LaneKey{key->id, key->time_s, value}}},
              tr("change key of %1").arg(model_.lane_name(place.lane)), gesture);
}

bool KeyEditor::move(const std::vector<KeyPlace>& places, double by_s, int gesture) {
  // The group keeps its shape: the least of what each key may move decides.
  double allowed = by_s;
  for (const KeyPlace& place : places) {
    const LaneKey* key = model_.find(place.lane, place.id);
    if (key == nullptr) {
      return false;
    }
    std::vector<double> others;
    for (const LaneKey& other : model_.keys(place.lane)) {
      if (std::find(places.begin(), places.end(), KeyPlace{place.lane, other.id}) == places.end()) {
        others.push_back(other.time_s);
      }
    }
    const double to = free_time(key->time_s + allowed, key->time_s, others, model_.frame_s(), model_.duration_s());
    if (std::abs(to - key->time_s) < std::abs(allowed) || (to - key->time_s) * allowed < 0.0) {
      allowed = (to - key->time_s) * allowed < 0.0 ? 0.0 : to - key->time_s;
    }
  }
  std::vector<KeyChange> changes;
  for (const KeyPlace& place : places) {
    const LaneKey* key = model_.find(place.lane, place.id);
    changes.push_back({place.lane, *key, LaneKey{key->id, key->time_s + allowed, key->value}});
  }
  if (std::abs(allowed) < 1e-9) {
    return false;
  }
  return push(std::move(changes), tr("move %n key(s)", nullptr, static_cast<int>(places.size())), gesture);
}

bool KeyEditor::turn(const std::vector<KeyPlace>& places, double by, int gesture) {
  std::vector<KeyChange> changes;
  for (const KeyPlace& place : places) {
    if (const LaneKey* key = model_.find(place.lane, place.id)) {
      changes.push_back({place.lane, *key, LaneKey{key->id, key->time_s, key->value + by}});
    }
  }
  return push(std::move(changes), tr("turn %n key(s)", nullptr, static_cast<int>(places.size())), gesture);
}

bool KeyEditor::remove(const std::vector<KeyPlace>& places) {
  std::vector<KeyChange> changes;
  for (const KeyPlace& place : places) {
    if (const LaneKey* key = model_.find(place.lane, place.id)) {
      changes.push_back({place.lane, *key, std::nullopt});
    }
  }
  return push(std::move(changes), tr("delete %n key(s)", nullptr, static_cast<int>(places.size())), kNoGesture);
}

}  // namespace limbwave::ui
