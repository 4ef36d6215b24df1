/// What goes wrong with the box in software: faults on request, at given times, or by chance.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace limbwave::emulator {

/// A fault that happens by itself, so long after the first start.
struct TimedFault {
  double at_s = 0.0;
  std::string command;
};

/// What `Emulator::command` understands, for people.
std::string fault_help();
/// Lines "SECONDS FAULT", empty ones and comments behind # aside. Fails with file and line.
Result<std::vector<TimedFault>> load_faults(const std::string& file);

/// Which faults are due: those of a list, and those that come by chance.
class FaultPlan {
 public:
  /// `every_s`: mean time between those by chance; 0: none.
  FaultPlan(std::vector<TimedFault> timed, double every_s, int wires, std::uint64_t seed);

  /// Commands that are due at `now_s`, in order. `since_start_s`: since the first start of the box; below 0: it was not
  /// started yet. By chance only while it sends, and not while its cable is out.
  std::vector<std::string> due(double now_s, double since_start_s, bool sends, bool unplugged);
  /// For what is random about a fault itself.
  std::mt19937_64& random() { return random_; }

 private:
  std::string by_chance(double now_s);
  std::vector<TimedFault> timed_;
  std::size_t next_timed_ = 0;
  double every_s_, next_s_ = 0.0;
  int wires_;
  std::vector<std::pair<double, int>> plug_again_;
  std::mt19937_64 random_;
};

}  // namespace limbwave::emulator
