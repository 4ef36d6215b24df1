/// Keys on the lanes of the timeline: for every segment the rotation about the vertical at some times. Keys have ids
/// that outlive sorting, so that undo finds them again.
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

namespace limbwave::ui {

using KeyId = int;

struct LaneKey {
  KeyId id = 0;
  double time_s = 0.0;  ///< In the clip.
  double value = 0.0;   ///< Radians.
  bool operator==(const LaneKey&) const = default;
};

/// One key before and after: empty before = added, empty after = removed. Both carry the same id.
struct KeyChange {
  int lane = 0;
  std::optional<LaneKey> before;
  std::optional<LaneKey> after;
};

/// The key that is being edited, on which lane.
struct KeyPlace {
  int lane = -1;
  KeyId id = -1;
  bool operator==(const KeyPlace&) const = default;
};

class KeyModel : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// A new clip: these lanes, without keys. Ids start anew: whoever calls this clears the undo stack.
  void reset(const std::vector<QString>& lane_names, double duration_s, double frame_s);
  /// Fills a lane, for what was loaded; ids are given here.
  void load(int lane, const std::vector<LaneKey>& keys);

  [[nodiscard]] int lane_count() const { return static_cast<int>(lanes_.size()); }
  [[nodiscard]] const QString& lane_name(int lane) const { return at(lane).name; }
  /// In order of time.
  [[nodiscard]] const std::vector<LaneKey>& keys(int lane) const { return at(lane).keys; }
  [[nodiscard]] const LaneKey* find(int lane, KeyId id) const;
  /// Position of a key on its lane, or -1.
  [[nodiscard]] int index_of(int lane, KeyId id) const;
  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] double frame_s() const { return frame_s_; }
  /// Keys of one lane are at least this far apart: half a frame.
  [[nodiscard]] double smallest_gap_s() const { return 0.5 * frame_s_; }
  /// Linear between keys, held outside, 0 without keys. Radians.
  [[nodiscard]] double value_at(int lane, double time_s) const;
  /// An id that no key has had yet.
  [[nodiscard]] KeyId new_id() { return next_id_++; }

  /// All changes or none: false when a `before` is not what is there, or when afterwards two keys of a lane would stand
  /// on the same time or one outside the clip.
  bool apply(const std::vector<KeyChange>& changes);

 Q_SIGNALS:
  void lanes_changed();
  /// Keys of some lanes are different.
  void keys_changed();

 private:
  struct Lane {
    QString name;
    std::vector<LaneKey> keys;
  };
  [[nodiscard]] const Lane& at(int lane) const { return lanes_.at(static_cast<std::size_t>(lane)); }
  std::vector<Lane> lanes_;
  double duration_s_ = 0.0;
  double frame_s_ = 1.0 / 60.0;
  KeyId next_id_ = 1;
};

}  // namespace limbwave::ui
