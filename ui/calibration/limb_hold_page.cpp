#include "calibration/limb_hold_page.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "calibration/wizard_frame.h"
#include "common/shown_names.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

LimbHoldPage::LimbHoldPage(LimbWizardModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      picture_(new PosePicture(this)),
      which_(new QLabel(this)),
      big_(distance_label(this)),
      sentence_(dim_label({}, this)),
      dial_(new CountdownDial(this)),
      bars_(new MovementBars(this)),
      stillest_(new QPushButton(this)),
      leave_out_(new QPushButton(this)) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kGrid);
  columns->addWidget(picture_, 2);
  auto* side = new QVBoxLayout;
  side->setSpacing(kGrid);
  which_->setStyleSheet(QStringLiteral("font-size: 20px;"));
  side->addWidget(which_);
  big_->setObjectName(QStringLiteral("advice"));
  side->addWidget(big_);
  sentence_->setWordWrap(true);
  sentence_->setStyleSheet(QStringLiteral("font-size: 18px;"));
  side->addWidget(sentence_);
  side->addWidget(dial_, 1);
  side->addWidget(bars_);
  auto* buttons = new QHBoxLayout;
  stillest_->setObjectName(QStringLiteral("take_stillest"));
  leave_out_->setObjectName(QStringLiteral("leave_out"));
  buttons->addWidget(stillest_);
  buttons->addWidget(leave_out_);
  buttons->addStretch();
  side->addLayout(buttons);
  columns->addLayout(side, 3);
  connect(stillest_, &QPushButton::clicked, &model_, &LimbWizardModel::take_stillest);
  connect(leave_out_, &QPushButton::clicked, this, [this] { model_.leave_out(lost_); });
  connect(&model_, &LimbWizardModel::held, this, &LimbHoldPage::refresh);
}

void LimbHoldPage::restart() {
  std::vector<int> sensors;
  for (const HolderState& holder : model_.holders()) {
    sensors.push_back(holder.sensor);
  }
  picture_->set_pose(model_.rig(), model_.skeleton(), model_.group(), model_.pose(), sensors);
  const QString name = shown_name(model_.pose_text(model_.pose()).name);
  which_->setText(model_.checking() ? tr("Check: %1").arg(name)
                                    : tr("Pose %1 of 2: %2").arg(model_.pose() + 1).arg(name));
  refresh();
}

QString LimbHoldPage::names(bool (*wanted)(const HolderState&)) const {
  QStringList list;
  for (const HolderState& holder : model_.holders()) {
    if (wanted(holder)) {
      list << shown_name(model_.rig().accelerometers.at(static_cast<std::size_t>(holder.sensor)).name);
    }
  }
  return list.join(tr(", "));
}

void LimbHoldPage::refresh() {
  if (model_.page() != LimbPage::kCountdown && model_.page() != LimbPage::kHold) {
    return;
  }
  std::vector<MovementBars::Row> rows;
  lost_ = -1;
  for (const HolderState& holder : model_.holders()) {
    rows.push_back({shown_name(model_.rig().accelerometers.at(static_cast<std::size_t>(holder.sensor)).name),
                    holder.movement.movement_g, holder.movement.has_signal, holder.movement.heard});
    if (holder.movement.heard && !holder.movement.has_signal && lost_ < 0) {
      lost_ = holder.sensor;
    }
  }
  bars_->set_rows(std::move(rows), model_.still_threshold_g());
  if (model_.source_lost()) {
    show_lost();
  } else if (model_.page() == LimbPage::kCountdown) {
    show_countdown();
  } else {
    show_hold();
  }
}

void LimbHoldPage::show_countdown() {
  stillest_->hide();
  leave_out_->hide();
  big_->setText(tr("Take this pose"));
  sentence_->setText(shown_name(model_.pose_text(model_.pose()).instruction));
  dial_->set_state(QString::number(std::max(1, static_cast<int>(std::ceil(model_.countdown_left_s())))),
                   model_.countdown_left_s() / model_.countdown_s(), Tone::kUnknown);
}

void LimbHoldPage::show_lost() {
  stillest_->hide();
  leave_out_->hide();
  const bool back = model_.desk().source().running();
  big_->setText(back ? tr("The device is back") : tr("Signal lost"));
  sentence_->setText(back ? tr("Go back and start the poses again.")
                          : tr("The device stopped sending. Plug it in again, open it in Capture, then go back and "
                               "start the poses again. What was held until then is kept."));
  dial_->set_state(tr("lost"), 0.0, Tone::kDanger);
}

void LimbHoldPage::show_hold() {
  const QString lost =
      names([](const HolderState& holder) { return holder.movement.heard && !holder.movement.has_signal; });
  const QString movers = names([](const HolderState& holder) { return holder.moves; });
  const bool early = model_.progress().seconds < 0.5;
  stillest_->setVisible(model_.can_take_stillest());
  leave_out_->setVisible(!early && lost_ >= 0 && model_.can_leave_out(lost_));
  if (leave_out_->isVisibleTo(this)) {
    leave_out_->setText(
        tr("Go on without %1").arg(shown_name(model_.rig().accelerometers.at(static_cast<std::size_t>(lost_)).name)));
  }
  if (model_.can_take_stillest()) {
    stillest_->setText(tr("Take the stillest second (%1)").arg(format_mg(model_.progress().best_movement_g)));
  }
  if (!early && !lost.isEmpty()) {
    big_->setText(tr("No signal: %1").arg(lost));
    sentence_->setText(tr("Check the cable and plug of %1, or go on without.").arg(lost));
    dial_->set_state(tr("?"), 0.0, Tone::kDanger);
  } else if (model_.captured_fraction() > 0.0) {
    big_->setText(tr("Hold still"));
    sentence_->setText(tr("Good, stay like this."));
    dial_->set_state(tr("still"), model_.captured_fraction(), Tone::kGood);
  } else if (!movers.isEmpty() && model_.progress().seconds > 1.0) {
    big_->setText(tr("Moves: %1").arg(movers));
    sentence_->setText(tr("Rest it against something, breathe out and hold. It is taken as soon as all are still."));
    dial_->set_state(tr("moves"), 0.0, Tone::kWarning);
  } else {
    big_->setText(tr("Hold still"));
    sentence_->setText(tr("One still second is enough."));
    dial_->set_state(tr("hold"), 0.0, Tone::kUnknown);
  }
}

}  // namespace limbwave::ui
