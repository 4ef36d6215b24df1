/// The parts of the wizards that can be checked alone: the map of the sphere, words, who moves, the library's newest.
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>
#include <set>

#include "base/units.h"
#include "calibration/calibration_desk.h"
#include "calibration/calibration_words.h"
#include "calibration/gauges.h"
#include "calibration/movement_meter.h"
#include "calibration/pose_picture.h"
#include "calibration/sensor_chooser.h"
#include "calibration/sensor_cube.h"
#include "calibration/sphere_map.h"
#include "calibration/verdict_row.h"
#include "ui/calibration/simulated_wearer.h"

namespace limbwave::ui::testing {

class CalibrationPartsTest : public QObject {
  Q_OBJECT
 private:
  static double area(const std::vector<DiscPoint>& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const DiscPoint& a = outline[i];
      const DiscPoint& b = outline[(i + 1) % outline.size()];
      twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2.0;
  }

 private Q_SLOTS:
  void verdicts_fit_narrow_and_wide_windows() {
    VerdictRowContent content;
    content.title = QStringLiteral("left upper arm");
    content.serial = QStringLiteral("LONG-SERIAL-0001");
    content.state = refused_state();
    content.text = QStringLiteral("only 2 % of all directions were covered; 65 % are needed");
    content.comparison = QStringLiteral("go on turning it slowly, for example until −x up");
    content.acceptable = content.repeatable = true;
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* row = new VerdictRow(0, true, &window);
    layout->addWidget(row);
    row->set_content(content);
    window.show();
    for (const int width : {620, 760, 820, 1000, 1400}) {
      window.resize(width, 300);
      QTRY_COMPARE(window.width(), width);
      for (const char* name : {"accept_0", "repeat_0", "discard_0"}) {
        auto* button = row->findChild<QPushButton*>(QString::fromLatin1(name));
        QTRY_VERIFY2(row->rect().contains(QRect(button->mapTo(row, QPoint()), button->size())), name);
        QVERIFY2(button->width() >= button->minimumSizeHint().width(), name);
      }
      auto* text = row->findChild<QLabel*>(QStringLiteral("text"));
      QVERIFY2(text->width() >= 150, qPrintable(QString::number(text->width())));
    }
  }

  void names_and_what_is_said_of_them_stand_in_columns() {
    const body::Rig rig = body::load_rig("line-in-arm").value();
    SensorChooser chooser;
    chooser.set_sensors(rig, {0, 1, 2, 3, 4}, {0}, [](int) { return refused_state(); });
    chooser.resize(500, 400);
    chooser.show();
    QTRY_VERIFY(chooser.isVisible());
    std::set<int> columns;
    for (VerdictBadge* badge : chooser.findChildren<VerdictBadge*>()) {
      columns.insert(badge->mapTo(&chooser, QPoint()).x());
    }
    QCOMPARE(columns.size(), std::size_t{1});
  }

  void cells_have_equal_areas_and_fill_both_discs() {
    double total = 0.0;
    for (int cell = 0; cell < calibrate::SphereCoverage::kCells; ++cell) {
      const double one = area(cell_outline(cell));
      // The outline's arcs are cut into straight pieces.
      QVERIFY2(std::abs(one - 2.0 * kPi / calibrate::SphereCoverage::kCells) < 0.02 * one,
               qPrintable(QString::number(cell)));
      total += one;
    }
    QVERIFY(std::abs(total - 2.0 * kPi) < 0.1);
  }

