#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "solve/decoded_take.h"
#include "solve/take_calibration.h"
#include "take/calibration_library.h"
#include "take/take.h"

namespace limbwave::cli {
namespace {

struct Options {
  std::string take, sensor, group, json;
  double from = -1.0, to = -1.0, second_from = -1.0, second_to = -1.0;
  bool no_library = false, save_poor = false;
};

std::vector<int> wanted_sensors(const body::Rig& rig, const std::string& name, Console& console) {
  std::vector<int> sensors;
  std::string names;
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    names += (names.empty() ? "" : ", ") + rig.accelerometers[s].name;
    if (name.empty() || rig.accelerometers[s].name == name) {
      sensors.push_back(static_cast<int>(s));
    }
  }
  if (sensors.empty()) {
    console.fail({"is no sensor of this take", "\"" + name + "\"", "it has " + names});
  }
  return sensors;
}

// The stretch between two times, or else the take's segment of that name.
std::span<const decode::AccelerationFrame> stretch(const take::Take& take, const solve::DecodedTake& decoded,
                                                   double from, double to, const std::string& segment,
                                                   const char* options, Console& console) {
  if (from >= 0.0 && to > from) {
    return decoded.between(from, to);
  }
  for (const take::TakeSegment& candidate : take.info.segments) {
    if (candidate.name == segment) {
      return decoded.of(take, candidate);
    }
  }
  if (take.info.segments.empty() && segment == solve::kRangeSegment) {
    return decoded.between(0.0, 1e12);  // a take of nothing but this movement
  }
  console.fail({"has no segment \"" + segment + "\"", take.folder.string(),
                std::string("say where the movement is with ") + options});
}

// The take gets what was found as its snapshot, the library gets it for later takes.
void store(take::Take& take, const calibrate::RigCalibration& calibration, const Options& options, Console& console) {
  take.info.calibration = calibration;
  console.check(take::save_info(take));
  if (!options.no_library) {
    console.check(take::CalibrationLibrary().save(take.info.rig, take.info.subject, calibration));
  }
}

// Half a stretch would silently be none.
void check_times(const std::string& take, double from, double to, const char* options, Console& console) {
  const bool given = from >= 0.0 || to >= 0.0;
  if (given && (from < 0.0 || to <= from)) {
    console.fail({"is no stretch of time: give its start and a later end", std::string(options),
                  "limbwave info " + take + " shows how long the take is"});
  }
}

calibrate::RigCalibration present_calibration(const take::Take& take) {
  return take.info.calibration ? *take.info.calibration : calibrate::nominal_calibration(take.info.rig);
}

void calibrate_range(const Options& options, bool as_json, Console& console) {
  check_times(options.take, options.from, options.to, "--from, --to", console);
  take::Take take = console.check(take::open_take(options.take));
  const std::vector<int> sensors = wanted_sensors(take.info.rig, options.sensor, console);
  const solve::DecodedTake decoded = console.check(solve::decode_take(take, {}, console.progress()));
  const auto frames =
      stretch(take, decoded, options.from, options.to, solve::kRangeSegment, "--from and --to", console);
  calibrate::RigCalibration calibration = present_calibration(take);
  nlohmann::json report = nlohmann::json::array();
  bool failed = false;
  bool changed = false;
  for (const solve::RangeOutcome& outcome : solve::calibrate_range(take, frames, sensors)) {
    const auto s = static_cast<std::size_t>(outcome.sensor);
    const std::string& name = take.info.rig.accelerometers[s].name;
    if (!outcome.result) {
      failed = true;
      report.push_back({{"sensor", name}, {"verdict", "repeat"}, {"text", outcome.result.error().text()}});
      if (!as_json) {
        console.print(fmt::format("{:<12} {}", name, outcome.result.error().text()));
      }
      continue;
    }
    const calibrate::RangeResult& range = *outcome.result;
    const bool accepted = range.verdict != calibrate::Verdict::kRepeat || options.save_poor;
    failed = failed || !accepted;
    if (accepted) {
      calibration.sensors[s] = range.calibration;
      changed = true;
    }
    report.push_back({{"sensor", name},
                      {"verdict", calibrate::name(range.verdict)},
                      {"text", range.text},
                      {"method", range.calibration.method},
                      {"residual_g", range.calibration.residual_g},
                      {"residual_extremes_g", range.extremes.residual_g},
                      {"residual_ellipsoid_g", range.ellipsoid.residual_g},
                      {"coverage", range.calibration.coverage},
                      {"diagnostics", diagnostics_to_json(range.diagnostics)}});
    if (!as_json) {
      console.print(fmt::format("{:<12} {}", name, range.text));
      console.print(range.diagnostics);
    }
  }
  if (changed) {
    store(take, calibration, options, console);
  }
  if (as_json) {
    console.print_json({{"procedure", "range"}, {"sensors", report}}, options.json);
  }
  if (failed) {
    console.fail({"not every sensor could be calibrated", options.take,
                  "repeat the movement for those sensors only, with --sensor"});
  }
}

void check_limb_options(const Options& options, Console& console) {
  check_times(options.take, options.from, options.to, "--from, --to", console);
  check_times(options.take, options.second_from, options.second_to, "--second-from, --second-to", console);
  if ((options.from >= 0.0) != (options.second_from >= 0.0)) {
    console.fail({"one pose has its time, the other has not", "--from, --second-from", "give both, or neither"});
  }
}

// The times of one group's poses are not those of another.
void check_groups(const Options& options, const body::Rig& rig, Console& console) {
  std::string names;
  for (const body::CalibrationGroup& group : rig.groups) {
    names += (names.empty() ? "\"" : ", \"") + group.name + "\"";
  }
  if (options.from >= 0.0 && options.group.empty() && options.sensor.empty() && rig.groups.size() > 1) {
    console.fail({"whose poses are these?", "--from", "say it with --group: " + names});
  }
  const bool known = options.group.empty() || std::any_of(rig.groups.begin(), rig.groups.end(), [&](const auto& group) {
                       return group.name == options.group;
                     });
  if (!known) {
    console.fail({"is no calibration group of this take", "\"" + options.group + "\"", "it has " + names});
  }
}

void calibrate_limb(const Options& options, bool as_json, Console& console) {
  check_limb_options(options, console);
  take::Take take = console.check(take::open_take(options.take));
  const body::Rig& rig = take.info.rig;
  check_groups(options, rig, console);
  (void)wanted_sensors(rig, options.sensor, console);  // before the work of decoding
  const solve::DecodedTake decoded = console.check(solve::decode_take(take, {}, console.progress()));
  calibrate::RigCalibration calibration = present_calibration(take);
  if (!solve::is_measured(calibration)) {
    const take::LibraryLookup known = take::library_calibration(rig, take.info.subject);
    calibration = known.calibration ? *known.calibration : calibration;
  }
  nlohmann::json report = nlohmann::json::array();
  bool failed = false;
  bool any = false;
  bool changed = false;
  for (std::size_t g = 0; g < rig.groups.size(); ++g) {
    const body::CalibrationGroup& group = rig.groups[g];
    if (!options.group.empty() && group.name != options.group) {
      continue;
    }
    std::vector<int> sensors;
    if (!options.sensor.empty()) {
      for (const int sensor : wanted_sensors(rig, options.sensor, console)) {
        if (std::find(group.sensors.begin(), group.sensors.end(), sensor) != group.sensors.end()) {
          sensors.push_back(sensor);
        }
      }
      if (sensors.empty()) {
        continue;
      }
    }
    any = true;
    const auto first = stretch(take, decoded, options.from, options.to, solve::pose_segment(group, 0),
                               "--from and --to for the first pose", console);
    const auto second = stretch(take, decoded, options.second_from, options.second_to, solve::pose_segment(group, 1),
                                "--second-from and --second-to", console);
    const Result<calibrate::LimbResult> limb =
        solve::calibrate_limb(take, static_cast<int>(g), first, second, calibration, sensors);
    if (!limb) {
      failed = true;
      report.push_back({{"group", group.name}, {"verdict", "repeat"}, {"text", limb.error().text()}});
      if (!as_json) {
        console.print(group.name + ": " + limb.error().text());
      }
      continue;
    }
    for (const calibrate::SensorLimbResult& sensor : limb->sensors) {
      const auto s = static_cast<std::size_t>(sensor.sensor);
      const bool accepted = sensor.verdict != calibrate::Verdict::kRepeat || options.save_poor;
      failed = failed || !accepted;
      if (accepted && sensor.mount.method != "nominal") {
        calibration.mounts[s] = sensor.mount;
        changed = true;
      }
      report.push_back({{"group", group.name},
                        {"sensor", rig.accelerometers[s].name},
                        {"verdict", calibrate::name(sensor.verdict)},
                        {"text", sensor.text},
                        {"pose_angle_deg", sensor.mount.pose_angle_deg},
                        {"movement_g", sensor.movement_g},
                        {"from_nominal_deg", sensor.from_nominal_deg}});
      if (!as_json) {
        console.print(fmt::format("{:<12} {}", rig.accelerometers[s].name, sensor.text));
      }
    }
    if (!as_json) {
      console.print(limb->diagnostics);
    }
  }
  if (!any) {
    console.fail({"is not in that calibration group", "\"" + options.sensor + "\"",
                  "limbwave info " + options.take + " lists them"});
  }
  if (changed) {
    store(take, calibration, options, console);
  }
  if (as_json) {
    console.print_json({{"procedure", "limb"}, {"sensors", report}}, options.json);
  }
  if (failed) {
    console.fail({"not every sensor could be calibrated", options.take, "hold the poses again, still and exact"});
  }
}

}  // namespace

