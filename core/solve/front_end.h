/// From raw samples to one instant per cycle: the streaming stages that live and offline share. Results do not depend
/// on how the samples are cut into blocks.
#pragma once

#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "body/rig.h"
#include "decode/line_in.h"
#include "decode/slot_alignment.h"

namespace limbwave::solve {

/// The decoder's view of the board that the rig file describes.
decode::LineInFormat line_in_format(const body::LineInSignal& signal);

/// Fails when a slot of this board lasts too few samples at `rate` for a settled value to be read from it.
Status check_rate(const body::LineInSignal& signal, SampleRate rate);

/// True where an axis reads the end of the sensor's range, by the data sheet: the true force may be anything beyond.
bool saturated(const body::LineInSignal& signal, const Eigen::Vector3d& volts);

class FrontEnd {
 public:
  FrontEnd(const body::Rig& rig, SampleRate rate, const decode::LineInParameters& parameters);

  /// Interleaved stereo, full scale ±1.
  void push(std::span<const float> interleaved);
  void finish();

  /// What has been decoded since the last call.
  std::vector<decode::AccelerationFrame> take_frames();
  /// A first version of what `take_frames` will give next (decode::SlotAligner::ahead).
  [[nodiscard]] std::vector<decode::AccelerationFrame> frames_ahead() const { return aligner_.ahead(); }
  /// Cycles since the last call, for displays; collected only after `keep_cycles(true)`.
  std::vector<decode::LineInCycle> take_cycles();
  void keep_cycles(bool keep) { keep_cycles_ = keep; }
  Diagnostics take_diagnostics() { return decoder_.take_diagnostics(); }
  /// As in the decoder: for recordings that begin and end in mid-stream.
  void restart_findings() { decoder_.restart_findings(); }
  void sum_up_findings() { decoder_.sum_up_findings(); }
  [[nodiscard]] const decode::LineInStatus& status() const { return decoder_.status(); }

 private:
  void align();

  decode::LineInDecoder decoder_;
  decode::SlotAligner aligner_;
  bool keep_cycles_ = false;
  std::vector<decode::LineInCycle> cycles_;
};

}  // namespace limbwave::solve
