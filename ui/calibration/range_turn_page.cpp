#include "calibration/range_turn_page.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "calibration/sensor_chooser.h"
#include "calibration/wizard_frame.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/shown_names.h"
#include "common/theme.h"

namespace limbwave::ui {

AdviceText advice_text(const RangeSensorState& state, const QString& sensor, bool all_enough) {
  switch (state.advice) {
    case RangeAdvice::kWaiting:
      return {RangeTurnPage::tr("Start turning"), RangeTurnPage::tr("Slowly, about ten seconds for a full turn.")};
    case RangeAdvice::kNoSignal:
      return {RangeTurnPage::tr("%1: no signal").arg(sensor),
              RangeTurnPage::tr("Its readings stopped. Check its cable and plug; what was turned so far is kept.")};
    case RangeAdvice::kSlower:
      return {RangeTurnPage::tr("Slower"),
              RangeTurnPage::tr("Only slow turning shows gravity alone. What is too fast is left out.")};
    case RangeAdvice::kSmoother:
      return {RangeTurnPage::tr("Smoother"),
              RangeTurnPage::tr("Jerks and knocks are left out. Turn it like a full glass.")};
    case RangeAdvice::kTurnTo:
      break;
    case RangeAdvice::kEnough:
      if (!all_enough) {
        break;
      }
      return {RangeTurnPage::tr("Enough"),
              RangeTurnPage::tr("Finish now, or fill the last gaps for an even better result.")};
    case RangeAdvice::kComplete:
      return {all_enough ? RangeTurnPage::tr("Complete") : RangeTurnPage::tr("Go on turning"),
              all_enough ? RangeTurnPage::tr("Every direction was seen. Press Enter to finish.")
                         : RangeTurnPage::tr("Every direction was seen; a few more steady seconds are needed.")};
  }
  if (state.progress.missing.empty()) {
    return {RangeTurnPage::tr("Go on turning"), {}};
  }
  const QString where = up_words(state.progress.missing.front());
  return {
      RangeTurnPage::tr("Turn: %1").arg(where),
      state.progress.enough
          ? RangeTurnPage::tr("%1 has enough; these directions would make it better.").arg(sensor)
          : RangeTurnPage::tr("Bring the blue arrow of the box to the top; on the map, the dot into the blue ring.")};
}

RangeTurnPage::RangeTurnPage(RangeWizardModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      big_(distance_label(this)),
      sentence_(dim_label({}, this)),
      map_(new SphereMap(false, this)),
      cube_(new SensorCube(this)),
      gauge_(new RateGauge(this)),
      numbers_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      strip_title_(dim_label({}, this)),
      strip_(new SignalStrip(this)),
      chip_row_(new QHBoxLayout),
      start_over_(new QPushButton(icon(QStringLiteral("refresh")), tr("Start over"), this)) {
  big_->setObjectName(QStringLiteral("advice"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(big_);
  sentence_->setStyleSheet(QStringLiteral("font-size: 16px;"));
  sentence_->setWordWrap(true);
  layout->addWidget(sentence_);
  auto* middle = new QHBoxLayout;
  middle->setSpacing(3 * kGrid);
  middle->addWidget(map_, 3);
  auto* side = new QVBoxLayout;
  side->setSpacing(kGrid);
  side->addWidget(cube_, 1);
  side->addWidget(gauge_);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  numbers_->setTextFormat(Qt::RichText);
  side->addWidget(numbers_);
  side->addWidget(bar_);
  middle->addLayout(side, 1);
  layout->addLayout(middle, 1);
  chip_row_->setSpacing(kGrid);
  layout->addLayout(chip_row_);
  layout->addWidget(strip_title_);
  strip_->setFixedHeight(14 * kGrid);
  layout->addWidget(strip_);
  start_over_->setObjectName(QStringLiteral("start_over"));
  connect(start_over_, &QPushButton::clicked, this, [this] {
    model_.start_over();
    map_->clear_trail();
  });
  connect(&model_, &RangeWizardModel::turned, this, &RangeTurnPage::refresh);
}

void RangeTurnPage::restart() {
  shown_ = -1;
  map_->clear_trail();
  while (QLayoutItem* item = chip_row_->takeAt(0)) {
    if (item->widget() != nullptr && item->widget() != start_over_) {
      item->widget()->deleteLater();
    }
    delete item;
  }
  chips_.clear();
  for (const RangeSensorState& state : model_.states()) {
    auto* chip = new QPushButton(this);
    chip->setCheckable(true);
    chip->setObjectName(QStringLiteral("chip_%1").arg(state.sensor));
    chip->setToolTip(tr("Show this sensor; once more: the one in most need"));
    connect(chip, &QPushButton::clicked, this, [this, sensor = state.sensor] { model_.show_sensor(sensor); });
    chip->setVisible(model_.states().size() > 1);
    chip_row_->addWidget(chip);
    chips_.push_back(chip);
  }
  chip_row_->addStretch();
  chip_row_->addWidget(start_over_);
  refresh();
}

void RangeTurnPage::refresh_chips() {
  const auto& states = model_.states();
  for (std::size_t i = 0; i < std::min(chips_.size(), states.size()); ++i) {
    const RangeSensorState& state = states[i];
    const Tone tone = state.lost ? Tone::kDanger : state.progress.enough ? Tone::kGood : Tone::kUnknown;
    const QString name = shown_name(model_.rig().accelerometers.at(static_cast<std::size_t>(state.sensor)).name);
    chips_[i]->setText(state.lost ? tr("%1  no signal").arg(name)
                                  : tr("%1  %2 %").arg(name).arg(qRound(100.0 * state.progress.coverage)));
    chips_[i]->setIcon(QIcon(icon_pixmap(tone_icon(tone), finding_color(palette(), tone), 16, devicePixelRatioF())));
    chips_[i]->setChecked(state.sensor == shown_);
  }
}

void RangeTurnPage::refresh() {
  const RangeSensorState* state = model_.shown();
  if (model_.page() != RangePage::kTurn || state == nullptr) {
    return;
  }
  if (state->sensor != shown_) {
    shown_ = state->sensor;
    map_->clear_trail();
  }
  const QString name = shown_name(model_.rig().accelerometers.at(static_cast<std::size_t>(shown_)).name);
  AdviceText text = advice_text(*state, name, model_.all_enough());
  if (model_.source_lost()) {
    const bool enough_to_try = model_.obstacle().isEmpty();
    text.big = model_.can_start_over() ? tr("The device is back") : tr("Signal lost");
    text.sentence = model_.can_start_over()
                        ? tr("Start over to turn the sensors once more.")
                        : tr("The device stopped sending. Plug it in again and open it in Capture, then start over.");
    text.sentence += QLatin1Char(' ') + (enough_to_try ? tr("Or finish with what was turned until then; it is kept.")
                                                       : tr("Nothing had been turned yet."));
  }
  start_over_->setEnabled(model_.can_start_over());
  start_over_->setToolTip(model_.can_start_over() ? QString() : tr("The device is gone: open it in Capture first."));
  big_->setText(text.big);
  sentence_->setText(text.sentence);

  const calibrate::RangeParameters limits;
  const calibrate::RangeProgress& progress = state->progress;
  map_->set_visited(state->visited);
  const bool directing = state->advice == RangeAdvice::kTurnTo || state->advice == RangeAdvice::kEnough;
  std::optional<Eigen::Vector3d> wanted;
  if (directing && !progress.missing.empty()) {
    wanted = progress.missing.front();
  }
  const bool known = !progress.up_S.isZero() && !state->lost;
  map_->set_directions(known ? std::optional(progress.up_S) : std::nullopt, wanted);
  cube_->set_up(progress.up_S);
  cube_->set_wanted(wanted);
  gauge_->set_rate(progress.rate_g_per_s, limits.steadiness.largest_rate,
                   progress.unsteadiness_g > limits.steadiness.largest_unsteadiness, !state->lost);
  numbers_->setText(tr("<b>%1 %</b> of the sphere, %2 % needed<br><b>%3 s</b> steady, %4 s needed<br>%5 turned")
                        .arg(qRound(100.0 * progress.coverage))
                        .arg(qRound(100.0 * limits.required_coverage))
                        .arg(progress.steady_s, 0, 'f', 0)
                        .arg(limits.required_steady_s, 0, 'f', 0)
                        .arg(format_clock(model_.turning_s())));
  bar_->setValue(qRound(1000.0 * std::min({1.0, progress.coverage / limits.required_coverage,
                                           progress.steady_s / limits.required_steady_s})));
  strip_title_->setText(sensor_title(model_.rig(), shown_));
  strip_->set_readings(model_.recent(), shown_, model_.rig().line_in, RangeWizardModel::kSignalSeconds);
  refresh_chips();
}

}  // namespace limbwave::ui
