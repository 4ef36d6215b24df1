/// An hour of motion in the studio. How long things take is printed; that nothing grows with the length where it must
/// not is asserted.
#include <QElapsedTimer>
#include <QPainter>
#include <QTest>
#include <cstdio>
#include <fstream>

#include "plots/overview_view.h"
#include "timeline/timeline_canvas.h"
#include "ui/support/solve_fixture.h"
#include "workspaces/solve/curves_panel.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui::testing {

namespace {

double resident_mb() {
  std::ifstream status("/proc/self/statm");
  double pages = 0.0;
  status >> pages >> pages;
  return pages * 4096.0 / 1e6;
}

// Mean time of painting the whole widget anew, ms.
template <typename Before>
double paint_ms(QWidget& widget, int times, Before&& before) {
  QImage image(widget.size(), QImage::Format_ARGB32_Premultiplied);
  QElapsedTimer clock;
  double sum = 0.0;
  for (int i = 0; i < times; ++i) {
    before(i);
    clock.start();
    widget.render(&image);
    sum += static_cast<double>(clock.nsecsElapsed()) * 1e-6;
  }
  return sum / times;
}

}  // namespace

class HourTakeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { apply_theme(*qApp, ThemeKind::kDark); }

  void solve_and_timeline() {
    FakeSolving solving;
    solving.seconds = 3600.0;
    const double before_mb = resident_mb();
    SolveStudio studio(solving.services());
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    const double empty_mb = resident_mb();
    QElapsedTimer clock;
    clock.start();
    take::Take take = made_up_take(studio.take_folder(QStringLiteral("hour.take")), 3600.0);
    for (int i = 0; i < 2000; ++i) {  // a restless operator and a bad cable
      take.events.push_back({SampleIndex{96000 + 86400LL * i}, i % 3 == 0 ? "dropped" : "marker", "event", 0});
    }
    studio.context->document().set(take);
    QTRY_COMPARE_WITH_TIMEOUT(studio.model->state(), SolveState::kSolved, 120000);
    std::printf("an hour, 60 Hz: open to solved (made up) %.1f s; memory %.0f MB, of it %.0f MB empty studio\n",
                static_cast<double>(clock.elapsed()) * 1e-3, resident_mb() - before_mb, empty_mb - before_mb);
    auto& workspace = *qobject_cast<SolveWorkspace*>(studio.window->workspace(QStringLiteral("solve")));
    auto& curves = workspace.curves();
    auto* canvas = studio.window->findChild<TimelineCanvas*>();
    QVERIFY(canvas != nullptr);
    QTRY_VERIFY(curves.width() > 300 && curves.height() > 50 && canvas->width() > 300);  // laid out
    TimeModel& time = studio.context->time();
    // A key every two seconds on one bone.
    for (int i = 0; i < 1800; ++i) {
      QVERIFY(studio.model->key_editor().set_value(2, 2.0 * i, 0.1 * (i % 7)));
    }
    for (const double width_s : {3600.0, 600.0, 60.0, 6.0}) {
      const auto scroll = [&](int i) {
        time.set_visible(1000.0 * (width_s < 3000) + i, 1000.0 * (width_s < 3000) + i + width_s);
      };
      const double scrolled = paint_ms(curves, 8, [&](int i) {
        scroll(i);
        curves.update();
      });
      const double lane = paint_ms(*canvas, 8, scroll);
      const double played = paint_ms(curves, 8, [&](int i) { time.set_playhead(1000.0 + i); });
      std::printf("  %6.0f s visible: curves %.1f ms scrolled, %.1f ms played; timeline %.1f ms\n", width_s, scrolled,
                  played, lane);
    }
    std::fflush(stdout);
    clock.start();
    std::vector<body::SegmentPose> poses;
    for (int i = 0; i < 1000; ++i) {
      studio.model->pose_at(3.6 * i, poses);
    }
    std::printf("  pose at a time: %.1f us\n", static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    clock.start();
    for (int i = 0; i < 10; ++i) {
      QVERIFY(studio.model->change_length(1, 0.25 + 0.001 * i, 1));
    }
    std::printf("  one step of a bone's length: %.1f ms\n", static_cast<double>(clock.nsecsElapsed()) * 1e-7);
    clock.start();
    QVERIFY(studio.model->key_editor().set_value(2, 1.0, 0.5));
    std::printf("  one more key: %.1f ms; undone ", static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    clock.start();
    studio.context->undo_stack().undo();
    std::printf("in %.1f ms\n", static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    std::fflush(stdout);
  }

  void recorded_signal() {
    // An hour at 48 kHz, as the Capture workspace keeps it.
    auto overview = std::make_shared<TakeOverview>();
    overview->rate_hz = 48000.0;
    std::vector<float> second(2 * 48000);
    QElapsedTimer clock;
    clock.start();
    const double before_mb = resident_mb();
    for (int s = 0; s < 3600; ++s) {
      for (std::size_t i = 0; i < 48000; ++i) {
        second[2 * i] = 0.5F * static_cast<float>((i * 7 + static_cast<std::size_t>(s)) % 1000) / 1000.0F;
        second[2 * i + 1] = (i / 400) % 2 == 0 ? -0.7F : 0.7F;
      }
      overview->left.append(second, 2);
      overview->right.append(std::span<const float>(second).subspan(1), 2);
      overview->frames += 48000;
    }
    std::printf("signal of an hour at 48 kHz: made in %.1f s, %.0f MB\n", static_cast<double>(clock.elapsed()) * 1e-3,
                resident_mb() - before_mb);
    OverviewView view;
    view.resize(1200, 160);
    view.set_overview(overview);
    for (const double width_s : {3600.0, 60.0, 1.0, 0.1}) {
      const double ms = paint_ms(view, 8, [&](int i) { view.set_visible(1000.0 + i, 1000.0 + i + width_s); });
      std::printf("  %6.1f s visible: %.1f ms\n", width_s, ms);
    }
    std::fflush(stdout);
    for (const double width_s : {3600.0, 60.0, 1.0}) {
      const auto last = static_cast<std::int64_t>(width_s * 48000.0);
      QVERIFY2(overview->left.query(0, last, view.width()).size() < 4U * static_cast<std::size_t>(view.width()) + 2,
               "what is drawn goes with the width of the window, not with the length of the take");
    }
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::HourTakeTest)
#include "hour_take_test.moc"
