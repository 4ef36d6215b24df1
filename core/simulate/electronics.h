/// From voltages to the samples of a sound card.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "acquire/sample_format.h"
#include "simulate/analog_line.h"
#include "simulate/errors.h"
#include "simulate/random.h"

namespace limbwave::simulate {

/// The stereo signal as a stream of raw frames. The same whatever the sizes of the blocks it is read in.
class LineInStream {
 public:
  /// `voltages` must outlive the stream. The format has two channels.
  LineInStream(const body::LineInSignal& board, const LineInErrors& errors, const acquire::StreamFormat& format,
               std::uint64_t seed, SlotVoltages& voltages);

  /// The next frames, as many whole ones as fit.
  void read(std::span<std::byte> out);

  [[nodiscard]] std::int64_t position() const { return frame_; }  ///< Frames of the take read so far.
  /// Real time at which a frame of the take was sampled, seconds: later than frame/rate once frames were lost.
  [[nodiscard]] double real_time(double frame) const;
  /// The frame (with fraction) of the take at a real time; negative while frames are lost.
  [[nodiscard]] double frame_at(double real_time_s) const;
  /// See AnalogLine.
  std::vector<double> take_cycle_starts() { return line_.take_cycle_starts(); }

 private:
  AnalogLine::Pair sampled();
  void store(double value, std::byte* out);

  acquire::StreamFormat format_;
  LineInErrors errors_;
  int oversampling_;
  std::vector<double> filter_;  // taps 0..half of the symmetric decimating low pass; empty without
  AnalogLine line_;
  std::vector<AnalogLine::Pair> history_;  // of the oversampled line, as long as the filter
  std::size_t oldest_ = 0;
  Random noise_random_, dither_random_;
  double hum_phase_ = 0.0;
  double samples_per_volt_ = 0.0;
  double noise_rms_ = 0.0;
  std::int64_t drop_every_ = 0;
  std::int64_t frame_ = 0;
};

}  // namespace limbwave::simulate
