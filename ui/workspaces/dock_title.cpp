#include "workspaces/dock_title.h"

#include <QDockWidget>
#include <QHBoxLayout>

#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

DockTitle::DockTitle(QDockWidget* dock)
    : QWidget(dock), dock_(dock), float_(icon_button(QStringLiteral("float"), {}, this)) {
  setObjectName(QStringLiteral("dock_title"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, kGrid / 2, kGrid, 0);
  layout->setSpacing(2);
  auto* name = new ElidedLabel(dock->windowTitle(), this);
  name->setProperty("role", "dim");
  // Whoever drags the name drags the dock.
  name->setAttribute(Qt::WA_TransparentForMouseEvents);
  layout->addWidget(name, 1);
  float_->setObjectName(QStringLiteral("float_") + dock->objectName());
  layout->addWidget(float_);
  auto* close = icon_button(QStringLiteral("close"), tr("Hide %1").arg(dock->windowTitle()), this);
  close->setObjectName(QStringLiteral("close_") + dock->objectName());
  layout->addWidget(close);
  connect(close, &QToolButton::clicked, dock_, &QDockWidget::close);
  connect(float_, &QToolButton::clicked, dock_, [this] { dock_->setFloating(!dock_->isFloating()); });
  connect(dock_, &QDockWidget::topLevelChanged, this, &DockTitle::refresh);
  connect(dock_, &QDockWidget::windowTitleChanged, name, &ElidedLabel::set_text);
  refresh();
}

void DockTitle::refresh() {
  const bool floating = dock_->isFloating();
  const QString words = floating ? tr("Put %1 back into the window").arg(dock_->windowTitle())
                                 : tr("Show %1 in a window of its own").arg(dock_->windowTitle());
  float_->setIcon(icon(floating ? QStringLiteral("dock") : QStringLiteral("float")));
  float_->setToolTip(words);
  float_->setAccessibleName(words);
}

}  // namespace limbwave::ui
