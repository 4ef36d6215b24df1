#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "solve/report_text.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::cli {

void add_solve(CLI::App& app, Console& console) {
  struct Options {
    std::string take, sensors = "A", method = "inclination", root = "fixed", smoothing = "adaptive";
    solve::SolveSettings settings;
    std::string left = "auto", right = "auto";
    double coupling = -1.0;
    std::string json;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("solve", "Turn the signals of a take into a moving skeleton");
  command->add_option("TAKE", options->take, "Folder of the take")->required();
  command->add_option("--sensors", options->sensors, "What to use: A = accelerometers")
      ->check(CLI::IsMember({"A"}))
      ->capture_default_str();
  command->add_option("--method", options->method, "inclination: from the direction of gravity")
      ->check(CLI::IsMember({"inclination"}))
      ->capture_default_str();
  command->add_option("--root", options->root, "fixed: the root stays where it is")
      ->check(CLI::IsMember({"fixed"}))
      ->capture_default_str();
  command
      ->add_option("--smoothing", options->smoothing,
                   "none; adaptive: weighted by trust, without lag; bridging: also carries over short bursts")
      ->check(CLI::IsMember({"none", "adaptive", "bridging"}))
      ->capture_default_str();
  command->add_option("--smoothing-time", options->settings.smoothing_s, "Time scale of smoothing, seconds")
      ->check(CLI::Range(estimate::kLeastSmoothing_s, 2.0))
      ->capture_default_str();
  command
      ->add_option("--calibration", options->settings.calibration,
                   "Where the calibration comes from; auto: the first of these that there is")
      ->check(CLI::IsMember({"auto", "snapshot", "segments", "library", "nominal"}))
      ->capture_default_str();
  command
      ->add_option("--coupling", options->coupling,
                   "Corner of the sound card's high pass, Hz; 0: no correction; otherwise found from the signal")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--left", options->left, "Polarity of the left channel")
      ->check(CLI::IsMember({"auto", "normal", "inverted"}))
      ->capture_default_str();
  command->add_option("--right", options->right, "Polarity of the right channel")
      ->check(CLI::IsMember({"auto", "normal", "inverted"}))
      ->capture_default_str();
  command->add_option("--name", options->settings.name, "Name of the solve within the take")->capture_default_str();
  command->add_option("--json", options->json, "Write the quality report as JSON to this file; -: standard output")
      ->expected(0, 1)
      ->default_str("-");
  command->footer("Example: limbwave solve reach.take --smoothing adaptive --name final");
  command->callback([options, command, &console] {
    solve::SolveSettings settings = options->settings;
    settings.smoothing = options->smoothing == "none"       ? solve::Smoothing::kNone
                         : options->smoothing == "adaptive" ? solve::Smoothing::kAdaptive
                                                            : solve::Smoothing::kBridging;
    const auto polarity = [](const std::string& text) {
      return text == "normal"     ? decode::Polarity::kNormal
             : text == "inverted" ? decode::Polarity::kInverted
                                  : decode::Polarity::kAuto;
    };
    settings.line_in.left = polarity(options->left);
    settings.line_in.right = polarity(options->right);
    if (options->coupling >= 0.0) {
      settings.line_in.coupling_hz = options->coupling;
    }
    const take::Take take = console.check(take::open_take(options->take));
    const solve::Solve solve = console.check(solve::solve_take(take, settings, console.progress()));
    console.check(solve::save_solve(take, solve));
    if (command->count("--json") > 0) {
      console.print_json(solve::report_to_json(solve), options->json);
      return;
    }
    for (const std::string& line : solve::report_lines(solve)) {
      console.print(line);
    }
    console.print(solve.report.diagnostics);
  });
}

}  // namespace limbwave::cli
