#include "workspaces/record_banner.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "common/format.h"
#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "workspaces/capture/capture_model.h"

namespace limbwave::ui {

namespace {

constexpr double kFigures = 56.0 / 13.0;  // Read from two metres away: at least 48 px.
constexpr int kDot = 32;

}  // namespace

RecordBanner::RecordBanner(StudioContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      capture_(CaptureModel::of(context)),
      dot_(new QLabel(this)),
      time_(new QLabel(this)),
      state_(new QLabel(this)),
      marker_(dim_label({}, this)),
      mark_(new QPushButton(tr("Set marker (M)"), this)),
      stop_(new QPushButton(this)) {
  setObjectName(QStringLiteral("record_banner"));
  setProperty("strip", true);
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * kGrid, kGrid / 2, kGrid, kGrid / 2);
  row->setSpacing(2 * kGrid);
  time_->setFont(tabular(time_->font(), kFigures, QFont::Light));
  time_->setObjectName(QStringLiteral("banner_time"));
  time_->setAccessibleName(tr("Recorded time"));
  // Wide enough for an hour, so that what stands beside it does not move.
  time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(QStringLiteral("00:00.0")));
  state_->setFont(tabular(state_->font(), 20.0 / 13.0));
  mark_->setFocusPolicy(Qt::TabFocus);
  stop_->setFocusPolicy(Qt::TabFocus);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  words->addStretch(1);
  words->addWidget(state_);
  words->addWidget(marker_);
  words->addStretch(1);
  row->addWidget(dot_);
  row->addWidget(time_);
  row->addLayout(words, 1);
  row->addWidget(mark_);
  row->addWidget(stop_);
  connect(mark_, &QPushButton::clicked, this, [this] { context_.markers().mark_now(); });
  connect(stop_, &QPushButton::clicked, &capture_, &CaptureModel::toggle_recording);
  connect(&capture_, &CaptureModel::countdown_changed, this, &RecordBanner::refresh);
  connect(&context_.live(), &LiveModel::recording_changed, this, &RecordBanner::refresh);
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &RecordBanner::refresh_time);
  connect(&context_.markers(), &MarkerModel::changed, this, &RecordBanner::refresh);
  refresh();
}

void RecordBanner::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    show_dot();
  }
}

Loss RecordBanner::loss() const {
  const auto& snapshot = context_.live().snapshot();
  return snapshot ? loss_of(*snapshot) : Loss::kNone;
}

void RecordBanner::show_dot() {
  // Red is for losing data; that it records is no trouble.
  const ThemeColors& theme = theme_colors(palette());
  const bool now = shows_loss_ == Loss::kNow;
  dot_->setPixmap(icon_pixmap(now ? QStringLiteral("bad") : QStringLiteral("record"),
                              now                          ? theme.danger
                              : shows_loss_ == Loss::kPast ? theme.warning
                                                           : theme.accent,
                              kDot, devicePixelRatioF()));
}

void RecordBanner::refresh() {
  const LiveModel& live = context_.live();
  const bool recording = live.recording() && !live.aside();
  const bool finishing = live.finishing() && !live.aside();
  const int countdown = capture_.countdown();
  setVisible(recording || finishing || countdown > 0);
  if (isHidden()) {
    return;
  }
  shows_loss_ = recording ? loss() : Loss::kNone;
  show_dot();
  dot_->setVisible(recording);
  mark_->setVisible(recording);
  stop_->setVisible(!finishing);
  stop_->setText(recording ? tr("Stop (R)") : tr("Cancel (R)"));
  const Marker* newest = recording ? context_.markers().find(context_.markers().newest()) : nullptr;
  marker_->setText(newest != nullptr
                       ? tr("%1 at %2").arg(newest->text, format_clock_tenths(context_.markers().time_s(*newest)))
                       : QString());
  marker_->setVisible(newest != nullptr);
  state_->setText(countdown > 0               ? tr("Recording begins in %n second(s)", nullptr, countdown)
                  : finishing                 ? tr("Closing the take")
                  : shows_loss_ == Loss::kNow ? tr("Recording, but samples are being lost")
                  : shows_loss_ == Loss::kPast
                      ? tr("Recording; samples were lost")
                      : tr("Recording %1").arg(QString::fromStdString(live.recording_folder().stem().string())));
  refresh_time();
}

void RecordBanner::refresh_time() {
  if (isHidden()) {
    return;
  }
  const LiveModel& live = context_.live();
  const auto& snapshot = live.snapshot();
  if (live.recording() && shows_loss_ != loss()) {
    refresh();
    return;
  }
  if (capture_.countdown() > 0) {
    time_->setText(QString::number(capture_.countdown()));
  } else if (live.recording()) {
    time_->setText(format_clock_tenths(snapshot ? snapshot->recorded_s : 0.0));
  }
}

}  // namespace limbwave::ui
