/// How old what is on screen is, taken apart by where the time went.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace limbwave::solve {

/// Instants on the way of one pose, steady_clock seconds, in this order; 0: not (yet) known.
struct PoseTimes {
  double oldest_slot = 0.0;  ///< The earliest slot of the newest cycle in the pose was captured.
  double instant = 0.0;      ///< What the pose shows: the middle of that cycle.
  double cycle_end = 0.0;    ///< The cycle's last slot was captured.
  double arrived = 0.0;      ///< The block with the end of the cycle was there for the decoder.
  double solved = 0.0;       ///< The pose was ready.
  double taken = 0.0;        ///< The viewer took it.
  double drawn = 0.0;        ///< The frame that shows it was handed to the screen.
};

/// Where the time goes.
enum class LatencyStage {
  kCycle,     ///< oldest_slot → cycle_end: the board reads its slots one after another.
  kArrival,   ///< cycle_end → arrived: the device's blocks, the edge that ends the cycle, waking up.
  kSolve,     ///< arrived → solved: decoding, smoothing, kinematics.
  kHandover,  ///< solved → taken: until the interface is free.
  kDraw,      ///< taken → drawn.
  kTotal,     ///< oldest_slot → drawn.
};
inline constexpr std::size_t kLatencyStages = 6;
/// A stable word: "cycle", "arrival", "solve", "handover", "draw", "total".
std::string_view name(LatencyStage stage);

struct LatencyFigures {
  double mean_s = 0.0, p95_s = 0.0, max_s = 0.0;
};

struct LatencyReport {
  std::size_t poses = 0;  ///< Counted; 0: nothing is known.
  std::array<LatencyFigures, kLatencyStages> stages{};
  double over_budget = 0.0;  ///< Share of poses whose total is above kLatencyBudget_s.
  [[nodiscard]] const LatencyFigures& of(LatencyStage stage) const { return stages[static_cast<std::size_t>(stage)]; }
};

/// What a performer who sees the figure does not yet feel as lag.
inline constexpr double kLatencyBudget_s = 0.080;

/// Keeps the poses of the last `window_s` seconds.
class LatencyMeter {
 public:
  explicit LatencyMeter(double window_s = 10.0) : window_s_(window_s) {}
  /// Ignored when an instant is missing or out of order. Without `drawn` and `taken` the last two stages are 0 and the
  /// total ends with `solved`.
  void add(const PoseTimes& times);
  void clear() { poses_.clear(); }
  [[nodiscard]] LatencyReport report() const;

 private:
  double window_s_;
  std::vector<PoseTimes> poses_;
};

}  // namespace limbwave::solve
