// The root's way by its feet alone: a walker of two points, whose soles slide and whose accelerations leak.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "base/json_reader.h"
#include "estimate/foot_root.h"

namespace limbwave::estimate {
namespace {

struct Walk {
  std::vector<FootLook> looks;
  std::vector<Vector3d> truth;
};

struct Gait {
  double speed = 1.3, slip = 0.05, leak = 0.3, jitter = 0.02, stair = 0.0, uneven = 0.0, rest = 1.0;
};

double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

// Feet that stand where they are but slide by what was drawn for the step, and swing in 0.4 s of every second.
Walk walk(unsigned seed, double seconds, const Gait& gait = {}) {
  constexpr double kRate = 120.0;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto steps = static_cast<std::size_t>(seconds) + 3;
  struct Print {
    Vector3d p, slip;
  };
  std::vector<Print> prints[2];
  for (int foot = 0; foot < 2; ++foot) {
    Vector3d p(0.0, foot == 0 ? 0.1 : -0.1, 0.0);
    for (std::size_t n = 0; n < steps; ++n) {
      const Vector3d slip(gait.slip * normal(random), gait.slip * normal(random), 0.0);
      prints[foot].push_back({p, slip});
      p += Vector3d(gait.speed * (n == 0 && foot == 0 ? 0.7 : 1.0), 0.0, gait.stair) + 0.6 * slip;
      p.z() += gait.uneven * normal(random);
    }
  }
  const auto foot_at = [&](int foot, double t) {
    const double phase = t - gait.rest - 0.5 * foot;
    if (phase <= 0.0) {
      return prints[foot][0].p;
    }
    const auto cycle = static_cast<std::size_t>(phase);
    const double s = (phase - static_cast<double>(cycle)) / 0.4;
    const Print& from = prints[foot][cycle];
    const Print& to = prints[foot][cycle + 1];
    const double stood = std::max(0.0, phase - static_cast<double>(cycle) - 0.4);
    const Vector3d begin = from.p + (cycle == 0 ? Vector3d::Zero() : Vector3d(0.6 * from.slip));
    Vector3d p = begin + smooth(s) * (to.p - begin) + stood * to.slip;
    if (s < 1.0) {
      p.z() += 8.0 * std::pow(s * (1.0 - s), 2);
    }
    return p;
  };
  const auto root_at = [&](double t) {
    // Over both feet, smoothly.
    Vector3d sum = Vector3d::Zero();
    for (int k = -6; k <= 6; ++k) {
      sum += 0.5 * (foot_at(0, t + 0.04 * k) + foot_at(1, t + 0.04 * k)) / 13.0;
    }
    return Vector3d(sum.x(), sum.y(), 0.9 + 0.2 * sum.z());
  };
  Walk out;
  Vector3d leak = Vector3d::Zero();
  const double h = 1e-3;
  for (int k = 0; k < static_cast<int>(seconds * kRate); ++k) {
    const double t = k / kRate;
    leak = leak * std::exp(-1.0 / kRate / 2.0) + gait.leak * std::sqrt(1.0 - std::exp(-1.0 / kRate)) *
                                                     Vector3d(normal(random), normal(random), normal(random));
    FootLook look;
    look.time_s = t;
    look.root_p = root_at(t);
    look.root_a = (root_at(t) - 2.0 * root_at(t - 1.0 / kRate) + root_at(t - 2.0 / kRate)) * kRate * kRate + leak;
    for (int foot = 0; foot < 2; ++foot) {
      const Vector3d jitter = gait.jitter * Vector3d(normal(random), normal(random), normal(random));
      const Vector3d p = foot_at(foot, t) - root_at(t);
      const Vector3d v =
          (foot_at(foot, t + h) - root_at(t + h) - foot_at(foot, t - h) + root_at(t - h)) / (2.0 * h) + jitter;
      look.soles.push_back({p - Vector3d(0.05, 0, 0), p + Vector3d(0.15, 0, 0), v, v});
    }
    out.truth.push_back(look.root_p);
    out.looks.push_back(look);
  }
  return out;
}

struct Error {
  Vector3d off = Vector3d::Zero(), sigma = Vector3d::Zero();
  double way = 0.0;
};

Error follow(const Walk& walk, double speed = 0.1) {
  FootRoot root(2, {});
  root.start(speed);
  RootPlace place;
  for (const FootLook& look : walk.looks) {
    place = root.push(look);
  }
  return {place.p - walk.truth.back(), place.sigma, (walk.truth.back() - walk.truth.front()).norm()};
}

TEST(FootRoot, AWalkerIsFollowedWithinWhatHisFeetSlide) {
  const Error steady = follow(walk(1, 20.0, {.slip = 0.0}));
  EXPECT_GT(steady.way, 20.0);
  EXPECT_LT(steady.off.norm(), 0.03 * steady.way);
  const Error sliding = follow(walk(1, 20.0));
  EXPECT_LT(sliding.off.norm(), 0.05 * sliding.way);
}

// Normalised estimation error squared over many walks, per axis: what is stated is what it is, within a factor of two
// in variance either way along the ground.
TEST(FootRoot, StatesHowFarItMayBeOff) {
  Vector3d nees = Vector3d::Zero();
  constexpr int kWalks = 40;
  for (unsigned seed = 1; seed <= kWalks; ++seed) {
    const Error error = follow(walk(seed, 12.0, {.slip = 0.08}));
    nees += error.off.cwiseQuotient(error.sigma).cwiseAbs2() / kWalks;
  }
  std::printf("nees x %.2f y %.2f z %.2f\n", nees.x(), nees.y(), nees.z());
  EXPECT_LT(nees.x(), 2.0);
  EXPECT_LT(nees.y(), 2.0);
  EXPECT_LT(nees.z(), 2.0);
  EXPECT_GT(nees.x() + nees.y(), 0.2);
}

TEST(FootRoot, BeginsInMidStride) {
  Walk full = walk(2, 14.0);
  Walk part;
  part.looks.assign(full.looks.begin() + 4 * 120 + 30, full.looks.end());
  part.truth.assign(full.truth.begin() + 4 * 120 + 30, full.truth.end());
  const Error error = follow(part, 2.0);
  EXPECT_LT(error.off.head<2>().norm(), 0.08 * error.way);
  const std::vector<RootPlace> both = FootRoot::smooth(part.looks, {}, 2.0);
  EXPECT_LT((both.back().p - part.truth.back()).head<2>().norm(), 0.08 * error.way);
}

// Stairs are another ground at every step; a ground that is a little uneven is the same.
TEST(FootRoot, ClimbsStairs) {
  const Walk stairs = walk(3, 12.0, {.speed = 0.6, .stair = 0.36});
  const double climbed = stairs.truth.back().z() - stairs.truth.front().z();
  ASSERT_GT(climbed, 0.6);
  EXPECT_LT(std::abs(follow(stairs).off.z()), 0.15 * climbed);
  const Error uneven = follow(walk(3, 20.0, {.uneven = 0.01}));
  EXPECT_LT(std::abs(uneven.off.z()), 0.1);
}

TEST(FootRoot, NoFeetNoWayButNoHarm) {
  Walk w = walk(4, 5.0);
  for (FootLook& look : w.looks) {
    look.soles.clear();
    look.still = look.time_s < 0.8;
  }
  FootRoot root(0, {});
  root.start(0.1);
  RootPlace place;
  for (const FootLook& look : w.looks) {
    place = root.push(look);
  }
  EXPECT_TRUE(place.p.allFinite());
  EXPECT_LT((place.p - w.truth.back()).norm(), 4.0 * place.sigma.norm());
}

TEST(FootRoot, AGapOfTimeIsBridgedAndSaid) {
  Walk w = walk(5, 12.0);
  std::vector<FootLook> looks;
  for (const FootLook& look : w.looks) {
    if (look.time_s < 5.0 || look.time_s > 7.0) {
      looks.push_back(look);
    }
  }
  w.looks = looks;
  const Error error = follow(w);
  EXPECT_TRUE(error.off.allFinite());
  EXPECT_LT(error.off.head<2>().norm(), 3.0 * error.sigma.head<2>().norm() + 0.1);
}

// Left or right first, and another heading: the same way.
TEST(FootRoot, OrderOfFeetAndHeadingDoNotCount) {
  const Walk w = walk(6, 8.0);
  const Error one = follow(w);
  Walk other = w;
  const Eigen::AngleAxisd turn(1.1, Vector3d::UnitZ());
  for (std::size_t k = 0; k < w.looks.size(); ++k) {
    FootLook& look = other.looks[k];
    std::swap(look.soles[0], look.soles[1]);
    look.root_p = turn * look.root_p;
    look.root_a = turn * look.root_a;
    other.truth[k] = turn * other.truth[k];
    for (FootLook::Sole& sole : look.soles) {
      sole = {turn * sole.heel, turn * sole.toe, turn * sole.heel_v, turn * sole.toe_v};
    }
  }
  EXPECT_LT((turn * one.off - follow(other).off).norm(), 1e-6);
}

TEST(FootRoot, SavedAndLoadedGoesOnToTheLastBit) {
  const Walk w = walk(7, 6.0);
  FootRoot whole(2, {});
  whole.start(0.1);
  FootRoot second(2, {});
  for (std::size_t k = 0; k < w.looks.size(); ++k) {
    const RootPlace place = whole.push(w.looks[k]);
    if (k == 400) {
      const nlohmann::json saved = nlohmann::json::parse(whole.save().dump());
      JsonReader::State problems{"state", {}};
      second.load(JsonReader(saved, "", problems));
      ASSERT_FALSE(problems.error);
    }
    if (k > 400) {
      ASSERT_EQ(second.push(w.looks[k]).p, place.p);
    }
  }
}

}  // namespace
}  // namespace limbwave::estimate
