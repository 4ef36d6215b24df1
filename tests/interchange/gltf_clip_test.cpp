#include "interchange/gltf_clip.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <random>

#include "base/files.h"
#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/bvh_reader.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"

namespace limbwave::interchange {
namespace {

using motion::Clip;

template <typename T>
void expect_same_keys(const motion::Track<T>& a, const motion::Track<T>& b) {
  ASSERT_EQ(a.times, b.times);
  ASSERT_EQ(a.values.size(), b.values.size());
  EXPECT_EQ(a.interpolation, b.interpolation);
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if constexpr (std::is_same_v<T, Eigen::Quaterniond>) {
      ASSERT_EQ(a.values[i].coeffs(), b.values[i].coeffs());
    } else {
      ASSERT_EQ(a.values[i], b.values[i]);
    }
  }
}

void expect_same_clip(const Clip& a, const Clip& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.frame_rate_hz, b.frame_rate_hz);
  EXPECT_EQ(a.skeleton.name, b.skeleton.name);
  EXPECT_EQ(a.skeleton.height, b.skeleton.height);
  ASSERT_EQ(a.skeleton.segments.size(), b.skeleton.segments.size());
  for (std::size_t i = 0; i < a.skeleton.segments.size(); ++i) {
    const body::Segment& x = a.skeleton.segments[i];
    const body::Segment& y = b.skeleton.segments[i];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.parent, y.parent);
    EXPECT_EQ(x.length, y.length);
    EXPECT_EQ(x.p_PL, y.p_PL);
    EXPECT_LT((x.R_PL_rest.coeffs() - y.R_PL_rest.coeffs()).norm(), 1e-15);
    EXPECT_EQ(x.joint.kind, y.joint.kind);
    expect_same_keys(a.joints[i].rotation, b.joints[i].rotation);
  }
  expect_same_keys(a.root_position, b.root_position);
}

Clip must_restore(const Clip& clip) {
  const Result<std::string> bytes = glb_from_clip(clip);
  EXPECT_TRUE(bytes.ok()) << bytes.error().text();
  Result<Clip> read = clip_from_glb(bytes.ok() ? *bytes : "", "clip.glb");
  EXPECT_TRUE(read.ok()) << read.error().text();
  return read.ok() ? *read : Clip();
}

TEST(GltfClip, RestoresEveryBitOfTheKeys) {
  Clip clip = test::random_clip(22, 200, 59.94, 21);
  clip.skeleton.height = 1.78;
  clip.skeleton.segments[3].name = "Hüfte links";
  clip.skeleton.segments[5].joint.kind = body::JointKind::kHinge;
  clip.skeleton.segments[6].joint.kind = body::JointKind::kUniversal;
  clip.skeleton.segments[7].joint.kind = body::JointKind::kFixed;
  // Own times, another interpolation, a quaternion that is not quite unit and the opposite sign.
  clip.joints[2].rotation.times.pop_back();
  clip.joints[2].rotation.values.pop_back();
  clip.joints[2].rotation.interpolation = motion::Interpolation::kStep;
  clip.joints[4].rotation.interpolation = motion::Interpolation::kCubic;
  clip.joints[5].rotation.values[7].coeffs() *= -1.0000001;
  // Times that are the same as floats but not as doubles.
  clip.joints[6].rotation.times[50] += 1e-12;
  expect_same_clip(clip, must_restore(clip));
}

TEST(GltfClip, RestoresOneKeyNoKeysAndLongTakes) {
  expect_same_clip(test::random_clip(3, 1, 60.0, 22), must_restore(test::random_clip(3, 1, 60.0, 22)));
  Clip still = test::random_clip(3, 1, 60.0, 23);
  still.joints.assign(3, {});
  still.root_position = {};
  expect_same_clip(still, must_restore(still));
  // After five hours a float does not tell neighbouring frames of 960 Hz apart.
  Clip late = test::random_clip(2, 50, 960.0, 24);
  for (double& t : late.joints[0].rotation.times) {
    t += 18000.0;
  }
  expect_same_clip(late, must_restore(late));
}

TEST(GltfClip, AnotherProgramsChangesCount) {
  const Clip clip = test::random_clip(4, 20, 60.0, 25);
  Result<std::string> bytes = glb_from_clip(clip);
  ASSERT_TRUE(bytes.ok());
  // The first float key of the root's position is the first place where its x stands.
  const auto x = static_cast<float>(clip.root_position.values[3].x());
  char pattern[4];
  std::memcpy(pattern, &x, 4);
  const std::size_t at = bytes->find(std::string(pattern, 4));
  ASSERT_NE(at, std::string::npos);
  const float moved = x + 1.0F;
  std::memcpy(bytes->data() + at, &moved, 4);
  const Result<Clip> read = clip_from_glb(*bytes, "clip.glb");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_FLOAT_EQ(static_cast<float>(read->root_position.values[3].x()), moved);
  EXPECT_LT((read->root_position.values[4] - clip.root_position.values[4]).norm(), 1e-6);
  EXPECT_LT(geometry::geodesic_angle(read->joints[1].rotation.values[5], clip.joints[1].rotation.values[5]), 1e-6);
}

