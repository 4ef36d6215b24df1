#include "interchange/csv_poses.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "base/files.h"
#include "interchange/random_clip.h"

namespace limbwave::interchange {
namespace {

TEST(CsvPoses, WritesEverySegmentAtEveryFrame) {
  motion::Clip clip;
  clip.frame_rate_hz = 2.0;
  body::Segment upper;
  upper.name = "upper \"right\", arm";
  body::Segment fore;
  fore.name = "fore";
  fore.parent = 0;
  fore.p_PL = {0.3, 0.0, 0.0};
  clip.skeleton.segments = {upper, fore};
  clip.joints.resize(2);
  clip.joints[0].rotation = {
      {0.0, 0.5},
      {Eigen::Quaterniond::Identity(), Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitZ()))}};
  const Result<std::string> text = csv_poses_text(clip);
  ASSERT_TRUE(text.ok()) << text.error().text();
  EXPECT_EQ(*text,
            "time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m\n"
            "0.000000,\"upper \"\"right\"\", arm\",1.000000000,0.000000000,0.000000000,0.000000000,"
            "0.000000,0.000000,0.000000\n"
            "0.000000,fore,1.000000000,0.000000000,0.000000000,0.000000000,0.300000,0.000000,0.000000\n"
            "0.500000,\"upper \"\"right\"\", arm\",0.707106781,0.000000000,0.000000000,0.707106781,"
            "0.000000,0.000000,0.000000\n"
            "0.500000,fore,0.707106781,0.000000000,0.000000000,0.707106781,0.000000,0.300000,0.000000\n");
}

TEST(CsvPoses, QuaternionsDoNotFlip) {
  const motion::Clip clip = test::random_clip(4, 200, 60.0, 61);
  const Result<std::string> text = csv_poses_text(clip, {30.0});
  ASSERT_TRUE(text.ok());
  std::istringstream lines(*text);
  std::string line;
  std::getline(lines, line);
  std::vector<Eigen::Quaterniond> previous(4, Eigen::Quaterniond::Identity());
  for (std::size_t row = 0; std::getline(lines, line); ++row) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    double time = 0;
    std::string name;
    Eigen::Quaterniond q;
    cells >> time >> name >> q.w() >> q.x() >> q.y() >> q.z();
    EXPECT_NEAR(time, static_cast<double>(row / 4) / 30.0, 1e-6);
    EXPECT_GE(q.dot(previous[row % 4]), 0.0) << line;
    previous[row % 4] = q;
  }
}

TEST(CsvPoses, FailedOrCancelledWritingLeavesNothing) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "csv_cancel";
  std::filesystem::create_directories(folder);
  motion::Clip clip = test::random_clip(3, 3000, 60.0, 62);
  const Progress stop([](double fraction, std::string_view) { return fraction < 0.5; });
  const Status status = write_csv_poses(clip, folder / "a.csv", {}, stop);
  ASSERT_FALSE(status.ok());
  EXPECT_TRUE(is_cancelled(status.error()));
  clip.joints[1].rotation.values[7].x() = NAN;
  EXPECT_FALSE(write_csv_poses(clip, folder / "a.csv").ok());
  clip.frame_rate_hz = 0.0;
  EXPECT_FALSE(write_csv_poses(clip, folder / "a.csv").ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace limbwave::interchange
