#include "workspaces/export/export_workspace.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "base/files.h"
#include "interchange/bvh_reader.h"
#include "ui/support/solve_fixture.h"

namespace limbwave::ui::testing {

class ExportWorkspaceTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<FakeSolving> solving_;
  std::unique_ptr<SolveStudio> studio_;

  template <typename T>
  [[nodiscard]] T* find(const QString& accessible_name) const {
    for (T* widget : studio_->window->findChildren<T*>()) {
      if (widget->accessibleName() == accessible_name && widget->isVisible()) {
        return widget;
      }
    }
    return nullptr;
  }
  [[nodiscard]] QPushButton* button(const QString& text) const {
    for (QPushButton* one : studio_->window->findChildren<QPushButton*>()) {
      if (one->text() == text && one->isVisible()) {
        return one;
      }
    }
    return nullptr;
  }
  [[nodiscard]] bool says(const QString& text) const {
    for (QLabel* label : studio_->window->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] QLineEdit* file() const { return find<QLineEdit>(QStringLiteral("File")); }
  void save(const QString& name) const { QVERIFY(studio_->screen().save(screenshot_path(name))); }
  void open(SolveServices services) {
    studio_ = std::make_unique<SolveStudio>(std::move(services));
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
    studio_->context->document().set(made_up_take(studio_->take_folder(QStringLiteral("swing.take")), 8.0));
    QTRY_COMPARE(studio_->model->state(), SolveState::kSolved);
    studio_->window->show_workspace(QStringLiteral("export"));
  }

 private Q_SLOTS:
  void init() {
    apply_theme(*qApp, ThemeKind::kDark);
    solving_ = std::make_unique<FakeSolving>();
  }
  void cleanup() {
    studio_.reset();
    solving_.reset();
  }

  void without_a_take_it_says_so() {
    studio_ = std::make_unique<SolveStudio>(solving_->services());
    studio_->window->show_workspace(QStringLiteral("export"));
    QVERIFY(says(QStringLiteral("No take is open")));
    save(QStringLiteral("export-empty"));
  }

  void suggests_a_name_beside_the_take() {
    open(solving_->services());
    QCOMPARE(file()->text(), studio_->take_folder(QStringLiteral("swing.bvh")));
  }

  void writes_reads_back_and_tells() {
    open(solving_->services());
    auto* rates = find<QComboBox>(QStringLiteral("Frame rate"));
    rates->setCurrentIndex(rates->findData(30.0));
    auto* units = find<QComboBox>(QStringLiteral("Unit of length"));
    units->setCurrentIndex(1);
    QVERIFY(says(QStringLiteral("241 frames")));
    QTest::mouseClick(button(QStringLiteral("Export")), Qt::LeftButton);
    QTRY_VERIFY(says(QStringLiteral("Written and read back: swing.bvh")));
    QVERIFY(says(QStringLiteral("241 frames at 30 Hz")));
    QVERIFY(button(QStringLiteral("Show in folder")) != nullptr);
    QVERIFY(says(QStringLiteral("will be replaced")));
    save(QStringLiteral("export-done"));
    interchange::BvhReadOptions metres;
    metres.metres_per_unit = 1.0;
    const auto back = interchange::load_bvh(file()->text().toStdString(), metres);
    QVERIFY(back.ok());
    QCOMPARE(back->frame_rate_hz, 30.0);
    const int upper = back->skeleton.find("upper_arm");
    QVERIFY(upper >= 0);
    QVERIFY(std::abs(back->skeleton.segments[static_cast<std::size_t>(upper)].length - 0.30) < 1e-3);
  }

  void what_is_there_stays_until_the_new_file_is_whole() {
    open(solving_->services());
    ExportPlan plan;
    plan.file = studio_->folder.filePath(QStringLiteral("old.bvh")).toStdString();
    const auto content = [&] {
      QFile read(QString::fromStdString(plan.file.string()));
      return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
    };
    QFile old(QString::fromStdString(plan.file.string()));
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("mine") == 4);
    old.close();
    const motion::Clip& clip = studio_->model->solve()->clip;
    for (const double stop_at : {0.0, 0.69, 0.7, 0.9}) {
      const auto result = export_clip(clip, plan, interchange::write_bvh,
                                      Progress([&](double fraction, std::string_view) { return fraction < stop_at; }));
      QVERIFY(!result.ok() && is_cancelled(result.error()));
      QCOMPARE(content(), QByteArray("mine"));
    }
    const auto broken = [](const motion::Clip&, const std::filesystem::path& file, const interchange::BvhWriteOptions&,
                           const Progress&) { return write_file(file, "HIERARCHY nonsense"); };
    QVERIFY(!export_clip(clip, plan, broken, {}).ok());
    QCOMPARE(content(), QByteArray("mine"));
    QVERIFY(export_clip(clip, plan, interchange::write_bvh, {}).ok());
    QVERIFY(content().startsWith("HIERARCHY"));
    QCOMPARE(
        QDir(studio_->folder.path()).entryList({QStringLiteral("*.part*")}, QDir::AllEntries | QDir::Hidden).size(), 0);
  }

