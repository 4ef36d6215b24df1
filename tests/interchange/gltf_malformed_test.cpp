#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/files.h"
#include "interchange/gltf_file.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;
using motion::Clip;

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

TEST(GltfMalformed, BrokenFilesGiveOneLocatedLine) {
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

// The place in a binary file of an accessor's numbers.
std::size_t place_of(const std::string& file, const nlohmann::json& json, const nlohmann::json& accessor_index) {
  const nlohmann::json& accessor = json["accessors"][accessor_index.get<std::size_t>()];
  const nlohmann::json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  std::uint32_t text = 0;
  std::memcpy(&text, file.data() + 12, sizeof text);
  return 28 + text + view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
}

TEST(GltfMalformed, MeshesThatPointOutsideAreNamedByTheirPlace) {
  Clip clip = test::random_clip(6, 3, 60.0, 4);
  clip.meshes = {test::tetrahedra(clip, 4)};
  const std::size_t vertices = clip.meshes[0]->positions.size();
  const test::TemporaryFolder folder;
  const Clip* clips[] = {&clip};
  ASSERT_TRUE(write_gltf(clips, folder / "x.glb").ok());
  const std::string file = *read_file(folder / "x.glb");
  ASSERT_TRUE(read_gltf(file, "x.glb").ok());
  std::uint32_t size = 0;
  std::memcpy(&size, file.data() + 12, sizeof size);
  const nlohmann::json json = nlohmann::json::parse(file.substr(20, size));
  const nlohmann::json& primitive = json["meshes"][0]["primitives"][0];
  const auto bytes_each = [&](const nlohmann::json& index) {
    const int type = json["accessors"][index.get<std::size_t>()]["componentType"];
    return type == 5121 ? 1U : type == 5123 ? 2U : 4U;
  };
  const auto put = [&](const nlohmann::json& accessor, std::size_t element, std::uint32_t value) {
    std::string damaged = file;
    const std::size_t each = bytes_each(accessor);
    std::memcpy(damaged.data() + place_of(file, json, accessor) + element * each, &value, each);
    return damaged;
  };
  const nlohmann::json& corners = primitive["indices"];
  // The last vertex is inside, the one behind it is not.
  EXPECT_TRUE(read_gltf(put(corners, 4, static_cast<std::uint32_t>(vertices - 1)), "x.glb").ok());
  for (const std::uint32_t index : {static_cast<std::uint32_t>(vertices), 0xFFU, 0xFFFFU, 0xFFFFFFFFU}) {
    const std::string text = refusal(put(corners, 4, index));
    EXPECT_NE(text.find("index 4 is"), std::string::npos) << text;
    EXPECT_NE(text.find("/meshes/0"), std::string::npos) << text;
  }
  const std::string joint = refusal(put(primitive["attributes"]["JOINTS_0"], 0, 6));
  EXPECT_NE(joint.find("vertex 0 follows joint 6 of 6"), std::string::npos) << joint;
  // Lists that are of another length than the vertices, or not there.
  EXPECT_NE(refusal(with(file, "\"JOINTS_0\":" + primitive["attributes"]["JOINTS_0"].dump(), "\"JOINTS_0\":0")).size(),
            0U);
}

TEST(GltfMalformed, CountsThatDoNotFitAreNamedByTheirPlace) {
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

TEST(GltfMalformed, NumbersThatAreNoneAreNamedByTheirPlace) {
  for (const char* bad : {"0,nan", "0,inf", "-1,1", "1,1", "1,0", "0,1e30"}) {
    EXPECT_NE(refusal(turning(bad)).find("/animations/0/channels/0"), std::string::npos) << bad;
  }
  for (const char* bad : {"nan,0,0,1", "0,inf,0,1", "0,0,0,0", "1e30,0,0,0"}) {
    EXPECT_NE(refusal(turning("0", bad)).find("/animations/0/channels/0: key 0"), std::string::npos) << bad;
  }
  EXPECT_NE(refusal(with(turning(), R"("translation":[0,1,0])", R"("scale":[0,0,0])")).find("/nodes/0"),
            std::string::npos);
}

TEST(GltfMalformed, TwoChannelsForOneJointAreRefused) {
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
TEST(GltfMalformed, LittleFilesCannotAskForMuchMemory) {
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

TEST(GltfMalformed, NoFileMakesItReadAnother) {
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

}  // namespace
}  // namespace limbwave::interchange
