#include "viewer/viewer_scene.h"

#include <QMetaObject>
#include <QPointer>
#include <QSurfaceFormat>
#include <Qt3DCore/QTransform>
#include <Qt3DExtras/Qt3DWindow>
#include <Qt3DLogic/QFrameAction>
#include <Qt3DRender/QRenderSettings>
#include <algorithm>
#include <chrono>

#include "viewer/viewer_materials.h"

namespace limbwave::ui {

namespace {

using Qt3DCore::QEntity;
using Qt3DCore::QTransform;
using Qt3DRender::QGeometryRenderer;

QVector3D to_qt(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

QQuaternion to_qt(const Eigen::Quaterniond& q) {
  return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())};
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr float kSensorHalfLength = 0.016F;  // Half the edges of a sensor's box, metres.
constexpr float kSensorHalfWidth = 0.012F;
constexpr float kSensorHalfHeight = 0.005F;
constexpr float kSensorAxis = 0.055F;
constexpr float kSensorAxisRadius = 0.0017F;
constexpr float kWorldAxis = 0.35F;
constexpr float kWorldAxisRadius = 0.004F;
constexpr float kLetter = 0.045F;
constexpr float kFloorHalf = 8.0F;
constexpr double kFloorStays = 1.5;  // metres about the origin in which one looks at the grid as it is

}  // namespace

ViewerColors viewer_colors(bool dark) {
  if (dark) {
    return {QColor(0x1b, 0x1d, 0x21), QColor(0xa8, 0xb0, 0xbc, 0x90), QColor(0xd9, 0xdd, 0xe3),
            QColor(0x8c, 0x95, 0xa3), QColor(0xf0, 0xa2, 0x1a),       QColor(0x56, 0xb4, 0xe9, 0x66),
            QColor(0x13, 0x14, 0x17), QColor(0x4a, 0x52, 0x5e),       QColor(0xe8, 0x6a, 0x33),
            QColor(0x1f, 0xb5, 0x83), QColor(0x3f, 0x97, 0xe0)};
  }
  return {QColor(0xe9, 0xeb, 0xee), QColor(0x4c, 0x54, 0x60, 0xa0), QColor(0xc4, 0xc9, 0xd1), QColor(0x6c, 0x75, 0x83),
          QColor(0xee, 0x8c, 0x00), QColor(0x00, 0x72, 0xb2, 0x66), QColor(0xcf, 0xd3, 0xd9), QColor(0x3a, 0x41, 0x4c),
          QColor(0xd5, 0x5e, 0x00), QColor(0x00, 0x8e, 0x66),       QColor(0x00, 0x72, 0xb2)};
}

/// One figure's moving parts.
struct Figure {
  QEntity* root = nullptr;
  std::vector<QEntity*> segments;
  std::vector<QTransform*> transforms;
};

struct ViewerScene::Impl {
  Qt3DExtras::Qt3DWindow* window = nullptr;
  QPointer<Qt3DExtras::Qt3DWindow> alive;  // The widget that embeds the window deletes it.
  QEntity* root = nullptr;
  FrameGraph frame_graph;
  FloorMaterial* floor_material = nullptr;
  SurfaceMaterial *bone = nullptr, *joint = nullptr, *selected = nullptr, *ghost = nullptr, *sensor = nullptr;
  std::array<SurfaceMaterial*, 3> axis{};
  QGeometryRenderer *bone_shape = nullptr, *ball = nullptr, *box = nullptr, *rod = nullptr, *arrow = nullptr;
  QEntity* floor = nullptr;
  QTransform* floor_place = nullptr;
  QEntity* sensors = nullptr;
  std::array<QTransform*, 3> letters{};
  Figure figure, ghost_figure;
  std::vector<QEntity*> bone_entities;
  std::vector<QEntity*> sensor_entities;
  std::vector<ViewerSensor> sensor_list;
  body::Skeleton skeleton;
  int selected_segment = -1;
  bool show_sensors = true, show_ghost = true, ghost_posed = false;
  bool pose_waits = false;  // For the frame that shows it.
  double pose_tag = 0.0;

