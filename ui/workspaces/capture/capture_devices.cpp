// The devices of the Capture workspace: which there are, which is open and how, and the rigs that go with it.
#include <algorithm>
#include <iterator>

#include "acquire/box_ports.h"
#include "common/core_services.h"
#include "common/core_text.h"
#include "workspaces/capture/capture_commands.h"
#include "workspaces/capture/capture_model.h"
#include "workspaces/capture/device_format.h"

namespace limbwave::ui {

namespace {

bool is_box_id(const QString& id) {
  return id.toStdString().starts_with(acquire::kBoxPrefix);
}

QString key_of(bool box) {
  return box ? QStringLiteral("capture/box-rig") : QStringLiteral("capture/rig");
}

constexpr auto kOwnPorts = "capture/box-ports";

}  // namespace

QString CaptureModel::rig_key() const {
  return key_of(is_box());
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
  const QString last = context_.settings().value(key_of(box)).toString();
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

}  // namespace limbwave::ui
