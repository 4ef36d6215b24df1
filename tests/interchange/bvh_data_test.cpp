// Files that other programs wrote, against a plain second reading and what is known about them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "base/units.h"
#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/file_axes.h"
#include "interchange/naive_bvh.h"

namespace limbwave::interchange {
namespace {

namespace fs = std::filesystem;

struct Known {
  const char* file;
  std::size_t joints;
  std::size_t frames;
  double rate;
  double metres_per_unit;  ///< What the guess must find.
};

// CMU's frame time of the pair, 0.008333, is 120 Hz cut off.
constexpr Known kFiles[] = {
    {"motions/01_01.bvh", 31, 2752, 120, kMetresPerCmuUnit},
    {"motions/01_08.bvh", 31, 2610, 120, 1.0},
    {"motions/02_01.bvh", 31, 343, 120, 1.0},
    {"motions/02_03.bvh", 31, 173, 120, 1.0},
    {"motions/02_05.bvh", 31, 1854, 120, 1.0},
    {"motions/02_07.bvh", 31, 2251, 120, 1.0},
    {"motions/03_01.bvh", 31, 432, 120, 1.0},
    {"motions/12_01_walk.bvh", 31, 524, 120, kMetresPerCmuUnit},
    {"pairs/60_10_scaled.bvh", 43, 1197, 120, 1.0},
    {"pairs/61_10_scaled.bvh", 43, 1197, 120, 1.0},
    {"files/pybvh_bvh_test1.bvh", 24, 75, 30, kMetresPerCmuUnit},
    {"files/pybvh_bvh_test2.bvh", 23, 61, 120, 0.01},
};

void PrintTo(const Known& known, std::ostream* out) {
  *out << known.file;
}

class BvhData : public testing::TestWithParam<Known> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("LIMBWAVE_DATA");
    path_ = fs::path(folder != nullptr ? folder : "") / GetParam().file;
    if (folder == nullptr || !fs::exists(path_)) {
      GTEST_SKIP() << "no " << path_ << "; set LIMBWAVE_DATA";
    }
  }
  fs::path path_;
};

TEST_P(BvhData, AgreesWithAPlainReading) {
  const Known& known = GetParam();
  Diagnostics findings;
  BvhReadOptions options;
  options.metres_per_unit = 1.0;
  options.diagnostics = &findings;
  const Result<motion::Clip> clip = load_bvh(path_, options);
  ASSERT_TRUE(clip.ok()) << clip.error().text();
  EXPECT_TRUE(findings.empty()) << findings.front().text();
  EXPECT_EQ(clip->skeleton.segments.size(), known.joints);
  EXPECT_EQ(clip->root_position.times.size(), known.frames);
  EXPECT_DOUBLE_EQ(clip->frame_rate_hz, known.rate);
  EXPECT_EQ(clip->name, path_.stem().string());

  const test::NaiveBvh naive = test::NaiveBvh::parse(*read_file(path_));
  ASSERT_EQ(naive.joints.size(), known.joints);
  for (std::size_t f = 0; f < known.frames; f += 17) {
    const auto ours = motion::pose_at(*clip, clip->root_position.times[f]);
    const auto theirs = naive.pose(f);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      ASSERT_EQ(clip->skeleton.segments[i].name, naive.joints[i].name);
      const Eigen::Vector3d p = from_y_up(Eigen::Vector3d(theirs[i].translation()));
      ASSERT_LT((ours[i].p_WL - p).norm(), 1e-9) << naive.joints[i].name << " in frame " << f;
    }
  }
}

TEST_P(BvhData, BonesPointAlongXToTheirOnlyChild) {
  const Result<motion::Clip> clip = load_bvh(path_);
  ASSERT_TRUE(clip.ok());
  const auto& segments = clip->skeleton.segments;
  std::vector<int> children(segments.size(), 0);
  for (const body::Segment& segment : segments) {
    if (segment.parent >= 0) {
      ++children[static_cast<std::size_t>(segment.parent)];
    }
  }
  int checked = 0;
  for (const body::Segment& segment : segments) {
    if (segment.parent >= 0 && children[static_cast<std::size_t>(segment.parent)] == 1) {
      const double length = segments[static_cast<std::size_t>(segment.parent)].length;
      EXPECT_LT((segment.p_PL - Eigen::Vector3d(length, 0, 0)).norm(), 1e-9) << segment.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 10);
}

TEST_P(BvhData, UnitIsGuessed) {
  BvhReadOptions options;
  options.metres_per_unit = 1.0;
  const Result<motion::Clip> clip = load_bvh(path_, options);
  ASSERT_TRUE(clip.ok());
  EXPECT_EQ(guess_metres_per_unit(clip->skeleton), GetParam().metres_per_unit);
  options.metres_per_unit.reset();
  const Result<motion::Clip> guessed = load_bvh(path_, options);
  ASSERT_TRUE(guessed.ok());
  EXPECT_NEAR(guessed->skeleton.segments.back().p_PL.norm(),
              clip->skeleton.segments.back().p_PL.norm() * GetParam().metres_per_unit, 1e-12);
}

TEST_P(BvhData, SurvivesWritingAndReading) {
  BvhReadOptions options;
  options.metres_per_unit.reset();
  options.skip_frames = 1;
  const Result<motion::Clip> clip = load_bvh(path_, options);
  ASSERT_TRUE(clip.ok());
  EXPECT_EQ(clip->root_position.times.size(), GetParam().frames - 1);
  const Result<std::string> text = bvh_text(*clip);
  ASSERT_TRUE(text.ok()) << text.error().text();
  const Result<motion::Clip> again = read_bvh(*text, "again");
  ASSERT_TRUE(again.ok()) << again.error().text();
  ASSERT_EQ(again->root_position.times.size(), clip->root_position.times.size());
  for (std::size_t f = 0; f < clip->root_position.times.size(); f += 7) {
    const double t = clip->root_position.times[f];
    const auto a = motion::pose_at(*clip, t);
    const auto b = motion::pose_at(*again, t);
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_LT((a[i].p_WL - b[i].p_WL).norm(), 1e-6) << clip->skeleton.segments[i].name << " in frame " << f;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BvhData, testing::ValuesIn(kFiles));

}  // namespace
}  // namespace limbwave::interchange
