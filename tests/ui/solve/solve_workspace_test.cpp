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
#include <thread>

#include "base/units.h"
#include "common/latency_text.h"
#include "common/widgets.h"
#include "simulate/simulate.h"
#include "ui/support/solve_fixture.h"
#include "workspaces/solve/bone_card.h"
#include "workspaces/solve/quality_card.h"
#include "timeline/timeline_canvas.h"
#include "workspaces/solve/settings_card.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui::testing {

namespace {

/// A capture with a pose every 17 ms, each one frame old.
class FakeCapture : public LiveBackend {
 public:
  explicit FakeCapture(body::Skeleton skeleton) : skeleton_(std::move(skeleton)) {}
  ~FakeCapture() override { end(); }
  Status start() override {
    running_ = true;
    thread_ = std::thread([this] {
      while (running_) {
        std::this_thread::sleep_for(std::chrono::milliseconds(17));
        ++number_;
        told_();
      }
    });
    return {};
  }
  void stop() override { end(); }
  Status start_recording(const std::filesystem::path& folder, const std::string&) override {
    folder_ = folder;
    recording_since_ = steady_now_s();
    return {};
  }
  Result<take::Take> stop_recording() override {
    take::Take take = made_up_take(QString::fromStdString(folder_.string()), 8.0);
    take.info.segments.clear();
    take.events = std::exchange(marks_, {});
    recording_since_ = 0.0;
    return take;
  }
  std::optional<take::TakeEvent> mark(const std::string& text) override {
    const auto number = static_cast<std::int64_t>(marks_.size()) + 1;
    marks_.push_back({SampleIndex{std::llround(48000.0 * (steady_now_s() - recording_since_))}, "marker", text, number});
    return marks_.back();
  }
  bool write_event(const take::TakeEvent&) override { return true; }
  void set_calibration(const calibrate::RigCalibration&) override {}
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) override {
    const std::lock_guard lock(mutex_);
    headings_ = headings;
  }
  void on_figure(std::function<void()> told) override { told_ = std::move(told); }
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override {
    auto shot = std::make_shared<solve::LiveSnapshot>();
    shot->version = ++version_;
    shot->recording = recording_since_ > 0.0;
    shot->recorded_s = shot->recording ? steady_now_s() - recording_since_ : 0.0;
    return shot;
  }
  [[nodiscard]] std::shared_ptr<const solve::LiveFigure> figure() const override {
    if (number_ == 0) {
      return nullptr;
    }
    auto made = std::make_shared<solve::LiveFigure>();
    made->number = number_;
    const std::vector<double> now{steady_now_s()};
    std::vector<body::Quaterniond> R;
    const std::lock_guard lock(mutex_);
    for (const auto& list : made_up_motion(skeleton_, now)) {
      const double heading = R.size() < headings_.size() ? solve::heading_at(headings_[R.size()], 0.0) : 0.0;
      R.push_back(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * list.front());
    }
    made->pose = body::poses_from_orientations(skeleton_, R, skeleton_.segments.front().p_PL);
    made->times.oldest_slot = now.front() - 0.017;
    made->times.instant = made->times.oldest_slot + 0.008;
    made->times.cycle_end = made->times.arrived = made->times.solved = now.front();
    return made;
  }

