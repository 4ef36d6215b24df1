// Odd files that must be read, and broken ones that must be refused with the line.
#include "interchange/bvh_reader.h"

#include <gtest/gtest.h>

#include <random>

#include "base/units.h"
#include "geometry/so3.h"
#include "interchange/bvh_writer.h"
#include "interchange/frame_rate.h"
#include "interchange/random_clip.h"

namespace limbwave::interchange {
namespace {

constexpr const char* kArm = R"(HIERARCHY
ROOT Upper
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Fore
  {
    OFFSET 0 30 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 25 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.04
0 100 0 0 0 0 90 0 0
0 100 0 0 0 0 0 90 0
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

motion::Clip must_read(const std::string& text, BvhReadOptions options = {}) {
  Result<motion::Clip> clip = read_bvh(text, "arm.bvh", options);
  EXPECT_TRUE(clip.ok()) << clip.error().text();
  return clip.ok() ? *clip : motion::Clip();
}

// Where the hand is in the first frame.
Eigen::Vector3d hand(const motion::Clip& clip, double t = 0.0) {
  const auto poses = motion::pose_at(clip, t);
  return poses.back().p_WL + poses.back().R_WL * Eigen::Vector3d(clip.skeleton.segments.back().length, 0, 0);
}

TEST(BvhReader, ReadsAxesUnitsAndLengths) {
  const motion::Clip clip = must_read(kArm);
  EXPECT_EQ(clip.frame_rate_hz, 25.0);
  EXPECT_DOUBLE_EQ(clip.duration(), 0.04);
  EXPECT_DOUBLE_EQ(clip.skeleton.segments[0].length, 0.3);
  EXPECT_DOUBLE_EQ(clip.skeleton.segments[1].length, 0.25);
  // Turned by +90° about the file's Z the upward forearm points to −X, which is −y in W; about X it
  // points to Z, which is x in W.
  EXPECT_LT((hand(clip, 0.0) - Eigen::Vector3d(0, -0.25, 1.3)).norm(), 1e-12);
  EXPECT_LT((hand(clip, 0.04) - Eigen::Vector3d(0.25, 0, 1.3)).norm(), 1e-12);
}

TEST(BvhReader, KeepsFileAxesOnRequest) {
  BvhReadOptions options;
  options.frames = BoneFrames::kFile;
  const motion::Clip clip = must_read(kArm, options);
  EXPECT_LT((clip.skeleton.segments[1].p_PL - Eigen::Vector3d(0, 0, 0.3)).norm(), 1e-15);
  EXPECT_LT(geometry::geodesic_angle(clip.skeleton.segments[1].R_PL_rest, Eigen::Quaterniond::Identity()), 1e-15);
  const Eigen::Quaterniond expected(Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitX()));
  EXPECT_LT(geometry::geodesic_angle(clip.joints[1].rotation.values[0], expected), 1e-12);
  options.up = UpAxis::kZ;
  EXPECT_LT((must_read(kArm, options).skeleton.segments[1].p_PL - Eigen::Vector3d(0, 0.3, 0)).norm(), 1e-15);
}

TEST(BvhReader, AcceptsWhatOtherProgramsWrite) {
  const Eigen::Vector3d expected = hand(must_read(kArm));
  const auto same = [&](const std::string& text) { return (hand(must_read(text)) - expected).norm() < 1e-12; };
  std::string crlf = kArm;
  for (std::size_t i = 0; (i = crlf.find('\n', i)) != std::string::npos; i += 2) {
    crlf.replace(i, 1, "\r\n");
  }
  EXPECT_TRUE(same(crlf));
  std::string old_mac = kArm;
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  EXPECT_TRUE(same(old_mac));
  std::string tabs = kArm;
  std::replace(tabs.begin(), tabs.end(), ' ', '\t');
  EXPECT_TRUE(same(replaced(tabs, "Frame\tTime:\t", "Frame Time:")));
  EXPECT_TRUE(same(std::string("\xEF\xBB\xBF") + kArm));
  EXPECT_TRUE(same("# exported by a program\n" + replaced(kArm, "MOTION", "  # the motion\nMOTION")));
  EXPECT_TRUE(same(replaced(kArm, "JOINT Fore\n  {", "joint Fore {")));
  EXPECT_TRUE(same(replaced(kArm, "Zrotation Xrotation Yrotation\n    End", "ZROTATION xrotation Yrotation\n    End")));
  EXPECT_TRUE(same(replaced(kArm, "Frame Time: 0.04", "Frame Time: .04   ")));
  EXPECT_TRUE(same(replaced(kArm, "Frames: 2", "Frames:\t2.0\n")));
  EXPECT_TRUE(same(replaced(kArm, "0 100 0 0 0 0 90 0 0", "0 +1.0e2 0 0 0 0 9e1 -0.0 0   \n\n   ")));
  EXPECT_TRUE(same(replaced(kArm, "0 0 0 0 90 0\n", "0 0 0 0 90 0")));  // no line end at the end
}

TEST(BvhReader, AnyOrderOfChannels) {
  // The same pose in another order of channels, positions last and between.
  const motion::Clip clip =
      must_read(replaced(replaced(kArm, "Xposition Yposition Zposition Zrotation Xrotation Yrotation",
                                  "Yrotation Zposition Zrotation Yposition Xrotation Xposition"),
                         "0 100 0 0 0 0 90 0 0", "0 0 0 100 0 0 90 0 0"));
  EXPECT_LT((hand(clip) - Eigen::Vector3d(0, -0.25, 1.3)).norm(), 1e-12);
  // Listed order is the order of multiplication: first about X, then about the turned Z.
  const motion::Clip xz = must_read(replaced(replaced(kArm, "3 Zrotation Xrotation Yrotation", "2 Xrotation Zrotation"),
                                             "90 0 0\n0 100 0 0 0 0 0 90 0", "90 90\n0 100 0 0 0 0 0 0"));
  EXPECT_LT((hand(xz) - Eigen::Vector3d(0, -0.25, 1.3)).norm(), 1e-12);
  const motion::Clip zx = must_read(replaced(replaced(kArm, "3 Zrotation Xrotation Yrotation", "2 Zrotation Xrotation"),
                                             "90 0 0\n0 100 0 0 0 0 0 90 0", "90 90\n0 100 0 0 0 0 0 0"));
  EXPECT_LT((hand(zx) - Eigen::Vector3d(0.25, 0, 1.3)).norm(), 1e-12);
}

std::string with_positions(const std::string& first, const std::string& second) {
  return replaced(replaced(replaced(kArm, "3 Zrotation", "6 Xposition Yposition Zposition Zrotation"), "90 0 0\n",
                           first + " 90 0 0\n"),
                  "0 100 0 0 0 0 0 90 0\n", "0 100 0 0 0 0 " + second + " 0 90 0\n");
}

TEST(BvhReader, PositionChannelsOfJointsGiveTheirPlace) {
  // The whole position, as most programs write it; or what is added to OFFSET.
  EXPECT_NEAR(hand(must_read(with_positions("0 31 0", "0 31 0"))).z(), 1.31, 1e-12);
  EXPECT_NEAR(hand(must_read(with_positions("0 1 0", "0 1 0"))).z(), 1.31, 1e-12);
  Diagnostics findings;
  BvhReadOptions options;
  options.diagnostics = &findings;
  const motion::Clip sliding = must_read(with_positions("0 31 0", "0 33 0"), options);
  EXPECT_NEAR(hand(sliding).z(), 1.31, 1e-12);
  EXPECT_NEAR(motion::pose_at(sliding, sliding.duration())[1].p_WL.z(), 1.33, 1e-12);
  EXPECT_NEAR(sliding.skeleton.segments[1].p_PL.norm(), 0.32, 1e-12);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "bvh.joint-slides");
  EXPECT_NE(findings[0].message.find("by 20.00 mm"), std::string::npos) << findings[0].text();
}

TEST(BvhReader, JointsWithoutChannelsStayAtRest) {
  const motion::Clip clip = must_read(replaced(replaced(kArm, "CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 0"),
                                               "90 0 0\n0 100 0 0 0 0 0 90 0", "\n0 100 0 0 0 0"));
  EXPECT_TRUE(clip.joints[1].rotation.empty());
  EXPECT_EQ(clip.skeleton.segments[1].joint.kind, body::JointKind::kFixed);
  EXPECT_LT((hand(clip) - Eigen::Vector3d(0, 0, 1.55)).norm(), 1e-12);
}

TEST(BvhReader, FrameCountsThatDoNotMatchAreReported) {
  Diagnostics findings;
  BvhReadOptions options;
  options.diagnostics = &findings;
  EXPECT_EQ(must_read(replaced(kArm, "Frames: 2", "Frames: 0"), options).root_position.times.size(), 2U);
  EXPECT_EQ(must_read(replaced(kArm, "Frames: 2", "Frames: 999999999999999"), options).root_position.times.size(), 2U);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[1].code, "bvh.frame-count");
  findings.clear();
  // Broken off inside the last line.
  EXPECT_EQ(must_read(replaced(kArm, "0 0 0 0 90 0\n", "0 0"), options).root_position.times.size(), 1U);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].code, "bvh.truncated");
  EXPECT_EQ(findings[0].place, "arm.bvh, line 20");
}