void add_calibrate(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("calibrate", "Calibrate sensors from the movements in a take");
  command->require_subcommand(1);
  command->footer("Example: limbwave calibrate range session.take");
  const auto add = [&](const char* name, const char* help, auto run, bool limb) {
    auto options = std::make_shared<Options>();
    CLI::App* procedure = command->add_subcommand(name, help);
    procedure->add_option("TAKE", options->take, "Folder of the take")->required();
    procedure->add_option("--sensor", options->sensor, "One sensor only, by its name in the rig");
    procedure->add_option("--from", options->from, "Start of the movement, seconds; otherwise the take's segment");
    procedure->add_option("--to", options->to, "End of the movement, seconds");
    if (limb) {
      procedure->add_option("--group", options->group, "One group of the rig only");
      procedure->add_option("--second-from", options->second_from, "Start of the second pose, seconds");
      procedure->add_option("--second-to", options->second_to, "End of the second pose, seconds");
    }
    procedure->add_flag("--no-library", options->no_library, "Write into the take only");
    procedure->add_flag("--save-poor", options->save_poor, "Keep results whose verdict is \"repeat\"");
    add_json_option(*procedure, options->json, "Write the report as JSON");
    procedure->footer(std::string("Example: limbwave calibrate ") + name + " session.take");
    procedure->callback(
        [options, procedure, run, &console] { run(*options, procedure->count("--json") > 0, console); });
  };
  add("range", "Offset and scale of the sensors, from slow rotation about all axes", calibrate_range, false);
  add("limb", "How the sensors sit on the limbs, from two poses", calibrate_limb, true);
  add_calibrate_sound(*command, console);
}

}  // namespace limbwave::cli
