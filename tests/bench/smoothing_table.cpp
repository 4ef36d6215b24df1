/// Prints how far the inclinations of moving limbs are off, by motion and smoothing, offline and live, on simulated
/// takes with their whole way from samples on. Usage: smoothing_table [MOTION|FILE ... [--errors NAME] [--seeds N]]
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "estimate/inclination_tracker.h"
#include "integration/limb_readings.h"

namespace {

using namespace limbwave;
using testing_support::LimbReadings;
using testing_support::require;
using testing_support::StillAndMoving;
using Estimates = std::vector<std::vector<estimate::Inclination>>;

struct Method {
  const char* name;
  std::function<Estimates(const LimbReadings&)> estimate;
};

Estimates offline(const LimbReadings& readings, estimate::Smoothing smoothing) {
  Estimates estimates;
  for (const auto& samples : readings.samples) {
    estimates.push_back(estimate::estimate_inclinations(samples, smoothing));
  }
  return estimates;
}

Estimates live(const LimbReadings& readings, estimate::Smoothing smoothing) {
  Estimates estimates;
  for (const auto& samples : readings.samples) {
    estimate::InclinationTracker tracker(smoothing);
    auto& results = estimates.emplace_back();
    for (const estimate::ForceSample& sample : samples) {
      results.push_back(tracker.push(sample));
    }
  }
  return estimates;
}

const std::vector<Method>& methods() {
  using enum estimate::Smoothing;
  static const std::vector<Method> kMethods{
      {"none", [](const LimbReadings& r) { return offline(r, kNone); }},
      {"adaptive", [](const LimbReadings& r) { return offline(r, kAdaptive); }},
      {"bridging", [](const LimbReadings& r) { return offline(r, kBridging); }},
      {"adaptive, live", [](const LimbReadings& r) { return live(r, kAdaptive); }},
      {"bridging, live", [](const LimbReadings& r) { return live(r, kBridging); }},
  };
  return kMethods;
}

LimbReadings readings_of(const std::string& motion, const std::string& errors, std::uint64_t seed) {
  const test::TemporaryFolder folder;
  simulate::SimulateSettings settings;
  settings.motion = motion;
  settings.errors_name = errors;
  settings.errors = require(simulate::load_errors(errors));
  settings.seed = seed;
  settings.prologue = errors != "none";
  const take::Take take = testing_support::simulated(folder / "x.take", settings);
  return testing_support::limb_readings(take);
}

void row(const std::string& motion, const std::string& errors, std::uint64_t seeds) {
  std::vector<StillAndMoving> figures(methods().size());
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const LimbReadings readings = readings_of(motion, errors, seed);
    for (std::size_t m = 0; m < methods().size(); ++m) {
      figures[m].add(testing_support::errors_of(readings, methods()[m].estimate(readings)));
    }
  }
  const std::string name = motion.substr(motion.find_last_of('/') + 1);
  for (std::size_t m = 0; m < methods().size(); ++m) {
    const StillAndMoving& f = figures[m];
    fmt::print("| {:<24} | {:<8} | {:<14} | {:6.2f} | {:6.2f} | {:6.2f} | {:6.2f} | {:3.0f} % |\n", name, errors,
               methods()[m].name, f.still.mean(), f.still.quantile(0.95), f.moving.mean(), f.moving.quantile(0.95),
               100.0 * f.within);
  }
  std::fflush(stdout);
}

void print_table(const std::vector<std::string>& arguments) {
  std::vector<std::string> motions;
  std::vector<std::string> profiles{"none", "accurate", "paper"};
  std::uint64_t seeds = 3;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--seeds" && i + 1 < arguments.size()) {
      seeds = std::stoull(arguments[++i]);
    } else if (arguments[i] == "--errors" && i + 1 < arguments.size()) {
      profiles = {arguments[++i]};
    } else {
      motions.push_back(arguments[i]);
    }
  }
  if (motions.empty()) {
    motions = {"arm-raise", "wave", "reach", "walk", "box", "every-joint"};
  }
  fmt::print("| {:<24} | {:<8} | {:<14} | {:>6} | {:>6} | {:>6} | {:>6} | {:>5} |\n", "motion", "errors", "smoothing",
             "still", "95 %", "moving", "95 %", "2 sd");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  for (const std::string& motion : motions) {
    for (const std::string& errors : profiles) {
      row(motion, errors, errors == "none" ? 1 : seeds);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    print_table({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "smoothing_table: {}\n", error.what());
    return 1;
  }
  return 0;
}
