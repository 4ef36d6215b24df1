#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "evaluate/evaluate.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::cli {

void add_evaluate(CLI::App& app, Console& console) {
  struct Options {
    std::string take, solve = "default", truth, json;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("evaluate", "Compare a solve with the truth");
  command->add_option("TAKE", options->take, "Folder of the take")->required();
  command->add_option("--solve", options->solve, "Name of the solve")->capture_default_str();
  command->add_option("--truth", options->truth, "Truth as CSV; otherwise the take's truth.json");
  add_json_option(*command, options->json, "Write the figures as JSON");
  command->footer("Example: limbwave evaluate reach.take --json errors.json");
  command->callback([options, command, &console] {
    const take::Take take = console.check(take::open_take(options->take));
    const solve::Solve solve = console.check(solve::load_solve(take, options->solve));
    const evaluate::Truth truth =
        console.check(options->truth.empty() ? evaluate::load_truth(std::filesystem::path(options->take) / "truth.json")
                                             : evaluate::load_truth_csv(options->truth));
    const double start = take.info.format.rate.seconds(take.info.capture().first).value;
    evaluate::Evaluation evaluation = console.check(evaluate::evaluate(solve.clip, start, truth));
    evaluation.take_seconds = solve.report.take_seconds;
    evaluation.decode_seconds = solve.report.decode_seconds;
    evaluation.solve_seconds = solve.report.solve_seconds;
    if (command->count("--json") > 0) {
      console.print_json(evaluate::evaluation_to_json(evaluation), options->json);
      return;
    }
    console.print("segment          inclination mean    max   orientation mean    max   position mean");
    const auto row = [&](const std::string& name, const evaluate::ErrorStatistics& s) {
      console.print(fmt::format("{:<16} {:>14.2f}° {:>6.2f}° {:>15.2f}° {:>5.2f}° {:>12.1f} mm", name,
                                s.inclination_mean_deg, s.inclination_max_deg, s.mean_deg, s.max_deg,
                                s.position_mean_mm));
    };
    for (const auto& [name, statistics] : evaluation.segments) {
      row(name, statistics);
    }
    row("all", evaluation.all);
  });
}

}  // namespace limbwave::cli
