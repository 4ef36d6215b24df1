#include "calibration/range_wizard_model.h"

#include <algorithm>

#include "calibration/calibration_words.h"
#include "common/core_text.h"

namespace limbwave::ui {
namespace {

constexpr double kLostAfterS = 0.5;

RangeAdvice advice_for(const RangeSensorState& state, const calibrate::RangeParameters& limits) {
  const calibrate::RangeProgress& progress = state.progress;
  if (state.lost) {
    return RangeAdvice::kNoSignal;
  }
  if (progress.up_S.isZero() && progress.steady_s <= 0.0 && progress.rate_g_per_s <= 0.0) {
    return RangeAdvice::kWaiting;
  }
  if (progress.rate_g_per_s > limits.steadiness.largest_rate) {
    return RangeAdvice::kSlower;
  }
  if (!progress.steady_now && progress.unsteadiness_g > limits.steadiness.largest_unsteadiness) {
    return RangeAdvice::kSmoother;
  }
  if (progress.missing.empty()) {
    return progress.enough ? RangeAdvice::kComplete : RangeAdvice::kTurnTo;
  }
  return progress.enough && progress.coverage >= 0.9 ? RangeAdvice::kEnough : RangeAdvice::kTurnTo;
}

}  // namespace

std::array<bool, calibrate::SphereCoverage::kCells> visited_cells(const calibrate::RangeProgress& progress) {
  std::array<bool, calibrate::SphereCoverage::kCells> visited{};
  visited.fill(true);
  for (const Eigen::Vector3d& direction : progress.missing) {
    visited.at(static_cast<std::size_t>(calibrate::SphereCoverage::cell_of(direction))) = false;
  }
  return visited;
}

RangeWizardModel::RangeWizardModel(CalibrationDesk& desk, QObject* parent) : WizardModel(desk, parent) {
  connect(&desk_.source(), &CalibrationSource::arrived, this, &RangeWizardModel::take_frames);
  connect(&desk_.source(), &CalibrationSource::changed, this, [this] {
    notice_loss(page_ == RangePage::kTurn);
    if (const RangePage page = page_;
        device_came() && (page == RangePage::kChoose || page == RangePage::kInstructions)) {
      const bool same = desk_.rig().name == target_.rig.name;
      begin(same ? chosen_ : std::vector<int>{});
      set_page(same ? page : RangePage::kChoose);
    }
    if (page_ == RangePage::kTurn) {
      Q_EMIT turned();
    } else {
      Q_EMIT choice_changed();
    }
  });
}

void RangeWizardModel::set_page(RangePage page) {
  page_ = page;
  desk_.source().ask(page == RangePage::kTurn ? "range" : "");
  Q_EMIT page_changed();
}

void RangeWizardModel::begin(std::vector<int> sensors) {
  ++attempt_;
  take_on(desk_.target());
  const int all = static_cast<int>(target_.rig.accelerometers.size());
  if (sensors.empty()) {
    const calibrate::RigCalibration calibration = desk_.calibration_of(target_);
    for (int s = 0; s < all; ++s) {
      if (calibration.sensors[static_cast<std::size_t>(s)].method == "nominal") {
        sensors.push_back(s);
      }
    }
  }
  if (sensors.empty()) {
    for (int s = 0; s < all; ++s) {
      sensors.push_back(s);
    }
  }
  chosen_ = std::move(sensors);
  outcomes_.clear();
  states_.clear();
  calibrators_.clear();
  turning_s_ = 0.0;
  saving_ = false;
  set_page(RangePage::kChoose);
}

void RangeWizardModel::choose(int sensor, bool on) {
  std::erase(chosen_, sensor);
  if (on) {
    chosen_.push_back(sensor);
    std::sort(chosen_.begin(), chosen_.end());
  }
  Q_EMIT choice_changed();
}

QString RangeWizardModel::obstacle() const {
  switch (page_) {
    case RangePage::kChoose:
      if (chosen_.empty()) {
        return tr("Choose at least one sensor.");
      }
      [[fallthrough]];
    case RangePage::kInstructions:
      if (!desk_.source().running()) {
        return tr("No signal comes in. Open a device in Capture.");
      }
      return {};
    case RangePage::kTurn:
      return turning_s_ >= 1.0 ? QString()
             : interrupted_    ? tr("The device died before anything was turned. Start over when it is back.")
                               : tr("Turn the sensors first.");
    case RangePage::kComputing:
      return tr("Computing…");
    case RangePage::kResult:
      return saving_ ? tr("Saving…") : accepted() == 0 ? tr("Nothing is accepted yet.") : QString();
  }
  return {};
}

void RangeWizardModel::next() {
  if (!obstacle().isEmpty()) {
    return;
  }
  switch (page_) {
    case RangePage::kChoose:
      set_page(RangePage::kInstructions);
      break;
    case RangePage::kInstructions:
      start_turning(chosen_);
      break;
    case RangePage::kTurn:
      compute();
      break;
    case RangePage::kComputing:
      break;
    case RangePage::kResult:
      save();
      break;
  }
}

void RangeWizardModel::back() {
  switch (page_) {
    case RangePage::kInstructions:
      set_page(RangePage::kChoose);
      break;
    case RangePage::kTurn:
      desk_.end_recording();
      calibrators_.clear();
      turning_s_ = 0.0;
      set_page(outcomes_.empty() ? RangePage::kInstructions : RangePage::kResult);
      break;
    default:
      break;
  }
}

bool RangeWizardModel::would_lose() const {
  return (page_ == RangePage::kTurn && turning_s_ > 2.0) || page_ == RangePage::kComputing || has_open_verdicts();
}

void RangeWizardModel::cancel() {
  ++attempt_;
  desk_.end_recording();
  calibrators_.clear();
  outcomes_.clear();
  page_ = RangePage::kChoose;
  desk_.source().ask({});
  Q_EMIT left();
}

void RangeWizardModel::start_turning(const std::vector<int>& sensors) {
  turning_ = sensors;
  interrupted_ = false;
  desk_.begin_recording(QStringLiteral("range"));
  start_over();
  set_page(RangePage::kTurn);
}

void RangeWizardModel::start_over() {
  if (!can_start_over()) {
    return;
  }
  if (interrupted_) {
    interrupted_ = false;
    desk_.begin_recording(QStringLiteral("range"));
  }
  calibrators_.clear();
  states_.clear();
  for (const int sensor : turning_) {
    calibrators_.emplace_back(target_.rig.line_in,
                              target_.rig.accelerometers.at(static_cast<std::size_t>(sensor)).serial);
    RangeSensorState state;
    state.sensor = sensor;
    states_.push_back(state);
  }
  last_usable_s_.assign(turning_.size(), -1.0);
  recent_.clear();
  shown_ = -1;
  first_s_ = -1.0;
  turning_s_ = 0.0;
  told_enough_ = false;
  Q_EMIT turned();
}

void RangeWizardModel::take_frames(const std::vector<decode::AccelerationFrame>& frames) {
  // After the device died its clock began anew: such readings do not go with
  // those before.
  if (page_ != RangePage::kTurn || !listens() || frames.empty()) {
    return;
  }
  for (const decode::AccelerationFrame& frame : frames) {
    if (first_s_ < 0.0) {
      first_s_ = frame.time_s;
      std::fill(last_usable_s_.begin(), last_usable_s_.end(), frame.time_s);
    }
    newest_s_ = frame.time_s;
    for (std::size_t i = 0; i < turning_.size(); ++i) {
      const auto sensor = static_cast<std::size_t>(turning_[i]);
      const bool usable = (frame.usable >> sensor & 1U) != 0;
      calibrators_[i].push(frame.time_s, frame.volts.at(sensor), usable);
      if (usable) {
        last_usable_s_[i] = frame.time_s;
      }
    }
    recent_.push_back(frame);
  }
  while (newest_s_ - recent_.front().time_s > kSignalSeconds) {
    recent_.pop_front();
  }
  turning_s_ = newest_s_ - first_s_;
  update_states();
  Q_EMIT turned();
  if (!told_enough_ && all_enough()) {
    told_enough_ = true;
    Q_EMIT sufficed();
  }
}

void RangeWizardModel::update_states() {
  const calibrate::RangeParameters limits;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    RangeSensorState& state = states_[i];
    state.progress = calibrators_[i].progress();
    state.lost = newest_s_ - last_usable_s_[i] > kLostAfterS;
    state.visited = visited_cells(state.progress);
    state.advice = advice_for(state, limits);
  }
}

