#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "solve/body_solve.h"
#include "solve/compose.h"
#include "solve/report_text.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::cli {

void add_solve(CLI::App& app, Console& console) {
  struct Options {
    std::string take, sensors = "A", method = "auto", root = "fixed", smoothing = "chain";
    solve::SolveSettings settings;
    std::string left = "auto", right = "auto";
    double coupling = -1.0;
    std::string json, start = "any", save_state, resume;
    bool tune = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("solve", "Turn the signals of a take into a moving skeleton");
  command->add_option("TAKE", options->take, "Folder of the take")->required();
  command->add_option("--sensors", options->sensors, "What to use: A = accelerometers, G = gyroscopes, D = ranges")
      ->check(CLI::IsMember({"A", "G", "D", "AG", "AD", "GD", "AGD"}))
      ->default_str("all there are");
  command
      ->add_option(
          "--method", options->method,
          "auto: inclination for a sound card's accelerometers, smoother for all other recordings; inclination: from "
          "the direction of gravity; filter: all sensors together on the whole skeleton; smoother: "
          "the same from both sides in time; batch: the smoother again and again, each linearised about the one "
          "before, until that changes nothing")
      ->check(CLI::IsMember({"auto", "inclination", "filter", "smoother", "batch"}))
      ->capture_default_str();
  command->add_option("--root", options->root,
                      "fixed: the root stays where it is; contacts: by feet that stand on the ground, the default for "
                      "a body with feet; "
                      "free: by its acceleration alone; truth: as simulated; or a CSV file with its path");
  command
      ->add_option(
          "--smoothing", options->smoothing,
          "chain: all limbs together, by what their own movement makes the sensors feel; adaptive: every sensor "
          "by itself, weighted by trust, without lag; bridging: also carries over short bursts; none")
      ->check(CLI::IsMember({"chain", "adaptive", "bridging", "none"}))
      ->capture_default_str();
  command->add_option("--smoothing-time", options->settings.smoothing_s, "Time scale of smoothing, seconds")
      ->check(within(estimate::kLeastSmoothing_s, 2.0))
      ->capture_default_str();
  command
      ->add_option("--calibration", options->settings.calibration,
                   "Where the calibration comes from; auto: the first of these that there is")
      ->check(CLI::IsMember({"auto", "snapshot", "segments", "library", "nominal"}))
      ->capture_default_str();
  command
      ->add_option("--coupling", options->coupling,
                   "Corner of the sound card's high pass, Hz; 0: no correction; otherwise found from the signal")
      ->check(within(0.0, 100.0));
  command->add_option("--left", options->left, "Polarity of the left channel")
      ->check(CLI::IsMember({"auto", "normal", "inverted"}))
      ->capture_default_str();
  command->add_option("--right", options->right, "Polarity of the right channel")
      ->check(CLI::IsMember({"auto", "normal", "inverted"}))
      ->capture_default_str();
  command->add_option("--name", options->settings.name, "Name of the solve within the take")->capture_default_str();
  command
      ->add_option("--start", options->start,
                   "any: from rest where there is rest; rest: refuse a wearer who was not still in the first second; "
                   "moving: in mid-motion")
      ->check(CLI::IsMember({"any", "rest", "moving"}))
      ->capture_default_str();
  command->add_option("--save-state", options->save_state, "Save the filter's last state, to resume from");
  command->add_option("--resume", options->resume, "Resume from a saved state: the take is the next part of one");
  command->add_flag("--tune", options->tune,
                    "Find how noisy sensors and how lively the wearer are from the take's first seconds");
  add_json_option(*command, options->json, "Write the quality report as JSON");
  command->footer("Example: limbwave solve reach.take --smoothing adaptive --name final");
  command->callback([options, command, &console] {
    solve::SolveSettings settings = options->settings;
    settings.smoothing = solve::smoothing_named(options->smoothing).value_or(settings.smoothing);
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
    if (options->method == "auto") {
      options->method = take.info.kind == "line-in" ? "inclination" : "smoother";
    }
    if (options->method == "inclination" && (options->sensors != "A" || options->root != "fixed")) {
      console.fail({"uses accelerometers on a root that is fixed", options->take,
                    "a take of a sound card has nothing else; other takes are solved by --method filter or smoother"});
    }
    if (take.info.kind == "log" && options->method == "inclination") {
      console.fail({"holds readings of other sensors", options->take, "choose --method filter or smoother"});
    }
    if (take.info.kind == "driver-box" && options->method == "inclination") {
      console.fail({"is a recording of a driver box", options->take, "choose --method filter or smoother"});
    }
    if (take.info.kind == "line-in" && options->method != "inclination") {
      console.fail({"is a recording of a sound card", options->take, "choose --method inclination"});
    }
    if (options->tune && options->method == "inclination") {
      console.fail({"is for the body filter", "--tune", "choose --method filter, smoother or batch"});
    }
    settings.headings = solve::known_headings(take, settings.name);  // The user's own; nothing else knows them.
    const auto solved = [&] {
      if (options->method == "inclination") {
        return solve::solve_take(take, settings, console.progress());
      }
      const bool batch = options->method == "batch";
      solve::BodySolveSettings body{settings.name, options->sensors, batch || options->method == "smoother",
                                    options->root};
      body.optimise = batch;
      body.tune = options->tune;
      body.sensors = command->count("--sensors") > 0 ? options->sensors : "AGD";
      body.root = command->count("--root") > 0 ? options->root : solve::usual_root(take);
      body.start = options->start == "rest"     ? estimate::StartMode::kRest
                   : options->start == "moving" ? estimate::StartMode::kMoving
                                                : estimate::StartMode::kAny;
      body.save_state = options->save_state;
      body.resume = options->resume;
      Result<solve::Solve> by_filter = solve::solve_sensors(take, body, console.progress());
      if (by_filter) {
        solve::apply_headings(*by_filter, solve::sensor_segments(take.info.rig, by_filter->clip.skeleton),
                              settings.headings);
      }
      return by_filter;
    };
    const solve::Solve solve = console.check(solved());
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
