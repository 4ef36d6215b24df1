/// The inspector's choices of how the body filter solves: shown where it solves, undone, and what is asked of it.
#include <QCheckBox>
#include <QComboBox>
#include <QTest>

#include "ui/support/solve_fixture.h"

namespace limbwave::ui::testing {

class BodyChoiceTest : public QObject {
  Q_OBJECT
 private:
  FakeSolving solving_;
  std::mutex mutex_;
  std::vector<std::optional<solve::BodyChoice>> asked_;
  std::unique_ptr<SolveStudio> studio_;

  void open(const char* kind) {
    SolveServices services = solving_.services();
    services.solve = [this, inner = services.solve](const take::Take& take, const solve::SolveSettings& settings,
                                                    const Progress& progress) {
      {
        const std::lock_guard lock(mutex_);
        asked_.push_back(settings.body);
      }
      return inner(take, settings, progress);
    };
    studio_ = std::make_unique<SolveStudio>(std::move(services));
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
    studio_->window->show_workspace(QStringLiteral("solve"));
    QDir().mkpath(studio_->take_folder(QStringLiteral("walk.take")));
    take::Take take = made_up_take(studio_->take_folder(QStringLiteral("walk.take")), 8.0);
    take.info.kind = kind;
    studio_->context->document().set(take);
    QTRY_COMPARE(studio_->model->state(), SolveState::kSolved);
  }
  [[nodiscard]] std::optional<solve::BodyChoice> newest() {
    const std::lock_guard lock(mutex_);
    return asked_.empty() ? std::nullopt : asked_.back();
  }
  template <typename T>
  T* find(const char* name) {
    return studio_->window->findChild<T*>(QLatin1String(name));
  }
  void choose(const char* name, const char* data) {
    auto* box = find<QComboBox>(name);
    QVERIFY(box != nullptr && box->isVisible());
    const int entry = box->findData(QLatin1String(data));
    QVERIFY2(entry >= 0, data);
    box->setCurrentIndex(entry);
    Q_EMIT box->activated(entry);
  }

 private Q_SLOTS:
  void initTestCase() { apply_theme(*qApp, ThemeKind::kDark); }
  void cleanup() {
    studio_.reset();
    asked_.clear();
    solving_.stored.reset();
  }

  void a_sound_cards_take_has_none() {
    open("line-in");
    QVERIFY(find<QComboBox>("body_method") != nullptr && !find<QComboBox>("body_method")->isVisible());
    QVERIFY(!newest().has_value());
  }

  void choices_solve_again_and_can_be_undone() {
    open("driver-box");
    QCOMPARE(find<QComboBox>("body_method")->currentData().toString(), QStringLiteral("smoother"));
    QCOMPARE(find<QComboBox>("body_sensors")->currentData().toString(), QStringLiteral("AGD"));
    const QString usual = QString::fromStdString(studio_->model->body_choice().root);
    QVERIFY(!usual.isEmpty());
    QCOMPARE(find<QComboBox>("body_root")->currentData().toString(), usual);
    QCOMPARE(find<QComboBox>("body_root")->findData(QStringLiteral("truth")), -1);  // It has none.
    QUndoStack& undo = studio_->context->undo_stack();
    const int start = undo.index();
    choose("body_method", "filter");
    choose("body_sensors", "AG");
    choose("body_root", "fixed");
    QTest::mouseClick(find<QCheckBox>("body_tune"), Qt::LeftButton, {},
                      QPoint(8, find<QCheckBox>("body_tune")->height() / 2));
    QCOMPARE(undo.index(), start + 4);
    const solve::BodyChoice all{"filter", "AG", "fixed", true};
    QTRY_VERIFY(newest() == all);
    QTRY_COMPARE(studio_->model->state(), SolveState::kSolved);
    QVERIFY(studio_->window->grab().save(screenshot_path(QStringLiteral("solve-body-choice"))));
    undo.undo();
    undo.undo();
    QCOMPARE(find<QComboBox>("body_root")->currentData().toString(), usual);
    QVERIFY(!find<QCheckBox>("body_tune")->isChecked());
    QTRY_VERIFY(newest() && newest()->sensors == "AG" && !newest()->tune);
    choose("body_method", "filter");  // What it is already is no step.
    QCOMPARE(undo.index(), start + 2);
    undo.undo();
    undo.undo();
    QCOMPARE(find<QComboBox>("body_method")->currentData().toString(), QStringLiteral("smoother"));
  }

  void what_a_stored_solve_was_made_with_is_shown() {
    take::Take take = made_up_take(QStringLiteral("/tmp/none.take"), 8.0);
    solve::SolveSettings settings;
    settings.body = solve::BodyChoice{"batch", "GD", "path.csv", false};
    solving_.stored = made_up_solve(take, settings, 8.0);
    open("log");
    QCOMPARE(find<QComboBox>("body_method")->currentData().toString(), QStringLiteral("batch"));
    QCOMPARE(find<QComboBox>("body_root")->currentText(), QStringLiteral("path.csv"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::BodyChoiceTest)
#include "body_choice_test.moc"
