#include "interchange/gltf_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

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
