#include "common/widgets.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QVariant>

#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

ElidedLabel::ElidedLabel(const QString& text, QWidget* parent) : QLabel(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  set_text(text);
}

void ElidedLabel::set_text(const QString& text) {
  full_ = text;
  setAccessibleName(text);
  setToolTip(text);
  updateGeometry();
  update();
}

QSize ElidedLabel::minimumSizeHint() const {
  return {fontMetrics().horizontalAdvance(QStringLiteral("…")) + 8, fontMetrics().height() + 2};
}

QSize ElidedLabel::sizeHint() const {
  return {fontMetrics().horizontalAdvance(full_) + 2, fontMetrics().height() + 2};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const bool dim = property("role").toString() == QLatin1String("dim");
  painter.setPen(dim ? theme_colors(palette()).dim : palette().color(foregroundRole()));
  painter.setFont(font());
  const QRect area = contentsRect();
  painter.drawText(area, static_cast<int>(alignment()) | Qt::TextSingleLine,
                   fontMetrics().elidedText(full_, Qt::ElideRight, area.width()));
}

Card::Card(const QString& heading, QWidget* parent) : QFrame(parent) {
  setProperty("card", true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid + 4, 2 * kGrid, 2 * kGrid);
  layout->setSpacing(kGrid);
  heading_ = heading_label(heading, this);
  heading_->setVisible(!heading.isEmpty());
  layout->addWidget(heading_);
  body_ = new QVBoxLayout;
  body_->setSpacing(kGrid);
  layout->addLayout(body_, 1);
}

void Card::set_heading(const QString& heading) {
  heading_->setText(heading);
  heading_->setVisible(!heading.isEmpty());
}

EmptyState::EmptyState(const QString& icon_name, QWidget* parent)
    : QWidget(parent),
      icon_name_(icon_name),
      icon_(new QLabel(this)),
      title_(new QLabel(this)),
      remedy_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(2 * kGrid);
  layout->addStretch(2);
  icon_->setAlignment(Qt::AlignCenter);
  layout->addWidget(icon_);
  QFont font = title_->font();
  font.setPixelSize(20);
  title_->setFont(font);
  title_->setAlignment(Qt::AlignCenter);
  title_->setWordWrap(true);
  layout->addWidget(title_);
  remedy_->setAlignment(Qt::AlignCenter);
  remedy_->setWordWrap(true);
  remedy_->setMaximumWidth(560);
  remedy_->setProperty("role", "dim");
  auto* remedy_row = new QHBoxLayout;
  remedy_row->addStretch(1);
  remedy_row->addWidget(remedy_, 4);
  remedy_row->addStretch(1);
  layout->addLayout(remedy_row);
  buttons_ = new QHBoxLayout;
  buttons_->setSpacing(kGrid);
  buttons_->addStretch();
  buttons_->addStretch();
  layout->addLayout(buttons_);
  links_ = new QVBoxLayout;
  layout->addLayout(links_);
  layout->addStretch(3);
  update_icon();
}

void EmptyState::set_texts(const QString& title, const QString& remedy) {
  title_->setText(title);
  remedy_->setText(remedy);
  setAccessibleName(title);
  setAccessibleDescription(remedy);
}

QPushButton* EmptyState::add_button(const QString& text, bool primary) {
  auto* button = new QPushButton(text, this);
  button->setProperty("primary", primary);
  buttons_->insertWidget(buttons_->count() - 1, button);
  return button;
}

QLabel* EmptyState::add_link(const QString& text) {
  QLabel* link = link_label(text, this);
  links_->addWidget(link, 0, Qt::AlignCenter);
  return link;
}

void EmptyState::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    update_icon();
  }
}

void EmptyState::update_icon() {
  icon_->setPixmap(icon_pixmap(icon_name_, theme_colors(palette()).dim, 48, devicePixelRatioF()));
}

QString tone_icon(Tone tone) {
  switch (tone) {
    case Tone::kGood:
      return QStringLiteral("good");
    case Tone::kWarning:
      return QStringLiteral("warning");
    case Tone::kDanger:
      return QStringLiteral("bad");
    case Tone::kUnknown:
      break;
  }
  return QStringLiteral("unknown");
}

QColor tone_color(const QPalette& palette, Tone tone) {
  const ThemeColors& theme = theme_colors(palette);
  switch (tone) {
    case Tone::kGood:
      return theme.good;
    case Tone::kWarning:
      return theme.warning;
    case Tone::kDanger:
      return theme.danger;
    case Tone::kUnknown:
      break;
  }
  return theme.dim;
}

QLabel* dim_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "dim");
  return label;
}

QLabel* heading_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "heading");
  return label;
}

QLabel* link_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(QStringLiteral("<a href=\"#\">%1</a>").arg(text.toHtmlEscaped()), parent);
  label->setAccessibleName(text);
  label->setFocusPolicy(Qt::StrongFocus);
  label->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  return label;
}

QToolButton* icon_button(const QString& icon_name, const QString& text, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(icon_name));
  button->setIconSize(QSize(18, 18));
  button->setToolTip(text);
  button->setAccessibleName(text);
  button->setProperty("flat", true);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void set_style_property(QWidget* widget, const char* name, const QVariant& value) {
  if (widget->property(name) != value) {
    widget->setProperty(name, value);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
    widget->update();
  }
}

}  // namespace limbwave::ui
