#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "acquire/recording_file.h"
#include "commands.h"
#include "take/body_log.h"
#include "take/import.h"
#include "take/take.h"

namespace limbwave::cli {

void add_import(CLI::App& app, Console& console) {
  struct Options {
    std::vector<std::string> csv;
    std::string take, rig = "line-in-arm", subject;
    std::vector<std::string> files;
    bool accept_truncated = false;
    std::string json;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("import", "Make a take from recordings of an MP3 player, field recorder or sound editor");
  command->add_option("TAKE", options->take, "Folder to make")->required();
  command->add_option("FILES", options->files,
                      "WAV, W64, RF64, FLAC or AIFF; several: parts of one recording, in order");
  command->add_option("--csv", options->csv,
                      "Readings of other sensors instead of recordings: tables of inertial readings or ranges; repeat "
                      "for several");
  command->add_option("--rig", options->rig, "Rig: a name or a file")->capture_default_str();
  command->add_option("--subject", options->subject, "Who wore it");
  command->add_flag("--accept-truncated", options->accept_truncated,
                    "Take files that break off as far as they go, with a warning");
  add_json_option(*command, options->json, "Write what was imported as JSON");
  command->footer("Example: limbwave import walk.take RECORD01.WAV RECORD02.WAV --rig line-in-arm");
  command->callback([options, command, &console] {
    const body::Rig rig = console.check(body::load_rig(options->rig));
    if (!options->csv.empty()) {
      const body::Skeleton skeleton = console.check(body::load_skeleton(rig.skeleton));
      const take::Take take = console.check(take::import_logs(options->take, {options->csv.begin(), options->csv.end()},
                                                              rig, skeleton, options->subject));
      const double seconds = take.info.format.rate.seconds(SampleIndex{take.info.frames}).value;
      if (command->count("--json") > 0) {
        console.print_json({{"take", options->take}, {"seconds", seconds}, {"files", options->csv.size()}},
                           options->json);
      } else {
        console.print(fmt::format("{}: {:.1f} s of readings", options->take, seconds));
      }
      return;
    }
    if (options->files.empty()) {
      console.fail({"there is nothing to import", options->take, "name recordings, or tables with --csv"});
    }
    const acquire::RecordingOptions reading{.accept_truncated = options->accept_truncated};
    Result<take::Take> imported = take::import_recordings(options->take, {options->files.begin(), options->files.end()},
                                                          rig, console.progress(), options->subject, reading);
    if (!imported && imported.error().remedy == acquire::kBreaksOffRemedy) {
      const Error& error = imported.error();
      console.fail({error.message, error.place, error.remedy + " with --accept-truncated"});
    }
    const take::Take take = console.check(std::move(imported));
    const acquire::StreamFormat& format = take.info.format;
    const double seconds = static_cast<double>(take.info.frames) / format.rate.hz;
    if (command->count("--json") > 0) {
      console.print_json({{"take", options->take},
                          {"seconds", seconds},
                          {"frames", take.info.frames},
                          {"rate_hz", format.rate.hz},
                          {"type", acquire::name(format.type)},
                          {"diagnostics", diagnostics_to_json(take.diagnostics)}},
                         options->json);
      return;
    }
    console.print(
        fmt::format("{}: {:.1f} s, {} Hz, {}", options->take, seconds, format.rate.hz, acquire::name(format.type)));
    console.print(take.diagnostics);
  });
}

}  // namespace limbwave::cli