const RangeSensorState* RangeWizardModel::shown() const {
  const RangeSensorState* best = nullptr;
  for (const RangeSensorState& state : states_) {
    if (state.sensor == shown_) {
      return &state;
    }
    // A sensor without signal first, then the one that has seen least.
    if (best == nullptr || (state.lost && !best->lost) ||
        (state.lost == best->lost && state.progress.coverage < best->progress.coverage)) {
      best = &state;
    }
  }
  return best;
}

void RangeWizardModel::show_sensor(int sensor) {
  shown_ = shown_ == sensor ? -1 : sensor;
  Q_EMIT turned();
}

bool RangeWizardModel::all_enough() const {
  return !states_.empty() &&
         std::all_of(states_.begin(), states_.end(), [](const auto& state) { return state.progress.enough; });
}

void RangeWizardModel::keep_stretch() {
  if (first_s_ >= 0.0) {
    desk_.add_segment(solve::kRangeSegment, first_s_, newest_s_);
  }
  desk_.end_recording();
}

void RangeWizardModel::compute() {
  keep_stretch();
  set_page(RangePage::kComputing);
  auto calibrators = std::make_shared<std::vector<calibrate::RangeCalibrator>>(std::move(calibrators_));
  calibrators_.clear();
  using Outcomes = std::vector<RangeOutcome>;
  std::vector<std::array<bool, calibrate::SphereCoverage::kCells>> visited;
  for (const RangeSensorState& state : states_) {
    visited.push_back(state.visited);
  }
  const std::uint64_t attempt = ++attempt_;
  desk_.context().jobs().compute<Outcomes>(
      tr("Computing the range calibration"), this,
      [calibrators, visited, sensors = turning_, date = now_iso()](const Progress& progress) -> Result<Outcomes> {
        Outcomes outcomes;
        for (std::size_t i = 0; i < calibrators->size(); ++i) {
          if (!progress.report(static_cast<double>(i) / static_cast<double>(calibrators->size()))) {
            return cancelled();
          }
          RangeOutcome outcome;
          outcome.sensor = sensors[i];
          outcome.visited = visited[i];
          Result<calibrate::RangeResult> result = (*calibrators)[i].finish(date);
          if (result) {
            outcome.result = std::move(result).value();
          } else {
            outcome.error = result.error();
          }
          outcomes.push_back(std::move(outcome));
        }
        return outcomes;
      },
      [this, attempt](Result<Outcomes> outcomes) {
        if (attempt != attempt_) {
          return;
        }
        if (outcomes) {
          merge(std::move(outcomes).value());
        }
        set_page(outcomes_.empty() ? RangePage::kInstructions : RangePage::kResult);
      });
}

