/// The Solve workspace with made-up solves, a running capture, and a simulated take from disk to picture.
#include "workspaces/solve/solve_workspace.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
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
#include "workspaces/solve/curves_panel.h"
#include "workspaces/solve/quality_card.h"
#include "workspaces/solve/settings_card.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui::testing {

class SolveWorkspaceTest : public SolveWindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }
  void cleanup() {
    studio_.reset();
    solving_.reset();
  }

  void without_a_take_it_says_what_to_do() {
    start();
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(says(QStringLiteral("No take is open")));
    save(QStringLiteral("solve-empty"));
  }

  void opening_a_take_without_a_solve_solves_and_saves_it() {
    open_solved();
    QCOMPARE(solving_->solved.load(), 1);
    QCOMPARE(solving_->loaded.load(), 0);
    QTRY_COMPARE(solving_->saved.load(), 1);
    QVERIFY(std::abs(studio_->context->time().duration_s() - 8.0) < 0.02);
    QTRY_VERIFY(says(QStringLiteral("every sensor was heard")));
    // Opened again, it is read and not solved.
    open(QStringLiteral("other.take"));
    QTRY_COMPARE(solving_->loaded.load(), 1);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QCOMPARE(solving_->solved.load(), 1);
  }

  void the_first_demo_plays_by_itself_later_ones_do_not() {
    start();
    TimeModel& time = studio_->context->time();
    open(QStringLiteral("demo-reach.take"));
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(time.playing());
    QVERIFY(studio_->context->notifications().all().front().remedy.contains(QStringLiteral("Space")));
    time.set_playing(false);
    open(QStringLiteral("demo-walk.take"));
    QTRY_COMPARE(solving_->loaded.load(), 1);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(!time.playing());
  }

  void the_viewer_follows_the_playhead() {
    open_solved();
    const auto before = workspace().viewer().pose();
    studio_->context->time().set_playhead(2.0);
    QVERIFY(before[2].R_WL.angularDistance(workspace().viewer().pose()[2].R_WL) > 0.2);
  }

  void a_bone_selected_anywhere_is_selected_everywhere() {
    open_solved();
    Q_EMIT workspace().viewer().segment_clicked(2);
    QCOMPARE(studio_->context->selection().index_of(SelectionKind::kSegment), 2);
    QCOMPARE(workspace().viewer().selected(), 2);
    QCOMPARE(find<QComboBox>(QStringLiteral("Selected bone"))->currentText(), QStringLiteral("forearm"));
    studio_->context->selection().select(SelectionKind::kSensor, 1);
    QCOMPARE(workspace().viewer().selected(), 1);
    Q_EMIT workspace().viewer().segment_clicked(-1);
    QCOMPARE(workspace().viewer().selected(), -1);
  }

  void solving_shows_progress_and_can_be_cancelled() {
    start();
    solving_->block = true;
    open();
    QTRY_COMPARE(model().state(), SolveState::kSolving);
    QTest::qWait(600);
    save(QStringLiteral("solve-progress"));
    QTest::mouseClick(button(QStringLiteral("Cancel solving")), Qt::LeftButton);
    QTRY_COMPARE(model().state(), SolveState::kFailed);
    QVERIFY(says(QStringLiteral("Solving was cancelled")));
    solving_->block = false;
    QTest::mouseClick(button(QStringLiteral("Try again")), Qt::LeftButton);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
  }

  void failures_are_sentences_with_a_remedy() {
    start();
    solving_->failure = Error{"the right channel carries no counter signal", "swing.take/signal.wav",
                              "check that both plugs of the stereo cable are in, then record again"};
    open();
    QTRY_COMPARE(model().state(), SolveState::kFailed);
    QVERIFY(says(QStringLiteral("The right channel carries no counter signal")));
    QVERIFY(says(QStringLiteral("Check that both plugs")));
    save(QStringLiteral("solve-error"));
  }

  void a_bad_report_names_sensors_and_remedies() {
    start();
    SolveServices services = solving_->services();
    open_solved();
    solve::Solve bad = *model().solve();
    bad.report.sensors[1] = {bad.report.sensors[1].sensor, 0.61, 0.3, 1.2};
    bad.report.sensors[3].mean_norm_g = 1.08;
    bad.report.line.lost_cycles = 20;
    bad.report.line.left_coupling_hz = 4.97;
    bad.report.line.coupling_sd_hz = 0.02;
    bad.report.line.noise = 0.001;
    bad.report.diagnostics = {{Severity::kWarning, "line-in.gain-changed", "the volume was moved by a factor of 0.5",
                               "leave the volume alone during a take", "", 4.2}};
    {
      const std::lock_guard lock(solving_->mutex);
      solving_->stored = bad;
    }
    open(QStringLiteral("a-take-with-a-very-long-name-that-somebody-typed-late-at-night-in-the-studio.take"));
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QTRY_VERIFY(says(QStringLiteral("61 %")));
    QVERIFY(says(QStringLiteral("Check its plug and cable")));
    QVERIFY(says(QStringLiteral("Leave the volume alone")));
    studio_->context->selection().select(SelectionKind::kSegment, 2);
    save(QStringLiteral("solve-bad-report"));
  }

  void a_solve_that_fails_again_says_so_over_the_older_one() {
    open_solved();
    solving_->failure = Error{"the calibration library has nothing for this rig", "", "calibrate its sensors"};
    model().start();
    QTRY_COMPARE(model().state(), SolveState::kFailed);
    QVERIFY(says(QStringLiteral("The calibration library has nothing for this rig.")));
    QVERIFY(says(QStringLiteral("Calibrate its sensors")));
    QVERIFY(button(QStringLiteral("Calibrate")) != nullptr);
    save(QStringLiteral("solve-failed-again"));
    solving_->failure.reset();
    QTest::mouseClick(button(QStringLiteral("Try again")), Qt::LeftButton);
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(!says(QStringLiteral("has nothing for this rig")));
    QVERIFY(button(QStringLiteral("Try again")) == nullptr);
  }

  void every_key_may_be_pressed_in_every_workspace() {
    start();
    open();
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    for (const char* name : {"solve", "export", "capture", "calibrate", "welcome"}) {
      studio_->window->show_workspace(QString::fromLatin1(name));
      QWidget* page = studio_->window->workspace(QString::fromLatin1(name));
      if (page == nullptr) {
        continue;
      }
      page->setFocus();
      for (int key = Qt::Key_A; key <= Qt::Key_Z; ++key) {
        for (const Qt::KeyboardModifiers modifiers :
             {Qt::KeyboardModifiers(Qt::NoModifier), Qt::KeyboardModifiers(Qt::ShiftModifier),
              Qt::KeyboardModifiers(Qt::ControlModifier)}) {
          if (modifiers == Qt::ControlModifier &&
              (key == Qt::Key_Q || key == Qt::Key_N || key == Qt::Key_O || key == Qt::Key_I || key == Qt::Key_W)) {
            continue;  // Ends the program, opens a dialog or closes the take, as it should.
          }
          QTest::keyClick(page, static_cast<Qt::Key>(key), modifiers);
        }
      }
    }
    QVERIFY(studio_->context->document().is_open());
  }

  void curves_are_shown_with_the_solve() {
    open_solved();
    const QImage picture = workspace().curves().grab().toImage();
    const QColor series = series_color(theme_colors(workspace().palette()), 1);
    int coloured = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const QColor at = picture.pixelColor(x, y);
        coloured += std::abs(at.red() - series.red()) + std::abs(at.green() - series.green()) +
                                std::abs(at.blue() - series.blue()) <
                            120
                        ? 1
                        : 0;
      }
    }
    QVERIFY2(coloured > 100, "the second sensor's curve is there");
  }

  void nothing_slow_is_done_in_the_windows_own_thread() {
    std::atomic<int> in_window{0}, elsewhere{0};
    const auto note = [&] { ++(QThread::currentThread() == qApp->thread() ? in_window : elsewhere); };
    FakeSolving made;
    SolveServices services = made.services();
    services.list = [&, list = services.list](const take::Take& take) {
      note();
      return list(take);
    };
    services.load = [&, load = services.load](const take::Take& take, const std::string& name) {
      note();
      return load(take, name);
    };
    services.save = [&, keep = services.save](const take::Take& take, const solve::Solve& solve) {
      note();
      return keep(take, solve);
    };
    services.load_truth = [&](const take::Take&) -> Result<std::optional<evaluate::Truth>> {
      note();
      return std::optional<evaluate::Truth>(evaluate::Truth{});
    };
    services.evaluate = [&](const motion::Clip&, double, const evaluate::Truth&) -> Result<evaluate::Evaluation> {
      note();
      return evaluate::Evaluation{};
    };
    StudioServices capture = capture_services();
    capture.load_rig = [&, load = capture.load_rig](const std::string& rig, const std::string& subject,
                                                    const std::string& device) {
      note();
      return load(rig, subject, device);
    };
    capture.list_rigs = [] { return std::vector<RigChoice>{{"line-in-arm", "Arm"}}; };
    studio_ = std::make_unique<SolveStudio>(services, capture);
    studio_->window->show_workspace(QStringLiteral("capture"));
    QVERIFY(studio_->context->live().open(QStringLiteral("fake"), QStringLiteral("Card"), "line-in-arm", {}));
    QTRY_VERIFY(studio_->context->live().running());
    for (const char* name : {"a.take", "b.take"}) {
      studio_->context->document().set(made_up_take(studio_->take_folder(QString::fromLatin1(name)), made.seconds));
      QTRY_COMPARE(model().state(), SolveState::kSolved);
      QVERIFY(model().change_length(1, model().skeleton().segments[1].length + 0.01));
      model().save();
      QTRY_VERIFY(studio_->context->jobs().jobs().empty());
    }
    QVERIFY(made.loaded.load() > 0 && made.saved.load() > 1);
    QVERIFY(elsewhere.load() > 8);
    QCOMPARE(in_window.load(), 0);
    studio_.reset();
  }

  void comparing_with_the_truth_never_piles_up_and_the_newest_stands() {
    FakeSolving made;
    SolveServices services = made.services();
    std::atomic<int> running{0}, most{0}, begun{0};
    std::atomic<bool> hold{false};
    services.load_truth = [](const take::Take&) -> Result<std::optional<evaluate::Truth>> {
      return std::optional<evaluate::Truth>(evaluate::Truth{});
    };
    services.evaluate = [&](const motion::Clip& clip, double, const evaluate::Truth&) -> Result<evaluate::Evaluation> {
      ++begun;
      most = std::max(most.load(), ++running);
      while (hold) {
        QThread::msleep(5);
      }
      --running;
      evaluate::Evaluation evaluation;
      evaluation.all.inclination_mean_deg = 1000.0 * clip.skeleton.segments[1].length;
      return evaluation;
    };
    studio_ = std::make_unique<SolveStudio>(services);
    studio_->context->document().set(made_up_take(studio_->take_folder(QStringLiteral("a.take")), made.seconds));
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QCOMPARE(begun.load(), 1);
    hold = true;
    QVERIFY(model().change_length(1, 0.31));
    QTRY_COMPARE(begun.load(), 2);
    for (const double length : {0.32, 0.33, 0.34}) {
      QVERIFY(model().change_length(1, length));
      QTest::qWait(900);  // Longer than it waits for the next edit.
    }
    QCOMPARE(begun.load(), 2);
    hold = false;
    QTRY_VERIFY(std::abs(model().evaluation()->all.inclination_mean_deg - 340.0) < 1e-6);
    QCOMPARE(most.load(), 1);
    QVERIFY2(begun.load() <= 4, "states that were overtaken are left out");
    studio_.reset();
  }

  void simulated_take_from_disk_to_picture() {
    solving_ = std::make_unique<FakeSolving>();
    studio_ = std::make_unique<SolveStudio>(core_solve_services());
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
    simulate::SimulateSettings settings;
    settings.errors = simulate::load_errors("paper").value();
    settings.errors_name = "paper";
    const QString folder = studio_->take_folder(QStringLiteral("wave.take"));
    const Status made = simulate::simulate_take(folder.toStdString(), settings, {});
    QVERIFY2(made.ok(), made ? "" : made.error().text().c_str());
    studio_->context->document().set(take::open_take(folder.toStdString()).value());
    QTRY_COMPARE_WITH_TIMEOUT(model().state(), SolveState::kSolved, 60000);
    QVERIFY(model().has_truth());
    QVERIFY(model().evaluation().has_value());
    TimeModel& time = studio_->context->time();
    time.set_playhead(0.45 * time.duration_s());
    studio_->context->selection().select(SelectionKind::kSegment, 2);
    QVERIFY(model().key_editor().set_value(2, 0.2 * time.duration_s(), 0.0));
    QVERIFY(model().key_editor().set_value(2, 0.5 * time.duration_s(), radians(25.0)));
    save(QStringLiteral("solve-dark"));
    apply_theme(*qApp, ThemeKind::kLight);
    save(QStringLiteral("solve-light"));
    studio_->window->show_workspace(QStringLiteral("export"));
    save(QStringLiteral("export-light"));
    apply_theme(*qApp, ThemeKind::kDark);
    save(QStringLiteral("export-dark"));
  }

  void a_driver_boxs_take_is_solved_by_the_body_filter() {
    solving_ = std::make_unique<FakeSolving>();
    studio_ = std::make_unique<SolveStudio>(core_solve_services());
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
    simulate::SimulateSettings settings;
    settings.rig = "driver-box-body";
    settings.motion = "walk";
    settings.seconds = 3.0;
    settings.errors_name = "none";
    settings.driver_box_errors = simulate::load_driver_box_errors("none").value();
    const QString folder = studio_->take_folder(QStringLiteral("box.take"));
    const Status made = simulate::simulate_take(folder.toStdString(), settings, {});
    QVERIFY2(made.ok(), made ? "" : made.error().text().c_str());
    studio_->context->document().set(take::open_take(folder.toStdString()).value());
    QTRY_COMPARE_WITH_TIMEOUT(model().state(), SolveState::kSolved, 120000);
    QVERIFY(!model().by_inclination());
    QVERIFY(says(QStringLiteral("All sensors together")));
    QCOMPARE(find<QComboBox>(QStringLiteral("Smoothing"))->isVisible(), false);
    QVERIFY(model().evaluation().has_value());
    QVERIFY2(model().evaluation()->all.inclination_mean_deg < 3.0, "the figure follows the body");
    const auto& curve = model().curves()->front();
    QVERIFY(curve.sigma_deg.size() == curve.elevation_deg.size() && curve.sigma_deg.front() > 0.0F);
    // Eighteen sensors do not fit: the selected one is scrolled to.
    auto* bar = workspace().findChild<CurvesPanel*>()->findChild<QScrollBar*>();
    QVERIFY(bar->isVisible());
    QCOMPARE(bar->value(), 0);
    studio_->context->selection().select(SelectionKind::kSegment, model().skeleton().find("right_foot"));
    QVERIFY(bar->value() > 0);
    save(QStringLiteral("solve-driver-box"));
    studio_->window->show_workspace(QStringLiteral("calibrate"));
    QVERIFY(says(QStringLiteral("This take needs no calibration by hand")));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::SolveWorkspaceTest)
#include "solve_workspace_test.moc"
