#include "workspaces/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "common/icons.h"
#include "common/theme.h"
#include "workspaces/button_keys.h"
#include "workspaces/dock_title.h"
#include "workspaces/inspector_pages.h"
#include "workspaces/job_bar.h"
#include "workspaces/layout_store.h"
#include "workspaces/manual_window.h"
#include "workspaces/message_bar.h"
#include "workspaces/mode_bar.h"
#include "workspaces/shortcut_sheet.h"
#include "workspaces/status_strip.h"
#include "workspaces/take_actions.h"
#include "workspaces/undo_keys.h"
#include "workspaces/welcome_page.h"

namespace limbwave::ui {

MainWindow::MainWindow(StudioContext& context, StudioParts parts, QWidget* parent)
    : QMainWindow(parent),
      context_(context),
      parts_(std::move(parts)),
      take_actions_(new TakeActions(context, this)),
      take_menu_(new QMenu(this)),
      recent_menu_(new QMenu(tr("Recent takes"), this)),
      main_menu_(new QMenu(this)) {
  setObjectName(QStringLiteral("main_window"));
  setAcceptDrops(true);
  setDockNestingEnabled(false);
  workspaces_.resize(parts_.workspaces.size(), nullptr);
  inspectors_.resize(parts_.workspaces.size(), nullptr);

  strip_ = new StatusStrip(context_, take_menu_, main_menu_, this);
  setMenuWidget(strip_);
  modes_ = new ModeBar(parts_.workspaces, this);
  addToolBar(Qt::LeftToolBarArea, modes_);
  connect(modes_, &ModeBar::chosen, this, &MainWindow::show_index);
  connect(modes_, &ModeBar::home, this, [this] { show_index(-1); });

  auto* center = new QWidget(this);
  auto* layout = new QVBoxLayout(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(new MessageBar(context_.notifications(), center));
  pages_ = new QStackedWidget(center);
  layout->addWidget(pages_, 1);
  layout->addWidget(new JobBar(context_.jobs(), center));
  setCentralWidget(center);
  welcome_ = new WelcomePage(context_, *take_actions_, pages_);
  pages_->addWidget(welcome_);

  make_docks();
  make_actions();
  follow_context();
  qApp->installEventFilter(new UndoKeys(this));
  qApp->installEventFilter(new ButtonKeys(this));
  resize(QSize(1440, 900).boundedTo(screen()->availableSize() * 0.95));
  setMinimumSize(QSize(960, 600).boundedTo(screen()->availableSize()));
  restore_layout(*this, context_.settings());
  update_title();
  show_index(-1);
  show_docks();  // What was stored may be of another page.
}

MainWindow::~MainWindow() = default;

void MainWindow::make_docks() {
  inspector_dock_ = new QDockWidget(tr("Inspector"), this);
  inspector_dock_->setObjectName(QStringLiteral("inspector"));
  inspector_pages_ = new InspectorPages(inspector_dock_);
  inspector_dock_->setWidget(inspector_pages_);
  inspector_dock_->setTitleBarWidget(new DockTitle(inspector_dock_));
  addDockWidget(Qt::RightDockWidgetArea, inspector_dock_);
  inspector_dock_->hide();
  inspector_dock_->installEventFilter(this);
  if (parts_.timeline) {
    timeline_dock_ = new QDockWidget(tr("Timeline"), this);
    timeline_dock_->setObjectName(QStringLiteral("timeline"));
    timeline_dock_->setWidget(parts_.timeline(context_, timeline_dock_));
    timeline_dock_->setTitleBarWidget(new DockTitle(timeline_dock_));
    addDockWidget(Qt::BottomDockWidgetArea, timeline_dock_);
    timeline_dock_->hide();
    timeline_dock_->installEventFilter(this);
  }
}

void MainWindow::make_actions() {
  const auto add = [this](QMenu* menu, const QString& icon_name, const QString& text, const QKeySequence& keys,
                          auto&& handler) {
    auto* action = new QAction(text, this);
    if (!icon_name.isEmpty()) {
      action->setIcon(icon(icon_name));
    }
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, handler);
    addAction(action);
    if (menu != nullptr) {
      menu->addAction(action);
    }
    return action;
  };
  add(take_menu_, QStringLiteral("plus"), tr("New take"), QKeySequence::New, [this] { take_actions_->new_take(); });
  add(take_menu_, QStringLiteral("folder"), tr("Open take…"), QKeySequence::Open,
      [this] { take_actions_->choose_and_open(); });
  add(take_menu_, QStringLiteral("export"), tr("Open animation…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
      [this] { take_actions_->choose_and_open_animation(); });
  add(take_menu_, QStringLiteral("import"), tr("Import recording…"), QKeySequence(Qt::CTRL | Qt::Key_I),
      [this] { take_actions_->choose_and_import(); });
  take_menu_->addMenu(recent_menu_);
  take_menu_->addSeparator();
  QAction* details = add(take_menu_, QStringLiteral("rename"), tr("Details of the take…"), QKeySequence(),
                         [this] { take_actions_->edit_details(); });
  details->setObjectName(QStringLiteral("take_details"));
  connect(take_menu_, &QMenu::aboutToShow, details,
          [this, details] { details->setEnabled(context_.document().is_open()); });
  add(take_menu_, {}, tr("Close"), QKeySequence::Close, [this] { take_actions_->close(); });

  QAction* undo = context_.undo_stack().createUndoAction(this, tr("Undo"));
  undo->setIcon(icon(QStringLiteral("undo")));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = context_.undo_stack().createRedoAction(this, tr("Redo"));
  redo->setIcon(icon(QStringLiteral("redo")));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  addActions({undo, redo});
  strip_->add_action_button(undo);
  strip_->add_action_button(redo);
  main_menu_->addActions({undo, redo});
  main_menu_->addSeparator();

  QAction* dark = add(main_menu_, QStringLiteral("theme"), tr("Light colours"), QKeySequence(), [this](bool light) {
    apply_theme(*qApp, light ? ThemeKind::kLight : ThemeKind::kDark);
    context_.settings().setValue(QStringLiteral("theme"), light ? QStringLiteral("light") : QStringLiteral("dark"));
  });
  dark->setCheckable(true);
  dark->setChecked(!theme_colors(palette()).dark);
  QAction* full = add(main_menu_, {}, tr("Full screen"), QKeySequence(Qt::Key_F11), [this](bool on) {
    setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
  });
  full->setCheckable(true);
  QMenu* view = main_menu_->addMenu(tr("Panels"));
  const auto panel = [&](const QString& text, const QKeySequence& keys, const QString& setting) {
    QAction* action = add(view, {}, text, keys, [] {});
    action->setCheckable(true);
    action->setChecked(context_.settings().value(setting, true).toBool());
    connect(action, &QAction::toggled, this, [this, setting](bool on) {
      context_.settings().setValue(setting, on);
      show_docks();
    });
    return action;
  };
  show_inspector_ = panel(tr("Inspector"), QKeySequence(Qt::Key_F3), QStringLiteral("window/inspector"));
  show_timeline_ = panel(tr("Timeline"), QKeySequence(Qt::Key_F4), QStringLiteral("window/timeline"));
  main_menu_->addSeparator();
  QAction* help =
      add(main_menu_, QStringLiteral("help"), tr("Keyboard shortcuts"), QKeySequence(), [this] { show_shortcuts(); });
  help->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(Qt::SHIFT | Qt::Key_Question)});
  strip_->add_action_button(help);
  add(main_menu_, QStringLiteral("info"), tr("Manual"), QKeySequence(Qt::Key_F1), [this] {
    // Where one is, is what one wants to read about.
    const QString here = current_workspace();
    show_manual(here == QLatin1String("capture")     ? QStringLiteral("levels")
                : here == QLatin1String("calibrate") ? QStringLiteral("range")
                : here == QLatin1String("welcome")   ? QStringLiteral("overview")
                                                     : QStringLiteral("exporting"));
  });
  main_menu_->addSeparator();
  add(main_menu_, {}, tr("Quit"), QKeySequence::Quit, [this] { close(); });

