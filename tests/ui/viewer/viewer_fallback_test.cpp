/// A computer without OpenGL gets a sentence in the picture's place, and everything else goes on working.
#include <QDir>
#include <QLabel>
#include <QTest>

#include "viewer/viewer_widget.h"

namespace limbwave::ui {

class ViewerFallbackTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { qputenv("LIMBWAVE_NO_OPENGL", "1"); }

  void says_what_is_missing_and_goes_on() {
    QVERIFY(!opengl_available());
    ViewerWidget viewer;
    viewer.resize(640, 400);
    viewer.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewer));
    QVERIFY(!viewer.has_picture());
    const auto* message = viewer.findChild<QLabel*>();
    QVERIFY(message != nullptr && message->isVisible());
    QVERIFY(message->text().contains(QStringLiteral("OpenGL")));
    body::Skeleton skeleton;
    skeleton.segments.resize(1);
    skeleton.segments[0].length = 0.3;
    viewer.set_skeleton(skeleton);
    viewer.set_pose({body::SegmentPose{}});
    viewer.set_ghost({body::SegmentPose{}});
    viewer.set_sensors({ViewerSensor{}});
    viewer.select(0);
    viewer.frame_selection();
    viewer.set_dark(false);
    QCOMPARE(viewer.selected(), 0);
    QCOMPARE(viewer.pose().size(), std::size_t{1});
    bool called = false;
    viewer.capture([&](const QImage& image) { called = image.isNull(); });
    QVERIFY(called);
    const QString folder = QStringLiteral(LIMBWAVE_BINARY_DIR "/screenshots");
    QDir().mkpath(folder);
    QVERIFY(viewer.grab().save(folder + QStringLiteral("/viewer_without_opengl.png")));
  }
};

}  // namespace limbwave::ui

QTEST_MAIN(limbwave::ui::ViewerFallbackTest)
#include "viewer_fallback_test.moc"
