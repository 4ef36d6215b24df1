/// Markers over real files and a made-up line: every change can be undone and stands in the take.
#include "common/marker_model.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <filesystem>

#include "common/studio_context.h"
#include "take/markers.h"
#include "take/recorder.h"
#include "ui/support/fake_services.h"

namespace limbwave::ui::testing {

class MarkerModelTest : public QObject {
  Q_OBJECT
 private:
  struct Studio {
    Studio() : line(std::make_shared<FakeLine>()) {
      StudioServices services = fake_services(line);
      services.open_take = [](const std::filesystem::path& path) { return take::open_take(path); };
      context = std::make_unique<StudioContext>(std::move(services), folder.filePath(QStringLiteral("settings")));
    }
    /// A take of ten seconds at 1 kHz with these markers.
    std::filesystem::path make_take(const std::vector<take::TakeEvent>& events) {
      const std::filesystem::path path = folder.filePath(QStringLiteral("x.take")).toStdString();
      take::TakeInfo info;
      info.format = {SampleRate{1000.0}, 2, acquire::SampleType::kInt16};
      info.rig = body::load_rig("line-in-arm").value();
      info.skeleton = body::load_skeleton(info.rig.skeleton).value();
      auto recorder = take::Recorder::create(path, info).value();
      (void)recorder->write(std::vector<std::byte>(40000));
      for (const take::TakeEvent& event : events) {
        (void)recorder->add_event(event);
      }
      (void)recorder->close();
      return path;
    }
    void open(const std::filesystem::path& path) {
      context->document().open(QString::fromStdString(path.string()));
      QTRY_VERIFY(context->document().is_open());
    }
    bool record() {
      context->live().open(QStringLiteral("card"), QStringLiteral("Card"), "line-in-arm", {});
      return QTest::qWaitFor([&] { return context->live().snapshot() != nullptr; }) &&
             context->live().start_recording(folder.filePath(QStringLiteral("live.take")).toStdString(), {}) &&
             QTest::qWaitFor([&] { return context->live().recording(); });
    }
    [[nodiscard]] QStringList shown() const {
      QStringList list;
      for (const Marker& marker : context->markers().markers()) {
        list << QStringLiteral("%1 %2").arg(marker.sample).arg(marker.text);
      }
      return list;
    }
    /// What another program reads from disk.
    static QStringList on_disk(const std::filesystem::path& path) {
      QStringList list;
      const Result<take::Take> take = take::open_take(path);
      for (const take::TakeEvent& event : take->events) {
        if (take::is_marker(event)) {
          list << QStringLiteral("%1 %2").arg(event.sample.value).arg(QString::fromStdString(event.text));
        }
      }
      return list;
    }
    /// Lines come in the order of the edits.
    static QStringList sorted(QStringList list) {
      list.sort();
      return list;
    }
    QTemporaryDir folder;
    std::shared_ptr<FakeLine> line;
    std::unique_ptr<StudioContext> context;
  };

 private Q_SLOTS:
  void every_change_of_a_take_is_on_disk_and_can_be_undone() {
    Studio studio;
    const auto path = studio.make_take(
        {{SampleIndex{1000}, take::kMarker, "clap", 1}, {SampleIndex{4000}, take::kMarker, "jump", 0}});
    studio.open(path);
    MarkerModel& markers = studio.context->markers();
    QUndoStack& undo = studio.context->undo_stack();
    const QStringList first{QStringLiteral("1000 clap"), QStringLiteral("4000 jump")};
    QCOMPARE(studio.shown(), first);

    std::vector<QStringList> states{first};
    const auto step = [&](bool done) {
      QVERIFY(done);
      states.push_back(studio.shown());
      QVERIFY(states.back() != states[states.size() - 2]);
    };
    step(markers.rename(1, QStringLiteral("clap  of  hands ")));
    QCOMPARE(studio.shown().first(), QStringLiteral("1000 clap of hands"));
    step(markers.move(-2, 0.5));
    QCOMPARE(studio.shown(), (QStringList{QStringLiteral("500 jump"), QStringLiteral("1000 clap of hands")}));
    step(markers.add(20.0, {}));  // Beyond the end: at the end.
    QCOMPARE(studio.shown().last(), QStringLiteral("10000 Marker 3"));
    step(markers.remove(1));
    step(markers.remove(-2));
    for (int round = 0; round < 2; ++round) {
      for (std::size_t i = states.size() - 1; i > 0; --i) {
        undo.undo();
        QCOMPARE(studio.shown(), states[i - 1]);
      }
      QVERIFY(!undo.canUndo());
      for (std::size_t i = 1; i < states.size(); ++i) {
        undo.redo();
        QCOMPARE(studio.shown(), states[i]);
      }
    }
    studio.context->saves().finish();
    QCOMPARE(Studio::sorted(Studio::on_disk(path)), Studio::sorted(states.back()));
    undo.undo();
    studio.context.reset();  // Closing the studio writes what still waits.
    QCOMPARE(Studio::sorted(Studio::on_disk(path)), Studio::sorted(states[states.size() - 2]));
  }

