#include "calibration/stretch_model.h"

#include <algorithm>
#include <cmath>

#include "calibration/stretch_command.h"
#include "common/core_text.h"
#include "common/format.h"

namespace limbwave::ui {
namespace {

constexpr double kShortest_s = 0.1;  // what the handles leave between them

}  // namespace

StretchModel::StretchModel(CalibrationDesk& desk, QObject* parent) : QObject(parent), desk_(desk) {
  connect(&desk_.context().document(), &TakeDocument::changed, this, [this] {
    if (active_) {
      follow();
    }
  });
}

double StretchModel::duration_s() const {
  return take_ && take_->info.format.rate.hz > 0.0
             ? static_cast<double>(take_->info.frames) / take_->info.format.rate.hz
             : 0.0;
}

void StretchModel::begin() {
  active_ = true;
  follow();
}

void StretchModel::follow() {
  const auto& open = desk_.context().document().take();
  const bool other = !take_ || !open || opening_ != desk_.context().document().opening();
  take_ = open;
  opening_ = desk_.context().document().opening();
  if (!other) {
    Q_EMIT
    changed();  // The same take with another calibration: its readings stay.
    return;
  }
  decoded_.reset();
  problem_.clear();
  if (job_ != nullptr) {
    job_->cancel();
    job_ = nullptr;
  }
  decoding_ = false;
  int procedure = -1;
  if (take_ && !has_range_segment(*take_)) {
    const std::vector<int> groups = groups_in_take(*take_);
    procedure = groups.empty() ? -1 : groups.front();
  }
  choice_ = suggested(procedure);
  if (take_) {
    decode();
  }
  Q_EMIT stretch_changed();
  Q_EMIT changed();
}

void StretchModel::decode() {
  decoding_ = true;
  using Decoded = std::shared_ptr<const solve::DecodedTake>;
  Job* job = desk_.context().jobs().compute<Decoded>(
      tr("Reading the signals of %1").arg(desk_.context().document().name()), this,
      [take = take_](const Progress& progress) -> Result<Decoded> {
        auto decoded = solve::decode_take(*take, {}, progress);
        if (!decoded) {
          return decoded.error();
        }
        return Decoded(std::make_shared<const solve::DecodedTake>(std::move(decoded).value()));
      },
      [this, opening = opening_](Result<Decoded> result) {
        if (!take_ || opening_ != opening) {
          return;
        }
        decoding_ = false;
        if (result) {
          decoded_ = std::move(result).value();
        } else {
          problem_ = is_cancelled(result.error()) ? tr("Reading was cancelled.")
                                                  : as_sentence(core_text(result.error().message)) + QLatin1Char(' ') +
                                                        as_sentence(core_text(result.error().remedy));
        }
        Q_EMIT changed();
      });
  job_ = job;
  connect(job, &Job::finished, this, [this, job] {
    if (job_ == job) {
      job_ = nullptr;
    }
  });
}

void StretchModel::set_procedure(int procedure) {
  if (procedure != choice_.procedure && take_ && procedure < static_cast<int>(take_->info.rig.groups.size())) {
    desk_.context().undo_stack().push(
        new StretchCommand(*this, suggested(procedure), tr("other movement to calibrate from"), -1));
  }
}

void StretchModel::put_choice(const StretchChoice& choice) {
  if (choice == choice_ || !take_ || choice.procedure >= static_cast<int>(take_->info.rig.groups.size())) {
    return;
  }
  const bool other = choice.procedure != choice_.procedure;
  choice_ = choice;
  Q_EMIT stretch_changed();
  if (other) {
    Q_EMIT changed();
  }
}

QString StretchModel::title(int i) const {
  if (procedure() < 0 || !take_) {
    return tr("Sensors are turned");
  }
  const body::CalibrationGroup& group = take_->info.rig.groups.at(static_cast<std::size_t>(procedure()));
  return tr("Pose %1: %2").arg(i + 1).arg(QString::fromStdString(i == 0 ? group.first.name : group.second.name));
}

std::vector<NamedStretch> StretchModel::suggestions(int i) const {
  return suggestions(procedure(), i);
}

std::vector<NamedStretch> StretchModel::suggestions(int procedure, int i) const {
  if (!take_) {
    return {};
  }
  std::vector<std::string> first{solve::kRangeSegment};
  if (procedure >= 0) {
    const body::CalibrationGroup& group = take_->info.rig.groups.at(static_cast<std::size_t>(procedure));
    first = {solve::pose_segment(group, i), solve::pose_segment(group, 1 - i)};
  }
  return named_stretches(take_->info, first);
}

/// The take's own segment where it has one; else all of it for turning, and two
/// seconds early and late for the poses.
StretchChoice StretchModel::suggested(int procedure) const {
  const double all = duration_s();
  StretchChoice choice{procedure, {}};
  for (int i = 0; i < 2; ++i) {
    Stretch& stretch = choice.stretches.at(static_cast<std::size_t>(i));
    const std::vector<NamedStretch> named =
        procedure < 0 && i > 0 ? std::vector<NamedStretch>{} : suggestions(procedure, i);
    const std::string wanted =
        procedure < 0 || !take_
            ? solve::kRangeSegment
            : solve::pose_segment(take_->info.rig.groups.at(static_cast<std::size_t>(procedure)), i);
    if (!named.empty() && named.front().name == wanted) {
      stretch = named.front().stretch;
    } else if (procedure < 0) {
      stretch = {0.0, all};
    } else {
      const double middle = all * (i == 0 ? 0.25 : 0.75);
      stretch = {std::max(0.0, middle - 1.0), std::min(all, middle + 1.0)};
    }
  }
  return choice;
}

void StretchModel::set_stretch(int i, Stretch wanted, int gesture) {
  if (!take_ || !std::isfinite(wanted.begin_s) || !std::isfinite(wanted.end_s) || i < 0 || i >= count()) {
    return;
  }
  StretchChoice choice = choice_;
  Stretch& stretch = choice.stretches.at(static_cast<std::size_t>(i));
  const double all = duration_s(), least = std::min(kShortest_s, all);
  const bool begin_moved = wanted.begin_s != stretch.begin_s;
  Stretch next{std::clamp(wanted.begin_s, 0.0, all - least), std::clamp(wanted.end_s, least, all)};
  if (next.seconds() < least) {
    if (begin_moved) {
      next.end_s = next.begin_s + least;
    } else {
      next.begin_s = next.end_s - least;
    }
  }
  if (!(next == stretch)) {
    stretch = next;
    desk_.context().undo_stack().push(
        new StretchCommand(*this, choice, tr("other stretch to calibrate from"), gesture));
  }
}

CalibrationDesk::Target StretchModel::target() const {
  return take_ ? CalibrationDesk::Target{CalibrationDesk::Subject::kTake, opening_,
                                         QString::fromStdString(take_->info.subject), take_->info.rig,
                                         take_->info.skeleton}
               : CalibrationDesk::Target{};
}

QString StretchModel::obstacle() const {
  if (!take_) {
    return tr("Open a take first.");
  }
  if (decoding_) {
    return tr("The signals are still being read.");
  }
  if (!decoded_) {
    return problem_;
  }
  if (computing_) {
    return tr("Computing…");
  }
  for (int i = 0; i < count(); ++i) {
    if (decoded_->between(stretch(i).begin_s, stretch(i).end_s).empty()) {
      return tr("\"%1\" holds no readings. Choose another stretch.").arg(title(i));
    }
  }
  const Stretch &a = stretch(0), &b = stretch(1);
  if (count() == 2 && a.begin_s < b.end_s && b.begin_s < a.end_s) {
    return tr("The two poses overlap. Move them apart.");
  }
  return {};
}

void StretchModel::compute() {
  if (!obstacle().isEmpty()) {
    return;
  }
  computing_ = true;
  Q_EMIT changed();
  const auto finished = [this](const auto& result, auto&& found) {
    computing_ = false;
    Q_EMIT changed();
    if (result) {
      found(result.value());
    } else if (!is_cancelled(result.error())) {
      Q_EMIT failed(result.error());
    }
  };
  JobRunner& jobs = desk_.context().jobs();
  if (procedure() < 0) {
    using Outcomes = std::vector<RangeOutcome>;
    jobs.compute<Outcomes>(
        tr("Computing the range calibration"), this,
        [take = take_, decoded = decoded_, stretch = stretch(0)](const Progress& progress) {
          return range_outcomes(take->info, decoded->between(stretch.begin_s, stretch.end_s), progress);
        },
        [this, finished](const Result<Outcomes>& result) {
          finished(result, [this](const Outcomes& outcomes) { Q_EMIT range_found(outcomes); });
        });
    return;
  }
  // What the take has; the range of sensors that it does not know comes from
  // the library.
  const calibrate::RigCalibration range =
      take_->info.calibration ? *take_->info.calibration
                              : newest_of_library(desk_.listing(), take_->info.rig, take_->info.subject);
  jobs.compute<LimbFromTake>(
      tr("Computing the mounting"), this,
      [take = take_, decoded = decoded_, group = procedure(), stretches = choice_.stretches,
       range](const Progress&) -> Result<LimbFromTake> {
        return limb_outcomes(*take, group, decoded->between(stretches[0].begin_s, stretches[0].end_s),
                             decoded->between(stretches[1].begin_s, stretches[1].end_s), range);
      },
      [this, finished](const Result<LimbFromTake>& result) {
        finished(result, [this](const LimbFromTake& found) { Q_EMIT limb_found(found); });
      });
}

}  // namespace limbwave::ui
