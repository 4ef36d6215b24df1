/// Calibrating from any stretch of a take, with real widgets over a simulated take.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTest>

#include "common/theme.h"
#include "simulate/simulate.h"
#include "solve/take_calibration.h"
#include "ui/calibration/simulated_wearer.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/calibrate_workspace.h"

namespace limbwave::ui::testing {

class StretchTest : public QObject {
  Q_OBJECT
 private:
  struct Bench {
    explicit Bench(const std::filesystem::path& take) : studio(services(), parts()) {
      studio.window->show_workspace(QStringLiteral("calibrate"));
      workspace = dynamic_cast<CalibrateWorkspace*>(studio.window->workspace(QStringLiteral("calibrate")));
      source->set_running(false);
      if (!take.empty()) {
        // A copy of its own: calibrating changes it.
        folder_of_take = folder.filePath(QStringLiteral("arm.take")).toStdString();
        std::filesystem::copy(take, folder_of_take, std::filesystem::copy_options::recursive);
        studio.context->document().open(QString::fromStdString(folder_of_take.string()));
        QTRY_VERIFY(studio.context->document().is_open());
      }
    }
    static StudioServices services() {
      StudioServices made;
      made.open_take = [](const std::filesystem::path& path) { return take::open_take(path); };
      return made;
    }
    StudioParts parts() {
      StudioParts made;
      WorkspaceEntry entry = calibrate_entry();
      entry.create = [this](StudioContext& context, QWidget* parent) -> Workspace* {
        auto fake = std::make_unique<FakeSource>();
        source = fake.get();
        return new CalibrateWorkspace(context, library(), std::move(fake), parent);
      };
      made.workspaces.push_back(entry);
      return made;
    }
    [[nodiscard]] take::CalibrationLibrary library() const {
      return take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString());
    }
    template <typename T>
    T* find(const char* name) {
      const auto all = workspace->findChildren<T*>(QLatin1String(name));
      for (T* candidate : all) {
        if (candidate->isVisible()) {
          return candidate;
        }
      }
      return nullptr;
    }
    void click(const char* name) {
      auto* found = find<QPushButton>(name);
      QVERIFY2(found != nullptr, name);
      QVERIFY2(found->isEnabled(), qPrintable(QLatin1String(name) + QStringLiteral(": ") + found->toolTip()));
      QTest::mouseClick(found, Qt::LeftButton);
    }
    void choose(const char* name, int entry) {
      auto* box = find<QComboBox>(name);
      QVERIFY2(box != nullptr && entry < box->count(), name);
      box->setCurrentIndex(entry);
      Q_EMIT box->activated(entry);
    }
    StretchModel& model() { return workspace->stretch_model(); }
    void open_page() {
      click("from_take");
      QTRY_VERIFY_WITH_TIMEOUT(model().decoded() != nullptr, 60000);
      QTRY_VERIFY(find<QPushButton>("stretch_compute")->isEnabled());
    }
    QTemporaryDir folder;
    std::filesystem::path folder_of_take;
    FakeSource* source = nullptr;
    StudioFixture studio;
    CalibrateWorkspace* workspace = nullptr;
  };

  static void shoot(Bench& bench, const QString& name) {
    QVERIFY(QTest::qWaitForWindowExposed(bench.studio.window.get()));
    QTRY_VERIFY(bench.studio.context->jobs().jobs().empty());
    QTest::qWait(60);
    QVERIFY(bench.studio.window->grab().toImage().save(screenshot_path(QStringLiteral("calibrate-stretch-") + name)));
  }

  QTemporaryDir folder_;
  std::filesystem::path take_;

 private Q_SLOTS:
  void initTestCase() {
    take_ = folder_.filePath(QStringLiteral("arm.take")).toStdString();
    simulate::SimulateSettings settings;
    settings.motion = "box";
    settings.seconds = 6.0;
    settings.errors = simulate::load_errors("paper").value();
    const Status made = simulate::simulate_take(take_, settings, {});
    QVERIFY2(made.ok(), made ? "" : made.error().text().c_str());
    apply_theme(*qApp, ThemeKind::kDark);
  }

