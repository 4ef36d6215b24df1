#include "timeline/timeline_widget.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>

#include "base/units.h"
#include "common/theme.h"

namespace limbwave::ui {

class TimelineWidgetTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<TimeModel> time_;
  std::unique_ptr<KeyModel> model_;
  std::unique_ptr<QUndoStack> stack_;
  std::unique_ptr<KeyEditor> keys_;
  std::unique_ptr<QWidget> window_;
  TimelineWidget* timeline_ = nullptr;
  QLineEdit* text_ = nullptr;

  [[nodiscard]] TimelineCanvas& canvas() const { return timeline_->canvas(); }
  [[nodiscard]] QPoint ruler(double time_s) const {
    return QPointF(canvas().scale().x(time_s), canvas().ruler_middle()).toPoint();
  }
  [[nodiscard]] QPoint key(int lane, int index) const {
    return canvas().key_position(lane, model_->keys(lane)[static_cast<std::size_t>(index)].time_s).toPoint();
  }
  void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&canvas(), button, {}, from);
    for (int i = 1; i <= 4; ++i) {
      const QPointF at = QPointF(from) + (to - from) * (i / 4.0);
      QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, button, {});
      QApplication::sendEvent(&canvas(), &move);
    }
    QTest::mouseRelease(&canvas(), button, {}, to);
  }

 private Q_SLOTS:
  void init() {
    apply_theme(*qApp, ThemeKind::kDark);
    time_ = std::make_unique<TimeModel>();
    model_ = std::make_unique<KeyModel>();
    stack_ = std::make_unique<QUndoStack>();
    keys_ = std::make_unique<KeyEditor>(*model_, *stack_);
    window_ = std::make_unique<QWidget>();
    timeline_ = new TimelineWidget(*time_, *keys_, window_.get());
    text_ = new QLineEdit(window_.get());
    auto* layout = new QVBoxLayout(window_.get());
    layout->addWidget(text_);
    layout->addWidget(timeline_, 1);
    model_->reset({tr("torso"), tr("upper_arm"), tr("forearm")}, 12.0, 1.0 / 60.0);
    time_->set_extent(12.0, 1.0 / 60.0);
    canvas().set_hint(tr("Select a bone"));
    window_->resize(1200, 260);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->activateWindow();
    canvas().setFocus();
  }

  void cleanup() {
    window_.reset();
    keys_.reset();
  }

  void scrubbing_in_the_ruler_moves_the_playhead() {
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, ruler(3.0));
    QVERIFY(std::abs(time_->playhead_s() - 3.0) < canvas().scale().seconds_per_pixel());
    drag(ruler(3.0), ruler(7.0));
    QVERIFY(std::abs(time_->playhead_s() - 7.0) < canvas().scale().seconds_per_pixel());
    drag(ruler(7.0), ruler(7.0) + QPoint(5000, 0));
    QCOMPARE(time_->playhead_s(), 12.0);
  }

  void wheel_zooms_about_the_pointer() {
    const QPointF at = ruler(9.0);
    QWheelEvent wheel(at, canvas().mapToGlobal(at), {}, {0, 480}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas(), &wheel);
    QVERIFY(time_->visible_end_s() - time_->visible_begin_s() < 6.0);
    QVERIFY(std::abs(canvas().scale().x(9.0) - at.x()) < 2.0);
    const double begin = time_->visible_begin_s();
    drag({600, 60}, {700, 60}, Qt::MiddleButton);
    QVERIFY(time_->visible_begin_s() < begin);
  }

  void keys_play_step_and_shuttle() {
    QTest::keyClick(&canvas(), Qt::Key_Space);
    QVERIFY(time_->playing());
    QTest::keyClick(&canvas(), Qt::Key_Space);
    QVERIFY(!time_->playing());
    time_->set_playhead(5.0);
    QTest::keyClick(&canvas(), Qt::Key_Right);
    QCOMPARE(std::llround(time_->playhead_s() * 60), 301LL);
    QTest::keyClick(&canvas(), Qt::Key_Left);
    QTest::keyClick(&canvas(), Qt::Key_Left);
    QCOMPARE(std::llround(time_->playhead_s() * 60), 299LL);
    QTest::keyClick(&canvas(), Qt::Key_L);
    QTest::keyClick(&canvas(), Qt::Key_L);
    QCOMPARE(time_->speed(), 2.0);
    QTest::keyClick(&canvas(), Qt::Key_J);
    QCOMPARE(time_->speed(), -1.0);
    QTest::keyClick(&canvas(), Qt::Key_K);
    QVERIFY(!time_->playing());
    // Space goes on with the speed of the box, whatever J and L did.
    QTest::keyClick(&canvas(), Qt::Key_Space);
    QCOMPARE(time_->speed(), 1.0);
    time_->set_playing(false);
    QTest::keyClick(&canvas(), Qt::Key_End);
    QCOMPARE(time_->playhead_s(), 12.0);
    QTest::keyClick(&canvas(), Qt::Key_Home);
    QCOMPARE(time_->playhead_s(), 0.0);
  }

  void text_fields_keep_their_letters() {
    text_->setFocus();
    QTest::keyClicks(text_, QStringLiteral("jkl i"));
    QCOMPARE(text_->text(), QStringLiteral("jkl i"));
    QVERIFY(!time_->playing());
  }

  void speed_box_offers_a_tenth_to_four_times() {
    auto* box = timeline_->findChild<QComboBox*>();
    QVERIFY(box != nullptr);
    QCOMPARE(box->itemData(0).toDouble(), 0.1);
    QCOMPARE(box->itemData(box->count() - 1).toDouble(), 4.0);
    box->setCurrentIndex(0);
    QCOMPARE(time_->speed(), 0.1);
  }

  void i_sets_a_key_and_delete_removes_it() {
    QTest::keyClick(&canvas(), Qt::Key_I);
    QCOMPARE(stack_->count(), 0);  // No bone is selected.
    canvas().set_current_lane(1);
    time_->set_playhead(2.0);
    QTest::keyClick(&canvas(), Qt::Key_I);
    QCOMPARE(model_->keys(1).size(), std::size_t{1});
    QTest::keyClick(&canvas(), Qt::Key_Up, Qt::AltModifier);
    QVERIFY(std::abs(model_->keys(1)[0].value - radians(1.0)) < 1e-12);
    QTest::keyClick(&canvas(), Qt::Key_Down, Qt::AltModifier | Qt::ShiftModifier);
    QVERIFY(std::abs(model_->keys(1)[0].value - radians(0.9)) < 1e-12);
    QTest::keyClick(&canvas(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(std::llround(model_->keys(1)[0].time_s * 60), 121LL);
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QVERIFY(model_->keys(1).empty());
    while (stack_->canUndo()) {
      stack_->undo();
    }
    QVERIFY(model_->keys(1).empty());
  }

  void keys_are_dragged_as_one_step_of_undo() {
    model_->load(1, {{0, 2.0, radians(20)}, {0, 6.0, radians(-30)}});
    model_->load(2, {{0, 4.0, radians(10)}});
    canvas().set_current_lane(1);
    QSignalSpy lanes(&canvas(), &TimelineCanvas::lane_clicked);
    drag(key(1, 0), key(1, 0) + QPoint(100, 0));
    QCOMPARE(lanes.size(), 1);
    QCOMPARE(stack_->count(), 1);
    const double moved = 100 * canvas().scale().seconds_per_pixel();
    QVERIFY(std::abs(model_->keys(1)[0].time_s - 2.0 - moved) <= 1.0 / 60.0);
    // On frames, unless Alt is held.
    QVERIFY(std::abs(std::remainder(model_->keys(1)[0].time_s, 1.0 / 60.0)) < 1e-6);
    stack_->undo();
    QCOMPARE(model_->keys(1)[0].time_s, 2.0);
    // Two keys of different lanes move together.
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, key(1, 0));
    QTest::mouseClick(&canvas(), Qt::LeftButton, Qt::ShiftModifier, key(2, 0));
    QCOMPARE(keys_->selected().size(), std::size_t{2});
    drag(key(2, 0), key(2, 0) + QPoint(60, 0));
    QVERIFY(model_->keys(1)[0].time_s > 2.3);
    QVERIFY(model_->keys(2)[0].time_s > 4.3);
    QCOMPARE(stack_->count(), 1);
    stack_->undo();
    QCOMPARE(model_->keys(2)[0].time_s, 4.0);
  }

  void double_click_sets_a_key_on_the_line() {
    model_->load(1, {{0, 2.0, 0.0}, {0, 6.0, 1.0}});
    const QPoint at = canvas().key_position(1, 4.0).toPoint();
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, at);
    QCOMPARE(model_->keys(1).size(), std::size_t{3});
    QVERIFY(std::abs(model_->keys(1)[1].value - 0.5) < 0.01);
  }

  void up_and_down_go_from_key_to_key() {
    model_->load(1, {{0, 2.0, 0.0}, {0, 6.0, 1.0}});
    model_->load(0, {{0, 4.0, 0.0}});
    for (const double expected : {2.0, 4.0, 6.0, 6.0}) {
      QTest::keyClick(&canvas(), Qt::Key_Down);
      QCOMPARE(time_->playhead_s(), expected);
    }
    QTest::keyClick(&canvas(), Qt::Key_Up);
    QCOMPARE(time_->playhead_s(), 4.0);
  }

  void markers_can_be_clicked() {
    canvas().set_markers({{3.0, TimelineMarker::Kind::kMarker, tr("clap"), 7}});
    QSignalSpy clicked(&canvas(), &TimelineCanvas::marker_clicked);
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, QPointF(canvas().scale().x(3.0) + 2, 38).toPoint());
    QCOMPARE(clicked.size(), 1);
    QCOMPARE(clicked[0][0].toInt(), 7);
    QCOMPARE(time_->playhead_s(), 3.0);
  }

  void a_marker_is_dragged_once_and_lands_on_a_frame() {
    canvas().set_markers({{3.0, TimelineMarker::Kind::kMarker, tr("clap"), 7}});
    QSignalSpy moved(&canvas(), &TimelineCanvas::marker_moved);
    const QPoint from = canvas().marker_position(7)->toPoint();
    drag(from, from + QPoint(120, 0));
    QVERIFY2(moved.isEmpty(), "nobody may edit them");
    canvas().set_markers_editable(true);
    drag(from, from + QPoint(2, 0));
    QVERIFY2(moved.isEmpty(), "that was a click");
    drag(from, from + QPoint(120, 0));
    QCOMPARE(moved.size(), 1);
    QCOMPARE(moved[0][0].toInt(), 7);
    const double to = moved[0][1].toDouble();
    QVERIFY(std::abs(to - 3.0 - 120 * canvas().scale().seconds_per_pixel()) <= 1.0 / 60.0);
    QVERIFY(std::abs(std::remainder(to, 1.0 / 60.0)) < 1e-6);
    QCOMPARE(time_->playhead_s(), to);
    drag(from, from + QPoint(9000, 0));
    QCOMPARE(moved.last()[1].toDouble(), 12.0);
  }

  void a_marker_is_caught_by_its_words_too() {
    canvas().set_markers({{3.0, TimelineMarker::Kind::kMarker, tr("a long name"), 7},
                          {9.0, TimelineMarker::Kind::kWarning, tr("the volume was moved"), 0}});
    canvas().set_markers_editable(true);
    canvas().grab();  // Only what is drawn can be caught.
    QSignalSpy moved(&canvas(), &TimelineCanvas::marker_moved);
    const QPoint words = canvas().marker_position(7)->toPoint() + QPoint(45, 0);
    drag(words, words + QPoint(60, 0));
    QCOMPARE(moved.size(), 1);
    QCOMPARE(moved[0][0].toInt(), 7);
    QVERIFY(std::abs(moved[0][1].toDouble() - 3.0 - 60 * canvas().scale().seconds_per_pixel()) <= 1.0 / 60.0);
    const QPoint beside = words + QPoint(150, 0);
    drag(beside, beside + QPoint(60, 0));
    QCOMPARE(moved.size(), 1);
  }

  void a_marker_is_renamed_in_place() {
    canvas().set_markers({{3.0, TimelineMarker::Kind::kMarker, tr("clap"), 7},
                          {3.0, TimelineMarker::Kind::kLoss, tr("120 samples lost"), 0}});
    canvas().set_markers_editable(true);
    QSignalSpy renamed(&canvas(), &TimelineCanvas::marker_renamed);
    const QPoint at = canvas().marker_position(7)->toPoint();
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, at);
    auto* field = canvas().findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    QCOMPARE(field->text(), QStringLiteral("clap"));
    QTest::keyClicks(field, QStringLiteral("jump"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(renamed.size(), 1);
    QCOMPARE(renamed[0][1].toString(), QStringLiteral("jump"));
    QTRY_VERIFY(canvas().findChild<QLineEdit*>() == nullptr);
    // Escape leaves it as it was.
    timeline_->select_marker(7);
    QTest::keyClick(&canvas(), Qt::Key_F2);
    field = canvas().findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    QTest::keyClicks(field, QStringLiteral("x"));
    QTest::keyClick(field, Qt::Key_Escape);
    QTRY_VERIFY(canvas().findChild<QLineEdit*>() == nullptr);
    QCOMPARE(renamed.size(), 1);
  }

  void a_selected_marker_answers_to_keys_and_keys_are_left_alone() {
    model_->load(1, {{0, 2.0, 0.0}});
    canvas().set_markers({{3.0, TimelineMarker::Kind::kMarker, tr("clap"), 7}});
    canvas().set_markers_editable(true);
    QSignalSpy moved(&canvas(), &TimelineCanvas::marker_moved);
    QSignalSpy removed(&canvas(), &TimelineCanvas::marker_removed);
    timeline_->select_marker(7);
    QTest::keyClick(&canvas(), Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(moved.size(), 1);
    QVERIFY(std::abs(moved[0][1].toDouble() - 3.0 + 1.0 / 60.0) < 1e-9);
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QCOMPARE(removed.size(), 1);
    QCOMPARE(model_->keys(1).size(), std::size_t{1});
    timeline_->select_marker(0);
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QCOMPARE(removed.size(), 1);
  }

  void a_double_click_among_the_events_asks_for_a_marker() {
    QSignalSpy wanted(&canvas(), &TimelineCanvas::marker_wanted);
    const QPoint at = QPointF(canvas().scale().x(5.0), 38).toPoint();
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, at);
    QVERIFY(wanted.isEmpty());
    canvas().set_markers_editable(true);
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, at);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(std::abs(wanted[0][0].toDouble() - 5.0) < 0.02);
  }

  void looks_as_it_should() {
    const QString folder = QStringLiteral(LIMBWAVE_BINARY_DIR "/screenshots");
    QDir().mkpath(folder);
    QVERIFY(window_->grab().save(folder + QStringLiteral("/timeline-empty.png")));
    model_->reset({tr("torso"), tr("upper_arm"), tr("a segment with a name that does not fit")}, 12.0, 1.0 / 60.0);
    model_->load(1, {{0, 2.0, radians(20)}, {0, 6.0, radians(-30)}, {0, 8.5, 0}});
    model_->load(2, {{0, 4.0, radians(10)}});
    canvas().set_current_lane(1);
    canvas().set_markers(
        {{1.0, TimelineMarker::Kind::kMarker, tr("clap"), 1},
         {3.0, TimelineMarker::Kind::kLoss, tr("120 samples lost"), 0},
         {7.4, TimelineMarker::Kind::kWarning, tr("The volume was moved: the level fell by half"), 0}});
    canvas().set_stretches({{2.5, 9.0, tr("capture")}});
    keys_->select({{1, model_->keys(1)[1].id}});
    time_->set_playhead(5.2);
    QTest::qWait(30);
    QVERIFY(window_->grab().save(folder + QStringLiteral("/timeline-dark.png")));
    apply_theme(*qApp, ThemeKind::kLight);
    time_->set_visible(3.0, 6.5);
    QTest::qWait(30);
    QVERIFY(window_->grab().save(folder + QStringLiteral("/timeline-light.png")));
  }
};

}  // namespace limbwave::ui

QTEST_MAIN(limbwave::ui::TimelineWidgetTest)
#include "timeline_widget_test.moc"
