// Broken FBX files: each gives one located line, and none crashes, hangs or eats memory.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "base/byte_sink.h"
#include "base/files.h"
#include "interchange/fbx_format.h"
#include "interchange/fbx_reader.h"
#include "interchange/fbx_scene_writer.h"
#include "interchange/fbx_writer.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using motion::Clip;

Error must_fail(std::string_view bytes) {
  const Result<std::vector<Clip>> clips = read_fbx(bytes, "x.fbx");
  EXPECT_FALSE(clips.ok());
  const Error error = clips.ok() ? Error{} : clips.error();
  EXPECT_EQ(error.place.substr(0, 5), "x.fbx");
  EXPECT_EQ(error.text().find('\n'), std::string::npos);
  EXPECT_FALSE(error.remedy.empty());
  return error;
}

// A small scene, record by record, with room for one mistake.
struct Scene {
  std::function<void(FbxRecordWriter&)> objects = [](FbxRecordWriter&) {};
  std::function<void(FbxRecordWriter&)> connections = [](FbxRecordWriter&) {};
  std::vector<std::int64_t> times = {0, 1000000000};
  std::vector<double> values = {0.0, 10.0};

  [[nodiscard]] std::string bytes() const {
    MemorySink sink;
    FbxRecordWriter out(sink);
    out.begin("Objects");
    object(out, "Model", 1, "hips", "Model", "LimbNode");
    object(out, "Model", 2, "knee", "Model", "LimbNode");
    object(out, "AnimationStack", 10, "walk", "AnimStack", "");
    object(out, "AnimationLayer", 11, "", "AnimLayer", "");
    object(out, "AnimationCurveNode", 12, "T", "AnimCurveNode", "");
    out.begin("AnimationCurve");
    out.add(std::int64_t{13});
    out.leaf_array("KeyTime", fbx_array(std::span<const std::int64_t>(times)));
    out.leaf_array("KeyValueFloat", fbx_array(std::span<const double>(values)));
    out.end();
    objects(out);
    out.end(true);
    out.begin("Connections");
    out.leaf("C", "OO", std::int64_t{1}, std::int64_t{0});
    out.leaf("C", "OO", std::int64_t{2}, std::int64_t{1});
    out.leaf("C", "OO", std::int64_t{11}, std::int64_t{10});
    out.leaf("C", "OO", std::int64_t{12}, std::int64_t{11});
    out.leaf("C", "OP", std::int64_t{12}, std::int64_t{1}, "Lcl Translation");
    out.leaf("C", "OP", std::int64_t{13}, std::int64_t{12}, "d|X");
    connections(out);
    out.end(true);
    out.finish();
    return sink.take();
  }
  static void object(FbxRecordWriter& out, const char* record, std::int64_t id, const char* name, const char* kind,
                     const char* subkind) {
    out.begin(record);
    out.add(id);
    out.add(fbx_object_name(name, kind));
    out.add(subkind);
    out.end(true);
  }
  // A mesh with a skin on the hips.
  void skin(const std::vector<double>& vertices, const std::vector<std::int32_t>& corners,
            const std::vector<std::int32_t>& indices, const std::vector<double>& weights) {
    objects = [=](FbxRecordWriter& out) {
      object(out, "Model", 20, "body", "Model", "Mesh");
      out.begin("Geometry");
      out.add(std::int64_t{21});
      out.leaf_array("Vertices", fbx_array(std::span<const double>(vertices)));
      out.leaf_array("PolygonVertexIndex", fbx_array(std::span<const std::int32_t>(corners)));
      out.end();
      object(out, "Deformer", 22, "body", "Deformer", "Skin");
      out.begin("Deformer");
      out.add(std::int64_t{23});
      out.add("body");
      out.add("Cluster");
      out.leaf_array("Indexes", fbx_array(std::span<const std::int32_t>(indices)));
      out.leaf_array("Weights", fbx_array(std::span<const double>(weights)));
      out.leaf_array("Transform", fbx_matrix(Eigen::Quaterniond::Identity(), {0, 0, 0}));
      out.leaf_array("TransformLink", fbx_matrix(Eigen::Quaterniond::Identity(), {0, 0, 0}));
      out.end();
    };
    connections = [](FbxRecordWriter& out) {
      out.leaf("C", "OO", std::int64_t{20}, std::int64_t{0});
      out.leaf("C", "OO", std::int64_t{21}, std::int64_t{20});
      out.leaf("C", "OO", std::int64_t{22}, std::int64_t{21});
      out.leaf("C", "OO", std::int64_t{23}, std::int64_t{22});
      out.leaf("C", "OO", std::int64_t{1}, std::int64_t{23});
    };
  }
};

