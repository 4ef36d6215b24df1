// FBX files that are written and read again, ours and those of other programs.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/bvh_reader.h"
#include "interchange/fbx_reader.h"
#include "interchange/fbx_writer.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using motion::Clip;
using motion::Interpolation;

// What reading and writing again may change.
constexpr double kSamePlace = 1e-4;                // m
constexpr double kSameAngle = 0.01 * kPi / 180.0;  // rad

class FbxRoundTrip : public testing::Test {
 protected:
  std::vector<Clip> must_return(std::span<const Clip* const> clips, const FbxWriteOptions& options = {}) {
    const Status written = write_fbx(clips, file_, options);
    EXPECT_TRUE(written.ok()) << written.error().text();
    Result<std::vector<Clip>> read = load_fbx(file_);
    EXPECT_TRUE(read.ok()) << read.error().text();
    return read.ok() ? std::move(*read) : std::vector<Clip>();
  }
  Clip must_return(const Clip& clip, const FbxWriteOptions& options = {}) {
    const Clip* const clips[] = {&clip};
    std::vector<Clip> read = must_return(clips, options);
    EXPECT_EQ(read.size(), 1U);
    return read.empty() ? Clip() : std::move(read.front());
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "Bewegung ü.fbx";
};

void expect_same_poses(const Clip& a, const Clip& b, double time_s) {
  const auto x = motion::pose_at(a, time_s);
  const auto y = motion::pose_at(b, time_s);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string& name = a.skeleton.segments[i].name;
    ASSERT_LT((x[i].p_WL - y[i].p_WL).norm(), kSamePlace) << name << " at " << time_s;
    ASSERT_LT(geometry::geodesic_angle(x[i].R_WL, y[i].R_WL), kSameAngle) << name << " at " << time_s;
  }
}

// Same skeleton, same poses at every key of both.
void expect_same_motion(const Clip& a, const Clip& b) {
  ASSERT_EQ(a.skeleton.segments.size(), b.skeleton.segments.size());
  for (std::size_t i = 0; i < a.skeleton.segments.size(); ++i) {
    const body::Segment& x = a.skeleton.segments[i];
    const body::Segment& y = b.skeleton.segments[i];
    EXPECT_EQ(x.name, y.name);
    ASSERT_EQ(x.parent, y.parent) << x.name;
    EXPECT_LT((x.p_PL - y.p_PL).norm(), kSamePlace) << x.name;
    EXPECT_LT(geometry::geodesic_angle(x.R_PL_rest, y.R_PL_rest), kSameAngle) << x.name;
    EXPECT_NEAR(x.length, y.length, 1e-9) << x.name;
  }
  EXPECT_NEAR(a.duration(), b.duration(), 1e-9);
  EXPECT_NEAR(a.frame_rate_hz, b.frame_rate_hz, 1e-9 * a.frame_rate_hz);
  for (const double time_s : motion::key_times(a)) {
    expect_same_poses(a, b, time_s);
  }
}

TEST_F(FbxRoundTrip, KeepsAWholeBodyPastGimbalLock) {
  for (const double fps : {24 / 1.001, 24.0, 25.0, 30 / 1.001, 30.0, 48.0, 50.0, 60 / 1.001, 60.0, 120.0, 73.5}) {
    Clip clip = test::random_clip(22, 40, fps, 71);
    clip.name = "Tanz über 2 Kanten";
    const Clip read = must_return(clip);
    EXPECT_EQ(read.name, clip.name);
    expect_same_motion(clip, read);
  }
}

TEST_F(FbxRoundTrip, KeepsOtherUnitsAndAxes) {
  const Clip clip = test::random_clip(8, 20, 60.0, 72);
  FbxWriteOptions options;
  options.metres_per_unit = 1.0;
  expect_same_motion(clip, must_return(clip, options));
  options.up = FbxUpAxis::kZ;
  expect_same_motion(clip, must_return(clip, options));
}

