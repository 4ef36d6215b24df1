/// The Solve workspace with made-up solves, a running capture, and a simulated take from disk to picture.
#include "workspaces/solve/solve_workspace.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
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
#include "ui/support/fake_capture.h"
#include "ui/support/solve_fixture.h"
#include "workspaces/solve/bone_card.h"
#include "workspaces/solve/quality_card.h"
#include "workspaces/solve/settings_card.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui::testing {

class SolveWorkspaceTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<FakeSolving> solving_;
  std::unique_ptr<SolveStudio> studio_;

  void start(StudioServices services = {}) {
    solving_ = std::make_unique<FakeSolving>();
    studio_ = std::make_unique<SolveStudio>(solving_->services(), std::move(services));
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
  }
  void open(const QString& name = QStringLiteral("swing.take")) {
    studio_->context->document().set(made_up_take(studio_->take_folder(name), solving_->seconds));
    QTRY_COMPARE(studio_->window->current_workspace(), QStringLiteral("solve"));
  }
  void open_solved() {
    start();
    open();
    QTRY_COMPARE(model().state(), SolveState::kSolved);
  }
  [[nodiscard]] SolveModel& model() const { return *studio_->model; }
  [[nodiscard]] SolveWorkspace& workspace() const {
    return *qobject_cast<SolveWorkspace*>(studio_->window->workspace(QStringLiteral("solve")));
  }
  template <typename T>
  [[nodiscard]] T* find(const QString& accessible_name) const {
    for (T* widget : studio_->window->findChildren<T*>()) {
      if (widget->accessibleName() == accessible_name) {
        return widget;
      }
    }
    return nullptr;
  }
  [[nodiscard]] QPushButton* button(const QString& text) const {
    for (QPushButton* one : studio_->window->findChildren<QPushButton*>()) {
      if (one->text() == text && one->isVisible()) {
        return one;
      }
    }
    return nullptr;
  }
  [[nodiscard]] bool says(const QString& text) const {
    for (QLabel* label : studio_->window->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) {
        return true;
      }
    }
    return false;
  }
  void save(const QString& name) const { QVERIFY(studio_->screen().save(screenshot_path(name))); }
  // Heading of a segment in the viewer: angle of its bone about the vertical.
  [[nodiscard]] double azimuth(int segment) const {
    const Eigen::Vector3d x =
        workspace().viewer().pose()[static_cast<std::size_t>(segment)].R_WL * Eigen::Vector3d::UnitX();
    return std::atan2(x.y(), x.x());
  }

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
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::SolveWorkspaceTest)
#include "solve_workspace_test.moc"
