/// Produces a picture of every screen in BUILD/screenshots, and checks that none of them is empty.
#include <QImage>
#include <QPushButton>
#include <QTest>
#include <QTranslator>
#include <set>

#include "common/theme.h"
#include "ui/support/fake_services.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/capture/capture_workspace.h"
#include "workspaces/shortcut_sheet.h"

namespace limbwave::ui::testing {

class ScreenshotsTest : public QObject {
  Q_OBJECT
 private:
  /// At other scales than 100 % the name says so.
  static QString scaled(const QString& name) {
    const int percent = qRound(qApp->devicePixelRatio() * 100.0);
    return percent == 100 ? name : QStringLiteral("%1-%2").arg(name).arg(percent);
  }

  static void shoot(QWidget& widget, const QString& name) {
    QVERIFY(QTest::qWaitForWindowExposed(&widget));
    QTest::qWait(80);
    const QImage image = widget.grab().toImage();
    std::set<QRgb> seen;
    for (int y = 0; y < image.height(); y += 7) {
      for (int x = 0; x < image.width(); x += 7) {
        seen.insert(image.pixel(x, y));
      }
    }
    QVERIFY2(seen.size() > 20, "the screen shows nothing");
    QVERIFY(image.save(screenshot_path(scaled(name))));
  }

  static void open(StudioFixture& studio, const char* device) {
    studio.window->show_workspace(QStringLiteral("capture"));
    auto* capture = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    QVERIFY(capture != nullptr);
    QTRY_VERIFY(!capture->model().searching() && !capture->model().devices().empty());
    capture->model().open_device(QString::fromLatin1(device));
    QTRY_VERIFY(studio.context->live().snapshot() != nullptr || !studio.context->live().problem().isEmpty());
  }

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }

  void welcome() {
    StudioFixture studio(fake_services(std::make_shared<FakeLine>()));
    const QStringList names{
        QStringLiteral("dance-20261122-1.take"),
        QStringLiteral("a take with a very long name that a person typed who likes long names and many words.take")};
    for (const QString& name : names) {
      QDir().mkpath(studio.folder.filePath(name));
      studio.context->recent_takes().add(studio.folder.filePath(name));
    }
    shoot(*studio.window, QStringLiteral("welcome-dark"));
    apply_theme(*qApp, ThemeKind::kLight);
    shoot(*studio.window, QStringLiteral("welcome-light"));
  }

  void capture_empty() {
    auto line = std::make_shared<FakeLine>();
    line->no_devices = true;
    StudioFixture studio(fake_services(line));
    studio.window->show_workspace(QStringLiteral("capture"));
    QTRY_VERIFY(studio.context->jobs().jobs().empty());
    shoot(*studio.window, QStringLiteral("capture-no-device"));
  }

  void capture_refused() {
    auto line = std::make_shared<FakeLine>();
    line->fail_open = true;
    StudioFixture studio(fake_services(line));
    open(studio, "portaudio:ALSA:card");
    shoot(*studio.window, QStringLiteral("capture-refused"));
  }

  void capture_live() {
    auto line = std::make_shared<FakeLine>();
    StudioFixture studio(fake_services(line));
    open(studio, "simulator:wave");
    shoot(*studio.window, QStringLiteral("capture-live-dark"));
    apply_theme(*qApp, ThemeKind::kLight);
    studio.context->selection().select(SelectionKind::kSensor, 2);
    shoot(*studio.window, QStringLiteral("capture-live-light"));
  }

  void capture_recording() {
    auto line = std::make_shared<FakeLine>();
    StudioFixture studio(fake_services(line));
    open(studio, "simulator:wave");
    auto* capture = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    capture->model().set_subject(QStringLiteral("Zoë"));
    capture->model().start_recording();
    QTRY_VERIFY(studio.context->live().recording());
    QTest::qWait(600);
    studio.context->markers().mark_now();
    studio.context->markers().mark_now(QStringLiteral("she turns around and walks back to the door"));
    shoot(*studio.window, QStringLiteral("capture-recording"));
  }

  void capture_with_errors() {
    auto line = std::make_shared<FakeLine>();
    line->level = 0.02;
    line->dead_sensor = 1;
    line->clipping_sensor = 3;
    line->disk_left_s = 200.0;
    line->diagnostics = {{Severity::kWarning, "line-in.low-level", "the left channel is weak, -34 dB",
                          "turn the recording volume up", "", 0.0}};
    StudioFixture studio(fake_services(line));
    open(studio, "portaudio:ALSA:card");
    studio.context->notifications().post(
        Severity::kError, QStringLiteral("walk-03.take cannot be opened: take.json is cut off at byte 212."),
        QStringLiteral("Run “limbwave recover walk-03.take”."));
    shoot(*studio.window, QStringLiteral("capture-errors"));
  }

  void capture_no_sync() {
    auto line = std::make_shared<FakeLine>();
    line->locked = false;
    StudioFixture studio(fake_services(line));
    open(studio, "portaudio:ALSA:card");
    shoot(*studio.window, QStringLiteral("capture-no-sync"));
    line->alive = false;
    QTRY_VERIFY(!studio.context->live().problem().isEmpty());
    shoot(*studio.window, QStringLiteral("capture-device-lost"));
  }

  void small_window() {
    auto line = std::make_shared<FakeLine>();
    StudioFixture studio(fake_services(line));
    open(studio, "simulator:wave");
    studio.window->resize(960, 600);
    shoot(*studio.window, QStringLiteral("capture-small"));
  }

  void job() {
    StudioFixture studio(fake_services(std::make_shared<FakeLine>()));
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    QTest::mouseClick(studio.window->findChild<QWidget*>(QStringLiteral("demo_reach")), Qt::LeftButton);
    QTest::qWait(1200);
    shoot(*studio.window, QStringLiteral("job"));
  }

  void german() {
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(LIMBWAVE_BINARY_DIR "/app/studio/limbwave_de.qm")));
    QApplication::installTranslator(&translator);
    {
      StudioFixture studio(fake_services(std::make_shared<FakeLine>()));
      auto* create = studio.window->findChild<QPushButton*>(QStringLiteral("welcome_new_take"));
      QCOMPARE(create->text(), QStringLiteral("Neuer Take"));
      shoot(*studio.window, QStringLiteral("welcome-german"));
      open(studio, "simulator:wave");
      shoot(*studio.window, QStringLiteral("capture-german"));
    }
    QApplication::removeTranslator(&translator);
  }

  void shortcuts() {
    ShortcutSheet sheet(shortcut_groups(studio_parts()), nullptr);
    sheet.show();
    shoot(sheet, QStringLiteral("shortcuts"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ScreenshotsTest)
#include "screenshots_test.moc"
