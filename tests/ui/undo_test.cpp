/// The list of everything that can be edited in the studio. Each edit is one step of undo, comes back with redo, and
/// leaves all others alone.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "calibration/calibration_desk.h"
#include "take/board_book.h"
#include "take/sensor_places.h"
#include "ui/support/fake_services.h"
#include "ui/support/solve_fixture.h"
#include "workspaces/calibrate_workspace.h"
#include "workspaces/capture/capture_model.h"
#include "workspaces/capture/device_format.h"
#include "workspaces/export/export_workspace.h"

namespace limbwave::ui::testing {

class UndoTest : public QObject {
  Q_OBJECT
 private:
  static constexpr auto kCard = "portaudio:ALSA:card";
  struct Edit {
    const char* name;
    std::function<void()> make;
  };
  FakeSolving solving_;
  QTemporaryDir home_;
  std::unique_ptr<SolveStudio> studio_;

  [[nodiscard]] StudioContext& context() const { return *studio_->context; }
  [[nodiscard]] CaptureModel& capture() const { return CaptureModel::of(context()); }
  [[nodiscard]] SolveModel& solve() const { return *studio_->model; }
  [[nodiscard]] ExportModel& exporting() const {
    return qobject_cast<ExportWorkspace*>(studio_->window->workspace(QStringLiteral("export")))->model();
  }
  [[nodiscard]] CalibrateWorkspace* calibrate() const {
    return qobject_cast<CalibrateWorkspace*>(studio_->window->workspace(QStringLiteral("calibrate")));
  }
  [[nodiscard]] CalibrationDesk& desk() const { return calibrate()->desk(); }
  [[nodiscard]] StretchModel& stretches() const { return calibrate()->stretch_model(); }
  [[nodiscard]] const acquire::DeviceInfo& card() const {
    return *std::find_if(capture().devices().begin(), capture().devices().end(),
                         [](const acquire::DeviceInfo& one) { return one.id == kCard; });
  }

  // All that edits change, in words.
  [[nodiscard]] QString everything() const {
    context().saves().finish();
    QStringList all;
    const CaptureSetup& setup = capture().setup();
    all << QStringLiteral("capture") << setup.rig << setup.subject << setup.take_name << setup.folder
        << context().wearer() << QString::number(remembered_setup(context().settings(), card()).rate_hz);
    const take::Board board = take::BoardBook().board(kCard, "line-in-arm").value();
    all << QString::fromStdString(board.name);
    const take::Take& take = *context().document().take();
    all << QStringLiteral("take") << context().document().name() << QString::fromStdString(take.info.subject);
    for (const body::Accelerometer& sensor : take.info.rig.accelerometers) {
      all << QString::fromStdString(sensor.name + ":" + sensor.serial);
    }
    const auto& calibration = take.info.calibration;
    all << (calibration ? QString::number(calibration->sensors[0].M(0, 0)) : QStringLiteral("none"));
    for (const Marker& marker : context().markers().markers()) {
      all << QStringLiteral("%1 %2").arg(marker.sample).arg(marker.text);
    }
    all << QStringLiteral("solve") << QString::number(static_cast<int>(solve().settings().smoothing))
        << QString::number(solve().settings().smoothing_s) << QString::fromStdString(solve().settings().calibration);
    for (const body::Segment& segment : solve().skeleton().segments) {
      all << QString::number(segment.length);
    }
    for (const LaneKey& key : solve().keys().keys(2)) {
      all << QStringLiteral("%1=%2").arg(key.time_s).arg(key.value);
    }
    all << QStringLiteral("calibrate from") << QString::number(stretches().procedure());
    for (const Stretch& stretch : stretches().choice().stretches) {
      all << QStringLiteral("%1 %2").arg(stretch.begin_s).arg(stretch.end_s);
    }
    const ExportChoices& choices = exporting().choices();
    const auto number = [](const auto& value) {
      return value ? QString::number(static_cast<double>(*value)) : QString();
    };
    all << QStringLiteral("export") << QString::fromStdString(choices.preset) << choices.format << number(choices.fps)
        << QString::number(static_cast<int>(choices.range)) << QString::number(choices.begin_s)
        << QString::number(choices.end_s) << number(choices.root_motion) << number(choices.rest)
        << number(choices.rest_frame) << QString::fromStdString(choices.bone_map.value_or("-")) << number(choices.unit)
        << QString::number(choices.key_tolerance_deg) << QString::number(static_cast<int>(choices.body))
        << QString::fromStdString(choices.mesh.string()) << exporting().file();
    const ExportSourceState sources = exporting().sources().state();
    all << QString::fromStdString(sources.chosen) << QString::number(sources.animations.size())
        << QString::number(sources.others.size());
    return all.join(QLatin1Char('|'));
  }
  [[nodiscard]] bool calm() const { return context().jobs().jobs().empty() && context().saves().idle(); }

