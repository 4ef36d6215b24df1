/// A driver box in the real studio: the emulator on a pseudo-terminal, chosen, watched, recorded and seen moving, by
/// the widgets that people use.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <fstream>

#include "common/core_services.h"
#include "common/theme.h"
#include "plots/wire_view.h"
#include "simulate/simulate.h"
#include "solve/live_body_session.h"
#include "support/child_process.h"
#include "support/temporary_folder.h"
#include "ui/support/studio_fixture.h"
#include "viewer/viewer_widget.h"
#include "workspaces/capture/capture_workspace.h"
#include "workspaces/take_actions.h"

namespace limbwave::ui::testing {

class DriverBoxCaptureTest : public QObject {
  Q_OBJECT

 private:
  static void shoot(QWidget& widget, const QString& name) {
    QTest::qWait(100);
    QVERIFY(widget.grab().toImage().save(screenshot_path(name)));
  }
  // The screen as it is: what draws with its own hands is not in a widget's picture.
  static void shoot_screen(QWidget& widget, const QString& name) {
    QTest::qWait(300);
    QVERIFY(widget.screen()->grabWindow(widget.winId()).save(screenshot_path(name)));
  }
  template <typename T>
  static T* find(StudioFixture& studio, const char* name) {
    return studio.window->findChild<T*>(QLatin1String(name));
  }
  static void choose(QComboBox* box, const QString& id) {
    const int index = box->findData(id);
    QVERIFY2(index >= 0, qPrintable(id));
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
  }
  // Slower than a real box, so that a busy machine keeps up.
  std::unique_ptr<test::ChildProcess> start_box(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{LIMBWAVE_EMULATOR, "--take", (folder_.path() / "walk.take").string(), "--speed",
                                       "0.25"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::make_unique<test::ChildProcess>(arguments, std::map<std::string, std::string>{},
                                                folder_.path() / "emulator.txt");
  }

  test::TemporaryFolder folder_;

 private Q_SLOTS:
  void initTestCase() {
    apply_theme(*qApp, ThemeKind::kDark);
    qputenv("LIMBWAVE_HOME", QByteArray::fromStdString((folder_.path() / "home").string()));
    simulate::SimulateSettings settings;
    settings.rig = "driver-box-body";
    settings.motion = "walk";
    settings.errors_name = "calibrated";
    settings.seconds = 8.0;
    const Status made = simulate::simulate_take(folder_.path() / "walk.take", settings, {});
    QVERIFY2(made.ok(), made.ok() ? "" : made.error().text().c_str());
  }

  void an_emulator_is_found_watched_recorded_and_seen() {
    const auto emulator = start_box({});
    StudioFixture studio(core_services());
    studio.window->show_workspace(QStringLiteral("capture"));
    auto* capture = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    QVERIFY(capture != nullptr);
    LiveModel& live = studio.context->live();
    auto* devices = find<QComboBox>(studio, "device_box");
    const QString id = QStringLiteral("driver-box:") +
                       QString::fromStdString((folder_.path() / "home" / "emulators").string()) + QLatin1Char('/') +
                       QString::number(emulator->id());
    for (int i = 0; i < 100 && devices->findData(id) < 0; ++i) {
      QTest::mouseClick(find<QToolButton>(studio, "refresh_devices"), Qt::LeftButton);
      QTest::qWait(500);
    }
    choose(devices, id);
    QTRY_VERIFY_WITH_TIMEOUT(live.running() || !live.problem().isEmpty(), 60000);
    QVERIFY2(live.running(), qPrintable(live.problem()));

    // The rig became a driver box's by itself, and only such can be chosen.
    auto* rigs = find<QComboBox>(studio, "rig_box");
    QCOMPARE(rigs->currentData().toString(), QStringLiteral("driver-box-body"));
    QCOMPARE(rigs->findData(QStringLiteral("line-in-arm")), -1);

    // Wires: levels, locks and words of all eighteen.
    auto* wires = find<WireView>(studio, "wire_view");
    QVERIFY(wires != nullptr);
    const auto box = [&live] { return live.snapshot() ? live.snapshot()->box : nullptr; };
    QTRY_VERIFY_WITH_TIMEOUT(box() && box()->wires.size() == 18, 60000);
    QTRY_VERIFY_WITH_TIMEOUT(std::all_of(box()->wires.begin(), box()->wires.end(),
                                         [](const solve::BoxWire& wire) {
                                           return wire.locked && wire.level > 0.0 && wire.words_hz > 130.0;
                                         }),
                             120000);
    QVERIFY(wires->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(box()->poses > 30, 180000);
    QVERIFY(box()->error.empty());
    QVERIFY2(find<QLabel>(studio, "box_state")->text().contains(QStringLiteral("poses")),
             qPrintable(find<QLabel>(studio, "box_state")->text()));
    QCOMPARE(wires->accessibleDescription(), QStringLiteral("All wires are well."));
    // A row is a sensor: chosen here, it is chosen everywhere.
    QTest::mouseClick(wires, Qt::LeftButton, {}, QPoint(60, 24 + 3));
    QCOMPARE(studio.context->selection().index_of(SelectionKind::kSensor), 0);
    QTest::keyClick(wires, Qt::Key_Down);
    QCOMPARE(studio.context->selection().index_of(SelectionKind::kSensor), 1);
    shoot(*studio.window, QStringLiteral("driver-box-capture"));

    // Recorded, with a marker.
    QTest::mouseClick(find<QPushButton>(studio, "record_button"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(live.recording(), 20000);
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->recorded_s > 0.5, 60000);
    QVERIFY(studio.context->markers().mark_now(QStringLiteral("turn")));
    QVERIFY(!find<QDoubleSpinBox>(studio, "box_temperature")->isEnabled());

    // And the figure moves in the viewer while it is.
    studio.window->show_workspace(QStringLiteral("solve"));
    auto* viewer = studio.window->findChild<ViewerWidget*>();
    QVERIFY(viewer != nullptr);
    QSignalSpy frames(viewer, &ViewerWidget::frame_rendered);
    const std::uint64_t first = live.figure()->number;
    const std::vector<body::SegmentPose> pose = live.figure()->pose;
    QTRY_VERIFY_WITH_TIMEOUT(live.figure()->number > first + 30 && frames.size() > 10, 120000);
    double moved = 0.0;
    for (std::size_t s = 0; s < pose.size(); ++s) {
      moved = std::max(moved, pose[s].R_WL.angularDistance(live.figure()->pose[s].R_WL));
    }
    QVERIFY2(moved > 0.05, "somebody walks");
    QTRY_VERIFY_WITH_TIMEOUT(live.latency().poses > 10, 60000);
    QVERIFY2(live.latency().of(solve::LatencyStage::kTotal).mean_s > 0.0, "told as for a sound card");
    shoot_screen(*studio.window, QStringLiteral("driver-box-live"));
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->recorded_s > 2.0, 60000);
    capture->model().stop_recording();
    QTRY_VERIFY_WITH_TIMEOUT(studio.context->document().is_open(), 60000);
    const auto take = studio.context->document().take();
    QCOMPARE(take->info.kind, std::string("driver-box"));
    QVERIFY(take->info.complete);
    QVERIFY(take->info.frames > 2 * 140000);
    QVERIFY(std::any_of(take->events.begin(), take->events.end(),
                        [](const take::TakeEvent& event) { return event.text == "turn"; }));
    QVERIFY2(live.running(), "capture goes on");
  }

  void a_port_that_is_typed_stays_in_the_list_and_faults_are_seen() {
    const QString link = QString::fromStdString((folder_.path() / "mybox").string());
    // In the box's own time, from its first start on.
    const std::filesystem::path faults = folder_.path() / "faults";
    { std::ofstream(faults) << "8.0 pull 5\n12.0 unplug 2.0\n"; }
    const auto emulator = start_box({"--link", link.toStdString(), "--faults", faults.string()});
    StudioFixture studio(core_services());
    studio.window->show_workspace(QStringLiteral("capture"));
    LiveModel& live = studio.context->live();
    auto* devices = find<QComboBox>(studio, "device_box");
    QTRY_VERIFY_WITH_TIMEOUT(devices->findData(QStringLiteral("other-port")) > 0 && QFile::exists(link), 60000);
    choose(devices, QStringLiteral("other-port"));
    auto* dialog = find<QInputDialog>(studio, "port_dialog");
    QTRY_VERIFY(dialog != nullptr && dialog->isVisible());
    dialog->setTextValue(link);
    dialog->accept();
    QTRY_VERIFY_WITH_TIMEOUT(live.running(), 60000);
    QCOMPARE(devices->currentData().toString(), QStringLiteral("driver-box:") + link);
    auto* wires = find<WireView>(studio, "wire_view");
    // A wire is pulled: the row says so, and the status strip.
    QTRY_VERIFY_WITH_TIMEOUT(wires->accessibleDescription().contains(QStringLiteral("pulled out")), 120000);
    shoot(*studio.window, QStringLiteral("driver-box-wire-pulled"));
    // The line goes, and is taken back by itself.
    QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>(studio, "box_state")->text().contains(QStringLiteral("away")), 120000);
    shoot(*studio.window, QStringLiteral("driver-box-away"));
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->box->connected && live.snapshot()->box->counters.reconnects == 1, 120000);
    QVERIFY(live.running());
    // Another air is another speed of sound: the box is opened anew, and undo takes it back.
    auto* temperature = find<QDoubleSpinBox>(studio, "box_temperature");
    temperature->setValue(27.5);
    QCOMPARE(studio.context->undo_stack().undoText(), QStringLiteral("format"));
    QTRY_VERIFY_WITH_TIMEOUT(live.running() && live.snapshot() && live.snapshot()->box, 60000);
    studio.context->undo_stack().undo();
    QTRY_COMPARE(temperature->value(), 22.0);
    QTRY_VERIFY_WITH_TIMEOUT(live.running(), 60000);
    // Looked for again, it is still there, and the simulator is still last.
    QTest::mouseClick(find<QToolButton>(studio, "refresh_devices"), Qt::LeftButton);
    QTRY_VERIFY(devices->findData(QStringLiteral("driver-box:") + link) > 0);
  }

  void a_port_without_a_box_says_so() {
    StudioFixture studio(core_services());
    studio.window->show_workspace(QStringLiteral("capture"));
    auto* capture = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    QTRY_VERIFY_WITH_TIMEOUT(!capture->model().devices().empty(), 60000);
    capture->model().open_box_port(QStringLiteral("/dev/nothing-there"));
    LiveModel& live = studio.context->live();
    QTRY_VERIFY_WITH_TIMEOUT(live.state() == LiveState::kOff && !live.problem().isEmpty(), 60000);
    shoot(*studio.window, QStringLiteral("driver-box-none"));
    // A sound card or simulator takes its own rig back.
    auto* devices = find<QComboBox>(studio, "device_box");
    choose(devices, QStringLiteral("simulator:wave"));
    QTRY_VERIFY_WITH_TIMEOUT(live.running(), 60000);
    QCOMPARE(find<QComboBox>(studio, "rig_box")->currentData().toString(), QStringLiteral("line-in-arm"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::DriverBoxCaptureTest)
#include "driver_box_capture_test.moc"
