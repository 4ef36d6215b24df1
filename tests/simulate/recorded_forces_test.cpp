#include "simulate/recorded_forces.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::simulate {
namespace {

namespace fs = std::filesystem;

Result<ForceLog> read_force_log(const fs::path& path) {
  auto logs = read_force_file(path);
  return logs ? Result<ForceLog>(logs->front()) : logs.error();
}

class Logs : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("limbwave-logs-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  static std::string rows(int count, const std::string& truth = ",1,0,0,0") {
    std::ostringstream text;
    text << "time_s,ax_m_s2,ay_m_s2,az_m_s2,truth_qw,truth_qx,truth_qy,truth_qz\n";
    for (int i = 0; i < count; ++i) {
      text << i * 0.01 << "," << i << ",0.5,-" << i * 0.25 << truth << "\n";
    }
    return text.str();
  }
  fs::path folder_;
};

fs::path data(const std::string& name) {
  const char* folder = std::getenv("LIMBWAVE_DATA");
  return fs::path(folder == nullptr ? "" : folder) / "inertial" / name;
}

TEST_F(Logs, PlainAndPackedSayTheSame) {
  const std::string text = rows(400);
  const fs::path plain = write("log.csv", text);
  const fs::path packed = folder_ / "log.csv.gz";
  gzFile file = gzopen(packed.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  for (const fs::path& path : {plain, packed}) {
    const auto log = read_force_log(path);
    ASSERT_TRUE(log) << log.error().text();
    ASSERT_EQ(log->times.size(), 400U);
    EXPECT_NEAR(log->duration(), 3.99, 1e-9);
    EXPECT_EQ(log->f_S[7], Vector3d(7.0, 0.5, -1.75));
    EXPECT_TRUE(log->R_WS[7]);
  }
}

TEST_F(Logs, MalformedFilesAreRefusedWithTheLine) {
  const auto error_of = [&](const std::string& text) {
    const auto log = read_force_log(write("bad.csv", text));
    return log ? std::string() : log.error().text();
  };
  EXPECT_NE(error_of(""), "");
  EXPECT_NE(error_of("a,b,c\n1,2,3\n").find("columns"), std::string::npos);
  EXPECT_NE(error_of("time_s,ax_m_s2,ay_m_s2,az_m_s2\n0,1,2,x\n").find("bad.csv:2"), std::string::npos);
  EXPECT_NE(error_of("time_s,ax_m_s2,ay_m_s2,az_m_s2\n0,1,2,nan\n").find("bad.csv:2"), std::string::npos);
  EXPECT_NE(error_of("time_s,ax_m_s2,ay_m_s2,az_m_s2\n1,1,2,3\n0.5,1,2,3\n").find("bad.csv:3"), std::string::npos);
  EXPECT_NE(error_of("time_s,ax_m_s2,ay_m_s2,az_m_s2\n,1,2,3\n").find("bad.csv:2"), std::string::npos);
  EXPECT_NE(error_of(rows(20)).find("two seconds"), std::string::npos);
  EXPECT_NE(error_of("PacketCounter\tAcc_X\tAcc_Y\tAcc_Z\n1\t1\t2\t3\n").find("Update Rate"), std::string::npos);
  std::ofstream(folder_ / "cut.csv.gz", std::ios::binary) << "\x1f\x8b\x08";
  EXPECT_FALSE(read_force_log(folder_ / "cut.csv.gz"));
  EXPECT_FALSE(read_force_log(folder_ / "missing.csv"));
}

TEST_F(Logs, EmptyTruthIsUnknownAndTimesBetweenAreInterpolated) {
  std::string text = rows(400);
  const std::size_t at = text.find("\n1,100,");  // the row of 1 s
  ASSERT_NE(at, std::string::npos);
  const std::size_t truth = text.find(",1,0,0,0", at);
  text.replace(truth, 8, ",,,,");
  const auto log = read_force_log(write("log.csv", text));
  ASSERT_TRUE(log) << log.error().text();
  const RecordedForces forces({*log}, 1);
  EXPECT_FALSE(forces.orientation(0, 1.0));
  EXPECT_FALSE(forces.orientation(0, 0.995));
  EXPECT_TRUE(forces.orientation(0, 0.985));
  EXPECT_TRUE(forces.orientation(0, 1.015));
  EXPECT_LT((forces.force(0, 0.5055) - Vector3d(50.55, 0.5, -50.55 * 0.25)).norm(), 1e-9);  // a line stays one
}

TEST_F(Logs, OneFileMayHoldSeveralSensors) {
  std::string text = "time_s,sensor,wx_rad_s,ax_m_s2,ay_m_s2,az_m_s2\n";
  for (int i = 0; i < 300; ++i) {
    text += std::to_string(0.01 * i) + ",hand,0.1," + std::to_string(i) + ",0,9.8\n";
    text += std::to_string(0.01 * i) + ",forearm,,0,5,9.8\n";
  }
  const auto logs = read_force_logs(write("two.csv", text).string(), 5);
  ASSERT_TRUE(logs) << logs.error().text();
  ASSERT_EQ(logs->size(), 2U);
  EXPECT_EQ(logs->at(0).name, "hand");
  EXPECT_EQ(logs->at(0).f_S[20], Vector3d(20, 0, 9.8));
  EXPECT_EQ(logs->at(1).f_S[20], Vector3d(0, 5, 9.8));
  EXPECT_FALSE(logs->at(1).R_WS[20]);
}

TEST_F(Logs, PacketCountersTurnOverAndShowLostPackets) {
  std::string text = "// Update Rate: 100.0Hz\nPacketCounter\tAcc_X\tAcc_Y\tAcc_Z\n";
  for (int i = 0; i < 400; ++i) {
    if (i < 150 || i >= 170) {
      text += std::to_string((65400 + i) % 65536) + "\t" + std::to_string(i) + "\t0\t9.8\n";
    }
  }
  const auto log = read_force_log(write("MT.txt", text));
  ASSERT_TRUE(log) << log.error().text();
  EXPECT_NEAR(log->duration(), 3.99, 1e-9);
  EXPECT_NEAR(log->times[150] - log->times[149], 0.21, 1e-9);
  EXPECT_FALSE(read_force_log(write("back.txt", text + "100\t0\t0\t9.8\n")));
}

TEST_F(Logs, SensorsShareOneLogInStretchesThatWrapSmoothly) {
  const auto log = read_force_log(write("log.csv", rows(501)));
  ASSERT_TRUE(log);
  const RecordedForces forces({*log}, 5);
  for (int sensor = 0; sensor < 5; ++sensor) {
    EXPECT_NEAR(forces.force(sensor, 0.2).x(), sensor * 100 + 20.0, 1e-6);
    EXPECT_NEAR(forces.force(sensor, 0.2 + 5.0).x(), sensor * 100 + 20.0, 1e-6);
  }
  double before = forces.force(3, 0.0).x();
  for (double t = 0.001; t < 6.0; t += 0.001) {
    const double now = forces.force(3, t).x();
    ASSERT_LT(std::abs(now - before), 3.0) << t;
    before = now;
  }
  EXPECT_FALSE(forces.orientation(3, 1.8));  // blended from the end to the beginning
}

TEST(RealLogs, BroadReplaysWhatTheFileSays) {
  const fs::path path = data("broad-02-slow-rotation.csv.gz");
  if (!fs::exists(path)) {
    GTEST_SKIP() << "needs " << path;
  }
  const auto log = read_force_log(path);
  ASSERT_TRUE(log) << log.error().text();
  const RecordedForces forces({*log}, 1);
  // The row of 104.993 s, copied from the file.
  const double t = 104.993;
  EXPECT_LT((forces.force(0, t) - Vector3d(9.1446, -0.9652, 3.1971)).norm(), 1e-6);
  const auto truth = forces.orientation(0, t);
  ASSERT_TRUE(truth);
  EXPECT_LT(geometry::geodesic_angle(*truth, Quaterniond(0.80385, -0.06448, -0.59131, -0.00394).normalized()), 1e-4);
  // Optical truth and gravity agree while it turns slowly.
  double error = 0.0;
  int count = 0;
  for (double s = 0.0; s < forces.duration() - 1.0; s += 0.1) {
    if (const auto R = forces.orientation(0, s)) {
      error += geometry::angle_between(*R * forces.force(0, s), Vector3d::UnitZ());
      ++count;
    }
  }
  ASSERT_GT(count, 500);
  EXPECT_LT(degrees(error / count), 5.0);
  EXPECT_FALSE(forces.orientation(0, 0.0));  // empty cells at the start
}

TEST(RealLogs, XsensFoldersGiveFiveSensorsOfOnePerson) {
  const fs::path path = data("xsens-walk");
  if (!fs::exists(path)) {
    GTEST_SKIP() << "needs " << path;
  }
  const auto logs = read_force_logs(path.string(), 5);
  ASSERT_TRUE(logs) << logs.error().text();
  ASSERT_EQ(logs->size(), 5U);
  const RecordedForces forces(*logs, 5);
  EXPECT_GT(forces.duration(), 10.0);
  for (int sensor = 0; sensor < 5; ++sensor) {
    const auto R = forces.orientation(sensor, 0.5);  // still standing
    ASSERT_TRUE(R);
    EXPECT_LT(degrees(geometry::angle_between(*R * forces.force(sensor, 0.5), Vector3d::UnitZ())), 5.0);
  }
}

}  // namespace
}  // namespace limbwave::simulate
