#include "common/take_edits.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "common/format.h"
#include "take/sensor_places.h"

namespace limbwave::ui {
namespace fs = std::filesystem;
namespace {

QString name_of(const fs::path& folder) {
  return QString::fromStdString(folder.stem().string());
}

}  // namespace

// Commands hold what they change and nothing else, so that other steps of undo in between keep theirs.

class RenameTakeCommand : public QUndoCommand {
 public:
  RenameTakeCommand(TakeEdits& edits, fs::path before, fs::path after, QUndoCommand* parent)
      : QUndoCommand(parent), edits_(edits), before_(std::move(before)), after_(std::move(after)) {}
  void redo() override { edits_.want_folder(before_, after_); }
  void undo() override { edits_.want_folder(after_, before_); }

 private:
  TakeEdits& edits_;
  fs::path before_, after_;
};

class SubjectCommand : public QUndoCommand {
 public:
  SubjectCommand(TakeEdits& edits, std::string before, std::string after, QUndoCommand* parent)
      : QUndoCommand(parent), edits_(edits), before_(std::move(before)), after_(std::move(after)) {}
  void redo() override { edits_.put_subject(after_); }
  void undo() override { edits_.put_subject(before_); }

 private:
  TakeEdits& edits_;
  std::string before_, after_;
};

class SensorsCommand : public QUndoCommand {
 public:
  SensorsCommand(TakeEdits& edits, take::TakeInfo before, take::TakeInfo after, QUndoCommand* parent)
      : QUndoCommand(parent), edits_(edits), before_(std::move(before)), after_(std::move(after)) {}
  void redo() override { edits_.put_info(after_); }
  void undo() override { edits_.put_info(before_); }

 private:
  TakeEdits& edits_;
  take::TakeInfo before_, after_;
};

TakeEdits::TakeEdits(TakeDocument& document, SaveQueue& saves, JobRunner& jobs, QUndoStack& undo,
                     Notifications& notifications, QObject* parent)
    : QObject(parent), document_(document), saves_(saves), jobs_(jobs), undo_(undo), notifications_(notifications) {
  // The job is still in the list then.
  connect(&jobs_, &JobRunner::job_finished, this, &TakeEdits::settle, Qt::QueuedConnection);
}

TakeEdits::~TakeEdits() {
  for (const Move& move : moves_) {
    if (!move.running) {
      saves_.move({}, move.now, move.wanted, {});
    }
  }
}

QString TakeEdits::name_problem(const QString& name) const {
  if (!document_.is_open() || name == document_.name()) {
    return {};
  }
  return take_name_problem(QString::fromStdString(document_.take()->folder.parent_path().string()), name);
}

bool TakeEdits::change(const QString& name, const QString& subject, const std::vector<std::string>& places,
                       const std::vector<std::string>& serials) {
  if (!document_.is_open() || !name_problem(name).isEmpty()) {
    return false;
  }
  const take::Take& take = *document_.take();
  auto step = std::make_unique<QUndoCommand>();
  if (!places.empty()) {
    const Result<take::TakeInfo> worn = take::with_sensors(take.info, places, serials);
    if (!worn) {
      notifications_.post_error(tr("The sensors stay as they are"), worn.error());
      return false;
    }
    const auto same = [](const body::Accelerometer& a, const body::Accelerometer& b) {
      return a.name == b.name && a.serial == b.serial;
    };
    const auto& before = take.info.rig.accelerometers;
    if (!std::equal(before.begin(), before.end(), worn->rig.accelerometers.begin(), worn->rig.accelerometers.end(),
                    same)) {
      step->setText(tr("sensors of the take"));
      new SensorsCommand(*this, take.info, *worn, step.get());
    }
  }
  if (subject.trimmed().toStdString() != take.info.subject) {
    step->setText(step->childCount() > 0 ? tr("details of the take") : tr("subject of the take"));
    new SubjectCommand(*this, take.info.subject, subject.trimmed().toStdString(), step.get());
  }
  if (name != document_.name()) {
    step->setText(step->childCount() > 0 ? tr("details of the take") : tr("name of the take"));
    const fs::path after = take.folder.parent_path() / (name.toStdString() + take.folder.extension().string());
    new RenameTakeCommand(*this, take.folder, after, step.get());
  }
  if (step->childCount() == 0) {
    return false;
  }
  undo_.push(step.release());
  return true;
}

void TakeEdits::want_folder(const fs::path& from, const fs::path& to) {
  // It may be on its way from there: then what counts is where it goes at last.
  const auto found = std::find_if(moves_.begin(), moves_.end(), [&](const Move& move) { return move.wanted == from; });
  if (found != moves_.end()) {
    found->wanted = to;
  } else {
    moves_.push_back({from, to});
  }
  settle();
  if (!moves_.empty() && !moves_.back().running && moves_.back().now != moves_.back().wanted) {
    notifications_.post(
        Severity::kInfo,
        tr("The take is called %1 as soon as nothing works on it any more.").arg(name_of(moves_.back().wanted)));
  }
}

void TakeEdits::settle() {
  std::erase_if(moves_, [](const Move& move) { return !move.running && move.now == move.wanted; });
  // Whatever runs may be reading or writing the take; the queue itself minds the order.
  const std::size_t own = saves_.idle() ? 0 : 1;
  if (jobs_.jobs().size() > own) {
    return;
  }
  for (Move& move : moves_) {
    if (!move.running) {
      move.running = true;
      saves_.move(tr("The take keeps its name"), move.now, move.wanted,
                  [this, from = move.now, to = move.wanted](const Status& status) { end_move(from, to, status); });
    }
  }
}

void TakeEdits::end_move(const fs::path& from, const fs::path& to, const Status& status) {
  const auto found =
      std::find_if(moves_.begin(), moves_.end(), [&](const Move& move) { return move.running && move.now == from; });
  if (found != moves_.end()) {
    found->running = false;
    if (!status) {
      moves_.erase(found);
    } else {
      found->now = to;
    }
  }
  if (status) {
    if (document_.is_open() && document_.take()->folder == from) {
      document_.describe(to, document_.take()->info.subject);
    }
    Q_EMIT moved(QString::fromStdString(from.string()), QString::fromStdString(to.string()));
  }
  settle();
}

void TakeEdits::put_subject(const std::string& subject) {
  if (document_.is_open()) {
    document_.describe(document_.take()->folder, subject);
    save_info();
  }
}

void TakeEdits::put_info(const take::TakeInfo& info) {
  if (document_.is_open()) {
    take::Take take = *document_.take();
    take.info.rig = info.rig;
    take.info.calibration = info.calibration;
    document_.set(std::move(take));
    save_info();
  }
}

void TakeEdits::save_info() {
  saves_.add(tr("The change is not saved in the take"), document_.take()->folder,
             [take = *document_.take()](const fs::path& now) mutable {
               take.folder = now;
               return take::save_info(take);
             });
}

}  // namespace limbwave::ui
