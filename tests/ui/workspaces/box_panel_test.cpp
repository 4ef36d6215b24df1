/// What Capture shows of a driver box and lets people say about it, over a box whose words are the test's.
#include "workspaces/capture/box_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <algorithm>

#include "common/theme.h"
#include "plots/overview_view.h"
#include "plots/wire_view.h"
#include "simulate/simulate.h"
#include "support/temporary_folder.h"
#include "ui/support/fake_box.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/capture/capture_workspace.h"

namespace limbwave::ui::testing {

class BoxPanelTest : public QObject {
  Q_OBJECT
 private:
  struct Capture {
    Capture() : studio(box_services(box)) {
      studio.window->show_workspace(QStringLiteral("capture"));
      workspace = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    }
    template <typename T>
    [[nodiscard]] T* find(const char* name) const {
      return studio.window->findChild<T*>(QString::fromLatin1(name));
    }
    bool choose(const char* id) {
      auto* devices = find<QComboBox>("device_box");
      if (!QTest::qWaitFor([&] { return devices->findData(QString::fromLatin1(id)) >= 0; })) {
        return false;
      }
      devices->setCurrentIndex(devices->findData(QString::fromLatin1(id)));
      Q_EMIT devices->activated(devices->currentIndex());
      return QTest::qWaitFor(
          [&] { return live().running() && live().snapshot() && live().device_id() == QLatin1String(id); });
    }
    [[nodiscard]] LiveModel& live() const { return studio.context->live(); }
    [[nodiscard]] DeviceSetup opened() const {
      const std::scoped_lock lock(box->mutex);
      return box->setups.back();
    }
    [[nodiscard]] QString said(const char* name) const { return find<QLabel>(name)->text(); }
    std::shared_ptr<FakeBox> box = std::make_shared<FakeBox>();
    StudioFixture studio;
    CaptureWorkspace* workspace = nullptr;
  };

 private Q_SLOTS:
  void initTestCase() { apply_theme(*qApp, ThemeKind::kDark); }

  void the_state_is_told_in_words() {
    Capture capture;
    QVERIFY(capture.choose(kFakeBox));
    QTRY_COMPARE(capture.said("box_state"), QStringLiteral("Stand still for a second"));
    capture.box->change([](auto& says) {
      says.started = true;
      says.poses_hz = 59.6;
      says.joint_sigma_deg = 2.34;
      says.counters.gaps = 3;
      says.status.sample = 1;
      says.status.battery_volts = 7.4F;
    });
    QTRY_COMPARE(capture.said("box_state"), QStringLiteral("Live: 60 poses a second"));
    QVERIFY(capture.said("box_figures").contains(QStringLiteral("Joints ± 2.3°")));
    QVERIFY(capture.said("box_figures").contains(QStringLiteral("Gaps: 3")));
    QVERIFY(capture.said("box_figures").contains(QStringLiteral("Battery 7.4 V")));
    QVERIFY(!capture.find<QLabel>("box_advice")->isVisible());
    capture.box->change([](auto& says) {
      says.diagnostics = {{Severity::kInfo, "x", "this is no trouble", "", ""},
                          {Severity::kWarning, "y", "this is one", "do something", ""}};
    });
    QTRY_COMPARE(capture.said("box_advice"), QStringLiteral("This is one. Do something."));
    capture.box->change([](auto& says) { says.error = "it will not start"; });
    QTRY_COMPARE(capture.said("box_state"), QStringLiteral("No live figure"));
    QVERIFY(capture.said("box_advice").startsWith(QStringLiteral("It will not start.")));
    capture.box->change([](auto& says) { says.connected = false; });
    QTRY_VERIFY(capture.said("box_state").contains(QStringLiteral("is away")));
  }

  void the_manual_is_one_click_away() {
    Capture capture;
    QVERIFY(capture.choose(kFakeBox));
    Q_EMIT capture.find<QLabel>("learn_box")->linkActivated({});
    QTRY_VERIFY(capture.studio.window->findChild<QWidget*>(QStringLiteral("manual")) != nullptr);
  }

