/// A handler that throws, in a real event loop.
#include "workspaces/studio_application.h"

#include <QTest>
#include <QTimer>
#include <stdexcept>

namespace limbwave::ui::testing {

class StudioApplicationTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void a_handler_that_throws_is_told_and_the_studio_lives_on() {
    Notifications notifications;
    static_cast<StudioApplication*>(qApp)->set_notifications(&notifications);
    bool later = false;
    QTimer::singleShot(0, qApp, [] { throw std::out_of_range("sensor 7"); });
    QTimer::singleShot(50, qApp, [&] { later = true; });
    QTRY_VERIFY(later);
    QCOMPARE(notifications.all().size(), std::size_t{1});
    QVERIFY(notifications.all().front().text.contains(QStringLiteral("sensor 7")));
  }
};

}  // namespace limbwave::ui::testing

int main(int argc, char** argv) {
  limbwave::ui::StudioApplication application(argc, argv);
  limbwave::ui::testing::StudioApplicationTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "studio_application_test.moc"