TEST(GltfClip, RefusesWhatCannotBeWritten) {
  EXPECT_FALSE(glb_from_clip({}).ok());
  Clip clip = test::random_clip(2, 4, 60.0, 26);
  clip.joints[1].rotation.values[2].x() = NAN;
  EXPECT_FALSE(glb_from_clip(clip).ok());
  clip = test::random_clip(2, 4, 60.0, 26);
  clip.joints[1].rotation.times[2] = clip.joints[1].rotation.times[1];
  EXPECT_FALSE(glb_from_clip(clip).ok());
  clip = test::random_clip(2, 4, 60.0, 26);
  clip.root_position.times[0] = -0.5;
  EXPECT_FALSE(glb_from_clip(clip).ok());
  // What it has no place for is not dropped silently.
  clip = test::random_clip(2, 4, 60.0, 26);
  clip.meshes = {test::tetrahedra(clip, 27)};
  EXPECT_FALSE(glb_from_clip(clip).ok());
  clip = test::random_clip(2, 4, 60.0, 26);
  clip.joints[1].position = clip.root_position;
  EXPECT_FALSE(glb_from_clip(clip).ok());
  clip = test::random_clip(2, 4, 60.0, 26);
  clip.joints[1].rotation.arriving.assign(4, Eigen::Vector3d::Zero());
  clip.joints[1].rotation.leaving = clip.joints[1].rotation.arriving;
  EXPECT_FALSE(glb_from_clip(clip).ok());
}

TEST(GltfClip, RefusesForeignAndBrokenFiles) {
  for (const std::string& bytes : {std::string(), std::string("glTF"), std::string(100, 'x'),
                                   std::string("glTF\1\0\0\0\24\0\0\0\0\0\0\0JSON", 20)}) {
    const Result<Clip> clip = clip_from_glb(bytes, "x.glb");
    ASSERT_FALSE(clip.ok());
    EXPECT_EQ(clip.error().place, "x.glb");
  }
  const auto glb = [](std::string json) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t n) {
      const auto value = static_cast<std::uint32_t>(n);
      return std::string(reinterpret_cast<const char*>(&value), 4);
    };
    return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
  };
  const Result<Clip> foreign = clip_from_glb(glb(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]}]})"), "x.glb");
  ASSERT_FALSE(foreign.ok());
  EXPECT_NE(foreign.error().message.find("Limbwave"), std::string::npos) << foreign.error().text();
  EXPECT_FALSE(clip_from_glb(glb(std::string(100000, '[')), "x.glb").ok());
  EXPECT_FALSE(clip_from_glb(glb(R"({"asset":7,"scenes":3})"), "x.glb").ok());
  const Result<Clip> outside =
      clip_from_glb(glb(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":9,"uri":"/etc/passwd"}]})"), "x.glb");
  ASSERT_FALSE(outside.ok());
}

TEST(GltfClip, EveryTruncationAndManyMutationsAreSurvived) {
  const Result<std::string> bytes = glb_from_clip(test::random_clip(3, 5, 60.0, 27));
  ASSERT_TRUE(bytes.ok());
  for (std::size_t length = 0; length < bytes->size(); ++length) {
    std::string cut = bytes->substr(0, length);
    EXPECT_FALSE(clip_from_glb(cut, "t").ok());
    if (length >= 12) {  // with the length corrected, so that the inside is looked at
      const auto size = static_cast<std::uint32_t>(length);
      std::memcpy(cut.data() + 8, &size, 4);
      EXPECT_FALSE(clip_from_glb(cut, "t").ok()) << length;
    }
  }
  std::mt19937 random(28);
  for (int round = 0; round < 5000; ++round) {
    std::string mutated = *bytes;
    for (int n = 0; n < 1 + round % 4; ++n) {
      const std::size_t at = random() % mutated.size();
      mutated[at] = random() % 2 == 0 ? static_cast<char>(random()) : "0123456789-,:[]{}\""[random() % 18];
    }
    const Result<Clip> clip = clip_from_glb(mutated, "m");
    if (clip) {
      for (const body::SegmentPose& pose : motion::pose_at(*clip, 0.03)) {
        ASSERT_TRUE(pose.p_WL.allFinite() && pose.R_WL.coeffs().allFinite()) << round;
      }
    }
  }
}

TEST(GltfClip, FilesComeBackWhole) {
  const auto path = std::filesystem::path(testing::TempDir()) / "clip_test.glb";
  const Clip clip = test::random_clip(5, 30, 60.0, 29);
  ASSERT_TRUE(write_glb(clip, path).ok());
  const Result<Clip> read = load_glb(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(read.ok()) << read.error().text();
  expect_same_clip(clip, *read);
  EXPECT_FALSE(load_glb(path).ok());
}

TEST(GltfClip, KeepsARealMotion) {
  const char* folder = std::getenv("LIMBWAVE_DATA");
  const std::filesystem::path path = std::filesystem::path(folder != nullptr ? folder : "") / "motions/02_01.bvh";
  if (folder == nullptr || !std::filesystem::exists(path)) {
    GTEST_SKIP() << "no " << path << "; set LIMBWAVE_DATA";
  }
  BvhReadOptions options;
  options.metres_per_unit = 1.0;
  const Result<Clip> clip = load_bvh(path, options);
  ASSERT_TRUE(clip.ok());
  expect_same_clip(*clip, must_restore(*clip));
}

}  // namespace
}  // namespace limbwave::interchange
