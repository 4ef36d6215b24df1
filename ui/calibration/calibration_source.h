/// Where a wizard's readings come from: the running capture, or a test's own. Readings come in order of time, each
/// once.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "body/rig.h"
#include "calibrate/calibration.h"
#include "common/live_model.h"
#include "decode/slot_alignment.h"
#include "take/take.h"

namespace limbwave::ui {

class CalibrationSource : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Readings come. The rest is meaningful only then.
  [[nodiscard]] virtual bool running() const = 0;
  [[nodiscard]] virtual QString title() const = 0;  ///< Of the device.
  /// Why nothing comes although it should, and what to do; empty when all is well.
  [[nodiscard]] virtual QString problem() const = 0;
  [[nodiscard]] virtual QString remedy() const = 0;
  [[nodiscard]] virtual const body::Rig& rig() const = 0;
  [[nodiscard]] virtual const body::Skeleton& skeleton() const = 0;
  [[nodiscard]] virtual const calibrate::RigCalibration& calibration() const = 0;
  virtual void set_calibration(const calibrate::RigCalibration& calibration) = 0;

  /// The raw samples of a calibration are kept as a take. False when that cannot be or something records already.
  virtual bool start_recording(const std::filesystem::path& folder, const QString& subject) = 0;
  virtual void stop_recording() = 0;
  /// What the wizard asks for now: the name of a stretch, or nothing. For wearers who are simulated.
  virtual void ask(const std::string& /*what*/) {}
  /// Time of the stream at which the recording began, seconds; the frames' own clock.
  [[nodiscard]] virtual double recording_start_s() const = 0;

 Q_SIGNALS:
  /// New readings since the last time.
  void arrived(const std::vector<limbwave::decode::AccelerationFrame>& frames);
  /// It runs or it does not, its device or calibration is another.
  void changed();
  void recording_closed(const limbwave::take::Take& take);
  void recording_failed(const QString& text);
};

/// The studio's running capture. Snapshots overlap by ten seconds; readings are told apart by their times.
class LiveCalibrationSource : public CalibrationSource {
  Q_OBJECT
 public:
  explicit LiveCalibrationSource(LiveModel& live, QObject* parent = nullptr);

  [[nodiscard]] bool running() const override;
  [[nodiscard]] QString title() const override { return live_.device_title(); }
  [[nodiscard]] QString problem() const override { return live_.problem(); }
  [[nodiscard]] QString remedy() const override { return live_.remedy(); }
  [[nodiscard]] const body::Rig& rig() const override { return live_.settings().rig; }
  [[nodiscard]] const body::Skeleton& skeleton() const override { return live_.settings().skeleton; }
  [[nodiscard]] const calibrate::RigCalibration& calibration() const override { return live_.settings().calibration; }
  void set_calibration(const calibrate::RigCalibration& calibration) override;
  bool start_recording(const std::filesystem::path& folder, const QString& subject) override;
  void stop_recording() override;
  void ask(const std::string& what) override { live_.ask(what); }
  [[nodiscard]] double recording_start_s() const override { return recording_start_s_; }

 private:
  void read_snapshot();
  void follow_recording();
  LiveModel& live_;
  /// What was asked for while a recording was still being started or closed, which takes a moment.
  bool stop_wanted_ = false;
  std::filesystem::path wanted_folder_;
  QString wanted_subject_;
  bool awaits_recording_ = false;  ///< It was started, and no snapshot has it yet.
  double last_time_s_ = -1.0;
  double recording_start_s_ = 0.0;
};

/// The frames of `all` (in order of time) that are newer than `after_s`.
std::vector<decode::AccelerationFrame> newer_frames(const std::vector<decode::AccelerationFrame>& all, double after_s);

}  // namespace limbwave::ui
