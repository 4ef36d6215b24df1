/// The Export workspace over the solve that is open: what it writes, what it refuses, and what it says of both.
#include "workspaces/export/export_workspace.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDesktopServices>
#include <QFileInfo>
#include <QSignalSpy>

#include "interchange/bvh_reader.h"
#include "ui/export/export_fixture.h"
#include "viewer/viewer_widget.h"

namespace limbwave::ui::testing {

using interchange::ExportReport;

class ExportWorkspaceTest : public QObject, protected ExportCase {
  Q_OBJECT

 private:
  void open(SolveServices services) {
    QVERIFY(open_studio(std::move(services)));
    QVERIFY(studio_->open_take());
  }
  void open() { open(solving_->services()); }
  void save(const QString& name) const { studio_->save(name); }
  [[nodiscard]] QString beside(const char* name) const { return studio_->studio->take_folder(QString::fromUtf8(name)); }
  static QByteArray content(const QString& path) {
    QFile read(path);
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
  }

 public Q_SLOTS:
  void remember_url(const QUrl& url) { opened_ = url; }

 private:
  QUrl opened_;

 private Q_SLOTS:
  void init() { set_up(); }
  void cleanup() { tear_down(); }

  void without_a_take_it_says_so() {
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    studio_->studio->window->show_workspace(QStringLiteral("export"));
    QVERIFY(studio_->says("There is nothing to export yet"));
    QVERIFY(studio_->button("Open animation…") != nullptr);
    save(QStringLiteral("export-empty"));
  }

  void the_name_follows_the_format_and_the_format_the_name() {
    open();
    QCOMPARE(studio_->file()->text(), beside("swing.fbx"));
    QVERIFY(studio_->pick("Format", "BVH"));
    QCOMPARE(studio_->file()->text(), beside("swing.bvh"));
    // A name of one's own keeps its stem.
    studio_->type_file(beside("arm.v2.bvh"));
    QVERIFY(studio_->pick("Format", "glTF, binary"));
    QCOMPARE(studio_->file()->text(), beside("arm.v2.glb"));
    // A typed ending is a choice, too.
    studio_->type_file(beside("arm.CSV"));
    QCOMPARE(studio_->find<QComboBox>("Format")->currentData().toString(), QStringLiteral("csv"));
    QCOMPARE(studio_->file()->text(), beside("arm.CSV"));
  }

  void writes_reads_back_and_tells() {
    open();
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY(studio_->pick("Frame rate", "30 "));
    QVERIFY(studio_->pick("Unit of length", "Metres"));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("241 at 30 Hz"));
    QVERIFY(studio_->export_now());
    QVERIFY(studio_->says("Written and read back: swing.bvh"));
    QVERIFY(studio_->says("241 frames at 30 Hz"));
    QVERIFY(studio_->says("Largest difference"));
    QVERIFY(studio_->says("The file exists"));
    save(QStringLiteral("export-done"));
    interchange::BvhReadOptions metres;
    metres.metres_per_unit = 1.0;
    const auto back = interchange::load_bvh(studio_->file()->text().toStdString(), metres);
    QVERIFY(back.ok());
    QCOMPARE(back->frame_rate_hz, 30.0);
    const int upper = back->skeleton.find("upper_arm");
    QVERIFY(upper >= 0);
    QVERIFY(std::abs(back->skeleton.segments[static_cast<std::size_t>(upper)].length - 0.30) < 1e-3);

