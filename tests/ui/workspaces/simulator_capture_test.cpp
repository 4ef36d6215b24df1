/// The whole way with nothing made up: the simulator as a device, the real session, the real recorder.
#include <QLabel>
#include <QTest>

#include "common/core_services.h"
#include "common/theme.h"
#include "take/markers.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/capture/capture_workspace.h"
#include "workspaces/capture/overview_panel.h"
#include "workspaces/solve/live_headings.h"
#include "workspaces/solve/solve_model.h"
#include "workspaces/take_actions.h"

namespace limbwave::ui::testing {

/// The simulator only: this machine's sound cards are not part of this test.
inline StudioServices simulator_services() {
  StudioServices services = core_services();
  services.list_devices = []() -> Result<std::vector<acquire::DeviceInfo>> {
    acquire::DeviceInfo device;
    device.id = "simulator:wave";
    device.title = "Simulator: wave";
    device.channels = 2;
    device.rates_hz = {48000.0, 96000.0};
    device.types = {acquire::SampleType::kInt16, acquire::SampleType::kInt24};
    return std::vector<acquire::DeviceInfo>{device};
  };
  return services;
}

class SimulatorCaptureTest : public QObject {
  Q_OBJECT
 private:
  static void shoot(QWidget& widget, const QString& name) {
    QTest::qWait(100);
    QVERIFY(widget.grab().toImage().save(screenshot_path(name)));
  }

  /// Markers as any program reads them from disk: "0.25 jump".
  static QStringList in_take(const std::filesystem::path& folder) {
    QStringList list;
    const Result<take::Take> take = take::open_take(folder);
    for (std::size_t i = 0; take && i < take->events.size(); ++i) {
      const take::TakeEvent& event = take->events[i];
      if (take::is_marker(event)) {
        list << QStringLiteral("%1 %2")
                    .arg(take->info.format.rate.seconds(event.sample).value)
                    .arg(QString::fromStdString(event.text));
      }
    }
    return list;
  }

 private Q_SLOTS:
  void initTestCase() { apply_theme(*qApp, ThemeKind::kDark); }

