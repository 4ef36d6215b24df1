#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <filesystem>
#include <locale>
#include <set>
#include <sstream>

#include "base/files.h"
#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/file_axes.h"
#include "interchange/naive_bvh.h"
#include "interchange/random_clip.h"

namespace limbwave::interchange {
namespace {

using motion::Clip;

// Where every joint of `a` is, and how it is turned away from rest, against the joint of `b` with the same name.
void expect_same_motion(const Clip& a, const Clip& b) {
  const auto rest_a = motion::rest_poses(a.skeleton);
  const auto rest_b = motion::rest_poses(b.skeleton);
  for (const double t : motion::key_times(a)) {
    const auto pose_a = motion::pose_at(a, t);
    const auto pose_b = motion::pose_at(b, t);
    for (std::size_t i = 0; i < pose_a.size(); ++i) {
      const int found = b.skeleton.find(a.skeleton.segments[i].name);
      ASSERT_GE(found, 0) << a.skeleton.segments[i].name;
      const auto j = static_cast<std::size_t>(found);
      ASSERT_LT((pose_a[i].p_WL - pose_b[j].p_WL).norm(), 1e-4) << a.skeleton.segments[i].name << " at " << t;
      const Eigen::Quaterniond away_a = pose_a[i].R_WL * rest_a[i].R_WL.conjugate();
      const Eigen::Quaterniond away_b = pose_b[j].R_WL * rest_b[j].R_WL.conjugate();
      ASSERT_LT(degrees(geometry::geodesic_angle(away_a, away_b)), 0.01) << a.skeleton.segments[i].name << " at " << t;
    }
  }
}

struct Variant {
  BvhUnit unit;
  BvhRotationOrder order;
  BoneFrames frames;
};

class BvhRoundTrip : public testing::TestWithParam<Variant> {};

TEST_P(BvhRoundTrip, KeepsEveryJointAtEveryKey) {
  const Clip clip = test::random_clip(22, 240, 60.0, 7);
  const Result<std::string> text = bvh_text(clip, {GetParam().unit, GetParam().order, 0.0});
  ASSERT_TRUE(text.ok()) << text.error().text();
  BvhReadOptions options;
  options.metres_per_unit = GetParam().unit == BvhUnit::kMetres ? 1.0 : 0.01;
  options.frames = GetParam().frames;
  Diagnostics findings;
  options.diagnostics = &findings;
  const Result<Clip> read = read_bvh(*text, "test", options);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(findings.empty()) << findings.front().text();
  EXPECT_EQ(read->frame_rate_hz, 60.0);
  EXPECT_EQ(read->root_position.times.size(), 240U);
  expect_same_motion(clip, *read);
}

TEST_P(BvhRoundTrip, AgreesWithAPlainReading) {
  const Clip clip = test::random_clip(22, 120, 60.0, 8);
  const Result<std::string> text = bvh_text(clip, {GetParam().unit, GetParam().order, 0.0});
  ASSERT_TRUE(text.ok());
  const test::NaiveBvh naive = test::NaiveBvh::parse(*text);
  ASSERT_EQ(naive.frames, 120U);
  ASSERT_EQ(naive.joints.size(), 22U);
  EXPECT_EQ(naive.joints[0].offset.norm(), 0.0);
  const double metres = GetParam().unit == BvhUnit::kMetres ? 1.0 : 0.01;
  for (std::size_t f = 0; f < naive.frames; ++f) {
    const auto ours = motion::pose_at(clip, static_cast<double>(f) / 60.0);
    const auto theirs = naive.pose(f);
    for (std::size_t i = 0; i < theirs.size(); ++i) {
      const auto j = static_cast<std::size_t>(clip.skeleton.find(naive.joints[i].name));
      const Eigen::Vector3d p = from_y_up(Eigen::Vector3d(theirs[i].translation() * metres));
      ASSERT_LT((p - ours[j].p_WL).norm(), 1e-5) << naive.joints[i].name << " in frame " << f;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UnitsOrdersFrames, BvhRoundTrip,
                         testing::Values(Variant{BvhUnit::kCentimetres, BvhRotationOrder::kZXY, BoneFrames::kAlongBone},
                                         Variant{BvhUnit::kCentimetres, BvhRotationOrder::kZYX, BoneFrames::kAlongBone},
                                         Variant{BvhUnit::kMetres, BvhRotationOrder::kZXY, BoneFrames::kAlongBone},
                                         Variant{BvhUnit::kMetres, BvhRotationOrder::kZYX, BoneFrames::kFile}));

TEST(Bvh, AnglesDoNotJumpBetweenFrames) {
  // Three turns about every axis in turn, slowly: half-way between frames the angles must still show the motion.
  Clip clip = test::random_clip(1, 1, 60.0, 1);
  clip.skeleton.segments[0].R_PL_rest.setIdentity();
  clip.joints[0].rotation = {};
  for (int f = 0; f < 1080; ++f) {
    clip.joints[0].rotation.times.push_back(f / 60.0);
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(f / 360);
    clip.joints[0].rotation.values.emplace_back(Eigen::AngleAxisd(radians(3.0 * (f % 360)), axis));
  }
  const Result<std::string> text = bvh_text(clip);
  ASSERT_TRUE(text.ok());
  const test::NaiveBvh naive = test::NaiveBvh::parse(*text);
  for (std::size_t f = 1; f < naive.frames; ++f) {
    for (std::size_t c = 3; c < 6; ++c) {
      // A jump of both outer angles by half a turn is unavoidable only in the lock itself, which the rotation about x
      // passes; a fixed axis makes none.
      ASSERT_LT(std::abs(naive.values[f][c] - naive.values[f - 1][c]), 3.5) << "frame " << f << " channel " << c;
    }
  }
}

TEST(Bvh, NamesBecomePlainAndUnique) {
  Clip clip = test::random_clip(6, 2, 60.0, 3);
  clip.skeleton.segments[1].name = "left arm";
  clip.skeleton.segments[2].name = "left_arm";
  clip.skeleton.segments[3].name = "";
  clip.skeleton.segments[4].name = "Hüfte\xC2\xA0{links}";  // with a no-break space
  clip.skeleton.segments[5].name = "M\xFCll";               // Latin-1
  const Result<std::string> text = bvh_text(clip);
  ASSERT_TRUE(text.ok());
  const Result<Clip> read = read_bvh(*text, "test");
  ASSERT_TRUE(read.ok()) << read.error().text();
  std::set<std::string> names;
  for (const body::Segment& segment : read->skeleton.segments) {
    names.insert(segment.name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"joint0", "left_arm", "left_arm_2", "joint", "Hüfte__links_", "Müll"}));
}

// A locale of C++ with a decimal comma and grouped thousands, which needs none installed.
class Comma : public std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(Bvh, LocaleChangesNothing) {
  const Clip clip = test::random_clip(5, 3, 29.97, 4);
  const Result<std::string> plain = bvh_text(clip);
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    std::setlocale(LC_ALL, name);  // C's locale as well, where one is installed
  }
  const Result<std::string> german = bvh_text(clip);
  const Result<Clip> read = read_bvh(*german, "test");
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(*plain, *german);
  expect_same_motion(clip, *read);
}

TEST(Bvh, OneFrameAndZeroLengths) {
  Clip clip = test::random_clip(4, 1, 24.0, 5);
  for (body::Segment& segment : clip.skeleton.segments) {
    segment.length = 0.0;
    segment.p_PL.setZero();
  }
  const Result<std::string> text = bvh_text(clip);
  ASSERT_TRUE(text.ok());
  const Result<Clip> read = read_bvh(*text, "test");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->root_position.times.size(), 1U);
  expect_same_motion(clip, *read);
}

TEST(Bvh, AClipWithoutKeysIsOneFrameAtRest) {
  Clip clip = test::random_clip(3, 1, 60.0, 6);
  clip.joints.assign(3, {});
  clip.root_position = {};
  const Result<std::string> text = bvh_text(clip);
  ASSERT_TRUE(text.ok());
  const Result<Clip> read = read_bvh(*text, "test");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_LT((read->root_position.values.at(0) - clip.skeleton.segments[0].p_PL).norm(), 1e-7);
}

TEST(Bvh, FrameTimeIsExactAndFpsResamples) {
  const Clip clip = test::random_clip(3, 61, 60.0, 9);
  const Result<std::string> text = bvh_text(clip, {BvhUnit::kCentimetres, BvhRotationOrder::kZXY, 47.3});
  ASSERT_TRUE(text.ok());
  const test::NaiveBvh naive = test::NaiveBvh::parse(*text);
  EXPECT_EQ(naive.frames, 48U);
  EXPECT_EQ(naive.frame_time, 1.0 / 47.3);
  const Result<Clip> read = read_bvh(*text, "test");
  ASSERT_TRUE(read.ok());
  EXPECT_DOUBLE_EQ(read->frame_rate_hz, 47.3);
  for (std::size_t f = 0; f < naive.frames; ++f) {
    EXPECT_LT((motion::pose_at(*read, read->root_position.times[f])[0].p_WL -
               motion::pose_at(clip, static_cast<double>(f) / 47.3)[0].p_WL)
                  .norm(),
              1e-6);
  }
}

TEST(Bvh, RefusesWhatCannotBeWritten) {
  EXPECT_FALSE(bvh_text({}).ok());
  Clip clip = test::random_clip(2, 3, 60.0, 1);
  EXPECT_FALSE(bvh_text(clip, {BvhUnit::kCentimetres, BvhRotationOrder::kZXY, 1e9}).ok());
  clip.frame_rate_hz = 0.0;
  EXPECT_FALSE(bvh_text(clip).ok());
  clip.frame_rate_hz = 1000.0;
  clip.root_position.times.back() = 1e9;  // A mistake that would fill the memory.
  EXPECT_FALSE(bvh_text(clip).ok());
  clip.root_position.times.back() = 1.0;
  clip.frame_rate_hz = 60.0;
  clip.joints[1].rotation.values[1].w() = NAN;
  const Result<std::string> text = bvh_text(clip);
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().message.find("joint1"), std::string::npos) << text.error().text();
}

