#include "viewer/viewer_widget.h"

#include <QApplication>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/bone_shapes.h"
#include "viewer/viewer_scene.h"

namespace limbwave::ui {

namespace {

constexpr double kRadiansPerPixel = 0.007;
constexpr double kZoomPerNotch = 1.12;
constexpr double kFollowMargin = 0.3;  // of the picture, in which a whole figure's middle is not left
constexpr double kFollowShare = 0.1;   // of the way, with every pose
constexpr double kPickSlackPixels = 4.0;

}  // namespace

bool opengl_available() {
  static const bool kAvailable = [] {
    if (qEnvironmentVariableIsSet("LIMBWAVE_NO_OPENGL")) {  // For machines whose driver lies, and for tests.
      return false;
    }
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create()) {
      return false;
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    return surface.isValid() && context.makeCurrent(&surface) && context.format().version() >= qMakePair(3, 2);
  }();
  return kAvailable;
}

struct ViewerWidget::Impl {
  std::unique_ptr<ViewerScene> scene;  // Null without OpenGL.
  QLabel* message = nullptr;
  OrbitCamera camera;
  body::Skeleton skeleton;
  std::vector<body::SegmentPose> poses;
  int selected = -1;
  bool floor = true, sensors = true, ghost = true;
  std::vector<Eigen::Vector3d> extent;
  bool framed = false;  // Once a figure has been shown, the user's view stays.
  bool follows = false;
  std::optional<bool> dark;
  QPointF pressed_at, last_at;
  Qt::MouseButton button = Qt::NoButton;
  bool moving = false;  // The press has become a drag.
};

ViewerWidget::ViewerWidget(QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>()) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Viewer"));
  setAccessibleDescription(tr("Shows the skeleton in three dimensions."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (opengl_available()) {
    impl_->scene = std::make_unique<ViewerScene>();
    QWidget* container = QWidget::createWindowContainer(impl_->scene->window(), this);
    container->setAttribute(Qt::WA_TransparentForMouseEvents);
    container->setFocusPolicy(Qt::NoFocus);
    layout->addWidget(container);
    connect(impl_->scene.get(), &ViewerScene::frame_rendered, this, &ViewerWidget::frame_rendered);
  } else {
    impl_->message = new QLabel(this);
    impl_->message->setText(
        tr("<p><b>No picture: this computer offers no OpenGL 3.2.</b></p>"
           "<p>Everything else works: solve, edit keys and export as usual. To see the figure, "
           "install the graphics driver or Mesa (on Debian: libgl1-mesa-dri) and start "
           "again.</p>"));
    impl_->message->setWordWrap(true);
    impl_->message->setAlignment(Qt::AlignCenter);
    impl_->message->setMargin(32);
    layout->addWidget(impl_->message);
  }
  impl_->camera.look(ViewDirection::kThreeQuarter);
  follow_palette();
  update_camera();
}

ViewerWidget::~ViewerWidget() = default;

int ViewerWidget::selected() const {
  return impl_->selected;
}
const std::vector<body::SegmentPose>& ViewerWidget::pose() const {
  return impl_->poses;
}
const OrbitCamera& ViewerWidget::camera() const {
  return impl_->camera;
}
bool ViewerWidget::has_picture() const {
  return impl_->scene != nullptr;
}

void ViewerWidget::set_skeleton(const body::Skeleton& skeleton) {
  impl_->skeleton = skeleton;
  const int selected_before = impl_->selected;
  impl_->selected = -1;
  if (impl_->scene) {
    impl_->scene->set_skeleton(skeleton);
  }
  // World poses of the rest pose; the shape may differ from the last one only by a length, so the view stays.
  std::vector<body::SegmentPose> rest(skeleton.segments.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    if (segment.parent < 0) {
      rest[i] = {segment.R_PL_rest, segment.p_PL};
    } else {
      const body::SegmentPose& parent = rest[static_cast<std::size_t>(segment.parent)];
      rest[i] = {parent.R_WL * segment.R_PL_rest, parent.p_WL + parent.R_WL * segment.p_PL};
    }
  }
  set_pose(rest);
  if (selected_before < static_cast<int>(rest.size())) {
    select(selected_before);
  }
}

void ViewerWidget::set_pose(const std::vector<body::SegmentPose>& poses, double tag) {
  if (poses.size() != impl_->skeleton.segments.size()) {
    return;
  }
  impl_->poses = poses;
  if (impl_->scene) {
    impl_->scene->set_pose(poses, tag);
  }
  if (!impl_->framed && !poses.empty()) {
    frame_all();
  }
  if (impl_->framed && impl_->follows && isVisible() && !poses.empty()) {
    follow_figure();
  }
}

// A figure that is seen as a whole is kept off the edges; one that is looked at closely is left alone until nothing of
// it is in the picture any more.
void ViewerWidget::follow_figure() {
  const Eigen::Vector2d size(width(), std::max(1, height()));
  const auto inside = [&](const Eigen::Vector3d& point, double margin) {
    const auto pixel = impl_->camera.project(point, size);
    return pixel && (pixel->array() >= margin * size.array()).all() &&
           (pixel->array() <= (1.0 - margin) * size.array()).all();
  };
  const Sphere sphere = bounds(impl_->skeleton, impl_->poses);
  const double across = 2.0 * impl_->camera.distance() * std::tan(impl_->camera.vertical_field() / 2.0);
  const bool whole = 2.0 * sphere.radius < 1.2 * across;
  const bool gone = std::none_of(impl_->poses.begin(), impl_->poses.end(),
                                 [&](const body::SegmentPose& pose) { return inside(pose.p_WL, 0.0); });
  if (gone || (whole && !inside(sphere.centre, kFollowMargin))) {
    const Eigen::Vector3d& target = impl_->camera.target();
    impl_->camera.follow(gone ? sphere.centre : Eigen::Vector3d(target + kFollowShare * (sphere.centre - target)));
    update_camera();
  }
}

void ViewerWidget::set_follows(bool follows) {
  impl_->follows = follows;
}

void ViewerWidget::set_sensors(const std::vector<ViewerSensor>& sensors) {
  if (impl_->scene) {
    impl_->scene->set_sensors(sensors);
  }
}

void ViewerWidget::set_ghost(const std::vector<body::SegmentPose>& poses) {
  if (impl_->scene && (poses.empty() || poses.size() == impl_->skeleton.segments.size())) {
    impl_->scene->set_ghost(poses);
  }
}

void ViewerWidget::select(int segment) {
  impl_->selected = segment >= 0 && segment < static_cast<int>(impl_->skeleton.segments.size()) ? segment : -1;
  if (impl_->scene) {
    impl_->scene->select(impl_->selected);
  }
}

void ViewerWidget::set_sensors_visible(bool visible) {
  impl_->sensors = visible;
  if (impl_->scene) {
    impl_->scene->set_visible(impl_->floor, impl_->sensors, impl_->ghost);
  }
}

void ViewerWidget::set_ghost_visible(bool visible) {
  impl_->ghost = visible;
  set_sensors_visible(impl_->sensors);
}

void ViewerWidget::set_floor_visible(bool visible) {
  impl_->floor = visible;
  set_sensors_visible(impl_->sensors);
}

void ViewerWidget::set_dark(bool dark) {
  impl_->dark = dark;
  follow_palette();
}

void ViewerWidget::follow_palette() {
  const bool dark = impl_->dark.value_or(palette().color(QPalette::Window).lightness() < 128);
  const ViewerColors colors = viewer_colors(dark);
  if (impl_->scene) {
    impl_->scene->set_colors(colors);
  }
}

void ViewerWidget::look(ViewDirection direction) {
  impl_->camera.look(direction);
  update_camera();
}

void ViewerWidget::set_extent(std::vector<Eigen::Vector3d> points) {
  const bool first = impl_->extent.empty() && !points.empty();
  impl_->extent = std::move(points);
  if (first) {
    frame_all();
  }
}

void ViewerWidget::frame_all() {
  std::vector<Eigen::Vector3d> points = impl_->extent;
  for (std::size_t i = 0; points.empty() && i < impl_->poses.size(); ++i) {
    // A little around the bones: the pose is where the motion starts.
    const Sphere sphere = bounds(impl_->skeleton, impl_->poses);
    for (int axis = 0; axis < 3; ++axis) {
      points.emplace_back(sphere.centre + 1.1 * sphere.radius * Eigen::Vector3d::Unit(axis));
      points.emplace_back(sphere.centre - 1.1 * sphere.radius * Eigen::Vector3d::Unit(axis));
    }
  }
  if (!points.empty()) {
    impl_->framed = isVisible();  // Before the first layout the shape of the picture is not known yet.
    impl_->camera.frame(points, width() / std::max(1.0, static_cast<double>(height())));
    update_camera();
  }
}

void ViewerWidget::frame_selection() {
  if (impl_->selected < 0 || impl_->poses.empty()) {
    frame_all();
    return;
  }
  const Sphere sphere = segment_bounds(impl_->skeleton, impl_->poses, impl_->selected);
  impl_->framed = true;
  impl_->camera.frame(sphere.centre, 1.6 * sphere.radius, width() / std::max(1.0, static_cast<double>(height())));
  update_camera();
}

int ViewerWidget::segment_at(const QPointF& point) const {
  const ViewRay ray = impl_->camera.ray({point.x(), point.y()},
                                        {static_cast<double>(width()), std::max(1.0, static_cast<double>(height()))});
  const double slack = kPickSlackPixels * 2 * std::tan(impl_->camera.vertical_field() / 2) /
                       std::max(1.0, static_cast<double>(height()));
  return pick_segment(impl_->skeleton, impl_->poses, ray, slack);
}

void ViewerWidget::capture(std::function<void(QImage)> done) {
  if (impl_->scene) {
    impl_->scene->capture(std::move(done));
  } else {
    done({});
  }
}

void ViewerWidget::mousePressEvent(QMouseEvent* event) {
  if (impl_->button == Qt::NoButton) {
    impl_->button = event->button();
    impl_->pressed_at = impl_->last_at = event->position();
    impl_->moving = false;
  }
  event->accept();
}

void ViewerWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  const QPointF by = at - impl_->last_at;
  if (!impl_->moving && (at - impl_->pressed_at).manhattanLength() < 0.5 * QApplication::startDragDistance()) {
    return;
  }
  impl_->moving = true;
  impl_->last_at = at;
  const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (impl_->button == Qt::MiddleButton || (impl_->button == Qt::LeftButton && shift)) {
    impl_->camera.pan(by.x(), by.y(), std::max(1, height()));
  } else if (impl_->button == Qt::LeftButton) {
    impl_->camera.orbit(-kRadiansPerPixel * by.x(), kRadiansPerPixel * by.y());
  } else if (impl_->button == Qt::RightButton) {
    impl_->camera.zoom(std::exp(-0.01 * by.y()));
  } else {
    return;
  }
  impl_->framed = true;
  update_camera();
}

void ViewerWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != impl_->button) {
    return;
  }
  const bool click = impl_->button == Qt::LeftButton && !impl_->moving;
  impl_->button = Qt::NoButton;
  if (click) {
    const int segment = segment_at(event->position());
    select(segment);
    Q_EMIT segment_clicked(segment);
  }
}

