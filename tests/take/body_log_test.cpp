// Logs of other people's sensors: what is wrong with one is said in a line, with its place.
#include "take/body_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.h"

namespace limbwave::take {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kInertial = "time_s,sensor,wx_rad_s,wy_rad_s,wz_rad_s,ax_m_s2,ay_m_s2,az_m_s2\n";
constexpr const char* kRanges = "time_s,source,receiver,range_m,confidence\n";

class BodyLog : public testing::Test {
 protected:
  BodyLog() {
    const auto rig = body::load_rig("driver-box-body");
    const auto skeleton = body::load_skeleton(rig->skeleton);
    model_ = estimate::body_model(*rig, *skeleton);
    rig_ = *rig;
    skeleton_ = *skeleton;
  }
  fs::path write(const std::string& text, const std::string& name = "log.csv") {
    fs::path path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  // One located line.
  void refused(const std::string& text, const std::string& place, const std::string& message) {
    const auto readings = read_logs({write(text)}, model_);
    ASSERT_FALSE(readings.ok()) << text.substr(0, 200);
    const std::string line = readings.error().text();
    EXPECT_THAT(line, HasSubstr((folder_.path() / ("log.csv" + place)).string() + ": "));
    EXPECT_THAT(line, HasSubstr(message));
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 0);
    // Nothing is left of an import.
    const fs::path take = folder_.path() / "log.take";
    EXPECT_FALSE(import_logs(take, {folder_.path() / "log.csv"}, rig_, skeleton_, "").ok());
    EXPECT_FALSE(fs::exists(take));
  }
  test::TemporaryFolder folder_;
  estimate::BodyModel model_;
  body::Rig rig_;
  body::Skeleton skeleton_;
};

TEST_F(BodyLog, ReadsWhatItShall) {
  const fs::path inertial = write(std::string("\xEF\xBB\xBF") + kInertial +
                                      "0,pelvis,1,2,3,4,5,6\r\n\r\n0.01, pelvis ,,,,7,8,9\r\n"
                                      "0.02,\"left hand\",1e-3,-2.5E+1,+3,4,5,6",
                                  "i.csv");
  const fs::path ranges = write(
      "confidence,extra,range_m,receiver,source,time_s\n"
      ",x,0.5,head,belly left,0.004\n1,x,,head,belly left,0.005\n0.5,x,0.75,pelvis,hat,0.006\n",
      "r.csv");
  const auto readings = read_logs({inertial, ranges}, model_);
  ASSERT_TRUE(readings.ok()) << readings.error().text();
  ASSERT_EQ(readings->inertial.size(), 3U);
  EXPECT_TRUE(std::isnan(readings->inertial[1].w_S.x()));
  EXPECT_EQ(readings->inertial[1].f_S, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(readings->inertial[2].w_S, Eigen::Vector3d(1e-3, -25, 3));
  EXPECT_EQ(readings->inertial[2].board, model_.find_board("left hand"));
  ASSERT_EQ(readings->ranges.size(), 2U);  // one was not heard
  EXPECT_EQ(readings->ranges[0].confidence, 1.0);
  EXPECT_EQ(readings->ranges[1].source, model_.find_source("hat"));
}

TEST_F(BodyLog, MissingColumns) {
  refused("a,b,c\n1,2,3\n", "", "has neither the columns");
  refused("sensor,wx_rad_s,wy_rad_s,wz_rad_s,ax_m_s2,ay_m_s2,az_m_s2\npelvis,1,2,3,4,5,6\n", "", "\"time_s\"");
  refused("time_s,wx_rad_s,wy_rad_s,wz_rad_s,ax_m_s2,ay_m_s2,az_m_s2\n0,1,2,3,4,5,6\n", "", "\"sensor\"");
  refused("time_s,sensor,wx_rad_s,wy_rad_s,ax_m_s2,ay_m_s2,az_m_s2\n0,pelvis,1,2,4,5,6\n", "", "\"wz_rad_s\"");
  refused("time_s,receiver,range_m,confidence\n0,pelvis,1,1\n", "", "\"source\"");
  refused("time_s,source,range_m,confidence\n0,hat,1,1\n", "", "\"receiver\"");
}

TEST_F(BodyLog, CellsThatAreNoNumbers) {
  const std::string good = "0,pelvis,1,2,3,4,5,6\n";
  refused(kInertial + good + "0.01,pelvis,1,2,x,4,5,6\n", ":3", "not a number");
  refused(kInertial + good + ",pelvis,1,2,3,4,5,6\n", ":3", "not a number");
  refused(kInertial + good + "nan,pelvis,1,2,3,4,5,6\n", ":3", "not a number");
  refused(kInertial + good + "0.01,pelvis,1,2,3,4,5,inf\n", ":3", "not a number");
  refused(kInertial + good + "0.01,pelvis,1,2,NaN,4,5,6\n", ":3", "not a number");
  refused(kInertial + good + "1e999,pelvis,1,2,3,4,5,6\n", ":3", "not a number");
  refused(kInertial + good + "0x10,pelvis,1,2,3,4,5,6\n", ":3", "not a number");
  refused(kInertial + good + "0.01;pelvis;1;2;3;4;5;6\n", ":3", "");
  refused(std::string(kRanges) + "0,hat,pelvis,far,1\n", ":2", "not a number");
  refused(std::string(kRanges) + "0,hat\n", ":2", "");
}

TEST_F(BodyLog, RowsThatEndTooSoon) {
  refused(std::string(kInertial) + "0,pelvis,1,2,3,4,5,6\n0.01\n", ":3", "");
  refused(std::string(kInertial) + "0,pelvis,1,2,3,4,5,6\n0.01,pelvis,1,2\n", ":3", "fewer cells");
}

TEST_F(BodyLog, TimeThatGoesBack) {
  refused(std::string(kInertial) + "0.02,pelvis,1,2,3,4,5,6\n0.01,head,1,2,3,4,5,6\n", ":3", "earlier");
  refused(std::string(kRanges) + "1,hat,pelvis,0.5,1\n0.5,hat,pelvis,0.5,1\n", ":3", "earlier");
}

TEST_F(BodyLog, BoardsThatTheRigLacks) {
  refused(std::string(kInertial) + "0,tail,1,2,3,4,5,6\n", ":2", "\"tail\"");
  refused(std::string(kInertial) + "0,,1,2,3,4,5,6\n", ":2", "\"\"");
  refused(std::string(kRanges) + "0,moon,pelvis,1,1\n", ":2", "\"moon\"");
}

TEST_F(BodyLog, NothingInIt) {
  refused("", "", "is empty");
  refused("\n\n \n", "", "is empty");
  refused(kInertial, "", "has no reading");
  EXPECT_FALSE(read_logs({folder_.path() / "none.csv"}, model_).ok());
  fs::create_directory(folder_.path() / "folder.csv");
  EXPECT_FALSE(read_logs({folder_.path() / "folder.csv"}, model_).ok());
  refused(std::string(4096, '\0'), "", "");
}

TEST_F(BodyLog, RangesThatCannotBe) {
  refused(std::string(kRanges) + "0,hat,pelvis,-1,1\n", ":2", "range");
  refused(std::string(kRanges) + "0,hat,pelvis,1,7\n", ":2", "confidence");
}

// A long recording reads in one go: half a million rows.
TEST_F(BodyLog, AHugeOne) {
  std::string text = kInertial;
  constexpr int kRows = 500000;
  for (int i = 0; i < kRows; ++i) {
    text += std::to_string(i / 100.0) + ",pelvis,0.1,-0.2,0.3,0.01,9.8,0.02\n";
  }
  const auto readings = read_logs({write(text)}, model_);
  ASSERT_TRUE(readings.ok());
  EXPECT_EQ(readings->inertial.size(), static_cast<std::size_t>(kRows));
  refused(text + "0,pelvis,1,2,3,4,5,6\n", ":" + std::to_string(kRows + 2), "earlier");
}

}  // namespace
}  // namespace limbwave::take
