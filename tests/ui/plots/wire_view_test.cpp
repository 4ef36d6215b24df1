/// The rows of a driver box's wires.
#include "plots/wire_view.h"

#include <QSignalSpy>
#include <QTest>

#include "common/theme.h"
#include "ui/support/fake_box.h"

namespace limbwave::ui::testing {

class WireViewTest : public QObject {
  Q_OBJECT
 private:
  static std::shared_ptr<const solve::LiveBodySnapshot> snapshot(const FakeBox& box) {
    return std::make_shared<solve::LiveBodySnapshot>(box.says);
  }
  static int count(const QImage& picture, const QRect& area, const QColor& color) {
    int found = 0;
    for (int y = area.top(); y <= area.bottom(); ++y) {
      for (int x = area.left(); x <= area.right(); ++x) {
        found += picture.pixelColor(x, y) == color ? 1 : 0;
      }
    }
    return found;
  }

 private Q_SLOTS:
  void initTestCase() { apply_theme(*qApp, ThemeKind::kDark); }

  void the_worst_is_the_word() {
    solve::BoxWire wire;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("silent"));
    wire.level = 0.1;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("listening"));
    wire.frames = 20;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("not understood"));
    wire.locked = true;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("well, no source in sight"));
    wire.ranges_hz = 12.0;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("well"));
    wire.clipped = true;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("clips"));
    wire.state = estimate::BoardState::kFrozen;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("frozen"));
    wire.state = estimate::BoardState::kSilent;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("no words"));
    wire.plugged = false;
    QCOMPARE(WireView::state_words(wire), QStringLiteral("pulled out"));
  }

  void who_cannot_see_it_hears_who_has_trouble() {
    FakeBox box;
    WireView view;
    view.set_snapshot(snapshot(box));
    QCOMPARE(view.accessibleDescription(), QStringLiteral("All wires are well."));
    box.says.wires[3].plugged = false;
    box.says.wires[7].clipped = true;
    view.set_snapshot(snapshot(box));
    QCOMPARE(view.accessibleDescription(), QStringLiteral("head: pulled out; left hand: clips"));
    box.says.connected = false;
    view.set_snapshot(snapshot(box));
    QCOMPARE(view.accessibleDescription(), QStringLiteral("The box is away."));
    view.set_snapshot(nullptr);
    QCOMPARE(view.accessibleDescription(), QString());
  }

  void rows_are_chosen_by_mouse_and_keys_and_not_beyond_the_ends() {
    FakeBox box;
    WireView view;
    view.resize(700, 24 + 18 * 26);
    view.set_snapshot(snapshot(box));
    view.show();
    QSignalSpy chosen(&view, &WireView::wire_clicked);
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(100, 24 + 17 * 26 + 10));
    QCOMPARE(chosen.takeLast().at(0).toInt(), 17);
    view.set_selected(17);
    QTest::keyClick(&view, Qt::Key_Down);
    QCOMPARE(chosen.takeLast().at(0).toInt(), 17);
    QTest::keyClick(&view, Qt::Key_Up);
    QCOMPARE(chosen.takeLast().at(0).toInt(), 16);
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(100, 5));
    QCOMPARE(chosen.takeLast().at(0).toInt(), -1);
    view.set_snapshot(nullptr);
    QTest::keyClick(&view, Qt::Key_Down);
    QVERIFY(chosen.isEmpty());
  }

  void a_box_that_is_away_shows_nothing_of_before() {
    FakeBox box;
    WireView view;
    view.resize(800, 24 + 18 * 26);
    view.set_snapshot(snapshot(box));
    const QRect rows(100, 30, 680, 18 * 26 - 10);
    QVERIFY(count(view.grab().toImage().scaled(view.size()), rows, dark_theme().good) > 100);
    box.says.connected = false;
    view.set_snapshot(snapshot(box));
    QCOMPARE(count(view.grab().toImage().scaled(view.size()), rows, dark_theme().good), 0);
  }

  void a_narrow_view_keeps_the_states() {
    FakeBox box;
    box.says.wires[2].plugged = false;
    WireView view;
    QVERIFY(view.minimumSizeHint().width() <= 280);
    view.resize(290, 24 + 18 * 26);
    view.set_snapshot(snapshot(box));
    const QImage picture = view.grab().toImage().scaled(view.size());
    // Letters are smoothed: anything that is no ground counts.
    const QRect state(174, 24 + 26 * 2 + 2, 110, 20);
    const int ground = count(picture, state, dark_theme().base);
    QVERIFY2(ground < state.width() * state.height() - 60, "the word for it is in view");
    QCOMPARE(count(picture, QRect(120, 24, 54, 26), dark_theme().good), 0);
  }

  void a_bar_is_as_long_as_the_level_and_warns_at_full_scale() {
    FakeBox box;
    box.says.wires[0].level = 0.01;
    box.says.wires[1].level = 0.5;
    box.says.wires[2].level = 1.0;
    box.says.wires[2].clipped = true;
    WireView view;
    view.resize(800, 24 + 18 * 26);
    view.set_snapshot(snapshot(box));
    const QImage picture = view.grab().toImage().scaled(view.size());
    const ThemeColors& theme = dark_theme();
    const auto row = [](int wire) { return QRect(176, 24 + 26 * wire + 12, 240, 2); };
    const int low = count(picture, row(0), theme.good), high = count(picture, row(1), theme.good);
    QVERIFY(low > 0);
    QVERIFY(high > low + 20);
    QCOMPARE(count(picture, row(2), theme.good), 0);
    QVERIFY(count(picture, row(2), theme.warning) > high);
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::WireViewTest)
#include "wire_view_test.moc"