  void air_and_height_open_it_anew_and_are_kept() {
    Capture capture;
    QVERIFY(capture.choose(kFakeBox));
    capture.find<QDoubleSpinBox>("box_temperature")->setValue(27.5);
    QTRY_COMPARE(capture.opened().temperature_c, 27.5);
    QTRY_VERIFY(capture.live().running());
    capture.find<QDoubleSpinBox>("box_height")->setValue(1.85);
    QTRY_COMPARE(capture.opened().height_m, 1.85);
    QCOMPARE(capture.opened().temperature_c, 27.5);
    QTRY_VERIFY(capture.live().running());
    QVERIFY(capture.choose("simulator:wave"));
    QVERIFY(capture.choose(kFakeBox));
    QCOMPARE(capture.opened().height_m, 1.85);
    QCOMPARE(capture.opened().temperature_c, 27.5);
  }

  // Delays of the sources from another take of this box: read, in use, told, taken back.
  void sources_are_known_from_a_take() {
    const test::TemporaryFolder folder;
    simulate::SimulateSettings settings;
    settings.rig = "driver-box-body";
    settings.motion = "walk";
    settings.errors_name = "calibrated";
    settings.seconds = 0.3;
    const std::filesystem::path measured = folder.path() / "measured.take";
    const Status made = simulate::simulate_take(measured, settings, {});
    QVERIFY2(made.ok(), made.ok() ? "" : made.error().text().c_str());
    Result<take::Take> nominal = take::open_take(measured);
    QVERIFY(nominal.ok());
    QVERIFY(!nominal->info.ranging->sources.empty());

    Capture capture;
    QVERIFY(capture.choose(kFakeBox));
    auto* sources = capture.find<QComboBox>("box_sources");
    auto* panel = dynamic_cast<BoxPanel*>(capture.find<QWidget>("box_panel"));
    QCOMPARE(sources->currentText(), QStringLiteral("Nominal delays"));
    QCOMPARE(capture.opened().ranging_take, std::string());
    const std::size_t before = capture.box->setups.size();
    panel->use_take(QString::fromStdString((folder.path() / "nothing.take").string()));
    QTRY_VERIFY(!capture.studio.context->notifications().all().empty());
    QCOMPARE(capture.box->setups.size(), before);
    panel->use_take(QString::fromStdString(measured.string()));
    QTRY_COMPARE(capture.opened().ranging_take, measured.string());
    QCOMPARE(sources->currentText(), QStringLiteral("As in “measured”"));
    QTRY_VERIFY(capture.live().running());
    capture.studio.context->undo_stack().undo();
    QTRY_COMPARE(capture.opened().ranging_take, std::string());
    QCOMPARE(sources->currentText(), QStringLiteral("Nominal delays"));
    QTRY_VERIFY(capture.live().running());
    capture.studio.context->undo_stack().redo();
    QTRY_COMPARE(capture.opened().ranging_take, measured.string());
    QTRY_VERIFY(capture.live().running());
    // Back by the list itself.
    sources->setCurrentIndex(0);
    Q_EMIT sources->activated(0);
    QTRY_COMPARE(capture.opened().ranging_take, std::string());
  }

