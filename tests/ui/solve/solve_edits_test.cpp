/// What is edited in the Solve workspace: keys, lengths, smoothing, markers; undo, and how edits get to disk.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <algorithm>
#include <atomic>

#include "base/units.h"
#include "common/widgets.h"
#include "simulate/simulate.h"
#include "timeline/timeline_canvas.h"
#include "ui/support/solve_window.h"
#include "workspaces/solve/bone_card.h"
#include "workspaces/solve/quality_card.h"
#include "workspaces/solve/settings_card.h"
#include "workspaces/solve/solve_pose.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui::testing {

class SolveEditsTest : public SolveWindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }
  void cleanup() {
    studio_.reset();
    solving_.reset();
  }

  void nothing_of_the_inspector_is_cut_off() {
    open_solved();
    for (const char* other : {"capture", "calibrate", "export"}) {
      studio_->window->show_workspace(QString::fromLatin1(other));
      QTest::qWait(50);
      studio_->window->show_workspace(QStringLiteral("solve"));
      QTest::qWait(50);
      auto* slider = find<QSlider>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
      QWidget* content = slider;
      while (qobject_cast<QScrollArea*>(content->parentWidget()->parentWidget()) == nullptr) {
        content = content->parentWidget();
      }
      const auto* area = qobject_cast<QScrollArea*>(content->parentWidget()->parentWidget());
      QTRY_VERIFY2(area->viewport()->width() >= content->width(), other);
    }
  }

  void turning_a_bone_sets_a_key_at_once_and_can_be_undone() {
    open_solved();
    TimeModel& time = studio_->context->time();
    time.set_playhead(2.0);
    studio_->context->selection().select(SelectionKind::kSegment, 2);
    const double before = azimuth(2);
    auto* box = find<QDoubleSpinBox>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    QVERIFY(box != nullptr && box->isEnabled());
    box->setValue(40.0);
    QVERIFY(std::abs(azimuth(2) - before - radians(40.0)) < 1e-6);
    QCOMPARE(solving_->solved.load(), 1);  // No new solve.
    time.set_playhead(4.0);
    box->setValue(-20.0);
    time.set_playhead(3.0);
    QVERIFY(std::abs(box->value() - 10.0) < 1e-6);  // Half way between the two keys.
    auto* list = find<QListWidget>(QStringLiteral("Keys of the rotation about the vertical"));
    QCOMPARE(list->count(), 2);
    QUndoStack& undo = studio_->context->undo_stack();
    QCOMPARE(undo.count(), 2);
    undo.undo();
    undo.undo();
    time.set_playhead(2.0);
    QVERIFY(std::abs(azimuth(2) - before) < 1e-6);
    QCOMPARE(list->count(), 0);
    undo.redo();
    QVERIFY(std::abs(azimuth(2) - before - radians(40.0)) < 1e-6);
    // Kept with the solve.
    QTRY_VERIFY(solving_->saved.load() >= 2);
    const std::lock_guard lock(solving_->mutex);
    QCOMPARE(solving_->stored->settings.headings[2].size(), std::size_t{1});
    const auto pose = motion::pose_at(solving_->stored->clip, 2.0);
    QVERIFY(pose[2].R_WL.angularDistance(workspace().viewer().pose()[2].R_WL) < 1e-6);
  }

  void a_number_that_was_typed_is_undone_by_key_where_it_was_typed() {
    open_solved();
    studio_->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(studio_->window.get()));
    studio_->context->time().set_playhead(2.0);
    studio_->context->selection().select(SelectionKind::kSegment, 2);
    auto* box = find<QDoubleSpinBox>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    QVERIFY(box != nullptr);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("60"));
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(std::abs(box->value() - 60.0) < 1e-6);
    QUndoStack& undo = studio_->context->undo_stack();
    QCOMPARE(undo.index(), 1);
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undo.index(), 0);
    QVERIFY(std::abs(box->value()) < 1e-6);
    // What is only being typed is left alone by a figure that moves, and by the program's undo.
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(undo.index(), 1);
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("4"));
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undo.index(), 1);
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("45"));
    studio_->context->time().set_playhead(3.0);
    QVERIFY(box->text().startsWith(QStringLiteral("45")));
  }

  void a_slider_held_is_one_step_of_undo() {
    open_solved();
    studio_->context->selection().select(SelectionKind::kSegment, 1);
    auto* slider = find<QSlider>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    QVERIFY(slider != nullptr);
    slider->setSliderDown(true);
    for (const int steps : {100, 200, 300}) {
      slider->setSliderPosition(steps);
    }
    slider->setSliderDown(false);
    QCOMPARE(studio_->context->undo_stack().count(), 1);
    QVERIFY(std::abs(model().keys().value_at(1, 0.0) - radians(30.0)) < 1e-9);
  }

  void length_changes_at_once_and_can_be_undone() {
    open_solved();
    studio_->context->selection().select(SelectionKind::kSegment, 1);
    auto* box = find<QDoubleSpinBox>(QStringLiteral("Length of the bone in millimetres"));
    const double before = box->value();
    const Eigen::Vector3d elbow = workspace().viewer().pose()[2].p_WL;
    box->setValue(before + 50.0);
    QVERIFY(std::abs((workspace().viewer().pose()[2].p_WL - elbow).norm() - 0.05) < 1e-6);
    QCOMPARE(solving_->solved.load(), 1);
    studio_->context->undo_stack().undo();
    QVERIFY((workspace().viewer().pose()[2].p_WL - elbow).norm() < 1e-9);
    QVERIFY(std::abs(box->value() - before) < 0.05);
    studio_->context->undo_stack().redo();
    // Survives a new solve and reaches the disk.
    model().start();
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(std::abs(model().skeleton().segments[1].length - (before + 50.0) / 1000.0) < 1e-9);
    QTRY_VERIFY([&] {
      const std::lock_guard lock(solving_->mutex);
      return std::abs(solving_->stored->clip.skeleton.segments[1].length - (before + 50.0) / 1000.0) < 1e-9;
    }());
  }

  void smoothing_solves_again_and_undo_does_too() {
    open_solved();
    const double playhead = 3.0;
    studio_->context->time().set_playhead(playhead);
    auto* box = find<QComboBox>(QStringLiteral("Smoothing"));
    box->setCurrentIndex(box->findText(QStringLiteral("None")));
    Q_EMIT box->activated(box->currentIndex());
    QTRY_COMPARE(solving_->solved.load(), 2);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QCOMPARE(model().solve()->settings.smoothing, solve::Smoothing::kNone);
    QCOMPARE(studio_->context->time().playhead_s(), playhead);  // One keeps one's place.
    studio_->context->undo_stack().undo();
    QTRY_COMPARE(solving_->solved.load(), 3);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QCOMPARE(model().solve()->settings.smoothing, solve::SolveSettings{}.smoothing);
    auto* strength = find<QSpinBox>(QStringLiteral("Time scale of the smoothing in milliseconds"));
    strength->setValue(200);
    QTRY_COMPARE(solving_->solved.load(), 4);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(std::abs(model().solve()->settings.smoothing_s - 0.2) < 1e-9);
  }

  void edits_of_one_take_are_saved_before_another_opens() {
    open_solved();
    QTRY_COMPARE(solving_->saved.load(), 1);
    QVERIFY(model().change_length(1, 0.31));
    open(QStringLiteral("other.take"));
    QTRY_VERIFY(solving_->saved.load() > 1);
    QVERIFY(!studio_->context->undo_stack().canUndo());
    const std::lock_guard lock(solving_->mutex);
    QVERIFY(std::abs(solving_->stored->clip.skeleton.segments[1].length - 0.31) < 1e-9);
  }

  void edits_made_while_it_is_solved_again_stay() {
    open_solved();
    QVERIFY(model().change_length(1, 0.33));
    solving_->block = true;
    model().start();
    QTRY_COMPARE(solving_->solved.load(), 2);
    QVERIFY(model().change_length(1, 0.4));
    QVERIFY(model().key_editor().set_value(2, 1.0, 0.5));
    model().save();  // Meets the solve that is going on.
    solving_->block = false;
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(std::abs(model().skeleton().segments[1].length - 0.4) < 1e-9);
    QVERIFY(std::abs(model().keys().value_at(2, 1.0) - 0.5) < 1e-9);
    QTRY_VERIFY([&] {
      const std::lock_guard lock(solving_->mutex);
      return std::abs(solving_->stored->clip.skeleton.segments[1].length - 0.4) < 1e-9 &&
             solving_->stored->settings.headings[2].size() == 1;
    }());
    studio_->context->undo_stack().undo();
    studio_->context->undo_stack().undo();
    QVERIFY(std::abs(model().skeleton().segments[1].length - 0.33) < 1e-9);
  }

  void an_older_state_never_follows_a_newer_one_on_disk() {
    SolveWriter writer;
    const int older = writer.issue(), newer = writer.issue();
    std::vector<int> written;
    const auto write = [&](int number, const char* take) {
      return writer.write(number, take, [&] {
        written.push_back(number);
        return Status();
      });
    };
    QVERIFY(write(newer, "a.take").ok());
    QVERIFY(write(older, "a.take").ok());
    QVERIFY(write(older, "b.take").ok());
    QCOMPARE(written, (std::vector<int>{newer, older}));
  }

  void a_damaged_solve_is_set_aside_and_its_keys_live_on() {
    FakeSolving made;
    SolveServices services = core_solve_services();
    services.solve = made.services().solve;
    studio_ = std::make_unique<SolveStudio>(services);
    const take::Take take = made_up_take(studio_->take_folder(QStringLiteral("swing.take")), made.seconds);
    solve::SolveSettings settings;
    settings.headings = {{}, {}, {{1.0, 0.5}}};
    QVERIFY(solve::save_solve(take, made_up_solve(take, settings, made.seconds)).ok());
    const std::filesystem::path solves = take.folder / "solves";
    QFile clip(QString::fromStdString((solves / "default" / "clip.glb").string()));
    QVERIFY(clip.open(QIODevice::WriteOnly) && clip.write("not a clip") == 10);
    clip.close();
    studio_->context->document().set(take);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QCOMPARE(model().keys().keys(2).size(), std::size_t{1});
    QVERIFY(std::filesystem::exists(solves / "default.damaged-1" / "settings.json"));
    QVERIFY(studio_->context->notifications().all().back().text.contains(QStringLiteral("default.damaged-1")));
    QTRY_VERIFY(std::filesystem::exists(solves / "default" / "clip.glb"));
    QCOMPARE(services.list(take), std::vector<std::string>{"default"});
    // With nothing to be read of it, it is kept all the same.
    QTRY_VERIFY(studio_->context->jobs().jobs().empty());
    std::filesystem::remove(solves / "default" / "settings.json");
    studio_->context->document().close();
    studio_->context->document().set(take);
    QTRY_VERIFY(std::filesystem::exists(solves / "default.damaged-2" / "clip.glb"));
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QCOMPARE(model().keys().keys(2).size(), std::size_t{0});
  }

  void markers_on_the_timeline_go_through_undo() {
    start();
    take::Take take = made_up_take(studio_->take_folder(QStringLiteral("swing.take")), solving_->seconds);
    take.events = {{SampleIndex{96000 + 48000}, "marker", "clap", 1}};
    std::filesystem::create_directories(take.folder);
    studio_->context->document().set(take);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    studio_->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(studio_->window.get()));
    MarkerModel& markers = studio_->context->markers();
    auto* canvas = studio_->window->findChild<TimelineCanvas*>();
    QVERIFY(canvas != nullptr && canvas->marker_position(1).has_value());
    canvas->setFocus();
    const QPoint from = canvas->marker_position(1)->toPoint();
    QTest::mousePress(canvas, Qt::LeftButton, {}, from);
    for (const int by : {30, 60, 90}) {
      const QPointF at = from + QPoint(by, 0);
      QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(canvas, &move);
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, from + QPoint(90, 0));
    const double moved = markers.time_s(*markers.find(1));
    QVERIFY(std::abs(moved - 3.0 - 90 * canvas->scale().seconds_per_pixel()) < 1.0 / 60.0);
    QCOMPARE(studio_->context->undo_stack().count(), 1);
    QCOMPARE(studio_->context->selection().marker(), std::int64_t{1});
    QTest::keyClick(canvas, Qt::Key_F2);
    auto* field = canvas->findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    QTest::keyClicks(field, QStringLiteral("jump"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(markers.find(1)->text, QStringLiteral("jump"));
    save(QStringLiteral("solve-marker"));
    QTest::keyClick(canvas, Qt::Key_Delete);
    QVERIFY(markers.markers().empty());
    QVERIFY(!canvas->marker_position(1).has_value());
    QCOMPARE(studio_->context->selection().item().kind, SelectionKind::kNone);
    for (const int steps : {2, 1, 0}) {
      QTest::keyClick(canvas, Qt::Key_Z, Qt::ControlModifier);
      QCOMPARE(studio_->context->undo_stack().index(), steps);
    }
    QCOMPARE(markers.find(1)->text, QStringLiteral("clap"));
    QCOMPARE(markers.time_s(*markers.find(1)), 3.0);
    // All of it stands in the take.
    studio_->context->saves().finish();
    QFile lines(QString::fromStdString((take.folder / "events.jsonl").string()));
    QVERIFY(lines.open(QIODevice::ReadOnly));
    QCOMPARE(lines.readAll().count('\n'), 6);
  }

  void m_sets_a_marker_at_the_playhead() {
    start();
    take::Take take = made_up_take(studio_->take_folder(QStringLiteral("swing.take")), solving_->seconds);
    take.events.clear();
    std::filesystem::create_directories(take.folder);
    studio_->context->document().set(take);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    studio_->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(studio_->window.get()));
    studio_->context->time().set_playhead(1.5);
    QTest::keyClick(studio_->window.get(), Qt::Key_M);
    MarkerModel& markers = studio_->context->markers();
    QCOMPARE(markers.markers().size(), std::size_t{1});
    QVERIFY(std::abs(markers.time_s(markers.markers().front()) - 3.5) < 1e-3);
    QCOMPARE(studio_->context->selection().marker(), markers.newest());
    QTest::keyClick(studio_->window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(markers.markers().empty());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::SolveEditsTest)
#include "solve_edits_test.moc"
