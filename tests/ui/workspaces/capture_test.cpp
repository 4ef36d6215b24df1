/// The Capture workspace with its real widgets over a made-up line.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "common/format.h"
#include "common/theme.h"
#include "plots/overview_view.h"
#include "plots/scope_view.h"
#include "plots/sensor_strips.h"
#include "ui/support/fake_services.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/capture/board_dialog.h"
#include "workspaces/capture/capture_workspace.h"
#include "workspaces/status_strip.h"

namespace limbwave::ui::testing {

class CaptureTest : public QObject {
  Q_OBJECT
 private:
  struct Capture {
    explicit Capture(const std::shared_ptr<FakeLine>& the_line) : line(the_line), studio(fake_services(the_line)) {
      studio.window->show_workspace(QStringLiteral("capture"));
      workspace = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
      workspace->model().set_today(QDate(2026, 11, 22));
    }
    template <typename T>
    [[nodiscard]] T* find(const char* name) const {
      return studio.window->findChild<T*>(QString::fromLatin1(name));
    }
    [[nodiscard]] LiveModel& live() const { return studio.context->live(); }
    std::shared_ptr<FakeLine> line;
    StudioFixture studio;
    CaptureWorkspace* workspace = nullptr;
  };

  static bool wait_for_devices(Capture& capture) {
    return QTest::qWaitFor([&] { return !capture.workspace->model().devices().empty(); });
  }
  static bool choose(Capture& capture, const char* id) {
    if (!wait_for_devices(capture)) {
      return false;
    }
    auto* box = capture.find<QComboBox>("device_box");
    const int index = box->findData(QString::fromLatin1(id));
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
    return QTest::qWaitFor([&] { return capture.live().snapshot() != nullptr; });
  }

 private Q_SLOTS:
  void records_a_take_with_markers_by_keys() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(QTest::qWaitForWindowActive(capture.studio.window.get()));
    QVERIFY(choose(capture, "simulator:wave"));
    auto* subject = capture.find<QLineEdit>("subject_edit");
    subject->clear();
    QTest::keyClicks(subject, QStringLiteral("Ann Rem"));
    QVERIFY2(!capture.live().recording(), "letters typed into a field are no shortcuts");
    QCOMPARE(capture.find<QLineEdit>("take_name_edit")->text(), QStringLiteral("ann-rem-20261122-1"));
    capture.workspace->setFocus();
    QTest::keyClick(capture.workspace, Qt::Key_R);
    QTRY_VERIFY(capture.live().recording());
    QVERIFY(capture.studio.window->windowTitle().contains(QStringLiteral("Recording")));
    QTest::qWait(300);
    QTest::keyClick(capture.workspace, Qt::Key_M);
    QTest::mouseClick(capture.find<QPushButton>("marker_button"), Qt::LeftButton);
    QCOMPARE(capture.line->events.size(), std::size_t{2});
    QCOMPARE(capture.find<QTableWidget>("marker_list")->rowCount(), 2);
    QVERIFY(capture.find<QLabel>("record_time")->text() != QStringLiteral("0:00.0"));
    QVERIFY2(capture.find<QLabel>("record_time")->font().pixelSize() >= 48, "readable from two metres");
    QTest::keyClick(capture.workspace, Qt::Key_R);
    QTRY_VERIFY(capture.studio.context->document().is_open());
    QCOMPARE(capture.studio.context->document().name(), QStringLiteral("ann-rem-20261122-1"));
    QVERIFY(capture.studio.window->windowTitle().startsWith(QStringLiteral("ann-rem-20261122-1")));
    QCOMPARE(capture.find<QLineEdit>("take_name_edit")->text(), QStringLiteral("ann-rem-20261122-2"));
    QCOMPARE(capture.studio.context->recent_takes().folders().size(), 1);
  }

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

  void health_is_said_in_words_however_low_the_rows_are() {
    apply_theme(*qApp, ThemeKind::kLight);
    SensorStrips strips;
    const QStringList names{QStringLiteral("torso"), QStringLiteral("upper arm"), QStringLiteral("forearm"),
                            QStringLiteral("hand"), QStringLiteral("fingers")};
    strips.set_sensors(names);
    auto snapshot = std::make_shared<solve::LiveSnapshot>();
    snapshot->health.assign(5, {solve::HealthState::kWarning, "no-calibration", "works, but was never calibrated"});
    strips.set_snapshot(snapshot);
    const QColor warning = tone_color(strips.palette(), Tone::kWarning);
    const auto is_ink = [&](const QColor& c) {
      return std::abs(c.red() - warning.red()) + std::abs(c.green() - warning.green()) +
                 std::abs(c.blue() - warning.blue()) <
             90;
    };
    for (const int row : {27, 31, 36, 40, 60}) {
      strips.resize(800, 38 + 5 * (row + 6));
      const QImage image = strips.grab().toImage();
      const double scale = image.devicePixelRatio();
      int ink = 0, lowest = 0;
      const int top = 20, bottom = top + row;  // The first card, without its symbol at the right.
      for (int y = 0; y < static_cast<int>((bottom + 3) * scale); ++y) {
        for (int x = static_cast<int>(12 * scale); x < static_cast<int>(186 * scale); ++x) {
          if (is_ink(image.pixelColor(x, y))) {
            ++ink;
            lowest = std::max(lowest, y);
          }
        }
      }
      QVERIFY2(ink > 40, qPrintable(QStringLiteral("%1 pixels at %2").arg(ink).arg(row)));
      QVERIFY2(lowest < (bottom - 1) * scale, qPrintable(QString::number(row)));
    }
    apply_theme(*qApp, ThemeKind::kDark);
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

  void markers_need_a_recording() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    QVERIFY(!capture.find<QPushButton>("marker_button")->isEnabled());
    QTest::keyClick(capture.workspace, Qt::Key_M);
    QVERIFY(capture.line->events.empty());
  }