  template <typename T>
  std::function<void()> choose(T ExportChoices::*field, T value) {
    return [this, field, value] {
      ExportChoices choices = exporting().choices();
      choices.*field = value;
      exporting().change(choices);
    };
  }
  std::function<void()> set_up(void (CaptureModel::*setter)(const QString&), const char* value) {
    return [this, setter, value] { (capture().*setter)(QString::fromUtf8(value)); };
  }

  std::vector<Edit> edits_of_capture() {
    return {{"rig", set_up(&CaptureModel::set_rig, "other")},
            {"who wears the sensors", set_up(&CaptureModel::set_subject, "Anna")},
            {"name of the next take", set_up(&CaptureModel::set_take_name, "walk")},
            {"folder for takes",
             [this] { capture().set_takes_folder(studio_->folder.filePath(QStringLiteral("elsewhere"))); }},
            {"format of the sound card",
             [this] {
               DeviceSetup setup;
               setup.rate_hz = 96000.0;
               capture().set_device_setup(setup);
             }},
            {"sensor board",
             [this] {
               take::Board after;
               after.name = "Lab 2";
               capture().set_board(QString::fromLatin1(kCard), "line-in-arm", {}, after);
             }},
            {"who wears the sensors, in Calibrate", [this] { desk().set_wearer(QStringLiteral("Ben")); }}};
  }
  std::vector<Edit> edits_of_take() {
    const auto change = [this](const QString& name, const QString& subject, const std::vector<std::string>& places = {},
                               const std::vector<std::string>& serials = {}) {
      QVERIFY(context().take_edits().change(name, subject, places, serials));
    };
    const auto marker = [this] { return context().markers().newest(); };
    return {{"who wore it", [=, this] { change(context().document().name(), QStringLiteral("Clara")); }},
            {"which sensor hung where",
             [=, this] {
               change(context().document().name(), QStringLiteral("Clara"),
                      {"torso", "upper arm", "hand", "forearm", "fingers"}, {"A", "B", "C", "D", "E"});
             }},
            {"name of the take", [=] { change(QStringLiteral("other name"), QStringLiteral("Clara")); }},
            {"marker set", [this] { QVERIFY(context().markers().add(3.0, QStringLiteral("jump"))); }},
            {"marker moved", [=, this] { QVERIFY(context().markers().move(marker(), 4.0)); }},
            {"marker renamed", [=, this] { QVERIFY(context().markers().rename(marker(), QStringLiteral("land"))); }},
            {"marker deleted", [=, this] { QVERIFY(context().markers().remove(marker())); }},
            {"choice of calibration", [this] {
               calibrate::RigCalibration other = calibrate::nominal_calibration(desk().rig());
               other.sensors[0].M *= 1.25;
               desk().apply(other);
             }}};
  }
  std::vector<Edit> edits_of_stretches() {
    return {{"stretch to calibrate from",
             [this] {
               stretches().set_stretch(0, {1.0, 3.0});
             }},
            {"movement to calibrate from", [this] { stretches().set_procedure(0); }},
            {"a pose's stretch", [this] {
               stretches().set_stretch(1, {5.0, 7.5});
             }}};
  }
  std::vector<Edit> edits_of_solve() {
    const auto key = [this] { return KeyPlace{2, solve().keys().keys(2).front().id}; };
    const auto set = [this](auto&& change) {
      solve::SolveSettings settings = solve().settings();
      change(settings);
      solve().change_settings(settings, QStringLiteral("settings"));
    };
    return {{"key set", [this] { QVERIFY(solve().key_editor().set_value(2, 2.0, 0.5)); }},
            {"key changed", [=, this] { QVERIFY(solve().key_editor().change_value(key(), 0.7)); }},
            {"key turned", [=, this] { QVERIFY(solve().key_editor().turn({key()}, 0.1)); }},
            {"key moved", [=, this] { QVERIFY(solve().key_editor().move({key()}, 0.5)); }},
            {"key deleted", [=, this] { QVERIFY(solve().key_editor().remove({key()})); }},
            {"length of a bone", [this] { QVERIFY(solve().change_length(1, 0.4)); }},
            {"smoothing", [=] { set([](auto& settings) { settings.smoothing = solve::Smoothing::kNone; }); }},
            {"strength of smoothing", [=] { set([](auto& settings) { settings.smoothing_s = 0.2; }); }},
            {"calibration to solve with", [=] { set([](auto& settings) { settings.calibration = "nominal"; }); }}};
  }
  std::vector<Edit> edits_of_export() {
    const auto part = [this](double begin_s, double end_s) {
      ExportChoices choices = exporting().choices();
      choices.range = ExportRange::kPart;
      choices.begin_s = begin_s;
      choices.end_s = end_s;
      exporting().change(choices);
    };
    return {{"program", [this] { exporting().choose_preset("unreal"); }},
            {"format", choose(&ExportChoices::format, QStringLiteral("glb"))},
            {"frame rate", choose(&ExportChoices::fps, std::optional(30.0))},
            {"range", [=] { part(1.0, 3.0); }},
            {"way over the floor", choose(&ExportChoices::root_motion, std::optional(motion::RootMotion::kInPlace))},
            {"rest pose", choose(&ExportChoices::rest, std::optional(interchange::RestPose::kTPose))},
            {"rest pose on frame 0", choose(&ExportChoices::rest_frame, std::optional(true))},
            {"bone names", choose(&ExportChoices::bone_map, std::optional(std::string("humanik")))},
            {"unit", choose(&ExportChoices::unit, std::optional(interchange::FileUnit::kMetres))},
            {"keys left out", choose(&ExportChoices::key_tolerance_deg, 0.5)},
            {"body", choose(&ExportChoices::body, ExportBody::kOwnMesh)},
            {"mesh", choose(&ExportChoices::mesh, std::filesystem::path("/some/body.obj"))},
            {"file", [this] { exporting().set_file(studio_->folder.filePath(QStringLiteral("mine.glb"))); }},
            {"another actor", [this] { exporting().sources().add_take(QStringLiteral("/some/other.take")); }},
            {"without that actor", [this] { exporting().sources().remove_other(0); }}};
  }

