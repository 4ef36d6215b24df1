/// `limbwave`: everything the studio can do to data, for scripts.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.h"

void limbwave::cli::add_json_option(CLI::App& command, std::string& file, const std::string& what) {
  command.add_option("--json", file, what + " to this file; -: standard output")->expected(0, 1)->default_str("-");
}

namespace {

int run(int argc, char** argv) {
  using namespace limbwave::cli;
  Console::catch_interrupts();
  Console console;
  CLI::App app{"Limbwave: low-cost wearable motion capture from raw samples to animation", "limbwave"};
  app.set_version_flag("--version", std::string("limbwave ") + LIMBWAVE_VERSION);
  app.require_subcommand(1);
  add_devices(app, console);
  add_record(app, console);
  add_import(app, console);
  add_calibrate(app, console);
  add_solve(app, console);
  add_export(app, console);
  add_simulate(app, console);
  add_evaluate(app, console);
  add_info(app, console);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    const bool unknown = argc > 1 && argv[1][0] != '-' &&
                         app.get_subcommands([&](CLI::App* command) { return command->get_name() == argv[1]; }).empty();
    if (unknown) {
      std::fprintf(stderr, "limbwave: \"%s\" is not a command; see limbwave --help\n", argv[1]);
    } else {
      std::string message = error.what();
      std::replace(message.begin(), message.end(), '\n', ' ');
      const std::string command = app.get_subcommands().empty() ? "" : " " + app.get_subcommands().front()->get_name();
      std::fprintf(stderr, "limbwave: %s; see limbwave%s --help\n", message.c_str(), command.c_str());
    }
    return 2;
  } catch (const CommandFailed& error) {
    std::fprintf(stderr, "limbwave: %s\n", error.what());
    return Console::interrupted() ? 130 : 1;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "limbwave: out of memory; close other programs or work on a shorter take\n");
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "limbwave: unexpected failure: %s; please report this\n", error.what());
    return 1;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fputs("limbwave: standard output: cannot be written; check that the disk has room\n", stderr);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (...) {
    std::fputs("limbwave: unexpected failure; please report this\n", stderr);
    return 1;
  }
}
