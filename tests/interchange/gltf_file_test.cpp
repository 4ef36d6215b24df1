#include "interchange/gltf_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/files.h"
#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;
using motion::Clip;

Clip skinned(unsigned seed) {
  Clip clip = test::random_clip(12, 50, 60.0, seed);
  clip.meshes = {test::tetrahedra(clip, seed)};
  return clip;
}

Clip written_and_read(const Clip& clip, const char* name = "x.glb") {
  const test::TemporaryFolder folder;
  const Clip* clips[] = {&clip};
  const Status written = write_gltf(clips, folder / name);
  EXPECT_TRUE(written.ok()) << written.error().text();
  Diagnostics findings;
  const Result<std::vector<Clip>> read = load_gltf(folder / name, &findings);
  EXPECT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(findings.empty()) << findings.front().text();
  return read.ok() && read->size() == 1 ? read->front() : Clip();
}

void expect_same_motion(const Clip& a, const Clip& b, double most_m = 1e-5, double most_deg = 1e-3) {
  ASSERT_EQ(a.skeleton.segments.size(), b.skeleton.segments.size());
  for (const double t : motion::key_times(a)) {
    const auto pose_a = motion::pose_at(a, t);
    const auto pose_b = motion::pose_at(b, static_cast<double>(static_cast<float>(t)));
    for (std::size_t i = 0; i < pose_a.size(); ++i) {
      const int found = b.skeleton.find(a.skeleton.segments[i].name);
      ASSERT_GE(found, 0) << a.skeleton.segments[i].name;
      const auto j = static_cast<std::size_t>(found);
      ASSERT_LT((pose_a[i].p_WL - pose_b[j].p_WL).norm(), most_m) << a.skeleton.segments[i].name << " at " << t;
      ASSERT_LT(degrees(geometry::geodesic_angle(pose_a[i].R_WL, pose_b[j].R_WL)), most_deg)
          << a.skeleton.segments[i].name << " at " << t;
    }
  }
}

TEST(GltfFile, KeepsEveryJointAtEveryKeyInBothForms) {
  const Clip clip = skinned(4);
  for (const char* name : {"x.glb", "x.gltf"}) {
    const Clip read = written_and_read(clip, name);
    expect_same_motion(clip, read);
    EXPECT_EQ(read.frame_rate_hz, 60.0);
    EXPECT_EQ(read.name, "random");
  }
}

TEST(GltfFile, MeshesMoveAsTheyDid) {
  const Clip clip = skinned(9);
  const Clip read = written_and_read(clip);
  ASSERT_EQ(read.meshes.size(), 1U);
  EXPECT_EQ(read.meshes[0]->name, "body");
  EXPECT_EQ(read.meshes[0]->triangles, clip.meshes[0]->triangles);
  for (const double t : {0.0, 0.4, 0.8}) {
    const auto a = motion::deformed(*clip.meshes[0], clip.skeleton, motion::pose_at(clip, t));
    const auto b = motion::deformed(*read.meshes[0], read.skeleton, motion::pose_at(read, t));
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t v = 0; v < a.size(); ++v) {
      EXPECT_LT((a[v] - b[v]).norm(), 1e-4F) << v;
    }
  }
}

TEST(GltfFile, CurvesStayTheCurvesTheyWere) {
  Clip clip = test::random_clip(3, 6, 4.0, 2);  // keys a quarter of a second apart, far turns between them
  for (motion::JointTracks& joint : clip.joints) {
    joint.rotation.interpolation = motion::Interpolation::kCubic;
  }
  clip.root_position.interpolation = motion::Interpolation::kCubic;
  clip.meshes = {test::tetrahedra(clip, 1)};
  const Clip read = written_and_read(clip);
  EXPECT_EQ(read.joints[1].rotation.interpolation, motion::Interpolation::kCubic);
  for (double t = 0.0; t < clip.duration(); t += 0.01) {
    const auto a = motion::pose_at(clip, t);
    const auto b = motion::pose_at(read, t);
    for (std::size_t i = 0; i < a.size(); ++i) {
      // Halved until component curves are within 0.01° of ours; ours come back from their velocities.
      EXPECT_LT(degrees(geometry::geodesic_angle(a[i].R_WL, b[i].R_WL)), 0.05) << i << " at " << t;
    }
    EXPECT_LT((a[0].p_WL - b[0].p_WL).norm(), 1e-5) << t;
  }
}

