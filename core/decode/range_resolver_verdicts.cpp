// Verdicts of a resolver: which arrival counts, how strong it must be, the paper's chain, past and future together.
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "decode/range_resolver.h"

namespace limbwave::decode {
namespace {

constexpr double kUnsure = 0.3;         // who is less sure than this of a number has no say
constexpr double kStrong = 0.6;         // of the amplitude expected: fully believed from here
constexpr double kContradiction = 0.2;  // a guess that is surer than this can contradict another
// Standard deviations, by the tracker and by the skeleton, at which nothing says that it is in front of the source.
// Who has followed an echo knows less of directions than it seems to him.
constexpr double kBehind = 3.0, kWornBehind = 2.0;
constexpr double kSure = 0.030;  // metres: who expects a range this well chooses among arrivals

}  // namespace

// The first arrival; what comes before the one that is expected is an echo of another pulse, or noise.
const Arrival& RangeResolver::straight(const HeardSlot& heard,
                                       const std::optional<RangeTracker::Expectation>& expected) const {
  if (expected && expected->variance < kSure * kSure) {
    for (std::size_t i = 0; i < heard.count; ++i) {
      const Arrival& arrival = heard.arrivals[i];
      const double c = format_.speed_of_sound;
      const double off = c * arrival.delay_s - expected->range;
      if (off * off < kSurprise * kSurprise * (expected->variance + c * c * arrival.delay_variance + 9e-6)) {
        return arrival;
      }
    }
  }
  return heard.arrivals.front();
}

// Strength and angle, as the paper has them, from what is known about the geometry.
void RangeResolver::weigh(const RangingSource& source, double range, double amplitude, double noise,
                          const Direction& towards, const std::optional<Direction>& worn, RangeReading& reading) const {
  // Sound that leaves a source backward comes by way of a wall or the floor. Of the angles that are possible the
  // foremost.
  const auto foremost_of = [&](const Direction& direction, double deviations) {
    return std::max(source.foremost, direction.sd < kNowhere ? direction.angle - deviations * direction.sd : 0.0);
  };
  const auto radiated = [&](double angle) {
    const std::vector<double>& table = format_.radiation;
    if (table.size() < 2) {
      return 1.0;
    }
    const double place = std::clamp(angle / kPi, 0.0, 1.0) * static_cast<double>(table.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), table.size() - 2);
    const double x = place - static_cast<double>(below);
    return table[below] + x * (table[below + 1] - table[below]);
  };
  const double near = std::max(range, 0.05);
  const double on_axis = source.level * format_.level_m / near * std::pow(10.0, -format_.absorption_db_m * near / 20.0);
  double pattern = 0.25;  // where no direction is known: far off the axis, but in sight
  if (towards.sd < radians(6.0)) {
    // Of the angles that are possible the one that explains the least strength.
    pattern = radiated(std::min(kPi, towards.angle + towards.sd));
  }
  const double foremost = std::max(foremost_of(towards, kBehind), worn ? foremost_of(*worn, kWornBehind) : 0.0);
  reading.factors.angle = std::clamp((radians(95.0) - foremost) / radians(10.0), 0.0, 1.0);
  const double relative = amplitude / (kStrong * on_axis * pattern);
  reading.factors.strength = relative >= 1.0 ? 1.0 : relative * relative * relative * relative;
  reading.snr_db = 10.0 * std::log10(std::max(1e-9, 0.25 * amplitude * amplitude / std::max(noise * 0.5, 1e-30)));
}