void ViewerWidget::wheelEvent(QWheelEvent* event) {
  impl_->camera.zoom(std::pow(kZoomPerNotch, event->angleDelta().y() / 120.0));
  impl_->framed = true;
  update_camera();
  event->accept();
}

void ViewerWidget::keyPressEvent(QKeyEvent* event) {
  if (!handle_key(event->key(), event->modifiers())) {
    QWidget::keyPressEvent(event);
  }
}

bool ViewerWidget::handle_key(int key, Qt::KeyboardModifiers modifiers) {
  const bool shift = modifiers == Qt::ShiftModifier;
  const bool pad = modifiers == Qt::KeypadModifier;
  if ((shift && key == Qt::Key_F) || (pad && key == Qt::Key_1)) {
    look(ViewDirection::kFront);
  } else if ((shift && key == Qt::Key_S) || (pad && key == Qt::Key_3)) {
    look(ViewDirection::kSide);
  } else if ((shift && key == Qt::Key_T) || (pad && key == Qt::Key_7)) {
    look(ViewDirection::kTop);
  } else if (key == Qt::Key_F && modifiers == Qt::NoModifier) {
    frame_selection();
  } else {
    return false;
  }
  return true;
}

void ViewerWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  update_camera();
}

void ViewerWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    follow_palette();
  }
}

bool ViewerWidget::event(QEvent* event) {
  const bool handled = QWidget::event(event);
  if (event->type() == QEvent::Show && !impl_->framed) {
    frame_all();
  }
  return handled;
}

void ViewerWidget::update_camera() {
  if (impl_->scene) {
    impl_->scene->set_camera(impl_->camera, width() / std::max(1.0, static_cast<double>(height())));
  }
  Q_EMIT camera_changed();
}

}  // namespace limbwave::ui
