/// Produces a picture of every screen in BUILD/screenshots, and checks that none of them is empty.
#include <QImage>
#include <QTest>
#include <set>

#include "common/theme.h"
#include "ui/support/studio_fixture.h"

namespace limbwave::ui::testing {

class ScreenshotsTest : public QObject {
  Q_OBJECT
 private:
  void shoot(QWidget& widget, const QString& name) {
    QVERIFY(QTest::qWaitForWindowExposed(&widget));
    QTest::qWait(50);
    const QImage image = widget.grab().toImage();
    std::set<QRgb> seen;
    for (int y = 0; y < image.height(); y += 7) {
      for (int x = 0; x < image.width(); x += 7) {
        seen.insert(image.pixel(x, y));
      }
    }
    QVERIFY2(seen.size() > 20, "the screen shows nothing");
    QVERIFY(image.save(screenshot_path(name)));
  }

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }

  void welcome() {
    StudioServices services;
    services.demo_motions = [] { return std::vector<std::string>{"wave", "raise", "reach", "walk", "box"}; };
    StudioFixture studio(services);
    const QStringList names{"dance-20261122-1.take",
                            "a take with a very long name that a person typed who likes long names.take"};
    for (const QString& name : names) {
      QDir().mkpath(studio.folder.filePath(name));
      studio.context->recent_takes().add(studio.folder.filePath(name));
    }
    shoot(*studio.window, QStringLiteral("welcome-dark"));
    apply_theme(*qApp, ThemeKind::kLight);
    shoot(*studio.window, QStringLiteral("welcome-light"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ScreenshotsTest)
#include "screenshots_test.moc"
