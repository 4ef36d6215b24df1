/// Inclinations of limbs that hang on one another, from all their accelerometers together and over the whole take:
/// Smoothing::kChain.
///
/// A limb that swings about its joint accelerates its own sensor; read by itself, that sensor shows a wrong vertical.
/// But how limbs move and how their sensors accelerate are one and the same thing where lengths and places are known.
/// This smoother looks for the most likely movement of the whole chain (maximum a posteriori, Gauss-Newton on the
/// residuals of chain_model.h), beginning with the adaptive estimate. Headings are found as far as joints and
/// accelerations tell them, and not given out: they are the user's.
#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "estimate/chain_model.h"
#include "estimate/inclination.h"
#include "estimate/limb_chain.h"

namespace limbwave::estimate {

/// What is assumed of limbs, sensors and rigs. Angular accelerations and velocities go with how fast the readings
/// change: a limb at rest is not taken to spin unseen about the vertical.
struct ChainParameters {
  ChainPriors priors;
  double sensor_sd = 0.06;          ///< Of a calibrated reading at rest, m/s² per axis.
  double lever_sd = 0.015;          ///< By how much lengths and places of sensors are off, metres per axis.
  double least_turning_sd = 0.3;    ///< Angular acceleration of a limb at rest, rad/s².
  double turning_per_change = 4.0;  ///< Angular acceleration by change of a reading's direction (rad/s), 1/s.
  double least_rate_sd = 0.1;       ///< Angular velocity of a limb at rest, rad/s.
  double rate_per_change = 1.5;     ///< Angular velocity by change of a reading's direction (rad/s).
  double least_root_sd = 0.05;      ///< Acceleration of the root of a body at rest, m/s².
  double root_per_change = 0.1;     ///< Acceleration of the root by change of its sensor's reading (m/s³), seconds.
  /// Residuals by what they explain at which the chain is believed as much as the single sensors. A rig that is right
  /// to a centimetre leaves below 0.1, sensors that do not belong together more than 0.25.
  double half_belief = 0.16;
  /// The same for ½ χ² per link and instant: a rig that is right stays below 0.2, one with lengths a third wrong below
  /// 0.5, strangers are above 0.6.
  double half_belief_cost = 0.65;
};

/// One series per sensor of the rig, as `samples` and `start`, all with the same times; sensors that are not in the
/// chain keep their `start`, which is the adaptive estimate. Where the readings contradict the chain (other lengths,
/// a loose sensor) the result goes back to `start`. Series with gaps are estimated in pieces, long ones in windows
/// that overlap; memory beyond the result is bounded. Fails only when `progress` says stop.
Result<std::vector<std::vector<Inclination>>> smooth_chain(const LimbChain& chain,
                                                           std::span<const std::vector<ForceSample>> samples,
                                                           std::span<const std::vector<Inclination>> start,
                                                           const ChainParameters& parameters, const Progress& progress);

}  // namespace limbwave::estimate
