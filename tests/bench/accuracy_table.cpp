/// Prints the accuracy of the line-in path on simulated takes, as a table beside its bars. Usage: accuracy_table
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "integration/accuracy.h"

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

ErrorFigures wire_inclination(simulate::SimulateSettings s, const decode::LineInParameters& parameters = {}) {
  const TemporaryFolder folder;
  s.prologue = false;
  const take::Take take = simulated(folder / "x.take", s);
  return testing_support::wire_errors(take, require(solve::decode_take(take, parameters, {}))).inclination_deg;
}

void row(const std::string& what, const ErrorFigures& figures, const std::string& bar) {
  fmt::print("| {:<64} | {:8.4f} | {:8.4f} | {:<22} |\n", what, figures.mean, figures.max, bar);
  std::fflush(stdout);
}

void none() {
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

void electronics() {
  for (const char* motion : {"still", "reach", "every-joint"}) {
    for (const double rate : {44100.0, 48000.0, 96000.0, 192000.0}) {
      simulate::SimulateSettings s = settings(motion, "electronics", 2);
      s.format.rate = SampleRate{rate};
      row(fmt::format("electronics, {}, {:g} kHz: added inclination, °", motion, rate / 1e3), wire_inclination(s),
          "mean 0.15, max 0.5");
    }
  }
}

void coupling() {
  for (const double hz : {1.0, 5.0, 20.0}) {
    simulate::SimulateSettings s = settings("still", "electronics", 3);
    s.errors.coupling_hz = hz;
    decode::LineInParameters off;
    off.coupling_hz = 0.0;
    row(fmt::format("coupling {:g} Hz, corrected: added inclination, °", hz), wire_inclination(s),
        "mean 0.15, max 0.5");
    row(fmt::format("coupling {:g} Hz, not corrected: added inclination, °", hz), wire_inclination(s, off),
        "for comparison");
  }
}

void calibrated() {
  for (const auto& [errors, bar] :
       {std::pair{"accurate", "mean 0.5, max 1.5 (paper 2, 4)"}, std::pair{"paper", "paper 6, 13"}}) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      const TemporaryFolder folder;
      const take::Take take = simulated(folder / "x.take", settings("still", errors, seed));
      row(fmt::format("whole path, still poses, errors \"{}\", seed {}: inclination, °", errors, seed),
          testing_support::still_pose_errors(take, require(solve::solve_take(take, {}, {}))), bar);
    }
  }
}

void smoothing() {
  for (const char* motion : {"wave", "reach", "walk", "box"}) {
    const TemporaryFolder folder;
    const take::Take take = simulated(folder / "x.take", settings(motion, "accurate", 6));
    const evaluate::Truth truth = require(evaluate::load_truth(take.folder / "truth.json"));
    for (const auto& [name, method] :
         {std::pair{"none", solve::Smoothing::kNone}, std::pair{"adaptive", solve::Smoothing::kAdaptive},
          std::pair{"bridging", solve::Smoothing::kBridging}}) {
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

int main() {
  try {
    fmt::print("| {:<64} | {:>8} | {:>8} | {:<22} |\n|---|---|---|---|\n", "what", "mean", "max", "bar");
    none();
    electronics();
    coupling();
    calibrated();
    smoothing();
  } catch (const std::exception& error) {
    fmt::print(stderr, "accuracy_table: {}\n", error.what());
    return 1;
  }
  return 0;
}
