#include "workspaces/solve/settings_card.h"

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <cmath>

#include "common/core_text.h"
#include "common/theme.h"
#include "solve/report_text.h"
#include "workspaces/solve/quality_text.h"

namespace limbwave::ui {

namespace {

constexpr int kWeakest = 10, kStrongest = 500;  // Milliseconds.

}  // namespace

SettingsCard::SettingsCard(SolveModel& model, QWidget* parent) : Card(tr("Solving"), parent), model_(model) {
  build();
  connect(&model_, &SolveModel::settings_changed, this, &SettingsCard::show_settings);
  connect(&model_, &SolveModel::state_changed, this, &SettingsCard::show_state);
  connect(&model_, &SolveModel::solve_changed, this, &SettingsCard::show_state);
  show_settings();
  show_state();
}

void SettingsCard::build() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  smoothing_ = new QComboBox(this);
  smoothing_->setAccessibleName(tr("Smoothing"));
  for (const auto kind : solve::kSmoothings) {
    smoothing_->addItem(smoothing_name(kind), static_cast<int>(kind));
    smoothing_->setItemData(smoothing_->count() - 1, smoothing_hint(kind), Qt::ToolTipRole);
  }
  strength_ = new QSpinBox(this);
  strength_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  strength_->setRange(kWeakest, kStrongest);
  strength_->setSuffix(tr(" ms"));
  strength_->setSingleStep(10);
  strength_->setKeyboardTracking(false);
  strength_->setAccessibleName(tr("Time scale of the smoothing in milliseconds"));
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setRange(kWeakest, kStrongest);
  slider_->setSingleStep(10);
  slider_->setPageStep(50);
  slider_->setAccessibleName(strength_->accessibleName());
  calibration_ = new QComboBox(this);
  calibration_->setAccessibleName(tr("Calibration"));
  calibration_->addItem(tr("Best there is"), QStringLiteral("auto"));
  calibration_->addItem(tr("Of the take"), QStringLiteral("snapshot"));
  calibration_->addItem(tr("Poses in the take"), QStringLiteral("segments"));
  calibration_->addItem(tr("Library"), QStringLiteral("library"));
  calibration_->addItem(tr("Data sheet"), QStringLiteral("nominal"));
  hint_ = dim_label({}, this);
  hint_->setWordWrap(true);
  source_ = dim_label({}, this);
  source_->setWordWrap(true);
  auto* smoothing_label = dim_label(tr("Smoothing"), this);
  auto* strength_label = dim_label(tr("Strength"), this);
  auto* calibration_label = dim_label(tr("Calibration"), this);
  for_inclination_ = {smoothing_label, strength_label, calibration_label, smoothing_, strength_, slider_, calibration_};
  grid->addWidget(smoothing_label, 0, 0);
  grid->addWidget(smoothing_, 0, 1);
  grid->addWidget(strength_label, 1, 0);
  grid->addWidget(strength_, 1, 1);
  grid->addWidget(slider_, 2, 0, 1, 2);
  grid->addWidget(hint_, 3, 0, 1, 2);
  grid->addWidget(calibration_label, 4, 0);
  grid->addWidget(calibration_, 4, 1);
  grid->addWidget(source_, 5, 0, 1, 2);
  body()->addLayout(grid);
  solve_ = new QPushButton(tr("Solve"), this);
  body()->addWidget(solve_);

  connect(smoothing_, &QComboBox::activated, this, [this] {
    solve::SolveSettings settings = model_.settings();
    settings.smoothing = static_cast<solve::Smoothing>(smoothing_->currentData().toInt());
    if (settings.smoothing != model_.settings().smoothing) {
      model_.change_settings(settings, tr("change smoothing"));
    }
  });
  connect(calibration_, &QComboBox::activated, this, [this] {
    solve::SolveSettings settings = model_.settings();
    settings.calibration = calibration_->currentData().toString().toStdString();
    if (settings.calibration != model_.settings().calibration) {
      model_.change_settings(settings, tr("change calibration"));
    }
  });
  connect(strength_, &QSpinBox::valueChanged, this, [this](int value) { set_strength(value, kNoGesture); });
  connect(slider_, &QSlider::sliderPressed, this, [this] { gesture_ = model_.key_editor().begin_gesture(); });
  connect(slider_, &QSlider::sliderReleased, this, [this] { gesture_ = kNoGesture; });
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { set_strength(value, gesture_); });
  connect(solve_, &QPushButton::clicked, this, [this] {
    if (model_.state() == SolveState::kSolving) {
      model_.cancel();
    } else {
      model_.start();
    }
  });
}

void SettingsCard::set_strength(int milliseconds, int gesture) {
  if (showing_ || std::lround(1000.0 * model_.settings().smoothing_s) == milliseconds) {
    return;
  }
  solve::SolveSettings settings = model_.settings();
  settings.smoothing_s = milliseconds / 1000.0;
  model_.change_settings(settings, tr("change strength of smoothing"), gesture);
}

void SettingsCard::show_settings() {
  showing_ = true;
  const solve::SolveSettings& settings = model_.settings();
  smoothing_->setCurrentIndex(smoothing_->findData(static_cast<int>(settings.smoothing)));
  for (QWidget* widget : for_inclination_) {
    widget->setVisible(model_.by_inclination());
  }
  hint_->setText(model_.by_inclination()
                     ? smoothing_hint(settings.smoothing)
                     : tr("By the body filter, forward and backward, from all sensors. Other choices of sensors and of "
                          "the root are made by the command line: limbwave solve."));
  const auto milliseconds = static_cast<int>(std::lround(1000.0 * settings.smoothing_s));
  strength_->setValue(milliseconds);
  slider_->setValue(milliseconds);
  const bool smooths = settings.smoothing != solve::Smoothing::kNone;
  strength_->setEnabled(smooths);
  slider_->setEnabled(smooths);
  calibration_->setCurrentIndex(calibration_->findData(QString::fromStdString(settings.calibration)));
  showing_ = false;
}

void SettingsCard::show_state() {
  const bool busy = model_.state() == SolveState::kSolving;
  setEnabled(model_.state() != SolveState::kNoTake);
  solve_->setText(busy ? tr("Cancel solving") : (model_.solve() ? tr("Solve again") : tr("Solve")));
  solve_->setEnabled(model_.state() != SolveState::kNoTake && model_.state() != SolveState::kLoading);
  // A body filter's sensors come calibrated.
  const bool calibrated = model_.solve() && model_.by_inclination();
  const QString used = calibrated ? core_text(model_.solve()->report.calibration) : QString();
  source_->setText(used.isEmpty() ? QString() : tr("Used: %1").arg(used));
  source_->setVisible(!used.isEmpty());
}

}  // namespace limbwave::ui
