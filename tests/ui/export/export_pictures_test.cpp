/// Pictures of the Export workspace in BUILD/screenshots: dark, light, German, small; with QT_SCALE_FACTOR=2 also for
/// dense displays. Checks that nothing that has to be read is cut off.
#include <QImage>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTranslator>

#include "ui/export/export_fixture.h"

namespace limbwave::ui::testing {

class ExportPicturesTest : public QObject, protected ExportCase {
  Q_OBJECT

 private:
  void open(int width = 1440, int height = 900) {
    const int scale = qRound(qApp->devicePixelRatio());
    QVERIFY(open_studio(solving_->services(), {std::min(width, 1600 / scale), std::min(height, 1000 / scale)}));
    const QString motion = recorded_motion();
    if (motion.isEmpty()) {
      QVERIFY(studio_->open_take());
    } else {
      QVERIFY(QFile::copy(motion, studio_->studio->folder.filePath(QStringLiteral("walk.bvh"))));
      QVERIFY(studio_->open_animation(studio_->studio->folder.filePath(QStringLiteral("walk.bvh"))));
    }
    studio_->studio->context->time().set_playhead(1.0);
  }
  void choose_unreal() {
    ExportChoices choices = studio_->model().choices();
    studio_->model().choose_preset("unreal");
    choices = studio_->model().choices();
    choices.fps = 30.0;
    choices.key_tolerance_deg = 0.2;
    studio_->model().change(choices);
    QVERIFY(studio_->settle());
  }
  /// Every label and button in view has the room that its text needs.
  void check_room() const {
    for (const QPushButton* button : studio_->workspace().findChildren<QPushButton*>()) {
      if (button->isVisible()) {
        QVERIFY2(button->width() >= button->minimumSizeHint().width(), qPrintable(button->text()));
      }
    }
    for (const QScrollArea* area : studio_->workspace().findChildren<QScrollArea*>()) {
      QVERIFY2(area->widget()->width() <= area->viewport()->width(), "the choices are wider than their place");
    }
  }
  void shoot(const QString& name) const {
    const int percent = qRound(qApp->devicePixelRatio() * 100.0);
    check_room();
    studio_->save(percent == 100 ? name : QStringLiteral("%1-%2").arg(name).arg(percent));
    // The lower part of the choices, too.
    auto* area = studio_->workspace().findChild<QScrollArea*>();
    area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
    studio_->save(QStringLiteral("%1-end%2").arg(name, percent == 100 ? QString() : QStringLiteral("-200")));
  }

 private Q_SLOTS:
  void init() { set_up(); }
  void cleanup() { tear_down(); }

  void dark() {
    open();
    choose_unreal();
    shoot(QStringLiteral("export-walk-dark"));
  }
  void light() {
    apply_theme(*qApp, ThemeKind::kLight);
    open();
    choose_unreal();
    QVERIFY(studio_->export_now());
    shoot(QStringLiteral("export-walk-light"));
  }
  void small() {
    open(960, 600);
    choose_unreal();
    shoot(QStringLiteral("export-walk-small"));
  }
  void rest_pose() {
    open();
    studio_->model().choose_preset("maya");
    QVERIFY(studio_->settle());
    QTest::mouseClick(studio_->button("Rest pose"), Qt::LeftButton);
    shoot(QStringLiteral("export-rest-pose"));
  }
  void german() {
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(LIMBWAVE_BINARY_DIR "/app/studio/limbwave_de.qm")));
    QApplication::installTranslator(&translator);
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    open();
    choose_unreal();
    bool done = false;
    connect(&studio_->model(), &ExportModel::exported, &studio_->model(), [&] { done = true; });
    studio_->model().start();
    QTRY_VERIFY_WITH_TIMEOUT(done, 60000);
    QVERIFY(studio_->says("Geschrieben und zurückgelesen"));
    QVERIFY(studio_->says("Die Knochen heißen wie in"));
    shoot(QStringLiteral("export-walk-german"));
    // Every shipped preset speaks German.
    for (const PresetEntry& entry : studio_->model().presets()) {
      QVERIFY2(preset_comment(*entry.preset) != QString::fromStdString(entry.preset->comment), entry.name.c_str());
    }
    studio_.reset();
    QApplication::removeTranslator(&translator);
    QLocale::setDefault(QLocale::c());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ExportPicturesTest)
#include "export_pictures_test.moc"