  void edits_are_in_the_file() {
    open(solving_->services());
    QVERIFY(studio_->model->change_length(1, 0.4));
    QVERIFY(studio_->model->key_editor().set_value(2, 0.0, 0.5));
    QTest::mouseClick(button(QStringLiteral("Export")), Qt::LeftButton);
    QTRY_VERIFY(says(QStringLiteral("Written and read back")));
    const auto back = interchange::load_bvh(file()->text().toStdString());
    QVERIFY(back.ok());
    QVERIFY(std::abs(back->skeleton.segments[1].length - 0.4) < 1e-3);
    std::vector<body::SegmentPose> shown;
    studio_->model->pose_at(2.0, shown);
    const auto pose = motion::pose_at(*back, 2.0);
    QVERIFY((pose[3].p_WL - pose[2].p_WL - (shown[3].p_WL - shown[2].p_WL)).norm() < 1e-3);
  }

  void any_rate_can_be_typed() {
    open(solving_->services());
    auto* rates = find<QComboBox>(QStringLiteral("Frame rate"));
    rates->setCurrentIndex(rates->count() - 1);
    auto* rate = find<QDoubleSpinBox>(QStringLiteral("Frames a second"));
    QVERIFY(rate != nullptr);
    rate->setValue(23.976);
    QTest::mouseClick(button(QStringLiteral("Export")), Qt::LeftButton);
    QTRY_VERIFY(says(QStringLiteral("at 23.976 Hz")));
  }

  void places_that_cannot_be_written_are_told_before_trying() {
    open(solving_->services());
    file()->setText(QStringLiteral("/no/such/folder/arm.bvh"));
    QVERIFY(says(QStringLiteral("does not exist")));
    QVERIFY(!button(QStringLiteral("Export"))->isEnabled());
    file()->setText(studio_->folder.filePath(QStringLiteral("arm.txt")));
    QVERIFY(says(QStringLiteral("must end in .bvh")));
    file()->setText(QString());
    QVERIFY(says(QStringLiteral("Choose where the file goes")));
    file()->setText(QStringLiteral("/no/such/folder/arm.bvh"));
    save(QStringLiteral("export-problem"));
    file()->setText(studio_->folder.filePath(QStringLiteral("arm.bvh")));
    QVERIFY(button(QStringLiteral("Export"))->isEnabled());
  }

  void failures_while_writing_are_told_with_their_remedy() {
    SolveServices services = solving_->services();
    services.write_bvh = [](const motion::Clip&, const std::filesystem::path& path, const interchange::BvhWriteOptions&,
                            const Progress&) -> Status {
      return Error{"no space left on the device", path.string(), "free some space or choose another disk"};
    };
    open(std::move(services));
    QTest::mouseClick(button(QStringLiteral("Export")), Qt::LeftButton);
    QTRY_VERIFY(says(QStringLiteral("No space left on the device")));
    QVERIFY(says(QStringLiteral("Free some space")));
    QVERIFY(!QFileInfo::exists(studio_->take_folder(QStringLiteral("swing.bvh"))));
    QVERIFY(button(QStringLiteral("Export"))->isEnabled());
    save(QStringLiteral("export-failed"));
  }

  void can_be_cancelled() {
    SolveServices services = solving_->services();
    services.write_bvh = [](const motion::Clip&, const std::filesystem::path&, const interchange::BvhWriteOptions&,
                            const Progress& progress) -> Status {
      for (int i = 0; progress.report(0.005 * i, "writing"); ++i) {
        QThread::msleep(5);
      }
      return cancelled();
    };
    open(std::move(services));
    QTest::mouseClick(button(QStringLiteral("Export")), Qt::LeftButton);
    QTRY_VERIFY(button(QStringLiteral("Cancel")) != nullptr);
    QTest::mouseClick(button(QStringLiteral("Cancel")), Qt::LeftButton);
    QTRY_VERIFY(says(QStringLiteral("Export cancelled")));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ExportWorkspaceTest)
#include "export_workspace_test.moc"