  void a_direction_lies_in_the_outline_of_its_cell() {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 500; ++i) {
      const Vector3d direction(normal(random), normal(random), normal(random));
      const DiscPoint point = disc_point(direction);
      QVERIFY(std::hypot(point.x, point.y) <= 1.0 + 1e-9);
      QPolygonF polygon;
      const int cell = calibrate::SphereCoverage::cell_of(direction);
      for (const DiscPoint& corner : cell_outline(cell)) {
        QCOMPARE(corner.disc, point.disc);
        polygon << QPointF(corner.x, corner.y);
      }
      // Points within the sagitta of an arc's straight pieces may fall outside by a hair.
      const QPointF centre(disc_point(calibrate::SphereCoverage::centre(cell)).x,
                           disc_point(calibrate::SphereCoverage::centre(cell)).y);
      const QPointF inward = QPointF(point.x, point.y) * 0.99 + centre * 0.01;
      QVERIFY(polygon.containsPoint(inward, Qt::OddEvenFill));
    }
  }

  void the_cube_turns_by_the_shortest_arc() {
    SensorCube cube;
    for (const Vector3d& up : {Vector3d(0, 0, -1), Vector3d(1, 0, 0), Vector3d(1, -1, 1)}) {
      cube.set_up(up);
      QVERIFY((cube.orientation() * up.normalized() - Vector3d::UnitZ()).norm() < 1e-9);
    }
  }

  void words_name_what_carries_the_direction() {
    QCOMPARE(up_words({0, 0, 1}), QStringLiteral("+z up"));
    QCOMPARE(up_words({0.7, -0.7, 0.1}), QStringLiteral("+x and ") + QChar(0x2212) + QStringLiteral("y up"));
    QVERIFY(up_words({1, 1, 1}).startsWith(QStringLiteral("corner")));
    QCOMPARE(format_mg(0.00324), QStringLiteral("3.2 mg"));
    QCOMPARE(format_mg(0.0412), QStringLiteral("41 mg"));
    QCOMPARE(format_degrees(-2.04, true), QString(QChar(0x2212)) + QStringLiteral("2.0°"));
    QCOMPARE(format_degrees(0.01, true), QStringLiteral("0.0°"));
  }

  void states_have_words_and_numbers() {
    calibrate::SensorCalibration range;
    range.method = "nominal";
    QCOMPARE(range_state(range).tone, Tone::kUnknown);
    range.method = "ellipsoid";
    range.residual_g = 0.004;
    QCOMPARE(range_state(range).tone, Tone::kGood);
    range.residual_g = 0.02;
    QCOMPARE(range_state(range).word, QStringLiteral("Usable"));
    range.residual_g = 0.05;
    QCOMPARE(range_state(range).word, QStringLiteral("Repeat"));
    calibrate::MountCalibration mount;
    mount.method = "two poses";
    mount.pose_angle_deg = 84.5;
    QCOMPARE(mount_state(mount).word, QStringLiteral("Usable"));
    QCOMPARE(mount_state(mount).number, QStringLiteral("84.5°"));
    mount.pose_angle_deg = 75.0;
    QCOMPARE(mount_state(mount).word, QStringLiteral("Repeat"));
  }

  void the_meter_says_who_moves_and_who_is_silent() {
    FakeSource source;
    SimulatedWearer wearer(source);
    MovementMeter meter({1, 2}, wearer.true_ranges());
    connect(&source, &CalibrationSource::arrived, &source, [&meter](const auto& frames) {
      for (const auto& frame : frames) {
        meter.push(frame);
      }
    });
    wearer.hold(0, 0, 2.0, 0.0, 0.1, {2});
    QVERIFY(meter.movements()[0].movement_g < 0.01);
    // A window of one second does not hold whole periods of the swaying.
    QVERIFY(std::abs(meter.movements()[1].movement_g - 0.1) < 0.015);
    wearer.unplugged = {1};
    wearer.hold(0, 0, 0.8);
    QVERIFY(!meter.movements()[0].has_signal);
    QVERIFY(meter.movements()[1].has_signal);
  }

