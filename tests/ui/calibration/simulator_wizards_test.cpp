/// Both wizards to the end with nothing made up but the person: the simulator as a live device in real time, the real
/// session, recorder, library. A wearer who does it well, one who does it badly, and a device that dies half-way.
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <numbers>

#include "common/core_services.h"
#include "common/theme.h"
#include "simulate/simulate.h"
#include "simulate/wearer.h"
#include "solve/take_calibration.h"
#include "take/take.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/calibrate_workspace.h"

namespace limbwave::ui::testing {

/// The simulator, which can be unplugged.
class PullablePlug : public acquire::LiveSource {
 public:
  PullablePlug(std::unique_ptr<acquire::LiveSource> source, std::shared_ptr<std::atomic<bool>> pulled)
      : source_(std::move(source)), pulled_(std::move(pulled)) {}
  [[nodiscard]] acquire::StreamFormat format() const override { return source_->format(); }
  [[nodiscard]] std::string title() const override { return source_->title(); }
  Status start() override { return source_->start(); }
  void stop() override { source_->stop(); }
  std::size_t pull(std::span<std::byte> out) override { return *pulled_ ? 0 : source_->pull(out); }
  [[nodiscard]] acquire::SourceCounters counters() const override { return source_->counters(); }
  [[nodiscard]] bool alive() const override { return !*pulled_ && source_->alive(); }
  [[nodiscard]] double device_latency_s() const override { return source_->device_latency_s(); }
  [[nodiscard]] double newest_frame_time_s() const override { return source_->newest_frame_time_s(); }

 private:
  std::unique_ptr<acquire::LiveSource> source_;
  std::shared_ptr<std::atomic<bool>> pulled_;
};

/// Calibrate in a real window over the simulator.
struct Bench {
  Bench() : Bench(StudioServices()) {}
  explicit Bench(const StudioServices& own) : studio(own.open_device ? own : services(), parts()) {
    studio.context->settings().setValue(QStringLiteral("capture/subject"), QStringLiteral("Ada"));
    studio.window->show_workspace(QStringLiteral("calibrate"));
    workspace = dynamic_cast<CalibrateWorkspace*>(studio.window->workspace(QStringLiteral("calibrate")));
  }
  StudioServices services() {
    StudioServices made = core_services();
    made.open_device = [this](const std::string& motion, const DeviceSetup&,
                              const std::string& rig) -> Result<std::unique_ptr<acquire::LiveSource>> {
      auto source = simulate::open_simulator(settings(motion, rig));
      if (!source) {
        return source.error();
      }
      return std::unique_ptr<acquire::LiveSource>(std::make_unique<PullablePlug>(std::move(source).value(), pulled));
    };
    return made;
  }
  [[nodiscard]] simulate::SimulateSettings settings(const std::string& motion, const std::string& rig) const {
    simulate::SimulateSettings wanted;
    wanted.motion = motion;
    wanted.rig = rig;
    wanted.prologue = false;
    wanted.errors = simulate::load_errors("paper").value();
    wanted.errors.pose_angle = pose_angle;
    return wanted;
  }
  StudioParts parts() {
    StudioParts made;
    WorkspaceEntry entry = calibrate_entry();
    entry.create = [this](StudioContext& context, QWidget* parent) -> Workspace* {
      return new CalibrateWorkspace(
          context, take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString()), nullptr, parent);
    };
    made.workspaces.push_back(entry);
    return made;
  }
  /// The person does this from now on.
  bool wears(const std::string& motion) {
    *pulled = false;
    LiveModel& live = studio.context->live();
    live.open(QString::fromStdString(motion), QStringLiteral("Simulator"), "line-in-arm", QStringLiteral("Ada"));
    return QTest::qWaitFor([&live] { return live.snapshot() && live.snapshot()->frames.size() > 30; }, 60000);
  }
  [[nodiscard]] double stream_s() const { return studio.context->live().snapshot()->stream_time_s; }
  QPushButton* button(const char* name) {
    const auto all = workspace->findChildren<QPushButton*>(QLatin1String(name));
    for (QPushButton* candidate : all) {
      if (candidate->isVisible()) {
        return candidate;
      }
    }
    return nullptr;
  }
  void click(const char* name) {
    QPushButton* found = button(name);
    QVERIFY2(found != nullptr, name);
    QVERIFY2(found->isEnabled(), qPrintable(QLatin1String(name) + QStringLiteral(": ") + found->toolTip()));
    QTest::mouseClick(found, Qt::LeftButton);
  }
  QString label(const char* name) {
    const auto all = workspace->findChildren<QLabel*>(QLatin1String(name));
    for (QLabel* candidate : all) {
      if (candidate->isVisible()) {
        return candidate->text();
      }
    }
    return {};
  }
  /// To the page on which sensors are turned.
  void begin_turning() {
    click("calibrate_range");
    click("next");
    click("next");
  }
  /// To the countdown of the first pose of a group of the rig.
  void begin_poses(int group, double countdown_s) {
    click("calibrate_mounting");
    workspace->limb_model().choose_group(group);
    workspace->limb_model().set_countdown_s(countdown_s);
    click("next");
    click("next");
  }
  /// Turns all sensors until each has enough.
  void turn_to_the_end() {
    begin_turning();
    QTRY_VERIFY_WITH_TIMEOUT(workspace->range_model().all_enough(), 240000);
    click("next");
    QTRY_VERIFY_WITH_TIMEOUT(button("accept_0") != nullptr, 60000);
  }
  /// Begins to hold a pose when the simulated wearer does; the script loops, so that a moment missed comes again.
  void hold(const std::string& name) {
    const auto rig = body::load_rig("line-in-arm").value();
    const auto skeleton = body::load_skeleton(rig.skeleton).value();
    const auto wearer = simulate::Wearer::create(settings("poses", "line-in-arm"), rig, skeleton).value();
    const double loop_s = wearer->duration();
    double begin_s = -1.0;
    for (const simulate::ScriptSegment& segment : wearer->segments()) {
      begin_s = segment.name == name ? segment.start_s : begin_s;
    }
    QVERIFY2(begin_s >= 0.0, name.c_str());
    LimbWizardModel& model = workspace->limb_model();
    const int pose = model.pose();
    model.set_countdown_s(30.0);
    const auto into_pose = [&] { return std::fmod(stream_s() - begin_s + 10.0 * loop_s, loop_s); };
    QTRY_VERIFY_WITH_TIMEOUT(into_pose() > 0.05 && into_pose() < 0.7, 120000);
    workspace->limb_wizard()->frame()->next_button()->click();  // "Skip the wait"
    QCOMPARE(model.page(), LimbPage::kHold);
    QTRY_VERIFY_WITH_TIMEOUT(model.page() != LimbPage::kHold || model.pose() != pose, 20000);
  }
  void hold_both(int group) {
    const auto rig = body::load_rig("line-in-arm").value();
    const body::CalibrationGroup& limb = rig.groups.at(static_cast<std::size_t>(group));
    for (const int pose : {0, 1}) {
      // The countdown may run out at a wrong moment; it was made long enough for one loop of the script.
      QTRY_COMPARE(workspace->limb_model().page(), LimbPage::kCountdown);
      QCOMPARE(workspace->limb_model().pose(), pose);
      hold(solve::pose_segment(limb, pose));
    }
    QTRY_VERIFY_WITH_TIMEOUT(workspace->limb_model().page() == LimbPage::kResult, 60000);
  }

