/// Where calibrations come from besides a test's own readings: the studio's live capture with its recording, and the
/// segments of a simulated take.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "base/files.h"
#include "calibration/calibration_desk.h"
#include "calibration/take_segments.h"
#include "simulate/simulate.h"
#include "take/take.h"
#include "ui/calibration/simulated_wearer.h"

namespace limbwave::ui::testing {

/// A session whose snapshots the test writes; its recordings are folders with a take.json.
class ScriptedBackend : public LiveBackend {
 public:
  explicit ScriptedBackend(solve::LiveSettings settings) : settings_(std::move(settings)) {}
  Status start() override { return {}; }
  void stop() override {}
  Status start_recording(const std::filesystem::path& folder, const std::string& subject) override {
    std::filesystem::create_directories(folder);
    take_.folder = folder;
    take_.info.subject = subject;
    take_.info.rig = settings_.rig;
    take_.info.skeleton = settings_.skeleton;
    take_.info.format.rate = SampleRate{48000.0};
    return {};
  }
  Result<take::Take> stop_recording() override {
    take_.info.complete = true;
    take_.info.frames = 48000 * 60;
    return take_;
  }
  std::optional<take::TakeEvent> mark(const std::string&) override { return std::nullopt; }
  bool write_event(const take::TakeEvent&) override { return true; }
  void set_calibration(const calibrate::RigCalibration& calibration) override { settings_.calibration = calibration; }
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>&) override {}
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override {
    return std::make_shared<solve::LiveSnapshot>(now);
  }
  solve::LiveSnapshot now;

 private:
  solve::LiveSettings settings_;
  take::Take take_;
};

class CalibrationSourcesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void live_readings_come_once_and_the_recording_gets_its_segments() {
    QTemporaryDir folder;
    ScriptedBackend* backend = nullptr;
    StudioServices services;
    services.open_device = [](const std::string&, const DeviceSetup&, const std::string&) {
      return Result<std::unique_ptr<acquire::LiveSource>>(nullptr);
    };
    services.load_rig = [](const std::string&, const std::string&, const std::string&) -> Result<solve::LiveSettings> {
      const FakeSource model;
      solve::LiveSettings settings;
      settings.rig = model.rig();
      settings.skeleton = model.skeleton();
      settings.calibration = model.calibration();
      return settings;
    };
    services.make_live = [&backend](std::unique_ptr<acquire::LiveSource>, solve::LiveSettings settings) {
      auto made = std::make_unique<ScriptedBackend>(std::move(settings));
      backend = made.get();
      return std::unique_ptr<LiveBackend>(std::move(made));
    };
    StudioContext context(services, folder.filePath(QStringLiteral("settings")));
    LiveCalibrationSource source(context.live());
    CalibrationDesk desk(context, source,
                         take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString()));
    QVERIFY(desk.subject() == CalibrationDesk::Subject::kNone);
    std::vector<double> times;
    connect(&source, &CalibrationSource::arrived, &source, [&times](const auto& frames) {
      for (const auto& frame : frames) {
        times.push_back(frame.time_s);
      }
    });
    QVERIFY(context.live().open(QStringLiteral("test"), QStringLiteral("Test"), "line-in-arm", {}));
    QTRY_VERIFY(source.running());
    QVERIFY(desk.subject() == CalibrationDesk::Subject::kLive);
    // Ten overlapping snapshots, of 90 readings each, 30 further every time.
    for (int step = 0; step < 10; ++step) {
      backend->now.frames.clear();
      for (int i = 0; i < 90; ++i) {
        decode::AccelerationFrame frame;
        frame.time_s = (30 * step + i) / 60.0;
        backend->now.frames.push_back(frame);
      }
      backend->now.stream_time_s = backend->now.frames.back().time_s;
      ++backend->now.version;
      QTRY_VERIFY(!times.empty() && times.back() == backend->now.stream_time_s);
    }
    QCOMPARE(times.size(), std::size_t{360});
    QVERIFY(std::is_sorted(times.begin(), times.end()));

    desk.begin_recording(QStringLiteral("range"));
    const std::filesystem::path recorded = desk.recording_folder();
    QTRY_VERIFY(context.live().recording());
    // The recording runs for 4 s, the turning was from 2 s to 3 s of it.
    backend->now.recording = true;
    backend->now.recorded_s = 4.0;
    backend->now.stream_time_s = 100.0;
    ++backend->now.version;
    QTRY_COMPARE(source.recording_start_s(), 96.0);
    desk.add_segment(solve::kRangeSegment, 98.0, 99.0);
    desk.end_recording();
    QTRY_VERIFY(!context.live().finishing() && context.jobs().jobs().empty());
    const Result<take::Take> stored = take::open_take(recorded);
    if (stored) {
      QCOMPARE(stored->info.segments.size(), std::size_t{1});
    }
    const Result<std::string> json = read_file(recorded / "take.json");
    QVERIFY(json.ok());
    QVERIFY(json->find("\"range\"") != std::string::npos);
    QVERIFY(json->find("96000") != std::string::npos);
    // It is not a take that the user made.
    QVERIFY(!context.document().is_open());
    // A recording that is cancelled before it has begun ends all the same.
    desk.begin_recording(QStringLiteral("range"));
    desk.end_recording();
    QTRY_VERIFY(!context.live().starting() && !context.live().recording() && !context.live().finishing());
    std::filesystem::remove_all(recorded);
    std::filesystem::remove_all(desk.recording_folder());
  }

  void a_simulated_take_gives_both_calibrations_and_undo_takes_them_back() {
    QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QStringLiteral("arm.take")).toStdString();
    simulate::SimulateSettings settings;
    settings.motion = simulate::builtin_motions().front();
    settings.seconds = 2.0;
    const Status made = simulate::simulate_take(path, settings, {});
    QVERIFY2(made.ok(), made ? "" : made.error().text().c_str());
    Result<take::Take> opened = take::open_take(path);
    QVERIFY(opened.ok());
    QVERIFY(has_range_segment(*opened));
    QCOMPARE(groups_in_take(*opened), (std::vector<int>{0, 1}));

    const auto ranges = range_from_take(*opened, {});
    QVERIFY2(ranges.ok(), ranges ? "" : ranges.error().text().c_str());
    QCOMPARE(ranges->size(), std::size_t{5});
    calibrate::RigCalibration calibration = calibrate::nominal_calibration(opened->info.rig);
    for (const RangeOutcome& outcome : *ranges) {
      QVERIFY2(outcome.result.has_value(), outcome.error.text().c_str());
      QCOMPARE(outcome.result->verdict, calibrate::Verdict::kGood);
      calibration.sensors[static_cast<std::size_t>(outcome.sensor)] = outcome.result->calibration;
    }
    const auto limb = limb_from_take(*opened, 0, calibration, {});
    QVERIFY2(limb.ok(), limb ? "" : limb.error().text().c_str());
    QCOMPARE(limb->outcomes.size(), std::size_t{4});
    for (const LimbOutcome& outcome : limb->outcomes) {
      QVERIFY(outcome.result.has_value());
      QCOMPARE(outcome.result->verdict, calibrate::Verdict::kGood);
    }
    // Stopped work says so.
    const auto stopped = range_from_take(*opened, Progress([](double, std::string_view) { return false; }));
    QVERIFY(!stopped.ok() && is_cancelled(stopped.error()));

    // Saving makes it the take's own; undo takes it back.
    StudioContext context(StudioServices{}, folder.filePath(QStringLiteral("settings")));
    context.document().set(std::move(opened).value());
    FakeSource source;
    source.set_running(false);
    CalibrationDesk desk(context, source,
                         take::CalibrationLibrary(folder.filePath(QStringLiteral("library")).toStdString()));
    QVERIFY(desk.subject() == CalibrationDesk::Subject::kTake);
    const bool before = solve::is_measured(desk.calibration());
    RangeWizardModel model(desk);
    model.show_outcomes(ranges.value(), desk.target());
    QCOMPARE(model.accepted(), 5);
    QSignalSpy saved(&model, &RangeWizardModel::saved);
    model.next();
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(desk.calibration().sensors[0].method, ranges->front().result->calibration.method);
    QTRY_VERIFY(context.jobs().jobs().empty());
    QVERIFY(solve::is_measured(*take::open_take(path)->info.calibration));
    context.undo_stack().undo();
    QCOMPARE(solve::is_measured(desk.calibration()), before);
    QTRY_VERIFY(context.jobs().jobs().empty());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::CalibrationSourcesTest)
#include "calibration_sources_test.moc"
