/// Solves on disk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/units.h"
#include "solve/compose.h"
#include "solve/report_text.h"
#include "solve/solve.h"
#include "solve/uncertainty.h"
#include "support/simulated_take.h"

namespace limbwave::solve {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_support::require;

class SolveStore : public testing::Test {
 protected:
  void SetUp() override {
    take.folder = folder / "x.take";
    fs::create_directories(take.folder);
    take.info.skeleton = require(body::load_skeleton("arm"));
  }

  // A solve that differs with `turn`.
  [[nodiscard]] Solve solve(double turn) const {
    constexpr std::size_t kFrames = 50;
    Solve result;
    std::vector<double> times(kFrames);
    std::vector<std::vector<Eigen::Quaterniond>> inclined(take.info.skeleton.segments.size());
    for (std::size_t i = 0; i < kFrames; ++i) {
      times[i] = static_cast<double>(i) / 60.0;
    }
    for (std::size_t i = 0; i < kFrames; ++i) {
      inclined.back().emplace_back(
          Eigen::AngleAxisd(turn * std::sin(0.1 * static_cast<double>(i)), Eigen::Vector3d(0.6, 0.8, 0.0)));
    }
    result.settings.smoothing = Smoothing::kNone;
    result.settings.smoothing_s = 0.123;
    result.settings.calibration = "library";
    result.settings.line_in.coupling_hz = 4.5;
    result.settings.line_in.swapped = true;
    result.settings.headings = {{}, {{0.0, 0.25}, {1.5, -1.0}}};
    result.clip = compose_clip(take.info.skeleton, times, inclined, {}, 60.0);
    result.trust = {std::vector<float>(kFrames, 0.75F), {}, std::vector<float>(kFrames, 1.0F)};
    result.report.calibration = "of today";
    result.report.sensors = {{"forearm", 0.9, 0.8, 1.01}};
    result.report.diagnostics = {{Severity::kWarning, "code", "message", "remedy", "place", 1.5}};
    result.report.line.cycles = 321;
    result.report.take_seconds = 12.5;
    return result;
  }
  [[nodiscard]] fs::path stored(const char* file) const { return take.folder / "solves" / "default" / file; }
  [[nodiscard]] double turned() const {
    return world_orientations(require(load_solve(take, "default")).clip)[16].back().w();
  }

