/// Devices, formats, boards and rigs in the Capture workspace.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "common/widgets.h"
#include "plots/scope_view.h"
#include "ui/support/capture_fixture.h"
#include "workspaces/capture/board_dialog.h"
#include "workspaces/capture/capture_workspace.h"

namespace limbwave::ui::testing {

class CaptureDevicesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_format_is_chosen_from_what_the_device_offers() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    auto* menu = capture.find<QMenu>("format_menu");
    Q_EMIT menu->aboutToShow();
    const auto action = [menu](const QString& start) -> QAction* {
      for (QAction* candidate : menu->actions()) {
        if (candidate->text().startsWith(start)) {
          return candidate;
        }
      }
      return nullptr;
    };
    QVERIFY(!action(QStringLiteral("192 kHz"))->isEnabled());
    QVERIFY2(action(QStringLiteral("192 kHz"))->text().size() > 12, "it says why");
    QVERIFY(action(QStringLiteral("96 kHz"))->isEnabled());
    const int opened = capture.line->opened;
    action(QStringLiteral("96 kHz"))->trigger();
    QTRY_COMPARE(capture.line->opened, opened + 1);
    QCOMPARE(capture.line->setup.rate_hz, 96000.0);
    Q_EMIT menu->aboutToShow();
    action(QStringLiteral("Left 3, right 4"))->trigger();
    QTRY_COMPARE(capture.line->setup.left, 2);
    QCOMPARE(capture.line->setup.rate_hz, 96000.0);
    QTRY_VERIFY(capture.live().snapshot() != nullptr);
    QVERIFY(capture.find<QToolButton>("format_button")->text().contains(QStringLiteral("3 + 4")));
    // Remembered for this device; another has its own.
    QVERIFY(choose(capture, "simulator:wave"));
    QCOMPARE(capture.line->setup.rate_hz, 0.0);
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    QTRY_COMPARE(capture.line->setup.rate_hz, 96000.0);
    QTRY_VERIFY(capture.live().snapshot() != nullptr);
    capture.workspace->model().start_recording();
    QTRY_VERIFY(capture.live().recording());
    QTRY_VERIFY(!capture.find<QToolButton>("format_button")->isEnabled());
  }

  void rigs_are_listed_by_title_and_a_choice_can_be_undone() {
    Capture capture(std::make_shared<FakeLine>());
    auto* box = capture.find<QComboBox>("rig_box");
    QCOMPARE(box->currentText(), QStringLiteral("Arm with five accelerometers on a sound card"));
    box->setCurrentIndex(1);
    Q_EMIT box->activated(1);
    QCOMPARE(capture.workspace->model().rig(), QStringLiteral("other"));
    capture.workspace->model().set_subject(QStringLiteral("A"));
    capture.workspace->model().set_subject(QStringLiteral("An"));
    capture.workspace->model().set_take_name(QStringLiteral("walk"));
    QUndoStack& undo = capture.studio.context->undo_stack();
    QCOMPARE(undo.count(), 3);
    undo.undo();
    QCOMPARE(capture.find<QLineEdit>("take_name_edit")->text(), QStringLiteral("an-20261122-1"));
    undo.undo();
    QCOMPARE(capture.find<QLineEdit>("subject_edit")->text(), QString());
    QCOMPARE(capture.find<QLineEdit>("take_name_edit")->text(), QStringLiteral("take-20261122-1"));
    undo.undo();
    QCOMPARE(capture.workspace->model().rig(), QStringLiteral("line-in-arm"));
    QCOMPARE(box->currentIndex(), 0);
    undo.redo();
    QCOMPARE(box->currentText(), QStringLiteral("Another board"));
  }

  void no_device_says_so_and_offers_the_simulator() {
    auto line = std::make_shared<FakeLine>();
    line->no_devices = true;
    Capture capture(line);
    QVERIFY(wait_for_devices(capture));
    auto* simulator = capture.find<QPushButton>("use_simulator");
    QTRY_VERIFY(simulator->isVisible());
    QVERIFY(capture.workspace->findChild<EmptyState*>()->accessibleName().startsWith(QStringLiteral("No sound card")));
    QVERIFY(capture.studio.window->grab().save(screenshot_path(QStringLiteral("capture-no-card"))));
    QTest::mouseClick(simulator, Qt::LeftButton);
    QTRY_VERIFY(capture.live().running());
    QTRY_VERIFY(capture.find<ScopeView>("scope")->isVisible());
  }

  void a_refused_device_gives_reason_and_remedy() {
    auto line = std::make_shared<FakeLine>();
    line->fail_open = true;
    Capture capture(line);
    QVERIFY(wait_for_devices(capture));
    capture.workspace->model().open_device(QStringLiteral("portaudio:ALSA:card"));
    QTRY_COMPARE(capture.live().problem(), QStringLiteral("The device is busy."));
    QVERIFY(capture.live().remedy().startsWith(QStringLiteral("Close the program")));
    QCOMPARE(capture.live().state(), LiveState::kOff);
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
  }

  void looking_for_devices_opens_a_lost_one_again() {
    auto line = std::make_shared<FakeLine>();
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    line->alive = false;
    QTRY_VERIFY(capture.live().lost());
    line->alive = true;
    QTest::mouseClick(capture.find<QToolButton>("refresh_devices"), Qt::LeftButton);
    QTRY_COMPARE(line->opened, 2);
    QTRY_VERIFY(capture.live().running() && !capture.live().lost());
  }

  void a_board_is_named_per_device() {
    QTemporaryDir home;
    const QByteArray before = qgetenv("LIMBWAVE_HOME");
    qputenv("LIMBWAVE_HOME", home.path().toLocal8Bit());
    auto line = std::make_shared<FakeLine>();
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    auto* edit = capture.find<QToolButton>("edit_board");
    QVERIFY2(!edit->isEnabled(), "the simulator's sensors have serials of their own");
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    QTRY_VERIFY(edit->isEnabled());
    const int opened = line->opened;
    QTest::mouseClick(edit, Qt::LeftButton);
    QTRY_VERIFY(capture.studio.window->findChild<BoardDialog*>() != nullptr);
    auto* dialog = capture.studio.window->findChild<BoardDialog*>();
    QTest::keyClicks(dialog->findChild<QLineEdit*>(QStringLiteral("board_name")), QStringLiteral("Lab 2"));
    QTest::keyClicks(dialog->findChild<QLineEdit*>(QStringLiteral("serial_1")), QStringLiteral("K7"));
    QTest::keyClicks(dialog->findChild<QLineEdit*>(QStringLiteral("serial_2")), QStringLiteral("K7"));
    auto* keep = dialog->findChild<QPushButton*>(QStringLiteral("keep_board"));
    QVERIFY2(!keep->isEnabled(), "one serial, two sensors");
    QTest::keyClicks(dialog->findChild<QLineEdit*>(QStringLiteral("serial_2")), QStringLiteral("b"));
    QTest::mouseClick(keep, Qt::LeftButton);
    QTRY_COMPARE(line->opened, opened + 1);
    const body::Rig rig = take::rig_on_device(body::load_rig("line-in-arm").value(), "portaudio:ALSA:card");
    QCOMPARE(rig.accelerometers[0].serial, std::string("Lab 2: torso"));
    QCOMPARE(rig.accelerometers[2].serial, std::string("K7b"));
    qputenv("LIMBWAVE_HOME", before);
  }

  void mixed_up_sensors_are_put_right_and_back_again() {
    QTemporaryDir home;
    const QByteArray before = qgetenv("LIMBWAVE_HOME");
    qputenv("LIMBWAVE_HOME", home.path().toLocal8Bit());
    auto line = std::make_shared<FakeLine>();
    Capture capture(line);
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    const auto in_book = [] { return take::BoardBook().board("portaudio:ALSA:card", "line-in-arm").value().places; };
    QTest::mouseClick(capture.find<QToolButton>("edit_board"), Qt::LeftButton);
    QTRY_VERIFY(capture.studio.window->findChild<BoardDialog*>() != nullptr);
    auto* dialog = capture.studio.window->findChild<BoardDialog*>();
    auto* hand = dialog->findChild<QComboBox*>(QStringLiteral("place_3"));
    QCOMPARE(hand->currentText(), QStringLiteral("hand"));
    hand->setCurrentText(QStringLiteral("forearm"));
    Q_EMIT hand->textActivated(QStringLiteral("forearm"));
    QCOMPARE(dialog->findChild<QComboBox*>(QStringLiteral("place_2"))->currentText(), QStringLiteral("hand"));
    QVERIFY(dialog->grab().save(screenshot_path(QStringLiteral("capture-board"))));
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("keep_board")), Qt::LeftButton);
    const std::vector<std::string> swapped{"torso", "upper arm", "hand", "forearm", "fingers"};
    QTRY_COMPARE(line->opened, 2);
    QCOMPARE(in_book(), swapped);
    // Undone and redone faster than anything can be written, the last wish stands.
    QUndoStack& stack = capture.studio.context->undo_stack();
    QVERIFY(stack.undoText().contains(QStringLiteral("sensor board")));
    stack.undo();
    capture.studio.context->saves().finish();
    QVERIFY(in_book().empty());
    stack.redo();
    stack.undo();
    stack.redo();
    capture.studio.context->saves().finish();
    QCOMPARE(in_book(), swapped);
    QTRY_VERIFY(capture.live().running());
    qputenv("LIMBWAVE_HOME", before);
  }

  void the_format_and_the_folder_are_undone() {
    auto line = std::make_shared<FakeLine>();
    Capture capture(line);
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    DeviceSetup setup;
    setup.rate_hz = 96000.0;
    capture.workspace->model().set_device_setup(setup);
    QTRY_COMPARE(line->setup.rate_hz, 96000.0);
    QTRY_VERIFY(capture.live().running());
    const QString folder = capture.studio.context->takes_folder();
    capture.workspace->model().set_takes_folder(folder + QStringLiteral("/deeper"));
    QCOMPARE(capture.studio.context->takes_folder(), folder + QStringLiteral("/deeper"));
    QVERIFY(QDir(folder + QStringLiteral("/deeper")).exists());
    QUndoStack& stack = capture.studio.context->undo_stack();
    stack.undo();
    QCOMPARE(capture.studio.context->takes_folder(), folder);
    QVERIFY(capture.workspace->model().take_folder().startsWith(folder + QStringLiteral("/take-")));
    stack.undo();
    QTRY_COMPARE(line->setup.rate_hz, 0.0);
    QTRY_VERIFY(capture.live().running());
  }

  void a_device_is_closed_before_it_is_opened_again() {
    auto line = std::make_shared<FakeLine>();
    line->exclusive = true;
    line->slow_close_ms = 200;
    Capture capture(line);
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    for (int i = 0; i < 3; ++i) {
      capture.workspace->model().set_rig(i % 2 == 0 ? QStringLiteral("other") : QStringLiteral("line-in-arm"));
    }
    QTRY_VERIFY(capture.live().running());
    QCOMPARE(capture.live().problem(), QString());
    // What was overtaken was ended by nobody who should have been drawing.
    QTRY_VERIFY(capture.studio.context->jobs().jobs().empty());
    QVERIFY(!line->ended_in_gui_thread);
  }

  void the_last_device_opens_by_itself_next_time() {
    auto line = std::make_shared<FakeLine>();
    StudioFixture first(fake_services(line));
    first.context->settings().setValue(QStringLiteral("capture/device"), QStringLiteral("simulator:wave"));
    first.window->show_workspace(QStringLiteral("capture"));
    QTRY_VERIFY(first.context->live().running());
    QCOMPARE(line->opened, 1);
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CaptureDevicesTest)
#include "capture_devices_test.moc"
