/// Inertial words of a driver box (signals.md §2): from the samples of one wire to readings of its board. A streaming
/// stage: results do not depend on how the samples are cut into blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/time.h"
#include "decode/inertial_reading.h"

namespace limbwave::decode {

/// The board, as the rig file describes it (body::DriverBoxSignal).
struct WordFormat {
  double word_rate_hz = 140.0;
  double clock_tolerance = 200e-6;
  double gyroscope_range_rad_s = 5.235987756;
  double accelerometer_range_m_s2 = 3.0 * 9.80665;
  double carrier_hz = 40000.0;  ///< Of the pulses, which the low pass keeps away.
};

/// How well the board's clock is followed, for health displays.
struct WordStatus {
  bool locked = false;
  double clock_offset = 0.0;  ///< Relative to the nominal bit rate.
  double timing_error = 0.0;  ///< RMS of the newest frames, bits.
  double amplitude = 0.0;     ///< Of a bit, fraction of full scale.
  InertialCounters counters;
};

class InertialWordDecoder {
 public:
  /// `board` is what readings will carry.
  InertialWordDecoder(const WordFormat& format, SampleRate rate, int board);
  ~InertialWordDecoder();
  InertialWordDecoder(InertialWordDecoder&&) noexcept;
  InertialWordDecoder& operator=(InertialWordDecoder&&) noexcept;

  /// The next samples of the wire, `stride` apart.
  void push(const float* samples, std::size_t count, std::size_t stride);
  /// Samples are missing here: frames within are counted as lost, and the clock goes on.
  void gap(SampleCount count);

  /// Readings since the last call, in order of time; lost frames are among them, not valid.
  std::vector<InertialReading> take_readings();
  [[nodiscard]] const WordStatus& status() const;
  /// All readings of before this have been given, or never will be; seconds.
  [[nodiscard]] double passed_s() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::decode
