/// The three-dimensional view of a skeleton. How the picture is made is hidden behind the implementation.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "body/skeleton.h"
#include "viewer/orbit_camera.h"

class QImage;
class QLabel;

namespace limbwave::ui {

/// A sensor to draw: a small box with its axes on a segment.
struct ViewerSensor {
  QString name;
  int segment = 0;  ///< Index into the skeleton's segments.
  Eigen::Quaterniond R_LS = Eigen::Quaterniond::Identity();
  Eigen::Vector3d p_LS = Eigen::Vector3d::Zero();  ///< Metres.
};

/// Shows a skeleton with its sensors on a floor with lines every 10 cm and 1 m, z up. Left drag turns, middle drag or
/// Shift and left drag moves, the wheel zooms, F frames the selection, Shift+F, Shift+S and Shift+T (and 1, 3, 7 on
/// the number pad) look from the front, the side and the top, a click selects a bone. Without OpenGL 3.2 a message
/// takes the place of the picture; everything else goes on working.
class ViewerWidget : public QWidget {
  Q_OBJECT
 public:
  explicit ViewerWidget(QWidget* parent = nullptr);
  ~ViewerWidget() override;

  /// Replaces the skeleton; it stands in its rest pose until the next set_pose.
  void set_skeleton(const body::Skeleton& skeleton);
  /// World poses, one per segment of the skeleton; ignored when the number differs. `tag` comes back with
  /// frame_rendered of the first frame that shows this pose.
  void set_pose(const std::vector<body::SegmentPose>& poses, double tag = 0.0);
  void set_sensors(const std::vector<ViewerSensor>& sensors);
  /// A second, translucent figure of the same skeleton (the truth of a simulated take); empty hides it.
  void set_ghost(const std::vector<body::SegmentPose>& poses);
  /// Highlights a segment; -1: none.
  void select(int segment);

  [[nodiscard]] int selected() const;
  [[nodiscard]] const std::vector<body::SegmentPose>& pose() const;
  [[nodiscard]] const OrbitCamera& camera() const;
  /// False when this machine offers no OpenGL that the picture could be drawn with.
  [[nodiscard]] bool has_picture() const;

  void set_sensors_visible(bool visible);
  void set_ghost_visible(bool visible);
  void set_floor_visible(bool visible);
  /// Background and colours; follows the palette by itself unless set here.
  void set_dark(bool dark);

  /// What "everything" is for framing: points of a whole motion, metres. Without any, the present pose. The first ones
  /// also place the camera.
  void set_extent(std::vector<Eigen::Vector3d> points);
  /// The camera goes along with a figure that is about to leave the picture.
  void set_follows(bool follows);

  void look(ViewDirection direction);
  /// Centres the selected bone, or everything when none is selected.
  void frame_selection();
  void frame_all();

  /// Does what a key of the viewer stands for; false when it is none of them.
  bool handle_key(int key, Qt::KeyboardModifiers modifiers);

  /// The segment under a point of this widget, or -1.
  [[nodiscard]] int segment_at(const QPointF& point) const;

  /// Draws the next frame and hands it over as an image; a null image when there is no picture.
  void capture(std::function<void(QImage)> done);

  [[nodiscard]] QSize sizeHint() const override { return {720, 520}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 180}; }

 Q_SIGNALS:
  /// A bone was clicked; -1 for the empty space.
  void segment_clicked(int segment);
  /// A frame that shows a new pose is on its way to the screen: std::chrono::steady_clock, seconds, and the tag given
  /// to set_pose.
  void frame_rendered(double steady_time_s, double tag);
  void camera_changed();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Impl;
  void update_camera();
  void follow_figure();
  void follow_palette();
  std::unique_ptr<Impl> impl_;
};

/// Whether this process can create an OpenGL 3.2 core context. Asked once, then remembered.
bool opengl_available();

}  // namespace limbwave::ui