  for (int i = 0; i < static_cast<int>(parts_.workspaces.size()); ++i) {
    add(nullptr, {}, parts_.workspaces[static_cast<std::size_t>(i)].title, QKeySequence(Qt::Key_1 + i),
        [this, i] { show_index(i); });
  }
  for (std::size_t i = 0; i < parts_.actions.size(); ++i) {
    const StudioAction& action = parts_.actions[i];
    add(nullptr, {}, action.what, action.keys, [this, i] {
      parts_.actions[i].run(context_, current_ >= 0 ? &parts_.workspaces[static_cast<std::size_t>(current_)] : nullptr);
    })->setAutoRepeat(false);
  }
  connect(take_menu_, &QMenu::aboutToShow, this, &MainWindow::update_recent_menu);
  update_recent_menu();
}

void MainWindow::follow_context() {
  connect(&context_, &StudioContext::reveal_requested, this, [this](const QString& id, const QString& topic) {
    if (id == QLatin1String("manual")) {
      show_manual(topic);
      return;
    }
    // Where a workspace does not exist, Capture shows the trouble itself.
    const bool shown = show_workspace(id) || show_workspace(QStringLiteral("capture"));
    if (shown && current_ >= 0 && !topic.isEmpty()) {
      workspaces_[static_cast<std::size_t>(current_)]->reveal(topic);
    }
  });
  connect(&context_.document(), &TakeDocument::changed, this, [this](bool other) {
    update_title();
    // From the first page one goes on to what can be done with the take.
    if (other && context_.document().is_open() && current_ < 0 && !show_workspace(QStringLiteral("solve"))) {
      show_workspace(QStringLiteral("capture"));
    }
  });
  connect(&context_.live(), &LiveModel::recording_changed, this, &MainWindow::update_title);
  connect(&context_.document(), &TakeDocument::described, this, &MainWindow::update_title);
  connect(&context_, &StudioContext::animation_changed, this, &MainWindow::update_title);
}

