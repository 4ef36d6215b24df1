/// The limb wizard while somebody stands: countdown, stillness, capture of both poses.
#include <algorithm>
#include <cmath>

#include "calibration/limb_wizard_model.h"

namespace limbwave::ui {

void LimbWizardModel::start_poses(const std::vector<int>& sensors) {
  checking_ = false;
  interrupted_ = false;
  held_by_ = sensors;
  frames_[0].clear();
  frames_[1].clear();
  make_calibrator();
  desk_.begin_recording(QStringLiteral("limb"));
  start_countdown(0);
}

void LimbWizardModel::make_calibrator() {
  calibrator_ =
      std::make_unique<calibrate::LimbCalibrator>(target_.rig, desk_.calibration_of(target_), group_, held_by_);
  calibrator_->push(0, frames_[0]);
  calibrator_->push(1, frames_[1]);
  meter_ = MovementMeter(held_by_, desk_.calibration_of(target_));
  holders_.clear();
  for (const int sensor : held_by_) {
    holders_.push_back({sensor, {}, false});
  }
}

void LimbWizardModel::start_countdown(int pose) {
  pose_ = pose;
  left_s_ = countdown_s_;
  set_page(LimbPage::kCountdown);
  Q_EMIT counted(static_cast<int>(std::ceil(left_s_)));
}

void LimbWizardModel::advance(double elapsed_s) {
  if (page_ != LimbPage::kCountdown || interrupted_) {
    return;
  }
  const double before = std::ceil(left_s_);
  left_s_ = std::max(0.0, left_s_ - elapsed_s);
  if (left_s_ <= 0.0) {
    start_hold();
    return;
  }
  if (std::ceil(left_s_) < before) {
    Q_EMIT counted(static_cast<int>(std::ceil(left_s_)));
  }
  Q_EMIT held();
}

void LimbWizardModel::start_hold() {
  left_s_ = 0.0;
  frames_.at(static_cast<std::size_t>(pose_)).clear();
  calibrator_->clear(pose_);
  meter_.clear();
  progress_ = {};
  progress_.movement_now_g = progress_.best_movement_g = INFINITY;
  ready_since_s_ = -1.0;
  set_page(LimbPage::kHold);
  Q_EMIT counted(0);
}

void LimbWizardModel::take_frames(const std::vector<decode::AccelerationFrame>& frames) {
  // After the device died its clock began anew: such readings do not go with
  // those before.
  if (!in_pose() || !listens() || frames.empty()) {
    return;
  }
  // Movement is shown during the countdown too, but only what is held counts.
  const bool holding = page_ == LimbPage::kHold;
  std::vector<decode::AccelerationFrame>& kept = frames_.at(static_cast<std::size_t>(pose_));
  for (const decode::AccelerationFrame& frame : frames) {
    meter_.push(frame);
    if (holding) {
      calibrator_->push(pose_, frame);
      kept.push_back(frame);
    }
  }
  const std::vector<SensorMovement> movements = meter_.movements();
  for (std::size_t i = 0; i < holders_.size(); ++i) {
    holders_[i].movement = movements[i];
    holders_[i].moves = movements[i].movement_g > still_threshold_g();
  }
  if (!holding) {
    Q_EMIT held();
    return;
  }
  progress_ = calibrator_->progress(pose_);
  const double newest_s = frames.back().time_s;
  if (progress_.ready && ready_since_s_ < 0.0) {
    ready_since_s_ = newest_s;
  }
  Q_EMIT held();
  if (ready_since_s_ >= 0.0 && (newest_s - ready_since_s_ >= kConfirmS || !progress_.still_now)) {
    capture();
  } else if (progress_.seconds > kForgetS) {
    kept.clear();
    calibrator_->clear(pose_);
  }
}

double LimbWizardModel::captured_fraction() const {
  const std::vector<decode::AccelerationFrame>& kept = frames_.at(static_cast<std::size_t>(pose_));
  return ready_since_s_ < 0.0 || kept.empty() ? 0.0
                                              : std::clamp((kept.back().time_s - ready_since_s_) / kConfirmS, 0.0, 1.0);
}

bool LimbWizardModel::can_take_stillest() const {
  return page_ == LimbPage::kHold && ready_since_s_ < 0.0 && progress_.seconds > kPatienceS &&
         progress_.best_movement_g <= calibrate::LimbParameters().usable_movement_g;
}

void LimbWizardModel::take_stillest() {
  if (can_take_stillest()) {
    capture();
  }
}

bool LimbWizardModel::can_leave_out(int sensor) const {
  return page_ == LimbPage::kHold && !checking_ && held_by_.size() > 1 &&
         std::find(held_by_.begin(), held_by_.end(), sensor) != held_by_.end();
}

void LimbWizardModel::leave_out(int sensor) {
  if (can_leave_out(sensor)) {
    std::erase(held_by_, sensor);
    std::erase(sensors_, sensor);
    frames_.at(static_cast<std::size_t>(pose_)).clear();
    make_calibrator();
    start_hold();
  }
}

void LimbWizardModel::add_pose_segment() {
  const std::vector<decode::AccelerationFrame>& kept = frames_.at(static_cast<std::size_t>(pose_));
  if (!checking_ && !kept.empty()) {
    const body::CalibrationGroup& group = target_.rig.groups.at(static_cast<std::size_t>(group_));
    desk_.add_segment(solve::pose_segment(group, pose_), kept.front().time_s, kept.back().time_s);
  }
}

void LimbWizardModel::keep_stretch() {
  timer_.stop();
  if (page_ == LimbPage::kHold) {
    add_pose_segment();
  }
  desk_.end_recording();
}

void LimbWizardModel::capture() {
  add_pose_segment();
  Q_EMIT captured(pose_);
  if (checking_) {
    compute_check();
  } else if (pose_ == 0) {
    start_countdown(1);
  } else {
    compute();
  }
}

}  // namespace limbwave::ui
