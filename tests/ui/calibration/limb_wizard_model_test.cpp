/// The limb wizard driven to its end by a simulated wearer, good and bad, without a window.
#include "calibration/limb_wizard_model.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "calibration/range_wizard_model.h"
#include "geometry/so3.h"
#include "ui/calibration/simulated_wearer.h"

namespace limbwave::ui::testing {

struct LimbBench {
  LimbBench()
      : context(StudioServices{}, folder.filePath(QStringLiteral("settings"))),
        desk(context, source, take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString())),
        model(desk),
        range_model(desk),
        wearer(source) {
    desk.set_wearer(QStringLiteral("Ada"));
  }
  /// Range calibration first, as one does.
  void calibrate_range() {
    range_model.begin({0, 1, 2, 3, 4});
    range_model.next();
    range_model.next();
    wearer.turn(90.0);
    range_model.next();
    QTRY_COMPARE(range_model.page(), RangePage::kResult);
    QSignalSpy saved(&range_model, &RangeWizardModel::saved);
    range_model.next();
    QTRY_COMPARE(saved.count(), 1);
  }
  void start(int sensor = -1, bool only = false) {
    model.begin(sensor, only);
    model.next();
    model.next();
    QCOMPARE(model.page(), LimbPage::kCountdown);
  }
  /// Both poses, each with its countdown; the first `first_off` degrees off, the second `second_off`.
  void hold_both(double first_off = 0.0, double second_off = 0.0) {
    model.advance(6.0);
    wearer.hold(model.group(), 0, 4.0, first_off);
    QCOMPARE(model.page(), LimbPage::kCountdown);
    QCOMPARE(model.pose(), 1);
    model.advance(6.0);
    wearer.hold(model.group(), 1, 4.0, second_off);
    QTRY_COMPARE(model.page(), LimbPage::kResult);
  }
  QTemporaryDir folder;
  StudioContext context;
  FakeSource source;
  CalibrationDesk desk;
  LimbWizardModel model;
  RangeWizardModel range_model;
  SimulatedWearer wearer;
};

class LimbWizardModelTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void a_good_wearer_ends_with_true_mountings() {
    LimbBench bench;
    bench.calibrate_range();
    bench.start();
    QCOMPARE(bench.model.sensors(), (std::vector<int>{1, 2, 3, 4}));
    QVERIFY(bench.model.without_range().isEmpty());
    bench.hold_both();
    QCOMPARE(bench.model.outcomes().size(), std::size_t{4});
    for (const LimbOutcome& outcome : bench.model.outcomes()) {
      QVERIFY(outcome.result);
      QCOMPARE(outcome.result->verdict, calibrate::Verdict::kGood);
      QVERIFY(std::abs(outcome.result->angle_error_deg) < 1.0);
      // 1°: what cross-axis terms of 1 % leave of a mounting, which an ellipsoid cannot tell from a rotation.
      const double error =
          degrees(geometry::geodesic_angle(outcome.result->mount.R_LS, bench.wearer.mount(outcome.sensor)));
      QVERIFY2(error < 1.5, qPrintable(QString::number(error)));
    }
    QSignalSpy saved(&bench.model, &LimbWizardModel::saved);
    bench.model.next();
    QTRY_COMPARE(saved.count(), 1);
    const take::LibraryListing listing = bench.desk.library().list();
    QCOMPARE(listing.mounts.size(), std::size_t{1});
    QCOMPARE(listing.mounts[0].subject, std::string("Ada"));
    QCOMPARE(listing.mounts[0].mounts.size(), std::size_t{4});
    QCOMPARE(bench.source.calibration().mounts[2].method, std::string("two poses"));
    QCOMPARE(bench.source.calibration().mounts[0].method, std::string("nominal"));
  }

  void the_countdown_counts_and_can_be_set() {
    LimbBench bench;
    bench.model.set_countdown_s(3.0);
    QSignalSpy counted(&bench.model, &LimbWizardModel::counted);
    bench.start();
    bench.model.advance(1.0);
    bench.model.advance(1.0);
    QCOMPARE(bench.model.page(), LimbPage::kCountdown);
    bench.model.advance(1.01);
    QCOMPARE(bench.model.page(), LimbPage::kHold);
    QList<int> told;
    for (const auto& arguments : counted) {
      told << arguments.at(0).toInt();
    }
    QCOMPARE(told, (QList<int>{3, 2, 1, 0}));
    QCOMPARE(LimbWizardModel(bench.desk).countdown_s(), 3.0);
  }

  void moving_during_the_hold_is_told_by_name_and_not_captured() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.model.advance(6.0);
    bench.wearer.hold(0, 0, 5.0, 0.0, 0.15, {3});
    QCOMPARE(bench.model.page(), LimbPage::kHold);
    for (const HolderState& holder : bench.model.holders()) {
      QCOMPARE(holder.moves, holder.sensor == 3);
    }
    QVERIFY(!bench.model.can_take_stillest());
    // As soon as it is still, it goes on.
    bench.wearer.hold(0, 0, 4.0);
    QCOMPARE(bench.model.page(), LimbPage::kCountdown);
    QCOMPARE(bench.model.pose(), 1);
  }

  void whoever_cannot_hold_still_may_use_the_stillest_second() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start(0);
    QCOMPARE(bench.model.group(), 1);
    bench.model.advance(6.0);
    bench.wearer.hold(1, 0, 12.0, 0.0, 0.04);
    QCOMPARE(bench.model.page(), LimbPage::kHold);
    QVERIFY(bench.model.can_take_stillest());
    bench.model.next();
    QCOMPARE(bench.model.page(), LimbPage::kCountdown);
    QCOMPARE(bench.model.pose(), 1);
  }

  void poses_fifteen_degrees_off_are_to_be_repeated() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.hold_both(0.0, 15.0);
    for (const LimbOutcome& outcome : bench.model.outcomes()) {
      QVERIFY(outcome.result);
      QCOMPARE(outcome.result->verdict, calibrate::Verdict::kRepeat);
      QVERIFY(std::abs(std::abs(outcome.result->angle_error_deg) - 15.0) < 1.0);
      QCOMPARE(outcome.decision, Decision::kOpen);
    }
    QVERIFY(!bench.model.obstacle().isEmpty());
    bench.model.repeat_both();
    QCOMPARE(bench.model.page(), LimbPage::kCountdown);
    bench.hold_both();
    QCOMPARE(bench.model.accepted(), 4);
    QVERIFY(bench.model.outcomes()[0].before_deg.has_value());
  }

  void both_poses_the_same_is_refused_with_a_reason() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.hold_both(0.0, -85.0);
    QVERIFY(!bench.model.refusal().message.empty());
    QCOMPARE(bench.model.accepted(), 0);
  }

  void one_sensor_alone_can_be_repeated() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.hold_both(0.0, 5.0);
    QCOMPARE(bench.model.accepted(), 4);
    const double other = bench.model.outcomes()[0].result->angle_error_deg;
    bench.model.repeat(3);
    QCOMPARE(bench.model.holders().size(), std::size_t{1});
    bench.hold_both();
    QCOMPARE(bench.model.outcomes().size(), std::size_t{4});
    QCOMPARE(bench.model.outcomes()[0].result->angle_error_deg, other);
    QVERIFY(std::abs(bench.model.outcomes()[2].result->angle_error_deg) < 1.0);
    QVERIFY(std::abs(*bench.model.outcomes()[2].before_deg) > 4.0);
  }

  void a_pulled_cable_is_told_and_can_be_left_out() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.model.advance(6.0);
    bench.wearer.hold(0, 0, 4.0);
    QCOMPARE(bench.model.pose(), 1);
    bench.wearer.unplugged = {4};
    bench.model.advance(6.0);
    bench.wearer.hold(0, 1, 4.0);
    QCOMPARE(bench.model.page(), LimbPage::kHold);
    for (const HolderState& holder : bench.model.holders()) {
      QCOMPARE(holder.movement.has_signal, holder.sensor != 4);
    }
    QVERIFY(bench.model.can_leave_out(4));
    bench.model.leave_out(4);
    bench.wearer.hold(0, 1, 4.0);
    QTRY_COMPARE(bench.model.page(), LimbPage::kResult);
    QCOMPARE(bench.model.outcomes().size(), std::size_t{3});
    QCOMPARE(bench.model.accepted(), 3);
  }

  void holding_a_pose_again_checks_in_degrees() {
    LimbBench bench;
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.hold_both();
    bench.model.check(0);
    QVERIFY(bench.model.checking());
    bench.model.advance(6.0);
    bench.wearer.hold(0, 0, 4.0, 6.0);
    QTRY_COMPARE(bench.model.page(), LimbPage::kCheck);
    QCOMPARE(bench.model.checks().size(), std::size_t{4});
    for (const calibrate::PoseCheck& check : bench.model.checks()) {
      QVERIFY2(std::abs(check.error_deg - 6.0) < 1.0, qPrintable(QString::number(check.error_deg)));
    }
    bench.model.next();
    QCOMPARE(bench.model.page(), LimbPage::kResult);
    QCOMPARE(bench.model.accepted(), 4);
  }

  void without_range_it_says_so() {
    LimbBench bench;
    bench.model.begin(-1);
    QCOMPARE(bench.model.without_range().size(), 4);
  }

  void nothing_held_is_lost_without_being_asked() {
    LimbBench bench;
    bench.start();
    QVERIFY(!bench.model.would_lose());
    bench.source.set_calibration(bench.wearer.true_ranges());
    bench.start();
    bench.model.advance(6.0);
    bench.wearer.hold(0, 0, 4.0);
    QVERIFY(bench.model.would_lose());
    bench.model.cancel();
    QCOMPARE(bench.desk.library().list().mounts.size(), std::size_t{0});
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::LimbWizardModelTest)
#include "limb_wizard_model_test.moc"