  test::TemporaryFolder folder;
  take::Take take;
};

TEST_F(SolveStore, WhatIsSavedIsLoaded) {
  const Solve before = solve(1.0);
  require(save_solve(take, before));
  EXPECT_THAT(list_solves(take), ElementsAre("default"));
  const Solve after = require(load_solve(take, "default"));
  EXPECT_EQ(settings_to_json(after.settings), settings_to_json(before.settings));
  EXPECT_EQ(after.settings.headings[1][1].heading, -1.0);
  EXPECT_EQ(report_to_json(after), report_to_json(before));
  EXPECT_EQ(after.trust, before.trust);
  ASSERT_EQ(after.clip.joints.size(), before.clip.joints.size());
  for (std::size_t s = 0; s < after.clip.joints.size(); ++s) {
    EXPECT_EQ(after.clip.joints[s].rotation.times, before.clip.joints[s].rotation.times);
    for (std::size_t i = 0; i < after.clip.joints[s].rotation.values.size(); ++i) {
      EXPECT_EQ(after.clip.joints[s].rotation.values[i].coeffs(), before.clip.joints[s].rotation.values[i].coeffs());
    }
  }
}

TEST_F(SolveStore, HowTheBodyFilterSolvedIsStored) {
  Solve before = solve(1.0);
  before.settings.body = BodyChoice{"batch", "GD", "contacts", true};
  require(save_solve(take, before));
  EXPECT_EQ(require(load_solve(take, "default")).settings.body, before.settings.body);
  EXPECT_FALSE(require(load_solve_settings(take, "default")).body == BodyChoice());
  before.settings.body.reset();
  require(save_solve(take, before));
  EXPECT_FALSE(require(load_solve(take, "default")).settings.body.has_value());
  nlohmann::json json = settings_to_json(before.settings);
  for (const auto& [method, sensors, wrong] :
       {std::tuple{"guess", "A", "method"}, std::tuple{"filter", "AX", "sensors"},
        std::tuple{"smoother", "", "sensors"}}) {
    json["method"] = method;
    json["sensors"] = sensors;
    const Result<SolveSettings> read = settings_from_json(json, "here");
    ASSERT_FALSE(read.ok());
    EXPECT_THAT(read.error().text(), HasSubstr(wrong));
  }
}

TEST_F(SolveStore, TheCalibrationThatWasUsedIsStored) {
  Solve before = solve(1.0);
  take.info.rig = require(body::load_rig("line-in-arm"));
  calibrate::RigCalibration used = calibrate::nominal_calibration(take.info.rig);
  used.sensors[2].method = "ellipsoid";
  used.sensors[2].residual_g = 0.0032;
  before.report.used_calibration = used;
  require(save_solve(take, before));
  const Solve after = require(load_solve(take, "default"));
  ASSERT_TRUE(after.report.used_calibration.has_value());
  EXPECT_EQ(calibrate::calibration_to_json(*after.report.used_calibration), calibrate::calibration_to_json(used));
}

TEST_F(SolveStore, TurnsOfARecordingAreKnownUntilASolveHasItsOwn) {
  EXPECT_THAT(known_headings(take, "default"), IsEmpty());
  require(save_live_headings(take.folder, {{}, {{0.0, 0.5}}, {{1.0, -0.5}, {2.0, 0.75}}}));
  const auto live = known_headings(take, "default");
  ASSERT_EQ(live.size(), 3U);
  EXPECT_EQ(live[2][1].time_s, 2.0);
  EXPECT_EQ(live[2][1].heading, 0.75);
  EXPECT_THAT(list_solves(take), IsEmpty());
  require(save_solve(take, solve(1.0)));
  EXPECT_EQ(known_headings(take, "default").size(), 2U);
  EXPECT_EQ(known_headings(take, "other").size(), 3U);
}

TEST_F(SolveStore, UncertaintyIsKeptTenTimesASecond) {
  Solve before = solve(1.0);
  before.clip.skeleton.segments[1].name = "upper, \"left\" arm";
  const std::size_t segments = before.clip.skeleton.segments.size();
  for (int i = 0; i < 50; ++i) {
    before.uncertainty.times.push_back(i / 60.0);
    before.uncertainty.joint.emplace_back(segments, 0.01F + 0.001F * static_cast<float>(i));
    before.uncertainty.point.emplace_back(segments, 0.002F);
  }
  require(save_solve(take, before));
  const Solve::Uncertainty after = require(load_solve(take, "default")).uncertainty;
  EXPECT_EQ(after.times.size(), 9U);  // 0.0, 0.1 ... 0.8 s
  EXPECT_NEAR(joint_sigma_deg(after, 1, 0.4), degrees(0.01 + 0.001 * 24), 1e-3);
  EXPECT_NEAR(joint_sigma_deg(after, 1, 9.0), joint_sigma_deg(after, 1, 0.8), 1e-12);
  EXPECT_NEAR(after.point[3][2], 0.002F, 1e-6F);
  // A line cut off, and a table that ends within an instant.
  for (const char* bad : {"time_s,segment,joint_sigma_deg,point_sigma_mm\n0.0,torso,1.0",
                          "time_s,segment,joint_sigma_deg,point_sigma_mm\n0.0,torso,1.0,nan\n",
                          "time_s,segment,joint_sigma_deg,point_sigma_mm\n0.0,torso,1.0,2.0\n"}) {
    EXPECT_FALSE(uncertainty_from_csv(bad, before.clip.skeleton, "x").ok()) << bad;
  }
}

TEST_F(SolveStore, ReplacesAndLeavesNothingElse) {
  require(save_solve(take, solve(1.0)));
  const double first = turned();
  require(save_solve(take, solve(0.3)));
  EXPECT_NE(turned(), first);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(take.folder / "solves")) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, ElementsAre("default"));
}

