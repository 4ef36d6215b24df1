/// Raw readings of one cycle: windows over the slots of the data channel and over the halves of the counter.
#pragma once

#include <array>
#include <cstdint>

#include "decode/counter_edges.h"
#include "decode/line_in.h"
#include "decode/settled_window.h"

namespace limbwave::decode {

/// More scatter within a slot than this part of the counter's swing is no noise that a sound card should have.
inline constexpr double kRestless = 0.003;

/// One window's reading. Levels are fractions of full scale, as the card gave them (drooped).
struct LevelReading {
  double centre = 0.0;    ///< Instant, samples of the take.
  double mean = 0.0;      ///< Level at that instant.
  double integral = 0.0;  ///< ∫ signal from the origin to that instant, value · samples.
  double slope = 0.0;     ///< Value per sample.
  double variance = 0.0;  ///< Around a straight line.
};

/// The readings of a cycle. The origin of integrals is the previous cycle's reference reading (data) and high half
/// (counter) if there is one, else the first reading here.
struct CycleMeasurement {
  CycleBounds bounds;
  bool linked = false;  ///< The previous cycle ends where this one starts, and its readings are `previous_*`.
  LevelReading previous_reference;
  LevelReading previous_high;
  std::array<LevelReading, kMaxSlots> slots{};
  LevelReading low, high;     ///< Counter halves.
  std::uint32_t clipped = 0;  ///< Bit per slot.
  std::uint32_t broken = 0;   ///< Bit per slot: neither its level nor what it adds to integrals is to be trusted.
  bool counter_clipped = false;
  double data_noise_gain = 0.0;  ///< Variance of a slot's mean per variance of a sample.
  double period() const { return bounds.end - bounds.start; }
};

/// Measures cycle after cycle.
class CycleMeter {
 public:
  CycleMeter(const LineInFormat& format, double settle_fraction) : format_(format), settle_(settle_fraction) {}
  /// The next cycle does not follow the last one.
  void unlink() { linked_ = false; }
  /// First sample that the next cycle, if linked, still needs.
  [[nodiscard]] std::int64_t needs_from() const { return linked_ ? std::min(data_from_, counter_from_) : INT64_MAX; }
  /// The samples of the cycle must be there.
  CycleMeasurement measure(const CycleBounds& bounds, const ChannelView& data, const ChannelView& counter);

 private:
  LineInFormat format_;
  double settle_;
  WindowBank bank_;
  bool linked_ = false;
  double last_end_ = 0.0;
  LevelReading reference_, high_;                  // of the previous cycle, integrals from their own window's start
  std::int64_t data_from_ = 0, counter_from_ = 0;  // where those windows start
};

}  // namespace limbwave::decode