TEST(GltfFile, StepsAndMixedTracksArrive) {
  Clip clip = test::random_clip(3, 5, 2.0, 6);
  clip.meshes = {test::tetrahedra(clip, 1)};
  using motion::Interpolation;
  clip.joints[1].rotation.interpolation = Interpolation::kStep;
  clip.joints[2].rotation.key_interpolation = {Interpolation::kStep, Interpolation::kLinear, Interpolation::kCubic,
                                               Interpolation::kStep, Interpolation::kLinear};
  clip.frame_rate_hz = 120.0;
  const Clip read = written_and_read(clip);
  EXPECT_EQ(read.joints[1].rotation.interpolation, Interpolation::kStep);
  for (double t = 0.003; t < clip.duration(); t += 0.01) {
    for (std::size_t i = 1; i < 3; ++i) {
      const double off = geometry::geodesic_angle(motion::sample(clip.joints[i].rotation, t),
                                                  motion::sample(read.joints[i].rotation, t));
      EXPECT_LT(degrees(off), 0.3) << i << " at " << t;
    }
  }
}

TEST(GltfFile, SeveralActorsStaySeparate) {
  const Clip a = skinned(1);
  Clip b = skinned(2);
  b.root_position = {};
  const test::TemporaryFolder folder;
  const Clip* clips[] = {&a, &b};
  ASSERT_TRUE(write_gltf(clips, folder / "two.glb").ok());
  const auto read = load_gltf(folder / "two.glb");
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_EQ(read->size(), 2U);
  expect_same_motion(a, (*read)[0]);
  EXPECT_EQ((*read)[1].skeleton.segments[0].name, "joint0_2");
  EXPECT_EQ((*read)[1].meshes.size(), 1U);
  EXPECT_LT((motion::pose_at((*read)[1], 0.5)[0].p_WL - motion::pose_at(b, 0.5)[0].p_WL).norm(), 1e-5);
}

TEST(GltfFile, SlidingJointsAndOddNamesArrive) {
  Clip clip = test::random_clip(4, 20, 30.0, 3);
  clip.skeleton.segments[1].name = "Oberarm links äöü";
  clip.skeleton.segments[2].name = "a\"b\\c";
  motion::PositionTrack& slides = clip.joints[2].position;
  for (int f = 0; f < 20; ++f) {
    slides.times.push_back(f / 30.0);
    slides.values.push_back(Vector3d(0.1 + 0.01 * f, 0.2, 0.0));
  }
  clip.meshes = {test::tetrahedra(clip, 3)};
  const Clip read = written_and_read(clip);
  EXPECT_FALSE(read.joints[2].position.empty());
  EXPECT_TRUE(read.joints[3].position.empty());
  expect_same_motion(clip, read);
}

TEST(GltfFile, ASingleFrameAndAClipWithoutKeys) {
  const Clip one = test::random_clip(5, 1, 60.0, 3);
  expect_same_motion(one, written_and_read(one));
  Clip none = test::random_clip(5, 1, 60.0, 3);
  none.joints.assign(5, {});
  none.root_position = {};
  const Clip read = written_and_read(none);
  EXPECT_EQ(read.duration(), 0.0);
  const int last = read.skeleton.find("joint4");
  ASSERT_GE(last, 0);
  EXPECT_LT(
      (motion::pose_at(none, 0.0)[4].p_WL - motion::pose_at(read, 0.0)[static_cast<std::size_t>(last)].p_WL).norm(),
      1e-6);
}

TEST(GltfFile, VrmNamesTheBones) {
  Clip clip = test::random_clip(2, 3, 60.0, 3);
  clip.skeleton.segments[0].name = "hips";
  clip.skeleton.segments[1].name = "spine";
  const test::TemporaryFolder folder;
  const Clip* clips[] = {&clip};
  ASSERT_TRUE(write_gltf(clips, folder / "x.vrm", {.vrm = true}).ok());
  const std::string bytes = *read_file(folder / "x.vrm");
  EXPECT_NE(bytes.find(R"("spine":{"node":1})"), std::string::npos) << bytes.substr(0, 3000);
  EXPECT_TRUE(load_gltf(folder / "x.vrm").ok());
}