  void what_makes_no_difference_is_no_step() {
    Studio studio;
    studio.open(studio.make_take({{SampleIndex{1000}, take::kMarker, "clap", 1}}));
    MarkerModel& markers = studio.context->markers();
    QVERIFY(!markers.rename(1, QStringLiteral(" ")));
    QVERIFY(!markers.rename(1, QStringLiteral("clap")));
    QVERIFY(!markers.rename(9, QStringLiteral("x")));
    QVERIFY(!markers.move(1, 1.0));
    QVERIFY(!markers.move(1, std::nan("")));
    QVERIFY(!markers.remove(9));
    QVERIFY(!markers.mark_now());
    QCOMPARE(studio.context->undo_stack().count(), 0);
  }

  void a_gesture_is_one_step() {
    Studio studio;
    studio.open(studio.make_take({{SampleIndex{1000}, take::kMarker, "clap", 1}}));
    MarkerModel& markers = studio.context->markers();
    for (const double to : {1.1, 1.2, 1.3}) {
      QVERIFY(markers.move(1, to, 7));
    }
    QVERIFY(markers.move(1, 2.0, 8));
    QCOMPARE(studio.context->undo_stack().count(), 2);
    studio.context->undo_stack().undo();
    QCOMPARE(studio.shown(), QStringList{QStringLiteral("1300 clap")});
    studio.context->undo_stack().undo();
    QCOMPARE(studio.shown(), QStringList{QStringLiteral("1000 clap")});
  }

  void editing_markers_is_no_other_take_and_no_other_calibration() {
    Studio studio;
    studio.open(studio.make_take({{SampleIndex{1000}, take::kMarker, "clap", 1}}));
    const QSignalSpy changed(&studio.context->document(), &TakeDocument::changed);
    QVERIFY(studio.context->markers().rename(1, QStringLiteral("snap")));
    QCOMPARE(changed.count(), 0);
    QCOMPARE(studio.context->document().take()->events.front().text, std::string("snap"));
  }

  void markers_of_a_recording_are_changed_and_undone_while_it_runs_and_after() {
    Studio studio;
    QVERIFY(studio.record());
    MarkerModel& markers = studio.context->markers();
    QUndoStack& undo = studio.context->undo_stack();
    QTest::qWait(100);
    QVERIFY(markers.mark_now());
    QVERIFY(markers.mark_now(QStringLiteral("she turns")));
    QVERIFY(markers.rename(1, QStringLiteral("clap")));
    QVERIFY(markers.move(2, 0.01));
    QVERIFY(markers.remove(1));
    undo.undo();
    QCOMPARE(markers.markers().size(), std::size_t{2});
    const QStringList before_stop = studio.shown();
    QCOMPARE(before_stop.first(), QStringLiteral("480 she turns"));
    // What a crash would leave at this moment: the lines that were handed to the recorder.
    QStringList written;
    for (const take::TakeEvent& event : take::events_in_force(studio.line->events)) {
      written << QStringLiteral("%1 %2").arg(event.sample.value).arg(QString::fromStdString(event.text));
    }
    QCOMPARE(Studio::sorted(written), Studio::sorted(before_stop));

    studio.context->live().stop_recording();
    QTRY_VERIFY(studio.context->document().is_open());
    QCOMPARE(studio.shown(), before_stop);
    QCOMPARE(undo.count(), 4);  // set, set, rename, move; the deletion was undone before.
    // Both were set within milliseconds: which is shown first depends on the samples' digits.
    const auto shows = [&studio](const QString& words) {
      const QStringList all = studio.shown();
      return std::any_of(all.begin(), all.end(), [&](const QString& one) { return one.endsWith(words); });
    };
    undo.undo();
    QVERIFY(shows(QStringLiteral("she turns")) && !studio.shown().contains(QStringLiteral("480 she turns")));
    undo.undo();
    QVERIFY(shows(QStringLiteral("Marker 1")) && !shows(QStringLiteral("clap")));
    undo.undo();
    undo.undo();
    QVERIFY(studio.shown().isEmpty());
    undo.redo();
    QVERIFY(studio.shown().first().endsWith(QStringLiteral("Marker 1")));
    studio.context->saves().finish();
  }

  void a_recording_aside_has_no_markers() {
    Studio studio;
    studio.open(studio.make_take({{SampleIndex{1000}, take::kMarker, "clap", 1}}));
    studio.context->live().open(QStringLiteral("card"), QStringLiteral("Card"), "line-in-arm", {});
    QTRY_VERIFY(studio.context->live().snapshot() != nullptr);
    QVERIFY(studio.context->live().start_recording(studio.folder.filePath(QStringLiteral("aside.take")).toStdString(),
                                                   {}, true));
    QTRY_VERIFY(studio.context->live().recording());
    QVERIFY(!studio.context->markers().mark_now());
    QCOMPARE(studio.shown(), QStringList{QStringLiteral("1000 clap")});
  }

  void a_marker_that_cannot_be_saved_is_told() {
    Studio studio;
    const auto path = studio.make_take({{SampleIndex{1000}, take::kMarker, "clap", 1}});
    studio.open(path);
    std::filesystem::remove_all(path);
    QVERIFY(studio.context->markers().rename(1, QStringLiteral("snap")));
    QTRY_VERIFY(!studio.context->notifications().all().empty());
    QVERIFY(studio.context->notifications().all().front().text.contains(QStringLiteral("marker is not saved")));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::MarkerModelTest)
#include "marker_model_test.moc"
