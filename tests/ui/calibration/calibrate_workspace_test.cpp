/// The Calibrate workspace in a real window: buttons are clicked and keys pressed, a simulated wearer does the rest,
/// and every page leaves a picture in BUILD/screenshots.
#include "workspaces/calibrate_workspace.h"

#include <QCheckBox>
#include <QImage>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include "common/theme.h"
#include "ui/calibration/simulated_wearer.h"
#include "ui/support/studio_fixture.h"

namespace limbwave::ui::testing {

struct CalibrateStudio {
  CalibrateStudio() : studio(StudioServices{}, parts()) {
    studio.context->settings().setValue(QStringLiteral("capture/subject"), QStringLiteral("Ada"));
    studio.window->show_workspace(QStringLiteral("calibrate"));
    workspace = dynamic_cast<CalibrateWorkspace*>(studio.window->workspace(QStringLiteral("calibrate")));
    idle();
  }
  StudioParts parts() {
    StudioParts parts;
    WorkspaceEntry entry = calibrate_entry();
    entry.create = [this](StudioContext& context, QWidget* parent) -> Workspace* {
      auto fake = std::make_unique<FakeSource>();
      source = fake.get();
      wearer = std::make_unique<SimulatedWearer>(*source);
      return new CalibrateWorkspace(context,
                                    take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString()),
                                    std::move(fake), parent);
    };
    parts.workspaces.push_back(entry);
    return parts;
  }
  /// Waits until no job is left.
  void idle() { QTRY_VERIFY(studio.context->jobs().jobs().empty()); }
  /// The visible button of that name.
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
  void key(Qt::Key code) {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr ? focus : studio.window.get(), code);
  }

  QTemporaryDir folder;
  FakeSource* source = nullptr;
  std::unique_ptr<SimulatedWearer> wearer;
  StudioFixture studio;
  CalibrateWorkspace* workspace = nullptr;
};

class CalibrateWorkspaceTest : public QObject {
  Q_OBJECT
 private:
  QString suffix_;

  void shoot(CalibrateStudio& bench, const QString& name) {
    QVERIFY(QTest::qWaitForWindowExposed(bench.studio.window.get()));
    bench.idle();
    QTest::qWait(60);
    const QImage image = bench.studio.window->grab().toImage();
    QVERIFY(!image.isNull());
    QVERIFY(image.save(screenshot_path(QStringLiteral("calibrate-") + name + suffix_)));
  }

  void range_to_the_end(CalibrateStudio& bench, bool pictures) {
    bench.click("calibrate_range");
    if (pictures) {
      shoot(bench, QStringLiteral("range-1-choose"));
    }
    bench.click("next");
    if (pictures) {
      shoot(bench, QStringLiteral("range-2-how"));
    }
    bench.click("next");
    bench.wearer->turn(14.0);
    if (pictures) {
      shoot(bench, QStringLiteral("range-3-turn"));
    }
    bench.wearer->turn(76.0);
    if (pictures) {
      shoot(bench, QStringLiteral("range-4-enough"));
    }
    QVERIFY(bench.workspace->range_model().all_enough());
    bench.click("next");
    QTRY_VERIFY(bench.button("accept_0") != nullptr);
    QCOMPARE(bench.label("summary"), QStringLiteral("5 sensors calibrated"));
    if (pictures) {
      shoot(bench, QStringLiteral("range-5-verdict"));
    }
    bench.click("next");
    QTRY_VERIFY(bench.button("calibrate_mounting") != nullptr);
  }

 private Q_SLOTS:
  void init() {
    apply_theme(*qApp, ThemeKind::kDark);
    suffix_ = qEnvironmentVariable("QT_SCALE_FACTOR") == QLatin1String("2") ? QStringLiteral("@2x") : QString();
  }

