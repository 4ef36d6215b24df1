/// What can be changed about the open take: its name, who wore it, which sensor hung where. Every change is one step of
/// undo, shows at once, and goes to disk in the order of the edits.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <filesystem>
#include <string>
#include <vector>

#include "common/job_runner.h"
#include "common/notifications.h"
#include "common/save_queue.h"
#include "common/take_document.h"

namespace limbwave::ui {

class TakeEdits : public QObject {
  Q_OBJECT
 public:
  TakeEdits(TakeDocument& document, SaveQueue& saves, JobRunner& jobs, QUndoStack& undo, Notifications& notifications,
            QObject* parent = nullptr);
  /// Does what still waits.
  ~TakeEdits() override;

  /// What the open take may not be called, in words; empty: it may.
  [[nodiscard]] QString name_problem(const QString& name) const;

  /// One step of undo for everything that differs; false when nothing does, or when there is a `name_problem`. `places`
  /// and `serials` are by socket (take/sensor_places.h); empty ones stay as they are. A name is only given when no work
  /// on the take runs any more: until then the take keeps its old one.
  bool change(const QString& name, const QString& subject, const std::vector<std::string>& places = {},
              const std::vector<std::string>& serials = {});

 Q_SIGNALS:
  /// A take's folder on disk is another now; the open take has it already.
  void moved(const QString& from, const QString& to);

 private:
  friend class RenameTakeCommand;
  friend class SubjectCommand;
  friend class SensorsCommand;
  /// A take that is to have another folder.
  struct Move {
    std::filesystem::path now, wanted;
    bool running = false;
  };
  void want_folder(const std::filesystem::path& from, const std::filesystem::path& to);
  void settle();
  void end_move(const std::filesystem::path& from, const std::filesystem::path& to, const Status& status);
  void put_subject(const std::string& subject);
  void put_info(const take::TakeInfo& info);
  void save_info();

  TakeDocument& document_;
  SaveQueue& saves_;
  JobRunner& jobs_;
  QUndoStack& undo_;
  Notifications& notifications_;
  std::vector<Move> moves_;
};

}  // namespace limbwave::ui
