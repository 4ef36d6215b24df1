#include "workspaces/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <vector>

#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

MessageBar::MessageBar(Notifications& notifications, QWidget* parent)
    : QWidget(parent),
      notifications_(notifications),
      icon_(new QLabel(this)),
      text_(new QLabel(this)),
      more_(new QPushButton(this)),
      action_(new QPushButton(this)),
      close_(icon_button(QStringLiteral("close"), tr("Dismiss"), this)) {
  setProperty("strip", true);
  setAttribute(Qt::WA_StyledBackground);
  setObjectName(QStringLiteral("message_bar"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid / 2, kGrid, kGrid / 2);
  layout->setSpacing(kGrid);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  more_->setProperty("flat", true);
  more_->setObjectName(QStringLiteral("more_messages"));
  more_->setToolTip(tr("Show the next message"));
  layout->addWidget(icon_);
  layout->addWidget(text_, 1);
  layout->addWidget(more_);
  layout->addWidget(action_);
  layout->addWidget(close_);
  connect(&notifications_, &Notifications::changed, this, [this] {
    turn_ = 0;
    refresh();
  });
  connect(more_, &QPushButton::clicked, this, [this] {
    ++turn_;
    refresh();
  });
  connect(close_, &QToolButton::clicked, this, [this] { notifications_.dismiss(shown_); });
  connect(action_, &QPushButton::clicked, this, [this] {
    const auto& all = notifications_.all();
    const auto found = std::find_if(all.begin(), all.end(), [this](const Notification& n) { return n.id == shown_; });
    if (found != all.end()) {
      const auto act = found->act;  // gone with the notification otherwise
      notifications_.dismiss(shown_);
      if (act) {
        act();
      }
    }
  });
  refresh();
}

QString MessageBar::text() const {
  return text_->text();
}

void MessageBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    refresh();
  }
}

void MessageBar::refresh() {
  const auto& all = notifications_.all();
  setVisible(!all.empty());
  if (all.empty()) {
    return;
  }
  // A later piece of news does not hide an error that nobody has dismissed.
  std::vector<const Notification*> order;
  order.reserve(all.size());
  for (const Notification& notification : all) {
    order.push_back(&notification);
  }
  std::stable_sort(order.begin(), order.end(), [](const Notification* a, const Notification* b) {
    return (a->severity == Severity::kError) > (b->severity == Severity::kError);
  });
  const Notification& first = *order[turn_ % order.size()];
  shown_ = first.id;
  const bool error = first.severity == Severity::kError;
  const bool warning = first.severity == Severity::kWarning;
  const ThemeColors& theme = theme_colors(palette());
  const QString name = error ? QStringLiteral("bad") : warning ? QStringLiteral("warning") : QStringLiteral("info");
  icon_->setPixmap(icon_pixmap(name,
                               error     ? theme.danger
                               : warning ? theme.warning
                                         : theme.accent,
                               18, devicePixelRatioF()));
  text_->setText(first.remedy.isEmpty() ? first.text : first.text + QLatin1Char(' ') + first.remedy);
  text_->setAccessibleName(text_->text());
  more_->setVisible(all.size() > 1);
  more_->setText(tr("%1 more").arg(all.size() - 1));
  action_->setVisible(!first.action.isEmpty());
  action_->setText(first.action);
}

}  // namespace limbwave::ui
