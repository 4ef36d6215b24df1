/// Prints the accuracy of the line-in path on simulated takes, as a table beside its bars.
/// Usage: accuracy_table [none|signal|calibrated|smoothing ...]   (default: all)
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "integration/accuracy.h"
#include "solve/report_text.h"

namespace {

using namespace limbwave;
using testing_support::ErrorFigures;
using testing_support::require;
using testing_support::simulated;
using testing_support::TemporaryFolder;

simulate::SimulateSettings settings(const std::string& motion, const std::string& errors, std::uint64_t seed) {
  simulate::SimulateSettings s;
  s.motion = motion;
  s.errors_name = errors;
  s.errors = require(simulate::load_errors(errors));
  s.seed = seed;
  return s;
}

void row(const std::string& what, const ErrorFigures& figures, const std::string& bar) {
  fmt::print("| {:<64} | {:8.4f} | {:8.4f} | {:<22} |\n", what, figures.mean, figures.max, bar);
  std::fflush(stdout);
}

void head(const char* what) {
  fmt::print("\n| {:<64} | {:>8} | {:>8} | {:<22} |\n|---|---|---|---|\n", what, "mean", "max", "bar");
}

void none() {
  head("errors none");
  const TemporaryFolder folder;
  simulate::SimulateSettings s = settings("every-joint", "none", 1);
  s.format.type = acquire::SampleType::kFloat32;
  s.prologue = false;
  const take::Take take = simulated(folder / "none.take", s);
  row("errors none, every-joint: acceleration, g",
      testing_support::wire_errors(take, require(solve::decode_take(take, {}, {}))).acceleration_g, "max 1e-4");
  s = settings("still", "none", 1);
  s.format.type = acquire::SampleType::kFloat32;
  const take::Take still = simulated(folder / "still.take", s);
  row("errors none, still poses: inclination, °",
      testing_support::still_pose_errors(still, require(solve::solve_take(still, {}, {}))), "max 0.01");
}

// What wire and decoder add, by rate and coupling, with and without the correction of the coupling.
void signal_block() {
  fmt::print(
      "\nInclination error added by wire and decoder, electronics of the profile, seed 3; bar: mean 0.15°, max "
      "0.5°\n\n");
  fmt::print(
      "| rate, kHz | coupling, Hz | motion | mean, ° | max, ° | usable, % | without correction: mean, ° | max, ° | "
      "|\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|\n");
  for (const double rate : {44100.0, 48000.0, 96000.0, 192000.0}) {
    for (const double hz : {1.0, 5.0, 20.0}) {
      for (const char* motion : {"still", "reach", "every-joint"}) {
        const TemporaryFolder folder;
        simulate::SimulateSettings s = settings(motion, "electronics", 3);
        s.format.rate = SampleRate{rate};
        s.errors.coupling_hz = hz;
        s.prologue = false;
        const take::Take take = simulated(folder / "x.take", s);
        decode::LineInParameters off;
        off.coupling_hz = 0.0;
        const auto with = testing_support::wire_errors(take, require(solve::decode_take(take, {}, {})));
        const auto without = testing_support::wire_errors(take, require(solve::decode_take(take, off, {})));
        const bool meets = with.inclination_deg.mean <= 0.15 && with.inclination_deg.max <= 0.5;
        fmt::print("| {:g} | {:g} | {} | {:.3f} | {:.3f} | {:.1f} | {:.2f} | {:.2f} | {} |\n", rate / 1e3, hz, motion,
                   with.inclination_deg.mean, with.inclination_deg.max, 100.0 * with.usable,
                   without.inclination_deg.mean, without.inclination_deg.max,
                   meets ? "meets the bar" : "misses the bar");
        std::fflush(stdout);
      }
    }
  }
}

void calibrated() {
  head("whole path, still poses, by smoothing");
  for (const auto& [errors, bar] :
       {std::pair{"accurate", "mean 0.5, max 1.5 (paper 2, 4)"}, std::pair{"paper", "paper 6, 13"}}) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      const TemporaryFolder folder;
      const take::Take take = simulated(folder / "x.take", settings("still", errors, seed));
      for (const solve::Smoothing smoothing : {solve::Smoothing::kAdaptive, solve::Smoothing::kChain}) {
        solve::SolveSettings wanted;
        wanted.smoothing = smoothing;
        row(fmt::format("\"{}\", seed {}, {}: inclination, °", errors, seed, solve::name(smoothing)),
            testing_support::still_pose_errors(take, require(solve::solve_take(take, wanted, {}))), bar);
      }
    }
  }
}

void smoothing() {
  head("moving, accurate calibration");
  for (const char* motion : {"wave", "reach", "walk", "box"}) {
    const TemporaryFolder folder;
    const take::Take take = simulated(folder / "x.take", settings(motion, "accurate", 6));
    const evaluate::Truth truth = require(evaluate::load_truth(take.folder / "truth.json"));
    for (const auto& [name, method] :
         {std::pair{"none", solve::Smoothing::kNone}, std::pair{"adaptive", solve::Smoothing::kAdaptive},
          std::pair{"bridging", solve::Smoothing::kBridging}, std::pair{"chain", solve::Smoothing::kChain}}) {
      solve::SolveSettings wanted;
      wanted.smoothing = method;
      const solve::Solve solve = require(solve::solve_take(take, wanted, {}));
      const double origin = take.info.format.rate.seconds(take.info.capture().first).value;
      const evaluate::Evaluation evaluation = require(evaluate::evaluate(solve.clip, origin, truth));
      ErrorFigures figures;
      figures.mean = evaluation.all.inclination_mean_deg;
      figures.max = evaluation.all.inclination_max_deg;
      row(fmt::format("moving, {}, smoothing {}: inclination, °", motion, name), figures, "for comparison");
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::pair<std::string, void (*)()>> blocks{
      {"none", none}, {"signal", signal_block}, {"calibrated", calibrated}, {"smoothing", smoothing}};
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  try {
    for (const auto& [name, print] : blocks) {
      if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end()) {
        print();
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "accuracy_table: {}\n", error.what());
    return 1;
  }
  return 0;
}