  QEntity* part(QEntity* parent, QGeometryRenderer* shape, Qt3DRender::QMaterial* material, const QVector3D& at,
                const QQuaternion& turned, const QVector3D& scale) {
    auto* entity = new QEntity(parent);
    auto* transform = new QTransform(entity);
    transform->setTranslation(at);
    transform->setRotation(turned);
    transform->setScale3D(scale);
    entity->addComponent(transform);
    entity->addComponent(shape);
    entity->addComponent(material);
    return entity;
  }

  // A rod between two points.
  QEntity* rod_between(QEntity* parent, QGeometryRenderer* shape, Qt3DRender::QMaterial* material, const QVector3D& a,
                       const QVector3D& b, float radius) {
    return part(parent, shape, material, a, QQuaternion::rotationTo(QVector3D(1, 0, 0), b - a),
                QVector3D((b - a).length(), radius, radius));
  }

  void triad(QEntity* parent, float length, float radius) {
    const std::array<QVector3D, 3> ends{QVector3D(length, 0, 0), QVector3D(0, length, 0), QVector3D(0, 0, length)};
    for (std::size_t k = 0; k < 3; ++k) {
      rod_between(parent, arrow, axis[k], QVector3D(), ends[k], radius);
    }
  }

  Figure make_figure(SurfaceMaterial* bones, SurfaceMaterial* joints, std::vector<QEntity*>* pickable) {
    Figure made;
    made.root = new QEntity(root);
    for (const body::Segment& segment : skeleton.segments) {
      auto* entity = new QEntity(made.root);
      auto* transform = new QTransform(entity);
      entity->addComponent(transform);
      made.segments.push_back(entity);
      made.transforms.push_back(transform);
      const auto radius = static_cast<float>(bone_radius(segment));
      const auto length = static_cast<float>(segment.length);
      QEntity* bone_entity = nullptr;
      if (length > 1e-4F) {
        bone_entity = part(entity, bone_shape, bones, {}, {}, {length, radius, radius});
        part(entity, ball, joints, {length, 0, 0}, {}, QVector3D(1, 1, 1) * (0.42F * radius));
      }
      part(entity, ball, joints, {}, {}, QVector3D(1, 1, 1) * (0.72F * radius));
      if (pickable != nullptr) {
        pickable->push_back(bone_entity);
      }
      if (segment.parent >= 0) {
        // A joint that does not sit on its parent's bone hangs on a thin strut.
        const auto parent = static_cast<std::size_t>(segment.parent);
        const QVector3D joint_at = to_qt(segment.p_PL);
        const auto parent_length = static_cast<float>(skeleton.segments[parent].length);
        const QVector3D foot(std::clamp(joint_at.x(), 0.0F, parent_length), 0, 0);
        if ((joint_at - foot).length() > 0.01F) {
          rod_between(made.segments[parent], rod, joints, foot, joint_at, 0.004F);
        }
      }
    }
    return made;
  }

  static void move(Figure& figure, const std::vector<body::SegmentPose>& poses) {
    for (std::size_t i = 0; i < std::min(poses.size(), figure.transforms.size()); ++i) {
      figure.transforms[i]->setTranslation(to_qt(poses[i].p_WL));
      figure.transforms[i]->setRotation(to_qt(poses[i].R_WL));
    }
  }

  void rebuild_sensors() {
    for (QEntity* entity : sensor_entities) {
      delete entity;
    }
    sensor_entities.clear();
    for (const ViewerSensor& s : sensor_list) {
      if (s.segment < 0 || static_cast<std::size_t>(s.segment) >= figure.segments.size()) {
        continue;
      }
      const auto i = static_cast<std::size_t>(s.segment);
      auto* mount = new QEntity(figure.segments[i]);
      auto* transform = new QTransform(mount);
      // A rig that places its sensors on the axis of the bone would hide them inside it: show them on its surface.
      Eigen::Vector3d at = s.p_LS;
      const double out = 0.9 * bone_radius(skeleton.segments[i]);
      if (at.tail<2>().norm() < out) {
        at.z() = out;
      }
      transform->setTranslation(to_qt(at));
      transform->setRotation(to_qt(s.R_LS));
      mount->addComponent(transform);
      part(mount, box, sensor, {}, {}, {kSensorHalfLength, kSensorHalfWidth, kSensorHalfHeight});
      triad(mount, kSensorAxis, kSensorAxisRadius);
      mount->setEnabled(show_sensors);
      sensor_entities.push_back(mount);
    }
  }

