/// What a workspace gets handed: the take, the selection, time, the live capture, jobs, undo, settings. Nothing else in
/// the studio is global.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <atomic>
#include <memory>

#include "common/job_runner.h"
#include "common/live_model.h"
#include "common/marker_model.h"
#include "common/notifications.h"
#include "common/recent_takes.h"
#include "common/save_queue.h"
#include "common/selection.h"
#include "common/studio_services.h"
#include "common/take_document.h"
#include "common/take_edits.h"
#include "common/time_model.h"

namespace limbwave::ui {

class StudioContext : public QObject {
  Q_OBJECT
 public:
  /// Settings are kept in `settings_folder`/studio.ini; the folder is made when needed.
  StudioContext(StudioServices services, const QString& settings_folder, QObject* parent = nullptr);
  ~StudioContext() override;

  [[nodiscard]] const StudioServices& services() const { return services_; }
  QSettings& settings() { return settings_; }
  JobRunner& jobs() { return jobs_; }
  Notifications& notifications() { return notifications_; }
  RecentTakes& recent_takes() { return recent_takes_; }
  TakeDocument& document() { return document_; }
  Selection& selection() { return selection_; }
  TimeModel& time() { return time_; }
  QUndoStack& undo_stack() { return undo_stack_; }
  LiveModel& live() { return live_; }
  /// Writes to the open take, in order.
  SaveQueue& saves() { return saves_; }
  MarkerModel& markers() { return markers_; }
  /// Name, subject and sensors of the open take.
  TakeEdits& take_edits() { return take_edits_; }

  /// Who wears the sensors now: mountings are kept per person, and takes are recorded as theirs.
  [[nodiscard]] QString wearer() const;
  /// The running capture then goes by this person's mountings.
  void set_wearer(const QString& wearer);

  /// File name of the animation of another program that is looked at instead of a take; empty: none is.
  [[nodiscard]] const QString& animation() const { return animation_; }
  void set_animation(const QString& name);
  /// What the window is about: the animation or the take; empty: neither is open.
  [[nodiscard]] QString title() const { return animation_.isEmpty() ? document_.name() : animation_; }

  /// Where new takes go: the setting, else ~/Limbwave.
  [[nodiscard]] QString takes_folder() const;
  void set_takes_folder(const QString& folder);
  /// How long recording into that folder lasts until its disk is full, seconds: as the session says while it records,
  /// else from the free space at the running capture's rate, or at 48 kHz in 16 bit stereo. Negative: not known yet.
  [[nodiscard]] double disk_left_s();

  /// Shows a workspace ("capture", "calibrate", "solve", "export", "welcome") and there the place of a topic: "record",
  /// "devices", "sensors", "sensor:2", "line", "disk", "latency", or one of the workspace's own. "manual" is the
  /// manual, its topics are the chapters: "levels".
  void reveal(const QString& workspace, const QString& topic = {}) { Q_EMIT reveal_requested(workspace, topic); }

 Q_SIGNALS:
  void takes_folder_changed();
  void disk_changed();  ///< It is known how much room there is.
  void wearer_changed();
  void animation_changed();
  void reveal_requested(const QString& workspace, const QString& topic);

 private:
  void ask_disk();
  StudioServices services_;
  QSettings settings_;
  JobRunner jobs_;
  Notifications notifications_;
  RecentTakes recent_takes_;
  TakeDocument document_;
  Selection selection_;
  TimeModel time_;
  QUndoStack undo_stack_;
  LiveModel live_;
  SaveQueue saves_;
  MarkerModel markers_;
  TakeEdits take_edits_;
  QString animation_;
  /// Asked beside the window, for a disk may be asleep, and by a thread of its own that nobody waits for.
  struct Disk {
    std::atomic<qint64> free{-1};  ///< Bytes.
    std::atomic<bool> answered{false};
  };
  std::shared_ptr<Disk> disk_, asked_disk_;
  QElapsedTimer disk_asked_;
  QTimer disk_timer_;
};

}  // namespace limbwave::ui
