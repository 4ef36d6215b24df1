/// What is selected. There is one selection: chosen anywhere, it is chosen everywhere.
#pragma once

#include <QObject>
#include <cstdint>

namespace limbwave::ui {

enum class SelectionKind { kNone, kSensor, kSegment, kHeadingKey, kMarker };

struct SelectedItem {
  SelectionKind kind = SelectionKind::kNone;
  int index =
      -1;        ///< Of the sensor in the rig, of the segment in the skeleton; of a marker its number within the take.
  int key = -1;  ///< For kHeadingKey: the key's index on segment `index`.
  bool operator==(const SelectedItem&) const = default;
};

class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  [[nodiscard]] const SelectedItem& item() const { return item_; }
  /// Index of what is selected when it is of this kind, else -1.
  [[nodiscard]] int index_of(SelectionKind kind) const { return item_.kind == kind ? item_.index : -1; }
  void select(const SelectedItem& item) {
    if (!(item == item_)) {
      item_ = item;
      Q_EMIT changed(item_);
    }
  }
  /// Number of the selected marker; 0: none.
  [[nodiscard]] std::int64_t marker() const { return item_.kind == SelectionKind::kMarker ? item_.index : 0; }
  void select_marker(std::int64_t number) { select(SelectionKind::kMarker, static_cast<int>(number)); }
  void select(SelectionKind kind, int index) { select(SelectedItem{kind, index, -1}); }
  void clear() { select(SelectedItem{}); }

 Q_SIGNALS:
  void changed(const limbwave::ui::SelectedItem& item);

 private:
  SelectedItem item_;
};

}  // namespace limbwave::ui