  void check(const std::vector<Edit>& edits) {
    QUndoStack& stack = context().undo_stack();
    for (const Edit& edit : edits) {
      QTRY_VERIFY(calm());
      const QString before = everything();
      const int index = stack.index();
      edit.make();
      QTRY_VERIFY2(everything() != before, edit.name);
      QTRY_VERIFY(calm());
      const QString after = everything();
      QVERIFY2(stack.index() == index + 1, edit.name);
      QVERIFY2(!stack.undoText().isEmpty(), edit.name);
      stack.undo();
      QTRY_VERIFY2(everything() == before, qPrintable(QString::fromLatin1(edit.name) + QLatin1Char('\n') + before +
                                                      QLatin1Char('\n') + everything()));
      stack.redo();
      QTRY_VERIFY2(everything() == after, qPrintable(QString::fromLatin1(edit.name) + QLatin1Char('\n') + after +
                                                     QLatin1Char('\n') + everything()));
    }
  }

 private Q_SLOTS:
  void every_edit_can_be_undone_and_redone() {
    qputenv("LIMBWAVE_HOME", home_.path().toLocal8Bit());
    studio_ = std::make_unique<SolveStudio>(solving_.services(), fake_services(std::make_shared<FakeLine>()));
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
    for (const char* id : {"capture", "calibrate", "solve", "export"}) {
      studio_->window->show_workspace(QString::fromLatin1(id));
    }
    QTRY_VERIFY(!capture().devices().empty());
    QDir().mkpath(studio_->take_folder(QStringLiteral("swing.take")));
    context().document().set(made_up_take(studio_->take_folder(QStringLiteral("swing.take")), 8.0));
    QTRY_COMPARE(solve().state(), SolveState::kSolved);
    QTRY_VERIFY(calm());

    stretches().begin();
    QTRY_VERIFY(calm());
    const QString start = everything();
    capture().open_device(QString::fromLatin1(kCard));
    QTRY_VERIFY(context().live().running());
    check(edits_of_capture());
    capture().open_device({});
    QTRY_VERIFY(!context().live().running());
    check(edits_of_take());
    check(edits_of_stretches());
    check(edits_of_solve());
    check(edits_of_export());

    // All the way back and on again.
    QTRY_VERIFY(calm());
    const QString end = everything();
    QUndoStack& stack = context().undo_stack();
    while (stack.canUndo()) {
      stack.undo();
      QTRY_VERIFY(calm());
    }
    QTRY_COMPARE(everything(), start);
    while (stack.canRedo()) {
      stack.redo();
      QTRY_VERIFY(calm());
    }
    QTRY_COMPARE(everything(), end);
    qunsetenv("LIMBWAVE_HOME");
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::UndoTest)
#include "undo_test.moc"
