#include "workspaces/status_strip.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

StatusButton::StatusButton(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

void StatusButton::set_fact(const StatusFact& fact) {
  const bool wider = fact.text.size() != fact_.text.size();
  if (fact.text == fact_.text && fact.tone == fact_.tone && fact.detail == fact_.detail) {
    fact_.topic = fact.topic;
    fact_.workspace = fact.workspace;
    return;
  }
  fact_ = fact;
  setToolTip(fact_.detail);
  setAccessibleName(fact_.text);
  setAccessibleDescription(fact_.detail);
  if (wider) {
    updateGeometry();
  }
  update();
}

QSize StatusButton::sizeHint() const {
  // Every figure as wide as a 0, so that running numbers do not push their neighbours about.
  QString widest = fact_.text;
  for (QChar& c : widest) {
    c = c.isDigit() ? QLatin1Char('0') : c;
  }
  return {fontMetrics().horizontalAdvance(widest) + 16 + 3 * kGrid, 5 * kGrid};
}

void StatusButton::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  const QRectF area = QRectF(rect()).adjusted(2, 6, -2, -6);
  const bool recording = fact_.id == QLatin1String("record") && fact_.tone != Tone::kUnknown;
  if (fact_.tone == Tone::kDanger) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.danger);
    painter.drawRoundedRect(area, 4, 4);
  } else if (underMouse()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(area, 4, 4);
  }
  if (hasFocus()) {
    painter.setPen(theme.accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  }
  const QColor shape = fact_.tone == Tone::kDanger ? QColor(Qt::white) : tone_color(palette(), fact_.tone);
  const QString name = recording && fact_.tone == Tone::kGood ? QStringLiteral("record") : tone_icon(fact_.tone);
  const QColor color = recording && fact_.tone == Tone::kGood ? theme.accent : shape;
  painter.drawPixmap(QPointF(kGrid, (height() - 14) / 2.0), icon_pixmap(name, color, 14, devicePixelRatioF()));
  painter.setPen(fact_.tone == Tone::kDanger    ? QColor(Qt::white)
                 : fact_.tone == Tone::kUnknown ? theme.dim
                                                : theme.text);
  painter.drawText(rect().adjusted(kGrid + 14 + 6, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, fact_.text);
}

void StatusButton::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) {
    Q_EMIT clicked();
  }
}

void StatusButton::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    Q_EMIT clicked();
    return;
  }
  QWidget::keyPressEvent(event);
}

void StatusButton::enterEvent(QEnterEvent*) {
  update();
}

void StatusButton::leaveEvent(QEvent*) {
  update();
}

StatusStrip::StatusStrip(StudioContext& context, QMenu* take_menu, QMenu* main_menu, QWidget* parent)
    : QWidget(parent), context_(context), take_(new QToolButton(this)) {
  setProperty("strip", true);
  setAttribute(Qt::WA_StyledBackground);
  setObjectName(QStringLiteral("status_strip"));
  setFixedHeight(6 * kGrid);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kGrid, 0, kGrid, 0);
  layout->setSpacing(2);

  take_->setMenu(take_menu);
  take_->setPopupMode(QToolButton::InstantPopup);
  take_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  take_->setProperty("flat", true);
  take_->setFocusPolicy(Qt::StrongFocus);
  take_->setIcon(icon(QStringLiteral("folder")));
  take_->setObjectName(QStringLiteral("take_button"));
  take_->setToolTip(tr("The open take: new, open, import, recent"));
  layout->addWidget(take_);
  layout->addStretch();
  for (int i = 0; i < 5; ++i) {
    auto* button = new StatusButton(this);
    facts_.push_back(button);
    layout->addWidget(button);
    connect(button, &StatusButton::clicked, this,
            [this, button] { context_.reveal(button->fact().workspace, button->fact().topic); });
  }
  layout->addSpacing(kGrid);
  right_ = new QHBoxLayout;
  right_->setSpacing(2);
  layout->addLayout(right_);
  auto* menu = icon_button(QStringLiteral("menu"), tr("Menu"), this);
  menu->setMenu(main_menu);
  menu->setPopupMode(QToolButton::InstantPopup);
  menu->setObjectName(QStringLiteral("menu_button"));
  layout->addWidget(menu);

  connect(&context_.live(), &LiveModel::state_changed, this, &StatusStrip::refresh);
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &StatusStrip::refresh);
  connect(&context_.live(), &LiveModel::recording_changed, this, &StatusStrip::refresh);
  connect(&context_.document(), &TakeDocument::changed, this, &StatusStrip::refresh);
  connect(&context_.document(), &TakeDocument::described, this, &StatusStrip::refresh);
  connect(&context_, &StudioContext::animation_changed, this, &StatusStrip::refresh);
  connect(&context_, &StudioContext::disk_changed, this, &StatusStrip::refresh);
  refresh();
}

void StatusStrip::add_action_button(QAction* action) {
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setIconSize(QSize(18, 18));
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  button->setProperty("flat", true);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setAccessibleName(action->text());
  right_->addWidget(button);
}

void StatusStrip::refresh() {
  const LiveModel& live = context_.live();
  const StatusInput input{.state = live.state(),
                          .recording = live.recording(),
                          .finishing = live.finishing(),
                          .aside = live.aside(),
                          .snapshot = live.snapshot().get(),
                          .disk_left_s = context_.disk_left_s(),
                          .latency = live.latency(),
                          .problem = live.problem(),
                          .remedy = live.remedy()};
  const std::vector<StatusFact> facts = status_facts(input);
  for (std::size_t i = 0; i < facts.size() && i < facts_.size(); ++i) {
    facts_[i]->set_fact(facts[i]);
  }
  const QString title = context_.title();
  const QString name = title.isEmpty() ? tr("No take") : title;
  take_->setText(take_->fontMetrics().elidedText(name, Qt::ElideMiddle, 240));
  take_->setAccessibleName(context_.animation().isEmpty() ? tr("Take: %1").arg(name) : tr("Animation: %1").arg(name));
}

}  // namespace limbwave::ui
