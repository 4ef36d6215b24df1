/// Jobs, notifications and recent takes with a running event loop.
#include "common/job_runner.h"

#include <QDir>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "common/notifications.h"
#include "common/recent_takes.h"

namespace limbwave::ui {

class JobRunnerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void value_arrives_in_the_gui_thread() {
    JobRunner jobs;
    int got = 0;
    QThread* thread = nullptr;
    jobs.compute<int>(
        QStringLiteral("count"), this, [](const Progress&) { return Result<int>(7); },
        [&](Result<int> result) {
          got = result.value();
          thread = QThread::currentThread();
        });
    QTRY_COMPARE(got, 7);
    QCOMPARE(thread, QCoreApplication::instance()->thread());
    QVERIFY(jobs.jobs().empty());
  }

  void cancel_stops_the_work() {
    JobRunner jobs;
    std::atomic<bool> left = false;
    Status ended;
    bool done = false;
    Job* job = jobs.start(
        QStringLiteral("for ever"), this,
        [&left](const Progress& progress) -> Status {
          while (progress.report(0.5, "turning")) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
          left = true;
          return cancelled();
        },
        [&](const Status& status) {
          ended = status;
          done = true;
        });
    QTRY_COMPARE(job->fraction(), 0.5);
    QCOMPARE(job->step(), QStringLiteral("turning"));
    job->cancel();
    QVERIFY(job->cancelling());
    QTRY_VERIFY(done);
    QVERIFY(left);
    QVERIFY(!ended && is_cancelled(ended.error()));
  }

  void exceptions_become_errors() {
    JobRunner jobs;
    QString message;
    jobs.start(
        QStringLiteral("bad"), this, [](const Progress&) -> Status { throw std::runtime_error("out of cheese"); },
        [&](const Status& status) { message = QString::fromStdString(status.error().message); });
    QTRY_VERIFY(message.contains(QStringLiteral("out of cheese")));
  }

  void exceptions_of_work_with_a_value_become_errors_too() {
    JobRunner jobs;
    QStringList messages;
    const auto done = [&](const Result<int>& result) {
      messages << (result ? QStringLiteral("a value") : QString::fromStdString(result.error().message));
    };
    jobs.compute<int>(
        QStringLiteral("bad"), this, [](const Progress&) -> Result<int> { throw std::bad_alloc(); }, done);
    jobs.compute<int>(
        QStringLiteral("worse"), this, [](const Progress&) -> Result<int> { throw 7; }, done);
    QTRY_COMPARE(messages.size(), 2);
    QVERIFY2(messages[0].contains(QStringLiteral("unexpected problem")), qPrintable(messages[0]));
    QVERIFY2(messages[1].contains(QStringLiteral("unexpected problem")), qPrintable(messages[1]));
  }

  void nobody_is_called_whose_owner_is_gone() {
    JobRunner jobs;
    auto owner = std::make_unique<QObject>();
    bool called = false;
    jobs.start(
        QStringLiteral("late"), owner.get(),
        [](const Progress&) -> Status {
          std::this_thread::sleep_for(std::chrono::milliseconds(30));
          return {};
        },
        [&](const Status&) { called = true; });
    owner.reset();
    QTRY_VERIFY(jobs.jobs().empty());
    QVERIFY(!called);
  }

  void runner_that_goes_cancels_and_waits() {
    std::atomic<bool> running = false, left = false;
    {
      JobRunner jobs;
      jobs.start(QStringLiteral("long"), this, [&](const Progress& progress) -> Status {
        running = true;
        while (progress.report(0.1)) {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        left = true;
        return cancelled();
      });
      QTRY_VERIFY(running);
    }
    QVERIFY(left);
    QTest::qWait(10);  // What the job had queued finds nobody and must not crash.
  }

  void notifications_say_each_sentence_once() {
    Notifications notifications;
    notifications.post(Severity::kWarning, QStringLiteral("a"));
    notifications.post(Severity::kWarning, QStringLiteral("b"));
    notifications.post(Severity::kWarning, QStringLiteral("a"));
    QCOMPARE(notifications.all().size(), std::size_t{2});
    QCOMPARE(notifications.all().front().text, QStringLiteral("a"));
    notifications.post_error(QStringLiteral("x"), cancelled());
    QCOMPARE(notifications.all().size(), std::size_t{2});
    notifications.post_error(QStringLiteral("x"), Error{"it broke", "file.wav", "repair it"});
    QCOMPARE(notifications.all().front().text, QStringLiteral("X: file.wav: it broke."));
    QCOMPARE(notifications.all().front().remedy, QStringLiteral("Repair it."));
    notifications.dismiss(notifications.all().front().id);
    QCOMPARE(notifications.all().size(), std::size_t{2});
  }

  void recent_takes_survive_anything_in_the_settings() {
    QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
    settings.setValue(QStringLiteral("recent/takes"), QByteArray("\x00\xff garbage", 10));
    RecentTakes recent(settings);
    QVERIFY(recent.folders().isEmpty());
    for (int i = 0; i < 20; ++i) {
      const QString take = folder.filePath(QStringLiteral("t%1.take").arg(i));
      QDir().mkpath(take);
      recent.add(take);
    }
    QCOMPARE(recent.folders().size(), 12);
    QVERIFY(recent.folders().first().endsWith(QStringLiteral("t19.take")));
    QDir(recent.folders().first()).removeRecursively();
    QVERIFY(recent.folders().first().endsWith(QStringLiteral("t18.take")));
  }
};

}  // namespace limbwave::ui

QTEST_GUILESS_MAIN(limbwave::ui::JobRunnerTest)
#include "job_runner_test.moc"
