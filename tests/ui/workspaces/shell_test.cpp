/// The window around the workspaces: layout, jobs, shortcuts, drops, takes.
#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QToolButton>
#include <cmath>
#include <set>

#include "common/theme.h"
#include "ui/support/fake_services.h"
#include "ui/support/solve_fixture.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/import_sheet.h"
#include "workspaces/job_bar.h"
#include "workspaces/layout_store.h"
#include "workspaces/message_bar.h"
#include "workspaces/shortcut_sheet.h"
#include "workspaces/take_actions.h"

namespace limbwave::ui::testing {

class ShellTest : public QObject {
  Q_OBJECT
 private:
  static StudioServices services() { return fake_services(std::make_shared<FakeLine>()); }

 private Q_SLOTS:
  void layout_survives_garbage_in_the_settings() {
    const QList<QByteArray> garbage{QByteArray(), QByteArray("garbage"), QByteArray(100000, '\xff'),
                                    seal_layout(QByteArray("not a state")), seal_layout(QByteArray(5000, '\x7f'))};
    for (const QByteArray& geometry : garbage) {
      QTemporaryDir folder;
      {
        QSettings settings(folder.filePath(QStringLiteral("studio.ini")), QSettings::IniFormat);
        settings.setValue(QStringLiteral("window/geometry"), geometry);
        settings.setValue(QStringLiteral("window/docks"), geometry);
        settings.setValue(QStringLiteral("recent/takes"), geometry);
        settings.setValue(QStringLiteral("capture/rig"), geometry);
        settings.setValue(QStringLiteral("takes/folder"), folder.path());
      }
      StudioContext context(services(), folder.path());
      MainWindow window(context, studio_parts());
      window.show();
      QVERIFY(QTest::qWaitForWindowExposed(&window));
      QVERIFY(window.show_workspace(QStringLiteral("capture")));
      QVERIFY(window.width() >= window.minimumWidth());
    }
    // And a settings file that is no settings file.
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("studio.ini")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(4096, '\x93') + "[[[=%%%\n@Variant(\\xff)");
    file.close();
    StudioContext context(services(), folder.path());
    context.set_takes_folder(folder.path());
    MainWindow window(context, studio_parts());
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
  }

  void layout_is_remembered() {
    QTemporaryDir folder;
    {
      StudioContext context(services(), folder.path());
      context.set_takes_folder(folder.path());
      MainWindow window(context, studio_parts());
      window.show();
      QVERIFY(QTest::qWaitForWindowExposed(&window));
      window.resize(1111, 777);
      QTRY_COMPARE(window.size(), QSize(1111, 777));
      window.close();
    }
    StudioContext context(services(), folder.path());
    MainWindow window(context, studio_parts());
    window.show();
    QTRY_COMPARE(window.size(), QSize(1111, 777));
  }

