/// Name, subject and sensors of a finished take over real files: every change can be undone and stands on disk.
#include "common/take_edits.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include "common/studio_context.h"
#include "take/markers.h"
#include "take/recorder.h"
#include "take/sensor_places.h"
#include "ui/support/fake_services.h"

namespace limbwave::ui::testing {
namespace fs = std::filesystem;

class TakeEditsTest : public QObject {
  Q_OBJECT
 private:
  struct Studio {
    Studio() {
      StudioServices services = fake_services(std::make_shared<FakeLine>());
      services.open_take = [](const fs::path& path) { return take::open_take(path); };
      context = std::make_unique<StudioContext>(std::move(services), folder.filePath(QStringLiteral("settings")));
    }
    [[nodiscard]] fs::path path(const char* name) const {
      return folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    void make_take(const char* name) const {
      take::TakeInfo info;
      info.format = {SampleRate{1000.0}, 2, acquire::SampleType::kInt16};
      info.rig = body::load_rig("line-in-arm").value();
      info.skeleton = body::load_skeleton(info.rig.skeleton).value();
      info.subject = "Anna";
      auto recorder = take::Recorder::create(path(name), info).value();
      (void)recorder->write(std::vector<std::byte>(40000));
      (void)recorder->close();
    }
    void open(const char* name) {
      context->document().open(QString::fromStdString(path(name).string()));
      QTRY_COMPARE(context->document().name(), QString::fromLatin1(name).chopped(5));
    }
    [[nodiscard]] TakeEdits& edits() const { return context->take_edits(); }
    [[nodiscard]] QUndoStack& stack() const { return context->undo_stack(); }
    [[nodiscard]] QString name() const { return context->document().name(); }
    QTemporaryDir folder;
    std::unique_ptr<StudioContext> context;
  };
  static std::string subject_on_disk(const fs::path& path) { return take::open_take(path)->info.subject; }

 private Q_SLOTS:
  void a_name_is_a_folder() {
    Studio studio;
    studio.make_take("a.take");
    studio.open("a.take");
    QSignalSpy changed(&studio.context->document(), &TakeDocument::changed);
    QVERIFY(studio.edits().change(QStringLiteral("b"), QStringLiteral("Anna")));
    QTRY_COMPARE(studio.name(), QStringLiteral("b"));
    QVERIFY(take::open_take(studio.path("b.take")).ok());
    QVERIFY(!fs::exists(studio.path("a.take")));
    QCOMPARE(studio.context->recent_takes().folders().size(), 1);
    QVERIFY(studio.context->recent_takes().folders().front().endsWith(QStringLiteral("/b.take")));
    studio.stack().undo();
    QTRY_COMPARE(studio.name(), QStringLiteral("a"));
    QVERIFY(fs::exists(studio.path("a.take")));
    studio.stack().redo();
    studio.stack().undo();
    studio.stack().redo();
    QTRY_COMPARE(studio.name(), QStringLiteral("b"));
    QTRY_VERIFY(studio.context->jobs().jobs().empty());
    QVERIFY(fs::exists(studio.path("b.take")) && !fs::exists(studio.path("a.take")));
    QVERIFY2(changed.isEmpty(), "the signals are the same: nothing is solved anew");
  }

  void edits_before_and_after_a_new_name_all_arrive() {
    Studio studio;
    studio.make_take("a.take");
    studio.open("a.take");
    // As fast as the stack takes them; what is on disk follows in this order.
    QVERIFY(studio.context->markers().add(1.0, QStringLiteral("one")));
    QVERIFY(studio.edits().change(QStringLiteral("b"), QStringLiteral("Anna")));
    QVERIFY(studio.context->markers().add(2.0, QStringLiteral("two")));
    QVERIFY(studio.edits().change(studio.name(), QStringLiteral("Ben")));
    QTRY_COMPARE(studio.name(), QStringLiteral("b"));
    QVERIFY(studio.context->markers().add(3.0, QStringLiteral("three")));
    studio.context->saves().finish();
    const take::Take take = take::open_take(studio.path("b.take")).value();
    QCOMPARE(take.info.subject, std::string("Ben"));
    QCOMPARE(std::count_if(take.events.begin(), take.events.end(), take::is_marker), std::ptrdiff_t{3});
    for (int i = 0; i < 5; ++i) {
      studio.stack().undo();
    }
    QTRY_COMPARE(studio.name(), QStringLiteral("a"));
    studio.context->saves().finish();
    const take::Take back = take::open_take(studio.path("a.take")).value();
    QCOMPARE(back.info.subject, std::string("Anna"));
    QCOMPARE(std::count_if(back.events.begin(), back.events.end(), take::is_marker), std::ptrdiff_t{0});
    QVERIFY(studio.context->notifications().all().empty());
  }

