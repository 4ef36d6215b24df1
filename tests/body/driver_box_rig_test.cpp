#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "body/rig.h"

namespace limbwave::body {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json shipped() {
  const Result<Rig> rig = load_rig("driver-box-body");
  EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().text());
  return rig_to_json(*rig);
}

TEST(DriverBoxRig, HasEighteenBoardsAndEightSources) {
  const Result<Rig> rig = load_rig("driver-box-body");
  ASSERT_TRUE(rig.ok()) << rig.error().text();
  EXPECT_FALSE(rig->has_line_in);
  ASSERT_TRUE(rig->driver_box);
  EXPECT_EQ(rig->microphones.size(), 18U);
  EXPECT_EQ(rig->gyroscopes.size(), 18U);
  EXPECT_EQ(rig->accelerometers.size(), 18U);
  EXPECT_EQ(rig->sources.size(), 8U);
}

TEST(DriverBoxRig, SevenSourcesLookForwardAndTheHatDown) {
  const Result<Rig> rig = load_rig("driver-box-body");
  ASSERT_TRUE(rig.ok());
  const Result<Skeleton> body = load_skeleton(rig->skeleton);
  ASSERT_TRUE(body.ok()) << body.error().text();
  const std::vector<Quaterniond> rest(body->segments.size(), Quaterniond::Identity());
  const auto poses = poses_from_joints(*body, rest, body->segments[0].p_PL);
  int forward = 0;
  int down = 0;
  for (const Source& source : rig->sources) {
    const Vector3d normal_W = poses[static_cast<std::size_t>(body->find(source.segment))].R_WL * source.normal_L;
    forward += normal_W.x() > 0.9 ? 1 : 0;
    down += normal_W.z() < -0.99 ? 1 : 0;
  }
  EXPECT_EQ(forward, 7);
  EXPECT_EQ(down, 1);
}

TEST(DriverBoxRig, BodyStandsOnTheFloorAsTallAsItSays) {
  const Result<Skeleton> body = load_skeleton("body");
  ASSERT_TRUE(body.ok());
  std::size_t angles = 0;
  for (std::size_t i = 1; i < body->segments.size(); ++i) {
    angles += degrees_of_freedom(body->segments[i].joint.kind);
  }
  EXPECT_EQ(angles, 40U);
  const std::vector<Quaterniond> rest(body->segments.size(), Quaterniond::Identity());
  const auto poses = poses_from_joints(*body, rest, body->segments[0].p_PL);
  const auto at = [&](const char* name, const Vector3d& p_L) {
    const SegmentPose& pose = poses[static_cast<std::size_t>(body->find(name))];
    return Vector3d(pose.p_WL + pose.R_WL * p_L);
  };
  EXPECT_NEAR(at("head", {0.16, 0, 0}).z(), 1.75, 0.03);
  EXPECT_NEAR(at("left_foot", {0, 0, -0.08}).z(), 0.0, 0.01);
  EXPECT_GT(at("left_foot", {0.2, 0, 0}).x(), 0.1);
  EXPECT_GT(at("left_hand", {0, 0, 0}).y(), 0.1);
  EXPECT_LT(at("right_hand", {0, 0, 0}).y(), -0.1);
  EXPECT_LT(at("right_hand", {0, 0, 0}).z(), 1.0);
  // Palms to the rear: the back of the hand, where its board sits, looks forward.
  EXPECT_GT((at("right_hand", {0, 0, 1}) - at("right_hand", {0, 0, 0})).x(), 0.99);
  EXPECT_GT((at("left_hand", {0, 0, 1}) - at("left_hand", {0, 0, 0})).x(), 0.99);
}

TEST(DriverBoxRig, LimitsMirror) {
  const Result<Skeleton> body = load_skeleton("body");
  ASSERT_TRUE(body.ok());
  for (const char* part : {"_upper_arm", "_thigh"}) {
    const Joint& left = body->segments[static_cast<std::size_t>(body->find(std::string("left") + part))].joint;
    const Joint& right = body->segments[static_cast<std::size_t>(body->find(std::string("right") + part))].joint;
    EXPECT_NEAR(left.minimum.z(), -right.maximum.z(), 1e-12) << part;
    EXPECT_NEAR(left.maximum.x(), -right.minimum.x(), 1e-12) << part;
    EXPECT_NEAR(left.minimum.y(), right.minimum.y(), 1e-12) << part;
  }
}

TEST(DriverBoxRig, CapsulesScaleWithTheSubject) {
  const Result<Skeleton> body = load_skeleton("body");
  ASSERT_TRUE(body.ok());
  const Skeleton small = scaled_to_height(*body, 0.5 * body->height);
  ASSERT_FALSE(body->segments[0].capsules.empty());
  EXPECT_NEAR(small.segments[0].capsules[0].radius, 0.5 * body->segments[0].capsules[0].radius, 1e-12);
  EXPECT_NEAR(small.segments[0].capsules[0].to_L.y(), 0.5 * body->segments[0].capsules[0].to_L.y(), 1e-12);
}

