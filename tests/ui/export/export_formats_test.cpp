/// Every format for every program, bodies, several actors, presets of the user's own, and animations that come in.
#include <QFileInfo>
#include <QMenu>
#include <QToolButton>
#include <fstream>

#include "interchange/bone_map.h"
#include "motion/mannequin.h"
#include "motion/transforms.h"
#include "ui/export/export_fixture.h"

namespace limbwave::ui::testing {

class ExportFormatsTest : public QObject, protected ExportCase {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> home_;

  static Result<motion::Clip> read(const QString& file) {
    Result<std::vector<motion::Clip>> clips = interchange::load_animation(file.toStdString());
    return clips ? Result<motion::Clip>(clips->front()) : Result<motion::Clip>(clips.error());
  }
  /// Where a bone of a person is, by its role whatever its name; NaN when it is not there.
  static Eigen::Vector3d place_of(const motion::Clip& clip, const char* role, double time_s) {
    const std::vector<std::string> roles = interchange::roles_of(clip.skeleton);
    const auto found = std::find(roles.begin(), roles.end(), role);
    return found == roles.end()
               ? Eigen::Vector3d::Constant(NAN)
               : Eigen::Vector3d(motion::pose_at(clip, time_s)[static_cast<std::size_t>(found - roles.begin())].p_WL);
  }
  /// Position of a CSV's first row of a segment at a time.
  static Eigen::Vector3d place_in_csv(const QString& file, const std::string& segment, double time_s) {
    std::ifstream lines(file.toStdString());
    std::string line;
    while (std::getline(lines, line)) {
      const QStringList cells = QString::fromStdString(line).split(QLatin1Char(','));
      if (cells.size() == 9 && cells[1].toStdString() == segment && std::abs(cells[0].toDouble() - time_s) < 1e-6) {
        return {cells[6].toDouble(), cells[7].toDouble(), cells[8].toDouble()};
      }
    }
    return Eigen::Vector3d::Constant(NAN);
  }
  void open_motion(const QString& motion) {
    QVERIFY(open_studio(solving_->services()));
    QVERIFY(QFile::copy(motion, studio_->studio->folder.filePath(QFileInfo(motion).fileName())));
    QVERIFY(studio_->open_animation(studio_->studio->folder.filePath(QFileInfo(motion).fileName())));
  }
  /// A mesh of the skeleton's own mannequin in the pose in which meshes are made, as another program would save it.
  static bool write_body(const std::filesystem::path& file, const motion::Clip& clip) {
    motion::Clip still;
    still.skeleton = clip.skeleton;
    still =
        motion::with_rest(std::move(still), interchange::t_pose(clip.skeleton, interchange::roles_of(clip.skeleton)));
    const auto body = motion::mannequin(still.skeleton);
    std::string text;
    for (const Eigen::Vector3f& p : body->positions) {  // z up and facing x to y up and facing z
      text += "v " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " " + std::to_string(p.x()) + "\n";
    }
    for (const auto& t : body->triangles) {
      text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
    }
    return write_file(file, text).ok();
  }
  /// A ball of rings: as many vertices as one likes.
  static bool write_ball(const std::filesystem::path& file, int rings) {
    std::string text;
    for (int r = 0; r <= rings; ++r) {
      for (int s = 0; s < rings; ++s) {
        const double a = M_PI * r / rings, b = 2 * M_PI * s / rings;
        text += "v " + std::to_string(std::sin(a) * std::cos(b)) + " " + std::to_string(1 + std::cos(a)) + " " +
                std::to_string(std::sin(a) * std::sin(b)) + "\n";
      }
    }
    for (int r = 0; r < rings; ++r) {
      for (int s = 0; s < rings; ++s) {
        const int a = r * rings + s + 1, b = r * rings + (s + 1) % rings + 1;
        text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(a + rings) + "\nf " +
                std::to_string(b) + " " + std::to_string(b + rings) + " " + std::to_string(a + rings) + "\n";
      }
    }
    return write_file(file, text).ok();
  }
  void choose_mesh(const QString& file) {
    QVERIFY(studio_->pick("Body", "Your own mesh"));
    ExportChoices choices = studio_->model().choices();
    choices.mesh = file.toStdString();
    studio_->model().change(choices);
  }