  void nobody_who_works_on_the_take_loses_it() {
    Studio studio;
    studio.make_take("a.take");
    studio.open("a.take");
    std::atomic<bool> go_on = false;
    const fs::path file = studio.path("a.take") / "late.txt";
    studio.context->jobs().start(QStringLiteral("Solving"), nullptr, [&](const Progress&) {
      while (!go_on) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return fs::exists(file.parent_path()) ? Status() : Status(Error{"is gone", file.string(), ""});
    });
    QVERIFY(studio.edits().change(QStringLiteral("b"), QStringLiteral("Anna")));
    QTest::qWait(100);
    QCOMPARE(studio.name(), QStringLiteral("a"));
    QCOMPARE(studio.context->notifications().all().size(), std::size_t{1});
    studio.stack().undo();
    studio.stack().redo();
    go_on = true;
    QTRY_COMPARE(studio.name(), QStringLiteral("b"));
    QVERIFY(!fs::exists(studio.path("a.take")));
  }

  void a_name_that_is_taken_is_refused_in_words() {
    Studio studio;
    studio.make_take("a.take");
    studio.make_take("b.take");
    studio.open("a.take");
    QVERIFY(studio.edits().name_problem(QStringLiteral("b")).contains(QStringLiteral("already")));
    QVERIFY(!studio.edits().change(QStringLiteral("b"), QStringLiteral("Ben")));
    QCOMPARE(studio.stack().count(), 0);
    // Taken between the edit and its undoing: the take keeps the name that it has.
    QVERIFY(studio.edits().change(QStringLiteral("c"), QStringLiteral("Anna")));
    QTRY_COMPARE(studio.name(), QStringLiteral("c"));
    studio.make_take("a.take");
    studio.stack().undo();
    QTRY_VERIFY(!studio.context->notifications().all().empty());
    QVERIFY(studio.context->notifications().all().front().text.contains(QStringLiteral("keeps its name")));
    QCOMPARE(studio.name(), QStringLiteral("c"));
    QVERIFY(studio.context->markers().add(1.0, QStringLiteral("still works")));
    studio.context->saves().finish();
    QCOMPARE(take::open_take(studio.path("c.take"))->events.size(), std::size_t{1});
  }

  void a_name_given_last_is_there_after_closing() {
    Studio studio;
    studio.make_take("a.take");
    studio.open("a.take");
    QVERIFY(studio.edits().change(QStringLiteral("b"), QStringLiteral("Ben")));
    studio.context.reset();
    QVERIFY(fs::exists(studio.path("b.take")));
    QCOMPARE(subject_on_disk(studio.path("b.take")), std::string("Ben"));
  }

  void sensors_that_were_mixed_up_are_put_right_as_one_step() {
    Studio studio;
    studio.make_take("a.take");
    studio.open("a.take");
    QSignalSpy changed(&studio.context->document(), &TakeDocument::changed);
    const std::vector<std::string> places{"torso", "upper arm", "hand", "forearm", "fingers"};
    const std::vector<std::string> serials{"A", "B", "C", "D", "E"};
    QVERIFY(studio.edits().change(QStringLiteral("a"), QStringLiteral("Ben"), places, serials));
    QCOMPARE(studio.stack().count(), 1);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed.front().front().toBool(), false);
    QCOMPARE(take::places_of(studio.context->document().take()->info.rig), places);
    studio.context->saves().finish();
    const take::Take worn = take::open_take(studio.path("a.take")).value();
    QCOMPARE(take::places_of(worn.info.rig), places);
    QCOMPARE(worn.info.rig.accelerometers[2].serial, std::string("C"));
    QCOMPARE(worn.info.rig.accelerometers[2].segment, std::string("hand"));
    QCOMPARE(worn.info.subject, std::string("Ben"));
    studio.stack().undo();
    studio.context->saves().finish();
    const take::Take back = take::open_take(studio.path("a.take")).value();
    QCOMPARE(back.info.rig.accelerometers[2].segment, std::string("forearm"));
    QCOMPARE(back.info.rig.accelerometers[2].serial, std::string());
    QCOMPARE(back.info.subject, std::string("Anna"));
    QVERIFY2(!studio.edits().change(QStringLiteral("a"), QStringLiteral("Anna"), places, {"A", "A", "", "", ""}),
             "one serial for two sensors");
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::TakeEditsTest)
#include "take_edits_test.moc"
