#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/units.h"
#include "simulate/body_motions.h"

namespace limbwave::simulate {
namespace {

using body::Skeleton;

// Both sides of a body with the anatomical names of its angles; all zero: standing, arms hanging. Index 0 is the left.
struct Person {
  explicit Person(const Skeleton& skeleton)
      : motion(std::make_shared<JointMotion>(skeleton)),
        bend(add(skeleton, "abdomen", {0, 1, 0})),
        twist(add(skeleton, "chest", {1, 0, 0})),
        sway(add(skeleton, "pelvis", {1, 0, 0})),
        tilt(add(skeleton, "pelvis", {0, 1, 0})),
        nod(add(skeleton, "neck", {0, 1, 0})),
        look(add(skeleton, "neck", {1, 0, 0})) {
    for (int side = 0; side < 2; ++side) {
      const std::string name = side == 0 ? "left_" : "right_";
      const double out = side == 0 ? 1.0 : -1.0;
      flexion[side] = &add(skeleton, name + "upper_arm", {0, -1, 0});
      abduction[side] = &add(skeleton, name + "upper_arm", {0, 0, out});
      turn[side] = &add(skeleton, name + "upper_arm", {out, 0, 0});
      elbow[side] = &add(skeleton, name + "forearm", {0, -1, 0});
      wrist[side] = &add(skeleton, name + "hand", {0, -1, 0});
      hip[side] = &add(skeleton, name + "thigh", {0, -1, 0});
      spread[side] = &add(skeleton, name + "thigh", {0, 0, out});
      knee[side] = &add(skeleton, name + "shin", {0, 1, 0});
      ankle[side] = &add(skeleton, name + "foot", {0, 1, 0});
    }
  }

  Curve& add(const Skeleton& skeleton, const std::string& segment, const Vector3d& axis) const {
    return motion->turn(skeleton.find(segment), axis);
  }
  std::shared_ptr<const BodyMotion> done(double seconds) const {
    motion->set_duration(seconds);
    return motion;
  }