 private Q_SLOTS:
  void init() {
    apply_theme(*qApp, ThemeKind::kDark);
    solving_ = std::make_unique<FakeSolving>();
    home_ = std::make_unique<QTemporaryDir>();
    qputenv("LIMBWAVE_HOME", home_->path().toUtf8());
  }
  void cleanup() {
    studio_.reset();
    solving_.reset();
    qunsetenv("LIMBWAVE_HOME");
  }

  void every_format_for_every_program_is_read_back() {
    const QString motion = recorded_motion();
    if (motion.isEmpty()) {
      QSKIP("LIMBWAVE_DATA has no recorded motions");
    }
    open_motion(motion);
    const motion::Clip source = *studio_->model().sources().source()->clip;
    const double time = 0.4;
    const Eigen::Vector3d hand = place_of(source, "leftHand", time), head = place_of(source, "head", time);
    QVERIFY(hand.allFinite() && head.allFinite());
    int written = 0;
    double worst_size = 1.0;
    for (const PresetEntry& entry : std::vector<PresetEntry>(studio_->model().presets())) {
      QVERIFY(entry.preset.has_value());
      QVERIFY(studio_->pick("Preset", preset_title(entry)));
      QVERIFY(studio_->pick("Frame rate", "30 "));
      for (const ExportFormat& format : export_formats()) {
        QVERIFY(studio_->pick("Format", format.title));
        const std::string what = entry.name + " as " + format.id.toStdString();
        studio_->type_file(studio_->studio->folder.filePath(
            QStringLiteral("%1-%2%3").arg(QString::fromStdString(entry.name), format.id, format.extension)));
        QVERIFY2(studio_->settle(), what.c_str());
        QVERIFY2(studio_->model().problem().isEmpty(),
                 (what + ": " + studio_->model().problem().toStdString()).c_str());
        const PreparedExport prepared = *studio_->model().prepared();
        QVERIFY2(studio_->export_now(), what.c_str());
        const QString file = studio_->file()->text();
        ++written;
        const double size = static_cast<double>(QFileInfo(file).size()) / static_cast<double>(prepared.bytes);
        worst_size = std::max({worst_size, size, 1.0 / size});
        if (format.id == QLatin1String("csv")) {
          const std::string name = [&] {
            const auto roles = interchange::roles_of(prepared.clips.front().skeleton);
            const auto found = std::find(roles.begin(), roles.end(), "leftHand");
            return prepared.clips.front().skeleton.segments[static_cast<std::size_t>(found - roles.begin())].name;
          }();
          QVERIFY2((place_in_csv(file, name, time) - hand).norm() < 2e-3, what.c_str());
          continue;
        }
        const Result<motion::Clip> back = read(file);
        QVERIFY2(back.ok(), what.c_str());
        QVERIFY2((place_of(*back, "leftHand", time + prepared.lead_s) - hand).norm() < 2e-3, what.c_str());
        QVERIFY2((place_of(*back, "head", time + prepared.lead_s) - head).norm() < 2e-3, what.c_str());
        QVERIFY2(std::abs(back->frame_rate_hz - 30.0) < 1e-6, what.c_str());
        QVERIFY2(std::abs(back->duration() - prepared.report.duration_s) < 1e-5, what.c_str());
        QVERIFY2(back->meshes.empty() != format.has_frames, what.c_str());
      }
    }
    QCOMPARE(written, 7 * 6);
    QVERIFY2(worst_size < 1.5, std::to_string(worst_size).c_str());
  }

  void the_way_over_the_floor_can_be_taken_out() {
    const QString motion = recorded_motion();
    if (motion.isEmpty()) {
      QSKIP("LIMBWAVE_DATA has no recorded motions");
    }
    open_motion(motion);
    QVERIFY(studio_->pick("Way over the floor", "In place"));
    QVERIFY(studio_->export_now());
    const Result<motion::Clip> back = read(studio_->file()->text());
    QVERIFY(back.ok());
    const Eigen::Vector3d way = place_of(*back, "hips", back->duration()) - place_of(*back, "hips", 0.0);
    QVERIFY(way.head<2>().norm() < 1e-3);
    // So does the preview.
    QVERIFY(studio_->settle());
    const PreparedExport& shown = *studio_->model().prepared();
    std::vector<body::SegmentPose> first, last;
    shown.pose_at(0.0, first);
    shown.pose_at(shown.report.duration_s, last);
    QVERIFY((last.front().p_WL - first.front().p_WL).head<2>().norm() < 1e-3);
  }

