/// A whole take, decoded: what calibration procedures and the offline solver start from.
#pragma once

#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "base/progress.h"
#include "base/result.h"
#include "decode/line_in.h"
#include "decode/slot_alignment.h"
#include "take/take.h"

namespace limbwave::solve {

struct DecodedTake {
  std::vector<decode::AccelerationFrame> frames;  ///< Of the whole take, in order of time.
  decode::LineInStatus line;
  Diagnostics diagnostics;
  double seconds = 0.0;  ///< Wall-clock time that decoding took.

  /// Frames from `begin_s` (inclusive) to `end_s` (exclusive), seconds of the take.
  [[nodiscard]] std::span<const decode::AccelerationFrame> between(double begin_s, double end_s) const;
  /// Frames of a segment.
  [[nodiscard]] std::span<const decode::AccelerationFrame> of(const take::Take& take,
                                                              const take::TakeSegment& segment) const;
};

/// Decodes all samples of a take. Fails when they cannot be read, when the take has other than two channels, or when no
/// cycle of the multiplexer was found; the error then repeats the decoder's most severe finding.
Result<DecodedTake> decode_take(const take::Take& take, const decode::LineInParameters& parameters,
                                const Progress& progress);

}  // namespace limbwave::solve
