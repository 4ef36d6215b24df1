/// The range wizard driven to its end by a simulated technician, good and bad, without a window.
#include "calibration/range_wizard_model.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "ui/calibration/simulated_wearer.h"

namespace limbwave::ui::testing {

struct RangeBench {
  RangeBench()
      : context(StudioServices{}, folder.filePath(QStringLiteral("settings"))),
        desk(context, source, take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString())),
        model(desk),
        wearer(source) {}
  void start(std::vector<int> sensors) {
    model.begin(std::move(sensors));
    model.next();
    model.next();
    QCOMPARE(model.page(), RangePage::kTurn);
  }
  void finish() {
    model.next();
    QTRY_COMPARE(model.page(), RangePage::kResult);
  }
  QTemporaryDir folder;
  StudioContext context;
  FakeSource source;
  CalibrationDesk desk;
  RangeWizardModel model;
  SimulatedWearer wearer;
};

class RangeWizardModelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whoever_turns_well_gets_good_numbers_for_all_sensors() {
    RangeBench bench;
    QSignalSpy sufficed(&bench.model, &RangeWizardModel::sufficed);
    bench.start({0, 1, 2, 3, 4});
    bench.wearer.turn(90.0);
    QVERIFY(bench.model.all_enough());
    QCOMPARE(sufficed.count(), 1);
    bench.finish();
    QCOMPARE(bench.model.outcomes().size(), std::size_t{5});
    for (const RangeOutcome& outcome : bench.model.outcomes()) {
      QVERIFY(outcome.result.has_value());
      QCOMPARE(outcome.result->verdict, calibrate::Verdict::kGood);
      QVERIFY(outcome.result->calibration.residual_g < 0.01);
      QCOMPARE(outcome.decision, Decision::kAccepted);
    }
    QSignalSpy saved(&bench.model, &RangeWizardModel::saved);
    bench.model.next();
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(saved.at(0).at(0).toInt(), 5);
    // In use, and in the library.
    for (const calibrate::SensorCalibration& sensor : bench.source.calibration().sensors) {
      QVERIFY(sensor.method != "nominal");
      QVERIFY(!sensor.date.empty());
    }
    QCOMPARE(bench.desk.library().list().sensors.size(), std::size_t{5});
  }

  void too_little_coverage_names_the_missing_direction() {
    RangeBench bench;
    bench.start({0});
    bench.wearer.turn_about_z(40.0);
    const RangeSensorState& state = bench.model.states().front();
    QVERIFY(!bench.model.all_enough());
    QCOMPARE(state.advice, RangeAdvice::kTurnTo);
    QVERIFY(std::abs(state.progress.missing.front().z()) > 0.8);
    bench.finish();
    const RangeOutcome& outcome = bench.model.outcomes().front();
    QVERIFY(!outcome.result);
    QVERIFY(QString::fromStdString(outcome.error.message + outcome.error.remedy).contains(QLatin1Char('z')));
    QCOMPARE(outcome.decision, Decision::kOpen);
    QVERIFY(!bench.model.obstacle().isEmpty());
    // It cannot be accepted.
    bench.model.decide(0, Decision::kAccepted);
    QCOMPARE(bench.model.accepted(), 0);
  }

  void too_fast_and_jerky_turning_is_told() {
    RangeBench bench;
    bench.start({2});
    bench.wearer.turn(3.0, 4.0);
    QCOMPARE(bench.model.states().front().advice, RangeAdvice::kSlower);
    bench.model.start_over();
    bench.wearer.turn_jerkily(10.0);
    QVERIFY(bench.model.states().front().advice == RangeAdvice::kSmoother ||
            bench.model.states().front().advice == RangeAdvice::kSlower);
    QVERIFY(bench.model.states().front().progress.steady_s < 1.0);
  }

  void a_pulled_cable_is_told_and_only_that_sensor_repeated() {
    RangeBench bench;
    bench.start({1, 3});
    bench.wearer.turn(20.0);
    bench.wearer.unplugged = {3};
    bench.wearer.turn(60.0);
    QVERIFY(!bench.model.states()[0].lost);
    QVERIFY(bench.model.states()[1].lost);
    QCOMPARE(bench.model.shown()->sensor, 3);
    QCOMPARE(bench.model.shown()->advice, RangeAdvice::kNoSignal);
    bench.finish();
    QVERIFY(bench.model.outcomes()[0].result);
    QVERIFY(!bench.model.outcomes()[1].result);

    bench.wearer.unplugged.clear();
    const double kept = bench.model.outcomes()[0].result->calibration.residual_g;
    bench.model.repeat(3);
    QCOMPARE(bench.model.page(), RangePage::kTurn);
    QCOMPARE(bench.model.states().size(), std::size_t{1});
    bench.wearer.turn(90.0);
    bench.finish();
    QCOMPARE(bench.model.outcomes().size(), std::size_t{2});
    QCOMPARE(bench.model.outcomes()[0].result->calibration.residual_g, kept);
    QVERIFY(bench.model.outcomes()[1].result);
    QCOMPARE(bench.model.accepted(), 2);
  }

  void nothing_is_lost_without_being_asked() {
    RangeBench bench;
    bench.model.begin({});
    QCOMPARE(bench.model.chosen().size(), std::size_t{5});
    QVERIFY(!bench.model.would_lose());
    for (int sensor = 0; sensor < 5; ++sensor) {
      bench.model.choose(sensor, false);
    }
    QVERIFY(!bench.model.obstacle().isEmpty());
    bench.model.next();
    QCOMPARE(bench.model.page(), RangePage::kChoose);
    bench.start({0});
    bench.wearer.turn(1.0);
    QVERIFY(!bench.model.would_lose());
    bench.wearer.turn(5.0);
    QVERIFY(bench.model.would_lose());
    QSignalSpy left(&bench.model, &RangeWizardModel::left);
    bench.model.cancel();
    QCOMPARE(left.count(), 1);
    QCOMPARE(bench.source.recordings_stopped, 1);
    QCOMPARE(bench.desk.library().list().sensors.size(), std::size_t{0});
  }

  void discarded_ones_are_not_saved() {
    RangeBench bench;
    bench.start({0, 1});
    bench.wearer.turn(90.0);
    bench.finish();
    bench.model.decide(1, Decision::kDiscarded);
    QCOMPARE(bench.model.accepted(), 1);
    QSignalSpy saved(&bench.model, &RangeWizardModel::saved);
    bench.model.next();
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(bench.desk.library().list().sensors.size(), std::size_t{1});
    QCOMPARE(bench.source.calibration().sensors[1].method, std::string("nominal"));
  }

  void a_device_that_goes_away_stops_the_start_but_not_the_verdict() {
    RangeBench bench;
    bench.start({0});
    bench.wearer.turn(90.0);
    bench.source.set_running(false);
    QVERIFY(bench.model.source_lost());
    bench.finish();
    QVERIFY(bench.model.outcomes().front().result);
    bench.model.repeat(0);
    QCOMPARE(bench.model.page(), RangePage::kResult);
    // Nothing runs that could use it; the library keeps it for the next time.
    QSignalSpy saved(&bench.model, &RangeWizardModel::saved);
    bench.model.next();
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(bench.desk.library().list().sensors.size(), std::size_t{1});
    QCOMPARE(bench.source.calibration().sensors[0].method, std::string("nominal"));
  }

  void what_is_turned_after_the_device_came_back_is_not_mixed_with_what_was_before() {
    RangeBench bench;
    bench.start({0});
    bench.wearer.turn(10.0);
    const double turned_s = bench.model.turning_s();
    QSignalSpy lost(&bench.model, &RangeWizardModel::device_lost);
    bench.source.set_running(false);
    QCOMPARE(lost.count(), 1);
    QCOMPARE(bench.source.recordings_stopped, 1);
    QVERIFY(!bench.model.can_start_over());
    bench.source.set_running(true);
    bench.wearer.turn(10.0);
    QCOMPARE(bench.model.turning_s(), turned_s);
    QVERIFY(bench.model.source_lost());
    bench.model.start_over();
    QVERIFY(!bench.model.source_lost());
    bench.wearer.turn(90.0);
    QVERIFY(bench.model.all_enough());
  }

  void raw_signals_are_kept_or_it_is_told_why_not() {
    RangeBench bench;
    bench.start({0});
    QVERIFY(!bench.source.recorded_folder.empty());
    QCOMPARE(bench.source.recorded_folder.parent_path(), calibration_takes_folder());
    QVERIFY(bench.desk.recording_note().contains(QString::fromStdString(bench.source.recorded_folder.string())));
    bench.model.cancel();
    bench.source.can_record = false;
    bench.start({0});
    QVERIFY(bench.desk.recording_note().contains(QStringLiteral("not kept")));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::RangeWizardModelTest)
#include "range_wizard_model_test.moc"