TEST(GltfFile, RefusesToWriteWhatIsNotValidAndLeavesNothing) {
  Clip clip = skinned(3);
  clip.joints[2].rotation.times[3] = clip.joints[2].rotation.times[2];
  const test::TemporaryFolder folder;
  const Clip* clips[] = {&clip};
  EXPECT_FALSE(write_gltf(clips, folder / "x.glb").ok());
  EXPECT_FALSE(write_gltf({}, folder / "x.glb").ok());
  const Clip good = skinned(3);
  const Clip* fine[] = {&good};
  const Status stopped =
      write_gltf(fine, folder / "x.glb", {}, Progress([](double, std::string_view) { return false; }));
  ASSERT_FALSE(stopped.ok());
  EXPECT_TRUE(is_cancelled(stopped.error()));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// A skeleton under an armature node that turns Z up into Y up and centimetres into metres, as Blender writes it, with a
// matrix on one node.
constexpr const char* kArmature = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
 "nodes":[{"name":"Armature","children":[1],"scale":[0.01,0.01,0.01],"rotation":[-0.7071067811865475,0,0,0.7071067811865476]},
          {"name":"hips","children":[2],"translation":[0,0,100]},
          {"name":"chest","matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 10,0,50,1]}],
 "skins":[{"joints":[1,2]}]})";

TEST(GltfFile, WhatStandsAboveTheBonesIsFoldedIn) {
  const auto read = read_gltf(kArmature, "test");
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_EQ(read->size(), 1U);
  const Clip& clip = read->front();
  ASSERT_EQ(clip.skeleton.segments.size(), 2U);
  const auto rest = motion::rest_poses(clip.skeleton);
  // File: hips at (0, 1, 0); chest 0.5 m above and 0.1 m along x, which is our y.
  EXPECT_LT((rest[0].p_WL - Vector3d(0, 0, 1)).norm(), 1e-9);
  EXPECT_LT((rest[1].p_WL - Vector3d(0, 0.1, 1.5)).norm(), 1e-9);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(GltfFile, BrokenFilesGiveOneLocatedLine) {
  const auto refused = [](const std::string& bytes) {
    const auto read = read_gltf(bytes, "x.gltf");
    EXPECT_FALSE(read.ok()) << bytes.substr(0, 200);
    const std::string text = read.ok() ? "" : read.error().text();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(text.rfind("x.gltf", 0), 0U) << text;
    return text;
  };
  EXPECT_NE(refused(changed(kArmature, R"("hips","children":[2])", R"("hips","children":[0])")).find("ancestor"),
            std::string::npos);
  EXPECT_NE(refused(changed(kArmature, R"("hips","children":[2])", R"("hips","children":[9])")).find("/nodes/1"),
            std::string::npos);
  EXPECT_NE(refused(changed(kArmature, R"("joints":[1,2])", R"("joints":[1,7])")).find("/skins/0"), std::string::npos);
  refused(changed(kArmature, "0,0,1,0, 10,0,50,1", "0,0,0,0, 10,0,50,1"));
  refused("");
  refused("{");
  refused("glTF");
  refused(std::string(100000, '['));
  refused(R"({"asset":{"version":"2.0"}})");
  // Every prefix of a real file, and every byte of its JSON changed once.
  const test::TemporaryFolder folder;
  const Clip clip = test::random_clip(3, 4, 60.0, 1);
  const Clip* clips[] = {&clip};
  ASSERT_TRUE(write_gltf(clips, folder / "x.glb").ok());
  const std::string bytes = *read_file(folder / "x.glb");
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    refused(bytes.substr(0, size));
  }
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    const auto read = read_gltf(damaged, "x.gltf");  // may still be readable; must not crash
    EXPECT_TRUE(read.ok() || read.error().text().find('\n') == std::string::npos);
  }
}

