#include "interchange/animation_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "interchange/export_file.h"
#include "interchange/gltf_clip.h"
#include "interchange/mesh_file.h"
#include "interchange/random_clip.h"
#include "motion/mannequin.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using motion::Clip;

TEST(AnimationFile, ReadsEveryFormatThatIsWrittenWhateverTheCaseOfItsEnding) {
  const test::TemporaryFolder folder;
  const Clip clip = test::random_clip(8, 20, 30.0, 3);
  const Clip* clips[] = {&clip};
  for (const char* ending : {".fbx", ".glb", ".gltf", ".bvh", ".vrm"}) {
    const std::filesystem::path file = folder.path() / (std::string("one") + ending);
    ASSERT_TRUE(export_file(clips, file).ok()) << ending;
    std::string loud = ending;
    for (char& c : loud) {
      c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    const std::filesystem::path other = folder.path() / ("OTHER" + loud);
    std::filesystem::rename(file, other);
    EXPECT_TRUE(is_animation_file(other));
    const auto read = load_animation(other);
    ASSERT_TRUE(read.ok()) << read.error().text();
    ASSERT_EQ(read->size(), 1U) << ending;
    EXPECT_EQ(read->front().skeleton.segments.size(), 8U);
    EXPECT_FALSE(read->front().name.empty());
  }
}

TEST(AnimationFile, ATakesOwnSolveComesBackExactly) {
  const test::TemporaryFolder folder;
  const Clip clip = test::random_clip(5, 30, 61.7, 9);
  ASSERT_TRUE(write_glb(clip, folder.path() / "clip.glb").ok());
  const auto read = load_animation(folder.path() / "clip.glb");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->front().frame_rate_hz, 61.7);
  EXPECT_EQ(read->front().joints[1].rotation.times, clip.joints[1].rotation.times);
}

TEST(AnimationFile, RefusesOthersInOneLocatedLine) {
  const test::TemporaryFolder folder;
  const auto refuse = [&](const char* name, std::string_view text) {
    EXPECT_TRUE(write_file(folder.path() / name, text).ok());
    const auto read = load_animation(folder.path() / name);
    EXPECT_FALSE(read.ok()) << name;
    const std::string line = read.ok() ? "" : read.error().text();
    EXPECT_NE(line.find(name), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  };
  EXPECT_FALSE(is_animation_file("walk.wav"));
  refuse("walk.wav", "RIFF");
  refuse("walk.bvh", "HIERARCHY\nnothing");
  refuse("walk.glb", "glTF");
  refuse("walk.gltf", "{}");
  refuse("walk.fbx", "Kaydara FBX Binary");
  EXPECT_FALSE(load_animation(folder.path() / "missing.bvh").ok());
}

TEST(MeshFile, SkinsAFileToASkeletonAndCanBeStopped) {
  const test::TemporaryFolder folder;
  const Clip clip = test::random_clip(4, 5, 30.0, 1);
  const auto body = motion::mannequin(clip.skeleton);
  std::string text;
  for (const Eigen::Vector3f& p : body->positions) {
    text += "v " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " " + std::to_string(p.x()) + "\n";
  }
  for (const auto& t : body->triangles) {
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  }
  const std::filesystem::path file = folder.path() / "body.obj";
  ASSERT_TRUE(write_file(file, text).ok());
  const auto mesh = skinned_mesh_file(file, clip);
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_TRUE(motion::validate(**mesh, clip.skeleton).ok());
  EXPECT_GT((*mesh)->positions.size(), 50U);
  for (const double stop_at : {0.0, 0.3, 0.7}) {
    const auto stopped =
        skinned_mesh_file(file, clip, Progress([&](double fraction, std::string_view) { return fraction < stop_at; }));
    ASSERT_FALSE(stopped.ok());
    EXPECT_TRUE(is_cancelled(stopped.error()));
  }
  EXPECT_FALSE(skinned_mesh_file(folder.path() / "missing.obj", clip).ok());
}

TEST(MeshFile, AGltfWithItsNumbersInAFileBesideItIsReadFromAnywhere) {
  const test::TemporaryFolder folder;
  const float positions[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::uint16_t triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string bytes(reinterpret_cast<const char*>(positions), sizeof positions);
  bytes.append(reinterpret_cast<const char*>(triangles), sizeof triangles);
  ASSERT_TRUE(write_file(folder.path() / "numbers.bin", bytes).ok());
  ASSERT_TRUE(write_file(folder.path() / "mesh.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
      "buffers": [{"uri": "numbers.bin", "byteLength": 72}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                    {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]})")
                  .ok());
  const auto mesh = load_mesh(folder.path() / "mesh.gltf");
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_EQ(mesh->positions.size(), 4U);
  EXPECT_EQ(mesh->triangles.size(), 4U);
  std::filesystem::remove(folder.path() / "numbers.bin");
  EXPECT_FALSE(load_mesh(folder.path() / "mesh.gltf").ok());
  ASSERT_TRUE(write_file(folder.path() / "empty.obj", "").ok());
  EXPECT_FALSE(load_mesh(folder.path() / "empty.obj").ok());
}

}  // namespace
}  // namespace limbwave::interchange
