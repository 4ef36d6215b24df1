/// Sensor to screen, in the real studio: a board played by a real sound server, captured by PortAudio, and the built-in
/// simulator. What depends on how busy the machine is gets printed, by the studio's own account; what does not is
/// asserted.
///
/// LIMBWAVE_LATENCY_SECONDS: how long each capture is watched (12).
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "common/core_services.h"
#include "common/latency_text.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "simulate/simulate.h"
#include "support/pulse_server.h"
#include "ui/support/studio_fixture.h"
#include "viewer/viewer_widget.h"

namespace limbwave::ui::testing {

class LiveLatencyTest : public QObject {
  Q_OBJECT

 private:
  static int seconds() {
    const int wanted = qEnvironmentVariableIntValue("LIMBWAVE_LATENCY_SECONDS");
    return wanted > 0 ? wanted : 12;
  }

  // The figure on screen, watched by the studio.
  static void watch(const QString& id, const QString& title) {
    StudioFixture studio(core_services());
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    LiveModel& live = studio.context->live();
    studio.window->show_workspace(QStringLiteral("solve"));
    QVERIFY(live.open(id, title, "line-in-arm", {}));
    QTRY_VERIFY_WITH_TIMEOUT(live.running(), 20000);
    auto* viewer = studio.window->findChild<ViewerWidget*>();
    QVERIFY(viewer != nullptr);
    QSignalSpy frames(viewer, &ViewerWidget::frame_rendered);
    QSignalSpy figures(&live, &LiveModel::figure_ready);
    QTRY_VERIFY_WITH_TIMEOUT(live.latency().poses > 20 && frames.size() > 20, 60000);

    const std::uint64_t first = live.figure()->number;
    const qsizetype drawn_before = frames.size();
    QTest::qWait(1000 * seconds());
    const auto figure = live.figure();
    const solve::LatencyReport report = live.latency();
    const auto snapshot = live.snapshot();
    const auto solved = static_cast<double>(figure->number - first);
    std::printf("%s: %.0f poses in %d s, %.1f %% of them drawn\n", qPrintable(title), solved, seconds(),
                100.0 * static_cast<double>(frames.size() - drawn_before) / solved);
    std::printf("  stage       mean    95 %%     max, ms, of the last %zu poses\n", report.poses);
    for (std::size_t s = 0; s < solve::kLatencyStages; ++s) {
      std::printf("  %-9s %6.1f  %6.1f  %6.1f\n", std::string(solve::name(static_cast<solve::LatencyStage>(s))).c_str(),
                  1e3 * report.stages[s].mean_s, 1e3 * report.stages[s].p95_s, 1e3 * report.stages[s].max_s);
    }
    std::printf("  above 80 ms: %.2f %%; not counted: the device's buffer, %.1f ms by its own account; worker %s\n",
                100.0 * report.over_budget, 1e3 * snapshot->device_latency_s,
                snapshot->preferred ? "preferred" : "at ordinary priority");
    std::fflush(stdout);

    // The board's own round: from the middle of its first slot to the end of its last.
    const double cycle_s = 1.0 / snapshot->line.cycle_rate_hz;
    QVERIFY(qAbs(report.of(solve::LatencyStage::kCycle).mean_s - cycle_s * (1.0 - 0.5 / 16.0)) < 0.05 * cycle_s);
    // Nothing is left out of the account.
    double sum = 0.0;
    for (std::size_t s = 0; s + 1 < solve::kLatencyStages; ++s) {
      sum += report.stages[s].mean_s;
      QVERIFY(report.stages[s].mean_s <= report.stages[s].max_s);
    }
    QVERIFY(qAbs(report.of(solve::LatencyStage::kTotal).mean_s - sum) < 1e-9);
    QVERIFY(report.of(solve::LatencyStage::kDraw).mean_s > 0.0);
    // No cycle is waited for beyond the newest: the pose is the middle of the last cycle before it was solved.
    QVERIFY(qAbs(figure->times.cycle_end - figure->times.instant - 0.5 * cycle_s) < 0.05 * cycle_s);
    // And the studio tells it, in words.
    const auto told = [&studio] {
      const auto labels = studio.window->findChildren<ElidedLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const ElidedLabel* label) {
        return label->full_text().contains(QStringLiteral("sensor to screen"));
      });
    };
    QTRY_VERIFY(told());
    save(studio, title);
    live.close();
    QTRY_VERIFY_WITH_TIMEOUT(!live.running(), 20000);
    QTest::qWait(300);  // the device is closed by a job
  }

  static void save(const StudioFixture& studio, const QString& title) {
    studio.window->grab().save(screenshot_path(QStringLiteral("live-") + title.toLower().replace(u' ', u'-')));
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY2(opengl_available(), "this machine draws no OpenGL: install libgl1-mesa-dri");
    apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()), ThemeKind::kDark);
  }

  void simulator_to_screen() { watch(QStringLiteral("simulator:walk"), QStringLiteral("Simulator")); }

  void sound_server_to_screen() {
    std::string why_not;
    if (!test::PulseServer::available(why_not)) {
      QSKIP(why_not.c_str());
    }
    const QTemporaryDir folder;
    simulate::SimulateSettings settings;
    settings.motion = "walk";
    settings.errors_name = "electronics";
    settings.errors = simulate::load_errors("electronics").value();
    settings.prologue = false;
    settings.seconds = seconds() + 90.0;
    const std::filesystem::path played = folder.filePath(QStringLiteral("played.take")).toStdString();
    QVERIFY(simulate::simulate_take(played, settings, {}).ok());
    test::PulseServer server(48000);
    const auto player = server.play(played / "signal.wav");
    watch(QString::fromStdString(test::PulseServer::capture_id()), QStringLiteral("Sound server"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::LiveLatencyTest)
#include "live_latency_test.moc"
