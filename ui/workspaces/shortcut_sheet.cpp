#include "workspaces/shortcut_sheet.h"

#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <array>

#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

namespace {

constexpr int kWidestLine = 33 * kGrid;  // What is longer is wrapped where there is no more room.

// Names of keys, for languages that Qt brings no words for.
[[maybe_unused]] constexpr std::array kKeyNames{
    QT_TRANSLATE_NOOP("QShortcut", "Ctrl"), QT_TRANSLATE_NOOP("QShortcut", "Shift"),
    QT_TRANSLATE_NOOP("QShortcut", "Alt"), QT_TRANSLATE_NOOP("QShortcut", "Del"),
    QT_TRANSLATE_NOOP("QShortcut", "Ins")};

// As the keyboard has them: "Strg+N".
QString native(const char* keys) {
  QStringList each;
  for (const QString& one : QString::fromLatin1(keys).split(QStringLiteral(" / "))) {
    each << QKeySequence(one).toString(QKeySequence::NativeText);
  }
  return each.join(QStringLiteral(" / "));
}

}  // namespace

std::vector<ShortcutGroup> shortcut_groups(const StudioParts& parts) {
  ShortcutGroup everywhere{
      ShortcutSheet::tr("Everywhere"),
      {{QStringLiteral("1 – %1").arg(parts.workspaces.size()), ShortcutSheet::tr("Go to a workspace")},
       {native("Ctrl+N"), ShortcutSheet::tr("New take")},
       {native("Ctrl+O"), ShortcutSheet::tr("Open a take")},
       {native("Ctrl+Shift+O"), ShortcutSheet::tr("Open an animation")},
       {native("Ctrl+I"), ShortcutSheet::tr("Import recordings")},
       {native("Ctrl+W"), ShortcutSheet::tr("Close the take or the animation")},
       {native("Ctrl+Z"), ShortcutSheet::tr("Undo")},
       {native("Ctrl+Shift+Z / Ctrl+Y"), ShortcutSheet::tr("Redo")},
       {native("F3 / F4"), ShortcutSheet::tr("Show or hide the inspector, the timeline")},
       {native("F11"), ShortcutSheet::tr("Full screen")},
       {native("F1"), ShortcutSheet::tr("The manual")},
       {native("? / Shift+?"), ShortcutSheet::tr("All keyboard shortcuts")},
       {native("Ctrl+Q"), ShortcutSheet::tr("Quit")}}};
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
    grid->setColumnMinimumWidth(0, 12 * kGrid);
    grid->addWidget(heading_label(group.title, page), 0, 0, 1, 2);
    int row = 1;
    for (const ShortcutHelp& shortcut : group.shortcuts) {
      auto* keys = new QLabel(shortcut.keys, page);
      keys->setFont(tabular(keys->font(), 1.0, QFont::DemiBold));
      grid->addWidget(keys, row, 0, Qt::AlignTop);
      auto* what = new QLabel(shortcut.what, page);
      what->setWordWrap(true);
      what->setMinimumWidth(std::min(what->fontMetrics().horizontalAdvance(shortcut.what) + 2, kWidestLine));
      grid->addWidget(what, row, 1);
      ++row;
    }
    column.at(into)->addLayout(grid);
  }
  for (QVBoxLayout* one : column) {
    one->addStretch();
  }
  // As large as its content, where the screen has the room.
  const QSize wanted = page->sizeHint() + QSize(scroll->verticalScrollBar()->sizeHint().width() + 2, 2);
  const QSize room = QGuiApplication::primaryScreen()->availableSize() * 0.95;
  resize(std::min(wanted.width(), room.width()), std::min(wanted.height(), room.height()));
}

}  // namespace limbwave::ui
