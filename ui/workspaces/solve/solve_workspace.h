/// The Solve workspace: the figure, the curves under it, and what the inspector says about them.
#pragma once

#include <QTimer>
#include <optional>
#include <vector>

#include "viewer/viewer_widget.h"
#include "workspaces/solve/curves_panel.h"
#include "workspaces/solve/solve_model.h"
#include "workspaces/workspace.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace limbwave::ui {

class ElidedLabel;
class EmptyState;

class SolveWorkspace : public Workspace {
  Q_OBJECT
 public:
  explicit SolveWorkspace(StudioContext& context, QWidget* parent = nullptr);

  void activate() override;
  void deactivate() override;
  QWidget* create_inspector() override;
  void reveal(const QString& topic) override;

  [[nodiscard]] ViewerWidget& viewer() { return *viewer_; }
  [[nodiscard]] CurvesPanel& curves() { return *curves_; }
  [[nodiscard]] bool shows_live() const { return live_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* make_toolbar();
  QWidget* make_main_page();
  QWidget* make_failure_bar();
  void follow_context();
  void follow_live();
  void follow_recording();
  void play_first_demo();
  /// What was said of the demo is not true any more.
  void end_demo_hint();
  void set_live(bool live);
  void show_state();
  void show_verdict();
  void show_figure();
  void show_curves();
  void show_skeleton();
  void show_pose();
  void show_live_figure();
  void note_live_frame(double steady_time_s, double tag);
  void show_live_status();
  void show_selection();

  StudioContext& context_;
  SolveModel& model_;
  QStackedWidget* pages_ = nullptr;
  EmptyState* empty_ = nullptr;
  QWidget* main_page_ = nullptr;
  QPushButton* empty_button_ = nullptr;
  ViewerWidget* viewer_ = nullptr;
  CurvesPanel* curves_ = nullptr;
  QLabel* verdict_ = nullptr;  ///< The tone of what `status_` says.
  ElidedLabel* status_ = nullptr;
  QPushButton* live_button_ = nullptr;
  QWidget* failure_bar_ = nullptr;  ///< Seen when solving again has failed.
  QLabel *failure_ = nullptr, *failure_icon_ = nullptr;
  QPushButton *retry_ = nullptr, *calibrate_ = nullptr;
  QToolButton* ghost_ = nullptr;
  QTimer live_timer_;
  struct ShownFigure {
    std::uint64_t number = 0;
    solve::PoseTimes times;
  };
  static constexpr std::size_t kFiguresUnderWay = 8;  // more are never on their way to the screen
  std::vector<ShownFigure> shown_figures_;            // newest last
  bool live_ = false, active_ = false;
  int demo_hint_ = 0;
  /// What the user asked for with the Live button, until another take or recording begins.
  std::optional<bool> wish_;
  bool recorded_ = false;  ///< A take is being recorded.
  bool framed_live_ = false, framed_take_ = false;
  std::vector<body::SegmentPose> poses_;
};

}  // namespace limbwave::ui