// One joint that turns; what the tests below change.
std::string turning(const std::string& times = "0,1", const std::string& values = "0,0,0,1,0,0,0.6,0.8") {
  const auto floats = [](const std::string& list) {
    std::string bytes;
    std::istringstream in(list);
    for (std::string word; std::getline(in, word, ',');) {
      const float value = std::strtof(word.c_str(), nullptr);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
  };
  const std::string a = floats(times);
  const std::string b = floats(values);
  const nlohmann::json json = {
      {"asset", {{"version", "2.0"}}},
      {"nodes", {{{"name", "hips"}, {"translation", {0, 1, 0}}}}},
      {"skins", {{{"joints", {0}}}}},
      {"buffers", {{{"byteLength", a.size() + b.size()}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteLength", a.size()}},
        {{"buffer", 0}, {"byteOffset", a.size()}, {"byteLength", b.size()}}}},
      {"accessors",
       {{{"bufferView", 0}, {"componentType", 5126}, {"type", "SCALAR"}, {"count", a.size() / 4}},
        {{"bufferView", 1}, {"componentType", 5126}, {"type", "VEC4"}, {"count", b.size() / 16}}}},
      {"animations",
       {{{"samplers", {{{"input", 0}, {"output", 1}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}}}};
  std::string text = json.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string file = "glTF";
  const auto word = [&](std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    file.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  word(2);
  word(28 + text.size() + a.size() + b.size());
  word(text.size());
  file += "JSON" + text;
  word(a.size() + b.size());
  return file + std::string("BIN\0", 4) + a + b;
}

// Puts `to` in the place of `from` in a binary file's JSON; both of one length or the rest filled up with spaces.
std::string with(std::string file, const std::string& from, std::string to) {
  const std::size_t at = file.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_LE(to.size(), from.size());
  to.append(from.size() - to.size(), ' ');
  return file.replace(at, from.size(), to);
}

std::string refusal(const std::string& bytes) {
  const auto read = read_gltf(bytes, "x.glb");
  EXPECT_FALSE(read.ok());
  const std::string text = read.ok() ? "" : read.error().text();
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  EXPECT_EQ(text.rfind("x.glb", 0), 0U) << text;
  return text;
}

TEST(GltfFile, CountsThatDoNotFitAreNamedByTheirPlace) {
  ASSERT_TRUE(read_gltf(turning(), "x.glb").ok()) << read_gltf(turning(), "x.glb").error().text();
  EXPECT_NE(refusal(turning("0,1,2")).find("/animations/0/channels/0: its keys are not whole"), std::string::npos);
  EXPECT_NE(refusal(turning("0")).find("/animations/0/channels/0"), std::string::npos);
  // More than there is, up to sizes that would wrap around.
  for (const char* count : {"3", "4294967295", "1152921504606846976", "18446744073709551615", "-1", "1e300", "null"}) {
    std::string file = turning();
    const std::string from = R"("count":2,"type":"VEC4"})";
    const std::size_t at = file.find(from);
    ASSERT_NE(at, std::string::npos);
    const std::string to = R"("count":)" + std::string(count) + R"(,"type":"VEC4"})";
    file.replace(at, from.size(), to);
    const std::size_t more = to.size() - from.size();
    const std::size_t padding = (4 - more % 4) % 4;
    file.insert(file.find(std::string("BIN\0", 4)) - 4, padding, ' ');
    for (const std::size_t where : {std::size_t{8}, std::size_t{12}}) {
      std::uint32_t size = 0;
      std::memcpy(&size, file.data() + where, 4);
      size += static_cast<std::uint32_t>(more + padding);
      std::memcpy(file.data() + where, &size, 4);
    }
    refusal(file);
  }
  EXPECT_NE(refusal(with(turning(), R"("input":0,"output":1)", R"("input":0,"output":7)")).find("/animations/0"),
            std::string::npos);
  refusal(with(turning(), R"("byteOffset":8)", R"("byteOffset":9)"));
}

TEST(GltfFile, NumbersThatAreNoneAreNamedByTheirPlace) {
  for (const char* bad : {"0,nan", "0,inf", "-1,1", "1,1", "1,0", "0,1e30"}) {
    EXPECT_NE(refusal(turning(bad)).find("/animations/0/channels/0"), std::string::npos) << bad;
  }
  for (const char* bad : {"nan,0,0,1", "0,inf,0,1", "0,0,0,0", "1e30,0,0,0"}) {
    EXPECT_NE(refusal(turning("0", bad)).find("/animations/0/channels/0: key 0"), std::string::npos) << bad;
  }
  EXPECT_NE(refusal(with(turning(), R"("translation":[0,1,0])", R"("scale":[0,0,0])")).find("/nodes/0"),
            std::string::npos);
}

TEST(GltfFile, TwoChannelsForOneJointAreRefused) {
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[{"name":"hips"}],"skins":[{"joints":[0]}],
    "buffers":[{"byteLength":20,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAAAAgD8="}],
    "bufferViews":[{"buffer":0,"byteLength":4},{"buffer":0,"byteOffset":4,"byteLength":16}],
    "accessors":[{"bufferView":0,"componentType":5126,"type":"SCALAR","count":1},
                 {"bufferView":1,"componentType":5126,"type":"VEC4","count":1}],
    "animations":[{"samplers":[{"input":0,"output":1}],
      "channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}MORE]}]})";
  const auto once = read_gltf(changed(text, "MORE", ""), "x.gltf");
  ASSERT_TRUE(once.ok()) << once.error().text();
  const auto twice =
      read_gltf(changed(text, "MORE", R"(,{"sampler":0,"target":{"node":0,"path":"rotation"}})"), "x.gltf");
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().message.find("/animations/0/channels/1"), std::string::npos) << twice.error().text();
}

// A hundred thousand skeletons times animations in a few bytes each, and numbers that many share.
TEST(GltfFile, LittleFilesCannotAskForMuchMemory) {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  for (int i = 0; i < 400; ++i) {
    json["nodes"].push_back({{"name", "a"}});
    json["skins"].push_back({{"joints", {i}}});
    json["animations"].push_back({{"name", "b"}, {"samplers", nlohmann::json::array()}, {"channels", {}}});
  }
  const auto many = read_gltf(json.dump(), "x.gltf");
  ASSERT_FALSE(many.ok());
  EXPECT_NE(many.error().message.find("400 skeletons"), std::string::npos) << many.error().text();

  // A mesh of a million corners without data, on forty nodes.
  const auto zeros = [](int type, const char* kind) {
    return nlohmann::json{{"componentType", type}, {"type", kind}, {"count", 1000000}};
  };
  json = {{"asset", {{"version", "2.0"}}},
          {"skins", {{{"joints", {0}}}}},
          {"accessors", {zeros(5126, "VEC3"), zeros(5123, "VEC4"), zeros(5126, "VEC4")}},
          {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}}}}}}}}}};
  json["nodes"].push_back({{"name", "hips"}});
  for (int i = 0; i < 40; ++i) {
    json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
  }
  const auto meshes = read_gltf(json.dump(), "x.gltf");
  ASSERT_FALSE(meshes.ok());
  EXPECT_NE(meshes.error().message.find("more"), std::string::npos) << meshes.error().text();

  constexpr int kKeys = 20000;
  std::string times;
  std::string values;
  for (int i = 0; i < kKeys; ++i) {
    times += std::to_string(i) + ",";
    values += "0,0,0,1,";
  }
  std::string file = turning(times, values);
  // The same keys for two thousand joints of one tree: 40 million.
  const std::size_t bin = file.find(std::string("BIN\0", 4)) - 4;
  json = nlohmann::json::parse(file.substr(20, bin - 20));
  for (int i = 1; i < 2000; ++i) {
    json["nodes"].push_back({{"name", "a"}});
    json["nodes"][static_cast<std::size_t>(i - 1)]["children"] = {i};
    json["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", {{"node", i}, {"path", "rotation"}}}});
  }
  std::string text = json.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string all = file.substr(0, 20) + text + file.substr(bin);
  const auto total = static_cast<std::uint32_t>(all.size());
  const auto size = static_cast<std::uint32_t>(text.size());
  std::memcpy(all.data() + 8, &total, 4);
  std::memcpy(all.data() + 12, &size, 4);
  EXPECT_NE(refusal(all).find("more keys"), std::string::npos);
}

