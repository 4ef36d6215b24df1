#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "take/import.h"
#include "take/take.h"

namespace limbwave::cli {

void add_import(CLI::App& app, Console& console) {
  struct Options {
    std::string take, rig = "line-in-arm", subject;
    std::vector<std::string> files;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("import", "Make a take from recordings of an MP3 player, field recorder or sound editor");
  command->add_option("TAKE", options->take, "Folder to make")->required();
  command
      ->add_option("FILES", options->files, "WAV, W64, RF64, FLAC or AIFF; several: parts of one recording, in order")
      ->required();
  command->add_option("--rig", options->rig, "Rig: a name or a file")->capture_default_str();
  command->add_option("--subject", options->subject, "Who wore it");
  command->footer("Example: limbwave import walk.take RECORD01.WAV RECORD02.WAV --rig line-in-arm");
  command->callback([options, &console] {
    const body::Rig rig = console.check(body::load_rig(options->rig));
    const take::Take take = console.check(take::import_recordings(
        options->take, {options->files.begin(), options->files.end()}, rig, console.progress(), options->subject));
    console.print(fmt::format("{}: {:.1f} s, {} Hz, {}", options->take,
                              static_cast<double>(take.info.frames) / take.info.format.rate.hz,
                              take.info.format.rate.hz, acquire::name(take.info.format.type)));
    console.print(take.diagnostics);
  });
}

}  // namespace limbwave::cli
