/// What a workspace gets handed: the take, the selection, time, the live capture, jobs, undo, settings. Nothing else in
/// the studio is global.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QUndoStack>
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

  /// Who wears the sensors now: mountings are kept per person, and takes are recorded as theirs.
  [[nodiscard]] QString wearer() const;
  /// The running capture then goes by this person's mountings.
  void set_wearer(const QString& wearer);

  /// Where new takes go: the setting, else ~/Limbwave. Made when it does not exist.
  [[nodiscard]] QString takes_folder() const;
  void set_takes_folder(const QString& folder);
  /// How long recording into that folder lasts until its disk is full, seconds: as the session says while it records,
  /// else from the free space at the running capture's rate, or at 48 kHz in 16 bit stereo. Negative while it is not
  /// known: the disk is asked beside the window, since it may be a network's or asleep.
  [[nodiscard]] double disk_left_s() const;

  /// Shows a workspace ("capture", "calibrate", "solve", "export", "welcome") and there the place of a topic: "record",
  /// "devices", "sensors", "sensor:2", "line", "disk", "latency", or one of the workspace's own.
  void reveal(const QString& workspace, const QString& topic = {}) { Q_EMIT reveal_requested(workspace, topic); }

 Q_SIGNALS:
  void wearer_changed();
  void reveal_requested(const QString& workspace, const QString& topic);

 private:
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
  struct DiskSpace;
  mutable QElapsedTimer disk_asked_;         ///< At most once a second.
  mutable std::shared_ptr<DiskSpace> disk_;  ///< Of the takes folder; outlives this in the hands of who asks.
  mutable QString made_folder_;              ///< Made already.
};

}  // namespace limbwave::ui
