/// The studio's one window: status strip, mode bar, the workspace, inspector and timeline. Knows workspaces from the
/// table only.
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <vector>

#include "workspaces/workspace.h"

class QAction;
class QActionGroup;
class QDockWidget;
class QMenu;
class QStackedWidget;

namespace limbwave::ui {

class ManualWindow;
class ModeBar;
class StatusStrip;
class TakeActions;
class WelcomePage;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// `context` outlives the window.
  MainWindow(StudioContext& context, StudioParts parts, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Shows a workspace by its id, "welcome" for the first page. False when there is none of that name.
  bool show_workspace(const QString& id);
  [[nodiscard]] QString current_workspace() const;
  /// The workspace if it has been shown before, else null.
  [[nodiscard]] Workspace* workspace(const QString& id) const;
  [[nodiscard]] TakeActions& take_actions() { return *take_actions_; }
  void show_shortcuts();
  /// At a chapter: "levels".
  void show_manual(const QString& chapter);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Asks when quitting would end something that cannot be done again.
  bool may_quit();
  void show_docks();
  void make_actions();
  void make_docks();
  void follow_context();
  void show_index(int index);
  void update_title();
  void update_recent_menu();
  [[nodiscard]] int index_of(const QString& id) const;

  StudioContext& context_;
  StudioParts parts_;
  TakeActions* take_actions_;
  QMenu* take_menu_;
  QMenu* recent_menu_;
  QMenu* main_menu_;
  QAction *show_inspector_ = nullptr, *show_timeline_ = nullptr;  ///< What the user wants to see where it exists.
  StatusStrip* strip_ = nullptr;
  ModeBar* modes_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  WelcomePage* welcome_ = nullptr;
  QPointer<ManualWindow> manual_;
  std::vector<Workspace*> workspaces_;  ///< By index of the table; null until shown.
  std::vector<QWidget*> inspectors_;    ///< The same.
  QDockWidget* inspector_dock_ = nullptr;
  QDockWidget* timeline_dock_ = nullptr;
  QStackedWidget* inspector_pages_ = nullptr;
  int current_ = -1;  ///< −1: the welcome page.
};

}  // namespace limbwave::ui
