/// The manual as it is shown: whole, with its pictures, in both themes, and reached from where it is needed.
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTextTable>
#include <QToolButton>
#include <QTranslator>

#include "common/theme.h"
#include "ui/support/fake_services.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/manual_window.h"

namespace limbwave::ui::testing {

class ManualTest : public QObject {
  Q_OBJECT
 private:
  static ManualWindow* manual_of(StudioFixture& studio) { return studio.window->findChild<ManualWindow*>(); }

 private Q_SLOTS:
  void init() { apply_theme(*qApp, ThemeKind::kDark); }
  void cleanup() { apply_theme(*qApp, ThemeKind::kDark); }

  void every_chapter_is_there_with_its_pictures_and_links() {
    StudioFixture studio(fake_services(std::make_shared<FakeLine>()));
    QVERIFY(QTest::qWaitForWindowActive(studio.window.get()));
    QTest::keyClick(studio.window.get(), Qt::Key_F1);
    QTRY_VERIFY(manual_of(studio) != nullptr);
    ManualWindow* manual = manual_of(studio);
    auto* text = manual->findChild<ManualBrowser*>();
    QCOMPARE(manual->chapter(), QStringLiteral("overview"));
    const QString suffix =
        qEnvironmentVariable("QT_SCALE_FACTOR") == QLatin1String("2") ? QStringLiteral("@2x") : QString();
    for (const QString& chapter : ManualWindow::chapters()) {
      manual->show_chapter(chapter);
      QCOMPARE(manual->chapter(), chapter);
      QVERIFY2(text->toPlainText().size() > 300, qPrintable(chapter));
      QCOMPARE(text->document()->firstBlock().blockFormat().headingLevel(), 1);
      for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
          const QTextCharFormat format = it.fragment().charFormat();
          if (format.isAnchor()) {
            const QUrl url(format.anchorHref());
            QVERIFY2(ManualWindow::chapters().contains(url.path()), qPrintable(format.anchorHref()));
          }
          if (format.isImageFormat()) {
            const QVariant picture =
                text->document()->resource(QTextDocument::ImageResource, QUrl(format.toImageFormat().name()));
            QVERIFY2(!picture.value<QImage>().isNull(), qPrintable(format.toImageFormat().name()));
          }
        }
      }
      QTest::qWait(50);
      QVERIFY(manual->grab().save(screenshot_path(QStringLiteral("manual-") + chapter + suffix)));
    }
    // Nothing is cut off at the right.
    QVERIFY(!text->horizontalScrollBar()->isVisible());
    manual->show_chapter(QStringLiteral("levels"));
    apply_theme(*qApp, ThemeKind::kLight);
    QTest::qWait(100);
    QVERIFY(manual->grab().save(screenshot_path(QStringLiteral("manual-light") + suffix)));
    Q_EMIT text->anchorClicked(QUrl(QStringLiteral("manual:wiring")));
    QCOMPARE(manual->chapter(), QStringLiteral("wiring"));
  }

  void german_has_every_chapter_with_the_same_pictures_and_links() {
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(LIMBWAVE_BINARY_DIR "/app/studio/limbwave_de.qm")));
    struct Content {
      QString text;
      QStringList links, pictures;
      int rows = 0;
    };
    const auto read = [](const QString& chapter) {
      ManualWindow manual(shortcut_groups(studio_parts()), nullptr);
      manual.show_chapter(chapter);
      auto* text = manual.findChild<ManualBrowser*>();
      Content content{text->toPlainText(), {}, {}, 0};
      for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
          const QTextCharFormat format = it.fragment().charFormat();
          if (format.isAnchor()) {
            content.links << format.anchorHref();
          }
          if (format.isImageFormat()) {
            content.pictures << format.toImageFormat().name();
          }
        }
      }
      for (QTextFrame* frame : text->document()->rootFrame()->childFrames()) {
        const auto* table = qobject_cast<QTextTable*>(frame);
        content.rows += table != nullptr ? table->rows() : 0;
      }
      return content;
    };
    const QString suffix =
        qEnvironmentVariable("QT_SCALE_FACTOR") == QLatin1String("2") ? QStringLiteral("@2x") : QString();
    for (const QString& chapter : ManualWindow::chapters()) {
      const Content english = read(chapter);
      QApplication::installTranslator(&translator);
      const Content german = read(chapter);
      ManualWindow manual(shortcut_groups(studio_parts()), nullptr);
      manual.show();
      manual.show_chapter(chapter);
      QTest::qWait(30);
      QVERIFY(manual.grab().save(screenshot_path(QStringLiteral("manual-german-") + chapter + suffix)));
      QVERIFY2(!manual.findChild<ManualBrowser*>()->horizontalScrollBar()->isVisible(), qPrintable(chapter));
      QApplication::removeTranslator(&translator);
      QVERIFY2(german.text.size() > 300 && german.text != english.text, qPrintable(chapter));
      QVERIFY2(german.text.contains(QRegularExpression(QStringLiteral("[äöüß]"))), qPrintable(chapter));
      QCOMPARE(german.links, english.links);
      QCOMPARE(german.pictures, english.pictures);
      QCOMPARE(german.rows, english.rows);
    }
  }

  void words_in_the_pictures_are_translated() {
    QDirIterator pictures(QStringLiteral(":/manual/pictures"));
    const QRegularExpression word(QStringLiteral(">([^<>]+)</text>"));
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(LIMBWAVE_BINARY_DIR "/app/studio/limbwave_de.qm")));
    int words = 0;
    while (pictures.hasNext()) {
      QFile file(pictures.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      for (auto found = word.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();) {
        const QString text = found.next().captured(1);
        if (text.contains(QRegularExpression(QStringLiteral("[a-z]{3}")))) {
          ++words;
          QVERIFY2(!translator.translate("ManualPicture", text.toUtf8().constData()).isEmpty(), qPrintable(text));
        }
      }
    }
    QVERIFY(words > 20);
  }

  void keys_are_those_of_the_studio() {
    const ManualWindow manual(shortcut_groups(studio_parts()), nullptr);
    auto* text = manual.findChild<ManualBrowser*>();
    const_cast<ManualWindow&>(manual).show_chapter(QStringLiteral("keys"));
    for (const ShortcutGroup& group : shortcut_groups(studio_parts())) {
      for (const ShortcutHelp& help : group.shortcuts) {
        QVERIFY2(text->toPlainText().contains(help.what.simplified()), qPrintable(help.what));
      }
    }
  }

  void what_is_wrong_leads_to_how_it_is_done() {
    auto line = std::make_shared<FakeLine>();
    line->level = 0.01;
    StudioFixture studio(fake_services(line));
    studio.window->show_workspace(QStringLiteral("capture"));
    studio.context->live().open(QStringLiteral("card"), QStringLiteral("Card"), "line-in-arm", {});
    auto* learn = studio.window->findChild<QLabel*>(QStringLiteral("learn_levels"));
    QTRY_VERIFY(learn->isVisible());
    Q_EMIT learn->linkActivated(QStringLiteral("#"));
    QTRY_VERIFY(manual_of(studio) != nullptr);
    QCOMPARE(manual_of(studio)->chapter(), QStringLiteral("levels"));
    line->level = 0.4;
    QTRY_VERIFY(!learn->isVisible());
    // The same window, another chapter.
    studio.context->reveal(QStringLiteral("manual"), QStringLiteral("recorder"));
    QCOMPARE(studio.window->findChildren<ManualWindow*>().size(), 1);
    QCOMPARE(manual_of(studio)->chapter(), QStringLiteral("recorder"));
  }

  void docks_have_buttons_that_can_be_hit() {
    StudioFixture studio(fake_services(std::make_shared<FakeLine>()));
    studio.window->show_workspace(QStringLiteral("solve"));
    auto* close = studio.window->findChild<QToolButton*>(QStringLiteral("close_inspector"));
    auto* floating = studio.window->findChild<QToolButton*>(QStringLiteral("float_inspector"));
    QTRY_VERIFY(close->isVisible());
    QVERIFY(close->width() >= 24 && close->height() >= 24);
    QVERIFY(!floating->accessibleName().isEmpty());
    const QString before = floating->accessibleName();
    QTest::mouseClick(floating, Qt::LeftButton);
    QTRY_VERIFY(floating->accessibleName() != before);
    QTest::mouseClick(floating, Qt::LeftButton);
    QTRY_COMPARE(floating->accessibleName(), before);
    QTest::mouseClick(close, Qt::LeftButton);
    QTRY_VERIFY(!close->isVisible());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ManualTest)
#include "manual_test.moc"
