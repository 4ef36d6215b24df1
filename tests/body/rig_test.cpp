#include "body/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

namespace limbwave::body {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json shipped() {
  const Result<Rig> rig = load_rig("line-in-arm");
  EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().text());
  return rig_to_json(*rig);
}

TEST(Rig, ShippedOnesLoadAndFitTheirSkeletons) {
  const std::vector<std::string> names = shipped_rigs();
  ASSERT_THAT(names, testing::Contains("line-in-arm"));
  for (const std::string& name : names) {
    const Result<Rig> rig = load_rig(name);
    EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().text());
  }
}

TEST(Rig, EverySensorOfTheArmIsCalibratedBySomePoses) {
  const Result<Rig> rig = load_rig("line-in-arm");
  ASSERT_TRUE(rig.ok());
  std::vector<int> sensors;
  for (const CalibrationGroup& group : rig->groups) {
    sensors.insert(sensors.end(), group.sensors.begin(), group.sensors.end());
  }
  EXPECT_THAT(sensors, testing::UnorderedElementsAre(0, 1, 2, 3, 4));
}

TEST(Rig, WrittenAndReadAgainIsTheSame) {
  const json once = shipped();
  const Result<Rig> again = rig_from_json(once, "again");
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(rig_to_json(*again), once);
}

TEST(Rig, RefusalsNameThePathOfTheKey) {
  const struct {
    std::function<void(json&)> damage;
    const char* expected;
  } cases[] = {
      {[](json& v) { v["line_in"]["slots"] = 15; }, "FILE: /line_in/slots: is 15"},
      {[](json& v) { v["line_in"]["volts_per_g"] = 0; }, "/line_in/volts_per_g"},
      {[](json& v) { v["line_in"]["gain"] = 1; }, "/line_in/gain: is not a known key"},
      {[](json& v) { v["accelerometers"].erase(4); }, "/accelerometers"},
      {[](json& v) { v["accelerometers"][1]["name"] = v["accelerometers"][0]["name"]; }, "/accelerometers/1/name"},
      {[](json& v) { v["calibration_groups"][0]["sensors"][0] = "knee"; }, "/calibration_groups/0/sensors/0"},
      {[](json& v) {
         v["calibration_groups"][0]["second"]["gravity"] = {0, 0, 1};
       },
       "/calibration_groups/0/second/gravity"},
  };
  for (const auto& c : cases) {
    json value = shipped();
    c.damage(value);
    const Result<Rig> rig = rig_from_json(value, "FILE");
    ASSERT_FALSE(rig.ok()) << c.expected;
    EXPECT_THAT(rig.error().text(), HasSubstr(c.expected));
  }
}

TEST(Rig, UnknownSegmentIsRefusedOnLoading) {
  json value = shipped();
  value["accelerometers"][2]["segment"] = "tail";
  const std::string path = testing::TempDir() + "/rig-with-tail.json";
  FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fputs(value.dump().c_str(), file);
  std::fclose(file);
  const Result<Rig> rig = load_rig(path);
  ASSERT_FALSE(rig.ok());
  EXPECT_THAT(rig.error().text(), HasSubstr("/accelerometers/2/segment"));
}

}  // namespace
}  // namespace limbwave::body
