#include "workspaces/shortcut_sheet.h"

#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <algorithm>
#include <array>

#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

std::vector<ShortcutGroup> shortcut_groups(const StudioParts& parts) {
  ShortcutGroup everywhere{
      ShortcutSheet::tr("Everywhere"),
      {{QStringLiteral("1 – %1").arg(parts.workspaces.size()), ShortcutSheet::tr("Go to a workspace")},
       {QStringLiteral("Ctrl+N"), ShortcutSheet::tr("New take")},
       {QStringLiteral("Ctrl+O"), ShortcutSheet::tr("Open a take")},
       {QStringLiteral("Ctrl+I"), ShortcutSheet::tr("Import recordings")},
       {QStringLiteral("Ctrl+W"), ShortcutSheet::tr("Close the take")},
       {QStringLiteral("Ctrl+Z"), ShortcutSheet::tr("Undo")},
       {QStringLiteral("Ctrl+Shift+Z / Ctrl+Y"), ShortcutSheet::tr("Redo")},
       {QStringLiteral("F3 / F4"), ShortcutSheet::tr("Show or hide the inspector, the timeline")},
       {QStringLiteral("F11"), ShortcutSheet::tr("Full screen")},
       {QStringLiteral("? / Shift+? / F1"), ShortcutSheet::tr("This sheet")},
       {QStringLiteral("Ctrl+Q"), ShortcutSheet::tr("Quit")}}};
  for (const StudioAction& action : parts.actions) {
    everywhere.shortcuts.push_back({action.keys.toString(QKeySequence::NativeText), action.what});
  }
  std::vector<ShortcutGroup> groups{std::move(everywhere)};
  for (const WorkspaceEntry& entry : parts.workspaces) {
    if (!entry.shortcuts.empty()) {
      groups.push_back({entry.title, entry.shortcuts});
    }
  }
  if (!parts.timeline_shortcuts.empty()) {
    groups.push_back({ShortcutSheet::tr("Timeline"), parts.timeline_shortcuts});
  }
  return groups;
}

ShortcutSheet::ShortcutSheet(const std::vector<ShortcutGroup>& groups, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Keyboard shortcuts"));
  setObjectName(QStringLiteral("shortcut_sheet"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  layout->addWidget(scroll);
  auto* page = new QWidget(scroll);
  page->setProperty("scroll", true);
  scroll->setWidget(page);
  // Two columns of groups, filled evenly.
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(4 * kGrid, 3 * kGrid, 4 * kGrid, 3 * kGrid);
  columns->setSpacing(6 * kGrid);
  std::array<QVBoxLayout*, 2> column{new QVBoxLayout, new QVBoxLayout};
  std::array<std::size_t, 2> rows{0, 0};
  for (QVBoxLayout* one : column) {
    one->setSpacing(3 * kGrid);
    columns->addLayout(one);
  }
  for (const ShortcutGroup& group : groups) {
    const std::size_t into = rows[1] < rows[0] ? 1 : 0;
    rows.at(into) += group.shortcuts.size() + 2;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * kGrid);
    grid->setVerticalSpacing(kGrid);
    grid->setColumnStretch(1, 1);
    grid->addWidget(heading_label(group.title, page), 0, 0, 1, 2);
    int row = 1;
    for (const ShortcutHelp& shortcut : group.shortcuts) {
      auto* keys = new QLabel(shortcut.keys, page);
      keys->setMinimumWidth(12 * kGrid);
      keys->setFont(tabular(keys->font(), 1.0, QFont::DemiBold));
      grid->addWidget(keys, row, 0, Qt::AlignTop);
      grid->addWidget(new QLabel(shortcut.what, page), row, 1);
      ++row;
    }
    column.at(into)->addLayout(grid);
  }
  for (QVBoxLayout* one : column) {
    one->addStretch();
  }
  // As large as its content, where the screen has the room.
  const QSize wanted = page->sizeHint() + QSize(2, 2);
  const QSize room = QGuiApplication::primaryScreen()->availableSize() * 0.95;
  resize(std::min(wanted.width(), room.width()), std::min(wanted.height(), room.height()));
}

}  // namespace limbwave::ui