  void gauges_say_in_words_what_they_say_in_colour() {
    RateGauge gauge;
    gauge.set_rate(0.2, 1.2, false, true);
    QVERIFY(gauge.word().startsWith(QStringLiteral("Steady")));
    gauge.set_rate(2.0, 1.2, false, true);
    QCOMPARE(gauge.word(), QStringLiteral("Too fast: 115°/s"));
    gauge.set_rate(0.2, 1.2, true, true);
    QVERIFY(gauge.word().startsWith(QStringLiteral("Jerky")));
    QCOMPARE(MovementBars::row_words({QStringLiteral("hand"), 0.045, true}, 0.02), QStringLiteral("moves: 45 mg"));
    QCOMPARE(MovementBars::row_words({QStringLiteral("hand"), 0.0, false}, 0.02), QStringLiteral("no signal"));
    CountdownDial dial;
    dial.resize(300, 300);
    for (const QString& text : {QStringLiteral("5"), QStringLiteral("30"), QStringLiteral("moves")}) {
      dial.set_state(text, 0.5, Tone::kGood);
      QVERIFY(dial.text_pixels() >= 48);
    }
  }

  void pictures_show_gravity_as_the_rig_says() {
    FakeSource source;
    const body::Rig& rig = source.rig();
    for (int group = 0; group < static_cast<int>(rig.groups.size()); ++group) {
      for (int pose = 0; pose < 2; ++pose) {
        const auto figure = figure_in_pose(rig, source.skeleton(), group, pose);
        const body::CalibrationGroup& limb = rig.groups[static_cast<std::size_t>(group)];
        for (const int sensor : limb.sensors) {
          const int segment = source.skeleton().find(rig.accelerometers[static_cast<std::size_t>(sensor)].segment);
          const Vector3d gravity_W = figure.at(static_cast<std::size_t>(segment)).R_WL *
                                     (pose == 0 ? limb.first.gravity_L : limb.second.gravity_L);
          QVERIFY((gravity_W + Vector3d::UnitZ()).norm() < 1e-9);
        }
      }
    }
    // The stretched arm points forward.
    const auto stretched = figure_in_pose(rig, source.skeleton(), 0, 0);
    QVERIFY((stretched[2].R_WL * Vector3d::UnitX()).x() > 0.99);
  }

  void the_newest_of_the_library_is_used() {
    FakeSource source;
    const body::Rig& rig = source.rig();
    take::LibraryListing listing;
    for (const char* date : {"2026-11-01T10:00:00Z", "2026-05-01T10:00:00Z", "2026-03-01T10:00:00Z"}) {
      take::SensorRecord record;
      record.key = take::sensor_key(rig, rig.accelerometers[2]);
      record.calibration.method = "ellipsoid";
      record.calibration.date = date;
      listing.sensors.push_back(record);
      take::MountRecord mounts;
      mounts.rig = rig.name;
      mounts.subject = "Ada";
      mounts.date = date;
      mounts.mounts.push_back({"forearm", "two poses", date, Quaterniond::Identity(), 89.0, 0.01});
      listing.mounts.push_back(mounts);
    }
    const calibrate::RigCalibration found = newest_of_library(listing, rig, "Ada");
    QCOMPARE(found.sensors[2].date, std::string("2026-11-01T10:00:00Z"));
    QCOMPARE(found.mounts[2].date, std::string("2026-11-01T10:00:00Z"));
    QCOMPARE(found.sensors[1].method, std::string("nominal"));
    QCOMPARE(newest_of_library(listing, rig, "Bob").mounts[2].method, std::string("nominal"));
  }

  void snapshots_that_overlap_give_each_reading_once() {
    std::vector<decode::AccelerationFrame> frames(10);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      frames[i].time_s = 0.1 * static_cast<double>(i);
    }
    QCOMPARE(newer_frames(frames, -1.0).size(), std::size_t{10});
    QCOMPARE(newer_frames(frames, frames[6].time_s).size(), std::size_t{3});
    QCOMPARE(newer_frames(frames, 5.0).size(), std::size_t{0});
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CalibrationPartsTest)
#include "calibration_parts_test.moc"