TEST(Bvh, CancelledOrFailedWritingLeavesNothing) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "bvh_cancel";
  std::filesystem::create_directories(folder);
  const Clip clip = test::random_clip(3, 5000, 60.0, 2);
  const Progress stop([](double fraction, std::string_view) { return fraction < 0.5; });
  const Status status = write_bvh(clip, folder / "a.bvh", {}, stop);
  ASSERT_FALSE(status.ok());
  EXPECT_TRUE(is_cancelled(status.error()));
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  EXPECT_FALSE(write_bvh(clip, folder / "missing" / "a.bvh").ok());
  ASSERT_TRUE(write_bvh(clip, folder / "a.bvh").ok());
  const Result<Clip> read = load_bvh(folder / "a.bvh");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->name, "a");
  std::filesystem::remove_all(folder);
}

TEST(Bvh, ReadingAndWritingAgainGivesTheSameFile) {
  const Result<std::string> first = bvh_text(test::random_clip(12, 30, 60.0, 10));
  ASSERT_TRUE(first.ok());
  const Result<Clip> read = read_bvh(*first, "test");
  ASSERT_TRUE(read.ok());
  const Result<std::string> second = bvh_text(*read);
  ASSERT_TRUE(second.ok());
  // End Sites too: the bones' directions live on in the rest orientations. Numbers may differ in the last digit.
  std::istringstream a(*first);
  std::istringstream b(*second);
  std::string word_a;
  std::string word_b;
  while (a >> word_a) {
    ASSERT_TRUE(b >> word_b);
    char* end = nullptr;
    const double number = std::strtod(word_a.c_str(), &end);
    if (end != word_a.c_str() && *end == '\0') {
      ASSERT_NEAR(number, std::strtod(word_b.c_str(), nullptr), 3e-6);
    } else {
      ASSERT_EQ(word_a, word_b);
    }
  }
}

TEST(BvhRoundTripOfSlidingJoints, KeepsEveryJointAtEveryKey) {
  Clip clip = test::random_clip(12, 60, 60.0, 3);
  for (const std::size_t joint : {2U, 7U}) {
    motion::PositionTrack& track = clip.joints[joint].position;
    track.times = clip.joints[joint].rotation.times;
    for (std::size_t f = 0; f < track.times.size(); ++f) {
      const double s = std::sin(0.1 * static_cast<double>(f));
      track.values.push_back(clip.skeleton.segments[joint].p_PL * (1.0 + 0.1 * s));
    }
  }
  const Result<std::string> text = bvh_text(clip);
  ASSERT_TRUE(text.ok());
  const Result<Clip> read = read_bvh(*text, "test");
  ASSERT_TRUE(read.ok()) << read.error().text();
  expect_same_motion(clip, *read);
}

}  // namespace
}  // namespace limbwave::interchange
