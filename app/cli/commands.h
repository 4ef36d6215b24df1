/// The commands of `limbwave`, one file each. Every `add_...` declares its options on `app` and what runs when chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

#include "console.h"

namespace limbwave::cli {

/// A finite number of an interval; CLI::Range lets through what is not a number.
inline CLI::Validator within(double least, double most) {
  const auto words = [](double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
  };
  const std::string interval = std::isfinite(most) ? words(least) + " to " + words(most) : "at least " + words(least);
  return {[=](std::string& text) -> std::string {
            double value = 0.0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && std::isfinite(value) && value >= least && value <= most
                       ? std::string()
                       : "Value " + text + " is not a number " + interval;
          },
          "(" + interval + ")", "within"};
}

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
