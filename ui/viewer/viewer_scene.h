/// The picture itself, drawn by Qt3D. Only viewer_widget.cpp includes this.
#pragma once

#include <QColor>
#include <QImage>
#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "body/skeleton.h"
#include "viewer/orbit_camera.h"
#include "viewer/viewer_widget.h"

class QWindow;

namespace limbwave::ui {

/// Everything that has a colour.
struct ViewerColors {
  QColor background, floor, bone, joint, selected, ghost, shadow, sensor;
  QColor axis_x, axis_y, axis_z;
};
ViewerColors viewer_colors(bool dark);

/// A window with the scene in it. The window takes no input; its parent handles that.
class ViewerScene : public QObject {
  Q_OBJECT
 public:
  ViewerScene();
  ~ViewerScene() override;

  /// The window to embed; owned by the scene until it is embedded.
  [[nodiscard]] QWindow* window() const;

  void set_colors(const ViewerColors& colors);
  void set_skeleton(const body::Skeleton& skeleton);
  void set_sensors(const std::vector<ViewerSensor>& sensors);
  void set_pose(const std::vector<body::SegmentPose>& poses, double tag);
  void set_ghost(const std::vector<body::SegmentPose>& poses);
  void select(int segment);
  void set_camera(const OrbitCamera& camera, double aspect);
  void set_visible(bool floor, bool sensors, bool ghost);
  void capture(std::function<void(QImage)> done);

 Q_SIGNALS:
  void frame_rendered(double steady_time_s, double tag);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::ui