TEST_F(SolveStore, OneThatWasBeingReplacedWhenTheProgramDiedIsThere) {
  require(save_solve(take, solve(1.0)));
  const double first = turned();
  fs::rename(take.folder / "solves" / "default", take.folder / "solves" / ".default.old");
  fs::create_directories(take.folder / "solves" / ".default.part");
  EXPECT_THAT(list_solves(take), ElementsAre("default"));
  EXPECT_EQ(turned(), first);

  // A failing save after that loses nothing either.
  Solve broken = solve(0.3);
  broken.clip.joints.back().rotation.values.front().coeffs().setConstant(std::nan(""));
  EXPECT_FALSE(save_solve(take, broken));
  EXPECT_EQ(turned(), first);

  require(save_solve(take, solve(0.3)));
  EXPECT_NE(turned(), first);
}

TEST_F(SolveStore, NamesOfOtherEncodingsDoNotStopIt) {
  Solve named = solve(1.0);
  named.report.diagnostics.front().place = "/home/j\xFCrgen";
  ASSERT_NO_THROW(require(save_solve(take, named)));
  EXPECT_EQ(require(load_solve(take, "default")).report.diagnostics.front().place, "/home/j\xEF\xBF\xBDrgen");
}

TEST_F(SolveStore, KeysAtDifferentTimesAreRefused) {
  Solve edited = solve(1.0);
  edited.clip.joints.back().rotation.times.pop_back();
  edited.clip.joints.back().rotation.values.pop_back();
  require(save_solve(take, edited));
  const Result<Solve> loaded = load_solve(take, "default");
  ASSERT_FALSE(loaded) << "editing its headings would read beyond the end of a track";
  EXPECT_THAT(loaded.error().text(), HasSubstr("keys at different times"));
}

TEST_F(SolveStore, DamagedFilesAreNamed) {
  require(save_solve(take, solve(1.0)));
  nlohmann::json quality = nlohmann::json::parse(require(read_file(stored("quality.json"))));
  quality["trust_percent"][0].erase(0);
  require(write_file(stored("quality.json"), quality.dump()));
  EXPECT_THAT(load_solve(take, "default").error().text(), HasSubstr("quality.json: is damaged"));
  require(write_file(stored("quality.json"), "{"));
  EXPECT_THAT(load_solve(take, "default").error().text(), HasSubstr("quality.json"));
  EXPECT_THAT(load_solve(take, "other").error().text(), HasSubstr("has no solve \"other\""));
  for (const char* name : {"", ".hidden", "a/b", ".."}) {
    EXPECT_FALSE(load_solve(take, name)) << name;
    Solve badly_named = solve(1.0);
    badly_named.settings.name = name;
    EXPECT_FALSE(save_solve(take, badly_named)) << name;
  }
}

TEST(SolveSettingsJson, WrongValuesAreRefusedWithTheirKey) {
  const auto refusal = [](const char* key, const nlohmann::json& value) {
    nlohmann::json json = settings_to_json({});
    json[key] = value;
    const Result<SolveSettings> settings = settings_from_json(json, "settings.json");
    return settings ? std::string() : settings.error().text();
  };
  EXPECT_EQ(refusal("smoothing_s", 0.5), "");
  EXPECT_THAT(refusal("smoothing_s", 0.0), HasSubstr("settings.json: /smoothing_s"));
  EXPECT_THAT(refusal("smoothing", "magic"), HasSubstr("/smoothing: is \"magic\""));
  EXPECT_EQ(refusal("smoothing", "none"), "");
  EXPECT_THAT(refusal("colour", 1), HasSubstr("/colour"));
  EXPECT_THAT(refusal("headings_s_rad", {{{1.0, 0.0}, {0.5, 0.0}}}), HasSubstr("is not later"));
}

TEST(ReportLines, ASensorThatNeverRestedHasNoLengthAtRest) {
  Solve solve;
  solve.report.sensors = {{"hand", 1.0, 0.5, 0.0}, {"torso", 1.0, 0.5, 1.002}};
  const std::vector<std::string> lines = report_lines(solve);
  EXPECT_THAT(lines, testing::Contains(testing::AllOf(HasSubstr("hand"), HasSubstr("never at rest"))));
  EXPECT_THAT(lines, testing::Contains(testing::AllOf(HasSubstr("torso"), HasSubstr("1.002 g at rest"))));
}

}  // namespace
}  // namespace limbwave::solve