TEST(BvhReader, SkipsFrames) {
  BvhReadOptions options;
  options.skip_frames = 1;
  const motion::Clip clip = must_read(kArm, options);
  EXPECT_EQ(clip.root_position.times, std::vector<double>{0.0});
  EXPECT_LT((hand(clip) - Eigen::Vector3d(0.25, 0, 1.3)).norm(), 1e-12);
  options.skip_frames = 5;
  EXPECT_TRUE(must_read(kArm, options).root_position.empty());
}

struct Broken {
  const char* from;
  const char* to;
  const char* place;
  const char* word;  ///< Must stand in the message.
};

class BvhReaderRefuses : public testing::TestWithParam<Broken> {};

TEST_P(BvhReaderRefuses, WithTheLine) {
  const Result<motion::Clip> clip = read_bvh(replaced(kArm, GetParam().from, GetParam().to), "arm.bvh");
  ASSERT_FALSE(clip.ok());
  EXPECT_EQ(clip.error().place, GetParam().place) << clip.error().text();
  EXPECT_NE(clip.error().message.find(GetParam().word), std::string::npos) << clip.error().text();
  EXPECT_EQ(clip.error().text().find('\n'), std::string::npos);
  EXPECT_FALSE(clip.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Files, BvhReaderRefuses,
    testing::Values(Broken{"HIERARCHY", "", "arm.bvh:2", "HIERARCHY"}, Broken{"ROOT", "BONE", "arm.bvh:2", "ROOT"},
                    Broken{"{", "", "arm.bvh:4", "{"}, Broken{"0 30 0", "0 x 0", "arm.bvh:8", "\"x\""},
                    Broken{"0 30 0", "0 30", "arm.bvh:9", "OFFSET"},
                    Broken{"0 30 0", "0 1e300 0", "arm.bvh:8", "1e+300"},
                    Broken{"0 30 0", "0 nan 0", "arm.bvh:8", "nan"}, Broken{"0 30 0", "0 30,5 0", "arm.bvh:8", "30,5"},
                    Broken{"CHANNELS 3", "CHANNELS 4", "arm.bvh:10", "channel"},
                    Broken{"CHANNELS 3", "CHANNELS 99999999999", "arm.bvh:9", "channels"},
                    Broken{"CHANNELS 3", "CHANNELS -1", "arm.bvh:9", "channels"},
                    Broken{"CHANNELS 3 Zrotation", "CHANNELS 3 Xrotation", "arm.bvh:9", "twice"},
                    Broken{"CHANNELS 3 Zrotation", "CHANNELS 3 Wrotation", "arm.bvh:9", "Wrotation"},
                    Broken{"}\nMOTION", "MOTION", "arm.bvh:15", "MOTION"},
                    Broken{"MOTION", "ROOT Second\n{\n}\nMOTION", "arm.bvh:16", "second ROOT"},
                    Broken{"Frames: 2", "Frames: -2", "arm.bvh:17", "-2"},
                    Broken{"Frames: 2", "Frames: 1.5", "arm.bvh:17", "1.5"},
                    Broken{"Frames: 2\n", "", "arm.bvh:18", "Frames:"},
                    Broken{"Frame Time: 0.04", "Frame Time: 0", "arm.bvh:18", "Frame Time"},
                    Broken{"Frame Time: 0.04", "Frame Time: nan", "arm.bvh:18", "nan"},
                    Broken{"Frame Time: 0.04", "Frame Time: 1e30", "arm.bvh:18", "Frame Time"},
                    Broken{"0 0 0 0 90 0 0\n", "0 0 0 0 90 0\n", "arm.bvh:19", "8 values instead of 9"},
                    Broken{"0 0 0 0 90 0 0\n", "0 0 0 0 90 0 0 7\n", "arm.bvh:19", "more than 9"},
                    Broken{"0 0 0 0 90 0 0\n", "0 0 0 0 -1.#IND 0 0\n", "arm.bvh:19", "-1.#IND"},
                    Broken{"0 0 0 0 90 0 0\n", "0 0 0 0 inf 0 0\n", "arm.bvh:19", "inf"},
                    Broken{"0 0 0 0 90 0 0\n", "0 0 0 0 90,5 0 0\n", "arm.bvh:19", "90,5"}));

TEST(BvhReader, RefusesEmptyAndForeignFiles) {
  for (const std::string& text :
       {std::string(), std::string(" \n"), std::string(1000, '\0'), std::string("glTF\2\0\0\0", 8),
        std::string("\xFF\xFEH\0I\0", 6), std::string(100000, '{')}) {
    const Result<motion::Clip> clip = read_bvh(text, "x.bvh");
    ASSERT_FALSE(clip.ok());
    EXPECT_EQ(clip.error().text().find('\n'), std::string::npos);
    EXPECT_LT(clip.error().text().size(), 300U);
  }
}

TEST(BvhReader, EveryTruncationAndManyMutationsAreSurvived) {
  const Result<std::string> text = bvh_text(test::random_clip(6, 12, 60.0, 11));
  ASSERT_TRUE(text.ok());
  for (std::size_t length = 0; length < text->size(); ++length) {
    const Result<motion::Clip> clip = read_bvh(std::string_view(*text).substr(0, length), "t");
    if (clip) {
      ASSERT_LE(clip->root_position.times.size(), 12U);
    }
  }
  std::mt19937 random(12);
  const std::string alphabet = "0123456789.-+eE \t\r\n{}:#XYZnaiJOINTEndSte\xC3\xFF";
  for (int round = 0; round < 4000; ++round) {
    std::string mutated = *text;
    for (int n = 0; n < 1 + round % 6; ++n) {
      const std::size_t at = random() % mutated.size();
      switch (random() % 3) {
        case 0:
          mutated[at] = alphabet[random() % alphabet.size()];
          break;
        case 1:
          mutated.erase(at, random() % 40);
          break;
        default:
          mutated.insert(at, mutated.substr(random() % mutated.size(), random() % 40));
      }
    }
    const Result<motion::Clip> clip = read_bvh(mutated, "m");
    if (clip) {
      for (const body::SegmentPose& pose : motion::pose_at(*clip, 0.05)) {
        ASSERT_TRUE(pose.p_WL.allFinite() && pose.R_WL.coeffs().allFinite());
      }
    } else {
      ASSERT_EQ(clip.error().text().find('\n'), std::string::npos);
    }
  }
}

TEST(BvhReader, DeepAndWideHierarchiesAreRead) {
  std::string deep = "HIERARCHY\nROOT a\n{ CHANNELS 1 Xrotation\n";
  constexpr int kDepth = 100000;
  for (int i = 0; i < kDepth; ++i) {
    deep += "JOINT a { OFFSET 0 1 0 CHANNELS 0\n";
  }
  deep += std::string(kDepth + 1, '}') + "\nMOTION\nFrames: 1\nFrame Time: 0.1\n90\n";
  const motion::Clip clip = must_read(deep);
  ASSERT_EQ(clip.skeleton.segments.size(), kDepth + 1U);
  EXPECT_EQ(clip.skeleton.segments.back().name, "a_" + std::to_string(kDepth + 1));
}

TEST(FrameRate, RoundedFrameTimesMeanCommonRates) {
  EXPECT_EQ(frame_rate_from_text(0.0083333, "0.0083333"), 120.0);
  EXPECT_EQ(frame_rate_from_text(0.0083333, ".0083333"), 120.0);
  EXPECT_EQ(frame_rate_from_text(0.008333, "0.008333"), 120.0);
  EXPECT_EQ(frame_rate_from_text(0.0333, "0.0333"), 30.0);
  EXPECT_EQ(frame_rate_from_text(0.033333, "0.033333"), 30.0);
  EXPECT_EQ(frame_rate_from_text(0.0167, "0.0167"), 60.0);
  EXPECT_EQ(frame_rate_from_text(0.016667, "0.016667"), 60.0);
  EXPECT_EQ(frame_rate_from_text(0.0417083, "0.0417083"), 24 / 1.001);
  EXPECT_EQ(frame_rate_from_text(0.0333667, "0.0333667"), 30 / 1.001);
  EXPECT_EQ(frame_rate_from_text(0.04, "0.04"), 25.0);
  EXPECT_EQ(frame_rate_from_text(0.03, "0.03"), 1.0 / 0.03);
  EXPECT_EQ(frame_rate_from_text(1.0 / 47.3, "0.021141649048625793"), 1.0 / (1.0 / 47.3));
}

}  // namespace
}  // namespace limbwave::interchange
