/// The take that is open: the studio's document. Title, recent list and every workspace follow it.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>

#include "common/job_runner.h"
#include "common/studio_services.h"
#include "take/take.h"

namespace limbwave::ui {

class TakeDocument : public QObject {
  Q_OBJECT
 public:
  TakeDocument(const StudioServices& services, JobRunner& jobs, QObject* parent = nullptr);
  /// Null while none is open.
  [[nodiscard]] const std::shared_ptr<const take::Take>& take() const { return take_; }
  [[nodiscard]] bool is_open() const { return take_ != nullptr; }
  /// "walk-01" of walk-01.take; empty while none is open.
  [[nodiscard]] QString name() const;
  /// Another number for every take that is opened: it stays when the take gets another name.
  [[nodiscard]] int opening() const { return opening_; }
  /// Where the open take's capture begins, seconds of the take: time 0 of a solved clip. 0 while none is open.
  [[nodiscard]] double capture_start_s() const;
  /// Opens in a job; ends in `changed` or `open_failed`.
  void open(const QString& folder);
  /// Shows this take, which is already read: after recording, or changed by a calibration. The same folder counts as
  /// the same take: `changed(false)`.
  void set(take::Take take);
  /// The open take with other events: markers were changed. Ends in `events_changed`; signal, rig and calibration stay.
  void set_events(std::vector<take::TakeEvent> events);
  /// The open take under another name (folder), or said to be worn by somebody else. Ends in `described`.
  void describe(const std::filesystem::path& folder, const std::string& subject);
  void close();

 Q_SIGNALS:
  /// `other`: another take than before, so that selections and playheads start anew.
  void changed(bool other);
  void events_changed();  ///< Nothing else of the take.
  void described();       ///< Folder or subject, nothing else: signal, rig and calibration stay.
  void open_failed(const QString& folder, const limbwave::Error& error);

 private:
  const StudioServices& services_;
  JobRunner& jobs_;
  int attempt_ = 0;  ///< Counts what was asked for, so that the last one wins.
  int opening_ = 0;
  std::shared_ptr<const take::Take> take_;
};

}  // namespace limbwave::ui
