#include "workspaces/capture/level_panel.h"

#include <QEvent>
#include <QHBoxLayout>

#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

LevelPanel::LevelPanel(StudioContext& context, QWidget* parent)
    : Card(tr("Level"), parent),
      context_(context),
      left_(new LevelMeter(tr("Left: accelerations"), this)),
      right_(new LevelMeter(tr("Right: clock"), this)),
      icon_(new QLabel(this)),
      title_(new QLabel(this)),
      remedy_(dim_label({}, this)),
      others_(dim_label({}, this)) {
  setObjectName(QStringLiteral("level_panel"));
  body()->addWidget(left_);
  body()->addWidget(right_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  icon_->setFixedSize(18, 18);
  QFont bold = title_->font();
  bold.setWeight(QFont::DemiBold);
  title_->setFont(bold);
  title_->setWordWrap(true);
  title_->setObjectName(QStringLiteral("level_advice"));
  row->addWidget(icon_, 0, Qt::AlignTop);
  row->addWidget(title_, 1);
  body()->addLayout(row);
  for (QLabel* label : {remedy_, others_}) {
    label->setWordWrap(true);
    body()->addWidget(label);
  }
  learn_ = link_label(tr("Learn how to set the level"), this);
  learn_->setObjectName(QStringLiteral("learn_levels"));
  body()->addWidget(learn_);
  connect(learn_, &QLabel::linkActivated, this,
          [this] { context_.reveal(QStringLiteral("manual"), QStringLiteral("levels")); });
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &LevelPanel::refresh);
  connect(&context_.live(), &LiveModel::state_changed, this, &LevelPanel::refresh);
  refresh();
}

QString LevelPanel::advice_title() const {
  return title_->text();
}

void LevelPanel::changeEvent(QEvent* event) {
  Card::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    shown_any_ = false;
    refresh();
  }
}

void LevelPanel::refresh() {
  const auto& snapshot = context_.live().snapshot();
  const std::vector<Advice> advice = level_advice(snapshot.get());
  if (snapshot) {
    constexpr double kClips = 0.999;
    left_->set_level(snapshot->line.left_peak, snapshot->line.left_peak >= kClips);
    right_->set_level(snapshot->line.right_peak, snapshot->line.right_peak >= kClips);
  } else {
    left_->set_level(-1.0, false);
    right_->set_level(-1.0, false);
  }
  const Advice& first = advice.front();
  learn_->setVisible(snapshot && (first.tone == Tone::kWarning || first.tone == Tone::kDanger));
  if (!shown_any_ || shown_tone_ != first.tone) {
    icon_->setPixmap(icon_pixmap(tone_icon(first.tone), tone_color(palette(), first.tone), 18, devicePixelRatioF()));
    shown_tone_ = first.tone;
    shown_any_ = true;
  }
  if (title_->text() != first.title) {
    title_->setText(first.title);
  }
  if (remedy_->text() != first.remedy) {
    remedy_->setText(first.remedy);
  }
  remedy_->setVisible(!first.remedy.isEmpty());
  QStringList more;
  for (std::size_t i = 1; i < advice.size() && i < 3; ++i) {
    more.append(QStringLiteral("• ") + advice[i].title +
                (advice[i].remedy.isEmpty() ? QString() : QStringLiteral(". ") + advice[i].remedy));
  }
  others_->setText(more.join(QLatin1Char('\n')));
  others_->setVisible(!more.isEmpty());
}

}  // namespace limbwave::ui
