/// The pose that a wearer takes, drawn from the rig's own description: a figure seen from its right side.
#pragma once

#include <QWidget>
#include <vector>

#include "body/rig.h"

namespace limbwave::ui {

/// World poses of the skeleton in one pose of a group, facing +x: its segments as gravity says, the others at rest.
std::vector<body::SegmentPose> figure_in_pose(const body::Rig& rig, const body::Skeleton& skeleton, int group,
                                              int pose);

class PosePicture : public QWidget {
  Q_OBJECT
 public:
  explicit PosePicture(QWidget* parent = nullptr);
  void set_pose(const body::Rig& rig, const body::Skeleton& skeleton, int group, int pose, std::vector<int> sensors);
  [[nodiscard]] QSize sizeHint() const override { return {320, 360}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {180, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Bone {
    QPointF from, to;  ///< Metres, x forward, y up.
    double depth;      ///< Metres towards the left of the figure.
    double width;      ///< Metres.
    bool marked;
  };
  std::vector<Bone> bones_;
  std::vector<QPointF> sensors_;
  QPointF head_, hip_;
  bool whole_figure_ = false;  ///< The root is a trunk, so that head and legs can be added.
};

}  // namespace limbwave::ui
