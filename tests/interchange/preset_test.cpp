#include "interchange/preset.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "interchange/bone_map.h"
#include "interchange/bvh_reader.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;
using motion::Clip;

// Names as CMU's BVH files have them; a person of eleven segments who stands with legs and arms spread, facing +y.
Clip person() {
  struct Bone {
    const char* name;
    int parent;
    Vector3d offset;
  };
  const Bone bones[] = {{"Hips", -1, {0, 0, 1}},
                        {"LeftUpLeg", 0, {-0.1, 0, 0}},
                        {"LeftLeg", 1, {-0.1, 0, -0.4}},
                        {"LeftFoot", 2, {-0.05, 0, -0.4}},
                        {"RightUpLeg", 0, {0.1, 0, 0}},
                        {"RightLeg", 4, {0.1, 0, -0.4}},
                        {"RightFoot", 5, {0.05, 0, -0.4}},
                        {"LowerBack", 0, {0, 0, 0.2}},
                        {"Spine", 7, {0, 0, 0.2}},
                        {"Head", 8, {0, 0, 0.3}},
                        {"LeftArm", 8, {-0.2, 0, 0.1}},
                        {"LeftForeArm", 10, {-0.2, 0, -0.2}},
                        {"LeftHand", 11, {-0.2, 0, -0.15}},
                        {"RightArm", 8, {0.2, 0, 0.1}},
                        {"RightForeArm", 13, {0.2, 0, -0.2}},
                        {"RightHand", 14, {0.2, 0, -0.15}},
                        {"Tail", 0, {0, -0.2, 0}}};
  Clip clip;
  clip.name = "person";
  clip.frame_rate_hz = 30.0;
  for (const Bone& bone : bones) {
    body::Segment segment;
    segment.name = bone.name;
    segment.parent = bone.parent;
    segment.p_PL = bone.offset;
    segment.length = 0.0;
    clip.skeleton.segments.push_back(segment);
  }
  clip.joints.resize(clip.skeleton.segments.size());
  clip.joints[8].rotation = {
      {0.0, 1.0},
      {Eigen::Quaterniond::Identity(), Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 1, 0).normalized()))}};
  clip.root_position = {{0.0, 1.0}, {Vector3d(0, 0, 1), Vector3d(1, 2, 0.9)}};
  return clip;
}

Vector3d at_rest(const Clip& clip, const std::string& bone) {
  return motion::rest_poses(clip.skeleton)[static_cast<std::size_t>(clip.skeleton.find(bone))].p_WL;
}

TEST(BoneMap, EveryShippedOneIsReadAndCoversAPerson) {
  const std::vector<std::string> names = bone_map_names();
  EXPECT_GE(names.size(), 7U);
  for (const std::string& name : names) {
    const Result<BoneMap> map = load_bone_map(name);
    ASSERT_TRUE(map.ok()) << map.error().text();
    EXPECT_EQ(map->name, name);
    for (const char* role : {"hips", "spine", "head", "leftUpperArm", "rightHand", "leftFoot"}) {
      EXPECT_TRUE(name == "limbwave" || map->bones.contains(role)) << name << " " << role;
    }
  }
}

TEST(BoneMap, RolesAreFoundWhateverTheSpelling) {
  body::Skeleton skeleton;
  for (const char* name :
       {"mixamorig:Hips", "mixamorig:LeftArm", "mixamorig:LeftForeArm", "MIXAMORIG:RIGHT_ARM", "Tail"}) {
    body::Segment segment;
    segment.name = name;
    skeleton.segments.push_back(segment);
  }
  EXPECT_EQ(roles_of(skeleton),
            (std::vector<std::string>{"hips", "leftUpperArm", "leftLowerArm", "rightUpperArm", ""}));
}

TEST(BoneMap, AUsersFileCountsAndMistakesAreNamed) {
  const test::TemporaryFolder home;
  ::setenv("LIMBWAVE_HOME", home.path().c_str(), 1);
  std::filesystem::create_directories(home / "bone_maps");
  ASSERT_TRUE(write_file(home / "bone_maps/mine.json", R"({"schema":1,"name":"mine","bones":{"hips":"Becken"}})").ok());
  EXPECT_EQ(load_bone_map("mine")->bones.at("hips"), "Becken");
  ASSERT_TRUE(write_file(home / "bone_maps/mine.json", R"({"schema":1,"name":"mine","bones":{"hip":"Becken"}})").ok());
  EXPECT_NE(load_bone_map("mine").error().text().find("/bones/hip: is no bone of a person"), std::string::npos)
      << load_bone_map("mine").error().text();
  ASSERT_TRUE(
      write_file(home / "bone_maps/mine.json", R"({"schema":1,"name":"mine","bones":{"hips":"A","head":"a"}})").ok());
  EXPECT_FALSE(load_bone_map("mine").ok());
  EXPECT_FALSE(load_bone_map("nowhere").ok());
  ::unsetenv("LIMBWAVE_HOME");
}

