/// The live capture of the studio: opens a device, polls the session at the screen's pace, records. Everything that may
/// wait runs in jobs.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <memory>

#include "common/device_door.h"
#include "common/job_runner.h"
#include "common/studio_services.h"

namespace limbwave::ui {

enum class LiveState { kOff, kOpening, kRunning, kStopping };

class LiveModel : public QObject {
  Q_OBJECT
 public:
  LiveModel(const StudioServices& services, JobRunner& jobs, QObject* parent = nullptr);
  ~LiveModel() override;

  [[nodiscard]] LiveState state() const { return state_; }
  [[nodiscard]] bool running() const { return state_ == LiveState::kRunning; }
  [[nodiscard]] bool recording() const { return recording_; }
  /// True between "Record" and the moment at which the take's folder is there.
  [[nodiscard]] bool starting() const { return starting_; }
  /// It records the raw signals of a calibration, not a take of the user's.
  [[nodiscard]] bool aside() const { return aside_; }
  /// Of the running or the last recording.
  [[nodiscard]] const std::filesystem::path& recording_folder() const { return recording_folder_; }
  /// True between "Stop" and the moment at which the take is complete on disk.
  [[nodiscard]] bool finishing() const { return finishing_; }
  /// The newest pose as of now; null while there is none. For the face that draws it: `figure_ready` says when.
  [[nodiscard]] std::shared_ptr<const solve::LiveFigure> figure() const;
  /// The newest state; null while nothing has been captured.
  [[nodiscard]] const std::shared_ptr<const solve::LiveSnapshot>& snapshot() const { return snapshot_; }
  /// Rig, skeleton and calibration of the running capture; known when it runs.
  [[nodiscard]] const solve::LiveSettings& settings() const { return settings_; }
  [[nodiscard]] const QString& device_id() const { return device_id_; }
  [[nodiscard]] const QString& device_title() const { return device_title_; }
  /// Why the last opening failed, or why capture ended by itself; empty when all is well.
  [[nodiscard]] const QString& problem() const { return problem_; }
  [[nodiscard]] const QString& remedy() const { return remedy_; }

  /// Closes what runs, reads the rig with its calibration, and opens this device; ends in `state_changed`. Refused
  /// while recording.
  bool open(const QString& device_id, const QString& device_title, const std::string& rig, const QString& subject,
            const DeviceSetup& setup = {});
  /// Refused while recording.
  void close();
  /// Ends in `recording_changed`, or in `recording_failed` when the folder cannot be made. False when nothing runs or
  /// it is recording already.
  /// `aside`: not a take that the user makes, but the raw signals of a calibration; it ends in `aside_finished` and
  /// does not become the open take.
  bool start_recording(const std::filesystem::path& folder, const QString& subject, bool aside = false);
  /// Ends in `recording_finished` (or `aside_finished`) or `recording_failed`.
  void stop_recording();
  /// Sets a marker at this moment of the recording; empty when nothing is recorded. Faces go through MarkerModel.
  std::optional<take::TakeEvent> mark(const QString& text);
  /// Writes a line of the recording's events; false when nothing is recorded.
  bool write_event(const take::TakeEvent& event);
  /// A wizard asks for this; a simulated wearer does it.
  void ask(const std::string& what);
  void set_calibration(const calibrate::RigCalibration& calibration);
  /// Somebody else wears the sensors: reads this person's mountings from the library in a job, a moment after the last
  /// call. A recording that starts before is told first. Ends in `calibration_changed`.
  void set_wearer(const QString& wearer);
  /// Whose mountings `settings().calibration` has.
  [[nodiscard]] const QString& wearer() const { return wearer_; }
  /// The device was unplugged: what it last sent still shows, and it can be opened again.
  [[nodiscard]] bool lost() const { return running() && snapshot_ && !snapshot_->source_alive; }
  /// Rotations about the vertical, per segment; faces go through LiveHeadings (workspaces/solve).
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings);

  /// A viewer has shown a pose: the times of its figure, with `taken` and `drawn`.
  void note_drawn(const solve::PoseTimes& times);
  /// Capture to screen, beyond the device's buffer, of the last ten seconds, the first second of a capture aside. When
  /// no viewer draws, what the session measured up to the solved pose; no poses: not measured.
  [[nodiscard]] solve::LatencyReport latency() const;

 Q_SIGNALS:
  void state_changed();
  void snapshot_changed();
  void figure_ready();  ///< At once when a pose is there; several poses that come while the interface is busy are one.
  void recording_changed();
  void calibration_changed();
  void source_lost();  ///< The device is gone; `problem()` says so.
  void recording_finished(const limbwave::take::Take& take);
  void aside_finished(const limbwave::take::Take& take);
  void recording_failed(const QString& text, const QString& remedy);

 private:
  void poll();
  void end_recording();
  void load_wearer();
  void set_state(LiveState state);
  void fail(const Error& error);
  /// Stops and ends it beside the window: joining its thread and closing a sound server can take a moment.
  void retire(std::shared_ptr<LiveBackend> backend);

  const StudioServices& services_;
  JobRunner& jobs_;
  LiveState state_ = LiveState::kOff;
  bool recording_ = false, starting_ = false, finishing_ = false, aside_ = false;
  std::filesystem::path recording_folder_;
  QString device_id_, device_title_, problem_, remedy_;
  solve::LiveSettings settings_;
  std::shared_ptr<LiveBackend> backend_;
  std::shared_ptr<const solve::LiveSnapshot> snapshot_;
  QString wearer_;         ///< Whose mountings are in use.
  QString wanted_wearer_;  ///< Whose are to be.
  std::string rig_name_;   ///< As asked for when opening.
  QTimer timer_, wearer_timer_;
  std::uint64_t opening_ = 0;         ///< Counts attempts, so that one that was overtaken is dropped.
  std::shared_ptr<DeviceDoor> door_;  ///< Devices are opened and closed in the order in which that was asked for.
  solve::LatencyMeter drawn_;
  QElapsedTimer since_drawn_;
  double counted_from_s_ = 0.0;  ///< Before that a capture is still finding its feet: caches, first frames.
  struct Bell;
  std::shared_ptr<Bell> bell_;  ///< Outlives this model in the hands of a session that is being closed.
};

/// steady_clock in seconds, the clock of `LiveSource::newest_frame_time_s`.
double steady_now_s();

}  // namespace limbwave::ui