  void records_two_seconds_and_opens_the_take() {
    StudioFixture studio(simulator_services());
    studio.window->show_workspace(QStringLiteral("capture"));
    auto* capture = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    QVERIFY(capture != nullptr);
    LiveModel& live = studio.context->live();
    QTRY_VERIFY(!capture->model().devices().empty());
    capture->model().open_device(QStringLiteral("simulator:wave"));
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot() && live.snapshot()->line.locked, 20000);
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->frames.size() > 60, 20000);
    QCOMPARE(live.snapshot()->health.size(), std::size_t{5});
    QVERIFY(live.snapshot()->scope.size() > 1000);
    QVERIFY(!live.snapshot()->scope_cycles.empty());
    capture->model().set_subject(QStringLiteral("Ann"));
    capture->model().start_recording();
    QTRY_VERIFY(live.recording());
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->recorded_s >= 1.0, 20000);
    MarkerModel& markers = studio.context->markers();
    QVERIFY(markers.mark_now(QStringLiteral("here")));
    QVERIFY(markers.mark_now(QStringLiteral("by mistake")));
    QVERIFY(markers.rename(1, QStringLiteral("there")));
    QVERIFY(markers.move(1, 0.25));
    QVERIFY(markers.remove(2));
    // What would be left if the program died now.
    const std::filesystem::path growing = live.recording_folder();
    QTRY_VERIFY_WITH_TIMEOUT(in_take(growing) == QStringList{QStringLiteral("0.25 there")}, 20000);
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->recorded_s >= 2.0, 20000);
    auto* overview = capture->findChild<OverviewPanel*>();
    QVERIFY2(overview->isVisible() && overview->view().visible_end_s() > 1.5, "the recording is seen while it grows");
    shoot(*studio.window, QStringLiteral("simulator-recording"));
    capture->model().stop_recording();
    QTRY_VERIFY_WITH_TIMEOUT(studio.context->document().is_open(), 20000);
    const auto take = studio.context->document().take();
    QVERIFY(take->info.complete);
    QCOMPARE(QString::fromStdString(take->info.subject), QStringLiteral("Ann"));
    QVERIFY(static_cast<double>(take->info.frames) / take->info.format.rate.hz >= 2.0);
    // What the window shows is what is on disk.
    const Result<take::Take> again = take::open_take(take->folder);
    QVERIFY(again.ok());
    QCOMPARE(again->info.frames, take->info.frames);
    QCOMPARE(markers.markers().size(), std::size_t{1});
    QCOMPARE(in_take(take->folder), QStringList{QStringLiteral("0.25 there")});
    studio.context->undo_stack().undo();  // The deletion, after the recording.
    studio.context->saves().finish();
    QCOMPARE(in_take(take->folder).size(), 2);
    studio.context->undo_stack().redo();
    studio.context->saves().finish();
    QCOMPARE(in_take(take->folder).size(), 1);
    QTRY_VERIFY(overview->view().visible_end_s() > 1.9);
    shoot(*studio.window, QStringLiteral("simulator-recorded"));
  }

  void a_chosen_format_is_what_is_recorded_and_is_remembered() {
    StudioFixture studio(simulator_services());
    studio.window->show_workspace(QStringLiteral("capture"));
    auto* capture = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    LiveModel& live = studio.context->live();
    QTRY_VERIFY(!capture->model().devices().empty());
    capture->model().open_device(QStringLiteral("simulator:wave"));
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot() && live.snapshot()->format.rate.hz == 48000.0, 20000);
    DeviceSetup setup;
    setup.rate_hz = 96000.0;
    setup.type = acquire::SampleType::kInt24;
    capture->model().set_device_setup(setup);
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot() && live.snapshot()->format.rate.hz == 96000.0, 20000);
    QCOMPARE(live.snapshot()->format.type, acquire::SampleType::kInt24);
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->line.locked, 20000);
    capture->model().open_device({});
    capture->model().open_device(QStringLiteral("simulator:wave"));
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot() && live.snapshot()->format.rate.hz == 96000.0, 20000);
  }

  void a_turn_of_the_live_figure_reaches_the_session_and_the_take() {
    StudioFixture studio(simulator_services());
    SolveModel& solving = SolveModel::of(*studio.context);
    LiveHeadings& headings = LiveHeadings::of(*studio.context);
    LiveModel& live = studio.context->live();
    QVERIFY(live.open(QStringLiteral("simulator:wave"), QStringLiteral("Simulator"), "line-in-arm", {}));
    QTRY_VERIFY_WITH_TIMEOUT(live.figure() != nullptr, 30000);
    // The torso stands nearly still: what turns it is the user.
    const auto torso = [&live] { return live.figure()->pose.front().R_WL; };
    const auto turned = [&](const Eigen::Quaterniond& from, double angle) {
      const Eigen::Quaterniond wanted(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * from);
      return torso().angularDistance(wanted) < 0.1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(live.figure()->number > 120, 30000);  // The filter has settled.
    const Eigen::Quaterniond before = torso();
    QVERIFY(headings.set(0, 1.0));
    QTRY_VERIFY_WITH_TIMEOUT(turned(before, 1.0), 20000);
    studio.context->undo_stack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(turned(before, 0.0), 20000);
    studio.context->undo_stack().redo();
    QVERIFY(live.start_recording(studio.context->takes_folder().toStdString() + "/turned.take", {}));
    QTRY_VERIFY(live.recording());
    QTRY_VERIFY_WITH_TIMEOUT(live.snapshot()->recorded_s >= 2.0, 20000);
    live.stop_recording();
    QTRY_VERIFY_WITH_TIMEOUT(studio.context->document().is_open(), 20000);
    QTRY_COMPARE_WITH_TIMEOUT(solving.state(), SolveState::kSolved, 60000);
    QCOMPARE(solving.keys().keys(0).size(), std::size_t{1});
    QCOMPARE(solving.solve()->settings.headings.front().front().heading, 1.0);
    std::vector<body::SegmentPose> solved;
    solving.pose_at(1.0, solved);
    const Eigen::Quaterniond wanted(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()) * before);
    QVERIFY2(solved.front().R_WL.angularDistance(wanted) < 0.1, "the take shows what was seen live");
  }

  void a_demo_take_is_simulated_and_shown() {
    StudioFixture studio(simulator_services());
    studio.window->take_actions().open_demo(QStringLiteral("wave"));
    QTRY_VERIFY_WITH_TIMEOUT(studio.context->document().is_open(), 120000);
    QVERIFY(studio.window->show_workspace(QStringLiteral("capture")));
    auto* overview = studio.window->findChild<OverviewPanel*>();
    QTRY_VERIFY(overview->view().visible_end_s() > 1.0);
    shoot(*studio.window, QStringLiteral("demo-in-capture"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::SimulatorCaptureTest)
#include "simulator_capture_test.moc"
