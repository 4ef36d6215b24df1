/// What a pulse on one wire says: how far its source is, how sure that is, and why it was not believed.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "base/time.h"

namespace limbwave::decode {

/// The three factors of the confidence (Vlasic et al. 2007, §4.1), each 0..1, kept apart for display.
struct RangeFactors {
  double strength = 0.0;    ///< w_s: well above the noise, and as strong as a source in sight at that range is.
  double continuity = 0.0;  ///< w_t: agrees with what the same pair, and the same microphone, showed before.
  double angle = 0.0;       ///< w_a: in front of the source; 1 where no pose is known.
  [[nodiscard]] double product() const { return strength * continuity * angle; }
};

/// What became of a pulse.
enum class RangeVerdict : std::uint8_t {
  kAccepted,
  kNothingHeard,  ///< No arrival stands out of the noise.
  kTooWeak,       ///< Heard, but far weaker than a source in sight would be: bent round a limb, or reflected.
  kAmbiguous,     ///< The number of whole carrier cycles is not certain; `range` is the envelope's.
  kInconsistent,  ///< Contradicts what the pair showed before by more than a body can move.
  kInterrupted,   ///< Samples are missing within the slot.
  kDisturbed,     ///< Other noise covers the slot: keys, brakes.
};
std::string_view name(RangeVerdict verdict);  ///< "accepted", "nothing-heard", "too-weak", ...

/// One pulse at one microphone. There is one for every pulse and wire, in order of emission, accepted or not.
struct RangeReading {
  int source = 0;             ///< Index into the rig's sources.
  int receiver = 0;           ///< Index into the rig's microphones: the wire.
  SampleIndex emission;       ///< The sample at whose instant the source began to radiate.
  Seconds emission_time;      ///< The same in seconds since the start of the take.
  double flight_s = 0.0;      ///< Time of flight, seconds: arrival at the microphone is emission_time + flight_s.
  double range = 0.0;         ///< Metres, from the source at emission to the microphone at arrival. NaN: no arrival.
  double variance = 0.0;      ///< Of `range`, m²; of what the verdict says it is. Infinite where there is no arrival.
  double envelope_range = 0;  ///< By the envelope alone, metres; never off by whole cycles. NaN: no arrival.
  double envelope_variance = 0.0;
  double phase_range = 0.0;  ///< By the carrier, metres modulo a wavelength, 0 <= phase_range < wavelength.
  /// By the carrier with the likeliest number of whole cycles, believed or not, metres. NaN: none was counted.
  double carrier_range = std::numeric_limits<double>::quiet_NaN();
  double failure = 1.0;            ///< Probability, as computed, that another number is right; 1: none was counted.
  double expected = 0.0;           ///< What all earlier ranges to this microphone let expect, metres; NaN: nothing yet.
  double expected_variance = 0.0;  ///< Of that, m².
  double snr_db = 0.0;             ///< In-band peak of the arrival over the noise, power.
  RangeFactors factors;
  RangeVerdict verdict = RangeVerdict::kNothingHeard;
  [[nodiscard]] double confidence() const { return factors.product(); }
};

/// What a pose filter expects, to resolve whole cycles with.
struct RangePrediction {
  double range = 0.0;     ///< Metres.
  double variance = 0.0;  ///< m².
  /// Of the microphone off the source's normal, radians, good to a few degrees; NaN: not known.
  double angle = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace limbwave::decode
