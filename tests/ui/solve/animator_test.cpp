/// An animator's half hour, by keyboard, in the real studio: a simulated take with a long name, played, scrubbed,
/// looped, a rotation keyed and undone, a bone lengthened, other smoothing, a BVH in the end. Every step leaves a
/// picture.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTest>
#include <QTranslator>

#include "common/core_services.h"
#include "interchange/animation_file.h"
#include "simulate/simulate.h"
#include "solve/report_text.h"
#include "ui/support/solve_fixture.h"
#include "viewer/viewer_widget.h"
#include "workspaces/export/export_workspace.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui::testing {

class AnimatorTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<SolveStudio> studio_;
  QString style_;

  [[nodiscard]] QWidget* focus() const {
    QWidget* with_focus = QApplication::focusWidget();
    return with_focus != nullptr ? with_focus : studio_->window.get();
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    QTest::keyClick(focus(), key, modifiers);
    QTest::qWait(30);
  }
  // Tab until a widget has the focus; people who use no mouse have nothing else.
  template <typename T>
  T* tab_to(const std::function<bool(const T&)>& wanted) const {
    for (int i = 0; i < 120; ++i) {
      if (auto* here = qobject_cast<T*>(QApplication::focusWidget()); here != nullptr && wanted(*here)) {
        return here;
      }
      press(Qt::Key_Tab);
    }
    return nullptr;
  }
  void picture(const QString& step) const {
    const int percent = qRound(qApp->devicePixelRatio() * 100.0);
    QString name = QStringLiteral("animator-%1-%2").arg(style_, step);
    if (percent != 100) {
      name += QStringLiteral("-%1").arg(percent);
    }
    const QImage image = studio_->screen();
    QVERIFY(image.width() > 500);
    QVERIFY(image.save(screenshot_path(name)));
  }

 private Q_SLOTS:
  void half_an_hour_data() {
    QTest::addColumn<bool>("german");
    QTest::addColumn<bool>("light");
    QTest::newRow("english-dark") << false << false;
    QTest::newRow("german-light") << true << true;
  }

  void half_an_hour() {
    QFETCH(const bool, german);
    QFETCH(const bool, light);
    style_ = QString::fromLatin1(QTest::currentDataTag());
    apply_theme(*qApp, light ? ThemeKind::kLight : ThemeKind::kDark);
    QTranslator translator;
    if (german) {
      QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
      QVERIFY(translator.load(QStringLiteral(LIMBWAVE_BINARY_DIR "/app/studio/limbwave_de.qm")));
      QApplication::installTranslator(&translator);
    }
    studio_ = std::make_unique<SolveStudio>(core_solve_services(), core_services());
    studio_->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
    picture(QStringLiteral("0-welcome"));

    const std::filesystem::path folder =
        studio_->take_folder(QStringLiteral("The third attempt at the long reach, with the left hand and a glass.take"))
            .toStdString();
    simulate::SimulateSettings settings;
    settings.motion = "reach";
    settings.errors_name = "paper";
    settings.errors = simulate::load_errors("paper").value();
    QVERIFY(simulate::simulate_take(folder, settings, {}).ok());
    studio_->context->document().set(studio_->context->services().open_take(folder).value());
    QTRY_COMPARE(studio_->window->current_workspace(), QStringLiteral("solve"));
    SolveModel& model = *studio_->model;
    QTRY_COMPARE_WITH_TIMEOUT(model.state(), SolveState::kSolved, 120000);
    picture(QStringLiteral("1-solved"));

    TimeModel& time = studio_->context->time();
    press(Qt::Key_Space);
    QVERIFY(time.playing());
    QTRY_VERIFY(time.playhead_s() > 0.2);
    press(Qt::Key_Space);
    QVERIFY(!time.playing());
    press(Qt::Key_End);
    QCOMPARE(time.playhead_s(), time.duration_s());
    press(Qt::Key_Home);
    press(Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(qAbs(time.playhead_s() - 10 * time.frame_s()) < 1e-9);
    QVERIFY(time.looping());
    press(Qt::Key_End);
    press(Qt::Key_Left);
    press(Qt::Key_Space);
    QTRY_VERIFY(time.playhead_s() < 0.5 * time.duration_s());  // round again
    press(Qt::Key_Space);
    QVERIFY(!time.playing());

    // Key a rotation about the vertical of the upper arm.
    const int upper = model.skeleton().find("upper_arm");
    studio_->context->selection().select(SelectionKind::kSegment, upper);
    time.set_playhead(1.0);
    press(Qt::Key_I);
    QCOMPARE(model.keys().keys(upper).size(), std::size_t{1});
    for (int i = 0; i < 20; ++i) {
      press(Qt::Key_Up, Qt::AltModifier);
    }
    QVERIFY(qAbs(model.keys().keys(upper).front().value - 20.0 * M_PI / 180.0) < 1e-6);
    std::vector<body::SegmentPose> turned;
    model.pose_at(1.0, turned);
    picture(QStringLiteral("2-keyed"));
    for (int i = 0; i < 21 && !model.keys().keys(upper).empty(); ++i) {
      press(Qt::Key_Z, Qt::ControlModifier);
    }
    QVERIFY(model.keys().keys(upper).empty());  // every nudge, then the key itself
    press(Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(model.keys().keys(upper).size(), std::size_t{1});

    // A longer bone, typed.
    auto* length = tab_to<QDoubleSpinBox>([&](const QDoubleSpinBox& box) {
      return qAbs(box.value() - 1000.0 * model.skeleton().segments[static_cast<std::size_t>(upper)].length) < 1e-6 ||
             qAbs(box.value() - 100.0 * model.skeleton().segments[static_cast<std::size_t>(upper)].length) < 1e-6;
    });
    QVERIFY2(length != nullptr, "the bone's length cannot be reached by keyboard");
    const double before = model.skeleton().segments[static_cast<std::size_t>(upper)].length;
    press(Qt::Key_PageUp);
    press(Qt::Key_Up);
    QVERIFY(model.skeleton().segments[static_cast<std::size_t>(upper)].length > before);
    // Other smoothing: solves again.
    auto* smoothing = tab_to<QComboBox>(
        [](const QComboBox& box) { return box.count() == static_cast<int>(solve::kSmoothings.size()); });
    QVERIFY2(smoothing != nullptr, "smoothing cannot be reached by keyboard");
    const int chosen = smoothing->currentIndex();
    press(chosen == 0 ? Qt::Key_Down : Qt::Key_Up);
    QVERIFY(smoothing->currentIndex() != chosen);
    QTRY_VERIFY_WITH_TIMEOUT(model.state() == SolveState::kSolving, 5000);
    QTRY_COMPARE_WITH_TIMEOUT(model.state(), SolveState::kSolved, 120000);
    picture(QStringLiteral("3-longer"));

    // Export.
    studio_->window->show_workspace(QStringLiteral("export"));
    auto* workspace = qobject_cast<ExportWorkspace*>(studio_->window->workspace(QStringLiteral("export")));
    QVERIFY(workspace != nullptr);
    QTest::qWait(300);
    time.set_playhead(1.0);
    press(Qt::Key_E, Qt::ControlModifier);
    const std::filesystem::path file = folder.parent_path() / (folder.stem().string() + ".fbx");
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(file), 60000);
    QTest::qWait(500);
    picture(QStringLiteral("4-exported"));
    const auto clips = interchange::load_animation(file);
    QVERIFY(clips.ok());
    const body::Skeleton& skeleton = clips->front().skeleton;
    const double exported = skeleton.segments[static_cast<std::size_t>(skeleton.find("forearm"))].p_PL.norm();
    QVERIFY(qAbs(exported - model.skeleton().segments[static_cast<std::size_t>(upper)].length) < 1e-4);

    studio_.reset();
    if (german) {
      QApplication::removeTranslator(&translator);
      QLocale::setDefault(QLocale::c());
    }
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::AnimatorTest)
#include "animator_test.moc"
