#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "commands.h"
#include "evaluate/driver_box_evaluation.h"
#include "evaluate/evaluate.h"
#include "evaluate/radio_ranges.h"
#include "solve/driver_box.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::cli {
namespace {

constexpr std::array kMethods = {"paper", "envelope", "carrier"};

// Ranges and words of a driver box, and the solve where there is one.
void evaluate_driver_box(const take::Take& take, const std::string& method, const std::string& solve_name,
                         bool solve_asked, const std::string* json_file, Console& console) {
  const std::filesystem::path truth_file = take.folder / "truth.json";
  const evaluate::DriverBoxTruth truth = console.check(evaluate::load_driver_box_truth(truth_file));
  const body::DriverBoxSignal& box = take.info.rig.driver_box.value();
  evaluate::DriverBoxComparison comparison(truth, take.info.format.rate.hz, box.pulse_hz,
                                           solve::ranging_calibration(take.info).speed_of_sound,
                                           box.gyroscope_range_rad_s, box.accelerometer_range_g * kStandardGravity);
  decode::DriverBoxParameters parameters;
  parameters.ranging.method =
      static_cast<decode::RangingMethod>(std::find(kMethods.begin(), kMethods.end(), method) - kMethods.begin());
  const solve::DriverBoxReport report = console.check(solve::decode_driver_box(
      take, parameters,
      [&](std::span<const decode::RangeReading> ranges, std::span<const decode::InertialReading> inertial) -> Status {
        for (const decode::RangeReading& reading : ranges) {
          comparison.add(reading);
        }
        for (const decode::InertialReading& reading : inertial) {
          comparison.add(reading);
        }
        return {};
      },
      console.progress()));
  console.end_progress();
  std::vector<decode::InertialCounters> counters;
  for (const decode::WordStatus& status : report.words) {
    counters.push_back(status.counters);
  }
  comparison.set_counters(counters);
  const evaluate::RangeStatistics ranges = comparison.ranges();
  const evaluate::WordStatistics& words = comparison.words();
  const double seconds = static_cast<double>(take.info.frames) / take.info.format.rate.hz;
  nlohmann::json json = nlohmann::json::object();
  const std::vector<std::string> solves = solve::list_solves(take);
  if (solve_asked || std::find(solves.begin(), solves.end(), solve_name) != solves.end()) {
    const solve::Solve solve = console.check(solve::load_solve(take, solve_name));
    const double start = take.info.format.rate.seconds(take.info.capture().first).value;
    evaluate::Evaluation evaluation =
        console.check(evaluate::evaluate(solve.clip, start, console.check(evaluate::load_truth(truth_file))));
    evaluation.solve_seconds = solve.report.solve_seconds;
    json = evaluate::evaluation_to_json(evaluation);
  }
  json["ranges"] = evaluate::ranges_to_json(ranges);
  json["words"] = evaluate::words_to_json(words);
  json["seconds"]["take"] = seconds;
  json["seconds"]["decode"] = report.seconds;
  if (json_file != nullptr) {
    console.print_json(json, *json_file);
    return;
  }
  console.print(fmt::format(
      "ranges by {}: {} of {} accepted, {:.1f} % of clear pairs", method, ranges.accepted, ranges.count,
      100.0 * static_cast<double>(ranges.clear_accepted) / std::max<double>(1.0, static_cast<double>(ranges.clear))));
  console.print(fmt::format("  error median {:.3f} mm, mean {:.3f} mm, sd {:.3f} mm, 95 % {:.3f} mm, largest {:.1f} mm",
                            ranges.median_mm, ranges.mean_mm, ranges.sd_mm, ranges.p95_mm, ranges.max_mm));
  console.print(fmt::format("  whole-cycle slips {:.2e}, off by more than 20 mm {:.2e}", ranges.slips, ranges.wrong));
  console.print(fmt::format("  squared errors over the variances told {:.2f}, beyond three deviations {:.2e}",
                            ranges.nis, ranges.beyond_3_sd));
  if (std::abs(ranges.speed_error) > 1e-6) {
    console.print(fmt::format("  speed of sound as entered {:+.2f} % off: ranges are too, which the errors leave out",
                              100.0 * ranges.speed_error));
  }
  console.print(fmt::format("  occluded pairs missed {:.2f} %, clear pairs flagged {:.2f} %",
                            100.0 * ranges.missed_occlusions, 100.0 * ranges.false_occlusions));
  console.print(fmt::format(
      "words: {} frames, {} lost ({:.1e}), {} bits corrected, {} readings wrong, lock within {:.0f} ms", words.frames,
      words.lost, static_cast<double>(words.lost) / std::max<double>(1.0, static_cast<double>(words.frames)),
      words.bit_errors, words.wrong, 1e3 * words.latest_lock_s));
  console.print("  board               frames   lost   bits   lock");
  for (std::size_t b = 0; b < words.boards.size(); ++b) {
    const decode::InertialCounters& board = words.boards[b];
    console.print(fmt::format("  {:<18} {:>7} {:>6} {:>6} {:>6}", take.info.rig.gyroscopes[b].name, board.frames,
                              board.lost, board.bit_errors,
                              board.lock_s >= 0.0 ? fmt::format("{:.0f} ms", 1e3 * board.lock_s) : "never"));
  }
  console.print(fmt::format("decoded {:.1f} s in {:.2f} s, {:.1f} times real time", seconds, report.seconds,
                            seconds / report.seconds));
}

// Recordings of radio ranging against their optical truth.
void evaluate_radio_ranges(const std::string& folder, const std::string* json_file, Console& console) {
  const auto recordings = console.check(evaluate::load_radio_recordings(folder));
  nlohmann::json json = nlohmann::json::object();
  for (const evaluate::RadioRecording& recording : recordings) {
    const evaluate::RadioStatistics s =
        evaluate::evaluate_radio(recording, evaluate::radio_parameters(recording), 0, recording.rows.size());
    json["radio_ranges"][recording.name] = evaluate::radio_to_json(s);
    if (json_file != nullptr) {
      continue;
    }
    console.print(
        fmt::format("{}: {} ranges, {} accepted ({:.2f} %)", recording.name, s.count, s.accepted,
                    100.0 * static_cast<double>(s.accepted) / std::max<double>(1.0, static_cast<double>(s.count))));
    console.print(fmt::format("  as measured  error median {:.0f} mm, sd {:.0f} mm, 95 % {:.0f} mm, largest {:.0f} mm",
                              s.raw_median_mm, s.raw_sd_mm, s.raw_p95_mm, s.raw_max_mm));
    console.print(fmt::format("  accepted     error median {:.0f} mm, sd {:.0f} mm, 95 % {:.0f} mm, largest {:.0f} mm",
                              s.median_mm, s.sd_mm, s.p95_mm, s.max_mm));
    console.print(
        fmt::format("  error over its standard deviation {:.2f} RMS; of {} outliers of more than 0.5 m {} accepted",
                    s.normalised_rms, s.outliers, s.outliers_accepted));
    console.print(fmt::format("  tags placed within {:.0f} mm (median, horizontally)", s.place_median_mm));
  }
  if (json_file != nullptr) {
    console.print_json(json, *json_file);
  }
}

}  // namespace

