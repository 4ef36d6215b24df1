#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "commands.h"
#include "solve/solve.h"
#include "solve/take_calibration.h"
#include "take/take.h"

namespace limbwave::cli {
namespace {

// A snapshot of nothing but the data sheet's values is none.
bool is_calibrated(const take::TakeInfo& info) {
  return info.calibration && solve::is_measured(*info.calibration);
}

nlohmann::json groups_to_json(const body::Rig& rig) {
  nlohmann::json groups = nlohmann::json::array();
  for (const body::CalibrationGroup& group : rig.groups) {
    nlohmann::json sensors = nlohmann::json::array();
    for (const int sensor : group.sensors) {
      sensors.push_back(rig.accelerometers.at(static_cast<std::size_t>(sensor)).name);
    }
    groups.push_back({{"name", group.name}, {"sensors", sensors}});
  }
  return groups;
}

// What calibrations ask for: the groups of the rig, their sensors, and how each was calibrated.
void print_rig(const take::TakeInfo& info, Console& console) {
  for (const body::CalibrationGroup& group : info.rig.groups) {
    console.print(fmt::format("group   {:<28} {}, {}", group.name, group.first.name, group.second.name));
    for (const int sensor : group.sensors) {
      const auto s = static_cast<std::size_t>(sensor);
      std::string text = "not calibrated";
      if (is_calibrated(info)) {
        text = fmt::format("range {}, mounting {}", info.calibration->sensors.at(s).method,
                           info.calibration->mounts.at(s).method);
      }
      console.print(fmt::format("sensor  {:<28} {}", info.rig.accelerometers.at(s).name, text));
    }
  }
}

// Movements that a calibration can be made from, as segments of the take tell of them.
struct Movement {
  std::string procedure;  // "range" or "limb", as `limbwave calibrate` has them
  std::string group;      // of a limb
  std::vector<std::pair<std::string, const take::TakeSegment*>> parts;  // with the pose's name; null: not in the take

  [[nodiscard]] bool complete() const {
    return std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.second != nullptr; });
  }
};

std::vector<Movement> movements_of(const take::TakeInfo& info) {
  const auto find = [&info](const std::string& name) -> const take::TakeSegment* {
    const auto found = std::find_if(info.segments.begin(), info.segments.end(),
                                    [&](const take::TakeSegment& one) { return one.name == name; });
    return found == info.segments.end() || found->count.value <= 0 ? nullptr : &*found;
  };
  std::vector<Movement> movements;
  if (const take::TakeSegment* range = find(solve::kRangeSegment)) {
    movements.push_back({"range", "", {{"turning", range}}});
  }
  for (const body::CalibrationGroup& group : info.rig.groups) {
    Movement limb{"limb",
                  group.name,
                  {{group.first.name, find(solve::pose_segment(group, 0))},
                   {group.second.name, find(solve::pose_segment(group, 1))}}};
    if (limb.parts[0].second != nullptr || limb.parts[1].second != nullptr) {
      movements.push_back(std::move(limb));
    }
  }
  return movements;
}

nlohmann::json movements_to_json(const take::TakeInfo& info) {
  nlohmann::json movements = nlohmann::json::array();
  for (const Movement& movement : movements_of(info)) {
    nlohmann::json parts = nlohmann::json::array();
    for (const auto& [name, segment] : movement.parts) {
      if (segment != nullptr) {
        parts.push_back({{"name", name},
                         {"start_s", info.format.rate.seconds(segment->first).value},
                         {"seconds", info.format.rate.seconds(segment->count).value}});
      }
    }
    nlohmann::json one{{"procedure", movement.procedure}, {"complete", movement.complete()}, {"parts", parts}};
    if (!movement.group.empty()) {
      one["group"] = movement.group;
    }
    movements.push_back(std::move(one));
  }
  return movements;
}

void print_movements(const take::TakeInfo& info, Console& console) {
  const std::vector<Movement> movements = movements_of(info);
  for (const Movement& movement : movements) {
    std::vector<std::string> parts;
    for (const auto& [name, segment] : movement.parts) {
      if (segment == nullptr) {
        parts.push_back(name + " is missing");
      } else {
        const double begin = info.format.rate.seconds(segment->first).value;
        parts.push_back(
            fmt::format("{} {:.2f} to {:.2f} s", name, begin, begin + info.format.rate.seconds(segment->count).value));
      }
    }
    console.print(fmt::format("calibration movement {:<15} {}", movement.group.empty() ? "range" : movement.group,
                              fmt::join(parts, ", ")));
  }
  if (movements.empty()) {
    console.print("no calibration movements in the take");
  }
}