  void a_closed_panel_stays_closed() {
    QTemporaryDir folder;
    {
      StudioContext context(services(), folder.path());
      context.set_takes_folder(folder.path());
      MainWindow window(context, studio_parts());
      window.show();
      QVERIFY(QTest::qWaitForWindowExposed(&window));
      auto* inspector = window.findChild<QDockWidget*>(QStringLiteral("inspector"));
      auto* timeline = window.findChild<QDockWidget*>(QStringLiteral("timeline"));
      window.show_workspace(QStringLiteral("solve"));
      QVERIFY(inspector->isVisible() && timeline->isVisible());
      inspector->close();
      window.show_workspace(QStringLiteral("capture"));
      QVERIFY(!timeline->isVisible());
      window.show_workspace(QStringLiteral("solve"));
      QVERIFY(!inspector->isVisible());
      QVERIFY(timeline->isVisible());
      window.close();
    }
    StudioContext context(services(), folder.path());
    MainWindow window(context, studio_parts());
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.show_workspace(QStringLiteral("solve"));
    auto* inspector = window.findChild<QDockWidget*>(QStringLiteral("inspector"));
    QVERIFY(!inspector->isVisible());
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));  // shortcuts are the active window's
    QTest::keyClick(&window, Qt::Key_F3);
    QVERIFY(inspector->isVisible());
  }

  void quitting_while_recording_is_asked() {
    StudioFixture studio(services());
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    LiveModel& live = studio.context->live();
    QVERIFY(live.open(QStringLiteral("simulator:wave"), QStringLiteral("Simulator"), "line-in-arm", {}));
    QTRY_VERIFY(live.running());
    QVERIFY(live.start_recording(studio.folder.filePath(QStringLiteral("a.take")).toStdString(), {}));
    QTRY_VERIFY(live.recording());
    bool asked = false;
    QTimer::singleShot(200, studio.window.get(), [&asked, window = studio.window.get()] {
      if (auto* box = window->findChild<QMessageBox*>(QStringLiteral("quit_question"))) {
        asked = true;
        box->reject();
      }
    });
    QVERIFY(!studio.window->close());
    QVERIFY(asked && live.recording() && studio.window->isVisible());
    asked = false;
    QTimer::singleShot(200, studio.window.get(), [&asked, window = studio.window.get()] {
      if (auto* box = window->findChild<QMessageBox*>(QStringLiteral("quit_question"))) {
        for (QAbstractButton* button : box->buttons()) {
          if (button->text().contains(QStringLiteral("quit"))) {
            asked = true;
            button->click();
            return;
          }
        }
      }
    });
    QVERIFY(studio.window->close());
    QVERIFY(asked);
  }

  void an_unread_error_is_not_hidden_by_later_news() {
    StudioFixture studio(services());
    Notifications& notifications = studio.context->notifications();
    auto* bar = studio.window->findChild<MessageBar*>(QStringLiteral("message_bar"));
    notifications.post_error(QStringLiteral("It went wrong."), Error{"the disk is full", "", "make room"});
    notifications.post(Severity::kInfo, QStringLiteral("Something was written."));
    QCOMPARE(bar->text(), QStringLiteral("It went wrong: the disk is full. Make room."));
    QTest::mouseClick(bar->findChild<QPushButton*>(QStringLiteral("more_messages")), Qt::LeftButton);
    QCOMPARE(bar->text(), QStringLiteral("Something was written."));
    QTest::mouseClick(bar->findChild<QToolButton*>(), Qt::LeftButton);
    QCOMPARE(bar->text(), QStringLiteral("It went wrong: the disk is full. Make room."));
  }

  void of_two_takes_asked_for_the_last_one_opens() {
    StudioServices table = services();
    table.open_take = [](const std::filesystem::path& folder) -> Result<take::Take> {
      QThread::msleep(folder.filename() == "slow.take" ? 400 : 10);
      take::Take take;
      take.folder = folder;
      return take;
    };
    StudioFixture studio(table);
    studio.context->document().open(QStringLiteral("slow.take"));
    studio.context->document().open(QStringLiteral("fast.take"));
    QTRY_VERIFY(studio.context->document().is_open());
    QTRY_VERIFY(studio.context->jobs().jobs().empty());
    QCOMPARE(studio.context->document().name(), QStringLiteral("fast"));
  }

  void importing_asks_for_name_rig_and_wearer() {
    StudioServices table = services();
    std::string asked;
    table.import_recording = [&asked](const std::filesystem::path& folder, const std::vector<std::filesystem::path>&,
                                      const std::string& rig, const std::string& subject, const Progress&) {
      asked = folder.filename().string() + "|" + rig + "|" + subject;
      return Status(Error{"no such file", "", ""});
    };
    StudioFixture studio(table);
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    studio.context->set_wearer(QStringLiteral("Anna"));
    studio.window->take_actions().import_files({QStringLiteral("/nowhere/Track 01.mp3")});
    auto* sheet = studio.window->findChild<ImportSheet*>();
    QVERIFY(sheet != nullptr);
    QVERIFY(asked.empty());
    QCOMPARE(sheet->subject(), QStringLiteral("Anna"));
    auto* name = sheet->findChild<QLineEdit*>(QStringLiteral("import_name"));
    auto* go = sheet->findChild<QPushButton*>(QStringLiteral("import_button"));
    QVERIFY(!name->text().isEmpty());
    name->clear();
    QVERIFY(!go->isEnabled());
    QTest::keyClicks(name, QStringLiteral("walk"));
    sheet->findChild<QLineEdit*>(QStringLiteral("import_subject"))->setText(QStringLiteral("Ben"));
    QTest::mouseClick(go, Qt::LeftButton);
    QTRY_COMPARE(asked, std::string("walk.take|line-in-arm|Ben"));
  }

  void a_job_shows_time_and_can_be_cancelled() {
    StudioFixture studio(services());
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    QTest::mouseClick(studio.window->findChild<QWidget*>(QStringLiteral("demo_wave")), Qt::LeftButton);
    auto* bar = studio.window->findChild<JobBar*>(QStringLiteral("job_bar"));
    QTRY_VERIFY(bar->isVisible());
    auto* progress = bar->findChild<QProgressBar*>();
    QTRY_VERIFY(progress->value() > 0);
    QPushButton* cancel = bar->findChild<QPushButton*>();
    QCOMPARE(cancel->text(), QStringLiteral("Cancel"));
    QTest::mouseClick(cancel, Qt::LeftButton);
    QTRY_VERIFY(studio.context->jobs().jobs().empty());
    QTRY_VERIFY(!bar->isVisible());
    QVERIFY2(!studio.context->document().is_open(), "cancelled: nothing opens");
    QVERIFY2(studio.context->notifications().all().empty(), "cancelled: nothing to complain about");
  }

  void a_demo_take_opens_when_it_is_made() {
    StudioFixture studio(services());
    studio.window->take_actions().open_demo(QStringLiteral("wave"));
    QTRY_VERIFY_WITH_TIMEOUT(studio.context->document().is_open(), 10000);
    QCOMPARE(studio.context->document().name(), QStringLiteral("demo-wave"));
    QVERIFY(studio.window->current_workspace() != QStringLiteral("welcome"));
  }

  void a_folder_that_is_no_take_is_refused_with_a_remedy() {
    StudioFixture studio(services());
    QVERIFY(QTest::qWaitForWindowExposed(studio.window.get()));
    studio.window->take_actions().open(studio.folder.path());
    auto* bar = studio.window->findChild<MessageBar*>(QStringLiteral("message_bar"));
    QTRY_VERIFY(bar->isVisible());
    QVERIFY(bar->text().contains(QStringLiteral("this is not a take")));
    QVERIFY(bar->text().contains(QStringLiteral("Choose a folder")));
  }

  void drops_are_sorted() {
    StudioFixture studio(services());
    const QString take = studio.folder.filePath(QStringLiteral("x.take"));
    QDir().mkpath(take);
    const QString wav = studio.folder.filePath(QStringLiteral("a.WAV"));
    QFile(wav).open(QIODevice::WriteOnly);
    QVERIFY(TakeActions::acceptable({QUrl::fromLocalFile(take)}));
    QVERIFY(TakeActions::acceptable({QUrl::fromLocalFile(wav)}));
    QVERIFY(!TakeActions::acceptable({QUrl::fromLocalFile(studio.folder.path())}));
    QVERIFY(!TakeActions::acceptable({QUrl(QStringLiteral("https://example.org/a.wav"))}));
  }

  void a_take_may_be_opened_when_every_place_was_seen_before() {
    FakeSolving solving;
    SolveStudio studio(solving.services(), services());
    for (const WorkspaceEntry& entry : studio_parts().workspaces) {
      QVERIFY(studio.window->show_workspace(entry.id));
    }
    studio.window->show_workspace(QStringLiteral("welcome"));
    studio.context->document().set(made_up_take(studio.take_folder(QStringLiteral("one.take")), 2.0));
    QTRY_COMPARE(studio.model->state(), SolveState::kSolved);
    QCOMPARE(studio.window->current_workspace(), QStringLiteral("solve"));
    // Also after one with another number of sensors.
    take::Take less = made_up_take(studio.take_folder(QStringLiteral("two.take")), 2.0);
    less.info.rig.accelerometers.pop_back();
    less.info.rig.groups.clear();
    studio.context->document().set(less);
    QTRY_COMPARE(studio.model->state(), SolveState::kSolved);
    studio.context->document().close();
    QCOMPARE(studio.model->state(), SolveState::kNoTake);
  }

  void return_presses_the_main_button_of_a_page() {
    StudioFixture studio(services());
    QVERIFY(QTest::qWaitForWindowActive(studio.window.get()));
    auto* create = studio.window->findChild<QPushButton*>(QStringLiteral("welcome_new_take"));
    create->setFocus();
    QTest::keyClick(create, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(studio.window->current_workspace(), QStringLiteral("welcome"));
    QTest::keyClick(create, Qt::Key_Return);
    QCOMPARE(studio.window->current_workspace(), QStringLiteral("capture"));
  }

  void shortcuts_are_listed_and_none_is_used_twice() {
    StudioFixture studio(services());
    std::set<QString> used;
    for (const QAction* action : studio.window->actions()) {
      for (const QKeySequence& keys : action->shortcuts()) {
        QVERIFY2(used.insert(keys.toString()).second, qPrintable(keys.toString()));
      }
    }
    for (const ShortcutGroup& group : shortcut_groups(studio_parts())) {
      QVERIFY(!group.shortcuts.empty());
      for (const ShortcutHelp& help : group.shortcuts) {
        QVERIFY(!help.keys.isEmpty() && !help.what.isEmpty());
      }
    }
    studio.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(studio.window.get()));
    QTest::keyClick(studio.window.get(), Qt::Key_1);
    QCOMPARE(studio.window->current_workspace(), QStringLiteral("capture"));
    QTest::keyClick(studio.window.get(), Qt::Key_Question, Qt::ShiftModifier);
    QTRY_VERIFY(studio.window->findChild<ShortcutSheet*>() != nullptr);
    // Every key of the window is on the sheet, and all of it is in view.
    QStringList listed;
    for (const ShortcutGroup& group : shortcut_groups(studio_parts())) {
      for (const ShortcutHelp& help : group.shortcuts) {
        for (const QString& one : help.keys.split(QStringLiteral(" / "))) {
          listed << one.trimmed();
        }
      }
    }
    for (const QAction* action : studio.window->actions()) {
      for (const QKeySequence& keys : action->shortcuts()) {
        const QString text = keys.toString();
        const bool workspace = text.size() == 1 && text[0].isDigit();
        QVERIFY2(workspace || listed.contains(text), qPrintable(text));
      }
    }
    const auto* sheet = studio.window->findChild<ShortcutSheet*>();
    const auto* scroll = sheet->findChild<QScrollArea*>();
    QTRY_VERIFY(scroll->viewport()->width() >= scroll->widget()->minimumSizeHint().width());
    QVERIFY(scroll->viewport()->width() + 4 >= scroll->widget()->sizeHint().width());
  }

  void themes_have_enough_contrast() {
    // WCAG 2: text against its ground at least 4.5 to 1.
    const auto luminance = [](const QColor& c) {
      const auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
      return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    };
    const auto contrast = [&](const QColor& a, const QColor& b) {
      const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
      return std::max(x, y) / std::min(x, y);
    };
    for (const ThemeColors* theme : {&dark_theme(), &light_theme()}) {
      for (const QColor& ground : {theme->window, theme->panel, theme->base}) {
        for (const QColor& ink : {theme->text, theme->dim}) {
          QVERIFY2(contrast(ink, ground) >= 4.5, qPrintable(ink.name() + QStringLiteral(" on ") + ground.name()));
        }
        for (const QColor& ink : {theme->good, theme->warning, theme->danger, theme->accent}) {
          QVERIFY2(contrast(ink, ground) >= 3.0, qPrintable(ink.name() + QStringLiteral(" on ") + ground.name()));
        }
      }
      QVERIFY(contrast(theme->accent_text, theme->accent) >= 4.5);
      for (int i = 0; i < 5; ++i) {
        QVERIFY(contrast(series_color(*theme, i), theme->base) >= 3.0);
      }
    }
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ShellTest)
#include "shell_test.moc"
