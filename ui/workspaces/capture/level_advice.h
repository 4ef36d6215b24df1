/// What is wrong with the line, in words, and what to do. A pure function of what the decoder says.
#pragma once

#include <QString>
#include <vector>

#include "common/widgets.h"
#include "solve/live_session.h"

namespace limbwave::ui {

struct Advice {
  Tone tone = Tone::kUnknown;
  QString title;   ///< "Too low"
  QString remedy;  ///< "Turn the recording volume up until ..."
};

/// The worst first; never empty: when all is well, it says so. `snapshot` may be null.
std::vector<Advice> level_advice(const solve::LiveSnapshot* snapshot);

/// Stretch of time for which a finding of the decoder counts as present, seconds.
inline constexpr double kAdviceMemory_s = 3.0;

}  // namespace limbwave::ui
