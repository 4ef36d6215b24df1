#include "solve/live_body_session.h"

#include <utility>

#include "solve/live_body_worker.h"
#include "take/markers.h"

namespace limbwave::solve {

LiveBodySession::LiveBodySession(std::unique_ptr<acquire::BoxSource> box, LiveBodySettings settings)
    : worker_(std::make_unique<LiveBodyWorker>(std::move(box), std::move(settings))) {}

LiveBodySession::~LiveBodySession() {
  if (worker_->was_started && !worker_->was_stopped) {
    (void)stop();
  }
}

Status LiveBodySession::start(const std::filesystem::path& folder, const std::string& subject) {
  LiveBodyWorker& w = *worker_;
  if (w.was_started) {
    return Error{"a session runs only once", "", "make another"};
  }
  if (Status fits = take::box_fits(w.settings.rig, w.box->hello()); !fits) {
    return fits;
  }
  if (Status ready = w.prepare(); !ready) {
    return ready;
  }
  const std::vector<std::uint8_t> schedule = take::rig_schedule(w.settings.rig);
  if (Status told = schedule.empty() ? Status() : w.box->set_schedule(schedule); !told) {
    return told;
  }
  // Before the box, so that its first sample is the take's.
  if (Status made = folder.empty() ? Status() : start_recording(folder, subject); !made) {
    return made;
  }
  if (Status started = w.box->start(); !started) {
    if (w.recording) {
      w.recording->discard();
      w.recording.reset();
    }
    return started;
  }
  w.was_started = true;
  w.solver = std::thread([&w] { w.solve(); });
  w.puller = std::thread([&w] { w.pull(); });
  return {};
}

Result<take::Take> LiveBodySession::stop() {
  LiveBodyWorker& w = *worker_;
  if (!w.was_started || w.was_stopped) {
    return Error{"no session runs", "", "start one"};
  }
  w.was_stopped = true;
  w.stopping = true;
  w.puller.join();
  w.solver.join();
  return stop_recording();
}

Status LiveBodySession::start_recording(const std::filesystem::path& folder, const std::string& subject) {
  LiveBodyWorker& w = *worker_;
  {
    const std::scoped_lock lock(w.recording_mutex);
    if (w.recording || w.preparing) {
      return Error{"is being recorded already", w.take_folder.string(), "stop that recording first"};
    }
    w.preparing = true;
  }
  // Without the lock: it touches the disk, and samples must not wait for that.
  auto made =
      take::BoxRecording::create(folder, *w.box, w.settings.rig, w.settings.skeleton, subject, w.settings.ranging);
  const std::scoped_lock lock(w.recording_mutex);
  w.preparing = false;
  if (!made) {
    return made.error();
  }
  w.recording = *std::move(made);
  w.recording->begin_at(SampleIndex{w.pulled});
  for (std::size_t wire = 0; wire < w.wire_pulled.size(); ++wire) {
    if (w.wire_pulled[wire]) {
      (void)w.recording->add_event({SampleIndex{0}, "wire-pulled",
                                    "wire " + std::to_string(wire + 1) + " was pulled before",
                                    static_cast<std::int64_t>(wire)});
    }
  }
  w.take_folder = folder;
  w.recording_error.clear();
  w.recorded_s = 0.0;
  w.disk_left_s = w.recording->disk_left_s();
  w.next_marker = 1;
  return {};
}

Result<take::Take> LiveBodySession::stop_recording() {
  std::unique_ptr<take::BoxRecording> recording;
  {
    const std::scoped_lock lock(worker_->recording_mutex);
    recording = std::move(worker_->recording);
  }
  if (!recording) {
    return Error{"nothing is being recorded", "", "start a recording first"};
  }
  return recording->close();
}

std::optional<take::TakeEvent> LiveBodySession::mark(const std::string& text) {
  const std::scoped_lock lock(worker_->recording_mutex);
  if (!worker_->recording) {
    return std::nullopt;
  }
  const take::TakeEvent event{SampleIndex{worker_->recording->frames()}, take::kMarker, text, worker_->next_marker++};
  return worker_->recording->add_event(event) ? std::optional(event) : std::nullopt;
}

bool LiveBodySession::write_event(const take::TakeEvent& event) {
  const std::scoped_lock lock(worker_->recording_mutex);
  return worker_->recording && worker_->recording->add_event(event).ok();
}

std::shared_ptr<const LiveBodySnapshot> LiveBodySession::snapshot() const {
  const std::lock_guard lock(worker_->published_mutex);
  return worker_->published;
}

std::shared_ptr<const LiveFigure> LiveBodySession::figure() const {
  const std::lock_guard lock(worker_->published_mutex);
  return worker_->figure;
}

void LiveBodySession::on_figure(std::function<void()> told) {
  worker_->told = std::move(told);
}

void LiveBodySession::on_poses(Poses told) {
  worker_->told_poses = std::move(told);
}

}  // namespace limbwave::solve