void MainWindow::show_docks() {
  const auto at = static_cast<std::size_t>(std::max(0, current_));
  const bool page = current_ >= 0;
  inspector_dock_->setVisible(page && inspectors_[at] != nullptr && show_inspector_->isChecked());
  show_inspector_->setEnabled(page && inspectors_[at] != nullptr);
  if (timeline_dock_ != nullptr) {
    const bool timeline = page && parts_.workspaces[at].timeline;
    timeline_dock_->setVisible(timeline && show_timeline_->isChecked());
    show_timeline_->setEnabled(timeline);
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  // The cross of a dock is a wish that outlives the workspace.
  if (event->type() == QEvent::Close && (watched == inspector_dock_ || watched == timeline_dock_)) {
    (watched == inspector_dock_ ? show_inspector_ : show_timeline_)->setChecked(false);
  }
  return QMainWindow::eventFilter(watched, event);
}

int MainWindow::index_of(const QString& id) const {
  for (std::size_t i = 0; i < parts_.workspaces.size(); ++i) {
    if (parts_.workspaces[i].id == id) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

bool MainWindow::show_workspace(const QString& id) {
  const int index = index_of(id);
  if (index < 0 && id != QLatin1String("welcome")) {
    return false;
  }
  show_index(index);
  return true;
}

QString MainWindow::current_workspace() const {
  return current_ < 0 ? QStringLiteral("welcome") : parts_.workspaces[static_cast<std::size_t>(current_)].id;
}

Workspace* MainWindow::workspace(const QString& id) const {
  const int index = index_of(id);
  return index < 0 ? nullptr : workspaces_[static_cast<std::size_t>(index)];
}

void MainWindow::show_index(int index) {
  modes_->set_current(index);
  if (index == current_ && (index >= 0 || pages_->currentWidget() == welcome_)) {
    return;
  }
  if (current_ >= 0) {
    workspaces_[static_cast<std::size_t>(current_)]->deactivate();
  }
  current_ = index;
  if (index < 0) {
    pages_->setCurrentWidget(welcome_);
    welcome_->setFocus();
    show_docks();
    return;
  }
  const auto at = static_cast<std::size_t>(index);
  const WorkspaceEntry& entry = parts_.workspaces[at];
  if (workspaces_[at] == nullptr) {
    workspaces_[at] = entry.create(context_, pages_);
    pages_->addWidget(workspaces_[at]);
    restore_splitters(*workspaces_[at], context_.settings());
    inspectors_[at] = workspaces_[at]->create_inspector();
    if (inspectors_[at] != nullptr) {
      inspector_pages_->addWidget(inspectors_[at]);
    }
  }
  pages_->setCurrentWidget(workspaces_[at]);
  if (inspectors_[at] != nullptr) {
    inspector_pages_->setCurrentWidget(inspectors_[at]);
  }
  show_docks();
  workspaces_[at]->activate();
}

void MainWindow::update_title() {
  const QString name = context_.title();
  const QString program = QStringLiteral("Limbwave");
  QString title = name.isEmpty() ? program : tr("%1 – %2").arg(name, program);
  if (context_.live().recording() && !context_.live().aside()) {
    title = tr("● Recording – %1").arg(program);
  }
  setWindowTitle(title);
}

void MainWindow::update_recent_menu() {
  recent_menu_->clear();
  const QStringList folders = context_.recent_takes().folders();
  for (const QString& folder : folders) {
    QString name = QFileInfo(folder).completeBaseName();
    QAction* action = recent_menu_->addAction(recent_menu_->fontMetrics().elidedText(
        name.replace(QLatin1Char('&'), QLatin1String("&&")), Qt::ElideMiddle, 320));
    action->setToolTip(folder);
    connect(action, &QAction::triggered, this, [this, folder] { take_actions_->open(folder); });
  }
  recent_menu_->setEnabled(!folders.isEmpty());
}

void MainWindow::show_shortcuts() {
  auto* sheet = new ShortcutSheet(shortcut_groups(parts_), this);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->open();
}

void MainWindow::show_manual(const QString& chapter) {
  if (!manual_) {
    manual_ = new ManualWindow(shortcut_groups(parts_), this);
    manual_->setAttribute(Qt::WA_DeleteOnClose);
  }
  manual_->show_chapter(chapter);
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
}

bool MainWindow::may_quit() {
  QString what, stop;
  if (context_.live().recording() || context_.live().starting()) {
    const bool aside = context_.live().aside();
    what = aside ? tr("A calibration is under way. What is not saved is lost.")
                 : tr("A take is being recorded. What is recorded until now is kept.");
    stop = aside ? tr("Leave it and quit") : tr("Stop recording and quit");
  } else {
    for (const Job* job : context_.jobs().jobs()) {
      if (job->elapsed_s() > 1.0) {
        what = tr("“%1” is still going on and would be cancelled.").arg(job->title());
        stop = tr("Cancel it and quit");
      }
    }
  }
  if (what.isEmpty()) {
    return true;
  }
  QMessageBox box(QMessageBox::Question, QStringLiteral("Limbwave"), what, QMessageBox::NoButton, this);
  box.setObjectName(QStringLiteral("quit_question"));
  QAbstractButton* quit = box.addButton(stop, QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(tr("Go on"), QMessageBox::RejectRole));
  box.exec();
  return box.clickedButton() == quit;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_quit()) {
    event->ignore();
    return;
  }
  // A recording is closed properly by the session's destructor.
  if (context_.live().recording() && !context_.live().aside() && context_.live().snapshot()) {
    context_.recent_takes().add(QString::fromStdString(context_.live().snapshot()->take_folder.string()));
  }
  save_layout(*this, context_.settings());
  save_splitters(*this, context_.settings());
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && TakeActions::acceptable(event->mimeData()->urls())) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  // Never a move: the file manager would delete what was dropped.
  event->setDropAction(Qt::CopyAction);
  event->accept();
  take_actions_->handle_drop(event->mimeData()->urls());
}

}  // namespace limbwave::ui
