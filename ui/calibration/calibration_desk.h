/// Everything that both wizards and the overview share: what is calibrated
/// (rig, wearer), the library, where results go, and the recording that keeps a
/// calibration's raw samples. No widgets.
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <vector>

#include "calibration/calibration_source.h"
#include "common/studio_context.h"
#include "solve/take_calibration.h"
#include "take/calibration_library.h"

namespace limbwave::ui {

/// Where takes of calibrations go: user_data_folder()/calibration-takes.
std::filesystem::path calibration_takes_folder();

/// The newest of the library for every sensor of a rig on a subject; the data
/// sheet where it has none.
calibrate::RigCalibration newest_of_library(const take::LibraryListing& listing, const body::Rig& rig,
                                            const std::string& subject);

/// What a finished calibration of some sensors changes.
struct CalibrationChange {
  std::vector<std::pair<int, calibrate::SensorCalibration>> ranges;  ///< By index of the accelerometer.
  std::vector<calibrate::MountCalibration> mounts;
};

struct LibraryEntry;

class CalibrationDesk : public QObject {
  Q_OBJECT
 public:
  /// `source` and `context` outlive this.
  CalibrationDesk(StudioContext& context, CalibrationSource& source, take::CalibrationLibrary library,
                  QObject* parent = nullptr);

  /// What is shown and changed: the running capture, else the open take, else
  /// nothing.
  enum class Subject { kNone, kLive, kTake };
  [[nodiscard]] Subject subject() const;
  [[nodiscard]] bool has_rig() const { return subject() != Subject::kNone; }
  /// Only with `has_rig()`.
  [[nodiscard]] const body::Rig& rig() const;
  [[nodiscard]] const body::Skeleton& skeleton() const;
  /// One entry for every sensor of the rig, at any time.
  [[nodiscard]] const calibrate::RigCalibration& calibration() const;
  /// What a wizard works on from its first page to its verdict, whatever becomes of the device or the take meanwhile.
  struct Target {
    Subject subject = Subject::kNone;
    int opening = 0;  ///< Of the open take.
    QString wearer;   ///< Of the open take, or who is typed in.
    body::Rig rig;
    body::Skeleton skeleton;
  };
  [[nodiscard]] Target target() const;
  /// A capture with the same sensors runs, or the same take is open.
  [[nodiscard]] bool is_current(const Target& target) const;
  /// One entry per sensor of the target at any time: the present calibration, else the last one known, else nominal.
  [[nodiscard]] calibrate::RigCalibration calibration_of(const Target& target) const;

  /// Who wears it: mountings are kept per person. Of the take, or as typed.
  [[nodiscard]] QString wearer() const;
  /// Can be undone.
  void set_wearer(const QString& wearer);

  CalibrationSource& source() { return source_; }
  StudioContext& context() { return context_; }
  const take::CalibrationLibrary& library() const { return library_; }
  [[nodiscard]] const take::LibraryListing& listing() const { return listing_; }
  /// Reads the library anew; ends in `changed`.
  void refresh();

  /// Saves to the library, then puts it to use where it was made for, as one
  /// step of undo: undone, it is in use and in the library no more. When the
  /// capture has ended meanwhile, or another take is open, the library alone
  /// gets it, for good. `done` is told how it went.
  void save(Target target, CalibrationChange change, std::function<void(const Status&)> done);
  /// Makes it the one of the running capture (every take recorded from now on
  /// carries it), or of the open take. Can be undone.
  void apply(const calibrate::RigCalibration& calibration);
  /// Without a step of undo. False when the target is not there any more. A
  /// capture that somebody else wears by now keeps that person's mountings.
  bool put_in_use(const Target& target, const std::optional<calibrate::RigCalibration>& calibration);
  /// Puts an entry into the library again, or takes it out; in order, beside
  /// the window.
  void change_library(const std::shared_ptr<LibraryEntry>& entry, bool in);
  /// Applies the newest of the library.
  void use_library();
  /// Applies one record of the library to the sensor it is of.
  void use_record(const take::SensorRecord& record);
  void use_record(const take::MountRecord& record);

  /// Keeps the raw samples of a live calibration; "range" or "limb" becomes
  /// part of the folder's name.
  void begin_recording(const QString& kind);
  /// Names a stretch of it, times of the frames: solve::kRangeSegment,
  /// solve::pose_segment().
  void add_segment(const std::string& name, double begin_s, double end_s);
  void end_recording();
  /// Where the raw samples are kept, or why they are not; for people.
  [[nodiscard]] const QString& recording_note() const { return recording_note_; }
  [[nodiscard]] const std::filesystem::path& recording_folder() const { return recording_folder_; }

 Q_SIGNALS:
  void changed();
  void recording_note_changed();

 private:
  void follow();
  void read_calibration() const;
  /// In use at the target; empty when it has none or is gone.
  [[nodiscard]] std::optional<calibrate::RigCalibration> in_use(const Target& target) const;
  struct Segment {
    std::string name;
    double begin_s, end_s;
  };
  /// A recording that is being closed on disk; another may begin meanwhile.
  struct Closing {
    std::filesystem::path folder;
    std::vector<Segment> segments;
    double start_s;
  };
  void store_segments(take::Take take, const Closing& closing);
  void set_note(const QString& note);

  StudioContext& context_;
  CalibrationSource& source_;
  take::CalibrationLibrary library_;
  take::LibraryListing listing_;
  mutable calibrate::RigCalibration calibration_;
  body::Rig known_rig_;              ///< What `known_` is of.
  calibrate::RigCalibration known_;  ///< The last one of a rig, also when that is gone.
  std::filesystem::path recording_folder_;
  std::vector<Segment> segments_;
  std::vector<Closing> closing_;
  QString recording_note_;
  bool recording_ = false;
  bool reading_ = false, read_again_ = false;
};

}  // namespace limbwave::ui