 private:
  void end() {
    running_ = false;
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  body::Skeleton skeleton_;
  std::function<void()> told_;
  std::thread thread_;
  std::atomic<bool> running_{false};
  std::atomic<std::uint64_t> number_{0};
  mutable std::mutex mutex_;
  std::vector<std::vector<solve::HeadingKey>> headings_;
  mutable std::atomic<std::uint64_t> version_{0};
  std::atomic<double> recording_since_{0.0};
  std::filesystem::path folder_;
  std::vector<take::TakeEvent> marks_;
};

class SilentSource : public acquire::LiveSource {
 public:
  [[nodiscard]] acquire::StreamFormat format() const override { return {}; }
  [[nodiscard]] std::string title() const override { return "fake"; }
  Status start() override { return {}; }
  void stop() override {}
  std::size_t pull(std::span<std::byte>) override { return 0; }
  [[nodiscard]] acquire::SourceCounters counters() const override { return {}; }
  [[nodiscard]] bool alive() const override { return true; }
  [[nodiscard]] double device_latency_s() const override { return 0.0; }
  [[nodiscard]] double newest_frame_time_s() const override { return 0.0; }
};

StudioServices capture_services() {
  StudioServices services;
  services.load_rig = [](const std::string& name, const std::string&,
                         const std::string&) -> Result<solve::LiveSettings> {
    solve::LiveSettings settings;
    settings.rig = body::load_rig(name).value();
    settings.skeleton = body::load_skeleton(settings.rig.skeleton).value();
    return settings;
  };
  services.open_device = [](const std::string&, const DeviceSetup&,
                            const std::string&) -> Result<std::unique_ptr<acquire::LiveSource>> {
    return std::unique_ptr<acquire::LiveSource>(std::make_unique<SilentSource>());
  };
  services.make_live = [](std::unique_ptr<acquire::LiveSource>, solve::LiveSettings settings) {
    return std::unique_ptr<LiveBackend>(std::make_unique<FakeCapture>(settings.skeleton));
  };
  return services;
}

}  // namespace

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

  void live_capture_moves_the_figure_and_measures_its_latency() {
    start(capture_services());
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(studio_->context->live().open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    QSignalSpy frames(&workspace().viewer(), &ViewerWidget::frame_rendered);
    const LiveModel& live = studio_->context->live();
    // The first second is not counted.
    QTRY_VERIFY_WITH_TIMEOUT(live.latency().poses > 30, 20000);
    const solve::LatencyReport report = live.latency();
    QVERIFY(static_cast<std::size_t>(frames.size()) >= report.poses);
    QVERIFY(qAbs(report.of(solve::LatencyStage::kCycle).mean_s - 0.017) < 1e-6);
    QVERIFY(report.of(solve::LatencyStage::kDraw).mean_s > 0.0);
    double sum = 0.0;
    for (std::size_t stage = 0; stage + 1 < solve::kLatencyStages; ++stage) {
      sum += report.stages[stage].mean_s;
    }
    QVERIFY(qAbs(report.of(solve::LatencyStage::kTotal).mean_s - sum) < 1e-9);
    const Eigen::Vector3d then = workspace().viewer().pose()[3].p_WL;
    QTRY_VERIFY((workspace().viewer().pose()[3].p_WL - then).norm() > 0.01);
    qInfo().noquote() << latency_sentences(report, 0.0);
    const auto told = [this] {
      const auto labels = studio_->window->findChildren<ElidedLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const ElidedLabel* label) {
        return label->full_text().contains(QStringLiteral("sensor to screen"));
      });
    };
    QTRY_VERIFY(told());
    save(QStringLiteral("solve-live"));
    studio_->context->live().close();
    QTRY_VERIFY(!workspace().shows_live());
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

  void after_a_recording_its_take_is_shown_and_the_live_choice_is_kept() {
    start(capture_services());
    studio_->window->show_workspace(QStringLiteral("solve"));
    LiveModel& live = studio_->context->live();
    QVERIFY(live.open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    // The whole figure is in the picture, however the arm is stretched.
    const OrbitCamera& camera = workspace().viewer().camera();
    const QSizeF size = workspace().viewer().size();
    QTRY_VERIFY(workspace().viewer().isVisible());
    for (const Eigen::Vector3d& point : reach_extent(live.settings().skeleton)) {
      const auto seen = camera.project(point, {size.width(), size.height()});
      QVERIFY(seen && seen->x() > 0 && seen->x() < size.width() && seen->y() > 0 && seen->y() < size.height());
    }
    QVERIFY(live.start_recording(studio_->take_folder(QStringLiteral("first.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    QVERIFY(workspace().shows_live());
    live.stop_recording();
    QTRY_VERIFY(studio_->context->document().is_open());
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    QVERIFY(!workspace().shows_live());
    std::vector<body::SegmentPose> expected;
    model().pose_at(0.0, expected);
    QTest::qWait(100);  // Live figures still come.
    QVERIFY(workspace().viewer().pose()[3].p_WL.isApprox(expected[3].p_WL));
    // The choice outlives a visit elsewhere, both ways.
    QPushButton* button = this->button(QStringLiteral("Live"));
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(workspace().shows_live());
    studio_->window->show_workspace(QStringLiteral("export"));
    QVERIFY(!model().shows_live());
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(workspace().shows_live() && model().shows_live());
    QTest::mouseClick(button, Qt::LeftButton);
    studio_->window->show_workspace(QStringLiteral("export"));
    studio_->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(!workspace().shows_live());
    // A new recording is watched whatever was chosen.
    QVERIFY(live.start_recording(studio_->take_folder(QStringLiteral("second.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    QVERIFY(workspace().shows_live());
    live.stop_recording();
    QTRY_VERIFY(!workspace().shows_live());
    QTRY_COMPARE(studio_->context->document().name(), QStringLiteral("second"));
  }

  void a_bone_turned_live_turns_at_once_and_becomes_keys_of_the_take() {
    start(capture_services());
    studio_->window->show_workspace(QStringLiteral("solve"));
    LiveModel& live = studio_->context->live();
    QVERIFY(live.open(QStringLiteral("fake"), QStringLiteral("Sound card"), "line-in-arm", {}));
    QTRY_VERIFY(workspace().shows_live());
    QTRY_COMPARE(workspace().viewer().pose().size(), live.settings().skeleton.segments.size());
    Q_EMIT workspace().viewer().segment_clicked(2);
    auto* box = find<QDoubleSpinBox>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    QVERIFY(box != nullptr && box->isEnabled());
    QTRY_VERIFY(std::abs(azimuth(2)) < 1e-6);
    box->setValue(40.0);
    QTRY_VERIFY(std::abs(azimuth(2) - radians(40.0)) < 1e-6);
    save(QStringLiteral("solve-live-turned"));
    QUndoStack& undo = studio_->context->undo_stack();
    undo.undo();
    QTRY_VERIFY(std::abs(azimuth(2)) < 1e-6);
    QCOMPARE(box->value(), 0.0);
    undo.redo();
    QTRY_VERIFY(std::abs(azimuth(2) - radians(40.0)) < 1e-6);
    // In a recording: where it stood, then a turn by the slider, one taken back, and none of the other bones.
    QVERIFY(live.start_recording(studio_->take_folder(QStringLiteral("turned.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    QTRY_VERIFY(live.snapshot()->recorded_s > 0.3);
    auto* slider = find<QSlider>(QStringLiteral("Rotation about the vertical at the playhead in degrees"));
    slider->setSliderDown(true);
    const double begun_s = live.snapshot()->recorded_s;
    slider->setSliderPosition(500);
    QTRY_VERIFY(live.snapshot()->recorded_s > begun_s + 0.2);
    slider->setSliderPosition(900);
    const double ended_s = live.snapshot()->recorded_s;
    slider->setSliderDown(false);
    const int steps = undo.count();
    box->setValue(10.0);
    undo.undo();
    QCOMPARE(undo.index(), steps);
    QTest::qWait(50);
    live.stop_recording();
    QTRY_COMPARE(studio_->context->document().name(), QStringLiteral("turned"));
    QTRY_COMPARE(model().state(), SolveState::kSolved);
    const auto& keys = model().keys().keys(2);
    QCOMPARE(keys.size(), std::size_t{3});
    QCOMPARE(keys[0].time_s, 0.0);
    QVERIFY(std::abs(keys[0].value - radians(40.0)) < 1e-9);
    QVERIFY(std::abs(keys[1].time_s - begun_s) < 0.02 && std::abs(keys[1].value - radians(40.0)) < 1e-9);
    QVERIFY(std::abs(keys[2].time_s - ended_s) < 0.02 && std::abs(keys[2].value - radians(90.0)) < 1e-9);
    for (const int other : {0, 1, 3}) {
      QVERIFY(model().keys().keys(other).empty());
    }
    // It is in the solve itself, and so on the disk and in what is exported.
    studio_->context->time().set_playhead(6.0);
    QVERIFY(std::abs(azimuth(2) - radians(90.0)) < 1e-6);
    QTRY_VERIFY([&] {
      const std::lock_guard lock(solving_->mutex);
      return solving_->stored && solving_->stored->settings.headings.size() > 2 &&
             solving_->stored->settings.headings[2].size() == 3;
    }());
    // Live the bone still stands as it was turned last.
    QTest::mouseClick(button(QStringLiteral("Live")), Qt::LeftButton);
    QTRY_VERIFY(std::abs(azimuth(2) - radians(90.0)) < 1e-6);
    Q_EMIT workspace().viewer().segment_clicked(2);
    QTest::mouseClick(button(QStringLiteral("Back to 0°")), Qt::LeftButton);
    QTRY_VERIFY(std::abs(azimuth(2)) < 1e-6);
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
