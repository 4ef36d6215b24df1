#include "common/live_model.h"

#include <atomic>
#include <chrono>
#include <mutex>

#include "acquire/box_ports.h"
#include "common/core_text.h"
#include "common/format.h"

namespace limbwave::ui {

double steady_now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What a session rings from its own thread.
struct LiveModel::Bell {
  std::mutex mutex;
  LiveModel* model = nullptr;        // null once it is gone
  std::atomic<bool> ringing{false};  // the interface has not answered yet

  void ring() {
    if (ringing.exchange(true)) {
      return;
    }
    const std::scoped_lock lock(mutex);
    if (model != nullptr) {
      QMetaObject::invokeMethod(
          model,
          [model = model] {
            model->bell_->ringing = false;
            Q_EMIT model->figure_ready();
          },
          Qt::QueuedConnection);
    }
  }
};

namespace {

/// What opening ends in.
struct Opened {
  std::shared_ptr<LiveBackend> backend;
  solve::LiveSettings settings;
};

/// Ranges are the sensors', whoever wears them; mountings are the wearer's.
calibrate::RigCalibration with_mounts(calibrate::RigCalibration calibration, const calibrate::RigCalibration& from) {
  calibration.mounts = from.mounts;
  return calibration;
}

}  // namespace

LiveModel::LiveModel(const StudioServices& services, JobRunner& jobs, QObject* parent)
    : QObject(parent), services_(services), jobs_(jobs) {
  bell_ = std::make_shared<Bell>();
  bell_->model = this;
  door_ = std::make_shared<DeviceDoor>();
  timer_.setInterval(33);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &LiveModel::poll);
  wearer_timer_.setSingleShot(true);
  wearer_timer_.setInterval(250);
  connect(&wearer_timer_, &QTimer::timeout, this, &LiveModel::load_wearer);
}

LiveModel::~LiveModel() {
  const std::scoped_lock lock(bell_->mutex);
  bell_->model = nullptr;
}

void LiveModel::set_state(LiveState state) {
  state_ = state;
  if (state == LiveState::kRunning) {
    timer_.start();
  } else {
    timer_.stop();
  }
  Q_EMIT state_changed();
}

void LiveModel::fail(const Error& error) {
  // The place is the device's id, which tells people nothing that the title does not, or a file.
  const bool is_device = error.place == device_id_.toStdString();
  problem_ =
      as_sentence(core_text(error.place.empty() || is_device ? error.message : error.place + ": " + error.message));
  remedy_ = as_sentence(core_text(error.remedy));
}

bool LiveModel::open(const QString& device_id, const QString& device_title, const std::string& rig,
                     const QString& subject, const DeviceSetup& setup) {
  if (recording_ || starting_ || finishing_ || !services_.open_device || !services_.load_rig || !services_.make_live) {
    return false;
  }
  close();
  device_id_ = device_id;
  device_title_ = device_title;
  rig_name_ = rig;
  wearer_ = wanted_wearer_ = subject.trimmed();
  wearer_timer_.stop();
  problem_.clear();
  remedy_.clear();
  set_state(LiveState::kOpening);
  const std::uint64_t attempt = ++opening_;
  door_->newest = attempt;
  auto work = [open_device = services_.open_device, open_box = services_.open_box, make_live = services_.make_live,
               load_rig = services_.load_rig, id = device_id.toStdString(), rig, wearer = wearer_.toStdString(), setup,
               bell = bell_, door = door_, ticket = door_->ticket(), attempt](const Progress&) -> Result<Opened> {
    const DeviceDoor::Turn turn(door, ticket);
    if (door->newest != attempt) {
      return cancelled();
    }
    auto settings = load_rig(rig, wearer, id);
    if (!settings) {
      return settings.error();
    }
    Opened opened{nullptr, std::move(settings).value()};
    if (open_box && id.starts_with(acquire::kBoxPrefix)) {
      auto backend = open_box(id, setup, opened.settings);
      if (!backend) {
        return backend.error();
      }
      opened.backend = std::move(backend).value();
    } else {
      auto source = open_device(id, setup, rig);
      if (!source) {
        return source.error();
      }
      opened.backend = make_live(std::move(source).value(), opened.settings);
    }
    opened.backend->on_figure([bell] { bell->ring(); });
    if (Status started = opened.backend->start(); !started) {
      return started.error();
    }
    return opened;
  };
  jobs_.compute<Opened>(tr("Opening %1").arg(device_title), this, std::move(work),
                        [this, attempt](Result<Opened> result) {
                          if (attempt != opening_) {
                            if (result) {
                              retire(std::move(result->backend));
                            }
                            return;
                          }
                          if (!result) {
                            fail(result.error());
                            set_state(LiveState::kOff);
                            return;
                          }
                          backend_ = std::move(result->backend);
                          settings_ = std::move(result->settings);
                          set_state(LiveState::kRunning);
                          if (wanted_wearer_ != wearer_) {
                            wearer_timer_.start();  // Somebody else put them on meanwhile.
                          }
                          poll();
                        });
  return true;
}