void add_evaluate(CLI::App& app, Console& console) {
  struct Options {
    std::string take, solve = "default", truth, json, method = "carrier", ranges;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("evaluate", "Compare a solve with the truth");
  CLI::Option* take_option = command->add_option("TAKE", options->take, "Folder of the take");
  command->add_option("--ranges", options->ranges, "Instead of a take: folder of radio ranges with optical truth")
      ->excludes(take_option);
  command->add_option("--solve", options->solve, "Name of the solve")->capture_default_str();
  command->add_option("--truth", options->truth, "Truth as CSV; otherwise the take's truth.json");
  command->add_option("--ranging", options->method, "How ranges of a driver box are decoded: paper, envelope, carrier")
      ->check(CLI::IsMember({"paper", "envelope", "carrier"}))
      ->capture_default_str();
  add_json_option(*command, options->json, "Write the figures as JSON");
  command->footer("Example: limbwave evaluate reach.take --json errors.json");
  command->callback([options, command, take_option, &console] {
    if (!options->ranges.empty()) {
      evaluate_radio_ranges(options->ranges, command->count("--json") > 0 ? &options->json : nullptr, console);
      return;
    }
    if (take_option->count() == 0) {
      throw CLI::RequiredError("TAKE");
    }
    const take::Take take = console.check(take::open_take(options->take));
    if (take.info.kind == "driver-box" && options->truth.empty()) {
      evaluate_driver_box(take, options->method, options->solve, command->count("--solve") > 0,
                          command->count("--json") > 0 ? &options->json : nullptr, console);
      return;
    }
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
    if (evaluation.still_fraction > 0.0) {
      row(fmt::format("held still {:.0f} %", 100.0 * evaluation.still_fraction), evaluation.still);
    }
  });
}

}  // namespace limbwave::cli
