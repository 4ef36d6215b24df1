/// The line-in multiplex (signals.md §1): from stereo samples to one value per accelerometer axis and cycle.
/// A streaming stage: results do not depend on how the samples are cut into blocks.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "base/time.h"

namespace limbwave::decode {

inline constexpr int kMaxSlots = 32;
inline constexpr int kMaxSensors = (kMaxSlots - 1) / 3;

/// The board, as the rig file describes it (body::LineInSignal); volts at the multiplexer.
struct LineInFormat {
  double cycle_rate_hz = 60.0;
  double cycle_rate_tolerance = 0.10;
  int slots = 16;
  double supply_volts = 3.3;
  double reference_volts = 0.33;
  double zero_g_volts = 1.65;
  double volts_per_g = 0.33;
  [[nodiscard]] int sensors() const { return (slots - 1) / 3; }
};

enum class Polarity { kAuto, kNormal, kInverted };

/// What a user may decide instead of the decoder.
struct LineInParameters {
  Polarity left = Polarity::kAuto;
  Polarity right = Polarity::kAuto;
  std::optional<bool> swapped;  ///< Left and right exchanged; empty: find out.
  /// Corner frequency of the sound card's high pass, Hz: empty = estimated from the signal; 0 = no correction.
  std::optional<double> coupling_hz;
  double settle_fraction = 0.15;  ///< Start of a slot that is never used.
};

/// One cycle of the multiplexer, decoded.
struct LineInCycle {
  std::int64_t number = 0;                 ///< Counts cycles of the clock, also lost ones where it is known how many.
  double start_sample = 0.0;               ///< Where slot 0 begins, in samples of the take.
  double period_samples = 0.0;             ///< Length of this cycle.
  std::array<double, kMaxSlots> sample{};  ///< Effective instant of every slot's value, in samples of the take.
  /// Voltage of every slot relative to the reference slot, volts at the board (ratiometric: scaled by the swing of the
  /// counter bit, so that the card's gain cancels), coupling corrected, polarity corrected.
  std::array<double, kMaxSlots> volts{};
  std::uint32_t clipped = 0;    ///< Bit per slot: touched full scale.
  std::uint32_t uncertain = 0;  ///< Bit per slot: holds a click, or lies between broken slots (clipped, clicks).
  bool valid = false;           ///< False where sync was lost: values are not to be used.
  bool gap_before = false;      ///< Samples or cycles are missing between the previous cycle and this one.
};

/// The state of the line, for health displays. All levels as fractions of full scale.
struct LineInStatus {
  bool decided = false;  ///< Enough heard to judge the line.
  bool locked = false;
  bool swapped = false, left_inverted = false, right_inverted = false;
  double cycle_rate_hz = 0.0;
  double left_peak = 0.0, right_peak = 0.0;                ///< Of the last second.
  double right_swing = 0.0;                                ///< Peak-to-peak of the counter bit.
  double left_coupling_hz = 0.0, right_coupling_hz = 0.0;  ///< Estimated corner frequencies.
  double coupling_sd_hz = 0.0;                             ///< Standard deviation of the left one.
  double noise = 0.0;                                      ///< RMS within settled slots after correction.
  double clock_jitter = 0.0;                               ///< RMS cycle-to-cycle change of period, relative.
  std::int64_t cycles = 0, lost_cycles = 0, clipped_slots = 0;
};

class LineInDecoder {
 public:
  LineInDecoder(const LineInFormat& format, SampleRate rate, const LineInParameters& parameters = {});
  ~LineInDecoder();
  LineInDecoder(LineInDecoder&&) noexcept;
  LineInDecoder& operator=(LineInDecoder&&) noexcept;

  /// Appends interleaved stereo samples. Non-finite samples count as loss of signal there.
  void push(std::span<const float> interleaved);
  /// No more samples: decodes what is still waiting, and sums findings up.
  void finish();

  /// Starts telling anew, as for a recording that begins in mid-stream: what is still so (exchanged channels, a line
  /// that cannot be used) is told again, and counts start from nothing. Decoding does not notice.
  void restart_findings();
  /// Tells what was only counted since then.
  void sum_up_findings();

  /// Cycles decoded since the last call, in order of time.
  std::vector<LineInCycle> take_cycles();
  /// Findings since the last call (clipping, inversion, loss of sync ...), each with what to do.
  Diagnostics take_diagnostics();
  [[nodiscard]] const LineInStatus& status() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::decode
