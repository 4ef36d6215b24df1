/// What an export is going to write: the figure frame by frame as the file will have it, its facts and its joints.
#pragma once

#include <QWidget>
#include <optional>

#include "workspaces/export/export_plan.h"
#include "workspaces/solve/solve_model.h"

class QFormLayout;
class QLabel;
class QTreeWidget;
class QVBoxLayout;

namespace limbwave::ui {

class ViewerWidget;

class ExportPreview : public QWidget {
  Q_OBJECT
 public:
  ExportPreview(StudioContext& context, SolveModel& model, QWidget* parent = nullptr);

  /// `open`: the plan is for the solve that is open, with its edits; others are not loaded just to be shown.
  void set_plan(const ExportPlan& plan, bool open);
  /// Pictures cost: they are made from the first time that somebody looks.
  void set_active(bool active);

  /// Null until somebody has looked.
  [[nodiscard]] ViewerWidget* viewer() const { return viewer_; }
  /// The frame of the file under the playhead, from 0.
  [[nodiscard]] std::size_t frame() const { return frame_; }

 private:
  QLabel* add_fact(QFormLayout* form, const QString& name);
  void show_facts();
  void show_joints();
  void show_figure();
  void show_pose();

  StudioContext& context_;
  SolveModel& model_;
  ExportPlan plan_;
  bool open_ = true, active_ = false;
  std::size_t frame_ = 0;
  ViewerWidget* viewer_ = nullptr;
  QVBoxLayout* picture_ = nullptr;
  QLabel *other_ = nullptr, *at_ = nullptr;
  QLabel *file_ = nullptr, *frames_ = nullptr, *range_ = nullptr, *joints_ = nullptr, *unit_ = nullptr;
  QTreeWidget* tree_ = nullptr;
  std::vector<body::SegmentPose> poses_;
};

}  // namespace limbwave::ui