  std::shared_ptr<std::atomic<bool>> pulled = std::make_shared<std::atomic<bool>>(false);
  double pose_angle = 0.0;
  QTemporaryDir folder;
  StudioFixture studio;
  CalibrateWorkspace* workspace = nullptr;
};

class SimulatorWizardsTest : public QObject {
  Q_OBJECT
 private:
  static void shoot(Bench& bench, const QString& name) {
    QTest::qWait(60);
    QVERIFY(bench.studio.window->grab().toImage().save(screenshot_path(QStringLiteral("calibrate-live-") + name)));
  }
  /// The stretches that the calibration's own take has.
  static QStringList segments_of(const std::filesystem::path& folder) {
    QStringList names;
    if (const Result<take::Take> take = take::open_take(folder); take) {
      for (const take::TakeSegment& segment : take->info.segments) {
        names << QString::fromStdString(segment.name);
      }
    }
    return names;
  }

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }

  void a_good_wearer_gets_good_verdicts_that_last() {
    Bench bench;
    QVERIFY(bench.wears("range"));
    QSignalSpy cues(&bench.workspace->range_wizard()->sounds(), &CueSounds::played);
    bench.turn_to_the_end();
    QVERIFY2(!cues.empty(), "enough turning is heard");
    shoot(bench, QStringLiteral("range-verdict"));
    QCOMPARE(bench.label("summary"), QStringLiteral("5 sensors calibrated"));
    for (const RangeOutcome& outcome : bench.workspace->range_model().outcomes()) {
      QVERIFY(outcome.result.has_value());
      QVERIFY2(outcome.result->calibration.residual_g < 0.01, qPrintable(QString::number(outcome.sensor)));
    }
    const std::filesystem::path recorded = bench.workspace->desk().recording_folder();
    bench.click("next");
    QTRY_VERIFY_WITH_TIMEOUT(bench.button("calibrate_mounting") != nullptr, 30000);
    QTRY_COMPARE_WITH_TIMEOUT(segments_of(recorded), QStringList{QStringLiteral("range")}, 30000);

    // Worn: the library knows the sensors by now, and a capture that is opened anew uses it.
    const calibrate::RigCalibration found = bench.workspace->desk().calibration();
    QVERIFY(bench.wears("poses"));
    bench.workspace->desk().apply(found);
    bench.begin_poses(0, 30.0);
    QSignalSpy limb_cues(&bench.workspace->limb_wizard()->sounds(), &CueSounds::played);
    bench.hold_both(0);
    QVERIFY2(limb_cues.size() >= 3, "start and capture are heard");
    shoot(bench, QStringLiteral("limb-verdict"));
    const auto& outcomes = bench.workspace->limb_model().outcomes();
    QCOMPARE(outcomes.size(), std::size_t{4});
    for (const LimbOutcome& outcome : outcomes) {
      QVERIFY2(outcome.result.has_value(), outcome.error.text().c_str());
      QCOMPARE(outcome.result->verdict, calibrate::Verdict::kGood);
    }
    bench.click("next");
    QTRY_VERIFY_WITH_TIMEOUT(bench.button("calibrate_mounting") != nullptr, 30000);
    const take::CalibrationLibrary library(bench.folder.filePath(QStringLiteral("library")).toStdString());
    QCOMPARE(library.list().sensors.size(), std::size_t{5});
    QCOMPARE(library.list().mounts.size(), std::size_t{1});
    QCOMPARE(library.list().mounts.front().mounts.size(), std::size_t{4});

    // Undone, neither the capture nor the library has it; done again, both.
    QUndoStack& undo = bench.studio.context->undo_stack();
    undo.undo();
    bench.studio.context->saves().finish();
    QVERIFY(library.list().mounts.empty());
    QCOMPARE(bench.workspace->desk().calibration().mounts[1].method, found.mounts[1].method);
    undo.redo();
    bench.studio.context->saves().finish();
    QCOMPARE(library.list().mounts.size(), std::size_t{1});
    QCOMPARE(bench.workspace->desk().calibration().mounts[1].method, std::string("two poses"));
  }

  // The studio's own simulator has a wearer who does what is asked: whatever the motion, nobody needs to wait for the
  // right moment.
  void the_simulators_wearer_does_what_the_wizards_ask() {
    Bench bench(core_services());
    QVERIFY(bench.wears("simulator:walk"));
    bench.turn_to_the_end();
    QCOMPARE(bench.label("summary"), QStringLiteral("5 sensors calibrated"));
    bench.click("next");
    QTRY_VERIFY_WITH_TIMEOUT(bench.button("calibrate_mounting") != nullptr, 30000);
    bench.begin_poses(0, 5.0);
    QTRY_VERIFY_WITH_TIMEOUT(bench.workspace->limb_model().page() == LimbPage::kResult, 60000);
    for (const LimbOutcome& outcome : bench.workspace->limb_model().outcomes()) {
      QVERIFY2(outcome.result.has_value(), outcome.error.text().c_str());
      // A real person is a few degrees beside the pose that was asked for, and so is this one.
      QVERIFY(outcome.result->verdict != calibrate::Verdict::kRepeat);
    }
    bench.workspace->limb_model().cancel();
    // And walks on: what is felt changes by more than a hand's trembling.
    LiveModel& live = bench.studio.context->live();
    const auto moves = [&live] {
      double most_volts = 0.0;
      const auto snapshot = live.snapshot();
      for (std::size_t sensor = 0; sensor < snapshot->health.size(); ++sensor) {
        Eigen::Vector3d least = Eigen::Vector3d::Constant(1e9), most = -least;
        for (const decode::AccelerationFrame& frame : snapshot->frames) {
          if (frame.time_s > snapshot->stream_time_s - 1.0) {
            least = least.cwiseMin(frame.volts[sensor]);
            most = most.cwiseMax(frame.volts[sensor]);
          }
        }
        most_volts = std::max(most_volts, (most - least).maxCoeff());
      }
      return most_volts > 0.05;
    };
    QTest::qWait(3500);  // the way from the pose is not meant
    QTRY_VERIFY_WITH_TIMEOUT(moves(), 20000);
  }

  void a_bad_wearer_is_told_and_gets_no_good_verdict() {
    Bench bench;
    // Boxing is no slow turning.
    QVERIFY(bench.wears("box"));
    bench.begin_turning();
    QSet<QString> advice;
    for (int i = 0; i < 60; ++i) {
      QTest::qWait(100);
      advice.insert(bench.label("advice"));
    }
    QVERIFY2(advice.contains(QStringLiteral("Slower")) || advice.contains(QStringLiteral("Smoother")),
             qPrintable(QStringList(advice.values()).join(QLatin1Char('|'))));
    QVERIFY(!bench.workspace->range_model().all_enough());
    bench.click("next");  // "Finish early"
    QTRY_VERIFY_WITH_TIMEOUT(bench.workspace->range_model().page() == RangePage::kResult, 60000);
    QCOMPARE(bench.label("summary"), QStringLiteral("Repeat"));
    QCOMPARE(bench.workspace->range_model().accepted(), 0);
    QVERIFY(!bench.button("next")->isEnabled());
    shoot(bench, QStringLiteral("range-bad"));
    bench.workspace->range_model().cancel();

    // Who moves all the time is never captured.
    bench.begin_poses(0, 5.0);
    bench.click("next");  // "Skip the wait"
    QTRY_VERIFY_WITH_TIMEOUT(bench.label("advice").startsWith(QStringLiteral("Moves: ")), 30000);
    QCOMPARE(bench.workspace->limb_model().page(), LimbPage::kHold);
    bench.workspace->limb_model().cancel();

    // Poses 12° beside what was asked for.
    bench.pose_angle = 12.0 * std::numbers::pi / 180.0;
    QVERIFY(bench.wears("poses"));
    bench.begin_poses(0, 30.0);
    bench.hold_both(0);
    shoot(bench, QStringLiteral("limb-bad"));
    QVERIFY2(bench.workspace->limb_model().bad() > 0 || !bench.workspace->limb_model().refusal().message.empty(),
             "some angle between the poses gives it away");
  }

  void a_device_that_dies_while_sensors_are_turned_leaves_the_take_as_far_as_it_got() {
    Bench bench;
    QVERIFY(bench.wears("range"));
    bench.begin_turning();
    RangeWizardModel& model = bench.workspace->range_model();
    QTRY_VERIFY_WITH_TIMEOUT(model.turning_s() > 5.0, 60000);
    const std::filesystem::path recorded = bench.workspace->desk().recording_folder();
    QSignalSpy cues(&bench.workspace->range_wizard()->sounds(), &CueSounds::played);
    *bench.pulled = true;
    QTRY_COMPARE_WITH_TIMEOUT(bench.label("advice"), QStringLiteral("Signal lost"), 30000);
    QVERIFY2(!cues.empty(), "it is heard");
    const double turned_s = model.turning_s();
    shoot(bench, QStringLiteral("range-device-lost"));
    QVERIFY(!bench.button("start_over")->isEnabled());
    QVERIFY2(bench.button("next")->isEnabled(), "what was turned may be enough");
    // The take is closed, with the stretch as far as it got.
    QTRY_COMPARE_WITH_TIMEOUT(segments_of(recorded), QStringList{QStringLiteral("range")}, 30000);
    const take::Take take = take::open_take(recorded).value();
    QVERIFY(take.info.complete);
    const take::TakeSegment& segment = take.info.segments.front();
    const double kept_s = take.info.format.rate.seconds(segment.count).value;
    QVERIFY2(std::abs(kept_s - turned_s) < 0.3, qPrintable(QString::number(kept_s)));
    QVERIFY(segment.first.value + segment.count.value <= take.info.frames);

    // Plugged in again: nothing is mixed with what was turned before.
    QVERIFY(bench.wears("range"));
    QTRY_COMPARE_WITH_TIMEOUT(bench.label("advice"), QStringLiteral("The device is back"), 30000);
    QTest::qWait(500);
    QCOMPARE(model.turning_s(), turned_s);
    bench.click("start_over");
    QTRY_VERIFY_WITH_TIMEOUT(model.turning_s() > 1.0 && model.turning_s() < turned_s, 60000);
    QVERIFY(!model.interrupted());
    QTRY_VERIFY_WITH_TIMEOUT(bench.workspace->desk().recording_folder() != recorded, 30000);
    model.cancel();
  }

  void a_device_that_dies_while_a_pose_is_held_says_what_to_do() {
    Bench bench;
    QVERIFY(bench.wears("box"));
    bench.begin_poses(0, 5.0);
    bench.click("next");  // "Skip the wait"
    QTRY_VERIFY_WITH_TIMEOUT(bench.workspace->limb_model().progress().seconds > 1.5, 30000);
    const std::filesystem::path recorded = bench.workspace->desk().recording_folder();
    *bench.pulled = true;
    QTRY_COMPARE_WITH_TIMEOUT(bench.label("advice"), QStringLiteral("Signal lost"), 30000);
    shoot(bench, QStringLiteral("limb-device-lost"));
    QTRY_COMPARE_WITH_TIMEOUT(segments_of(recorded).size(), 1, 30000);
    QVERIFY(segments_of(recorded).front().startsWith(QStringLiteral("pose:")));
    bench.click("back");
    QCOMPARE(bench.workspace->limb_model().page(), LimbPage::kPrepare);
    QVERIFY(!bench.button("next")->isEnabled());
    QVERIFY(bench.wears("box"));
    QTRY_VERIFY(bench.button("next")->isEnabled());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::SimulatorWizardsTest)
#include "simulator_wizards_test.moc"
