// Every animation that can be read is written in every format and read again: every joint stays within 1e-4 m and
// 0.01 degrees at every key.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/fbx_reader.h"
#include "interchange/fbx_writer.h"
#include "interchange/gltf_file.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "support/temporary_folder.h"

namespace limbwave::interchange {
namespace {

using motion::Clip;

constexpr double kSamePlace = 1e-4;                // m
constexpr double kSameAngle = 0.01 * kPi / 180.0;  // rad

std::string ending_of(const std::filesystem::path& path) {
  return path.extension().string();
}

// All movements of a file. BVH with frames as the file has them, so that orientations can be compared across formats.
std::vector<Clip> load(const std::filesystem::path& path, std::optional<double> metres_per_unit) {
  if (ending_of(path) == ".bvh") {
    BvhReadOptions options;
    options.metres_per_unit = metres_per_unit;
    options.frames = BoneFrames::kFile;
    const Result<Clip> clip = load_bvh(path, options);
    EXPECT_TRUE(clip.ok()) << clip.error().text();
    return clip ? std::vector<Clip>{*clip} : std::vector<Clip>();
  }
  const Result<std::vector<Clip>> clips = ending_of(path) == ".fbx" ? load_fbx(path) : load_gltf(path);
  EXPECT_TRUE(clips.ok()) << clips.error().text();
  return clips ? *clips : std::vector<Clip>();
}

void write(const Clip& clip, const std::filesystem::path& path) {
  const Clip* const clips[] = {&clip};
  const Status written = ending_of(path) == ".bvh"   ? write_bvh(clip, path)
                         : ending_of(path) == ".fbx" ? write_fbx(clip, path)
                                                     : write_gltf(clips, path);
  ASSERT_TRUE(written.ok()) << written.error().text();
}

// The joint of `b` that is joint i of `a`: formats keep depth-first order, which need not be the skeleton's own.
std::vector<std::size_t> depth_first(const body::Skeleton& skeleton) {
  std::vector<std::vector<std::size_t>> children(skeleton.segments.size());
  for (std::size_t i = 1; i < skeleton.segments.size(); ++i) {
    children[static_cast<std::size_t>(skeleton.segments[i].parent)].push_back(i);
  }
  std::vector<std::size_t> order;
  std::vector<std::size_t> open = {0};
  while (!open.empty()) {
    order.push_back(open.back());
    open.pop_back();
    for (auto child = children[order.back()].rbegin(); child != children[order.back()].rend(); ++child) {
      open.push_back(*child);
    }
  }
  return order;
}

// BVH knows no frames at rest, so that the turn away from rest is what is compared.
Eigen::Quaterniond turn(const body::SegmentPose& pose, const body::SegmentPose& rest) {
  return pose.R_WL * rest.R_WL.conjugate();
}

void expect_same(const Clip& a, const Clip& b, const std::vector<double>& times) {
  ASSERT_EQ(a.skeleton.segments.size(), b.skeleton.segments.size());
  const std::vector<std::size_t> of_a = depth_first(a.skeleton);
  const std::vector<std::size_t> of_b = depth_first(b.skeleton);
  const auto rest_a = motion::rest_poses(a.skeleton);
  const auto rest_b = motion::rest_poses(b.skeleton);
  for (const double time_s : times) {
    const auto x = motion::pose_at(a, time_s);
    const auto y = motion::pose_at(b, time_s);
    for (std::size_t n = 0; n < of_a.size(); ++n) {
      const std::size_t i = of_a[n];
      const std::size_t j = of_b[n];
      const std::string& name = a.skeleton.segments[i].name;
      ASSERT_LT((x[i].p_WL - y[j].p_WL).norm(), kSamePlace) << name << " at " << time_s;
      ASSERT_LT(geometry::geodesic_angle(turn(x[i], rest_a[i]), turn(y[j], rest_b[j])), kSameAngle)
          << name << " at " << time_s;
    }
  }
}

// BVH has frames only: the multiples of its rate.
std::vector<double> frames(const Clip& clip) {
  std::vector<double> times;
  for (std::size_t f = 0; f < motion::frame_count(clip.duration(), clip.frame_rate_hz); ++f) {
    times.push_back(static_cast<double>(f) / clip.frame_rate_hz);
  }
  return times;
}

void expect_return(const Clip& clip, const std::filesystem::path& folder) {
  for (const char* ending : {".fbx", ".glb", ".gltf", ".bvh"}) {
    SCOPED_TRACE(ending);
    const std::filesystem::path file = folder / (std::string("x") + ending);
    write(clip, file);
    const std::vector<Clip> read = load(file, kMetresPerCentimetre);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_NEAR(read[0].frame_rate_hz, clip.frame_rate_hz, 1e-6 * clip.frame_rate_hz);
    const bool bvh = ending == std::string(".bvh");
    const std::vector<double> times = bvh ? frames(clip) : motion::key_times(clip);
    expect_same(clip, read[0], times);
    if (testing::Test::HasFatalFailure()) {
      return;
    }
    // What was read, in the next format.
    const char* next = bvh ? ".fbx" : ending[1] == 'f' ? ".glb" : ".bvh";
    const std::filesystem::path other = folder / (std::string("y") + next);
    write(read[0], other);
    const std::vector<Clip> again = load(other, kMetresPerCentimetre);
    ASSERT_EQ(again.size(), 1U);
    expect_same(clip, again[0], frames(clip));
    if (testing::Test::HasFatalFailure()) {
      return;
    }
  }
}

TEST(RoundTrip, APersonPastGimbalLockInEveryFormat) {
  const test::TemporaryFolder folder;
  for (const double fps : {24 / 1.001, 30 / 1.001, 60.0, 120.0}) {
    expect_return(test::random_clip(22, 60, fps, 91), folder.path());
  }
}

TEST(RoundTrip, SlidingJointsInEveryFormat) {
  const test::TemporaryFolder folder;
  Clip clip = test::random_clip(6, 40, 60.0, 92);
  clip.joints[3].position = clip.root_position;
  clip.meshes = {test::tetrahedra(clip, 93)};
  expect_return(clip, folder.path());
}

TEST(RoundTrip, BoneLengthsComeBackFromGltf) {
  const test::TemporaryFolder folder;
  const Clip clip = test::random_clip(9, 5, 60.0, 94);  // without a mesh, and joints that stay at rest
  write(clip, folder / "x.glb");
  const std::vector<Clip> read = load(folder / "x.glb", {});
  ASSERT_EQ(read.size(), 1U);
  const std::vector<std::size_t> order = depth_first(clip.skeleton);
  ASSERT_EQ(read[0].skeleton.segments.size(), order.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    EXPECT_NEAR(read[0].skeleton.segments[n].length, clip.skeleton.segments[order[n]].length, 1e-12);
  }
}

class RealFiles : public testing::TestWithParam<const char*> {};

TEST_P(RealFiles, ComeBackFromEveryFormat) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  const auto folder = std::filesystem::path(data != nullptr ? data : "") / GetParam();
  if (data == nullptr || !std::filesystem::exists(folder)) {
    GTEST_SKIP() << "no " << folder << "; set LIMBWAVE_DATA";
  }
  const test::TemporaryFolder work;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    for (const Clip& clip : load(entry.path(), {})) {
      expect_return(clip, work.path());
    }
    ++files;
  }
  EXPECT_GT(files, 1);
}

INSTANTIATE_TEST_SUITE_P(Data, RealFiles, testing::Values("files", "motions", "pairs"),
                         [](const auto& which) { return std::string(which.param); });

}  // namespace
}  // namespace limbwave::interchange
