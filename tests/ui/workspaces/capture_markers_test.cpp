/// Markers of the Capture workspace: set, named, moved, deleted, undone.
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "common/format.h"
#include "plots/overview_view.h"
#include "ui/support/capture_fixture.h"
#include "workspaces/capture/capture_workspace.h"

namespace limbwave::ui::testing {

class CaptureMarkersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void markers_are_edited_where_they_are_shown_and_undone_by_keys() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(QTest::qWaitForWindowActive(capture.studio.window.get()));
    QVERIFY(choose(capture, "simulator:wave"));
    capture.workspace->model().start_recording();
    QTRY_VERIFY(capture.live().recording());
    QTest::qWait(1200);
    QTest::keyClick(capture.workspace, Qt::Key_M);
    auto* table = capture.find<QTableWidget>("marker_list");
    QCOMPARE(table->rowCount(), 1);
    // Rename: F2 in the list.
    table->setFocus();
    table->setCurrentCell(0, 1);
    QTest::keyClick(table, Qt::Key_F2);
    auto* editor = table->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, QStringLiteral("jump"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(table->item(0, 1)->text(), QStringLiteral("jump"));
    QTRY_VERIFY(table->findChild<QLineEdit*>() == nullptr);
    // Another time: typed.
    table->setCurrentCell(0, 0);
    QTest::keyClick(table, Qt::Key_F2);
    editor = table->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QCOMPARE(editor->text(), table->item(0, 0)->text());
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("0:00.50"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(capture.studio.context->markers().markers().front().sample, std::int64_t{24000});
    // Dragged in the growing signal.
    auto* view = capture.find<OverviewView>("overview");
    QTRY_VERIFY(view->visible_end_s() > 1.0);
    const QPoint from(qRound(view->mark_x(1)), view->height() / 2);
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    QTest::mouseMove(view, from + QPoint(20, 0));
    QTest::mouseMove(view, from + QPoint(40, 0));
    QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(40, 0));
    QVERIFY(capture.studio.context->markers().markers().front().sample > 24000);
    QCOMPARE(capture.studio.context->selection().marker(), std::int64_t{1});
    // All back by Ctrl+Z, whatever has the focus.
    capture.workspace->setFocus();
    QTest::keyClick(capture.workspace, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(table->item(0, 0)->text(), format_clock_hundredths(0.5));
    QTest::keyClick(capture.workspace, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(capture.workspace, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("Marker 1"));
    QTest::keyClick(capture.workspace, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("jump"));
    // Deleted and brought back, also after the recording.
    table->setFocus();
    table->selectRow(0);
    QTest::keyClick(table, Qt::Key_Delete);
    QCOMPARE(table->rowCount(), 0);
    capture.workspace->setFocus();
    QTest::keyClick(capture.workspace, Qt::Key_R);
    QTRY_VERIFY(capture.studio.context->document().is_open());
    QCOMPARE(table->rowCount(), 0);
    QTest::keyClick(capture.workspace, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(table->rowCount(), 1);
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("jump"));
    QVERIFY(capture.find<QToolButton>("marker_rename") != nullptr);
  }

  void what_is_being_typed_stays_when_the_list_changes() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    capture.workspace->model().start_recording();
    QTRY_VERIFY(capture.live().recording());
    MarkerModel& markers = capture.studio.context->markers();
    QVERIFY(markers.mark_now(QStringLiteral("jump")));
    const std::int64_t sample = markers.markers().front().sample;
    QTest::qWait(100);
    auto* table = capture.find<QTableWidget>("marker_list");
    for (const auto& [column, typed] : {std::pair(1, QStringLiteral("hop")), std::pair(0, QStringLiteral("0:00.00"))}) {
      table->setCurrentCell(0, column);
      QTest::keyClick(table, Qt::Key_F2);
      auto* editor = table->findChild<QLineEdit*>();
      QVERIFY(editor != nullptr);
      editor->selectAll();
      QTest::keyClicks(editor, typed);
      QVERIFY(markers.mark_now());
      QVERIFY(markers.rename(2, QStringLiteral("other %1").arg(column)));
      QCOMPARE(editor->text(), typed);
      QTest::keyClick(editor, Qt::Key_Return);
      QTRY_VERIFY(table->findChild<QLineEdit*>() == nullptr);
    }
    QTRY_COMPARE(markers.find(1)->text, QStringLiteral("hop"));
    QTRY_COMPARE(markers.find(1)->sample, std::int64_t{0});
    QVERIFY(sample > 0);
    QCOMPARE(table->rowCount(), 3);
  }

  void a_time_that_is_none_is_refused_in_words() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    capture.workspace->model().start_recording();
    QTRY_VERIFY(capture.live().recording());
    QVERIFY(capture.studio.context->markers().mark_now(QStringLiteral("jump")));
    auto* table = capture.find<QTableWidget>("marker_list");
    const QString before = table->item(0, 0)->text();
    table->item(0, 0)->setText(QStringLiteral("soon"));
    QTRY_COMPARE(table->item(0, 0)->text(), before);
    QVERIFY(capture.studio.context->notifications().all().front().text.contains(QStringLiteral("soon")));
  }

  void markers_need_a_recording() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    QVERIFY(!capture.find<QPushButton>("marker_button")->isEnabled());
    QTest::keyClick(capture.workspace, Qt::Key_M);
    QVERIFY(capture.line->events.empty());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CaptureMarkersTest)
#include "capture_markers_test.moc"