  void build() {
    bone_shape = make_renderer(bone_mesh(), root);
    ball = make_renderer(sphere_mesh(), root);
    box = make_renderer(box_mesh(), root);
    rod = make_renderer(rod_mesh(false), root);
    arrow = make_renderer(rod_mesh(true), root);
    using Kind = SurfaceMaterial::Kind;
    bone = new SurfaceMaterial(Kind::kSolidWithShadow, root);
    joint = new SurfaceMaterial(Kind::kSolidWithShadow, root);
    selected = new SurfaceMaterial(Kind::kSolidWithShadow, root);
    ghost = new SurfaceMaterial(Kind::kTranslucent, root);
    sensor = new SurfaceMaterial(Kind::kSolid, root);
    for (auto& material : axis) {
      material = new SurfaceMaterial(Kind::kFlat, root);
    }
    floor_material = new FloorMaterial(root);

    TriangleMesh quad;
    for (const auto& [x, y] :
         {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      quad.positions.emplace_back(kFloorHalf * static_cast<float>(x), kFloorHalf * static_cast<float>(y), 0.0F);
      quad.normals.push_back(Eigen::Vector3f::UnitZ());
    }
    floor = new QEntity(root);
    QEntity* grid = part(floor, make_renderer(quad, root), floor_material, {}, {}, {1, 1, 1});
    floor_place = grid->componentsOfType<QTransform>().value(0);
    triad(floor, kWorldAxis, kWorldAxisRadius);
    const std::array<char, 3> names{'X', 'Y', 'Z'};
    for (std::size_t k = 0; k < 3; ++k) {
      QVector3D at;
      at[static_cast<int>(k)] = kWorldAxis + kLetter;
      QEntity* letter =
          part(floor, make_renderer(letter_mesh(names[k]), root), axis[k], at, {}, QVector3D(1, 1, 1) * kLetter);
      letters[k] = letter->componentsOfType<QTransform>().front();
    }
  }
};

ViewerScene::ViewerScene() : impl_(std::make_unique<Impl>()) {
  // Qt3D has two ways of drawing; our shaders are for the one that talks to OpenGL itself.
  if (!qEnvironmentVariableIsSet("QT3D_RENDERER")) {
    qputenv("QT3D_RENDERER", "opengl");
  }
  impl_->window = new Qt3DExtras::Qt3DWindow;
  impl_->alive = impl_->window;
  // The widget around it gets the mouse and the keys: shortcuts work whether or not the picture was clicked last.
  impl_->window->setFlag(Qt::WindowTransparentForInput);
  impl_->window->setFlag(Qt::WindowDoesNotAcceptFocus);
  impl_->window->renderSettings()->setRenderPolicy(Qt3DRender::QRenderSettings::OnDemand);
  impl_->root = new QEntity;
  impl_->frame_graph = make_frame_graph(impl_->window->camera(), impl_->window, impl_->root);
  impl_->window->setActiveFrameGraph(impl_->frame_graph.root);
  impl_->build();
  impl_->window->setRootEntity(impl_->root);

  // The action comes between taking over the scene's changes and drawing them; drawing ends before the event loop
  // goes on, so that what is queued here runs when the frame has been handed to the screen.
  auto* action = new Qt3DLogic::QFrameAction(impl_->root);
  impl_->root->addComponent(action);
  connect(action, &Qt3DLogic::QFrameAction::triggered, this, [this] {
    if (impl_->pose_waits) {
      impl_->pose_waits = false;
      QMetaObject::invokeMethod(
          this, [this, tag = impl_->pose_tag] { Q_EMIT frame_rendered(steady_seconds(), tag); }, Qt::QueuedConnection);
    }
  });
}

ViewerScene::~ViewerScene() {
  delete impl_->alive;
}

QWindow* ViewerScene::window() const {
  return impl_->window;
}

void ViewerScene::set_colors(const ViewerColors& colors) {
  impl_->frame_graph.clear->setClearColor(colors.background);
  impl_->floor_material->set_color(colors.floor);
  impl_->bone->set_color(colors.bone);
  impl_->joint->set_color(colors.joint);
  impl_->selected->set_color(colors.selected);
  impl_->ghost->set_color(colors.ghost);
  impl_->sensor->set_color(colors.sensor);
  for (SurfaceMaterial* material : {impl_->bone, impl_->joint, impl_->selected}) {
    material->set_shadow_color(colors.shadow);
  }
  impl_->axis[0]->set_color(colors.axis_x);
  impl_->axis[1]->set_color(colors.axis_y);
  impl_->axis[2]->set_color(colors.axis_z);
}

void ViewerScene::set_skeleton(const body::Skeleton& skeleton) {
  impl_->sensor_entities.clear();  // They go with the figure they are mounted on.
  impl_->bone_entities.clear();
  delete impl_->figure.root;
  delete impl_->ghost_figure.root;
  impl_->skeleton = skeleton;
  impl_->figure = impl_->make_figure(impl_->bone, impl_->joint, &impl_->bone_entities);
  impl_->ghost_figure = impl_->make_figure(impl_->ghost, impl_->ghost, nullptr);
  impl_->ghost_figure.root->setEnabled(false);
  impl_->ghost_posed = false;
  impl_->selected_segment = -1;
  impl_->rebuild_sensors();
}

void ViewerScene::set_sensors(const std::vector<ViewerSensor>& sensors) {
  impl_->sensor_list = sensors;
  impl_->rebuild_sensors();
}

void ViewerScene::set_pose(const std::vector<body::SegmentPose>& poses, double tag) {
  Impl::move(impl_->figure, poses);
  impl_->pose_waits = true;
  impl_->pose_tag = tag;
}

void ViewerScene::set_ghost(const std::vector<body::SegmentPose>& poses) {
  impl_->ghost_posed = !poses.empty();
  Impl::move(impl_->ghost_figure, poses);
  if (impl_->ghost_figure.root != nullptr) {
    impl_->ghost_figure.root->setEnabled(impl_->ghost_posed && impl_->show_ghost);
  }
}

void ViewerScene::select(int segment) {
  const auto paint = [this](int index, SurfaceMaterial* from, SurfaceMaterial* to) {
    if (index >= 0 && static_cast<std::size_t>(index) < impl_->bone_entities.size()) {
      if (QEntity* entity = impl_->bone_entities[static_cast<std::size_t>(index)]) {
        entity->removeComponent(from);
        entity->addComponent(to);
      }
    }
  };
  if (segment != impl_->selected_segment) {
    paint(impl_->selected_segment, impl_->selected, impl_->bone);
    paint(segment, impl_->bone, impl_->selected);
    impl_->selected_segment = segment;
  }
}

void ViewerScene::set_camera(const OrbitCamera& camera, double aspect) {
  Qt3DRender::QCamera* lens = impl_->window->camera();
  lens->lens()->setPerspectiveProjection(static_cast<float>(camera.vertical_field() * 180.0 / M_PI),
                                         static_cast<float>(aspect), static_cast<float>(camera.near_plane()),
                                         static_cast<float>(camera.far_plane()));
  lens->setPosition(to_qt(camera.position()));
  lens->setUpVector(to_qt(camera.up()));
  lens->setViewCenter(to_qt(camera.target()));
  // The grid lies where one looks; its lines stay where they are in the world.
  const Eigen::Vector3d target(camera.target().x(), camera.target().y(), 0.0);
  impl_->floor_place->setTranslation(to_qt(target * std::max(0.0, 1.0 - kFloorStays / std::max(target.norm(), 1e-9))));
  // The letters at the axes face the viewer.
  Eigen::Matrix3d R_WV;
  R_WV << camera.right(), camera.up(), -camera.forward();
  for (QTransform* letter : impl_->letters) {
    letter->setRotation(to_qt(Eigen::Quaterniond(R_WV)));
  }
}

void ViewerScene::set_visible(bool floor, bool sensors, bool ghost) {
  impl_->floor->setEnabled(floor);
  impl_->show_sensors = sensors;
  for (QEntity* entity : impl_->sensor_entities) {
    entity->setEnabled(sensors);
  }
  impl_->show_ghost = ghost;
  if (impl_->ghost_figure.root != nullptr) {
    impl_->ghost_figure.root->setEnabled(ghost && impl_->ghost_posed);
  }
}

void ViewerScene::capture(std::function<void(QImage)> done) {
  Qt3DRender::QRenderCaptureReply* reply = impl_->frame_graph.capture->requestCapture();
  connect(reply, &Qt3DRender::QRenderCaptureReply::completed, this, [reply, done = std::move(done)] {
    done(reply->image());
    reply->deleteLater();
  });
}

}  // namespace limbwave::ui
