#include "faults.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace limbwave::emulator {
namespace {

struct FaultKind {
  const char *name, *argument, *text;
};
constexpr FaultKind kFaults[] = {
    {"lose", "[N]", "the next N blocks (1) never reach the line"},
    {"corrupt", "[N]", "three bytes of each of the next N blocks (1) arrive changed"},
    {"duplicate", "", "the next block comes twice"},
    {"reorder", "", "the next two blocks come in the wrong order"},
    {"pull", "WIRE", "a board's wire (1, 2, ...) is pulled out: silence until it is plugged in"},
    {"plug", "WIRE", "the wire is plugged in again"},
    {"stall", "SECONDS", "nothing comes for so long; the box keeps one second and loses the rest"},
    {"unplug", "SECONDS", "the cable to the computer is out for so long; the box goes on counting"},
    {"reboot", "SECONDS", "the box is off for so long, and has then forgotten everything"},
};

}  // namespace

std::string fault_help() {
  std::string text;
  for (const FaultKind& fault : kFaults) {
    text += fmt::format("  {:<16} {}\n", fmt::format("{} {}", fault.name, fault.argument), fault.text);
  }
  return text + "  help             lists these\n";
}

Result<std::vector<TimedFault>> load_faults(const std::string& file) {
  std::ifstream in(file);
  if (!in) {
    return Error{"cannot be read", file, "check the path"};
  }
  std::vector<TimedFault> faults;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    line = line.substr(0, line.find('#'));
    std::istringstream words(line);
    TimedFault fault;
    if (line.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    if (!(words >> fault.at_s) || !std::getline(words >> std::ws, fault.command) ||
        (!faults.empty() && fault.at_s < faults.back().at_s)) {
      return Error{"is no fault", fmt::format("{}:{}", file, number), "write \"SECONDS FAULT\", in order of time"};
    }
    faults.push_back(std::move(fault));
  }
  return faults;
}

FaultPlan::FaultPlan(std::vector<TimedFault> timed, double every_s, int wires, std::uint64_t seed)
    : timed_(std::move(timed)), every_s_(every_s), wires_(wires), random_(seed) {}

std::vector<std::string> FaultPlan::due(double now_s, double since_start_s, bool sends, bool unplugged) {
  std::vector<std::string> faults;
  for (auto it = plug_again_.begin(); it != plug_again_.end();) {
    if (it->first <= now_s) {
      faults.push_back(fmt::format("plug {}", it->second));
      it = plug_again_.erase(it);
    } else {
      ++it;
    }
  }
  for (; since_start_s >= 0.0 && next_timed_ < timed_.size() && timed_[next_timed_].at_s <= since_start_s;
       ++next_timed_) {
    faults.push_back(timed_[next_timed_].command);
  }
  if (every_s_ <= 0.0 || !sends || now_s < next_s_) {
    return faults;
  }
  std::exponential_distribution<double> pause(1.0 / every_s_);
  const bool first = next_s_ == 0.0;
  next_s_ = now_s + pause(random_);
  if (!first && !unplugged) {
    faults.push_back(by_chance(now_s));
  }
  return faults;
}

std::string FaultPlan::by_chance(double now_s) {
  const auto wire = static_cast<int>(random_() % static_cast<std::uint64_t>(wires_)) + 1;
  switch (random_() % 12) {
    case 0:
    case 1:
    case 2:
      return fmt::format("lose {}", 1 + random_() % 20);
    case 3:
    case 4:
      return fmt::format("corrupt {}", 1 + random_() % 4);
    case 5:
    case 6:
      return "duplicate";
    case 7:
    case 8:
      return "reorder";
    case 9:
      plug_again_.emplace_back(now_s + 1.0, wire);
      return fmt::format("pull {}", wire);
    case 10:
      return fmt::format("stall {}", 0.2 + 0.1 * static_cast<double>(random_() % 10));
    default:
      return fmt::format("unplug {}", 0.2 + 0.1 * static_cast<double>(random_() % 20));
  }
}

}  // namespace limbwave::emulator
