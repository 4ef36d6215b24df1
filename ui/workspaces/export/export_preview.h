/// What an export is going to write: the figure frame by frame as the file will have it, its facts and its bones.
#pragma once

#include <QWidget>

#include "workspaces/export/export_model.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace limbwave::ui {

class ViewerWidget;

class ExportPreview : public QWidget {
  Q_OBJECT
 public:
  ExportPreview(StudioContext& context, SolveModel& solves, ExportModel& model, QWidget* parent = nullptr);

  /// Pictures cost: they are made from the first time that somebody looks.
  void set_active(bool active);

  /// Null until somebody has looked.
  [[nodiscard]] ViewerWidget* viewer() const { return viewer_; }
  /// The frame of the file under the playhead, from 0.
  [[nodiscard]] std::size_t frame() const { return frame_; }

 private:
  void make_picture(QVBoxLayout* column);
  void make_facts(QVBoxLayout* column);
  /// A name and its value in a row of the grid, in its left or right half or (`wide`) in both.
  QLabel* add_fact(QGridLayout* grid, const QString& name, int row, int half, bool wide = false);
  void follow();
  void show_prepared();
  void show_facts();
  void show_bones();
  void show_pose();
  void show_selection();
  void select_bone(int bone);
  /// Bones in front of the open solve's own in the file: a root bone.
  [[nodiscard]] int bones_before() const;

  StudioContext& context_;
  SolveModel& solves_;
  ExportModel& model_;
  bool active_ = false;
  std::size_t frame_ = 0;
  ViewerWidget* viewer_ = nullptr;
  QVBoxLayout* picture_ = nullptr;
  QLabel *instead_ = nullptr, *at_ = nullptr;
  QPushButton* rest_ = nullptr;
  QLabel* actors_name_ = nullptr;
  QLabel *file_ = nullptr, *frames_ = nullptr, *range_ = nullptr, *actors_ = nullptr, *bones_ = nullptr,
         *keys_ = nullptr, *unit_ = nullptr, *size_ = nullptr;
  QTreeWidget* tree_ = nullptr;
  std::shared_ptr<const PreparedExport> shown_;
  std::vector<body::SegmentPose> poses_;
};

}  // namespace limbwave::ui
