/// What is chosen on the Export page: frame rates that are proposed, the way back, and no picture of anything else.
#include <QSignalSpy>
#include <QToolButton>
#include <QUndoStack>

#include "interchange/bvh_reader.h"
#include "ui/export/export_fixture.h"
#include "viewer/viewer_widget.h"
#include "workspaces/take_actions.h"

namespace limbwave::ui::testing {

class ExportChoicesTest : public QObject, protected ExportCase {
  Q_OBJECT

 private:
  /// With a take whose board keeps its own time.
  void open(double rate_hz = 60.0) {
    SolveServices services = solving_->services();
    services.solve = [made = services.solve, rate_hz](const take::Take& take, const solve::SolveSettings& settings,
                                                      const Progress& progress) {
      Result<solve::Solve> solve = made(take, settings, progress);
      if (solve) {
        solve->clip.frame_rate_hz = rate_hz;
      }
      return solve;
    };
    QVERIFY(open_studio(std::move(services)));
    QVERIFY(studio_->open_take());
  }
  void open_nothing() { QVERIFY(open_studio(solving_->services())); }
  [[nodiscard]] QString rate() const { return studio_->find<QComboBox>("Frame rate")->currentText(); }
  [[nodiscard]] QString title() const { return studio_->studio->window->windowTitle(); }

 private Q_SLOTS:
  void init() { set_up(); }
  void cleanup() { tear_down(); }

  void usual_rates_are_proposed() {
    const std::vector<std::pair<double, double>> expected{
        {62.071, 60.0}, {60.0, 60.0},     {60.003, 60.0}, {59.9, 50.0}, {59.94, 59.94}, {119.0, 60.0},
        {240.0, 120.0}, {1000.0, 120.0},  {100.0, 100.0}, {49.0, 30.0}, {29.0, 25.0},   {24.5, 24.0},
        {30.0, 30.0},   {23.976, 23.976}, {23.0, 23.0},   {12.5, 12.5}, {0.0, 0.0},     {48.0, 48.0}};
    for (const auto& [own, proposed] : expected) {
      QCOMPARE(proposed_rate(own), proposed);
    }
  }