TEST_F(FbxRoundTrip, KeepsMeshes) {
  Clip clip = test::random_clip(10, 12, 30.0, 73);
  clip.meshes = {test::tetrahedra(clip, 74)};
  const Clip read = must_return(clip);
  ASSERT_EQ(read.meshes.size(), 1U);
  ASSERT_TRUE(motion::validate(*read.meshes[0], read.skeleton).ok());
  EXPECT_EQ(read.meshes[0]->name, "body");
  EXPECT_EQ(read.meshes[0]->triangles, clip.meshes[0]->triangles);
  for (const double time_s : motion::key_times(clip)) {
    const auto a = motion::deformed(*clip.meshes[0], clip.skeleton, motion::pose_at(clip, time_s));
    const auto b = motion::deformed(*read.meshes[0], read.skeleton, motion::pose_at(read, time_s));
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t v = 0; v < a.size(); ++v) {
      ASSERT_LT((a[v] - b[v]).norm(), 1e-4F) << v;
    }
  }
}

TEST_F(FbxRoundTrip, KeepsSeveralActors) {
  const Clip a = test::random_clip(5, 30, 60.0, 75);
  Clip b = test::random_clip(7, 20, 60.0, 76);
  const Clip* const clips[] = {&a, &b};
  const std::vector<Clip> read = must_return(clips);
  ASSERT_EQ(read.size(), 2U);
  expect_same_motion(a, read[0]);
  for (std::size_t i = 0; i < b.skeleton.segments.size(); ++i) {
    b.skeleton.segments[i].name += i < 5 ? "_2" : "";
  }
  expect_same_motion(b, read[1]);
}

TEST_F(FbxRoundTrip, KeepsOneKeyStillClipsAndOddNames) {
  expect_same_motion(test::random_clip(3, 1, 60.0, 77), must_return(test::random_clip(3, 1, 60.0, 77)));
  Clip clip = test::random_clip(4, 3, 60.0, 78);
  clip.skeleton.segments[1].name = "linker Arm";
  clip.skeleton.segments[2].name = "右手";
  clip.skeleton.segments[3].name = "linker Arm";
  Clip expected = clip;
  expected.skeleton.segments[3].name = "linker Arm_2";
  expect_same_motion(expected, must_return(clip));
  clip.joints.assign(4, {});
  clip.root_position = {};
  expected.joints = clip.joints;
  expected.root_position = {};
  expect_same_motion(expected, must_return(clip));
}

TEST_F(FbxRoundTrip, KeepsSlidingJointsAndSteps) {
  Clip clip = test::random_clip(4, 30, 60.0, 79);
  clip.joints[2].position.times = {0.0, 0.2, 0.4};
  clip.joints[2].position.values = {{0.1, 0.0, 0.0}, {0.2, 0.1, 0.0}, {0.15, 0.0, 0.1}};
  clip.joints[2].position.interpolation = Interpolation::kStep;
  const Clip read = must_return(clip);
  expect_same_motion(clip, read);
  // Held until a frame before the next key, for programs without steps; then straight.
  EXPECT_LT((motion::pose_at(read, 0.19)[2].p_WL - motion::pose_at(clip, 0.19)[2].p_WL).norm(), 0.05);
}

TEST_F(FbxRoundTrip, SparseKeysStayInTheirPlacesBetweenTheKeys) {
  Clip clip = test::random_clip(3, 2, 30.0, 80);
  clip.root_position.times = {0.0, 0.5, 1.0, 2.0};
  clip.root_position.values = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1.5}, {0, 0, 1}};
  clip.root_position.interpolation = Interpolation::kCubic;
  for (motion::JointTracks& joint : clip.joints) {
    joint.rotation.times = {0.0, 1.0, 2.0};
    joint.rotation.values.resize(3, Eigen::Quaterniond::Identity());
    joint.rotation.values[2] = geometry::exp_so3({1.0, -1.2, 0.7});
  }
  clip.joints[1].rotation.interpolation = Interpolation::kCubic;
  const Clip dense = must_return(clip);
  for (double time_s = 0.0; time_s <= 2.0; time_s += 1.0 / 30.0) {
    expect_same_poses(clip, dense, time_s);
  }
  // Cubic positions are cubic curves in FBX too, so that the few keys say everything.
  FbxWriteOptions own;
  own.keys = FbxKeyMode::kOwn;
  const Clip sparse = must_return(clip, own);
  for (const double time_s : {0.1, 0.3, 0.7, 1.5, 1.9}) {
    const double frame = std::round(time_s * 30.0) / 30.0;
    EXPECT_LT((motion::sample(sparse.root_position, frame) - motion::sample(clip.root_position, frame)).norm(),
              kSamePlace);
  }
  // Rotations are only about the same between their own keys.
  for (const double time_s : clip.joints[0].rotation.times) {
    expect_same_poses(clip, sparse, time_s);
  }
}