void print_info(const take::Take& take, bool as_json, Console& console) {
  const take::TakeInfo& info = take.info;
  const double seconds = static_cast<double>(info.frames) / info.format.rate.hz;
  if (as_json) {
    nlohmann::json segments = nlohmann::json::array();
    for (const take::TakeSegment& segment : info.segments) {
      segments.push_back({{"name", segment.name},
                          {"start_s", info.format.rate.seconds(segment.first).value},
                          {"seconds", info.format.rate.seconds(segment.count).value}});
    }
    nlohmann::json events = nlohmann::json::array();
    for (const take::TakeEvent& event : take.events) {
      events.push_back({{"time_s", info.format.rate.seconds(event.sample).value},
                        {"kind", event.kind},
                        {"text", event.text},
                        {"count", event.count}});
    }
    console.print_json({{"kind", info.kind},
                        {"created", info.created},
                        {"subject", info.subject},
                        {"source", info.source},
                        {"complete", info.complete},
                        {"frames", info.frames},
                        {"seconds", seconds},
                        {"rate_hz", info.format.rate.hz},
                        {"channels", info.format.channels},
                        {"type", acquire::name(info.format.type)},
                        {"rig", info.rig.name},
                        {"skeleton", info.skeleton.name},
                        {"calibrated", is_calibrated(info)},
                        {"groups", groups_to_json(info.rig)},
                        {"calibration_movements", movements_to_json(info)},
                        {"segments", segments},
                        {"events", events},
                        {"solves", solve::list_solves(take)},
                        {"diagnostics", diagnostics_to_json(take.diagnostics)}});
    return;
  }
  console.print(fmt::format("{}: {:.2f} s, {:g} Hz, {} channels, {}{}", take.folder.string(), seconds,
                            info.format.rate.hz, info.format.channels, acquire::name(info.format.type),
                            info.complete ? "" : ", was not closed"));
  console.print(fmt::format("recorded {} from {}; subject {}", info.created, info.source,
                            info.subject.empty() ? "not named" : info.subject));
  console.print(fmt::format("rig {}, skeleton {}, {}", info.rig.name, info.skeleton.name,
                            is_calibrated(info) ? "with its calibration" : "no calibration in the take"));
  print_rig(info, console);
  print_movements(info, console);
  for (const take::TakeSegment& segment : info.segments) {
    console.print(fmt::format("segment {:<28} {:8.2f} s  {:8.2f} s long", segment.name,
                              info.format.rate.seconds(segment.first).value,
                              info.format.rate.seconds(segment.count).value));
  }
  for (const take::TakeEvent& event : take.events) {
    console.print(fmt::format("event   {:<28} {:8.2f} s  {}", event.kind, info.format.rate.seconds(event.sample).value,
                              event.text));
  }
  for (const std::string& name : solve::list_solves(take)) {
    console.print("solve   " + name);
  }
  console.print(take.diagnostics);
}

}  // namespace

void add_info(CLI::App& app, Console& console) {
  struct Options {
    std::string take;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  const auto add = [&](const char* name, const char* help, const char* example) {
    CLI::App* command = app.add_subcommand(name, help);
    command->add_option("TAKE", options->take, "Folder of the take")->required();
    command->add_flag("--json", options->json, "As JSON");
    command->footer(example);
    return command;
  };
  add("info", "Tell what is in a take", "Example: limbwave info reach.take")->callback([options, &console] {
    print_info(console.check(take::open_take(options->take)), options->json, console);
  });
  add("verify", "Check whether a take is whole", "Example: limbwave verify reach.take")->callback([options, &console] {
    const take::VerifyReport report = console.check(take::verify_take(options->take, console.progress()));
    if (options->json) {
      console.print_json({{"whole", report.findings.empty()}, {"findings", diagnostics_to_json(report.findings)}});
    } else {
      console.print(report.findings);
    }
    if (worst(report.findings) != Severity::kInfo) {
      console.fail({fmt::format("has {} finding(s)", report.findings.size()), options->take,
                    "limbwave recover repairs what a crash left"});
    }
    if (!options->json) {
      console.print(options->take + ": whole");
    }
  });
  add("recover", "Repair a take after a crash", "Example: limbwave recover reach.take")->callback([options, &console] {
    const Diagnostics done = console.check(take::recover_take(options->take));
    if (options->json) {
      console.print_json({{"done", diagnostics_to_json(done)}});
    } else {
      console.print(options->take + (done.empty() ? ": nothing to repair" : ": repaired"));
      console.print(done);
    }
  });
}

}  // namespace limbwave::cli
