#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/evaluate.h"

namespace limbwave::evaluate {
namespace {

TEST(TruthJson, ReadsSamplesAndGaps) {
  const Result<Truth> truth = truth_from_json(R"({"schema": 1, "rate_hz": 240, "motion": "wave", "segments": [
    {"name": "upper", "more": 7,
     "q_WL": [[1, 0, 0, 0], null, [0, 0, 0.6, 0.8], [0.6, 0.8, 0, 0]],
     "p_WL": [[1, 2, 3], [4, 5, 6], null, [7, 8, 9]]},
    {"name": "fore", "q_WL": [null, [0, 1, 0, 0], null, null]}]})",
                                              "truth.json");
  ASSERT_TRUE(truth.ok()) << truth.error().text();
  ASSERT_EQ(truth->segments.size(), 2U);
  const Truth::SegmentTruth& upper = truth->segments[0];
  EXPECT_EQ(upper.times, (std::vector<double>{0.0, 2.0 / 240.0, 3.0 / 240.0}));
  EXPECT_EQ(upper.R_WL[1].y(), 0.6);
  EXPECT_EQ(upper.R_WL[2].w(), 0.6);
  EXPECT_EQ(upper.p_WL[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(std::isnan(upper.p_WL[1].x()));
  EXPECT_EQ(truth->segments[1].times, std::vector<double>{1.0 / 240.0});
  EXPECT_TRUE(std::isnan(truth->segments[1].p_WL[0].y()));
}

TEST(TruthJson, RefusesWithTheKey) {
  const struct {
    const char* text;
    const char* place;
  } cases[] = {
      {R"({"schema": 2, "rate_hz": 1, "segments": []})", "t: /schema"},
      {R"({"schema": 1, "rate_hz": 0, "segments": []})", "t: /rate_hz"},
      {R"({"schema": 1, "rate_hz": 1})", "t: /segments"},
      {R"({"schema": 1, "rate_hz": 1, "segments": [{"name": "a"}]})", "t: /segments/0/q_WL"},
      {R"({"schema": 1, "rate_hz": 1, "segments": [{"name": "a", "q_WL": [[1, 0, 0]]}]})", "t: /segments/0/q_WL"},
      {R"({"schema": 1, "rate_hz": 1, "segments": [{"name": "a", "q_WL": [[2, 0, 0, 0]]}]})", "t: /segments/0/q_WL"},
      {R"({"schema": 1, "rate_hz": 1, "segments": [{"name": "a", "q_WL": [["1", 0, 0, 0]]}]})", "t: /segments/0/q_WL"},
      {R"({"schema": 1, "rate_hz": 1, "segments": [{"name": "a", "q_WL": [[1, 0, 0, 0]], "p_WL": []}]})",
       "t: /segments/0/p_WL"},
      {R"({"schema": 1, "rate_hz": 1, "segments": [{"name": "a", "q_WL": [[1, 0, 0, 0]], "p_WL": [[1, 2]]}]})",
       "t: /segments/0/p_WL"},
      {R"({"schema": 1, "rate_hz": 1, "segments": {})", "t:1:43"},
      {R"([1, 2])", "t: /schema"},
  };
  for (const auto& [text, place] : cases) {
    const Result<Truth> truth = truth_from_json(text, "t");
    ASSERT_FALSE(truth.ok()) << text;
    EXPECT_EQ(truth.error().place, place) << truth.error().text();
  }
}

TEST(TruthCsv, ReadsColumnsInAnyOrder) {
  const Result<Truth> truth = truth_from_csv(
      "\xEF\xBB\xBFsegment, qz,qy,qx,qw,px_m,note,time_s,pz_m,py_m\r\n"
      "a,0,0,0,1,1.5,x,0,3,2\r\n"
      "\r\n"
      "\"b, left\",0,0,1,0,,,0.5,,\r\n"
      "a,,,,,1.5,x,0.5,3,2\r\n"
      "a,1,0,0,0,1.5,x,1e0,3,2",
      "t.csv");
  ASSERT_TRUE(truth.ok()) << truth.error().text();
  ASSERT_EQ(truth->segments.size(), 2U);
  EXPECT_EQ(truth->segments[0].times, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(truth->segments[0].p_WL[0], Eigen::Vector3d(1.5, 2, 3));
  EXPECT_EQ(truth->segments[0].R_WL[1].z(), 1.0);
  EXPECT_EQ(truth->segments[1].name, "b, left");
  EXPECT_EQ(truth->segments[1].R_WL[0].x(), 1.0);
  EXPECT_TRUE(std::isnan(truth->segments[1].p_WL[0].x()));
  EXPECT_TRUE(truth_from_csv("time_s,segment,qw,qx,qy,qz\n0,a,1,0,0,0\n", "t").ok());
}

TEST(TruthCsv, RefusesWithTheLine) {
  const std::string head = "time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m\n";
  const struct {
    std::string text;
    const char* place;
    const char* word;
  } cases[] = {
      {"", "t.csv:1", "empty"},
      {"time_s,segment,qw,qx,qy\n", "t.csv:1", "qz"},
      {head + "0,a,1,0,0,0,0,0,0\n0,a,1,0,0,0,0,0,0\n", "t.csv:3", "increase"},
      {head + "0,a,1,0,0,0,0,0,zero\n", "t.csv:2", "zero"},
      {head + "0,a,nan,0,0,0,0,0,0\n", "t.csv:2", "nan"},
      {head + "0,a,0.5,0,0,0,0,0,0\n", "t.csv:2", "0.500"},
      {head + ",a,1,0,0,0,0,0,0\n", "t.csv:2", "time"},
      {head + "0,,1,0,0,0,0,0,0\n", "t.csv:2", "segment"},
      {head + "0\n", "t.csv:2", "segment"},
  };
  for (const auto& [text, place, word] : cases) {
    const Result<Truth> truth = truth_from_csv(text, "t.csv");
    ASSERT_FALSE(truth.ok()) << text;
    EXPECT_EQ(truth.error().place, place) << truth.error().text();
    EXPECT_NE(truth.error().message.find(word), std::string::npos) << truth.error().text();
  }
}

TEST(Truth, FilesThatAreMissingAreNamed) {
  EXPECT_EQ(load_truth("/no/such/truth.json").error().place, "/no/such/truth.json");
  EXPECT_EQ(load_truth_csv("/no/such/truth.csv").error().place, "/no/such/truth.csv");
}

}  // namespace
}  // namespace limbwave::evaluate
