#include "calibration/limb_wizard_model.h"

#include <algorithm>

#include "calibration/calibration_words.h"
#include "common/shown_names.h"
#include "solve/take_calibration.h"

namespace limbwave::ui {
namespace {

constexpr auto kCountdownKey = "calibrate/countdown_s";

bool is_nominal(const std::string& method) {
  return method.empty() || method == "nominal";
}

}  // namespace

LimbWizardModel::LimbWizardModel(CalibrationDesk& desk, QObject* parent) : WizardModel(desk, parent) {
  timer_.setInterval(50);
  connect(&timer_, &QTimer::timeout, this, [this] { advance(1e-3 * static_cast<double>(clock_.restart())); });
  connect(&desk_.source(), &CalibrationSource::arrived, this, &LimbWizardModel::take_frames);
  connect(&desk_.source(), &CalibrationSource::changed, this, [this] {
    notice_loss(in_pose());
    if (device_came() && (page_ == LimbPage::kChoose || page_ == LimbPage::kPrepare)) {
      take_device();
    }
    if (in_pose()) {
      Q_EMIT held();
    } else {
      Q_EMIT choice_changed();
    }
  });
  countdown_s_ = std::clamp(desk_.context().settings().value(QLatin1String(kCountdownKey), 5.0).toDouble(), 2.0, 30.0);
}

void LimbWizardModel::set_page(LimbPage page) {
  page_ = page;
  if (page == LimbPage::kCountdown) {
    clock_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  desk_.source().ask(in_pose() ? solve::pose_segment(target_.rig.groups.at(static_cast<std::size_t>(group_)), pose_)
                               : std::string());
  Q_EMIT page_changed();
}

void LimbWizardModel::begin(int sensor, bool only) {
  ++attempt_;
  take_on(desk_.target());
  outcomes_.clear();
  checks_.clear();
  refusal_ = {};
  diagnostics_.clear();
  saving_ = false;
  checking_ = false;
  int chosen = -1;
  for (int g = 0; g < static_cast<int>(target_.rig.groups.size()) && chosen < 0; ++g) {
    const std::vector<int>& members = target_.rig.groups[static_cast<std::size_t>(g)].sensors;
    const bool wanted =
        sensor >= 0 ? std::find(members.begin(), members.end(), sensor) != members.end()
                    : std::any_of(members.begin(), members.end(), [this](int s) {
                        return is_nominal(desk_.calibration_of(target_).mounts[static_cast<std::size_t>(s)].method);
                      });
    chosen = wanted ? g : -1;
  }
  choose_group(std::max(0, chosen));
  if (only && sensor >= 0) {
    sensors_ = {sensor};
  }
  set_page(LimbPage::kChoose);
}

void LimbWizardModel::take_device() {
  const bool same = desk_.rig().name == target_.rig.name;
  const LimbPage page = page_;
  const int group = group_;
  const std::vector<int> sensors = sensors_;
  begin(-1);
  if (same) {
    choose_group(group);
    sensors_ = sensors;
    set_page(page);
  }
}

void LimbWizardModel::choose_group(int group) {
  group_ = group;
  sensors_ = group < static_cast<int>(target_.rig.groups.size())
                 ? target_.rig.groups[static_cast<std::size_t>(group)].sensors
                 : std::vector<int>{};
  Q_EMIT choice_changed();
}

void LimbWizardModel::choose_sensor(int sensor, bool on) {
  std::erase(sensors_, sensor);
  if (on) {
    sensors_.push_back(sensor);
    std::sort(sensors_.begin(), sensors_.end());
  }
  Q_EMIT choice_changed();
}

const body::LimbPose& LimbWizardModel::pose_text(int pose) const {
  const body::CalibrationGroup& group = target_.rig.groups.at(static_cast<std::size_t>(group_));
  return pose == 0 ? group.first : group.second;
}

QStringList LimbWizardModel::without_range() const {
  QStringList names;
  for (const int sensor : sensors_) {
    const auto s = static_cast<std::size_t>(sensor);
    if (is_nominal(desk_.calibration_of(target_).sensors.at(s).method)) {
      names << shown_name(target_.rig.accelerometers.at(s).name);
    }
  }
  return names;
}

QString LimbWizardModel::obstacle() const {
  switch (page_) {
    case LimbPage::kChoose:
      if (target_.rig.groups.empty()) {
        return tr("This rig names no poses. Add calibration groups to its file.");
      }
      if (sensors_.empty()) {
        return tr("Choose at least one sensor.");
      }
      [[fallthrough]];
    case LimbPage::kPrepare:
      return desk_.source().running() ? QString() : tr("No signal comes in. Open a device in Capture.");
    case LimbPage::kHold:
      return interrupted_          ? tr("The device died. Go back and start again when it is there.")
             : can_take_stillest() ? QString()
                                   : tr("Hold still: it goes on by itself.");
    case LimbPage::kComputing:
      return tr("Computing…");
    case LimbPage::kResult:
      return saving_ ? tr("Saving…") : accepted() == 0 ? tr("Nothing is accepted yet.") : QString();
    case LimbPage::kCountdown:
      return interrupted_ ? tr("The device died. Go back and start again when it is there.") : QString();
    case LimbPage::kCheck:
      break;
  }
  return {};
}

void LimbWizardModel::next() {
  if (!obstacle().isEmpty()) {
    return;
  }
  switch (page_) {
    case LimbPage::kChoose:
      set_page(LimbPage::kPrepare);
      break;
    case LimbPage::kPrepare:
      start_poses(sensors_);
      break;
    case LimbPage::kCountdown:
      start_hold();
      break;
    case LimbPage::kHold:
      take_stillest();
      break;
    case LimbPage::kComputing:
      break;
    case LimbPage::kResult:
      save();
      break;
    case LimbPage::kCheck:
      set_page(LimbPage::kResult);
      break;
  }
}

void LimbWizardModel::back() {
  switch (page_) {
    case LimbPage::kPrepare:
      set_page(LimbPage::kChoose);
      break;
    case LimbPage::kCountdown:
    case LimbPage::kHold:
      desk_.end_recording();
      interrupted_ = false;
      set_page(checking_ || !outcomes_.empty() ? LimbPage::kResult : LimbPage::kPrepare);
      checking_ = false;
      break;
    case LimbPage::kCheck:
      set_page(LimbPage::kResult);
      break;
    default:
      break;
  }
}

bool LimbWizardModel::would_lose() const {
  return has_open_verdicts() || page_ == LimbPage::kComputing || (in_pose() && pose_ == 1 && !checking_);
}

void LimbWizardModel::cancel() {
  ++attempt_;
  timer_.stop();
  desk_.end_recording();
  outcomes_.clear();
  checking_ = false;
  page_ = LimbPage::kChoose;
  desk_.source().ask({});
  Q_EMIT left();
}

void LimbWizardModel::set_countdown_s(double seconds) {
  countdown_s_ = std::clamp(seconds, 2.0, 30.0);
  desk_.context().settings().setValue(QLatin1String(kCountdownKey), countdown_s_);
  Q_EMIT choice_changed();
}

void LimbWizardModel::repeat(int sensor) {
  if (page_ == LimbPage::kResult && repeatable()) {
    start_poses({sensor});
  }
}

void LimbWizardModel::repeat_both() {
  if (page_ == LimbPage::kResult && repeatable()) {
    start_poses(sensors_);
  }
}

void LimbWizardModel::check(int pose) {
  if (page_ != LimbPage::kResult || !repeatable() || accepted() == 0) {
    return;
  }
  held_by_.clear();
  for (const LimbOutcome& outcome : outcomes_) {
    if (outcome.decision == Decision::kAccepted) {
      held_by_.push_back(outcome.sensor);
    }
  }
  frames_[0].clear();
  frames_[1].clear();
  make_calibrator();
  checking_ = true;
  interrupted_ = false;
  start_countdown(pose);
}

}  // namespace limbwave::ui
