/// Return on the main button of a page.
#include "workspaces/button_keys.h"

#include <QDialog>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace limbwave::ui::testing {

class ButtonKeysTest : public QObject {
  Q_OBJECT
 private:
  ButtonKeys keys_;

 private Q_SLOTS:
  void initTestCase() { qApp->installEventFilter(&keys_); }
  void cleanupTestCase() { qApp->removeEventFilter(&keys_); }

  void return_presses_the_main_button_alone() {
    QWidget page;
    QPushButton main(&page), other(&page);
    main.setProperty("primary", true);
    QSignalSpy pressed(&main, &QPushButton::clicked), others(&other, &QPushButton::clicked);
    page.show();
    QTest::keyClick(&main, Qt::Key_Return);
    QTest::keyClick(&main, Qt::Key_Enter, Qt::KeypadModifier);
    QCOMPARE(pressed.size(), 2);
    QTest::keyClick(&main, Qt::Key_Return, Qt::ControlModifier);
    QTest::keyClick(&main, Qt::Key_A);
    QCOMPARE(pressed.size(), 2);
    QTest::keyClick(&other, Qt::Key_Return);
    QVERIFY(others.isEmpty());
    main.setEnabled(false);
    QTest::keyClick(&main, Qt::Key_Return);
    QCOMPARE(pressed.size(), 2);
  }

  void a_key_that_is_held_presses_once() {
    QWidget page;
    QPushButton main(&page);
    main.setProperty("primary", true);
    QSignalSpy pressed(&main, &QPushButton::clicked);
    page.show();
    for (const bool repeated : {false, true, true}) {
      QKeyEvent press(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, {}, repeated);
      QCoreApplication::sendEvent(&main, &press);
    }
    QCOMPARE(pressed.size(), 1);
  }

  void dialogs_keep_their_own_way() {
    QDialog dialog;
    QPushButton main(&dialog), usual(&dialog);
    main.setProperty("primary", true);
    main.setAutoDefault(false);
    usual.setDefault(true);
    QSignalSpy pressed(&main, &QPushButton::clicked), usuals(&usual, &QPushButton::clicked);
    dialog.show();
    QTest::keyClick(&main, Qt::Key_Return);
    QVERIFY(pressed.isEmpty());
    QCOMPARE(usuals.size(), 1);
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ButtonKeysTest)
#include "button_keys_test.moc"
