/// Recording in the Capture workspace, and what it says of signal, level, calibration and disk.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

#include "common/theme.h"
#include "plots/overview_view.h"
#include "plots/sensor_strips.h"
#include "ui/support/capture_fixture.h"
#include "workspaces/capture/capture_workspace.h"
#include "workspaces/status_strip.h"

namespace limbwave::ui::testing {

class CaptureTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void records_a_take_with_markers_by_keys() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(QTest::qWaitForWindowActive(capture.studio.window.get()));
    QVERIFY(choose(capture, "simulator:wave"));
    auto* subject = capture.find<QLineEdit>("subject_edit");
    subject->clear();
    QTest::keyClicks(subject, QStringLiteral("Ann Rem"));
    QVERIFY2(!capture.live().recording(), "letters typed into a field are no shortcuts");
    QCOMPARE(capture.find<QLineEdit>("take_name_edit")->text(), QStringLiteral("ann-rem-20261122-1"));
    capture.workspace->setFocus();
    QTest::keyClick(capture.workspace, Qt::Key_R);
    QTRY_VERIFY(capture.live().recording());
    QVERIFY(capture.studio.window->windowTitle().contains(QStringLiteral("Recording")));
    QTest::qWait(300);
    QTest::keyClick(capture.workspace, Qt::Key_M);
    QTest::mouseClick(capture.find<QPushButton>("marker_button"), Qt::LeftButton);
    QCOMPARE(capture.line->events.size(), std::size_t{2});
    QCOMPARE(capture.find<QTableWidget>("marker_list")->rowCount(), 2);
    QVERIFY(capture.find<QLabel>("record_time")->text() != QStringLiteral("0:00.0"));
    QVERIFY2(capture.find<QLabel>("record_time")->font().pixelSize() >= 48, "readable from two metres");
    QTest::keyClick(capture.workspace, Qt::Key_R);
    QTRY_VERIFY(capture.studio.context->document().is_open());
    QCOMPARE(capture.studio.context->document().name(), QStringLiteral("ann-rem-20261122-1"));
    QVERIFY(capture.studio.window->windowTitle().startsWith(QStringLiteral("ann-rem-20261122-1")));
    QCOMPARE(capture.find<QLineEdit>("take_name_edit")->text(), QStringLiteral("ann-rem-20261122-2"));
    QCOMPARE(capture.studio.context->recent_takes().folders().size(), 1);
  }

  void health_is_said_in_words_however_low_the_rows_are() {
    apply_theme(*qApp, ThemeKind::kLight);
    SensorStrips strips;
    const QStringList names{QStringLiteral("torso"), QStringLiteral("upper arm"), QStringLiteral("forearm"),
                            QStringLiteral("hand"), QStringLiteral("fingers")};
    strips.set_sensors(names);
    auto snapshot = std::make_shared<solve::LiveSnapshot>();
    snapshot->health.assign(5, {solve::HealthState::kWarning, "no-calibration", "works, but was never calibrated"});
    strips.set_snapshot(snapshot);
    const QColor warning = tone_color(strips.palette(), Tone::kWarning);
    const auto is_ink = [&](const QColor& c) {
      return std::abs(c.red() - warning.red()) + std::abs(c.green() - warning.green()) +
                 std::abs(c.blue() - warning.blue()) <
             90;
    };
    for (const int row : {27, 31, 36, 40, 60}) {
      strips.resize(800, 38 + 5 * (row + 6));
      const QImage image = strips.grab().toImage();
      const double scale = image.devicePixelRatio();
      int ink = 0, lowest = 0;
      const int top = 20, bottom = top + row;  // The first card, without its symbol at the right.
      for (int y = 0; y < static_cast<int>((bottom + 3) * scale); ++y) {
        for (int x = static_cast<int>(12 * scale); x < static_cast<int>(186 * scale); ++x) {
          if (is_ink(image.pixelColor(x, y))) {
            ++ink;
            lowest = std::max(lowest, y);
          }
        }
      }
      QVERIFY2(ink > 40, qPrintable(QStringLiteral("%1 pixels at %2").arg(ink).arg(row)));
      QVERIFY2(lowest < (bottom - 1) * scale, qPrintable(QString::number(row)));
    }
    apply_theme(*qApp, ThemeKind::kDark);
  }

  void done_with_a_name_keys_are_commands_again() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(QTest::qWaitForWindowActive(capture.studio.window.get()));
    QVERIFY(choose(capture, "simulator:wave"));
    auto* name = capture.find<QLineEdit>("take_name_edit");
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
      name->setFocus();
      QTRY_VERIFY(name->hasFocus());
      QTest::keyClick(name, key);
      QVERIFY(!name->hasFocus());
    }
  }

  void a_name_that_is_taken_is_refused_where_it_is_typed() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    QDir().mkpath(capture.studio.context->takes_folder() + QStringLiteral("/walk.take"));
    auto* name = capture.find<QLineEdit>("take_name_edit");
    name->clear();
    QTest::keyClicks(name, QStringLiteral("walk"));
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(capture.find<QLabel>("take_name_problem")->isVisible());
    QTest::keyClicks(name, QStringLiteral("2"));
    QVERIFY(capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(!capture.find<QLabel>("take_name_problem")->isVisible());
  }

  void a_full_disk_is_told_and_nothing_records() {
    auto line = std::make_shared<FakeLine>();
    line->fail_recording = true;
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
    QTRY_VERIFY(!capture.studio.context->notifications().all().empty());
    QVERIFY(capture.studio.context->notifications().all().front().text.contains(QStringLiteral("no space left")));
    QVERIFY(!capture.live().recording());
  }

  void unplugging_keeps_what_was_recorded() {
    auto line = std::make_shared<FakeLine>();
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
    QTRY_VERIFY(capture.live().recording());
    line->alive = false;
    QTRY_VERIFY(capture.studio.context->document().is_open());
    QVERIFY(!capture.live().recording());
    QVERIFY(!capture.live().problem().isEmpty());
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
    // Plugged in again and chosen once more, as it says.
    QTRY_VERIFY(!capture.live().finishing());
    line->alive = true;
    QCOMPARE(line->opened, 1);
    auto* box = capture.find<QComboBox>("device_box");
    Q_EMIT box->activated(box->findData(QStringLiteral("simulator:wave")));
    QTRY_COMPARE(line->opened, 2);
    QTRY_VERIFY(capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(capture.live().problem().isEmpty());
  }

  void a_take_has_its_wearers_mountings_and_nobody_elses() {
    auto line = std::make_shared<FakeLine>();
    line->mounted = {{"Anna", "2026-03-01T10:00:00Z"}, {"Ben", "2026-04-01T10:00:00Z"}};
    Capture capture(line);
    capture.studio.context->set_wearer(QStringLiteral("Anna"));
    QVERIFY(choose(capture, "simulator:wave"));
    QCOMPARE(capture.live().settings().calibration.mounts[0].date, std::string("2026-03-01T10:00:00Z"));
    const auto record = [&](const QString& name) {
      auto* subject = capture.find<QLineEdit>("subject_edit");
      subject->selectAll();
      QTest::keyClicks(subject, name);
      // At once: nothing has been read yet.
      QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
      QTRY_VERIFY(capture.live().recording());
      QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
      QTRY_VERIFY(capture.studio.context->document().is_open() &&
                  capture.studio.context->document().take()->info.subject == name.toStdString());
    };
    record(QStringLiteral("Zoe"));
    QCOMPARE(capture.studio.context->document().take()->info.calibration->mounts[0].method, std::string("nominal"));
    record(QStringLiteral("Ben"));
    QCOMPARE(capture.studio.context->document().take()->info.calibration->mounts[0].date,
             std::string("2026-04-01T10:00:00Z"));
    // Typed elsewhere, such as in the wizard, it is the same person; and the figure follows without recording.
    capture.studio.context->set_wearer(QStringLiteral("Anna"));
    QCOMPARE(capture.find<QLineEdit>("subject_edit")->text(), QStringLiteral("Anna"));
    QTRY_COMPARE(capture.live().settings().calibration.mounts[0].date, std::string("2026-03-01T10:00:00Z"));
  }

  void the_calibration_of_the_next_take_is_told_before_it_is_recorded() {
    auto line = std::make_shared<FakeLine>();
    line->mounted = {{"Anna", "2026-03-01T10:00:00Z"}};
    Capture capture(line);
    capture.studio.context->set_wearer(QStringLiteral("Anna"));
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    auto* told = capture.find<QLabel>("calibration_in_use");
    QTRY_VERIFY(told->isVisible());
    QVERIFY2(told->text().startsWith(QStringLiteral("Range never calibrated. Mounting on Anna, ")),
             qPrintable(told->text()));
    QVERIFY(told->text().contains(QStringLiteral("href")));
    capture.studio.context->set_wearer(QStringLiteral("Zoe"));
    QTRY_VERIFY(told->text().contains(QStringLiteral("Mounting on Zoe not calibrated.")));
    QVERIFY(capture.studio.window->grab().save(screenshot_path(QStringLiteral("capture-calibration"))));
  }

  void the_raw_signals_of_a_calibration_are_nobodys_take() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    const std::filesystem::path folder = capture.studio.folder.filePath(QStringLiteral("aside.take")).toStdString();
    QVERIFY(capture.live().start_recording(folder, {}, true));
    QTRY_VERIFY(capture.live().recording());
    QTest::qWait(100);
    QVERIFY(!capture.find<OverviewView>("overview")->isVisible());
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(!capture.studio.window->windowTitle().contains(QStringLiteral("Recording")));
    const auto facts = capture.studio.window->findChildren<StatusButton*>();
    QVERIFY(std::any_of(facts.begin(), facts.end(), [](const StatusButton* button) {
      return button->fact().text == QStringLiteral("calibrating");
    }));
    capture.workspace->model().toggle_recording();
    QVERIFY2(capture.live().recording(), "R in Capture is for takes");
    capture.live().stop_recording();
    QTRY_VERIFY(!capture.live().finishing());
    QVERIFY(!capture.studio.context->document().is_open());
    QTRY_VERIFY(capture.find<QPushButton>("record_button")->isEnabled());
  }

  void another_folder_suggests_another_name() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    const QString name = capture.workspace->model().take_name();
    const QString other = capture.studio.context->takes_folder() + QStringLiteral("/other");
    QDir().mkpath(other + QLatin1Char('/') + name + QStringLiteral(".take"));
    capture.studio.context->set_takes_folder(other);
    capture.workspace->model().suggest_name();
    QVERIFY(capture.workspace->model().take_name() != name);
    QVERIFY(capture.workspace->model().can_record());
  }

  void level_check_speaks() {
    auto line = std::make_shared<FakeLine>();
    line->level = 0.01;
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    QTRY_COMPARE(capture.find<QLabel>("level_advice")->text(), QStringLiteral("Too low"));
    line->level = 0.4;
    QTRY_COMPARE(capture.find<QLabel>("level_advice")->text(), QStringLiteral("Level is good"));
  }

  void a_click_on_a_fact_leads_to_the_cause() {
    auto line = std::make_shared<FakeLine>();
    line->dead_sensor = 3;
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    capture.studio.window->show_workspace(QStringLiteral("welcome"));
    StatusButton* sensors = nullptr;
    QTRY_VERIFY([&] {
      for (auto* button : capture.studio.window->findChildren<StatusButton*>()) {
        if (button->fact().topic == QStringLiteral("sensor:3")) {
          sensors = button;
        }
      }
      return sensors != nullptr;
    }());
    QTest::mouseClick(sensors, Qt::LeftButton);
    QCOMPARE(capture.studio.window->current_workspace(), QStringLiteral("capture"));
    QCOMPARE(capture.studio.context->selection().index_of(SelectionKind::kSensor), 3);
  }

  void every_control_has_a_name() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    for (const QWidget* widget : capture.studio.window->findChildren<QWidget*>()) {
      if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible() || widget->inherits("QScrollArea") ||
          widget->inherits("QSplitter") || widget->inherits("QMainWindow") ||
          widget->inherits("limbwave::ui::Workspace") || widget->objectName().startsWith(QStringLiteral("qt_"))) {
        continue;
      }
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      const bool named = !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
      QVERIFY2(named,
               qPrintable(QStringLiteral("%1 “%2” has no accessible name")
                              .arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName())));
    }
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CaptureTest)
#include "capture_test.moc"
