/// What the wires of a running driver box carry: levels, locks and rates, for faces that show them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "acquire/box_source.h"
#include "body/rig.h"
#include "decode/driver_box_decoder.h"
#include "estimate/sensor_watch.h"

namespace limbwave::solve {

/// One wire.
struct BoxWire {
  std::string board;                                         ///< Name of what hangs on it, as the rig has it.
  double level = 0.0;                                        ///< Greatest sample of the last moments, 1: full scale.
  bool clipped = false;                                      ///< Some of them are at full scale.
  bool plugged = true;                                       ///< The box says that the wire is there.
  bool locked = false;                                       ///< The board's words are understood.
  std::int64_t frames = 0;                                   ///< Words since it was locked, lost ones too.
  std::int64_t lost_frames = 0;                              ///< Of these.
  std::int64_t bit_errors = 0;                               ///< Corrected.
  double words_hz = 0.0;                                     ///< Understood in the last half second, a second.
  double ranges_hz = 0.0;                                    ///< Accepted there.
  estimate::BoardState state = estimate::BoardState::kWell;  ///< What the filter makes of it.
};

/// Counts over stretches of the stream. One thread.
class BoxWires {
 public:
  BoxWires(const body::Rig& rig, SampleRate rate);

  /// What has been pulled, as full scale ±1, interleaved.
  void push(std::span<const float> samples);
  void gap(std::int64_t frames) { advance(frames); }
  void note(std::span<const acquire::BoxEvent> events);
  void note(std::span<const decode::RangeReading> ranges, std::span<const decode::InertialReading> words);
  /// As it stands; the states of boards are the caller's to add.
  [[nodiscard]] std::vector<BoxWire> state(const decode::DriverBoxDecoder& decoder) const;

 private:
  struct Count {
    float peak = 0.0F, shown_peak = 0.0F;
    int words = 0, ranges = 0;
    double words_hz = 0.0, ranges_hz = 0.0;
    bool plugged = true;
  };
  void advance(std::int64_t frames);
  std::vector<std::string> names_;
  std::vector<Count> wires_;
  double rate_hz_;
  std::int64_t level_frames_ = 0, count_frames_ = 0;  // since the last closing of a stretch
};

}  // namespace limbwave::solve