TEST(GltfFile, NoFileMakesItReadAnother) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "in");
  ASSERT_TRUE(write_file(folder / "secret.bin", std::string(64, 'x')).ok());
  const std::string text = changed(
      kArmature, R"("skins")",
      R"("buffers":[{"uri":"../secret.bin","byteLength":64}],"bufferViews":[{"buffer":0,"byteLength":64}],"skins")");
  ASSERT_TRUE(write_file(folder / "in/x.gltf", text).ok());
  const auto read = load_gltf(folder / "in/x.gltf");
  ASSERT_FALSE(read.ok());
  EXPECT_TRUE(load_gltf(folder / "in/none.gltf").error().text().find("cannot be read") != std::string::npos);
}

TEST(GltfFile, ReadsWhatAnotherProgramWrote) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  const std::filesystem::path file = std::filesystem::path(data != nullptr ? data : "") / "files/simple_skin.gltf";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is not there";
  }
  const auto read = load_gltf(file);
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_EQ(read->size(), 1U);
  const Clip& clip = read->front();
  ASSERT_EQ(clip.skeleton.segments.size(), 2U);
  ASSERT_EQ(clip.meshes.size(), 1U);
  EXPECT_EQ(clip.meshes[0]->positions.size(), 10U);
  EXPECT_EQ(clip.meshes[0]->triangles.size(), 8U);
  EXPECT_GT(clip.duration(), 1.0);
  expect_same_motion(clip, written_and_read(clip));
}

}  // namespace
}  // namespace limbwave::interchange
