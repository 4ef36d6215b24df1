#include "calibration/verdict_row.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

namespace {

constexpr int kLeastWidth = 70 * kGrid;
constexpr int kBesideEachOther = 130 * kGrid;  // From here on the buttons stand behind the words, else below.

}  // namespace

CalibrationState refused_state() {
  return {Tone::kDanger, verdict_word(calibrate::Verdict::kRepeat), {}, {}};
}

VerdictRow::VerdictRow(int sensor, bool with_map, QWidget* parent)
    : QFrame(parent),
      sensor_(sensor),
      title_(new QLabel(this)),
      serial_(dim_label({}, this)),
      badge_(new VerdictBadge(this)),
      map_(new SphereMap(true, this)),
      text_(new QLabel(this)),
      comparison_(dim_label({}, this)),
      accept_(new QPushButton(this)),
      repeat_(new QPushButton(icon(QStringLiteral("refresh")), tr("Repeat this sensor only"), this)),
      discard_(new QPushButton(tr("Discard"), this)) {
  setProperty("card", true);
  setObjectName(QStringLiteral("verdict_%1").arg(sensor));
  outer_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
  outer_->setContentsMargins(2 * kGrid, kGrid + 4, 2 * kGrid, kGrid + 4);
  outer_->setSpacing(kGrid);
  auto* layout = new QHBoxLayout;
  layout->setSpacing(2 * kGrid);
  outer_->addLayout(layout, 1);
  title_->setStyleSheet(QStringLiteral("font-size: 16px;"));
  auto* names = new QWidget(this);
  names->setFixedWidth(12 * kGrid);
  auto* names_layout = new QVBoxLayout(names);
  names_layout->setContentsMargins(0, 0, 0, 0);
  names_layout->setSpacing(2);
  title_->setWordWrap(true);
  names_layout->addWidget(title_);
  names_layout->addWidget(serial_);
  layout->addWidget(names);
  badge_->setFixedWidth(17 * kGrid);
  layout->addWidget(badge_);
  map_->setVisible(with_map);
  layout->addWidget(map_);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  text_->setWordWrap(true);
  text_->setObjectName(QStringLiteral("text"));
  comparison_->setWordWrap(true);
  words->addStretch();
  words->addWidget(text_);
  words->addWidget(comparison_);
  words->addStretch();
  layout->addLayout(words, 1);
  accept_->setObjectName(QStringLiteral("accept_%1").arg(sensor));
  accept_->setCheckable(true);
  accept_->setMinimumWidth(11 * kGrid);
  repeat_->setObjectName(QStringLiteral("repeat_%1").arg(sensor));
  discard_->setObjectName(QStringLiteral("discard_%1").arg(sensor));
  discard_->setCheckable(true);
  discard_->setMinimumWidth(11 * kGrid);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  buttons->addStretch();
  buttons->addWidget(accept_);
  buttons->addWidget(repeat_);
  buttons->addWidget(discard_);
  outer_->addLayout(buttons);
  setMinimumWidth(kLeastWidth);  // Not that of the words and the buttons side by side.
  connect(accept_, &QPushButton::clicked, this, [this] { Q_EMIT accept(sensor_); });
  connect(repeat_, &QPushButton::clicked, this, [this] { Q_EMIT repeat(sensor_); });
  connect(discard_, &QPushButton::clicked, this, [this] { Q_EMIT discard(sensor_); });
}

void VerdictRow::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  const auto wanted = width() < kBesideEachOther ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (outer_->direction() != wanted) {
    outer_->setDirection(wanted);
  }
}

void VerdictRow::set_content(const VerdictRowContent& content) {
  title_->setText(content.title);
  serial_->setText(content.serial);
  serial_->setVisible(!content.serial.isEmpty());
  badge_->set_state(content.state);
  text_->setText(content.text);
  comparison_->setText(content.comparison);
  comparison_->setVisible(!content.comparison.isEmpty());
  const bool accepted = content.decision == Decision::kAccepted;
  const bool discarded = content.decision == Decision::kDiscarded;
  accept_->setText(accepted ? tr("Accepted") : tr("Accept"));
  accept_->setChecked(accepted);
  accept_->setEnabled(content.acceptable);
  accept_->setIcon(
      accepted ? QIcon(icon_pixmap(QStringLiteral("good"), theme_colors(palette()).good, 16, devicePixelRatioF()))
               : QIcon());
  repeat_->setEnabled(content.repeatable);
  repeat_->setToolTip(content.repeatable ? QString() : tr("Needs a running capture"));
  discard_->setText(discarded ? tr("Discarded") : tr("Discard"));
  discard_->setChecked(discarded);
  discard_->setEnabled(content.acceptable);
}

}  // namespace limbwave::ui
