/// The live view of the Solve workspace over a made-up capture: what it shows and when, turning bones, recording by key
/// from everywhere.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <algorithm>

#include "base/units.h"
#include "common/latency_text.h"
#include "common/widgets.h"
#include "ui/support/solve_window.h"
#include "workspaces/capture/capture_model.h"
#include "workspaces/record_banner.h"
#include "workspaces/solve/solve_pose.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui::testing {

class LiveViewTest : public SolveWindowTest {
  Q_OBJECT

 private:
  // In the Solve workspace, with the capture running.
  void start_live() {
    start(capture_services());
    studio_->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(studio_->window.get()));
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(live().open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    QTRY_VERIFY(capture().can_record());
  }
  [[nodiscard]] LiveModel& live() const { return studio_->context->live(); }
  [[nodiscard]] CaptureModel& capture() const { return CaptureModel::of(*studio_->context); }
  [[nodiscard]] RecordBanner& banner() const { return *workspace().findChild<RecordBanner*>(); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(studio_->window.get(), key, modifiers);
  }

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }
  void cleanup() {
    studio_.reset();
    solving_.reset();
  }

  void live_capture_moves_the_figure_and_measures_its_latency() {
    start(capture_services());
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(studio_->context->live().open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    QSignalSpy frames(&workspace().viewer(), &ViewerWidget::frame_rendered);
    const LiveModel& live = studio_->context->live();
    // The first second is not counted.
    QTRY_VERIFY_WITH_TIMEOUT(live.latency().poses > 30, 20000);
    const solve::LatencyReport report = live.latency();
    QVERIFY(static_cast<std::size_t>(frames.size()) >= report.poses);
    QVERIFY(qAbs(report.of(solve::LatencyStage::kCycle).mean_s - 0.017) < 1e-6);
    QVERIFY(report.of(solve::LatencyStage::kDraw).mean_s > 0.0);
    double sum = 0.0;
    for (std::size_t stage = 0; stage + 1 < solve::kLatencyStages; ++stage) {
      sum += report.stages[stage].mean_s;
    }
    QVERIFY(qAbs(report.of(solve::LatencyStage::kTotal).mean_s - sum) < 1e-9);
    const Eigen::Vector3d then = workspace().viewer().pose()[3].p_WL;
    QTRY_VERIFY((workspace().viewer().pose()[3].p_WL - then).norm() > 0.01);
    qInfo().noquote() << latency_sentences(report, 0.0);
    const auto told = [this] {
      const auto labels = studio_->window->findChildren<ElidedLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const ElidedLabel* label) {
        return label->full_text().contains(QStringLiteral("sensor to screen"));
      });
    };
    QTRY_VERIFY(told());
    save(QStringLiteral("solve-live"));
    studio_->context->live().close();
    QTRY_VERIFY(!workspace().shows_live());
  }

  void after_a_recording_its_take_is_shown_and_the_live_choice_is_kept() {
    start(capture_services());
    studio_->window->show_workspace(QStringLiteral("solve"));
    LiveModel& live = studio_->context->live();
    QVERIFY(live.open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    // The whole figure is in the picture, however the arm is stretched.
    const OrbitCamera& camera = workspace().viewer().camera();
    const QSizeF size = workspace().viewer().size();
    QTRY_VERIFY(workspace().viewer().isVisible());
    for (const Eigen::Vector3d& point : reach_extent(live.settings().skeleton)) {
      const auto seen = camera.project(point, {size.width(), size.height()});
      QVERIFY(seen && seen->x() > 0 && seen->x() < size.width() && seen->y() > 0 && seen->y() < size.height());
    }
    QVERIFY(live.start_recording(studio_->take_folder(QStringLiteral("first.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    QVERIFY(workspace().shows_live());
    live.stop_recording();
    QTRY_VERIFY(studio_->context->document().is_open());
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(!workspace().shows_live());
    std::vector<body::SegmentPose> expected;
    model().pose_at(0.0, expected);
    QTest::qWait(100);  // Live figures still come.
    QVERIFY(workspace().viewer().pose()[3].p_WL.isApprox(expected[3].p_WL));
    // The choice outlives a visit elsewhere, both ways.
    QPushButton* button = this->button(QStringLiteral("Live"));
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(workspace().shows_live());
    studio_->window->show_workspace(QStringLiteral("export"));
    QVERIFY(!model().shows_live());
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(workspace().shows_live() && model().shows_live());
    QTest::mouseClick(button, Qt::LeftButton);
    studio_->window->show_workspace(QStringLiteral("export"));
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(!workspace().shows_live());
    // A new recording is watched whatever was chosen.
    QVERIFY(live.start_recording(studio_->take_folder(QStringLiteral("second.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    QVERIFY(workspace().shows_live());
    live.stop_recording();
    QTRY_VERIFY(!workspace().shows_live());
    QTRY_COMPARE(studio_->context->document().name(), QStringLiteral("second"));
  }

  void a_bone_turned_live_turns_at_once_and_becomes_keys_of_the_take() {
    start(capture_services());
    studio_->window->show_workspace(QStringLiteral("solve"));
    LiveModel& live = studio_->context->live();
    QVERIFY(live.open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    QTRY_COMPARE(workspace().viewer().pose().size(), live.settings().skeleton.segments.size());
    Q_EMIT workspace().viewer().segment_clicked(2);
    auto* box = find<QDoubleSpinBox>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    QVERIFY(box != nullptr && box->isEnabled());
    QTRY_VERIFY(std::abs(azimuth(2)) < 1e-6);
    box->setValue(40.0);
    QTRY_VERIFY(std::abs(azimuth(2) - radians(40.0)) < 1e-6);
    save(QStringLiteral("solve-live-turned"));
    QUndoStack& undo = studio_->context->undo_stack();
    undo.undo();
    QTRY_VERIFY(std::abs(azimuth(2)) < 1e-6);
    QCOMPARE(box->value(), 0.0);
    undo.redo();
    QTRY_VERIFY(std::abs(azimuth(2) - radians(40.0)) < 1e-6);
    // In a recording: where it stood, then a turn by the slider, one taken back, and none of the other bones.
    QVERIFY(live.start_recording(studio_->take_folder(QStringLiteral("turned.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    QTRY_VERIFY(live.snapshot()->recorded_s > 0.3);
    auto* slider = find<QSlider>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    slider->setSliderDown(true);
    const double begun_s = live.snapshot()->recorded_s;
    slider->setSliderPosition(500);
    QTRY_VERIFY(live.snapshot()->recorded_s > begun_s + 0.2);
    slider->setSliderPosition(900);
    const double ended_s = live.snapshot()->recorded_s;
    slider->setSliderDown(false);
    const int steps = undo.count();
    box->setValue(10.0);
    undo.undo();
    QCOMPARE(undo.index(), steps);
    QTest::qWait(50);
    live.stop_recording();
    QTRY_COMPARE(studio_->context->document().name(), QStringLiteral("turned"));
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    const auto& keys = model().keys().keys(2);
    QCOMPARE(keys.size(), std::size_t{3});
    QCOMPARE(keys[0].time_s, 0.0);
    QVERIFY(std::abs(keys[0].value - radians(40.0)) < 1e-9);
    QVERIFY(std::abs(keys[1].time_s - begun_s) < 0.02 && std::abs(keys[1].value - radians(40.0)) < 1e-9);
    QVERIFY(std::abs(keys[2].time_s - ended_s) < 0.02 && std::abs(keys[2].value - radians(90.0)) < 1e-9);
    for (const int other : {0, 1, 3}) {
      QVERIFY(model().keys().keys(other).empty());
    }
    // It is in the solve itself, and so on the disk and in what is exported.
    studio_->context->time().set_playhead(6.0);
    QVERIFY(std::abs(azimuth(2) - radians(90.0)) < 1e-6);
    QTRY_VERIFY([&] {
      const std::lock_guard lock(solving_->mutex);
      return solving_->stored && solving_->stored->settings.headings.size() > 2 &&
             solving_->stored->settings.headings[2].size() == 3;
    }());
    // Live the bone still stands as it was turned last.
    QTest::mouseClick(button(QStringLiteral("Live")), Qt::LeftButton);
    QTRY_VERIFY(std::abs(azimuth(2) - radians(90.0)) < 1e-6);
    Q_EMIT workspace().viewer().segment_clicked(2);
    QTest::mouseClick(button(QStringLiteral("Back to 0°")), Qt::LeftButton);
    QTRY_VERIFY(std::abs(azimuth(2)) < 1e-6);
  }

  void record_and_mark_by_key_in_every_workspace() {
    start_live();
    MarkerModel& markers = studio_->context->markers();
    int takes = 0;
    for (const char* place : {"solve", "export", "calibrate", "capture", "welcome"}) {
      studio_->window->show_workspace(QString::fromLatin1(place));
      QTRY_VERIFY2(capture().can_record(), place);
      press(Qt::Key_R);
      QTRY_VERIFY2(live().recording(), place);
      press(Qt::Key_M);
      QCOMPARE(markers.markers().size(), std::size_t{1});
      if (takes == 0) {
        QVERIFY(banner().isVisible());
        auto* time = banner().findChild<QLabel*>(QStringLiteral("banner_time"));
        QVERIFY2(time->font().pixelSize() >= 48, "readable from two metres");
        QTRY_VERIFY(time->text() != QStringLiteral("0:00.0"));
        QVERIFY(time->width() >= time->fontMetrics().horizontalAdvance(time->text()));
        QVERIFY(banner().mapToGlobal(QPoint()).y() < workspace().viewer().mapToGlobal(QPoint()).y());
        QVERIFY(says(QStringLiteral("Marker 1 at 0:0")));
        save(QStringLiteral("solve-recording"));
      }
      const QString name = capture().take_name();
      press(Qt::Key_R);
      QTRY_COMPARE(studio_->context->document().name(), name);
      QCOMPARE(studio_->context->document().take()->events.size(), std::size_t{1});
      ++takes;
    }
    QCOMPARE(takes, 5);
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(!banner().isVisible());
  }

  void alone_in_the_suit_one_records_after_a_countdown() {
    start_live();
    QSignalSpy cues(&capture().sounds(), &CueSounds::played);
    press(Qt::Key_R, Qt::ShiftModifier);
    QCOMPARE(capture().countdown(), CaptureModel::kCountdown_s);
    QVERIFY(banner().isVisible());
    QCOMPARE(banner().findChild<QLabel*>(QStringLiteral("banner_time"))->text(), QStringLiteral("5"));
    QVERIFY(!live().recording());
    save(QStringLiteral("solve-countdown"));
    QTRY_VERIFY_WITH_TIMEOUT(live().recording(), 15000);
    QCOMPARE(capture().countdown(), 0);
    QCOMPARE(cues.size(), CaptureModel::kCountdown_s + 1);
    QCOMPARE(cues.last()[0].value<CueSounds::Cue>(), CueSounds::Cue::kGo);
    press(Qt::Key_R);
    QTRY_VERIFY(studio_->context->document().is_open());
    // R ends a countdown, and nothing is recorded.
    QTRY_VERIFY(capture().can_record());
    press(Qt::Key_R, Qt::ShiftModifier);
    QCOMPARE(capture().countdown(), CaptureModel::kCountdown_s);
    press(Qt::Key_R);
    QCOMPARE(capture().countdown(), 0);
    QVERIFY(!banner().isVisible());
    // Nor when the device goes meanwhile: that is told and heard.
    press(Qt::Key_R, Qt::ShiftModifier);
    live().close();
    QTRY_COMPARE(capture().countdown(), 0);
    QCOMPARE(cues.last()[0].value<CueSounds::Cue>(), CueSounds::Cue::kLost);
    QVERIFY(!live().recording() && !live().starting());
    QVERIFY(std::any_of(studio_->context->notifications().all().begin(), studio_->context->notifications().all().end(),
                        [](const Notification& one) { return one.text.contains(QStringLiteral("countdown")); }));
  }

  void without_a_device_r_leads_to_where_it_is_chosen() {
    start();
    studio_->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(studio_->window.get()));
    studio_->window->show_workspace(QStringLiteral("solve"));
    press(Qt::Key_R);
    QCOMPARE(studio_->window->current_workspace(), QStringLiteral("capture"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::LiveViewTest)
#include "live_view_test.moc"