  void both_procedures_by_mouse() {
    CalibrateStudio bench;
    shoot(bench, QStringLiteral("overview-none"));
    range_to_the_end(bench, true);
    QVERIFY(bench.label("headline").contains(QStringLiteral("Range: 5 of 5")));

    bench.click("calibrate_mounting");
    shoot(bench, QStringLiteral("limb-1-choose"));
    bench.click("next");
    shoot(bench, QStringLiteral("limb-2-prepare"));
    bench.click("next");
    bench.workspace->limb_model().advance(1.4);
    shoot(bench, QStringLiteral("limb-3-countdown"));
    QVERIFY(bench.workspace->limb_wizard()->hold_page()->dial()->text_pixels() >= 48);
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 0, 3.0, 0.0, 0.12, {3});
    shoot(bench, QStringLiteral("limb-4-moves"));
    QCOMPARE(bench.label("advice"), QStringLiteral("Moves: hand"));
    bench.wearer->hold(0, 0, 1.5);
    shoot(bench, QStringLiteral("limb-5-hold"));
    bench.wearer->hold(0, 0, 3.0);
    QCOMPARE(bench.workspace->limb_model().pose(), 1);
    bench.workspace->limb_model().advance(2.0);
    shoot(bench, QStringLiteral("limb-6-second"));
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 1, 4.0, 2.0);
    QTRY_VERIFY(bench.button("accept_1") != nullptr);
    shoot(bench, QStringLiteral("limb-7-verdict"));
    bench.click("check_0");
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 0, 4.0, 4.0);
    QTRY_VERIFY(!bench.label("check_summary").isEmpty());
    shoot(bench, QStringLiteral("limb-8-check"));
    QVERIFY(bench.label("check_summary").startsWith(QStringLiteral("At most")));
    bench.click("next");
    bench.click("next");
    QTRY_VERIFY(bench.button("calibrate_mounting") != nullptr);
    QCOMPARE(bench.source->calibration().mounts[1].method, std::string("two poses"));

    // The torso's two poses are another group.
    bench.click("mount_0");
    bench.click("next");
    shoot(bench, QStringLiteral("limb-9-torso"));
    bench.click("next");
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(1, 0, 4.0);
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(1, 1, 4.0);
    QTRY_VERIFY(bench.button("accept_0") != nullptr);
    bench.click("next");
    QTRY_COMPARE(bench.label("headline"), QStringLiteral("Everything is calibrated"));
    QTest::mouseClick(bench.workspace->findChild<QWidget*>(QStringLiteral("row_2")), Qt::LeftButton, {},
                      QPoint(20, 20));
    QCOMPARE(bench.studio.context->selection().index_of(SelectionKind::kSensor), 2);
    shoot(bench, QStringLiteral("overview-done"));
    apply_theme(*qApp, ThemeKind::kLight);
    shoot(bench, QStringLiteral("overview-done-light"));
  }

  void range_by_keyboard_alone() {
    CalibrateStudio bench;
    bench.studio.window->activateWindow();
    bench.click("calibrate_range");
    QTRY_VERIFY(QApplication::focusWidget() != nullptr);
    bench.key(Qt::Key_Return);
    QCOMPARE(bench.workspace->range_model().page(), RangePage::kInstructions);
    bench.key(Qt::Key_Return);
    QCOMPARE(bench.workspace->range_model().page(), RangePage::kTurn);
    bench.wearer->turn(5.0);
    // Esc asks, because something would be lost; Esc again stays, Esc and the button leave.
    bench.key(Qt::Key_Escape);
    QVERIFY(bench.button("leave") != nullptr);
    shoot(bench, QStringLiteral("range-6-leave"));
    bench.key(Qt::Key_Escape);
    QVERIFY(bench.button("leave") == nullptr);
    QCOMPARE(bench.workspace->range_model().page(), RangePage::kTurn);
    bench.key(Qt::Key_Escape);
    bench.click("leave");
    QVERIFY(bench.button("calibrate_range") != nullptr);
  }

  void whoever_turns_badly_is_told_and_repeats_one_sensor() {
    CalibrateStudio bench;
    apply_theme(*qApp, ThemeKind::kLight);
    bench.click("calibrate_range");
    bench.click("next");
    bench.click("next");
    bench.wearer->turn(3.0, 4.5);
    QCOMPARE(bench.label("advice"), QStringLiteral("Slower"));
    shoot(bench, QStringLiteral("range-7-too-fast-light"));
    bench.click("start_over");
    bench.wearer->turn(40.0);
    bench.wearer->unplugged = {2};
    bench.wearer->turn(50.0);
    QCOMPARE(bench.label("advice"), QStringLiteral("forearm: no signal"));
    shoot(bench, QStringLiteral("range-8-no-signal-light"));
    bench.click("next");
    QTRY_VERIFY(bench.button("repeat_2") != nullptr);
    QVERIFY(!bench.button("accept_2")->isEnabled());
    QCOMPARE(bench.label("summary"), QStringLiteral("4 of 5 calibrated, repeat the others"));
    shoot(bench, QStringLiteral("range-9-repeat-light"));
    bench.wearer->unplugged.clear();
    bench.click("repeat_2");
    bench.wearer->turn(90.0);
    bench.click("next");
    QTRY_VERIFY(bench.button("accept_2") != nullptr && bench.button("accept_2")->isEnabled());
    QCOMPARE(bench.workspace->range_model().accepted(), 5);
    bench.click("discard_4");
    QCOMPARE(bench.workspace->range_model().accepted(), 4);
  }

  void poses_far_off_end_in_repeat() {
    CalibrateStudio bench;
    bench.source->set_calibration(bench.wearer->true_ranges());
    bench.click("calibrate_mounting");
    bench.click("next");
    bench.click("next");
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 0, 4.0);
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->unplugged = {4};
    bench.wearer->hold(0, 1, 3.0);
    QCOMPARE(bench.label("advice"), QStringLiteral("No signal: fingers"));
    shoot(bench, QStringLiteral("limb-10-no-signal"));
    bench.click("leave_out");
    bench.wearer->hold(0, 1, 4.0, 15.0);
    QTRY_VERIFY(bench.button("repeat_both") != nullptr);
    QCOMPARE(bench.label("summary"), QStringLiteral("Repeat"));
    QVERIFY(!bench.button("next")->isEnabled());
    shoot(bench, QStringLiteral("limb-11-repeat"));
    // A technician who knows better may accept it all the same.
    bench.click("accept_1");
    QVERIFY(bench.button("next")->isEnabled());
  }

  void without_device_or_take_it_says_what_to_do() {
    CalibrateStudio bench;
    QSignalSpy revealed(bench.studio.context.get(), &StudioContext::reveal_requested);
    bench.source->set_running(false);
    shoot(bench, QStringLiteral("empty"));
    bench.click("open_device");
    QCOMPARE(revealed.count(), 1);
    QCOMPARE(revealed.at(0).at(0).toString(), QStringLiteral("capture"));
  }

  void the_device_may_go_away_on_every_page() {
    CalibrateStudio bench;
    const auto unplug = [&] {
      bench.source->set_running(false);
      bench.idle();
      bench.source->set_running(true);
    };
    bench.click("calibrate_mounting");
    unplug();
    bench.click("next");
    unplug();
    // In a pose it ends the attempt: the readings after it are of another clock.
    bench.click("next");
    unplug();
    QVERIFY(bench.workspace->limb_model().interrupted());
    bench.click("back");
    bench.click("next");
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 0, 1.0);
    unplug();
    QVERIFY(bench.workspace->limb_model().interrupted());
    bench.wearer->hold(0, 0, 4.0);
    QCOMPARE(bench.workspace->limb_model().page(), LimbPage::kHold);
    bench.click("back");
    bench.click("next");
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 0, 4.0);
    bench.workspace->limb_model().advance(6.0);
    bench.wearer->hold(0, 1, 4.0);
    QTRY_VERIFY(bench.button("accept_1") != nullptr);
    unplug();
    bench.workspace->limb_model().cancel();
    // Closed long ago, the wizard still hears of it.
    unplug();
    bench.click("calibrate_range");
    unplug();
    bench.click("next");
    unplug();
    bench.click("next");
    bench.wearer->turn(5.0);
    unplug();
    bench.workspace->range_model().cancel();
    bench.source->set_running(false);
    QVERIFY(bench.button("open_device") != nullptr);
  }

  void what_was_measured_is_kept_when_its_device_is_gone_but_not_given_to_a_take() {
    CalibrateStudio bench;
    bench.click("calibrate_range");
    bench.click("next");
    bench.click("next");
    bench.wearer->turn(90.0);
    bench.click("next");
    QTRY_VERIFY(bench.button("accept_0") != nullptr);
    // A take of a smaller rig is open when the device goes.
    take::Take take;
    take.folder = bench.folder.filePath(QStringLiteral("other.take")).toStdString();
    take.info.rig = bench.source->rig();
    take.info.rig.name = "smaller";
    take.info.rig.accelerometers.resize(2);
    take.info.rig.groups.clear();
    take.info.skeleton = bench.source->skeleton();
    bench.studio.context->document().set(take);
    bench.source->set_running(false);
    bench.workspace->range_model().save();
    QTRY_COMPARE(bench.workspace->desk().listing().sensors.size(), std::size_t{5});
    QCOMPARE(bench.workspace->desk().listing().sensors[0].key.substr(0, 3), std::string("LW-"));
    QVERIFY(!bench.studio.context->document().take()->info.calibration);
    QVERIFY(!bench.studio.context->undo_stack().canUndo());
    QVERIFY(!bench.studio.context->notifications().all().empty());
  }

  void a_device_opened_for_a_wizard_of_a_take_is_the_one_that_is_calibrated() {
    CalibrateStudio bench;
    bench.source->set_running(false);
    take::Take take;
    take.folder = bench.folder.filePath(QStringLiteral("open.take")).toStdString();
    take.info.rig = bench.source->rig();
    take.info.skeleton = bench.source->skeleton();
    bench.studio.context->document().set(take);
    bench.click("calibrate_range");
    bench.workspace->range_model().choose(4, false);
    QVERIFY(!bench.button("next")->isEnabled());
    bench.source->set_running(true);
    QCOMPARE(bench.workspace->range_model().chosen(), (std::vector<int>{0, 1, 2, 3}));
    bench.click("next");
    bench.click("next");
    bench.wearer->turn(90.0);
    bench.click("next");
    QTRY_VERIFY(bench.button("accept_0") != nullptr);
    bench.click("next");
    QTRY_VERIFY(bench.button("calibrate_mounting") != nullptr);
    QVERIFY(bench.source->calibration().sensors[0].method != "nominal");
    QVERIFY(!bench.studio.context->document().take()->info.calibration);
  }

  void an_undone_mounting_is_not_given_to_whoever_wears_the_sensors_by_then() {
    CalibrateStudio bench;
    CalibrationDesk& desk = bench.workspace->desk();
    desk.set_wearer(QStringLiteral("Ada"));
    calibrate::RigCalibration of_ada = desk.calibration();
    of_ada.mounts[0].method = "two poses";
    of_ada.sensors[0].residual_g = 0.125;
    desk.apply(of_ada);
    QCOMPARE(bench.source->calibration().mounts[0].method, std::string("two poses"));
    QUndoStack& undo = bench.studio.context->undo_stack();
    undo.undo();
    QCOMPARE(bench.source->calibration().mounts[0].method, std::string("nominal"));
    bench.studio.context->set_wearer(QStringLiteral("Bo"));
    undo.redo();
    QCOMPARE(bench.source->calibration().mounts[0].method, std::string("nominal"));
    QCOMPARE(bench.source->calibration().sensors[0].residual_g, 0.125);
  }

  void an_older_calibration_can_be_used_again() {
    CalibrateStudio bench;
    range_to_the_end(bench, false);
    const calibrate::RigCalibration first = bench.source->calibration();
    QTest::qWait(1100);  // Dates count whole seconds.
    range_again(bench);
    QVERIFY(bench.source->calibration().sensors[0].offset != first.sensors[0].offset);
    QTRY_COMPARE(bench.workspace->desk().listing().sensors.size(), std::size_t{6});
    for (const take::SensorRecord& record : bench.workspace->desk().listing().sensors) {
      if (record.calibration.date == first.sensors[0].date &&
          record.calibration.offset.isApprox(first.sensors[0].offset, 1e-9)) {
        bench.workspace->desk().use_record(record);
      }
    }
    QVERIFY(bench.source->calibration().sensors[0].offset.isApprox(first.sensors[0].offset, 1e-9));
    bench.click("use_library");
    QVERIFY(!bench.source->calibration().sensors[0].offset.isApprox(first.sensors[0].offset, 1e-9));
  }

 private:
  static void range_again(CalibrateStudio& bench) {
    bench.click("range_0");
    bench.click("next");
    bench.click("next");
    bench.wearer->turn(90.0);
    bench.click("next");
    QTRY_VERIFY(bench.button("accept_0") != nullptr);
    bench.click("next");
    QTRY_VERIFY(bench.button("calibrate_mounting") != nullptr);
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CalibrateWorkspaceTest)
#include "calibrate_workspace_test.moc"
