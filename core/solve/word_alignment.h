/// Inertial words of many boards at common instants.
#pragma once

#include <span>
#include <vector>

#include "estimate/body_model.h"

namespace limbwave::solve {

/// Every board speaks by a clock of its own, so that eighteen boards have 2500 instants a second between them, and a
/// filter predicts its whole covariance for each. Between two words of a board its readings run straight on, here read
/// at the instants of one grid for all boards: at 140 words a second that is off by w'' / 8 · (7 ms)², 0.03 rad/s for
/// an arm that is shaken at 5 Hz by 5 rad/s and mostly far less, and the noise of a word is divided between two
/// readings. Depends on the words alone, not on how they arrive: live and offline give the same bits.
class WordAligner {
 public:
  /// The grid is k / rate_hz. A component at the end of its range (of `model`) stays there rather than being drawn
  /// inside.
  WordAligner(const estimate::BodyModel& model, double rate_hz);

  /// The next words, in order of time for every board. Readings at the grid's instants that these and those before
  /// tell: one is known when the board's next word has come, 1 / rate_hz later at most. Across a word that was lost
  /// there are none.
  std::vector<estimate::InertialReading> push(std::span<const estimate::InertialReading> words);
  [[nodiscard]] double delay_s() const { return 1.0 / rate_hz_; }

 private:
  double rate_hz_, gyroscope_range_, accelerometer_range_;
  std::vector<estimate::InertialReading> last_;  // by board; board -1: none yet
};

}  // namespace limbwave::solve
