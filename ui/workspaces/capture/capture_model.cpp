#include "workspaces/capture/capture_model.h"

#include <QDir>
#include <QPointer>
#include <algorithm>
#include <iterator>
#include <utility>

#include "acquire/box_ports.h"
#include "common/core_services.h"
#include "common/core_text.h"
#include "common/format.h"
#include "workspaces/capture/capture_commands.h"
#include "workspaces/capture/device_format.h"

namespace limbwave::ui {

namespace {

bool is_box_id(const QString& id) {
  return id.toStdString().starts_with(acquire::kBoxPrefix);
}

QString rig_key(bool box) {
  return box ? QStringLiteral("capture/box-rig") : QStringLiteral("capture/rig");
}

constexpr auto kOwnPorts = "capture/box-ports";

}  // namespace

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
            sensor_names_.append(QString::fromStdString(sensor.name));
          }
          slot_count_ = settings.value().rig.line_in.slots;
        }
        Q_EMIT setup_changed();
      });
}

bool CaptureModel::is_box() const {
  return is_box_id(context_.live().device_id());
}

std::vector<RigChoice> CaptureModel::rigs() const {
  std::vector<RigChoice> fitting;
  std::copy_if(rigs_.begin(), rigs_.end(), std::back_inserter(fitting),
               [box = is_box()](const RigChoice& rig) { return rig.driver_box == box; });
  return fitting;
}

void CaptureModel::suit_rig(const QString& device) {
  const bool box = is_box_id(device);
  const auto fits = [box](const QString& name) {
    return [box, name](const RigChoice& rig) { return rig.driver_box == box && rig.name == name.toStdString(); };
  };
  if (std::any_of(rigs_.begin(), rigs_.end(), fits(setup_.rig))) {
    return;
  }
  const QString last = context_.settings().value(rig_key(box)).toString();
  auto found = std::find_if(rigs_.begin(), rigs_.end(), fits(last));
  if (found == rigs_.end()) {
    found = std::find_if(rigs_.begin(), rigs_.end(), [box](const RigChoice& rig) { return rig.driver_box == box; });
  }
  if (found != rigs_.end()) {
    setup_.rig = QString::fromStdString(found->name);
    load_rig_names();
  }
}

void CaptureModel::add_own_ports() {
  for (const QString& port : context_.settings().value(QLatin1String(kOwnPorts)).toStringList()) {
    acquire::DeviceInfo box;
    box.id = std::string(acquire::kBoxPrefix) + port.toStdString();
    box.title = tr("Driver box at %1").arg(port).toStdString();
    if (std::none_of(devices_.begin(), devices_.end(), [&](const auto& one) { return one.id == box.id; })) {
      // Before the simulator, which is always last.
      const auto simulators = std::find_if(devices_.begin(), devices_.end(),
                                           [](const auto& one) { return one.id.starts_with(kSimulatorPrefix); });
      devices_.insert(simulators, std::move(box));
    }
  }
}

void CaptureModel::open_box_port(const QString& port) {
  if (port.trimmed().isEmpty()) {
    return;
  }
  QStringList ports = context_.settings().value(QLatin1String(kOwnPorts)).toStringList();
  ports.removeAll(port.trimmed());
  ports.prepend(port.trimmed());
  context_.settings().setValue(QLatin1String(kOwnPorts), ports.mid(0, 4));
  add_own_ports();
  Q_EMIT devices_changed();
  open_device(QString::fromLatin1(acquire::kBoxPrefix.data(), static_cast<qsizetype>(acquire::kBoxPrefix.size())) +
              port.trimmed());
}

QStringList CaptureModel::sensor_names() const {
  if (!context_.live().running()) {
    return sensor_names_;
  }
  QStringList names;  // Sensors may be worn elsewhere than the rig's file has them.
  for (const body::Accelerometer& sensor : context_.live().settings().rig.accelerometers) {
    names.append(QString::fromStdString(sensor.name));
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

void CaptureModel::refresh_devices() {
  if (searching_ || !context_.services().list_devices) {
    return;
  }
  searching_ = true;
  search_problem_.clear();
  Q_EMIT devices_changed();
  using Devices = std::vector<acquire::DeviceInfo>;
  context_.jobs().compute<Devices>(
      tr("Looking for devices"), this,
      [list_devices = context_.services().list_devices](const Progress&) { return list_devices(); },
      [this](Result<Devices> result) {
        searching_ = false;
        if (result) {
          devices_ = std::move(result).value();
          add_own_ports();
        } else {
          devices_.clear();
          search_problem_ = core_text(result.error().text());
        }
        Q_EMIT devices_changed();
        const QString last = context_.settings().value(QStringLiteral("capture/device")).toString();
        if ((context_.live().state() == LiveState::kOff || context_.live().lost()) && !last.isEmpty()) {
          open_device(last);
        }
      });
}

void CaptureModel::open_device(const QString& id) {
  LiveModel& live = context_.live();
  if (live.recording() || live.finishing()) {
    return;
  }
  if (id.isEmpty()) {
    live.close();
    context_.settings().remove(QStringLiteral("capture/device"));
    return;
  }
  const auto device = std::find_if(devices_.begin(), devices_.end(),
                                   [&](const acquire::DeviceInfo& one) { return one.id == id.toStdString(); });
  if (device == devices_.end() || (live.state() != LiveState::kOff && live.device_id() == id && !live.lost())) {
    return;
  }
  suit_rig(id);
  if (live.open(id, QString::fromStdString(device->title), rig().toStdString(), subject(),
                remembered_setup(context_.settings(), *device))) {
    context_.settings().setValue(QStringLiteral("capture/device"), id);
  }
  Q_EMIT setup_changed();
}

const acquire::DeviceInfo* CaptureModel::device() const {
  const auto found = std::find_if(devices_.begin(), devices_.end(), [this](const acquire::DeviceInfo& one) {
    return one.id == context_.live().device_id().toStdString();
  });
  return found == devices_.end() ? nullptr : &*found;
}

DeviceSetup CaptureModel::device_setup() const {
  const acquire::DeviceInfo* chosen = device();
  return chosen != nullptr ? remembered_setup(context_.settings(), *chosen) : DeviceSetup{};
}

void CaptureModel::set_device_setup(const DeviceSetup& setup) {
  const acquire::DeviceInfo* chosen = device();
  LiveModel& live = context_.live();
  if (chosen == nullptr || live.recording() || live.starting() || live.finishing()) {
    return;
  }
  const DeviceSetup before = device_setup();
  if (before != setup) {
    context_.undo_stack().push(new FormatCommand(*this, *chosen, before, setup, tr("format")));
  }
}

void CaptureModel::put_format(const acquire::DeviceInfo& device, const DeviceSetup& setup) {
  remember_setup(context_.settings(), device, setup);
  reopen(QString::fromStdString(device.id));
  Q_EMIT setup_changed();
}

void CaptureModel::reopen(const QString& device) {
  LiveModel& live = context_.live();
  if (live.recording() || live.starting() || live.finishing()) {
    reopen_ = device;
  } else if ((live.state() != LiveState::kOff || !live.problem().isEmpty()) && live.device_id() == device) {
    live.close();
    open_device(device);
  }
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
    context_.settings().setValue(rig_key(is_box()), rig());
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