    QTest::mouseClick(studio_->button("Copy path"), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), beside("swing.bvh"));
    QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "remember_url");
    QTest::mouseClick(studio_->button("Open folder"), Qt::LeftButton);
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    QCOMPARE(opened_.toLocalFile(), QFileInfo(beside("swing.bvh")).path());
  }

  void the_preview_shows_the_files_frames() {
    open();
    ExportPreview& preview = studio_->preview();
    QVERIFY(preview.viewer() != nullptr);
    QVERIFY(studio_->pick("Frame rate", "24 "));
    QVERIFY(studio_->settle());
    studio_->studio->context->time().set_playhead(2.03);  // between frames 48 and 49
    QCOMPARE(preview.frame(), std::size_t{48});
    QVERIFY(studio_->says("Frame 49 of 193"));
    std::vector<body::SegmentPose> expected;
    studio_->studio->model->pose_at(2.0, expected);
    QVERIFY((preview.viewer()->pose()[3].p_WL - expected[3].p_WL).norm() < 1e-4);
    auto* tree = studio_->find<QTreeWidget>("Bones of the file");
    QVERIFY(tree != nullptr);
    const auto length = [&] {
      const auto items = tree->findItems(QStringLiteral("upper_arm"), Qt::MatchExactly | Qt::MatchRecursive);
      return items.size() == 1 ? items.front()->text(1) : QStringLiteral("none");
    };
    QCOMPARE(length(), QStringLiteral("30.0 cm"));
    QVERIFY(studio_->studio->model->change_length(1, 0.4));
    QTRY_COMPARE(length(), QStringLiteral("40.0 cm"));
    QSignalSpy frames(preview.viewer(), &ViewerWidget::frame_rendered);
    studio_->studio->context->time().set_playhead(3.0);
    QVERIFY(frames.wait(5000));
    save(QStringLiteral("export-preview"));
  }

  void the_rest_frame_and_the_root_bone_are_in_the_preview() {
    open();
    QVERIFY(studio_->pick("Preset", "MotionBuilder"));
    QVERIFY(studio_->pick("Frame rate", "30 "));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("242 at 30 Hz"));
    QVERIFY(studio_->says("behind one frame of rest"));
    studio_->studio->context->time().set_playhead(2.0);
    QCOMPARE(studio_->preview().frame(), std::size_t{61});
    const auto& shown = studio_->preview().viewer()->pose();
    std::vector<body::SegmentPose> expected;
    studio_->studio->model->pose_at(2.0, expected);
    QCOMPARE(shown.size(), expected.size() + 1);
    QVERIFY((shown[4].p_WL - expected[3].p_WL).norm() < 1e-4);
    // A bone that is chosen here is chosen everywhere, and the other way round.
    studio_->studio->context->selection().select(SelectionKind::kSegment, 1);
    QCOMPARE(studio_->preview().viewer()->selected(), 2);
    auto* tree = studio_->find<QTreeWidget>("Bones of the file");
    const auto hands = tree->findItems(QStringLiteral("hand"), Qt::MatchContains | Qt::MatchRecursive);
    QVERIFY(!hands.isEmpty());
    tree->setCurrentItem(hands.front());
    QCOMPARE(studio_->studio->context->selection().index_of(SelectionKind::kSegment),
             hands.front()->data(0, Qt::UserRole).toInt() - 1);
    auto* rest = studio_->button("Rest pose");
    QTest::mouseClick(rest, Qt::LeftButton);
    QVERIFY(studio_->says("At rest"));
    auto* box = studio_->studio->window->findChild<QCheckBox*>();
    QVERIFY(box != nullptr && box->isChecked());
    QTest::mouseClick(box, Qt::LeftButton, Qt::NoModifier, QPoint(8, box->height() / 2));
    QVERIFY(!box->isChecked());
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("241 at 30 Hz"));
    QVERIFY(studio_->says("by the T-pose on frame 0"));
  }

  void parts_can_be_exported() {
    open();
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY(studio_->pick("Frame rate", "30 "));
    studio_->studio->context->time().set_visible(2.0, 5.0);
    QVERIFY(studio_->pick("Range", "What the timeline shows"));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("91 at 30 Hz"));
    studio_->studio->context->time().set_playhead(1.0);
    QCOMPARE(studio_->preview().frame(), std::size_t{0});
    QVERIFY(studio_->export_now());
    auto back = interchange::load_bvh(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    std::vector<body::SegmentPose> shown;
    studio_->studio->model->pose_at(3.0, shown);
    auto pose = motion::pose_at(*back, 1.0);
    QVERIFY((pose[3].p_WL - pose[2].p_WL - (shown[3].p_WL - shown[2].p_WL)).norm() < 1e-3);

    // From and to in seconds of the clip; they start as the timeline's.
    QVERIFY(studio_->pick("Range", "From"));
    auto* from = studio_->find<QDoubleSpinBox>("From");
    auto* to = studio_->find<QDoubleSpinBox>("To");
    QVERIFY(from != nullptr && to != nullptr);
    QCOMPARE(from->value(), 2.0);
    QCOMPARE(to->value(), 5.0);
    from->setValue(3.0);
    to->setValue(4.0);
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("31 at 30 Hz"));
    QVERIFY(studio_->export_now());
    back = interchange::load_bvh(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    pose = motion::pose_at(*back, 0.0);
    QVERIFY((pose[3].p_WL - pose[2].p_WL - (shown[3].p_WL - shown[2].p_WL)).norm() < 1e-3);
    to->setValue(2.0);
    QVERIFY(studio_->says("ends before it begins"));
    QVERIFY(!studio_->button("Export")->isEnabled());
  }

  void edits_are_in_the_file() {
    open();
    QVERIFY(studio_->studio->model->change_length(1, 0.4));
    QVERIFY(studio_->studio->model->key_editor().set_value(2, 0.0, 0.5));
    QVERIFY(studio_->export_now());
    const auto back = interchange::load_animation(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    std::vector<body::SegmentPose> shown;
    studio_->studio->model->pose_at(2.0, shown);
    const auto pose = motion::pose_at(back->front(), 2.0);
    QVERIFY(std::abs((pose[2].p_WL - pose[1].p_WL).norm() - 0.4) < 1e-3);
    QVERIFY((pose[3].p_WL - pose[2].p_WL - (shown[3].p_WL - shown[2].p_WL)).norm() < 1e-3);
  }

  void any_rate_can_be_typed() {
    open();
    QVERIFY(studio_->pick("Frame rate", "Another rate"));
    auto* rate = studio_->find<QDoubleSpinBox>("Frames a second");
    QVERIFY(rate != nullptr);
    QCOMPARE(rate->value(), 60.0);  // what the motion has
    rate->setValue(37.5);
    QVERIFY(studio_->export_now());
    QVERIFY(studio_->says("at 37.5 Hz"));
    // One of the list stays "another" while it is typed, and counts as the exact rate.
    rate->setValue(23.976);
    QCOMPARE(studio_->find<QComboBox>("Frame rate")->currentText(), QStringLiteral("Another rate"));
    QVERIFY(studio_->export_now());
    const auto back = interchange::load_animation(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    QVERIFY(std::abs(back->front().frame_rate_hz - 24.0 / 1.001) < 1e-6);
  }

  void keys_are_left_out_within_the_tolerance() {
    open();
    auto* tolerance = studio_->find<QDoubleSpinBox>("Leave out keys within");
    QCOMPARE(tolerance->text(), QStringLiteral("Keep all keys"));
    tolerance->setValue(1.0);
    QVERIFY(studio_->settle());
    const ExportReport report = studio_->model().prepared()->report;
    QVERIFY(report.keys_after < report.keys_before / 2);
    QVERIFY(studio_->says(QStringLiteral(" of %1 (").arg(QLocale().toString(qulonglong(report.keys_before)))));
    QVERIFY(studio_->export_now());
    const auto back = interchange::load_animation(studio_->file()->text().toStdString());
    QVERIFY(back.ok());
    for (const double t : {0.5, 2.0, 6.3}) {
      std::vector<body::SegmentPose> shown;
      studio_->studio->model->pose_at(t, shown);
      const auto pose = motion::pose_at(back->front(), t);
      // Three joints of at most 1° over less than a metre.
      QVERIFY((pose[3].p_WL - shown[3].p_WL).norm() < 0.06);
    }
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY(!tolerance->isEnabled());
  }

  void places_that_cannot_be_written_are_told_before_trying() {
    open();
    studio_->type_file(QStringLiteral("/no/such/folder/arm.fbx"));
    QVERIFY(studio_->says("does not exist"));
    QVERIFY(!studio_->button("Export")->isEnabled());
    save(QStringLiteral("export-problem"));
    studio_->type_file(beside("arm.txt"));
    QVERIFY(studio_->says("must end in .fbx"));
    studio_->type_file(QString());
    QVERIFY(studio_->says("Choose where the file goes"));
    studio_->type_file(beside("arm.fbx"));
    QVERIFY(studio_->button("Export")->isEnabled());
  }

  void a_folder_that_takes_no_files_is_told_and_the_studio_goes_on() {
    open();
    studio_->type_file(QStringLiteral("/proc/arm.fbx"));  // Not even for those who may write everywhere.
    if (studio_->button("Export")->isEnabled()) {
      QVERIFY(!studio_->export_now());
      QVERIFY(studio_->says("Not exported."));
      QVERIFY(studio_->says("/proc/arm.fbx"));
    } else {
      QVERIFY(studio_->says("You may not write into /proc"));
    }
    studio_->type_file(beside("arm.fbx"));
    QVERIFY(studio_->export_now());
  }

  void a_file_that_reads_back_differently_is_no_file() {
    // 32-bit floats cannot say where something 123 km away is to the millimetre: glTF fails, honestly.
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    QVERIFY(write_chain(studio_->path(QStringLiteral("far.bvh")), 123456.789));
    QVERIFY(studio_->open_animation(studio_->studio->folder.filePath(QStringLiteral("far.bvh"))));
    QVERIFY(studio_->pick("Format", "glTF, binary"));
    const QString target = studio_->file()->text();
    QVERIFY(write_file(target.toStdString(), "mine").ok());
    QVERIFY(!studio_->export_now());
    QVERIFY(studio_->says("mm away from where it belongs at frame"));
    QVERIFY(studio_->says("hips"));
    QVERIFY(studio_->says(target));
    QCOMPARE(content(target), QByteArray("mine"));
    QCOMPARE(
        QDir(QFileInfo(target).path()).entryList({QStringLiteral("*.part*")}, QDir::AllEntries | QDir::Hidden).size(),
        0);
    save(QStringLiteral("export-differs"));
  }

  void failures_while_writing_are_told_with_their_remedy() {
    SolveServices services = solving_->services();
    services.export_file = [](std::span<const motion::Clip* const>, const std::filesystem::path& path,
                              const interchange::ExportOptions&, const Progress&) -> Result<ExportReport> {
      return Error{"no space left on the device", path.string(), "free some space or choose another disk"};
    };
    open(std::move(services));
    QVERIFY(!studio_->export_now());
    QVERIFY(studio_->says("No space left on the device"));
    QVERIFY(studio_->says("Free some space"));
    QVERIFY(!QFileInfo::exists(beside("swing.fbx")));
    QVERIFY(studio_->button("Export")->isEnabled());
    save(QStringLiteral("export-failed"));
  }

  void can_be_cancelled() {
    SolveServices services = solving_->services();
    services.export_file = [](std::span<const motion::Clip* const>, const std::filesystem::path&,
                              const interchange::ExportOptions&, const Progress& progress) -> Result<ExportReport> {
      for (int i = 0; progress.report(std::min(0.4, 0.005 * i), "writing"); ++i) {
        QThread::msleep(5);
      }
      return cancelled();
    };
    open(std::move(services));
    QVERIFY(write_file(beside("swing.fbx").toStdString(), "mine").ok());
    studio_->press_export();
    QTRY_VERIFY(studio_->button("Cancel") != nullptr);
    QVERIFY(!studio_->button("Export")->isEnabled());
    QTest::qWait(400);
    save(QStringLiteral("export-running"));
    QTest::mouseClick(studio_->button("Cancel"), Qt::LeftButton);
    QTRY_VERIFY(studio_->says("Export cancelled"));
    QCOMPARE(content(beside("swing.fbx")), QByteArray("mine"));
  }

  void what_is_missing_for_a_program_is_told_before_exporting() {
    open();
    QVERIFY(studio_->pick("Preset", "VRM"));
    QCOMPARE(studio_->find<QComboBox>("Format")->currentData().toString(), QStringLiteral("vrm"));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("needs bones that the skeleton lacks"));
    QVERIFY(!studio_->button("Export")->isEnabled());
    QVERIFY(studio_->pick("Preset", "Maya"));
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY(studio_->says("Maya does not open .bvh files by itself. Choose FBX for it."));
    QVERIFY(studio_->pick("Preset", "Unreal"));
    QVERIFY(studio_->pick("Format", "FBX"));
    QVERIFY(studio_->pick("Body", "None"));
    QVERIFY(studio_->pick("Unit of length", "Metres"));
    QVERIFY(studio_->says("refuses bones without a body"));
    QVERIFY(studio_->says("100 times too small"));
    QVERIFY(studio_->settle());
    save(QStringLiteral("export-warnings"));
  }

  void choices_are_remembered_for_every_preset() {
    open();
    QVERIFY(studio_->pick("Preset", "Unreal"));
    QVERIFY(studio_->pick("Frame rate", "30 "));
    QVERIFY(studio_->pick("Way over the floor", "In place"));
    QVERIFY(studio_->pick("Preset", "Unity"));
    QVERIFY(!studio_->model().choices().fps);
    QVERIFY(!studio_->model().choices().root_motion.has_value());
    QVERIFY(studio_->pick("Frame rate", "24 "));
    QVERIFY(studio_->pick("Preset", "Unreal"));
    QVERIFY(studio_->model().choices().fps == std::optional(30.0));
    QVERIFY(studio_->model().choices().root_motion == motion::RootMotion::kInPlace);
    // Also the next time that the studio is started.
    ExportModel later(*studio_->studio->context, *studio_->studio->model);
    QVERIFY(later.choices() == studio_->model().choices());
  }

  void it_can_be_used_without_a_mouse() {
    open();
    studio_->studio->window->activateWindow();  // Xvfb has no window manager that would do it.
    QVERIFY(QTest::qWaitForWindowActive(studio_->studio->window.get()));
    studio_->find<QComboBox>("Motion")->setFocus();
    QStringList order;
    for (int i = 0; i < 60; ++i) {
      QWidget* here = QApplication::focusWidget();
      QVERIFY(here != nullptr);
      const auto* button = qobject_cast<QAbstractButton*>(here);
      const QString name =
          !here->accessibleName().isEmpty() ? here->accessibleName() : (button != nullptr ? button->text() : QString());
      QVERIFY2(!name.isEmpty(), here->metaObject()->className());  // Everything that is reached says what it is.
      order << name;
      if (button != nullptr && name == QLatin1String("Export") && order.size() > 5) {
        break;
      }
      QTest::keyClick(here, Qt::Key_Tab);
    }
    QStringList wanted{QStringLiteral("Motion"),     QStringLiteral("Preset"),     QStringLiteral("Format"),
                       QStringLiteral("Frame rate"), QStringLiteral("Range"),      QStringLiteral("Way over the floor"),
                       QStringLiteral("Rest pose"),  QStringLiteral("Bone names"), QStringLiteral("Unit of length"),
                       QStringLiteral("Body"),       QStringLiteral("File"),       QStringLiteral("Export")};
    QStringList reached;
    for (const QString& name : order) {
      if (wanted.contains(name) && !reached.contains(name)) {
        reached << name;
      }
    }
    QCOMPARE(reached, wanted);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY(studio_->says("Written and read back"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ExportWorkspaceTest)
#include "export_workspace_test.moc"