  // While it records, every wire has a row below, and what was wrong is told in words.
  void the_overview_of_a_recording_shows_the_wires() {
    Capture capture;
    QVERIFY(capture.choose(kFakeBox));
    auto* view = capture.find<OverviewView>("overview");
    QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
    QTRY_VERIFY(capture.live().recording());
    QVERIFY(!capture.find<QDoubleSpinBox>("box_temperature")->isEnabled());
    QVERIFY(!capture.find<QComboBox>("box_sources")->isEnabled());
    QTRY_COMPARE(view->accessibleDescription(), QStringLiteral("nothing was lost"));
    QTRY_VERIFY(view->height() > 130);
    QTest::qWait(700);
    capture.box->change([](auto& says) {
      says.wires[4].lost_frames += 3;
      says.wires[2].plugged = false;
      says.wires[6].ranges_hz = 0.0;
      says.wires[8].clipped = true;
    });
    QTRY_VERIFY(view->accessibleDescription().contains(QStringLiteral("left shoulder: 3 word")));
    QVERIFY(view->accessibleDescription().contains(QStringLiteral("right shoulder: clips")));
    QVERIFY(view->accessibleDescription().contains(QStringLiteral("chest: pulled out")));
    QTest::qWait(900);
    const QImage picture = view->grab().toImage();
    QVERIFY(picture.save(screenshot_path(QStringLiteral("driver-box-overview"))));
    // A row can be chosen, and chooses the wire above.
    const double scale = picture.devicePixelRatio();
    int row = -1;
    for (int y = 0; y < view->height(); ++y) {
      row = view->wire_at(y) == 4 ? y + 3 : row;
      if (row >= 0) {
        break;
      }
    }
    QVERIFY(row > 0);
    QTest::mouseClick(view, Qt::LeftButton, {}, QPoint(20, row));
    QCOMPARE(capture.studio.context->selection().index_of(SelectionKind::kSensor), 4);
    // Lost words are in the colour of losses somewhere in the row of that board, and in no row of a board that is well.
    const QColor danger = theme_colors(view->palette()).danger;
    const auto reds = [&](int y) {
      int count = 0;
      for (int x = 0; x < picture.width(); ++x) {
        count += picture.pixelColor(x, static_cast<int>(y * scale)) == danger ? 1 : 0;
      }
      return count;
    };
    QVERIFY(reds(row) > 0);
    QCOMPARE(reds(row + 7), 0);
    QTest::mouseClick(capture.find<QPushButton>("record_button"), Qt::LeftButton);
    QTRY_VERIFY(capture.studio.context->document().is_open());
    QTRY_VERIFY(view->accessibleDescription().contains(QStringLiteral("left shoulder: 3 word")));
    QVERIFY(view->height() > 130);
  }

  // A box takes rigs for boxes alone, the sound card its own.
  void every_kind_of_device_has_its_rigs() {
    Capture capture;
    QVERIFY(capture.choose("simulator:wave"));
    auto* rigs = capture.find<QComboBox>("rig_box");
    QTRY_COMPARE(rigs->currentData().toString(), QStringLiteral("line-in-arm"));
    QCOMPARE(rigs->findData(QStringLiteral("driver-box-body")), -1);
    QVERIFY(capture.choose(kFakeBox));
    QTRY_COMPARE(rigs->currentData().toString(), QStringLiteral("driver-box-body"));
    QCOMPARE(rigs->findData(QStringLiteral("line-in-arm")), -1);
    QVERIFY(capture.choose("simulator:wave"));
    QTRY_COMPARE(rigs->currentData().toString(), QStringLiteral("line-in-arm"));
  }

  void ports_that_were_typed_are_kept_newest_first_four_at_most() {
    Capture capture;
    CaptureModel& model = capture.workspace->model();
    QTRY_VERIFY(!model.devices().empty());
    const auto index = [&](const std::string& id) {
      const auto& list = model.devices();
      const auto at = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.id == id; });
      return at == list.end() ? -1 : static_cast<int>(at - list.begin());
    };
    for (const QString& port : {QStringLiteral("/dev/a"), QStringLiteral("/dev/b"), QStringLiteral("/dev/c"),
                                QStringLiteral("/dev/d"), QStringLiteral(" /dev/a "), QStringLiteral("/dev/e")}) {
      model.open_box_port(port);
      QTRY_VERIFY(capture.live().running());
    }
    model.open_box_port(QStringLiteral("  "));
    const QStringList kept =
        capture.studio.context->settings().value(QStringLiteral("capture/box-ports")).toStringList();
    QCOMPARE(kept, QStringList({QStringLiteral("/dev/e"), QStringLiteral("/dev/a"), QStringLiteral("/dev/d"),
                                QStringLiteral("/dev/c")}));
    QCOMPARE(capture.box->ids.back(), std::string("driver-box:/dev/e"));
    model.refresh_devices();
    QTRY_VERIFY(!model.searching());
    QVERIFY(index("driver-box:/dev/a") > 0);
    QCOMPARE(index("driver-box:/dev/b"), -1);
    QVERIFY2(index("driver-box:/dev/c") < index("simulator:wave"), "the simulator is last");
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::BoxPanelTest)
#include "box_panel_test.moc"
