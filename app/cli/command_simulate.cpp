#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "simulate/simulate.h"

namespace limbwave::cli {

void add_simulate(CLI::App& app, Console& console) {
  struct Options {
    std::string take, errors = "paper", type = "int16";
    simulate::SimulateSettings settings;
    double rate = 48000.0;
    int actors = 1;
    bool no_prologue = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("simulate", "Make a take by simulation, with the truth beside it");
  std::string motions;
  for (const std::string& motion : simulate::builtin_motions()) {
    motions += (motions.empty() ? "" : ", ") + motion;
  }
  command->add_option("TAKE", options->take, "Folder to make")->required();
  command
      ->add_option("--motion", options->settings.motion,
                   "One of " + motions + "; or a .bvh file; or logs of real accelerations (.csv, .csv.gz, .txt)")
      ->capture_default_str();
  command->add_option("--rig", options->settings.rig, "Rig: a name or a file")->capture_default_str();
  command->add_option("--errors", options->errors, "Error profile: none, paper, another shipped one or a file")
      ->capture_default_str();
  command->add_option("--seed", options->settings.seed, "Seed of everything random")->capture_default_str();
  command->add_option("--seconds", options->settings.seconds, "Length of the motion; 0: its own")
      ->check(within(0.0, 36000.0))
      ->capture_default_str();
  command->add_option("--rate", options->rate, "Samples a second")
      ->check(within(44100.0, 192000.0))
      ->capture_default_str();
  command->add_option("--type", options->type, "Sample type")
      ->check(CLI::IsMember({"int16", "int24", "int32", "float32"}))
      ->capture_default_str();
  command->add_option("--actors", options->actors, "Number of people")->check(CLI::Range(1, 1))->capture_default_str();
  command->add_flag("--no-calibration", options->no_prologue, "Leave out the calibration at the start of the take");
  command->footer("Example: limbwave simulate reach.take --motion reach --errors paper --seed 7");
  command->callback([options, &console] {
    simulate::SimulateSettings settings = options->settings;
    settings.errors_name = options->errors;
    if (options->take.empty()) {
      console.fail({"has no name", "TAKE", "name the folder that is to be made"});
    }
    if (console.check(body::load_rig(settings.rig)).driver_box) {
      settings.driver_box_errors = console.check(simulate::load_driver_box_errors(options->errors));
    } else {
      settings.errors = console.check(simulate::load_errors(options->errors));
    }
    settings.prologue = !options->no_prologue;
    settings.format.rate = SampleRate{options->rate};
    for (const auto type : {acquire::SampleType::kInt16, acquire::SampleType::kInt24, acquire::SampleType::kInt32,
                            acquire::SampleType::kFloat32}) {
      if (acquire::name(type) == options->type) {
        settings.format.type = type;
      }
    }
    console.check(simulate::simulate_take(options->take, settings, console.progress()));
    console.print(fmt::format("{}: simulated \"{}\" with errors \"{}\", seed {}", options->take, settings.motion,
                              settings.errors_name, settings.seed));
  });
}

}  // namespace limbwave::cli
