/// Wearers of the driver box through the body filter, from readings with the errors of the profiles: what the filter
/// reaches, what the smoother adds, and whether both know how far off they are.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "estimate/exact_rig.h"
#include "support/body_runs.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;
using testing_support::JointErrors;

std::vector<std::string> motions() {
  std::vector<std::string> names{"box", "squat"};
  const char* data = std::getenv("LIMBWAVE_DATA");
  for (const char* file : {"02_05.bvh", "03_01.bvh"}) {
    const fs::path path = fs::path(data != nullptr ? data : "") / "motions" / file;
    if (fs::exists(path)) {
      names.push_back(path.string());
    }
  }
  return names;
}

struct Solved {
  JointErrors filter, smoother;
  bool exact = false;
};

Solved solved(const std::string& motion, const std::string& profile, std::uint64_t seed, bool smooth) {
  const auto errors = simulate::load_driver_box_errors(profile);
  EXPECT_TRUE(errors.ok());
  const auto wearer = testing_support::make_wearer(motion, *errors, seed, 2.0, 7.0);
  EXPECT_TRUE(wearer.ok());
  const auto model = estimate::body_model(wearer->rig, wearer->skeleton);
  estimate::BodyFilterParameters p;
  p.root = estimate::RootMode::kGiven;
  Solved result;
  result.exact = estimate::rig_is_exact(model, p, wearer->readings);
  p = result.exact ? estimate::exact_parameters(p) : p;
  const auto forward = estimate::filter_body(model, p, wearer->readings, 30.0, {});
  EXPECT_TRUE(forward.ok());
  result.filter = errors_of(*wearer, forward->track);
  if (smooth) {
    const auto both = estimate::smooth_body(model, p, wearer->readings, 30.0, {});
    EXPECT_TRUE(both.ok());
    result.smoother = errors_of(*wearer, both->track);
  }
  return result;
}

TEST(BodyAccuracy, WithoutErrorsEveryJointIsExact) {
  for (const std::string& motion : motions()) {
    const Solved run = solved(motion, "none", 1, false);
    EXPECT_TRUE(run.exact) << motion;
    for (const auto& [joint, errors] : run.filter.by_name) {
      EXPECT_LE(errors.mean(), 0.05) << motion << " " << joint;
    }
  }
}

TEST(BodyAccuracy, WithTheErrorsOfThePaper) {
  double filter = 0.0;
  double smoother = 0.0;
  std::uint64_t seed = 11;
  for (const std::string& motion : motions()) {
    const Solved run = solved(motion, "paper", seed++, true);
    EXPECT_FALSE(run.exact) << motion;
    EXPECT_LE(run.filter.all.mean(), 3.5) << motion;
    EXPECT_LE(run.smoother.all.mean(), 3.5) << motion;
    for (const JointErrors* errors : {&run.filter, &run.smoother}) {
      EXPECT_LT(errors->all.rms(), 1.5 * errors->all.sigma()) << motion;
      EXPECT_GT(errors->all.rms(), errors->all.sigma() / 1.5) << motion;
    }
    filter += run.filter.all.mean();
    smoother += run.smoother.all.mean();
  }
  EXPECT_LE(smoother, 0.85 * filter);
}

}  // namespace
}  // namespace limbwave