  void the_takes_own_stretch_is_offered_first_and_its_verdict_is_kept_and_undone() {
    Bench bench(take_);
    bench.open_page();
    QCOMPARE(bench.model().procedure(), -1);
    auto* named = bench.find<QComboBox>("stretch_named_0");
    QCOMPARE(named->currentText(), QStringLiteral("Sensors are turned"));
    QCOMPARE(named->itemText(2), QStringLiteral("Sensors are turned"));
    shoot(bench, QStringLiteral("range"));
    bench.click("stretch_compute");
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("accept_0") != nullptr, 30000);
    QCOMPARE(bench.find<QLabel>("summary")->text(), QStringLiteral("5 sensors calibrated"));
    QVERIFY2(!bench.find<QPushButton>("repeat_0")->isEnabled(), "nobody is there who could repeat it");
    // The same as the command line finds.
    const auto expected = range_from_take(take::open_take(take_).value(), {}).value();
    const std::optional<calibrate::RigCalibration> before = bench.studio.context->document().take()->info.calibration;
    bench.click("next");
    QTRY_COMPARE_WITH_TIMEOUT(bench.library().list().sensors.size(), std::size_t{5}, 10000);
    QTRY_VERIFY(bench.find<QPushButton>("calibrate_range") != nullptr);
    const auto in_take = [&bench] { return bench.studio.context->document().take()->info.calibration; };
    QCOMPARE(in_take()->sensors[3].method, expected[3].result->calibration.method);
    QVERIFY(in_take()->sensors[3].offset == expected[3].result->calibration.offset);