void LiveModel::retire(std::shared_ptr<LiveBackend> backend) {
  jobs_.start(tr("Closing %1").arg(device_title_), nullptr,
              [backend = std::move(backend), door = door_, ticket = door_->ticket()](const Progress&) mutable {
                const DeviceDoor::Turn turn(door, ticket);
                backend->stop();
                backend.reset();
                return Status();
              });
}

void LiveModel::close() {
  if (recording_ || starting_ || finishing_) {
    return;
  }
  door_->newest = ++opening_;
  drawn_.clear();
  counted_from_s_ = 0.0;
  const bool had_snapshot = snapshot_ != nullptr;
  snapshot_.reset();
  if (backend_) {
    retire(std::exchange(backend_, nullptr));
  }
  if (state_ != LiveState::kOff) {
    set_state(LiveState::kOff);
  }
  if (had_snapshot) {
    Q_EMIT snapshot_changed();
  }
}

std::shared_ptr<const solve::LiveFigure> LiveModel::figure() const {
  return backend_ && running() && !finishing_ ? backend_->figure() : nullptr;
}

void LiveModel::poll() {
  if (!backend_) {
    return;
  }
  std::shared_ptr<const solve::LiveSnapshot> next = backend_->snapshot();
  if (!next || (snapshot_ && next->version == snapshot_->version)) {
    return;
  }
  const bool was_alive = !snapshot_ || snapshot_->source_alive;
  const bool had_error = snapshot_ && !snapshot_->recording_error.empty();
  snapshot_ = std::move(next);
  if (recording_ && !had_error && !snapshot_->recording_error.empty()) {
    Q_EMIT recording_failed(as_sentence(core_text(snapshot_->recording_error)), {});
    stop_recording();
  }
  if (was_alive && !snapshot_->source_alive) {
    problem_ = tr("%1 has stopped sending.").arg(device_title_);
    remedy_ = tr("Plug it in again, then choose it once more. What was recorded until now is kept.");
    if (recording_) {
      stop_recording();
    }
    Q_EMIT source_lost();
    Q_EMIT state_changed();
  }
  Q_EMIT snapshot_changed();
}

bool LiveModel::start_recording(const std::filesystem::path& folder, const QString& subject, bool aside) {
  if (!backend_ || recording_ || starting_ || finishing_) {
    return false;
  }
  starting_ = true;
  aside_ = aside;
  recording_folder_ = folder;
  wearer_timer_.stop();
  wanted_wearer_ = subject.trimmed();
  const bool other_wearer = wanted_wearer_ != wearer_;
  auto read = std::make_shared<std::optional<calibrate::RigCalibration>>();
  jobs_.start(
      tr("Making the take"), this,
      [backend = backend_, folder, name = subject.trimmed().toStdString(), other_wearer, read,
       load_rig = services_.load_rig, rig = rig_name_, device = device_id_.toStdString(),
       calibration = settings_.calibration](const Progress&) -> Status {
        if (other_wearer) {
          // A take never carries the mountings of whoever wore the sensors before.
          Result<solve::LiveSettings> settings = load_rig(rig, name, device);
          if (!settings) {
            return settings.error();
          }
          *read = with_mounts(calibration, settings.value().calibration);
          backend->set_calibration(**read);
        }
        return backend->start_recording(folder, name);
      },
      [this, read, wearer = wanted_wearer_](const Status& status) {
        starting_ = false;
        if (*read) {
          settings_.calibration = **read;
          wearer_ = wearer;
          Q_EMIT calibration_changed();
        }
        if (!status) {
          fail(status.error());
          Q_EMIT recording_failed(problem_, remedy_);
          return;
        }
        recording_ = true;
        Q_EMIT recording_changed();
        if (lost()) {
          stop_recording();  // It went while the take was being made.
        }
      });
  return true;
}