std::string sample() {
  static const std::string bytes = [] {
    const test::TemporaryFolder folder;
    Clip clip = test::random_clip(4, 6, 60.0, 91);
    clip.meshes = {test::tetrahedra(clip, 92)};
    EXPECT_TRUE(write_fbx(clip, folder / "a.fbx").ok());
    return *read_file(folder / "a.fbx");
  }();
  return bytes;
}

TEST(FbxMalformed, TheSmallSceneIsWholeByItself) {
  Scene scene;
  scene.skin({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, -3}, {0, 1, 2}, {1, 1, 1});
  const Result<std::vector<Clip>> clips = read_fbx(scene.bytes(), "x.fbx");
  ASSERT_TRUE(clips.ok()) << clips.error().text();
  ASSERT_EQ(clips->size(), 1U);
  EXPECT_EQ(clips->front().skeleton.segments.size(), 2U);
  EXPECT_EQ(clips->front().meshes.size(), 1U);
  EXPECT_EQ(clips->front().root_position.times.size(), 2U);
  // 10 cm along the file's x is along our y.
  EXPECT_NEAR(clips->front().root_position.values[1].y(), 0.1, 1e-7);
}

TEST(FbxMalformed, OtherFilesAreNamedForWhatTheyAre) {
  must_fail("");
  must_fail("HIERARCHY\nROOT Hips");
  EXPECT_NE(must_fail("; FBX 7.4.0 project file\nFBXHeaderExtension: {").remedy.find("binary"), std::string::npos);
  std::string old = sample();
  const std::uint32_t version = 6100;
  std::memcpy(old.data() + kFbxMagic.size(), &version, 4);
  EXPECT_NE(must_fail(old).message.find("6.1"), std::string::npos);
}

TEST(FbxMalformed, EveryTruncationFails) {
  const std::string whole = sample();
  ASSERT_TRUE(read_fbx(whole, "x.fbx").ok());
  // Nothing is read behind the last record.
  const std::size_t records_end = whole.size() - 160;
  for (std::size_t length = 0; length < records_end - 13; length += length < 4000 ? 1 : 97) {
    must_fail(std::string_view(whole).substr(0, length));
  }
}

TEST(FbxMalformed, CurvesMustBeWhole) {
  Scene scene;
  scene.values = {0.0};
  EXPECT_NE(must_fail(scene.bytes()).message.find("2 times and 1 values"), std::string::npos);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e30}) {
    scene.values = {0.0, bad};
    const Error error = must_fail(scene.bytes());
    EXPECT_NE(error.message.find("hips"), std::string::npos) << error.text();
    EXPECT_NE(error.place.find("byte"), std::string::npos) << error.text();
  }
  scene.values = {0.0, 1.0};
  scene.times = {5, 5};
  must_fail(scene.bytes());
  scene.times = {0, std::numeric_limits<std::int64_t>::max()};
  must_fail(scene.bytes());
  scene.times = {std::numeric_limits<std::int64_t>::min(), 0};
  must_fail(scene.bytes());
  scene.times = {};
  scene.values = {};
  must_fail(scene.bytes());
}

TEST(FbxMalformed, BonesMustNotHangOnThemselves) {
  Scene scene;
  scene.objects = [](FbxRecordWriter& out) {
    Scene::object(out, "Model", 30, "a", "Model", "LimbNode");
    Scene::object(out, "Model", 31, "b", "Model", "LimbNode");
  };
  scene.connections = [](FbxRecordWriter& out) {
    out.leaf("C", "OO", std::int64_t{30}, std::int64_t{31});
    out.leaf("C", "OO", std::int64_t{31}, std::int64_t{30});
  };
  EXPECT_NE(must_fail(scene.bytes()).message.find("hangs on itself"), std::string::npos);
  // A second parent is ignored; no circle comes about.
  scene.objects = [](FbxRecordWriter&) {};
  scene.connections = [](FbxRecordWriter& out) { out.leaf("C", "OO", std::int64_t{1}, std::int64_t{2}); };
  EXPECT_TRUE(read_fbx(scene.bytes(), "x.fbx").ok());
}

TEST(FbxMalformed, MeshesMustFitTogether) {
  const std::vector<double> corner = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  Scene scene;
  scene.skin(corner, {0, 1, -4}, {0}, {1});
  must_fail(scene.bytes());
  scene.skin(corner, {0, 1, 2}, {0}, {1});  // no end
  must_fail(scene.bytes());
  scene.skin({0, 0, 0, 1}, {0, 0, -1}, {0}, {1});
  must_fail(scene.bytes());
  scene.skin({0, 0, 0, 1, std::nan(""), 0, 0, 1, 0}, {0, 1, -3}, {0}, {1});
  must_fail(scene.bytes());
  scene.skin(corner, {0, 1, -3}, {0, 3}, {1, 1});
  must_fail(scene.bytes());
  scene.skin(corner, {0, 1, -3}, {0, -1}, {1, 1});
  must_fail(scene.bytes());
  scene.skin(corner, {0, 1, -3}, {0, 1}, {1});
  must_fail(scene.bytes());
  scene.skin(corner, {0, 1, -3}, {0}, {std::nan("")});
  must_fail(scene.bytes());
}

