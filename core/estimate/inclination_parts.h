/// What the live and the offline estimate have in common besides their filters.
#pragma once

#include <span>

#include "estimate/inclination.h"
#include "estimate/inclination_filter.h"
#include "estimate/lever_bank.h"

namespace limbwave::estimate {

/// `trust_of`, 0 for unusable samples.
double usable_trust(const ForceSample& sample, const InclinationParameters& parameters);

/// Smoothing::kNone for one sample: its own direction, or `last` again where it is unusable. `deviation` is that of
/// its surroundings, `noise` per axis, both m/s².
Inclination raw_inclination(const ForceSample& sample, const Inclination& last, double deviation, double noise,
                            const InclinationParameters& parameters);

/// A filter's state as an inclination at `sample`.
Inclination inclination_of(const InclinationFilter::State& state, const ForceSample& sample, double deviation,
                           const InclinationParameters& parameters);

/// The mean of the levers' directions, with the spread of it and of each; `each` has one entry per lever.
Inclination mixed(std::span<const Inclination> each, const Logs& weights);

}  // namespace limbwave::estimate