void LiveModel::stop_recording() {
  if (recording_ && backend_) {
    end_recording();
  }
}

void LiveModel::end_recording() {
  recording_ = false;
  finishing_ = true;
  Q_EMIT recording_changed();
  jobs_.compute<take::Take>(
      tr("Closing the take"), this, [backend = backend_](const Progress&) { return backend->stop_recording(); },
      [this](Result<take::Take> result) {
        finishing_ = false;
        Q_EMIT recording_changed();
        if (!result) {
          fail(result.error());
          Q_EMIT recording_failed(problem_, remedy_);
          return;
        }
        if (aside_) {
          Q_EMIT aside_finished(result.value());
        } else {
          Q_EMIT recording_finished(result.value());
        }
      });
}

std::optional<take::TakeEvent> LiveModel::mark(const QString& text) {
  return backend_ && recording_ ? backend_->mark(text.toStdString()) : std::nullopt;
}

bool LiveModel::write_event(const take::TakeEvent& event) {
  return backend_ && recording_ && backend_->write_event(event);
}

void LiveModel::ask(const std::string& what) {
  if (backend_) {
    backend_->ask(what);
  }
}

void LiveModel::set_calibration(const calibrate::RigCalibration& calibration) {
  settings_.calibration = calibration;
  if (backend_) {
    backend_->set_calibration(calibration);
  }
  Q_EMIT calibration_changed();
}

void LiveModel::set_wearer(const QString& wearer) {
  wanted_wearer_ = wearer;
  if (running()) {
    wearer_timer_.start();
  }
}

void LiveModel::load_wearer() {
  if (recording_ || starting_ || !running() || wanted_wearer_ == wearer_) {
    return;
  }
  jobs_.compute<solve::LiveSettings>(
      tr("Reading the calibration of %1").arg(wanted_wearer_), this,
      [load_rig = services_.load_rig, rig = rig_name_, name = wanted_wearer_.toStdString(),
       device = device_id_.toStdString()](const Progress&) { return load_rig(rig, name, device); },
      [this, attempt = opening_, wearer = wanted_wearer_](Result<solve::LiveSettings> settings) {
        if (settings && attempt == opening_ && wearer == wanted_wearer_ && !recording_ && !starting_) {
          wearer_ = wearer;
          set_calibration(with_mounts(settings_.calibration, settings.value().calibration));
        }
      });
}

void LiveModel::set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) {
  settings_.solve.headings = headings;
  if (backend_) {
    backend_->set_headings(headings);
  }
}

void LiveModel::note_drawn(const solve::PoseTimes& times) {
  constexpr double kSettling_s = 1.0;
  since_drawn_.start();
  if (counted_from_s_ == 0.0) {
    counted_from_s_ = times.drawn + kSettling_s;
  }
  if (times.drawn >= counted_from_s_) {
    drawn_.add(times);
  }
}

solve::LatencyReport LiveModel::latency() const {
  solve::LatencyReport report = drawn_.report();
  // Nothing is drawn while another page is shown: what was drawn long ago says nothing of now.
  constexpr qint64 kStale_ms = 3000;
  if ((report.poses == 0 || !since_drawn_.isValid() || since_drawn_.elapsed() > kStale_ms) && snapshot_) {
    report = snapshot_->latency;
  }
  return report;
}

}  // namespace limbwave::ui
