// A simulated person who does what a wizard asks.
#include "simulate/obliging_wearer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "simulate/simulate.h"
#include "support/simulated_take.h"

namespace limbwave::simulate {
namespace {

using testing_support::require;

struct Person {
  Person() {
    settings.prologue = false;
    settings.errors = require(load_errors("paper"));
    rig = require(body::load_rig("line-in-arm"));
    skeleton = require(body::load_skeleton(rig.skeleton));
    own = story("wave");
    poses = story("poses");
    range = story("range");
  }
  std::shared_ptr<const Wearer> story(const std::string& motion) {
    settings.motion = motion;
    return require(Wearer::create(settings, rig, skeleton));
  }
  [[nodiscard]] double hold_begin(const std::string& name) const {
    for (const ScriptSegment& segment : poses->segments()) {
      if (segment.name == name) {
        return 0.5 * (segment.start_s + segment.end_s);
      }
    }
    ADD_FAILURE() << name;
    return 0.0;
  }
  SimulateSettings settings;
  body::Rig rig;
  body::Skeleton skeleton;
  std::shared_ptr<const Wearer> own, poses, range;
};

std::string pose(const body::CalibrationGroup& group, bool first) {
  return "pose:" + group.name + (first ? ":first" : ":second");
}

TEST(ObligingWearer, UnaskedDoesAsItLikes) {
  const Person person;
  const ObligingWearer wearer(person.own, person.poses, person.range);
  for (double t = 0.0; t < 5.0; t += 0.37) {
    EXPECT_EQ(wearer.specific_force(1, t), person.own->specific_force(1, t));
  }
}

TEST(ObligingWearer, TakesEveryPoseOfTheRigWithinTwoSecondsAndHoldsIt) {
  const Person person;
  ObligingWearer wearer(person.own, person.poses, person.range);
  double t = 3.0;
  for (const body::CalibrationGroup& group : person.rig.groups) {
    for (const bool first : {true, false}) {
      wearer.ask(pose(group, first), t);
      const double hold = person.hold_begin(pose(group, first));
      for (const int sensor : group.sensors) {
        const Vector3d wanted = person.poses->specific_force(sensor, hold);
        for (double held = t + 2.0; held < t + 40.0; held += 0.7) {
          ASSERT_LT((wearer.specific_force(sensor, held) - wanted).norm(), 0.02) << group.name << ' ' << held - t;
        }
      }
      t += 40.0;
    }
  }
  // And goes on with the own motion when nothing is asked any more.
  wearer.ask("", t);
  EXPECT_EQ(wearer.specific_force(2, t + 3.0), person.own->specific_force(2, t + 3.0));
}

// A person's movement has no jumps, whenever it is asked for something else.
TEST(ObligingWearer, NeverJumps) {
  const Person person;
  ObligingWearer wearer(person.own, person.poses, person.range);
  const char* wishes[] = {"range", "", "range", "pose:nobody:first"};
  std::vector<std::string> all(std::begin(wishes), std::end(wishes));
  for (const body::CalibrationGroup& group : person.rig.groups) {
    all.push_back(pose(group, true));
    all.push_back(pose(group, false));
  }
  double t = 0.0;
  constexpr double kStep = 1e-3;
  Vector3d last = wearer.specific_force(0, t);
  for (std::size_t i = 0; i < all.size(); ++i) {
    wearer.ask(all[i], t);
    for (int n = 0; n < 2600; ++n) {
      t += kStep;
      const Vector3d now = wearer.specific_force(0, t);
      // No arm changes what it feels by more than a few hundred g a second.
      ASSERT_LT((now - last).norm(), 300.0 * kStandardGravity * kStep) << all[i] << ' ' << t;
      last = now;
    }
  }
}

TEST(ObligingWearer, TurnsTheSensorsInAllDirectionsWhenAskedTo) {
  const Person person;
  ObligingWearer wearer(person.own, person.poses, person.range);
  wearer.ask("range", 1.0);
  Vector3d least = Vector3d::Constant(1e9), most = -least;
  for (double t = 3.0; t < 60.0; t += 0.05) {
    const Vector3d force = wearer.specific_force(0, t);
    least = least.cwiseMin(force);
    most = most.cwiseMax(force);
  }
  EXPECT_LT(least.maxCoeff(), -0.8 * kStandardGravity);
  EXPECT_GT(most.minCoeff(), 0.8 * kStandardGravity);
}

}  // namespace
}  // namespace limbwave::simulate
