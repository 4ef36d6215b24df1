/// The way from a take of a driver box to its measurements.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "decode/driver_box_decoder.h"
#include "take/take.h"

namespace limbwave::solve {

/// What decoding needs to know, from a rig, who wears it, and the calibration of the sources. Asserts that the rig has
/// a driver box.
decode::DriverBoxFormat driver_box_format(const body::Rig& rig, const body::Skeleton& skeleton,
                                          const calibrate::RangingCalibration& calibration);

/// The calibration of a take, or the nominal one at 22 °C.
calibrate::RangingCalibration ranging_calibration(const take::TakeInfo& info);

/// Decoding that a live picture can wait for: ranges are judged by the past alone, and words are joined to their
/// neighbours alone, not across lost ones: there a pulse is judged without its board's motion. With `by_past` a take is
/// solved from the same readings.
decode::DriverBoxParameters live_decoding();

/// Behind the newest sample that was decoded by `live_decoding` no reading of before this comes any more, seconds.
/// A pulse waits for the words around it (words_joined_s), these for the end of their frame, or for two frames while a
/// board's lock is being found; a word waits for the same and for the next one of its board, with which it is aligned
/// (`alignment_s`). Beyond that the filters' own delays.
double live_settled_s(const decode::DriverBoxParameters& parameters, double word_rate_hz, double alignment_s);

/// What is decoded of a stretch of a take.
using DriverBoxSink = std::function<Status(std::span<const decode::RangeReading> ranges,
                                           std::span<const decode::InertialReading> inertial)>;

struct DriverBoxReport {
  std::vector<decode::WordStatus> words;  ///< By board.
  double seconds = 0.0;                   ///< Wall-clock time.
};

/// Decodes a whole take and hands measurements on as they come, so that memory does not grow with its length. Gaps are
/// those of the events of kind "dropped".
Result<DriverBoxReport> decode_driver_box(const take::Take& take, const decode::DriverBoxParameters& parameters,
                                          const DriverBoxSink& sink, const Progress& progress);

}  // namespace limbwave::solve
