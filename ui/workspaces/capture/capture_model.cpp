#include "workspaces/capture/capture_model.h"

#include <QDir>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "common/format.h"
#include "common/shown_names.h"
#include "workspaces/capture/capture_commands.h"

namespace limbwave::ui {

CaptureModel& CaptureModel::of(StudioContext& context) {
  if (auto* made = context.findChild<CaptureModel*>({}, Qt::FindDirectChildrenOnly)) {
    return *made;
  }
  return *new CaptureModel(context, &context);
}

CaptureModel::CaptureModel(StudioContext& context, QObject* parent)
    : QObject(parent), context_(context), sounds_(context.settings()) {
  countdown_timer_.setInterval(1000);
  countdown_timer_.setTimerType(Qt::PreciseTimer);
  connect(&countdown_timer_, &QTimer::timeout, this, &CaptureModel::count_down);
  if (context_.services().list_rigs) {
    rigs_ = context_.services().list_rigs();
  }
  setup_.rig = context.settings().value(QStringLiteral("capture/rig"), QStringLiteral("line-in-arm")).toString();
  setup_.subject = context.wearer();
  setup_.folder = context.takes_folder();
  const auto known = std::any_of(rigs_.begin(), rigs_.end(), [this](const RigChoice& rig) {
    return !rig.driver_box && rig.name == setup_.rig.toStdString();
  });
  const auto first = std::find_if(rigs_.begin(), rigs_.end(), [](const RigChoice& rig) { return !rig.driver_box; });
  if (first != rigs_.end() && !known) {
    setup_.rig = QString::fromStdString(first->name);
  }
  load_rig_names();
  suggest_name();
  LiveModel& live = context_.live();
  connect(&live, &LiveModel::recording_finished, this, [this] {
    setup_.name_typed = false;
    suggest_name();
  });
  connect(&live, &LiveModel::recording_failed, this, &CaptureModel::suggest_name);
  connect(&live, &LiveModel::recording_changed, this, [this] {
    if (!reopen_.isEmpty()) {
      reopen(std::exchange(reopen_, {}));
    }
  });
  connect(&context_.take_edits(), &TakeEdits::moved, this, &CaptureModel::suggest_name);
  connect(&context_, &StudioContext::takes_folder_changed, this, [this] {
    setup_.folder = context_.takes_folder();
    suggest_name();
  });
  connect(&context_, &StudioContext::wearer_changed, this, [this] {
    if (setup_.subject != context_.wearer()) {
      setup_.subject = context_.wearer();  // said elsewhere: in a wizard
      suggest_name();
    }
  });
}

void CaptureModel::set_today(const QDate& today) {
  today_ = today;
  suggest_name();
}

void CaptureModel::load_rig_names() {
  if (!context_.services().load_rig) {
    return;
  }
  // With it the calibration library is read, which may be large.
  context_.jobs().compute<solve::LiveSettings>(
      tr("Reading the rig"), this,
      [load_rig = context_.services().load_rig, rig = rig().toStdString(),
       subject = subject().toStdString()](const Progress&) { return load_rig(rig, subject, {}); },
      [this, rig = rig()](const Result<solve::LiveSettings>& settings) {
        if (rig != this->rig()) {
          return;
        }
        sensor_names_.clear();
        if (!settings) {
          context_.notifications().post_error(tr("Rig %1").arg(rig), settings.error());
        } else {
          for (const body::Accelerometer& sensor : settings.value().rig.accelerometers) {
            sensor_names_.append(shown_name(sensor.name));
          }
          slot_count_ = settings.value().rig.line_in.slots;
        }
        Q_EMIT setup_changed();
      });
}

QStringList CaptureModel::sensor_names() const {
  if (!context_.live().running()) {
    return sensor_names_;
  }
  QStringList names;  // Sensors may be worn elsewhere than the rig's file has them.
  for (const body::Accelerometer& sensor : context_.live().settings().rig.accelerometers) {
    names.append(shown_name(sensor.name));
  }
  return names;
}

int CaptureModel::slot_count() const {
  return context_.live().running() ? context_.live().settings().rig.line_in.slots : slot_count_;
}

QString CaptureModel::suggested_name(const QString& subject) const {
  const QDate day = today_.isValid() ? today_ : QDate::currentDate();
  return suggest_take_name(context_.takes_folder(), subject, day.toString(QStringLiteral("yyyyMMdd")));
}

void CaptureModel::suggest_name() {
  if (!setup_.name_typed) {
    setup_.take_name = suggested_name(setup_.subject);
  }
  check_name();
  Q_EMIT setup_changed();
}

QString CaptureModel::take_folder() const {
  return QDir(context_.takes_folder()).filePath(take_name() + QStringLiteral(".take"));
}

void CaptureModel::check_name() {
  name_problem_ = limbwave::ui::take_name_problem(context_.takes_folder(), take_name());
}

bool CaptureModel::can_record() const {
  const LiveModel& live = context_.live();
  return live.running() && live.snapshot() && live.snapshot()->source_alive && !live.recording() && !live.finishing() &&
         take_name_problem().isEmpty();
}

void CaptureModel::read_board() {
  using Read = std::pair<body::Rig, take::Board>;
  context_.jobs().compute<Read>(
      tr("Reading the board"), this,
      [rig = rig().toStdString(), device = context_.live().device_id().toStdString()](const Progress&) -> Result<Read> {
        Result<body::Rig> loaded = body::load_rig(rig);
        if (!loaded) {
          return loaded.error();
        }
        Result<take::Board> board = take::BoardBook().board(device, loaded->name);
        if (!board) {
          return board.error();
        }
        return Read{std::move(loaded).value(), std::move(board).value()};
      },
      [this](const Result<Read>& read) {
        if (!read) {
          context_.notifications().post_error(tr("The board cannot be read"), read.error());
          return;
        }
        Q_EMIT board_ready(read->first, read->second);
      });
}

void CaptureModel::set_board(const QString& device, const std::string& rig, const take::Board& before,
                             const take::Board& after) {
  if (before != after) {
    context_.undo_stack().push(new BoardCommand(*this, device, rig, before, after, tr("sensor board")));
  }
}

void CaptureModel::put_board(const QString& device, const std::string& rig, const take::Board& board) {
  context_.saves().add(
      tr("The board cannot be kept"),
      [device = device.toStdString(), rig, board] { return take::BoardBook().set_board(device, rig, board); },
      [self = QPointer<CaptureModel>(this), device](const Status& status) {
        // Opened anew, it goes by its own sensors' calibrations.
        if (self && status) {
          self->reopen(device);
        }
      });
}

void CaptureModel::change(const CaptureSetup& next, Field field, const QString& text) {
  if (next != setup_) {
    context_.undo_stack().push(new SetupCommand(*this, next, static_cast<int>(field), text));
  }
}

bool CaptureModel::apply(const CaptureSetup& next) {
  const LiveModel& live = context_.live();
  if (live.recording() || live.starting()) {
    return false;  // It belongs to what is being recorded.
  }
  const std::vector<RigChoice> fitting = rigs();
  const bool fits = std::any_of(fitting.begin(), fitting.end(),
                                [&](const RigChoice& rig) { return rig.name == next.rig.toStdString(); });
  // An older step may name a rig for the other kind of device: the device stays, and its rig.
  const QString rig_before = setup_.rig;
  const bool other_rig = next.rig != setup_.rig && (fits || fitting.empty());
  context_.set_takes_folder(next.folder);
  setup_ = next;
  setup_.rig = other_rig ? next.rig : rig_before;
  check_name();
  context_.set_wearer(subject());
  if (other_rig) {
    context_.settings().setValue(rig_key(), rig());
    load_rig_names();
  }
  Q_EMIT setup_changed();
  const QString id = live.device_id();
  if (other_rig) {
    reopen(id);  // The decoder depends on the rig: listen anew.
  }
  return true;
}

void CaptureModel::set_rig(const QString& rig) {
  if (!rig.isEmpty() && !context_.live().recording()) {
    CaptureSetup next = setup_;
    next.rig = rig;
    change(next, Field::kRig, tr("rig"));
  }
}

void CaptureModel::set_subject(const QString& subject) {
  CaptureSetup next = setup_;
  next.subject = subject;
  if (!next.name_typed) {
    next.take_name = suggested_name(subject);
  }
  change(next, Field::kSubject, tr("subject"));
}

void CaptureModel::set_take_name(const QString& name) {
  CaptureSetup next = setup_;
  next.take_name = name;
  next.name_typed = !name.isEmpty();
  change(next, Field::kTakeName, tr("name of the take"));
}

void CaptureModel::set_takes_folder(const QString& folder) {
  CaptureSetup next = setup_;
  next.folder = folder;
  if (!next.name_typed) {
    const QDate day = today_.isValid() ? today_ : QDate::currentDate();
    next.take_name = suggest_take_name(folder, next.subject, day.toString(QStringLiteral("yyyyMMdd")));
  }
  change(next, Field::kFolder, tr("folder for takes"));
}

void CaptureModel::start_recording() {
  if (can_record()) {
    context_.live().start_recording(take_folder().toStdString(), subject());
  }
}

void CaptureModel::stop_recording() {
  if (!(context_.live().recording() && context_.live().aside())) {
    context_.live().stop_recording();
  }
}

void CaptureModel::toggle_recording() {
  const LiveModel& live = context_.live();
  if (countdown_ > 0) {
    set_countdown(0);
  } else if (live.recording() && !live.aside()) {
    stop_recording();
  } else {
    start_recording();
  }
}

void CaptureModel::toggle_countdown() {
  if (countdown_ > 0) {
    set_countdown(0);
  } else if (can_record()) {
    set_countdown(kCountdown_s);
    sounds_.play(CueSounds::Cue::kTick);
  }
}

void CaptureModel::set_countdown(int seconds) {
  countdown_ = seconds;
  if (seconds <= 0) {
    countdown_timer_.stop();
  } else if (!countdown_timer_.isActive()) {
    countdown_timer_.start();
  }
  Q_EMIT countdown_changed();
}

void CaptureModel::count_down() {
  if (!can_record()) {
    // The device went, or somebody else began to record: whoever waits for it must hear that.
    set_countdown(0);
    sounds_.play(CueSounds::Cue::kLost);
    context_.notifications().post(Severity::kWarning, tr("The countdown ended without recording."),
                                  tr("Look at the device and at the name of the take, then begin again."));
    return;
  }
  set_countdown(countdown_ - 1);
  sounds_.play(countdown_ > 0 ? CueSounds::Cue::kTick : CueSounds::Cue::kGo);
  if (countdown_ == 0) {
    start_recording();
  }
}

}  // namespace limbwave::ui