TEST(TPose, ArmsToTheSidesLegsDownFacingX) {
  const Clip clip = person();
  Clip posed = motion::with_rest(clip, t_pose(clip.skeleton, roles_of(clip.skeleton)));
  const Vector3d arm = at_rest(posed, "LeftHand") - at_rest(posed, "LeftArm");
  EXPECT_NEAR(arm.normalized().y(), 1.0, 1e-9);
  EXPECT_NEAR((at_rest(posed, "RightForeArm") - at_rest(posed, "RightArm")).normalized().y(), -1.0, 1e-9);
  EXPECT_NEAR((at_rest(posed, "LeftFoot") - at_rest(posed, "LeftUpLeg")).normalized().z(), -1.0, 1e-9);
  EXPECT_GT(at_rest(posed, "LeftUpLeg").y(), at_rest(posed, "RightUpLeg").y());
  EXPECT_NEAR((at_rest(posed, "Tail") - at_rest(posed, "Hips")).normalized().x(), -1.0, 1e-9);
}

TEST(Preset, EveryShippedOneKeepsTheMovement) {
  const Clip clip = person();
  EXPECT_GE(preset_names().size(), 7U);
  EXPECT_EQ(preset_names().front(), "plain");
  for (const std::string& name : preset_names()) {
    SCOPED_TRACE(name);
    const Result<Preset> preset = load_preset(name);
    ASSERT_TRUE(preset.ok()) << preset.error().text();
    const Result<Clip> out = arranged(clip, *preset);
    ASSERT_TRUE(out.ok()) << out.error().text();
    const std::size_t first = preset->root_bone.empty() ? 0 : 1;
    const double shift = preset->rest_frame ? 1.0 / 30.0 : 0.0;
    ASSERT_EQ(out->skeleton.segments.size(), clip.skeleton.segments.size() + first);
    for (const double t : {0.0, 0.3, 1.0}) {
      const auto a = motion::pose_at(clip, t);
      const auto b = motion::pose_at(*out, t + shift + 1e-9);
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((a[i].p_WL - b[i + first].p_WL).norm(), 1e-6) << clip.skeleton.segments[i].name << " at " << t;
      }
    }
  }
}

TEST(Preset, NamesBonesAsTheProgramDoes) {
  const Clip unreal = *arranged(person(), *load_preset("unreal"));
  EXPECT_EQ(unreal.skeleton.segments[0].name, "root");
  EXPECT_GE(unreal.skeleton.find("upperarm_l"), 0);
  EXPECT_GE(unreal.skeleton.find("Tail"), 0);
  // The root walks, the hips stay over it.
  EXPECT_LT((motion::pose_at(unreal, 1.0)[0].p_WL - Vector3d(1, 2, 0)).norm(), 1e-9);
  const Clip blender = *arranged(person(), *load_preset("blender"));
  EXPECT_GE(blender.skeleton.find("upper_arm.L"), 0);
}

TEST(Preset, VrmStandsOnTheFloorInATPoseAndNamesMissingBones) {
  const Preset vrm = *load_preset("vrm");
  const Clip out = *arranged(person(), vrm);
  EXPECT_NEAR(motion::lowest_point_at_rest(out.skeleton), 0.0, 1e-9);
  Clip armless = person();
  armless.skeleton.segments[12].name = "Hook";
  const Result<Clip> refused = arranged(armless, vrm);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().message, "VRM 1.0 needs bones that the skeleton lacks: leftHand");
}

TEST(Preset, MistakesInAFileAreNamed) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "p.json").string();
  ASSERT_TRUE(write_file(file, R"({"schema":1,"name":"p","rest":"a-pose"})").ok());
  EXPECT_NE(load_preset(file).error().text().find("use one of as-is, t-pose"), std::string::npos);
  ASSERT_TRUE(write_file(file, R"({"schema":1,"name":"p","root_motion":"on-root"})").ok());
  EXPECT_FALSE(load_preset(file).ok());
  ASSERT_TRUE(write_file(file, R"({"schema":1,"name":"p","colour":"red"})").ok());
  EXPECT_FALSE(load_preset(file).ok());
}

}  // namespace
}  // namespace limbwave::interchange
