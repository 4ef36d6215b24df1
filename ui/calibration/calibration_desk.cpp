#include "calibration/calibration_desk.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "base/files.h"
#include "calibration/calibration_command.h"
#include "calibration/calibration_words.h"

namespace limbwave::ui {

std::filesystem::path calibration_takes_folder() {
  return user_data_folder() / "calibration-takes";
}

calibrate::RigCalibration newest_of_library(const take::LibraryListing& listing, const body::Rig& rig,
                                            const std::string& subject) {
  return take::lookup(listing, rig, subject).calibration.value_or(calibrate::nominal_calibration(rig));
}

namespace {

bool same_sensors(const body::Rig& a, const body::Rig& b) {
  return a.name == b.name &&
         std::equal(a.accelerometers.begin(), a.accelerometers.end(), b.accelerometers.begin(), b.accelerometers.end(),
                    [](const auto& x, const auto& y) { return x.name == y.name && x.serial == y.serial; });
}

bool fits(const calibrate::RigCalibration& calibration, const body::Rig& rig) {
  return calibration.sensors.size() == rig.accelerometers.size() &&
         calibration.mounts.size() == rig.accelerometers.size();
}

calibrate::RigCalibration with_change(calibrate::RigCalibration calibration, const CalibrationChange& change) {
  for (const auto& [sensor, range] : change.ranges) {
    if (const auto s = static_cast<std::size_t>(sensor); s < calibration.sensors.size()) {
      calibration.sensors[s] = range;
    }
  }
  for (const calibrate::MountCalibration& mount : change.mounts) {
    const auto found = std::find_if(calibration.mounts.begin(), calibration.mounts.end(),
                                    [&](const auto& candidate) { return candidate.sensor == mount.sensor; });
    if (found != calibration.mounts.end()) {
      *found = mount;
    }
  }
  return calibration;
}

}  // namespace

CalibrationDesk::CalibrationDesk(StudioContext& context, CalibrationSource& source, take::CalibrationLibrary library,
                                 QObject* parent)
    : QObject(parent), context_(context), source_(source), library_(std::move(library)) {
  connect(&source_, &CalibrationSource::changed, this, &CalibrationDesk::follow);
  connect(&context_.document(), &TakeDocument::changed, this, &CalibrationDesk::follow);
  connect(&context_.document(), &TakeDocument::described, this, &CalibrationDesk::follow);
  connect(&context_, &StudioContext::wearer_changed, this, &CalibrationDesk::follow);
  connect(&source_, &CalibrationSource::recording_closed, this, [this](const take::Take& take) {
    if (recording_ && take.folder == recording_folder_) {
      end_recording();  // It ended by itself: the device is gone.
    }
    const auto found = std::find_if(closing_.begin(), closing_.end(),
                                    [&](const Closing& closing) { return closing.folder == take.folder; });
    if (found != closing_.end()) {
      const Closing closing = *found;
      closing_.erase(found);
      store_segments(take, closing);
    }
  });
  connect(&source_, &CalibrationSource::recording_failed, this, [this](const QString& text) {
    if (recording_) {
      recording_ = false;
      set_note(tr("The raw signals are not kept: %1").arg(text));
    }
  });
  follow();
  refresh();
}

CalibrationDesk::Subject CalibrationDesk::subject() const {
  return source_.running() ? Subject::kLive : context_.document().is_open() ? Subject::kTake : Subject::kNone;
}

const body::Rig& CalibrationDesk::rig() const {
  return subject() == Subject::kLive ? source_.rig() : context_.document().take()->info.rig;
}

const body::Skeleton& CalibrationDesk::skeleton() const {
  return subject() == Subject::kLive ? source_.skeleton() : context_.document().take()->info.skeleton;
}

QString CalibrationDesk::wearer() const {
  if (subject() == Subject::kTake) {
    return QString::fromStdString(context_.document().take()->info.subject);
  }
  return context_.wearer().trimmed();
}

void CalibrationDesk::set_wearer(const QString& wearer) {
  if (const QString name = wearer.trimmed(); name != context_.wearer()) {
    context_.undo_stack().push(new WearerCommand(context_, name, tr("subject")));
  }
}

void CalibrationDesk::follow() {
  read_calibration();
  if (has_rig()) {
    known_rig_ = rig();
    known_ = calibration_;
  }
  Q_EMIT changed();
}

const calibrate::RigCalibration& CalibrationDesk::calibration() const {
  // Somebody else may have heard of another take or capture before this has.
  if (has_rig() && !fits(calibration_, rig())) {
    read_calibration();
  }
  return calibration_;
}

void CalibrationDesk::read_calibration() const {
  if (subject() == Subject::kLive) {
    calibration_ = source_.calibration();
  } else if (subject() == Subject::kTake) {
    const take::TakeInfo& info = context_.document().take()->info;
    calibration_ = info.calibration ? *info.calibration : calibrate::nominal_calibration(info.rig);
  } else {
    calibration_ = {};
  }
  if (has_rig() && !fits(calibration_, rig())) {
    calibration_ = calibrate::nominal_calibration(rig());
  }
}

void CalibrationDesk::refresh() {
  if (reading_) {
    read_again_ = true;  // What is being read may be older than what was just saved.
    return;
  }
  reading_ = true;
  context_.jobs().compute<take::LibraryListing>(
      tr("Reading the calibration library"), this,
      [library = library_](const Progress&) -> Result<take::LibraryListing> { return library.list(); },
      [this](Result<take::LibraryListing> listing) {
        reading_ = false;
        if (std::exchange(read_again_, false)) {
          refresh();
        }
        if (listing) {
          listing_ = std::move(listing).value();
          Q_EMIT changed();
        }
      });
}

CalibrationDesk::Target CalibrationDesk::target() const {
  Target target;
  target.subject = subject();
  if (has_rig()) {
    target.rig = rig();
    target.skeleton = skeleton();
    target.wearer = wearer();
  }
  if (target.subject == Subject::kTake) {
    target.opening = context_.document().opening();
  }
  return target;
}

bool CalibrationDesk::is_current(const Target& target) const {
  switch (target.subject) {
    case Subject::kLive:
      return source_.running() && same_sensors(target.rig, source_.rig());
    case Subject::kTake: {
      const auto& open = context_.document().take();
      return context_.document().is_open() && context_.document().opening() == target.opening &&
             same_sensors(target.rig, open->info.rig);
    }
    case Subject::kNone:
      break;
  }
  return false;
}

calibrate::RigCalibration CalibrationDesk::calibration_of(const Target& target) const {
  const std::optional<calibrate::RigCalibration> now = in_use(target);
  if (now && fits(*now, target.rig)) {
    return *now;
  }
  if (!is_current(target) && same_sensors(target.rig, known_rig_)) {
    return known_;
  }
  return calibrate::nominal_calibration(target.rig);
}

std::optional<calibrate::RigCalibration> CalibrationDesk::in_use(const Target& target) const {
  if (!is_current(target)) {
    return std::nullopt;
  }
  return target.subject == Subject::kLive ? source_.calibration() : context_.document().take()->info.calibration;
}

bool CalibrationDesk::put_in_use(const Target& target, const std::optional<calibrate::RigCalibration>& calibration) {
  if (!is_current(target)) {
    return false;
  }
  if (target.subject == Subject::kLive) {
    calibrate::RigCalibration next = calibration ? *calibration : calibrate::nominal_calibration(source_.rig());
    if (target.wearer != context_.wearer().trimmed()) {
      next.mounts = source_.calibration().mounts;  // Somebody else wears the sensors by now.
    }
    source_.set_calibration(next);
    return true;
  }
  take::Take take = *context_.document().take();
  take.info.calibration = calibration;
  context_.document().set(take);
  const std::filesystem::path folder = take.folder;
  context_.saves().add(tr("The calibration is not saved in the take"), folder,
                       [take = std::move(take)](const std::filesystem::path& now) mutable {
                         take.folder = now;
                         return take::save_info(take);
                       });
  return true;
}

void CalibrationDesk::change_library(const std::shared_ptr<LibraryEntry>& entry, bool in) {
  context_.saves().add(
      in ? tr("The calibration is not saved in the library") : tr("The calibration is not taken out of the library"),
      [entry, in, library = library_, desk = QPointer<CalibrationDesk>(this)] {
        Status status = in ? entry->save(library) : entry->remove(library);
        // Only this thread's own copy of the pointer is touched here.
        QMetaObject::invokeMethod(qApp, [desk] {
          if (desk) {
            desk->refresh();
          }
        });
        return status;
      });
}

void CalibrationDesk::save(Target target, CalibrationChange change, std::function<void(const Status&)> done) {
  // Mountings belong to a person: of the take that they were made from, else as
  // typed.
  if (target.subject != Subject::kTake) {
    target.wearer = context_.wearer().trimmed();
  }
  const bool is_range = !change.ranges.empty();
  auto entry = std::make_shared<LibraryEntry>();
  for (const auto& [sensor, range] : change.ranges) {
    if (const auto s = static_cast<std::size_t>(sensor); s < target.rig.accelerometers.size()) {
      entry->ranges.emplace_back(take::sensor_key(target.rig, target.rig.accelerometers[s]), range);
    }
  }
  entry->mounts = change.mounts;
  entry->rig = target.rig;
  entry->subject = target.wearer.toStdString();
  context_.jobs().start(
      tr("Saving the calibration"), this, [library = library_, entry](const Progress&) { return entry->save(library); },
      [this, entry, target = std::move(target), is_range, change = std::move(change),
       done = std::move(done)](const Status& status) {
        if (status && is_current(target)) {
          context_.undo_stack().push(
              new CalibrationCommand(*this, target, in_use(target), with_change(calibration_of(target), change), entry,
                                     is_range ? tr("range calibration") : tr("mounting calibration")));
        } else if (status) {
          context_.notifications().post(
              Severity::kWarning, tr("The calibration is kept in the library, but what it was made for is closed: "
                                     "the capture or take at hand is unchanged."));
        }
        refresh();
        done(status);
      });
}

void CalibrationDesk::apply(const calibrate::RigCalibration& calibration) {
  if (has_rig()) {
    context_.undo_stack().push(
        new CalibrationCommand(*this, target(), in_use(target()), calibration, nullptr, tr("choice of calibration")));
  }
}

void CalibrationDesk::use_library() {
  if (has_rig()) {
    apply(newest_of_library(listing_, rig(), wearer().toStdString()));
  }
}

void CalibrationDesk::use_record(const take::SensorRecord& record) {
  calibrate::RigCalibration next = calibration_;
  for (std::size_t s = 0; has_rig() && s < rig().accelerometers.size(); ++s) {
    if (take::sensor_key(rig(), rig().accelerometers[s]) == record.key) {
      next.sensors[s] = record.calibration;
    }
  }
  apply(next);
}

void CalibrationDesk::use_record(const take::MountRecord& record) {
  calibrate::RigCalibration next = calibration_;
  for (calibrate::MountCalibration& mount : next.mounts) {
    for (const calibrate::MountCalibration& stored : record.mounts) {
      if (stored.sensor == mount.sensor) {
        mount = stored;
      }
    }
  }
  apply(next);
}

void CalibrationDesk::begin_recording(const QString& kind) {
  if (recording_ || subject() != Subject::kLive) {
    return;
  }
  segments_.clear();
  const QString name =
      QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")) + QLatin1Char('-') + kind;
  std::filesystem::path folder = calibration_takes_folder() / (name.toStdString() + ".take");
  std::error_code ignored;
  std::filesystem::create_directories(folder.parent_path(), ignored);
  for (int n = 2; std::filesystem::exists(folder, ignored); ++n) {
    folder = calibration_takes_folder() / (name.toStdString() + "-" + std::to_string(n) + ".take");
  }
  recording_folder_ = folder;
  recording_ = source_.start_recording(folder, wearer());
  set_note(recording_ ? tr("Raw signals are kept in %1").arg(QString::fromStdString(folder.string()))
                      : tr("The raw signals are not kept in a take of their own: the capture records already, or it "
                           "cannot record. The calibration itself goes on."));
}

void CalibrationDesk::add_segment(const std::string& name, double begin_s, double end_s) {
  if (recording_ && end_s > begin_s) {
    segments_.push_back({name, begin_s, end_s});
  }
}

void CalibrationDesk::end_recording() {
  if (recording_) {
    recording_ = false;
    closing_.push_back({recording_folder_, std::move(segments_), source_.recording_start_s()});
    segments_.clear();
    source_.stop_recording();
  }
}

void CalibrationDesk::store_segments(take::Take take, const Closing& closing) {
  const double start_s = closing.start_s;
  for (const Segment& segment : closing.segments) {
    const SampleRate rate = take.info.format.rate;
    const SampleIndex first = rate.index(Seconds{std::max(0.0, segment.begin_s - start_s)});
    const std::int64_t last =
        std::min(rate.index(Seconds{std::max(0.0, segment.end_s - start_s)}).value, take.info.frames);
    if (last > first.value) {
      take.info.segments.push_back({segment.name, first, SampleCount{last - first.value}});
    }
  }
  context_.jobs().start(
      tr("Closing the calibration's take"), this,
      [take = std::move(take)](const Progress&) { return take::save_info(take); },
      [this](const Status& status) {
        if (!status) {
          context_.notifications().post_error(tr("The calibration's take has no segments"), status.error());
        }
      });
}

void CalibrationDesk::set_note(const QString& note) {
  recording_note_ = note;
  Q_EMIT recording_note_changed();
}

}  // namespace limbwave::ui
