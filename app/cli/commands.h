/// The commands of `limbwave`, one file each. Every `add_...` declares its options on `app` and what runs when chosen.
#pragma once

#include <CLI/CLI.hpp>

#include "console.h"

namespace limbwave::cli {

/// The option `--json [FILE]` of commands that report: "-" or nothing is standard output.
void add_json_option(CLI::App& command, std::string& file, const std::string& what);

void add_calibrate(CLI::App& app, Console& console);
/// `limbwave calibrate sound`.
void add_calibrate_sound(CLI::App& calibrate, Console& console);
void add_devices(CLI::App& app, Console& console);
void add_evaluate(CLI::App& app, Console& console);
void add_export(CLI::App& app, Console& console);
void add_import(CLI::App& app, Console& console);
void add_info(CLI::App& app, Console& console);
void add_record(CLI::App& app, Console& console);
void add_simulate(CLI::App& app, Console& console);
void add_solve(CLI::App& app, Console& console);

}  // namespace limbwave::cli
