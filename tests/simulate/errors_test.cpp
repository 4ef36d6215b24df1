#include "simulate/errors.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

namespace fs = std::filesystem;

class ErrorsFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("limbwave-errors-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  fs::path folder_;
};

TEST(Errors, ShippedProfilesSayWhatTheErrorModelSays) {
  EXPECT_EQ(shipped_errors(), (std::vector<std::string>{"accurate", "electronics", "none", "paper"}));
  const auto none = load_errors("none");
  ASSERT_TRUE(none) << none.error().text();
  EXPECT_EQ(errors_to_json(*none), errors_to_json(LineInErrors{}));
  const auto paper = load_errors("paper");
  ASSERT_TRUE(paper) << paper.error().text();
  EXPECT_DOUBLE_EQ(paper->accelerometer_noise, 0.02);
  EXPECT_DOUBLE_EQ(paper->offset_g, 0.1);
  EXPECT_DOUBLE_EQ(paper->cross_axis, 0.01);
  EXPECT_TRUE(paper->saturates);
  EXPECT_NEAR(paper->mount_angle, radians(3.0), 1e-12);
  EXPECT_NEAR(paper->mount_offset, 0.005, 1e-12);
  EXPECT_NEAR(paper->pose_angle, radians(5.0), 1e-12);
  EXPECT_NEAR(paper->soft_tissue_angle, radians(1.5), 1e-12);
  EXPECT_NEAR(paper->soft_tissue_offset, 0.004, 1e-12);
  EXPECT_DOUBLE_EQ(paper->clock_offset, 0.03);
  EXPECT_DOUBLE_EQ(paper->clock_wander, 0.003);
  EXPECT_DOUBLE_EQ(paper->coupling_hz, 5.0);
  EXPECT_DOUBLE_EQ(paper->noise_db, -60.0);
  EXPECT_GT(paper->ringing, 0.0);
  const auto accurate = load_errors("accurate");
  ASSERT_TRUE(accurate);
  EXPECT_EQ(accurate->pose_angle, 0.0);
  EXPECT_EQ(accurate->soft_tissue_angle, 0.0);
  EXPECT_DOUBLE_EQ(accurate->scale, 0.1);
  const auto electronics = load_errors("electronics");
  ASSERT_TRUE(electronics);
  EXPECT_EQ(electronics->offset_g, 0.0);
  EXPECT_EQ(electronics->accelerometer_noise, 0.0);
}

TEST_F(ErrorsFile, OverridesItsBaseAndGoesThereAndBack) {
  const auto mine = load_errors(file("mine.json", R"({"schema":1,"base":"paper","hum":0.01,"mount_angle_deg":7,
      "swapped":true,"drop_every_s":2,"drop_frames":40})"));
  ASSERT_TRUE(mine) << mine.error().text();
  EXPECT_DOUBLE_EQ(mine->hum, 0.01);
  EXPECT_NEAR(mine->mount_angle, radians(7.0), 1e-12);
  EXPECT_TRUE(mine->swapped);
  EXPECT_EQ(mine->drop_frames, 40);
  EXPECT_DOUBLE_EQ(mine->coupling_hz, 5.0);
  const auto again = load_errors(file("again.json", errors_to_json(*mine).dump()));
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_NEAR(again->soft_tissue_angle, mine->soft_tissue_angle, 1e-15);
  EXPECT_NEAR(again->ringing_decay_s, mine->ringing_decay_s, 1e-15);
  const auto child = load_errors(file("child.json", R"({"schema":1,"base":"mine.json","swapped":false})"));
  ASSERT_TRUE(child) << child.error().text();
  EXPECT_FALSE(child->swapped);
  EXPECT_DOUBLE_EQ(child->hum, 0.01);
}

TEST_F(ErrorsFile, RefusesWhatIsWrongWithThePathOfTheKey) {
  const auto error_of = [&](const std::string& text) {
    const auto result = load_errors(file("bad.json", text));
    return result ? std::string() : result.error().text();
  };
  EXPECT_NE(error_of(R"({"schema":1,"clock_ofset":0.1})").find("/clock_ofset"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"scale":2})").find("/scale"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"scale":"much"})").find("/scale"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"swapped":1})").find("/swapped"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":2})").find("/schema"), std::string::npos);
  EXPECT_NE(error_of(R"({"hum":0})").find("/schema"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"ringing":0.1})").find("ringing_hz"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"title":7})").find("/title"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"base":"nothing"})").find("nothing"), std::string::npos);
  EXPECT_NE(error_of(R"({"schema":1,"base":"bad.json"})").find("its own base"), std::string::npos);
  EXPECT_NE(error_of(R"([])"), "");
  EXPECT_NE(error_of(R"({"schema":1,)").find("bad.json:1"), std::string::npos);
  EXPECT_FALSE(load_errors("nonsense"));
  EXPECT_FALSE(load_errors((folder_ / "missing.json").string()));
}

}  // namespace
}  // namespace limbwave::simulate