  void a_usual_rate_is_proposed_and_written_and_the_takes_own_is_offered() {
    open(62.071);
    QCOMPARE(rate(), QStringLiteral("Proposed: 60 frames a second"));
    QVERIFY(studio_->says("481 at 60 Hz"));
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY(studio_->export_now());
    auto back = interchange::load_bvh(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    QVERIFY(std::abs(back->frame_rate_hz - 60.0) < 1e-6);
    QVERIFY(studio_->pick("Frame rate", "As the motion has it: 62.071 Hz"));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("497 at 62.071 Hz"));
    QVERIFY(studio_->export_now());
    back = interchange::load_bvh(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    QVERIFY(std::abs(back->frame_rate_hz - 62.071) < 1e-3);
    // Both choices are kept as they were made, also the next time.
    const ExportModel later(*studio_->studio->context, *studio_->studio->model);
    QVERIFY(later.choices().fps == std::optional(0.0));
    QVERIFY(studio_->pick("Frame rate", "Proposed"));
    const ExportModel again(*studio_->studio->context, *studio_->studio->model);
    QVERIFY(!again.choices().fps);
  }

  void where_the_rate_is_usual_it_is_kept() {
    open(60.0);
    QCOMPARE(rate(), QStringLiteral("Proposed: 60 frames a second, as the motion has them"));
    QCOMPARE(studio_->model().prepared()->report.fps, 60.0);
  }

  void animations_of_other_programs_keep_theirs() {
    open_nothing();
    QVERIFY(studio_->open_animation(chain("chain.bvh")));  // A frame of 0.0333333 s.
    QVERIFY(studio_->settle());
    const double own = model().sources().source()->clip->frame_rate_hz;
    QCOMPARE(model().prepared()->report.fps, own);
    QVERIFY(rate().endsWith(QStringLiteral("as the motion has them")));
  }

  void one_count_of_frames_everywhere() {
    // 8 s at 62.071 Hz hold 496.568 frames, and one stands at 0.
    open(62.071);
    QVERIFY(studio_->pick("Frame rate", "As the motion has it"));
    QVERIFY(studio_->settle());
    QCOMPARE(model().prepared()->report.frames, std::size_t{497});
    QVERIFY(studio_->says("of 497"));
    studio_->studio->context->time().set_playhead(8.0);
    QVERIFY(studio_->says("frame 497 of 497"));
    studio_->studio->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(studio_->says("497 frames at 62.07 Hz"));
  }

  void what_is_chosen_with_a_widget_is_undone_with_a_key() {
    open();
    studio_->studio->window->activateWindow();  // Xvfb has no window manager that would do it.
    QVERIFY(QTest::qWaitForWindowActive(studio_->studio->window.get()));
    auto* rates = studio_->find<QComboBox>("Frame rate");
    const QString before = rates->currentText();
    QVERIFY(studio_->pick("Frame rate", "24 "));
    QCOMPARE(undo().undoText(), QStringLiteral("frame rate of the export"));
    QVERIFY(studio_->pick("Format", "BVH"));
    QCOMPARE(studio_->file()->text().right(4), QStringLiteral(".bvh"));
    rates->setFocus();
    QTest::keyClick(rates, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(studio_->find<QComboBox>("Format")->currentText(), QStringLiteral("FBX"));
    QCOMPARE(studio_->file()->text().right(4), QStringLiteral(".fbx"));
    QTest::keyClick(rates, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(rates->currentText(), before);
    QVERIFY(!undo().canUndo());
    QTest::keyClick(rates, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(rates->currentText().startsWith(QStringLiteral("24 ")));
    // And the next start of the studio finds what it was at last.
    undo().undo();
    const ExportModel later(*studio_->studio->context, *studio_->studio->model);
    QVERIFY(!later.choices().fps);
  }

  void letters_and_turned_numbers_are_one_step_each() {
    open();
    const QString proposed = studio_->file()->text();
    studio_->type_file(studio_->studio->take_folder(QStringLiteral("mine.fbx")));
    QCOMPARE(undo().count(), 1);
    auto* tolerance = studio_->find<QDoubleSpinBox>("Leave out keys within");
    for (const double degrees : {0.1, 0.2, 0.3}) {
      tolerance->setValue(degrees);
    }
    QCOMPARE(undo().count(), 2);
    undo().undo();
    QCOMPARE(tolerance->value(), 0.0);
    undo().undo();
    QCOMPARE(studio_->file()->text(), proposed);
    // A name that is only proposed follows the format, also after that.
    QVERIFY(studio_->pick("Format", "BVH"));
    QCOMPARE(studio_->file()->text().right(4), QStringLiteral(".bvh"));
  }

  void an_animation_that_was_opened_is_closed_by_undo() {
    open();
    const QString file = chain("chain.bvh");
    studio_->type_file(studio_->studio->take_folder(QStringLiteral("mine.fbx")));
    QVERIFY(studio_->pick("Range", "From"));
    QVERIFY(studio_->open_animation(file));
    QVERIFY(model().sources().source()->kind == ExportSource::Kind::kAnimation);
    QVERIFY(model().choices().range == ExportRange::kAll);
    undo().undo();
    QVERIFY(model().sources().source()->kind == ExportSource::Kind::kOpenSolve);
    QCOMPARE(model().sources().offered().size(), std::size_t{1});
    QCOMPARE(studio_->file()->text(), studio_->studio->take_folder(QStringLiteral("mine.fbx")));
    QVERIFY(model().choices().range == ExportRange::kPart);
    undo().redo();
    QVERIFY(model().sources().source()->kind == ExportSource::Kind::kAnimation);
    QVERIFY(studio_->settle());
    QVERIFY(studio_->pick("Motion", "swing"));
    undo().undo();
    QVERIFY(model().sources().source()->kind == ExportSource::Kind::kAnimation);
  }

  void a_take_that_is_renamed_keeps_the_file_one_chose() {
    open();
    studio_->type_file(studio_->studio->take_folder(QStringLiteral("mine.fbx")));
    const std::filesystem::path other = studio_->studio->take_folder(QStringLiteral("other.take")).toStdString();
    studio_->studio->context->document().describe(other, "Anna");
    QCOMPARE(studio_->file()->text(), studio_->studio->take_folder(QStringLiteral("mine.fbx")));
    undo().undo();
    QCOMPARE(studio_->file()->text(), studio_->studio->take_folder(QStringLiteral("other.fbx")));
  }

  void the_window_is_called_after_what_one_looks_at() {
    open_nothing();
    auto* take = studio_->studio->window->findChild<QToolButton*>(QStringLiteral("take_button"));
    QCOMPARE(take->text(), QStringLiteral("No take"));
    const QString file = chain("jump.bvh");
    QVERIFY(studio_->open_animation(file));
    QVERIFY2(title().startsWith(QStringLiteral("jump.bvh – ")), qPrintable(title()));
    QCOMPARE(take->text(), QStringLiteral("jump.bvh"));
    QCOMPARE(take->accessibleName(), QStringLiteral("Animation: jump.bvh"));
    studio_->studio->window->show_workspace(QStringLiteral("capture"));
    QCOMPARE(take->text(), QStringLiteral("jump.bvh"));
    // A take comes first, except where the animation is looked at.
    QVERIFY(studio_->open_take());
    QVERIFY2(title().startsWith(QStringLiteral("swing – ")), qPrintable(title()));
    QVERIFY(studio_->pick("Motion", "jump.bvh"));
    QCOMPARE(take->text(), QStringLiteral("jump.bvh"));
    studio_->studio->window->show_workspace(QStringLiteral("solve"));
    QCOMPARE(take->text(), QStringLiteral("swing"));
    // Closing closes what the window is called after, and comes back with undo.
    studio_->studio->window->show_workspace(QStringLiteral("export"));
    studio_->studio->window->take_actions().close();
    QCOMPARE(take->text(), QStringLiteral("swing"));
    QVERIFY(studio_->studio->context->document().is_open());
    undo().undo();
    QCOMPARE(take->text(), QStringLiteral("jump.bvh"));
    undo().redo();
    studio_->studio->window->take_actions().close();
    QCOMPARE(take->text(), QStringLiteral("No take"));
  }

  void beside_a_problem_there_is_no_picture_of_something_else() {
    open();
    QVERIFY(studio_->says("481 at 60 Hz"));
    QVERIFY(studio_->preview().viewer()->isVisible());
    QVERIFY(studio_->pick("Preset", "VRM"));  // It needs more bones than an arm has.
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("needs bones that the skeleton lacks"));
    QVERIFY(!studio_->preview().viewer()->isVisible());
    QVERIFY(studio_->says("There is no preview of these choices"));
    QVERIFY(!studio_->says("481 at 60 Hz"));
    QVERIFY(model().prepared() == nullptr);
    studio_->save(QStringLiteral("export-no-preview"));
    undo().undo();
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("481 at 60 Hz"));
    QVERIFY(studio_->preview().viewer()->isVisible());
    // At once where the choices themselves say so.
    QVERIFY(studio_->pick("Body", "Your own mesh"));
    QVERIFY(!studio_->preview().viewer()->isVisible());
    QVERIFY(studio_->says("Choose the mesh that is to be skinned"));
    undo().undo();
    // While it is made anew, the old picture says that it is old.
    QVERIFY(studio_->settle());
    QVERIFY(studio_->pick("Frame rate", "24 "));
    QVERIFY(studio_->says("Of earlier choices"));
    QVERIFY(studio_->settle());
    QVERIFY(!studio_->says("Of earlier choices"));
  }

  void what_is_overtaken_while_it_is_made_is_never_shown() {
    open();
    for (const char* rate : {"24 ", "25 ", "30 ", "50 ", "24 "}) {
      QVERIFY(studio_->pick("Frame rate", rate));
      QTest::qWait(130);  // It is being made just now.
    }
    QVERIFY(studio_->pick("Frame rate", "25 "));
    QVERIFY(!model().up_to_date());
    QVERIFY(studio_->settle());
    QCOMPARE(model().prepared()->report.fps, 25.0);
  }

  void a_failure_is_gone_with_the_choices_it_was_of() {
    SolveServices services = solving_->services();
    services.export_file = [](std::span<const motion::Clip* const>, const std::filesystem::path& path,
                              const interchange::ExportOptions&, const Progress&) -> Result<interchange::ExportReport> {
      return Error{"no space left on the device", path.string(), "free some space"};
    };
    studio_ = std::make_unique<ExportStudio>(std::move(services));
    QVERIFY(studio_->open_take());
    QVERIFY(!studio_->export_now());
    QVERIFY(studio_->says("Not exported"));
    QVERIFY(studio_->pick("Frame rate", "24 "));
    QVERIFY(!studio_->says("Not exported"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ExportChoicesTest)
#include "export_choices_test.moc"