TEST_F(FbxRoundTrip, FramesAreMultiplesOfTheRateAsked) {
  Clip clip = test::random_clip(3, 121, 120.0, 81);
  FbxWriteOptions options;
  options.fps = 29.97;
  const Clip read = must_return(clip, options);
  EXPECT_DOUBLE_EQ(read.frame_rate_hz, 30 / 1.001);
  EXPECT_NEAR(read.duration(), 29.0 * 1.001 / 30.0, 1e-9);
  for (int frame = 0; frame < 30; ++frame) {
    expect_same_poses(clip, read, frame * 1.001 / 30.0);
  }
}

TEST_F(FbxRoundTrip, RealMotionsComeBack) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path(data) / "motions")) {
    GTEST_SKIP() << "set LIMBWAVE_DATA";
  }
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(data) / "motions")) {
    BvhReadOptions options;
    options.metres_per_unit.reset();
    const Result<Clip> clip = load_bvh(entry.path(), options);
    if (!clip || files >= 4) {
      continue;
    }
    ++files;
    SCOPED_TRACE(entry.path().filename());
    const Clip cut = motion::trimmed(*clip, 0.0, std::min(2.0, clip->duration()));
    expect_same_motion(cut, must_return(cut));
  }
  EXPECT_GT(files, 0);
}

TEST_F(FbxRoundTrip, AForeignFileComesBack) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  const auto path = std::filesystem::path(data != nullptr ? data : "") / "files" / "ufbx_maya_human_ik_7400_binary.fbx";
  if (data == nullptr || !std::filesystem::exists(path)) {
    GTEST_SKIP() << "no " << path << "; set LIMBWAVE_DATA";
  }
  const Result<std::vector<Clip>> clips = load_fbx(path);
  ASSERT_TRUE(clips.ok()) << clips.error().text();
  ASSERT_EQ(clips->size(), 1U);
  const Clip& clip = clips->front();
  EXPECT_EQ(clip.skeleton.segments.size(), 62U);
  EXPECT_EQ(clip.skeleton.segments[0].name, "Character1_Hips");
  // A person, upright: the head is over the hips, and the feet are under them.
  const auto poses = motion::pose_at(clip, 0.0);
  const auto z = [&](const char* name) { return poses[static_cast<std::size_t>(clip.skeleton.find(name))].p_WL.z(); };
  EXPECT_GT(z("Character1_Head") - z("Character1_LeftFoot"), 1.0);
  EXPECT_LT(z("Character1_Head") - z("Character1_LeftFoot"), 2.2);
  expect_same_motion(clip, must_return(clip));
}

TEST_F(FbxRoundTrip, NumbersDoNotDependOnTheLocale) {
  const Clip clip = test::random_clip(3, 3, 60.0, 82);
  ASSERT_TRUE(write_fbx(clip, file_).ok());
  const Result<std::string> plain = read_file(file_);
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  ASSERT_TRUE(write_fbx(clip, file_).ok());
  const Result<std::string> german = read_file(file_);
  const Result<std::vector<Clip>> read = load_fbx(file_);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(*plain, *german) << (set == nullptr ? "(no German locale here)" : "");
  ASSERT_TRUE(read.ok());
  expect_same_motion(clip, read->front());
}

}  // namespace
}  // namespace limbwave::interchange
