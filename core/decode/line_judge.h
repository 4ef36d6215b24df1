/// What kind of line is this? The first second is judged before anything is decoded.
#pragma once

#include "base/diagnostics.h"
#include "decode/counter_edges.h"
#include "decode/coupling.h"
#include "decode/line_in.h"

namespace limbwave::decode {

struct LineJudgement {
  bool usable = false;  ///< There is a counter and there are slots.
  bool swapped = false;
  bool left_inverted = false;   ///< The channel that carries the slots.
  bool right_inverted = false;  ///< The channel that carries the counter.
  double half_samples = 0.0;    ///< Half a cycle.
  double swing = 0.0;           ///< Of the counter, fraction of full scale.
  double noise = 0.0;           ///< RMS within settled slots.
  CouplingEstimator coupling{1.0};
  Diagnostics findings;
};

/// Judges a stretch of both channels, best a second long. Times of findings are those of its start.
LineJudgement judge_line(const ChannelView& left, const ChannelView& right, const LineInFormat& format, SampleRate rate,
                         const LineInParameters& parameters, double memory_cycles);

}  // namespace limbwave::decode