void RangeWizardModel::merge(std::vector<RangeOutcome> outcomes) {
  for (RangeOutcome& outcome : outcomes) {
    const auto same = std::find_if(outcomes_.begin(), outcomes_.end(),
                                   [&](const RangeOutcome& old) { return old.sensor == outcome.sensor; });
    // What is good or usable is accepted unless the technician says otherwise.
    if (outcome.result && outcome.result->verdict != calibrate::Verdict::kRepeat) {
      outcome.decision = Decision::kAccepted;
    }
    if (same == outcomes_.end()) {
      outcomes_.push_back(std::move(outcome));
      continue;
    }
    if (same->result) {
      outcome.before_g = same->result->calibration.residual_g;
    }
    *same = std::move(outcome);
  }
  std::sort(outcomes_.begin(), outcomes_.end(), [](const auto& a, const auto& b) { return a.sensor < b.sensor; });
  Q_EMIT outcomes_changed();
}

void RangeWizardModel::show_outcomes(std::vector<RangeOutcome> outcomes, const CalibrationDesk::Target& target) {
  ++attempt_;
  take_on(target);
  from_take_ = true;
  outcomes_.clear();
  merge(std::move(outcomes));
  set_page(RangePage::kResult);
}

std::optional<calibrate::Verdict> RangeWizardModel::verdict(int i) const {
  const auto& result = outcomes_.at(static_cast<std::size_t>(i)).result;
  return result ? std::optional(result->verdict) : std::nullopt;
}

void RangeWizardModel::repeat(int sensor) {
  if (page_ == RangePage::kResult && repeatable()) {
    start_turning({sensor});
  }
}

CalibrationChange RangeWizardModel::accepted_change() const {
  CalibrationChange change;
  for (const RangeOutcome& outcome : outcomes_) {
    if (outcome.decision == Decision::kAccepted && outcome.result) {
      change.ranges.emplace_back(outcome.sensor, outcome.result->calibration);
    }
  }
  return change;
}

}  // namespace limbwave::ui
