/// The markers of the running recording, else of the open take, and everything that can be done to them. Every change
/// is one step of undo and is written into the take at once.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "common/live_model.h"
#include "common/save_queue.h"
#include "common/take_document.h"

namespace limbwave::ui {

struct Marker {
  std::int64_t number = 0;  ///< Within its take; stays when it is moved or renamed.
  std::int64_t sample = 0;  ///< Of the take.
  QString text;
  bool operator==(const Marker&) const = default;
};

/// One marker before and after; empty: it does not exist.
struct MarkerChange {
  std::optional<Marker> before, after;
};

class MarkerModel : public QObject {
  Q_OBJECT
 public:
  MarkerModel(TakeDocument& document, LiveModel& live, SaveQueue& saves, QUndoStack& undo, QObject* parent = nullptr);

  /// In order of time.
  [[nodiscard]] const std::vector<Marker>& markers() const { return markers_; }
  [[nodiscard]] const Marker* find(std::int64_t number) const;
  /// Number of the marker that was set last; 0: none was.
  [[nodiscard]] std::int64_t newest() const { return newest_; }
  [[nodiscard]] double time_s(const Marker& marker) const;
  /// Markers can be moved from 0 to here, seconds.
  [[nodiscard]] double duration_s() const;
  /// There is a recording or a take.
  [[nodiscard]] bool editable() const;
  [[nodiscard]] bool recording() const { return recording_; }

  /// At this moment of the running recording. Without words it is "Marker 3". False when nothing is recorded.
  bool mark_now(const QString& text = {});
  /// At a time of the open take (or of what is recorded).
  bool add(double time_s, const QString& text = {});
  /// Empty words are refused.
  bool rename(std::int64_t number, const QString& text);
  /// Moves of one `gesture` (≥ 0) become one step of undo.
  bool move(std::int64_t number, double time_s, int gesture = -1);
  bool remove(std::int64_t number);
  /// The stack was emptied because another take is open: when that is the recording that was just closed, what was done
  /// to its markers can be undone again.
  void restore_undo();

 Q_SIGNALS:
  void changed();

 private:
  friend class MarkerCommand;
  bool push(MarkerChange change, const QString& text, int gesture = -1);
  /// Shows it and writes it. False when the marker is not in the state `from` any more, or its take is gone.
  bool apply(const std::optional<Marker>& from, const std::optional<Marker>& to);
  void follow_document();
  void follow_recording();
  [[nodiscard]] double rate_hz() const;
  [[nodiscard]] QString next_words() const;

  TakeDocument& document_;
  LiveModel& live_;
  SaveQueue& saves_;
  QUndoStack& undo_;
  std::vector<Marker> markers_;
  bool recording_ = false;
  std::int64_t newest_ = 0;
  std::filesystem::path folder_;  ///< Of the recording whose markers are shown.
  /// What was done to the markers while recording, without what was undone: the stack starts anew when the take opens,
  /// and gets these again.
  std::vector<std::pair<MarkerChange, QString>> done_live_;
};

}  // namespace limbwave::ui
