#include "body/skeleton.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "base/units.h"

namespace limbwave::body {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json two_bones() {
  return json::parse(R"({
    "schema": 1, "name": "two", "height_m": 1.8,
    "segments": [
      {"name": "a", "length_m": 0.3, "offset_m": [0, 0, 1]},
      {"name": "b", "parent": "a", "length_m": 0.25, "offset_m": [0.3, 0, 0],
       "joint": {"kind": "hinge", "axis": [0, 2, 0], "minimum_deg": [-10], "maximum_deg": [150]}}
    ]})");
}

TEST(Skeleton, ReadsSegmentsJointsAndLimits) {
  const Result<Skeleton> skeleton = skeleton_from_json(two_bones(), "FILE");
  ASSERT_TRUE(skeleton.ok()) << skeleton.error().text();
  ASSERT_EQ(skeleton->segments.size(), 2U);
  EXPECT_EQ(skeleton->segments[1].parent, 0);
  EXPECT_EQ(skeleton->segments[1].joint.kind, JointKind::kHinge);
  EXPECT_NEAR((skeleton->segments[1].joint.axis - Vector3d::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_NEAR(skeleton->segments[1].joint.maximum[0], radians(150.0), 1e-12);
  EXPECT_EQ(skeleton->find("b"), 1);
  EXPECT_EQ(skeleton->find("c"), -1);
}

TEST(Skeleton, WrittenAndReadAgainIsTheSame) {
  const Result<Skeleton> arm = load_skeleton("arm");
  ASSERT_TRUE(arm.ok()) << arm.error().text();
  const Result<Skeleton> again = skeleton_from_json(skeleton_to_json(*arm), "again");
  ASSERT_TRUE(again.ok()) << again.error().text();
  ASSERT_EQ(again->segments.size(), arm->segments.size());
  for (std::size_t s = 0; s < arm->segments.size(); ++s) {
    EXPECT_EQ(again->segments[s].name, arm->segments[s].name);
    EXPECT_EQ(again->segments[s].length, arm->segments[s].length);
    EXPECT_EQ(again->segments[s].p_PL, arm->segments[s].p_PL);
    EXPECT_EQ(again->segments[s].R_PL_rest.coeffs(), arm->segments[s].R_PL_rest.coeffs());
    EXPECT_TRUE(again->segments[s].joint.maximum.isApprox(arm->segments[s].joint.maximum, 1e-12));
  }
}

TEST(Skeleton, RefusalsNameThePathOfTheKey) {
  const struct {
    std::function<void(json&)> damage;
    const char* expected;
  } cases[] = {
      {[](json& v) { v["segments"][1]["colour"] = "red"; }, "FILE: /segments/1/colour: is not a known key"},
      {[](json& v) { v["segments"][1]["parent"] = "z"; }, "/segments/1/parent"},
      {[](json& v) { v["segments"][1]["name"] = "a"; }, "/segments/1/name"},
      {[](json& v) { v["segments"][0]["length_m"] = -1; }, "/segments/0/length_m"},
      {[](json& v) { v["segments"][0]["length_m"] = "long"; }, "/segments/0/length_m: is not a number"},
      {[](json& v) {
         v["segments"][0]["rest"] = {1, 1, 0, 0};
       },
       "/segments/0/rest"},
      {[](json& v) { v["segments"][1]["joint"]["minimum_deg"] = {200}; }, "/segments/1/joint/minimum_deg"},
      {[](json& v) { v["segments"][1]["joint"]["kind"] = "rubber"; }, "/segments/1/joint/kind"},
      {[](json& v) { v["segments"][1].erase("parent"); }, "has no parent"},
      {[](json& v) { v["segments"] = json::array(); }, "/segments"},
      {[](json& v) { v = json::array(); }, "is not an object"},
      {[](json& v) { v["schema"] = 2; }, "/schema"},
  };
  for (const auto& c : cases) {
    json value = two_bones();
    c.damage(value);
    const Result<Skeleton> skeleton = skeleton_from_json(value, "FILE");
    ASSERT_FALSE(skeleton.ok()) << c.expected;
    EXPECT_THAT(skeleton.error().text(), HasSubstr(c.expected));
  }
}

TEST(Skeleton, IsTheSameInEveryUnit) {
  const auto metres = load_skeleton("body");
  ASSERT_TRUE(metres.ok());
  for (const auto& [suffix, per_metre] : {std::pair{"_mm", 1000.0}, {"_cm", 100.0}}) {
    nlohmann::json scaled = skeleton_to_json(*metres);
    const std::function<void(nlohmann::json&)> rename = [&](nlohmann::json& value) {
      if (value.is_object()) {
        nlohmann::json renamed = nlohmann::json::object();
        for (auto& [key, item] : value.items()) {
          rename(item);
          if (!key.ends_with("_m")) {
            renamed[key] = item;
            continue;
          }
          if (item.is_array()) {
            for (auto& number : item) {
              number = number.get<double>() * per_metre;
            }
          } else {
            item = item.get<double>() * per_metre;
          }
          renamed[key.substr(0, key.size() - 2) + suffix] = item;
        }
        value = renamed;
      } else if (value.is_array()) {
        for (auto& item : value) {
          rename(item);
        }
      }
    };
    rename(scaled);
    const auto read = skeleton_from_json(scaled, "test");
    ASSERT_TRUE(read.ok()) << read.error().text();
    ASSERT_EQ(read->segments.size(), metres->segments.size());
    EXPECT_NEAR(read->height, metres->height, 1e-12);
    for (std::size_t i = 0; i < metres->segments.size(); ++i) {
      EXPECT_LT((read->segments[i].p_PL - metres->segments[i].p_PL).norm(), 1e-12);
      EXPECT_NEAR(read->segments[i].length, metres->segments[i].length, 1e-12);
      ASSERT_EQ(read->segments[i].capsules.size(), metres->segments[i].capsules.size());
      for (std::size_t c = 0; c < metres->segments[i].capsules.size(); ++c) {
        EXPECT_NEAR(read->segments[i].capsules[c].radius, metres->segments[i].capsules[c].radius, 1e-12);
      }
    }
  }
}

TEST(Skeleton, MissingFileSaysSo) {
  const Result<Skeleton> skeleton = load_skeleton("/nowhere/at-all.json");
  ASSERT_FALSE(skeleton.ok());
  EXPECT_THAT(skeleton.error().text(), HasSubstr("/nowhere/at-all.json"));
}

TEST(Skeleton, ScalesWithHeight) {
  const Result<Skeleton> arm = load_skeleton("arm");
  ASSERT_TRUE(arm.ok());
  const Skeleton tall = scaled_to_height(*arm, 2.0 * arm->height);
  EXPECT_NEAR(tall.segments[2].length, 2.0 * arm->segments[2].length, 1e-12);
  EXPECT_NEAR(tall.segments[1].p_PL.y(), 2.0 * arm->segments[1].p_PL.y(), 1e-12);
}

TEST(Skeleton, ChangedLengthMovesOnlyWhatHangsOnTheEnd) {
  const Result<Skeleton> arm = load_skeleton("arm");
  ASSERT_TRUE(arm.ok());
  const int upper_arm = arm->find("upper_arm");
  const Skeleton longer = with_length(*arm, upper_arm, 0.35);
  EXPECT_EQ(longer.segments[static_cast<std::size_t>(upper_arm)].length, 0.35);
  EXPECT_EQ(longer.segments[static_cast<std::size_t>(arm->find("forearm"))].p_PL.x(), 0.35);
  // The shoulder is beside the spine, not on its end.
  EXPECT_EQ(with_length(*arm, 0, 0.6).segments[1].p_PL, arm->segments[1].p_PL);
}

}  // namespace
}  // namespace limbwave::body