    QUndoStack& undo = bench.studio.context->undo_stack();
    QCOMPARE(undo.undoText(), QStringLiteral("range calibration"));
    undo.undo();
    bench.studio.context->saves().finish();
    QVERIFY(bench.library().list().sensors.empty());
    QCOMPARE(in_take().has_value(), before.has_value());
    undo.redo();
    bench.studio.context->saves().finish();
    QCOMPARE(bench.library().list().sensors.size(), std::size_t{5});
    const take::Take stored = take::open_take(bench.folder_of_take).value();
    QVERIFY(stored.info.calibration->sensors[3].offset == expected[3].result->calibration.offset);
  }

  void both_poses_are_chosen_by_hand_by_key_and_by_name() {
    Bench bench(take_);
    bench.open_page();
    // The range first: without it directions are degrees off.
    bench.click("stretch_compute");
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("accept_0") != nullptr, 30000);
    bench.click("next");
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("from_take") != nullptr, 10000);
    bench.open_page();
    bench.choose("stretch_procedure", 1);
    QCOMPARE(bench.model().count(), 2);
    const Stretch first = bench.model().stretch(0), second = bench.model().stretch(1);
    QVERIFY(first.seconds() > 2.0 && second.begin_s > first.end_s);
    shoot(bench, QStringLiteral("limb"));
    // Both on the same stretch is refused in words.
    bench.choose("stretch_named_1", 3);
    QVERIFY(!bench.find<QPushButton>("stretch_compute")->isEnabled());
    QVERIFY(bench.find<QLabel>("stretch_obstacle")->text().contains(QStringLiteral("overlap")));
    // Numbers by key.
    const auto type = [&bench](const char* name, double value) {
      auto* box = bench.find<QDoubleSpinBox>(name);
      box->setFocus();
      box->selectAll();
      QTest::keyClicks(box, QLocale().toString(value, 'f', 2));
      QTest::keyClick(box, Qt::Key_Return);
    };
    type("stretch_end_1", second.end_s - 0.2);
    type("stretch_begin_1", second.begin_s + 0.2);
    QVERIFY(std::abs(bench.model().stretch(1).begin_s - second.begin_s - 0.2) < 0.006);
    QVERIFY(std::abs(bench.model().stretch(1).end_s - second.end_s + 0.2) < 0.006);
    // An end by hand.
    StretchPlot* plot = bench.workspace->stretch_page()->plot();
    plot->set_visible({first.begin_s - 3.0, second.end_s + 3.0});
    const QPoint handle(qRound(plot->x_of(first.begin_s)), plot->height() / 2);
    const QPoint to(qRound(plot->x_of(first.begin_s + 0.5)), plot->height() / 2);
    QTest::mousePress(plot, Qt::LeftButton, {}, handle);
    QTest::mouseMove(plot, to);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
    QVERIFY(std::abs(bench.model().stretch(0).begin_s - first.begin_s - 0.5) < 0.1);
    QCOMPARE(bench.find<QComboBox>("stretch_named_0")->currentText(), QStringLiteral("Own choice"));
    bench.click("stretch_compute");
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QPushButton>("accept_1") != nullptr, 30000);
    bench.click("next");
    QTRY_COMPARE_WITH_TIMEOUT(bench.library().list().mounts.size(), std::size_t{1}, 10000);
    QCOMPARE(bench.library().list().mounts.front().mounts.size(), std::size_t{4});
  }

  void movements_and_stretches_can_be_undone_a_drag_as_one_step() {
    Bench bench(take_);
    bench.open_page();
    QUndoStack& undo = bench.studio.context->undo_stack();
    const int start = undo.index();
    const StretchChoice range = bench.model().choice();
    bench.choose("stretch_procedure", 1);
    QCOMPARE(undo.index(), start + 1);
    const StretchChoice limb = bench.model().choice();
    StretchPlot* plot = bench.workspace->stretch_page()->plot();
    plot->set_visible({limb.stretches[0].begin_s - 3.0, limb.stretches[1].end_s + 3.0});
    const auto drag = [&](double from_s, const std::vector<double>& to_s) {
      const auto at = [&](double time_s) { return QPoint(qRound(plot->x_of(time_s)), plot->height() / 2); };
      QTest::mousePress(plot, Qt::LeftButton, {}, at(from_s));
      for (const double time_s : to_s) {
        QTest::mouseMove(plot, at(time_s));
      }
      QTest::mouseRelease(plot, Qt::LeftButton, {}, at(to_s.back()));
    };
    const double begin_s = limb.stretches[0].begin_s;
    drag(begin_s, {begin_s + 0.2, begin_s + 0.4, begin_s + 0.6});
    QCOMPARE(undo.index(), start + 2);
    const StretchChoice dragged = bench.model().choice();
    QVERIFY(std::abs(dragged.stretches[0].begin_s - begin_s - 0.6) < 0.1);
    drag(dragged.stretches[0].begin_s, {begin_s + 0.4, begin_s + 0.3});
    QCOMPARE(undo.index(), start + 3);  // Another drag is another step.
    bench.choose("stretch_named_1", 1);
    QCOMPARE(undo.index(), start + 4);
    QVERIFY(!bench.find<QPushButton>("stretch_compute")->isEnabled());

    undo.undo();
    QVERIFY(bench.find<QPushButton>("stretch_compute")->isEnabled());
    undo.undo();
    QVERIFY(bench.model().choice() == dragged);
    undo.undo();
    QVERIFY(bench.model().choice() == limb);
    QVERIFY(std::abs(bench.find<QDoubleSpinBox>("stretch_begin_0")->value() - begin_s) < 0.006);
    undo.undo();
    QVERIFY(bench.model().choice() == range);
    QCOMPARE(bench.find<QComboBox>("stretch_procedure")->currentIndex(), 0);
    undo.redo();
    undo.redo();
    QVERIFY(bench.model().choice() == dragged);
  }

  void a_stretch_in_which_nobody_turns_ends_in_repeat_and_leads_back() {
    Bench bench(take_);
    bench.open_page();
    auto* named = bench.find<QComboBox>("stretch_named_0");
    bench.choose("stretch_named_0", named->findText(QStringLiteral("Capture")));
    bench.click("stretch_compute");
    QTRY_VERIFY_WITH_TIMEOUT(bench.find<QLabel>("summary") != nullptr, 30000);
    QCOMPARE(bench.find<QLabel>("summary")->text(), QStringLiteral("Repeat"));
    QVERIFY(!bench.find<QPushButton>("next")->isEnabled());
    shoot(bench, QStringLiteral("repeat"));
    bench.click("cancel");
    QVERIFY2(bench.find<QPushButton>("stretch_compute") != nullptr, "another stretch can be tried");
    bench.click("stretch_cancel");
    QVERIFY(bench.find<QPushButton>("from_take") != nullptr);
    QVERIFY(bench.library().list().sensors.empty());
  }

  void without_a_take_it_says_what_to_do() {
    Bench bench({});
    bench.click("empty_from_take");
    QVERIFY(!bench.find<QPushButton>("stretch_compute")->isEnabled());
    QVERIFY(bench.find<QLabel>("stretch_obstacle")->text().contains(QStringLiteral("Open a take")));
    apply_theme(*qApp, ThemeKind::kLight);
    shoot(bench, QStringLiteral("none-light"));
    apply_theme(*qApp, ThemeKind::kDark);
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::StretchTest)
#include "stretch_test.moc"
