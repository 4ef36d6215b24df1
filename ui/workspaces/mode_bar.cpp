#include "workspaces/mode_bar.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {
namespace {

QToolButton* mode_button(const QString& icon_name, const QString& title, const QString& hint, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(icon_name));
  button->setIconSize(QSize(24, 24));
  button->setText(title);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setToolTip(hint);
  button->setAccessibleName(title);
  button->setAccessibleDescription(hint);
  button->setProperty("mode", true);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return button;
}

}  // namespace

ModeBar::ModeBar(const std::vector<WorkspaceEntry>& entries, QWidget* parent)
    : QToolBar(parent), group_(new QButtonGroup(this)) {
  setObjectName(QStringLiteral("mode_bar"));
  setWindowTitle(tr("Workspaces"));
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  layout()->setContentsMargins(0, 0, 0, 0);
  layout()->setSpacing(0);
  auto* column = new QWidget(this);
  column->setProperty("strip", true);
  column->setAttribute(Qt::WA_StyledBackground);
  column->setMinimumWidth(10 * kGrid);
  column->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, kGrid);
  layout->setSpacing(0);
  int index = 0;
  for (const WorkspaceEntry& entry : entries) {
    QToolButton* button =
        mode_button(entry.icon, entry.title, QStringLiteral("%1 (%2)").arg(entry.hint).arg(index + 1), column);
    button->setObjectName(QStringLiteral("mode_%1").arg(entry.id));
    group_->addButton(button, index++);
    layout->addWidget(button);
  }
  layout->addStretch();
  QToolButton* start =
      mode_button(QStringLiteral("home"), tr("Start"), tr("The welcome page: demo takes, recent takes"), column);
  start->setObjectName(QStringLiteral("mode_welcome"));
  group_->addButton(start, static_cast<int>(entries.size()));
  layout->addWidget(start);
  addWidget(column);
  const int home_id = static_cast<int>(entries.size());
  connect(group_, &QButtonGroup::idClicked, this, [this, home_id](int id) {
    if (id == home_id) {
      Q_EMIT home();
    } else {
      Q_EMIT chosen(id);
    }
  });
}

void ModeBar::set_current(int index) {
  const auto buttons = group_->buttons();
  const int id = index < 0 ? static_cast<int>(buttons.size()) - 1 : index;
  if (QAbstractButton* button = group_->button(id)) {
    button->setChecked(true);
  }
}

}  // namespace limbwave::ui
