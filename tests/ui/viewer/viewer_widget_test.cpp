#include "viewer/viewer_widget.h"

#include <QApplication>
#include <QImage>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <chrono>
#include <filesystem>

#include "body/rig.h"

namespace limbwave::ui {
namespace {

body::Skeleton arm() {
  auto skeleton = body::load_skeleton("arm");
  return skeleton ? *skeleton : body::Skeleton{};
}

std::vector<body::SegmentPose> raised(const body::Skeleton& skeleton) {
  std::vector<body::Quaterniond> joints(skeleton.segments.size(), body::Quaterniond::Identity());
  joints[1] = Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ());
  joints[2] = Eigen::AngleAxisd(0.9, -Eigen::Vector3d::UnitY());
  return body::poses_from_joints(skeleton, joints, skeleton.segments[0].p_PL);
}

std::vector<ViewerSensor> sensors() {
  std::vector<ViewerSensor> list;
  const auto rig = body::load_rig("line-in-arm");
  const body::Skeleton skeleton = arm();
  if (rig) {
    for (const body::Accelerometer& a : rig->accelerometers) {
      list.push_back({QString::fromStdString(a.name), skeleton.find(a.segment), a.R_LS, a.p_LS});
    }
  }
  return list;
}

QImage grab(QWidget& widget) {
  QTest::qWait(150);  // The X server copies the frame on its own time.
  return widget.screen()->grabWindow(widget.window()->winId()).toImage().convertToFormat(QImage::Format_RGB32);
}

void save(const QImage& image, const QString& name) {
  const std::filesystem::path folder = std::filesystem::path(LIMBWAVE_BINARY_DIR) / "screenshots";
  std::filesystem::create_directories(folder);
  QVERIFY(image.save(QString::fromStdString((folder / name.toStdString()).string())));
}

int differing_pixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
      count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
  }
  return count;
}

QPoint pixel_of(const ViewerWidget& viewer, const Eigen::Vector3d& point) {
  const auto pixel = viewer.camera().project(point, {viewer.width(), viewer.height()});
  return pixel ? QPoint(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())) : QPoint(-1, -1);
}

}  // namespace

class ViewerWidgetTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ViewerWidget> viewer_;
  body::Skeleton skeleton_ = arm();

  // A shown viewer with the arm raised, its first frame drawn.
  void show_arm(bool dark) {
    viewer_ = std::make_unique<ViewerWidget>();
    viewer_->resize(960, 720);
    viewer_->set_dark(dark);
    viewer_->set_skeleton(skeleton_);
    viewer_->set_sensors(sensors());
    viewer_->show();
    QVERIFY(QTest::qWaitForWindowExposed(viewer_.get()));
    QSignalSpy frames(viewer_.get(), &ViewerWidget::frame_rendered);
    viewer_->set_pose(raised(skeleton_), 1.0);
    viewer_->frame_all();
    QVERIFY(frames.wait(5000));
  }

  Eigen::Vector3d middle_of(int segment) const {
    const auto i = static_cast<std::size_t>(segment);
    const body::SegmentPose& pose = viewer_->pose()[i];
    return pose.p_WL + pose.R_WL * Eigen::Vector3d(skeleton_.segments[i].length / 2, 0, 0);
  }

 private Q_SLOTS:
  // A live figure walks where it likes: the camera goes along, unless somebody looks closely at a part of it.
  void a_figure_that_walks_away_is_followed_when_asked_for() {
    show_arm(true);
    const auto walked = [this](double metres) {
      std::vector<body::SegmentPose> poses = raised(skeleton_);
      for (body::SegmentPose& pose : poses) {
        pose.p_WL.x() += metres;
        pose.p_WL.y() += metres;
      }
      return poses;
    };
    const Eigen::Vector3d target = viewer_->camera().target();
    for (double way = 0.0; way < 20.0; way += 0.05) {
      viewer_->set_pose(walked(way));
    }
    QCOMPARE((viewer_->camera().target() - target).norm(), 0.0);
    viewer_->set_follows(true);
    viewer_->set_pose(walked(20.0));
    const double distance = viewer_->camera().distance();
    for (double way = 20.0; way < 24.0; way += 0.02) {
      viewer_->set_pose(walked(way));
      const QPoint pixel = pixel_of(*viewer_, viewer_->pose().front().p_WL);
      QVERIFY2(viewer_->rect().contains(pixel), "it never leaves the picture");
    }
    QCOMPARE(viewer_->camera().distance(), distance);
    // The hand alone fills the picture: that is left alone.
    viewer_->select(static_cast<int>(skeleton_.segments.size()) - 1);
    viewer_->frame_selection();
    const Eigen::Vector3d close = viewer_->camera().target();
    viewer_->set_pose(walked(24.0));
    QVERIFY((viewer_->camera().target() - close).norm() < 1e-12);
  }

  void initTestCase() {
    QVERIFY2(opengl_available(), "this machine draws no OpenGL: install libgl1-mesa-dri");
    QVERIFY(!skeleton_.segments.empty());
  }

  void cleanup() { viewer_.reset(); }

  void draws_the_arm_in_dark_and_light() {
    for (const bool dark : {true, false}) {
      show_arm(dark);
      const QImage image = grab(*viewer_);
      save(image, dark ? "viewer_dark.png" : "viewer_light.png");
      const QRgb ground = image.pixel(5, 5);
      QCOMPARE(qGray(ground) < 80, dark);
      // Every bone stands out from the ground at its middle.
      for (int i = 0; i < static_cast<int>(skeleton_.segments.size()); ++i) {
        const QRgb bone = image.pixel(pixel_of(*viewer_, middle_of(i)));
        QVERIFY2(std::abs(qGray(bone) - qGray(ground)) > 12, qPrintable(QStringLiteral("segment %1").arg(i)));
      }
    }
  }

  void click_selects_the_bone_under_the_pointer() {
    show_arm(true);
    QSignalSpy clicked(viewer_.get(), &ViewerWidget::segment_clicked);
    QTest::mouseClick(viewer_.get(), Qt::LeftButton, {}, pixel_of(*viewer_, middle_of(2)));
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(clicked[0][0].toInt(), 2);
    QCOMPARE(viewer_->selected(), 2);
    const QImage selected = grab(*viewer_);
    save(selected, QStringLiteral("viewer_selected.png"));
    const QColor bone = selected.pixelColor(pixel_of(*viewer_, middle_of(2)));
    QVERIFY2(bone.red() > bone.blue() + 40, "the selected bone has the accent's colour");
    QTest::mouseClick(viewer_.get(), Qt::LeftButton, {}, QPoint(8, 8));
    QCOMPARE(viewer_->selected(), -1);
  }

  void drags_turn_move_and_zoom() {
    show_arm(true);
    const OrbitCamera before = viewer_->camera();
    QSignalSpy clicked(viewer_.get(), &ViewerWidget::segment_clicked);
    const auto drag = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
      QTest::mousePress(viewer_.get(), button, modifiers, {300, 300});
      QMouseEvent move(QEvent::MouseMove, QPointF(380, 330), viewer_->mapToGlobal(QPointF(380, 330)), Qt::NoButton,
                       button, modifiers);
      QApplication::sendEvent(viewer_.get(), &move);
      QTest::mouseRelease(viewer_.get(), button, modifiers, {380, 330});
    };
    drag(Qt::LeftButton, {});
    QVERIFY(viewer_->camera().yaw() != before.yaw());
    QVERIFY(viewer_->camera().pitch() > before.pitch());
    QCOMPARE(viewer_->camera().target(), before.target());
    for (const auto& [button, modifiers] : {std::pair<Qt::MouseButton, Qt::KeyboardModifiers>(Qt::MiddleButton, {}),
                                            {Qt::LeftButton, Qt::ShiftModifier}}) {
      const OrbitCamera start = viewer_->camera();
      drag(button, modifiers);
      QVERIFY((viewer_->camera().target() - start.target()).norm() > 0.01);
      QCOMPARE(viewer_->camera().yaw(), start.yaw());
    }
    QCOMPARE(clicked.size(), 0);
    const double distance = viewer_->camera().distance();
    QWheelEvent wheel({300, 300}, viewer_->mapToGlobal(QPointF(300, 300)), {}, {0, 240}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(viewer_.get(), &wheel);
    QVERIFY(viewer_->camera().distance() < distance);
  }

  void keys_choose_views_and_frame_the_selection() {
    show_arm(true);
    QTest::keyClick(viewer_.get(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY((viewer_->camera().forward() + Eigen::Vector3d::UnitX()).norm() < 1e-9);
    QTest::keyClick(viewer_.get(), Qt::Key_S, Qt::ShiftModifier);
    QVERIFY((viewer_->camera().forward() - Eigen::Vector3d::UnitY()).norm() < 1e-9);
    QTest::keyClick(viewer_.get(), Qt::Key_T, Qt::ShiftModifier);
    QVERIFY(viewer_->camera().forward().z() < -0.99);
    QTest::keyClick(viewer_.get(), Qt::Key_1, Qt::KeypadModifier);
    QVERIFY((viewer_->camera().forward() + Eigen::Vector3d::UnitX()).norm() < 1e-9);
    viewer_->select(3);
    QTest::keyClick(viewer_.get(), Qt::Key_F);
    QVERIFY((viewer_->camera().target() - middle_of(3)).norm() < 1e-9);
  }

  void every_new_pose_is_reported_with_its_tag_and_a_later_time() {
    show_arm(true);
    QSignalSpy frames(viewer_.get(), &ViewerWidget::frame_rendered);
    const QImage before = grab(*viewer_);
    for (int i = 1; i <= 5; ++i) {
      const double set_at = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
      auto poses = raised(skeleton_);
      for (auto& pose : poses) {
        pose.p_WL.y() += 0.03 * i;
      }
      viewer_->set_pose(poses, i);
      QVERIFY(frames.wait(2000));
      QCOMPARE(frames.last()[1].toDouble(), static_cast<double>(i));
      QVERIFY(frames.last()[0].toDouble() >= set_at);
    }
    QVERIFY2(differing_pixels(before, grab(*viewer_)) > 1000, "the picture follows the pose");
    frames.clear();
    QTest::qWait(200);
    QCOMPARE(frames.size(), 0);  // Nothing new, nothing reported.
  }

  void ghost_sensors_and_floor_can_be_hidden() {
    show_arm(true);
    viewer_->set_ghost(body::poses_from_orientations(
        skeleton_,
        [&] {
          std::vector<body::Quaterniond> R;
          for (const auto& pose : viewer_->pose()) {
            R.push_back(Eigen::AngleAxisd(0.12, Eigen::Vector3d::UnitX()) * pose.R_WL);
          }
          return R;
        }(),
        viewer_->pose()[0].p_WL));
    const QImage all = grab(*viewer_);
    save(all, QStringLiteral("viewer_ghost.png"));
    viewer_->set_ghost_visible(false);
    const QImage no_ghost = grab(*viewer_);
    QVERIFY(differing_pixels(all, no_ghost) > 500);
    viewer_->set_sensors_visible(false);
    const QImage no_sensors = grab(*viewer_);
    QVERIFY(differing_pixels(no_ghost, no_sensors) > 200);
    viewer_->set_floor_visible(false);
    QVERIFY(differing_pixels(no_sensors, grab(*viewer_)) > 500);
  }

  void capture_gives_the_frame() {
    show_arm(true);
    QImage picture;
    bool done = false;
    viewer_->capture([&](const QImage& image) {
      picture = image;
      done = true;
    });
    QTRY_VERIFY_WITH_TIMEOUT(done, 5000);
    QVERIFY(picture.width() >= 900);
  }

  void poses_of_another_skeleton_are_ignored() {
    show_arm(true);
    const auto before = viewer_->pose();
    viewer_->set_pose(std::vector<body::SegmentPose>(2));
    QCOMPARE(viewer_->pose().size(), before.size());
    viewer_->set_skeleton({});
    QVERIFY(viewer_->pose().empty());
    viewer_->frame_selection();
    viewer_->select(7);
    QCOMPARE(viewer_->selected(), -1);
    QTest::qWait(50);
  }
};

}  // namespace limbwave::ui

QTEST_MAIN(limbwave::ui::ViewerWidgetTest)
#include "viewer_widget_test.moc"