void RangeResolver::by_paper(const HeardSlot& heard, const TrackerStep& step, RangeTracker& tracker,
                             RangeReading& reading) const {
  if (!heard.steepest) {
    return;
  }
  const RangingSource& source = format_.sources[static_cast<std::size_t>(heard.source)];
  const double c = format_.speed_of_sound;
  reading.range = reading.envelope_range = c * (heard.steepest->delay_s - source.delay_s);
  reading.flight_s = reading.range / c;
  const auto expected = tracker.expect(reading.source, step.source);
  const Direction towards =
      expected ? Direction{expected->angle, std::min(kNowhere, expected->angle_sd)} : Direction{0.0, kNowhere};
  weigh(source, reading.range, heard.steepest->peak, heard.noise, towards, std::nullopt, reading);
  // σ of 2.5 mm at 25 dB, and in inverse proportion to the amplitude.
  const double sd = 2.5e-3 * std::pow(10.0, (25.0 - std::min(45.0, reading.snr_db)) / 20.0);
  reading.variance = reading.envelope_variance = sd * sd + kSystematic * kSystematic;
  reading.factors.continuity = 1.0;
  if (expected) {
    const double z =
        std::abs(reading.range - expected->range) / std::sqrt(expected->variance + reading.variance + 1e-6);
    reading.factors.continuity = z <= kSurprise ? 1.0 : std::pow(kSurprise / z, 4);
  }
  if (reading.factors.strength < parameters_.least_confidence) {
    reading.verdict = RangeVerdict::kTooWeak;
  } else if (reading.range > source.reach || reading.range < 0.0 ||
             reading.confidence() < parameters_.least_confidence) {
    reading.verdict = RangeVerdict::kInconsistent;
    tracker.contradict();
  } else {
    reading.verdict = RangeVerdict::kAccepted;
    tracker.update(reading.source, step.source, reading.range, reading.variance);
    tracker.collect(reading.source, step.source, reading.range, reading.variance);
  }
}

// Past and future that both tell the same number, and are not sure of it alone.
std::optional<RangeReading> RangeResolver::by_both(const Kept& kept, const RangeReading& backward,
                                                   const Guess& guess) const {
  const RangeReading& forward = kept.reading;
  const Guess& before = kept.guess;
  const double failure = before.failure * guess.failure;
  const double finest = parameters_.finest * parameters_.finest;
  const double off = guess.range - forward.envelope_range;
  if (forward.verdict != RangeVerdict::kAmbiguous || backward.verdict != RangeVerdict::kAmbiguous ||
      std::abs(before.range - guess.range) > 0.25 * wavelength_ || failure > parameters_.joint_failure ||
      std::max(before.failure, guess.failure) > kUnsure || std::max(before.variance, guess.variance) > finest ||
      off * off > kFarthest * kFarthest * parameters_.caution * forward.envelope_variance) {
    return std::nullopt;
  }
  const bool later = guess.variance < before.variance;
  RangeReading both = later ? backward : forward;
  both.range = both.carrier_range = later ? guess.range : before.range;
  both.variance = later ? guess.variance : before.variance;
  both.flight_s = both.range / format_.speed_of_sound;
  both.failure = failure;
  both.verdict = RangeVerdict::kAccepted;
  return both;
}

RangeReading RangeResolver::better(const Kept& kept, const RangeReading& backward, const Guess& guess) const {
  const RangeReading& forward = kept.reading;
  const bool f = forward.verdict == RangeVerdict::kAccepted;
  const bool b = backward.verdict == RangeVerdict::kAccepted;
  const bool both_guess = (f || kept.guess.failure < kContradiction) && (b || guess.failure < kContradiction);
  if ((f || b) && both_guess && std::abs(kept.guess.range - guess.range) > 0.5 * wavelength_) {
    // Past and future disagree.
    RangeReading neither = forward;
    neither.range = forward.envelope_range;
    neither.variance = forward.envelope_variance;
    neither.verdict = RangeVerdict::kAmbiguous;
    return neither;
  }
  if (const auto both = by_both(kept, backward, guess)) {
    return *both;
  }
  const bool later = backward.expected_variance < forward.expected_variance;
  const RangeReading& best = later ? backward : forward;
  const RangeReading& other = later ? forward : backward;
  return best.verdict == RangeVerdict::kAmbiguous && (f || b) ? other : best;
}

}  // namespace limbwave::decode
