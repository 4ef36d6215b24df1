#include "solve/live_session.h"

#include <utility>

#include "solve/live_worker.h"
#include "take/markers.h"

namespace limbwave::solve {

LiveSession::LiveSession(std::unique_ptr<acquire::LiveSource> source, LiveSettings settings)
    : worker_(std::make_unique<LiveWorker>(std::move(source), std::move(settings))) {}

LiveSession::~LiveSession() {
  stop();
  if (worker_->recorder) {
    (void)stop_recording();
  }
}

Status LiveSession::start() {
  const std::scoped_lock lock(worker_->running);
  if (worker_->thread.joinable()) {
    return {};
  }
  if (Status status = worker_->source->start(); !status) {
    return status;
  }
  worker_->stopping = false;
  worker_->thread = std::thread([worker = worker_.get()] { worker->run(); });
  return {};
}

void LiveSession::stop() {
  const std::scoped_lock lock(worker_->running);
  if (!worker_->thread.joinable()) {
    return;
  }
  worker_->source->stop();
  worker_->stopping = true;
  worker_->thread.join();
}

Status LiveSession::start_recording(const std::filesystem::path& folder, const std::string& subject) {
  take::TakeInfo info;
  info.subject = subject;
  info.source = worker_->source->title();
  info.format = worker_->format;
  info.rig = worker_->settings.rig;
  info.skeleton = worker_->settings.skeleton;
  std::int64_t calibrations = 0;
  {
    const std::scoped_lock lock(worker_->mutex);
    if (worker_->recorder || worker_->is_preparing) {
      return Error{"is being recorded already", worker_->take_folder.string(), "stop that recording first"};
    }
    worker_->is_preparing = true;
    info.calibration = worker_->settings.calibration;
    calibrations = worker_->calibrations;
  }
  // Without the lock: it touches the disk, and the worker must not wait for that.
  Result<std::unique_ptr<take::Recorder>> recorder = take::Recorder::create(folder, std::move(info));
  {
    const std::scoped_lock lock(worker_->mutex);
    worker_->is_preparing = false;
    if (!recorder) {
      return recorder.error();
    }
    worker_->recorder = std::move(*recorder);
    if (worker_->calibrations != calibrations) {  // set meanwhile: the worker brings it into the take
      worker_->new_calibration = worker_->settings.calibration;
    }
    worker_->recording_start = -1;
    worker_->recording_error.clear();
    worker_->pending_events.clear();
    worker_->next_marker = 1;
    worker_->take_folder = folder;
  }
  worker_->restart_findings();
  return {};
}

Result<take::Take> LiveSession::stop_recording() {
  std::unique_ptr<take::Recorder> recorder;
  worker_->write_pending_events();
  worker_->sum_up_findings();
  {
    const std::scoped_lock lock(worker_->mutex);
    recorder = std::move(worker_->recorder);
    if (recorder && worker_->new_calibration) {
      (void)recorder->set_calibration(*worker_->new_calibration);  // no sample came since
    }
  }
  if (!recorder) {
    return Error{"nothing is being recorded", "", "start a recording first"};
  }
  return recorder->close();
}

std::optional<take::TakeEvent> LiveSession::mark(const std::string& text) {
  const std::scoped_lock lock(worker_->mutex);
  if (!worker_->recorder) {
    return std::nullopt;
  }
  const take::TakeEvent event{SampleIndex{worker_->recorder->frames()}, take::kMarker, text, worker_->next_marker++};
  worker_->pending_events.push_back(event);
  return event;
}

bool LiveSession::write_event(const take::TakeEvent& event) {
  const std::scoped_lock lock(worker_->mutex);
  if (!worker_->recorder) {
    return false;
  }
  worker_->pending_events.push_back(event);
  return true;
}

void LiveSession::ask(const std::string& what) {
  worker_->source->ask(what);
}

void LiveSession::set_calibration(const calibrate::RigCalibration& calibration) {
  const std::scoped_lock lock(worker_->mutex);
  worker_->new_calibration = calibration;
  ++worker_->calibrations;
  worker_->settings.calibration = calibration;
}

void LiveSession::set_headings(const std::vector<std::vector<HeadingKey>>& headings) {
  const std::scoped_lock lock(worker_->mutex);
  worker_->new_headings = headings;
}

std::shared_ptr<const LiveSnapshot> LiveSession::snapshot() const {
  const std::scoped_lock lock(worker_->published_mutex);
  return worker_->published;
}

std::shared_ptr<const LiveFigure> LiveSession::figure() const {
  const std::scoped_lock lock(worker_->published_mutex);
  return worker_->figure;
}

void LiveSession::on_figure(std::function<void()> told) {
  worker_->told = std::move(told);
}

}  // namespace limbwave::solve