  void done_with_a_name_keys_are_commands_again() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(QTest::qWaitForWindowActive(capture.studio.window.get()));
    QVERIFY(choose(capture, "simulator:wave"));
    auto* name = capture.find<QLineEdit>("take_name_edit");
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
      name->setFocus();
      QTRY_VERIFY(name->hasFocus());
      QTest::keyClick(name, key);
      QVERIFY(!name->hasFocus());
    }
  }

  void a_name_that_is_taken_is_refused_where_it_is_typed() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    QDir().mkpath(capture.studio.context->takes_folder() + QStringLiteral("/walk.take"));
    auto* name = capture.find<QLineEdit>("take_name_edit");
    name->clear();
    QTest::keyClicks(name, QStringLiteral("walk"));
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(capture.find<QLabel>("take_name_problem")->isVisible());
    QTest::keyClicks(name, QStringLiteral("2"));
    QVERIFY(capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(!capture.find<QLabel>("take_name_problem")->isVisible());
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

  void a_full_disk_is_told_and_nothing_records() {
    auto line = std::make_shared<FakeLine>();
    line->fail_recording = true;
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
    QTRY_VERIFY(!capture.studio.context->notifications().all().empty());
    QVERIFY(capture.studio.context->notifications().all().front().text.contains(QStringLiteral("no space left")));
    QVERIFY(!capture.live().recording());
  }

  void unplugging_keeps_what_was_recorded() {
    auto line = std::make_shared<FakeLine>();
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
    QTRY_VERIFY(capture.live().recording());
    line->alive = false;
    QTRY_VERIFY(capture.studio.context->document().is_open());
    QVERIFY(!capture.live().recording());
    QVERIFY(!capture.live().problem().isEmpty());
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
    // Plugged in again and chosen once more, as it says.
    QTRY_VERIFY(!capture.live().finishing());
    line->alive = true;
    QCOMPARE(line->opened, 1);
    auto* box = capture.find<QComboBox>("device_box");
    Q_EMIT box->activated(box->findData(QStringLiteral("simulator:wave")));
    QTRY_COMPARE(line->opened, 2);
    QTRY_VERIFY(capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(capture.live().problem().isEmpty());
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

  void a_take_has_its_wearers_mountings_and_nobody_elses() {
    auto line = std::make_shared<FakeLine>();
    line->mounted = {{"Anna", "2026-03-01T10:00:00Z"}, {"Ben", "2026-04-01T10:00:00Z"}};
    Capture capture(line);
    capture.studio.context->set_wearer(QStringLiteral("Anna"));
    QVERIFY(choose(capture, "simulator:wave"));
    QCOMPARE(capture.live().settings().calibration.mounts[0].date, std::string("2026-03-01T10:00:00Z"));
    const auto record = [&](const QString& name) {
      auto* subject = capture.find<QLineEdit>("subject_edit");
      subject->selectAll();
      QTest::keyClicks(subject, name);
      // At once: nothing has been read yet.
      QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
      QTRY_VERIFY(capture.live().recording());
      QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
      QTRY_VERIFY(capture.studio.context->document().is_open() &&
                  capture.studio.context->document().take()->info.subject == name.toStdString());
    };
    record(QStringLiteral("Zoe"));
    QCOMPARE(capture.studio.context->document().take()->info.calibration->mounts[0].method, std::string("nominal"));
    record(QStringLiteral("Ben"));
    QCOMPARE(capture.studio.context->document().take()->info.calibration->mounts[0].date,
             std::string("2026-04-01T10:00:00Z"));
    // Typed elsewhere, such as in the wizard, it is the same person; and the figure follows without recording.
    capture.studio.context->set_wearer(QStringLiteral("Anna"));
    QCOMPARE(capture.find<QLineEdit>("subject_edit")->text(), QStringLiteral("Anna"));
    QTRY_COMPARE(capture.live().settings().calibration.mounts[0].date, std::string("2026-03-01T10:00:00Z"));
  }

  void the_calibration_of_the_next_take_is_told_before_it_is_recorded() {
    auto line = std::make_shared<FakeLine>();
    line->mounted = {{"Anna", "2026-03-01T10:00:00Z"}};
    Capture capture(line);
    capture.studio.context->set_wearer(QStringLiteral("Anna"));
    QVERIFY(choose(capture, "portaudio:ALSA:card"));
    auto* told = capture.find<QLabel>("calibration_in_use");
    QTRY_VERIFY(told->isVisible());
    QVERIFY2(told->text().startsWith(QStringLiteral("Range never calibrated. Mounting on Anna, ")),
             qPrintable(told->text()));
    QVERIFY(told->text().contains(QStringLiteral("href")));
    capture.studio.context->set_wearer(QStringLiteral("Zoe"));
    QTRY_VERIFY(told->text().contains(QStringLiteral("Mounting on Zoe not calibrated.")));
    QVERIFY(capture.studio.window->grab().save(screenshot_path(QStringLiteral("capture-calibration"))));
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

  void the_raw_signals_of_a_calibration_are_nobodys_take() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    const std::filesystem::path folder = capture.studio.folder.filePath(QStringLiteral("aside.take")).toStdString();
    QVERIFY(capture.live().start_recording(folder, {}, true));
    QTRY_VERIFY(capture.live().recording());
    QTest::qWait(100);
    QVERIFY(!capture.find<OverviewView>("overview")->isVisible());
    QVERIFY(!capture.find<QPushButton>("record_button")->isEnabled());
    QVERIFY(!capture.studio.window->windowTitle().contains(QStringLiteral("Recording")));
    const auto facts = capture.studio.window->findChildren<StatusButton*>();
    QVERIFY(std::any_of(facts.begin(), facts.end(), [](const StatusButton* button) {
      return button->fact().text == QStringLiteral("calibrating");
    }));
    capture.workspace->model().toggle_recording();
    QVERIFY2(capture.live().recording(), "R in Capture is for takes");
    capture.live().stop_recording();
    QTRY_VERIFY(!capture.live().finishing());
    QVERIFY(!capture.studio.context->document().is_open());
    QTRY_VERIFY(capture.find<QPushButton>("record_button")->isEnabled());
  }

  void another_folder_suggests_another_name() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    const QString name = capture.workspace->model().take_name();
    const QString other = capture.studio.context->takes_folder() + QStringLiteral("/other");
    QDir().mkpath(other + QLatin1Char('/') + name + QStringLiteral(".take"));
    capture.studio.context->set_takes_folder(other);
    capture.workspace->model().suggest_name();
    QVERIFY(capture.workspace->model().take_name() != name);
    QVERIFY(capture.workspace->model().can_record());
  }

  void level_check_speaks() {
    auto line = std::make_shared<FakeLine>();
    line->level = 0.01;
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    QTRY_COMPARE(capture.find<QLabel>("level_advice")->text(), QStringLiteral("Too low"));
    line->level = 0.4;
    QTRY_COMPARE(capture.find<QLabel>("level_advice")->text(), QStringLiteral("Level is good"));
  }

  void a_click_on_a_fact_leads_to_the_cause() {
    auto line = std::make_shared<FakeLine>();
    line->dead_sensor = 3;
    Capture capture(line);
    QVERIFY(choose(capture, "simulator:wave"));
    capture.studio.window->show_workspace(QStringLiteral("welcome"));
    StatusButton* sensors = nullptr;
    QTRY_VERIFY([&] {
      for (auto* button : capture.studio.window->findChildren<StatusButton*>()) {
        if (button->fact().topic == QStringLiteral("sensor:3")) {
          sensors = button;
        }
      }
      return sensors != nullptr;
    }());
    QTest::mouseClick(sensors, Qt::LeftButton);
    QCOMPARE(capture.studio.window->current_workspace(), QStringLiteral("capture"));
    QCOMPARE(capture.studio.context->selection().index_of(SelectionKind::kSensor), 3);
  }

  void the_last_device_opens_by_itself_next_time() {
    auto line = std::make_shared<FakeLine>();
    StudioFixture first(fake_services(line));
    first.context->settings().setValue(QStringLiteral("capture/device"), QStringLiteral("simulator:wave"));
    first.window->show_workspace(QStringLiteral("capture"));
    QTRY_VERIFY(first.context->live().running());
    QCOMPARE(line->opened, 1);
  }

  void every_control_has_a_name() {
    Capture capture(std::make_shared<FakeLine>());
    QVERIFY(choose(capture, "simulator:wave"));
    for (const QWidget* widget : capture.studio.window->findChildren<QWidget*>()) {
      if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible() || widget->inherits("QScrollArea") ||
          widget->inherits("QSplitter") || widget->inherits("QMainWindow") ||
          widget->inherits("limbwave::ui::Workspace") || widget->objectName().startsWith(QStringLiteral("qt_"))) {
        continue;
      }
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      const bool named = !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
      QVERIFY2(named,
               qPrintable(QStringLiteral("%1 “%2” has no accessible name")
                              .arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName())));
    }
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CaptureTest)
#include "capture_test.moc"