TEST(FbxMalformed, AbsurdSizesAreRefusedBeforeMemoryIsTaken) {
  // An array of four thousand million numbers in a few bytes, packed and not.
  for (const std::uint32_t encoding : {0U, 1U}) {
    std::string bytes = Scene().bytes();
    const std::size_t at = bytes.find("KeyTime") + 8;
    const std::uint32_t count = 0xFFFFFFF0U;
    std::memcpy(bytes.data() + at, &count, 4);
    std::memcpy(bytes.data() + at + 4, &encoding, 4);
    must_fail(bytes);
  }
  // A record in a record in a record ...
  MemorySink sink;
  FbxRecordWriter out(sink);
  for (int i = 0; i < 500; ++i) {
    out.begin("a");
  }
  for (int i = 0; i < 500; ++i) {
    out.end();
  }
  out.finish();
  EXPECT_NE(must_fail(sink.take()).message.find("deeper"), std::string::npos);
  // Keys so far from each other that frames between them would never end.
  Scene scene;
  scene.times = {0, std::int64_t{4'000'000} * 1'000'000'000'000};
  scene.connections = [](FbxRecordWriter& more) {
    more.leaf("C", "OP", std::int64_t{12}, std::int64_t{2}, "Lcl Rotation");
  };
  EXPECT_NE(must_fail(scene.bytes()).message.find("more keys"), std::string::npos);
}

TEST(FbxMalformed, FilesWithoutBonesSaySo) {
  MemorySink sink;
  FbxRecordWriter out(sink);
  out.begin("Objects");
  out.end(true);
  out.finish();
  EXPECT_NE(must_fail(sink.take()).message.find("no bones"), std::string::npos);
}

TEST(FbxMalformed, ManyMutationsAreSurvived) {
  const std::string whole = sample();
  std::mt19937 random(93);
  int read_anyway = 0;
  for (int round = 0; round < 400; ++round) {
    std::string mutated = whole;
    for (int n = 0; n < 1 + round % 5; ++n) {
      mutated[random() % mutated.size()] = static_cast<char>(random());
    }
    const Result<std::vector<Clip>> clips = read_fbx(mutated, "m.fbx");
    if (!clips) {
      EXPECT_EQ(clips.error().text().find('\n'), std::string::npos);
      continue;
    }
    ++read_anyway;
    for (const Clip& clip : *clips) {
      for (const body::SegmentPose& pose : motion::pose_at(clip, 0.03)) {
        ASSERT_TRUE(pose.p_WL.allFinite() && pose.R_WL.coeffs().allFinite()) << round;
      }
      for (const auto& mesh : clip.meshes) {
        ASSERT_TRUE(motion::validate(*mesh, clip.skeleton).ok()) << round;
      }
    }
  }
  EXPECT_GT(read_anyway, 0);
}

TEST(FbxWriter, RefusesWhatCannotBeWrittenAndLeavesNoFile) {
  const test::TemporaryFolder folder;
  const auto path = folder / "a.fbx";
  EXPECT_FALSE(write_fbx(Clip(), path).ok());
  Clip clip = test::random_clip(3, 4, 60.0, 94);
  clip.joints[1].rotation.values[2].x() = NAN;
  EXPECT_FALSE(write_fbx(clip, path).ok());
  clip = test::random_clip(3, 4, 60.0, 94);
  clip.root_position.times[2] = clip.root_position.times[1];
  EXPECT_FALSE(write_fbx(clip, path).ok());
  clip = test::random_clip(3, 4, 60.0, 94);
  FbxWriteOptions options;
  options.fps = -1.0;
  EXPECT_FALSE(write_fbx(clip, path, options).ok());
  const Status cancelled_status = write_fbx(clip, path, {}, Progress([](double, std::string_view) { return false; }));
  ASSERT_FALSE(cancelled_status.ok());
  EXPECT_TRUE(is_cancelled(cancelled_status.error()));
  EXPECT_FALSE(write_fbx(clip, folder / "nowhere" / "a.fbx").ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  // A file that was there stays as it was.
  ASSERT_TRUE(write_file(path, "old").ok());
  EXPECT_FALSE(write_fbx(Clip(), path).ok());
  EXPECT_EQ(*read_file(path), "old");
}

}  // namespace
}  // namespace limbwave::interchange