  void names_rest_pose_and_preset_can_be_combined() {
    const QString motion = recorded_motion();
    if (motion.isEmpty()) {
      QSKIP("LIMBWAVE_DATA has no recorded motions");
    }
    open_motion(motion);
    QVERIFY(studio_->pick("Bone names", "Unreal"));
    QVERIFY(studio_->pick("Rest pose", "T-pose"));
    QVERIFY(studio_->export_now());
    const Result<motion::Clip> back = read(studio_->file()->text());
    QVERIFY(back.ok());
    QVERIFY(back->skeleton.find("upperarm_l") >= 0);
    const auto rest = motion::rest_poses(back->skeleton);
    const auto at = [&](const char* name) { return rest[static_cast<std::size_t>(back->skeleton.find(name))].p_WL; };
    const Eigen::Vector3d arm = (at("hand_l") - at("upperarm_l")).normalized();
    QVERIFY(std::abs(arm.z()) < 0.02 && std::abs(arm.y()) > 0.99);
  }

  void a_mesh_of_ones_own_is_skinned_and_goes_along() {
    const QString motion = recorded_motion();
    if (motion.isEmpty()) {
      QSKIP("LIMBWAVE_DATA has no recorded motions");
    }
    open_motion(motion);
    const motion::Clip source = *studio_->model().sources().source()->clip;
    const QString body = studio_->studio->folder.filePath(QStringLiteral("Zoë.obj"));
    QVERIFY(write_body(body.toStdString(), source));
    QVERIFY(studio_->pick("Body", "Your own mesh"));
    QVERIFY(studio_->says("Choose the mesh"));
    QVERIFY(!studio_->button("Export")->isEnabled());
    choose_mesh(body);
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("vertices skinned"));
    QVERIFY(studio_->says("Zoë.obj"));
    studio_->save(QStringLiteral("export-own-mesh"));
    const std::size_t vertices = studio_->model().prepared()->vertices;
    QVERIFY(vertices > 500);
    for (const char* format : {"FBX", "glTF, binary"}) {
      QVERIFY(studio_->pick("Format", format));
      QVERIFY(studio_->export_now());
      const Result<motion::Clip> back = read(studio_->file()->text());
      QVERIFY(back.ok());
      QCOMPARE(back->meshes.size(), std::size_t{1});
      const motion::SkinnedMesh& mesh = *back->meshes.front();
      QVERIFY(motion::validate(mesh, back->skeleton).ok());
      QVERIFY(mesh.positions.size() >= vertices);
      // It follows: the mesh's points near the hand are near the hand two seconds on.
      const double time = 2.0;
      const auto moved = motion::deformed(mesh, back->skeleton, motion::pose_at(*back, time));
      const Eigen::Vector3d hand = place_of(*back, "leftHand", time);
      double nearest = 1.0;
      for (const Eigen::Vector3f& p : moved) {
        nearest = std::min(nearest, (p.cast<double>() - hand).norm());
      }
      QVERIFY2(nearest < 0.06, std::to_string(nearest).c_str());
    }
    // What is no mesh is told in one line, and nothing is exported.
    const QString broken = studio_->studio->folder.filePath(QStringLiteral("broken.obj"));
    QVERIFY(write_file(broken.toStdString(), "v 1 2\nf nonsense").ok());
    choose_mesh(broken);
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("broken.obj"));
    QVERIFY(!studio_->button("Export")->isEnabled());
  }

  void skinning_can_be_stopped_and_taken_up() {
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    QVERIFY(studio_->open_take());
    const QString ball = studio_->studio->folder.filePath(QStringLiteral("ball.obj"));
    QVERIFY(write_ball(ball.toStdString(), 150));  // 22 650 vertices
    choose_mesh(ball);
    QTRY_VERIFY(studio_->button("Stop") != nullptr);
    QTest::mouseClick(studio_->button("Stop"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(studio_->says("Skinning was stopped"), 30000);
    QVERIFY(!studio_->says("Problem"));
    QTest::mouseClick(studio_->button("Skin it"), Qt::LeftButton);
    QTest::qWait(400);
    studio_->save(QStringLiteral("export-skinning"));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("vertices skinned"));
    QVERIFY(studio_->pick("Way over the floor", "In place"));
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("vertices skinned"));
  }

  void several_actors_go_into_one_file() {
    QVERIFY(open_studio(solving_->services()));
    for (const char* name : {"a.bvh", "b.bvh"}) {
      QVERIFY(write_chain(studio_->path(QString::fromLatin1(name)), name[0] == 'a' ? 0.0 : 1.0));
    }
    QVERIFY(studio_->open_animation(studio_->studio->folder.filePath(QStringLiteral("a.bvh"))));
    studio_->model().sources().open_animation(studio_->studio->folder.filePath(QStringLiteral("b.bvh")), true);
    QTRY_COMPARE(studio_->model().sources().others().size(), std::size_t{1});
    QVERIFY(studio_->settle());
    QVERIFY(studio_->says("Other actors") || studio_->find<QWidget>("Other actors") != nullptr);
    QCOMPARE(studio_->model().prepared()->report.actors, std::size_t{2});
    studio_->save(QStringLiteral("export-actors"));
    QVERIFY(studio_->export_now());
    const auto both = interchange::load_animation(studio_->file()->text().toStdString());
    QVERIFY(both.ok());
    QCOMPARE(both->size(), std::size_t{2});
    const double apart = (motion::pose_at((*both)[0], 0.3)[0].p_WL - motion::pose_at((*both)[1], 0.3)[0].p_WL).norm();
    QVERIFY2(std::abs(apart - 1.0) < 1e-3, std::to_string(apart).c_str());
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY(studio_->says("holds one actor"));
    QVERIFY(!studio_->button("Export")->isEnabled());
    QTest::mouseClick(studio_->button("Remove"), Qt::LeftButton);
    QVERIFY(studio_->settle());
    QVERIFY(studio_->export_now());
  }

  void presets_and_names_of_ones_own_are_offered() {
    std::filesystem::create_directories(home_->filePath(QStringLiteral("presets")).toStdString());
    std::filesystem::create_directories(home_->filePath(QStringLiteral("bone_maps")).toStdString());
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    QVERIFY(studio_->open_take());
    QVERIFY(!studio_->pick("Preset", "Our rig"));
    // Files that come while the studio runs are there after reading again.
    QVERIFY(
        write_file(home_->filePath(QStringLiteral("bone_maps/house.json")).toStdString(),
                   R"({"schema": 1, "name": "house", "title": "House names", "bones": {"rightUpperArm": "OBERARM"}})")
            .ok());
    QVERIFY(write_file(home_->filePath(QStringLiteral("presets/ours.json")).toStdString(),
                       R"({"schema": 1, "name": "ours", "title": "Our rig", "comment": "As we like it.",
                           "bone_map": "house", "rest_frame": true, "unit": "m"})")
                .ok());
    QVERIFY(write_file(home_->filePath(QStringLiteral("presets/broken.json")).toStdString(),
                       R"({"schema": 1, "name": "broken", "unit": "ell"})")
                .ok());
    for (QToolButton* menu : studio_->studio->window->findChildren<QToolButton*>()) {
      if (menu->accessibleName() == QLatin1String("Your own presets and bone names")) {
        menu->menu()->actions().last()->trigger();
      }
    }
    QVERIFY(studio_->pick("Preset", "Our rig (your own)"));
    QVERIFY(studio_->says("As we like it."));
    QVERIFY(studio_->says("Bones are named as in House names."));
    QVERIFY(studio_->says("Lengths are in metres."));
    QVERIFY(studio_->pick("Bone names", "House names"));
    QVERIFY(studio_->export_now());
    QVERIFY(studio_->pick("Preset", "broken"));
    QVERIFY(studio_->says("broken.json"));
    QVERIFY(studio_->says("unit"));
    QVERIFY(!studio_->button("Export")->isEnabled());
    studio_->save(QStringLiteral("export-broken-preset"));
  }

  void animations_come_in_by_dropping_them() {
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    auto& window = *studio_->studio->window;
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QCOMPARE(window.current_workspace(), QStringLiteral("welcome"));
    QVERIFY(write_chain(studio_->path(QStringLiteral("chain.BVH")), 0.0, 91));
    QVERIFY(studio_->open_animation(studio_->studio->folder.filePath(QStringLiteral("chain.BVH"))));
    QCOMPARE(window.current_workspace(), QStringLiteral("export"));
    // The timeline is the animation's.
    const TimeModel& time = studio_->studio->context->time();
    QVERIFY(std::abs(time.duration_s() - 3.0) < 1e-3);
    QVERIFY(studio_->says("91 at 30 Hz"));
    QCOMPARE(studio_->file()->text(), studio_->studio->folder.filePath(QStringLiteral("chain.fbx")));
    // The file that is read is never the one that is written.
    QVERIFY(studio_->pick("Format", "BVH"));
    studio_->type_file(studio_->studio->folder.filePath(QStringLiteral("chain.BVH")));
    QVERIFY(studio_->says("This is the file that is being exported"));
    studio_->type_file(studio_->studio->folder.filePath(QStringLiteral("copy.bvh")));
    QVERIFY(studio_->export_now());
    // Every format that is written is read again.
    for (const char* format : {"FBX", "glTF, binary", "glTF, text"}) {
      QVERIFY(studio_->pick("Format", format));
      QVERIFY(studio_->export_now());
      const QString file = studio_->file()->text();
      ExportStudio other(solving_->services());
      QVERIFY(other.open_animation(file));
      QVERIFY(other.says("91 at 30 Hz"));
      QCOMPARE(other.model().prepared()->report.bones, std::size_t{3});
    }
  }

  void broken_animations_are_told_in_one_located_line() {
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    QVERIFY(write_file(studio_->path(QStringLiteral("cut.bvh")), "HIERARCHY\nROOT hips\n{\n OFFSET 0 zero 0\n").ok());
    studio_->drop(studio_->studio->folder.filePath(QStringLiteral("cut.bvh")));
    QTRY_VERIFY(!studio_->studio->context->notifications().all().empty());
    const Notification told = studio_->studio->context->notifications().all().front();
    QVERIFY(told.text.contains(QStringLiteral("cut.bvh:4")));
    QVERIFY(!told.text.contains(QLatin1Char('\n')));
    QVERIFY(studio_->says("There is nothing to export yet"));
    studio_->save(QStringLiteral("export-broken-animation"));
  }

  void the_open_take_stays_beside_an_animation() {
    studio_ = std::make_unique<ExportStudio>(solving_->services());
    QVERIFY(studio_->open_take());
    QVERIFY(write_chain(studio_->path(QStringLiteral("chain.bvh")), 0.0, 31));
    QVERIFY(studio_->open_animation(studio_->studio->folder.filePath(QStringLiteral("chain.bvh"))));
    const TimeModel& time = studio_->studio->context->time();
    QVERIFY(std::abs(time.duration_s() - 1.0) < 1e-3);
    // Solve has its own time again.
    studio_->studio->window->show_workspace(QStringLiteral("solve"));
    QVERIFY(std::abs(time.duration_s() - 8.0) < 1e-3);
    studio_->studio->window->show_workspace(QStringLiteral("export"));
    QVERIFY(std::abs(time.duration_s() - 1.0) < 1e-3);
    QVERIFY(studio_->pick("Motion", "swing"));
    QVERIFY(std::abs(time.duration_s() - 8.0) < 1e-3);
    QCOMPARE(studio_->file()->text(), studio_->studio->take_folder(QStringLiteral("swing.fbx")));
    QVERIFY(studio_->export_now());
    QVERIFY(studio_->says("481 frames at 60 Hz"));
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ExportFormatsTest)
#include "export_formats_test.moc"