// What is worn stays where it is on the body: twice the size, twice the distances, the same directions.
TEST(DriverBoxRig, ScalesWithTheSubject) {
  const Result<Rig> rig = load_rig("driver-box-body");
  ASSERT_TRUE(rig.ok());
  const Result<Skeleton> body = load_skeleton(rig->skeleton);
  ASSERT_TRUE(body.ok());
  const Skeleton tall = scaled_to_height(*body, 2.0 * body->height);
  const Rig worn = scaled(*rig, 2.0);
  const std::vector<Quaterniond> rest(body->segments.size(), Quaterniond::Identity());
  const auto small_poses = poses_from_joints(*body, rest, body->segments[0].p_PL);
  const auto tall_poses = poses_from_joints(tall, rest, tall.segments[0].p_PL);
  const auto place = [&](const auto& poses, const auto& thing) {
    const SegmentPose& pose = poses[static_cast<std::size_t>(body->find(thing.segment))];
    return Vector3d(pose.p_WL + pose.R_WL * thing.p_LS);
  };
  for (std::size_t s = 0; s < rig->sources.size(); ++s) {
    for (std::size_t m = 0; m < rig->microphones.size(); ++m) {
      const Vector3d before = place(small_poses, rig->microphones[m]) - place(small_poses, rig->sources[s]);
      const Vector3d after = place(tall_poses, worn.microphones[m]) - place(tall_poses, worn.sources[s]);
      EXPECT_LT((after - 2.0 * before).norm(), 1e-12) << rig->sources[s].name << " " << rig->microphones[m].name;
    }
  }
  for (std::size_t b = 0; b < rig->gyroscopes.size(); ++b) {
    EXPECT_EQ(worn.gyroscopes[b].p_LS, 2.0 * rig->gyroscopes[b].p_LS);
    EXPECT_EQ(worn.accelerometers[b].p_LS, 2.0 * rig->accelerometers[b].p_LS);
  }
}

TEST(DriverBoxRig, WrittenAndReadAgainIsTheSame) {
  const json once = shipped();
  const Result<Rig> again = rig_from_json(once, "again");
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(rig_to_json(*again), once);
  const Result<Skeleton> body = load_skeleton("body");
  ASSERT_TRUE(body.ok());
  const json text = skeleton_to_json(*body);
  const Result<Skeleton> body_again = skeleton_from_json(text, "again");
  ASSERT_TRUE(body_again.ok()) << body_again.error().text();
  EXPECT_EQ(skeleton_to_json(*body_again).dump().size(), text.dump().size());
  EXPECT_EQ(body_again->segments[3].capsules.size(), body->segments[3].capsules.size());
}

TEST(DriverBoxRig, RefusalsNameThePathOfTheKey) {
  const struct {
    std::function<void(json&)> damage;
    const char* expected;
  } cases[] = {
      {[](json& v) { v["driver_box"]["bits"] = 11; }, "FILE: /driver_box/bits"},
      {[](json& v) { v["driver_box"]["colour"] = 1; }, "/driver_box/colour: is not a known key"},
      {[](json& v) { v["driver_box"]["pulse_hz"] = 69000; }, "/driver_box: has a pulse_hz"},
      {[](json& v) {
         v["driver_box"]["pulse_cycles"] = 100;
         v["driver_box"]["slot_samples"] = 300;
       },
       "/driver_box: has pulses longer"},
      {[](json& v) { v["gyroscopes"].erase(17); }, "/gyroscopes: has 17 entries"},
      {[](json& v) { v["gyroscopes"][3]["name"] = "knee"; }, "/gyroscopes/3/name"},
      {[](json& v) { v["microphones"][1]["name"] = v["microphones"][0]["name"]; }, "/microphones/1/name"},
      {[](json& v) {
         v["microphones"][1]["mount"] = {1, 0, 0, 0};
       },
       "/microphones/1/mount: is not a known key"},
      {[](json& v) { v["sources"][2].erase("normal"); }, "/sources/2"},
      {[](json& v) {
         v["sources"][2]["normal"] = {0, 0, 0};
       },
       "/sources/2/normal"},
      {[](json& v) {
         v["sources"][2]["position_m"] = {0, 0, 50};
       },
       "/sources/2/position_m"},
      {[](json& v) { v["line_in"] = json::object(); }, "/driver_box: stands beside line_in"},
      {[](json& v) { v["microphones"] = json::array(); }, "/microphones: has 0 entries"},
  };
  for (const auto& c : cases) {
    json value = shipped();
    c.damage(value);
    const Result<Rig> rig = rig_from_json(value, "FILE");
    ASSERT_FALSE(rig.ok()) << c.expected;
    EXPECT_THAT(rig.error().text(), HasSubstr(c.expected));
  }
}

}  // namespace
}  // namespace limbwave::body