  std::shared_ptr<JointMotion> motion;
  Curve &bend, &twist, &sway, &tilt, &nod, &look;
  std::array<Curve*, 2> flexion{}, abduction{}, turn{}, elbow{}, wrist{}, hip{}, spread{}, knee{}, ankle{};
};

void keys(Curve& curve, std::initializer_list<std::array<double, 2>> values) {
  for (const auto& [time, angle] : values) {
    curve.key(time, radians(angle));
  }
}

// A gait on the spot: `stride` a second, `reach` scales its angles.
std::shared_ptr<const BodyMotion> gait(const Skeleton& skeleton, double stride, double reach, double elbows,
                                       double bob) {
  const Person p(skeleton);
  const double end = 20.0;
  for (int side = 0; side < 2; ++side) {
    const auto s = static_cast<std::size_t>(side);
    const double phase = side == 0 ? 0.0 : kPi;
    p.hip[s]->oscillate(0.5, end, 2.0, stride, radians(22) * reach, phase);
    keys(*p.hip[s], {{0.5, 0}, {2.5, 8 * reach}, {end - 2, 8 * reach}, {end, 0}});
    keys(*p.knee[s], {{0.5, 0}, {2.5, 26 * reach}, {end - 2, 26 * reach}, {end, 0}});
    p.knee[s]->oscillate(0.5, end, 2.0, stride, radians(24) * reach, phase + 1.3);
    p.ankle[s]->oscillate(0.5, end, 2.0, stride, radians(12), phase - 0.9);
    p.flexion[s]->oscillate(0.5, end, 2.0, stride, radians(24) * reach, phase + kPi);
    keys(*p.abduction[s], {{0.5, 0}, {2.5, 8}, {end - 2, 8}, {end, 0}});
    keys(*p.elbow[s], {{0.5, 0}, {2.5, elbows}, {end - 2, elbows}, {end, 0}});
    p.elbow[s]->oscillate(0.5, end, 2.0, stride, radians(12), phase + kPi - 0.5);
  }
  p.twist.oscillate(0.5, end, 2.0, stride, radians(5));
  p.sway.oscillate(0.5, end, 2.0, stride, radians(4), kPi);
  p.nod.oscillate(0.5, end, 2.0, 2.0 * stride, radians(2));
  keys(p.bend, {{0.5, 0}, {2.5, 5}, {end - 2, 5}, {end, 0}});
  p.motion->root(1).oscillate(0.5, end, 2.0, stride, 0.018);
  p.motion->root(2).oscillate(0.5, end, 2.0, 2.0 * stride, bob, 0.5);
  return p.done(end + 0.5);
}

std::shared_ptr<const BodyMotion> box(const Skeleton& skeleton) {
  const Person p(skeleton);
  for (std::size_t s = 0; s < 2; ++s) {
    p.flexion[s]->key(0.5, 0).key(1.8, radians(35));
    p.elbow[s]->key(0.5, 0).key(1.8, radians(120));
    keys(*p.turn[s], {{0.5, 0}, {1.8, 20}, {14.5, 20}, {16, 0}});
  }
  keys(p.bend, {{0.5, 0}, {1.8, 10}, {14.5, 10}, {16, 0}});
  keys(*p.hip[0], {{0.5, 0}, {1.8, 18}, {14.5, 18}, {16, 0}});
  keys(*p.knee[0], {{0.5, 0}, {1.8, 22}, {14.5, 22}, {16, 0}});
  double t = 2.4;
  for (int punch = 0; punch < 9; ++punch) {
    const std::size_t s = punch % 2 == 0 ? 1 : 0;
    const double out = punch % 3 == 2 ? 0.26 : 0.36;
    p.flexion[s]->key(t, radians(35)).key(t + out, radians(85)).key(t + 2.2 * out, radians(35));
    p.elbow[s]->key(t, radians(120)).key(t + out, radians(15)).key(t + 2.2 * out, radians(120));
    p.twist.key(t, 0).key(t + 1.1 * out, radians(s == 1 ? 20 : -20)).key(t + 2.4 * out, 0);
    t += 1.3;
  }
  for (std::size_t s = 0; s < 2; ++s) {
    p.flexion[s]->key(14.5, radians(35)).key(16, 0);
    p.elbow[s]->key(14.5, radians(120)).key(16, 0);
  }
  p.motion->root(2).oscillate(1.8, 14.5, 1.5, 1.6, 0.012);
  return p.done(16.5);
}

std::shared_ptr<const BodyMotion> wave(const Skeleton& skeleton) {
  const Person p(skeleton);
  keys(*p.flexion[1], {{0.5, 0}, {2, 70}, {9.5, 70}, {11, 0}});
  keys(*p.abduction[1], {{0.5, 0}, {2, 25}, {9.5, 25}, {11, 0}});
  keys(*p.elbow[1], {{0.5, 0}, {2, 85}, {9.5, 85}, {11, 0}});
  p.turn[1]->oscillate(2.0, 9.5, 1.0, 1.3, radians(25));
  p.wrist[1]->oscillate(2.0, 9.5, 1.0, 1.3, radians(10), -0.8);
  p.look.key(0.5, 0).key(2.0, radians(-15)).key(9.5, radians(-15)).key(11.0, 0);
  p.bend.oscillate(2.0, 9.5, 2.0, 0.4, radians(1.5));
  return p.done(11.5);
}

std::shared_ptr<const BodyMotion> reach(const Skeleton& skeleton) {
  const Person p(skeleton);
  keys(p.bend, {{0.5, 0}, {2.5, 22}, {3.5, 22}, {5, 0}, {8, 0}, {9.5, 22}, {10.3, 22}, {12, 0}});
  keys(*p.flexion[1], {{0.5, 0}, {2.5, 62}, {3.5, 62}, {5.5, 48}, {7.5, 52}, {9.5, 62}, {10.3, 62}, {12.3, 0}});
  keys(*p.abduction[1], {{0.5, 0}, {2, 6}, {5.5, 20}, {7.5, 20}, {9.5, 6}, {12, 0}});
  keys(*p.elbow[1],
       {{0.4, 0}, {1.4, 70}, {2.5, 28}, {3.5, 28}, {5.5, 128}, {7.5, 134}, {9.5, 28}, {10.3, 28}, {12.3, 0}});
  keys(p.nod, {{0.5, 0}, {2.5, 15}, {3.5, 15}, {5.5, -8}, {7.5, -8}, {9.5, 15}, {12, 0}});
  return p.done(12.8);
}

std::shared_ptr<const BodyMotion> arm_raise(const Skeleton& skeleton) {
  const Person p(skeleton);
  for (std::size_t s = 0; s < 2; ++s) {
    const double late = 0.4 * static_cast<double>(s);
    for (const auto& [time, angle] : {std::array{0.5, 0.0},
                                      {2.5, 90.0},
                                      {3.5, 90.0},
                                      {5.5, 0.0},
                                      {6.0, 0.0},
                                      {8.5, 150.0},
                                      {9.0, 150.0},
                                      {11.5, 0.0}}) {
      p.flexion[s]->key(time + late, radians(angle));
    }
    for (const auto& [time, angle] : {std::array{12.0, 0.0}, {14.0, 85.0}, {15.0, 85.0}, {17.0, 0.0}}) {
      p.abduction[s]->key(time + late, radians(angle));
    }
  }
  return p.done(18.0);
}

std::shared_ptr<const BodyMotion> squat(const Skeleton& skeleton) {
  const Person p(skeleton);
  for (int n = 0; n < 4; ++n) {
    const double t = 0.5 + 3.0 * n;
    for (std::size_t s = 0; s < 2; ++s) {
      p.hip[s]->key(t, 0).key(t + 1.3, radians(80)).key(t + 2.8, 0);
      p.knee[s]->key(t, 0).key(t + 1.3, radians(95)).key(t + 2.8, 0);
      p.ankle[s]->key(t, 0).key(t + 1.3, radians(-20)).key(t + 2.8, 0);
      p.flexion[s]->key(t, 0).key(t + 1.3, radians(75)).key(t + 2.8, 0);
    }
    p.bend.key(t, 0).key(t + 1.3, radians(15)).key(t + 2.8, 0);
    p.tilt.key(t, 0).key(t + 1.3, radians(15)).key(t + 2.8, 0);
    p.motion->root(2).key(t, 0).key(t + 1.3, -0.33).key(t + 2.8, 0);
  }
  return p.done(13.0);
}

}  // namespace

bool is_whole_body(const Skeleton& skeleton) {
  for (const char* part : {"upper_arm", "forearm", "hand", "thigh", "shin", "foot"}) {
    for (const char* side : {"left_", "right_"}) {
      if (skeleton.find(std::string(side) + part) < 0) {
        return false;
      }
    }
  }
  return skeleton.find("pelvis") >= 0 && skeleton.find("abdomen") >= 0 && skeleton.find("chest") >= 0 &&
         skeleton.find("neck") >= 0;
}

std::shared_ptr<const BodyMotion> make_body_motion(const std::string& name, const Skeleton& skeleton) {
  if (name == "walk") {
    return gait(skeleton, 0.92, 1.0, 20.0, 0.022);
  }
  if (name == "run") {
    return gait(skeleton, 1.35, 1.5, 80.0, 0.04);
  }
  if (name == "box") {
    return box(skeleton);
  }
  if (name == "wave") {
    return wave(skeleton);
  }
  if (name == "reach") {
    return reach(skeleton);
  }
  if (name == "arm-raise") {
    return arm_raise(skeleton);
  }
  if (name == "squat") {
    return squat(skeleton);
  }
  return nullptr;
}

}  // namespace limbwave::simulate
