/// From specific force in the limb frame to how the limb is inclined (line-in paper §5).
///
/// What gravity shows is the direction up_L that is up, seen from the limb; the rotation about the vertical is the
/// user's. Everything here works per sensor.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "base/progress.h"

namespace limbwave::estimate {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// How inclinations are smoothed.
enum class Smoothing {
  kNone,      ///< Every reading by itself (the paper's equation 2).
  kAdaptive,  ///< Low pass that is the slower the less a reading is to be trusted; without lag offline. Default.
  kBridging,  ///< Also bridges bursts of limb acceleration, by a model of turning and of acceleration.
};

/// One calibrated reading: f_L = R_LS · SensorCalibration::apply(volts).
struct ForceSample {
  double time_s = 0.0;
  Vector3d f_L = Vector3d::Zero();  ///< Specific force, m/s², limb frame; at rest it points up.
  bool usable = false;              ///< False: clipped, out of sync, missing.
};

/// The inclination at one instant.
struct Inclination {
  double time_s = 0.0;
  Vector3d up_L = Vector3d::UnitZ();  ///< The vertical, seen from the limb; unit length.
  double trust = 0.0;                 ///< 0..1, how far gravity alone explains the reading; 0 when unusable.
  double sd_rad = 0.0;                ///< Standard deviation of the direction, per axis across it, radians.
  bool known = false;                 ///< False before the first usable reading: up_L is then meaningless.
};

/// Smoothing is never shorter than this, seconds: without any, use Smoothing::kNone.
inline constexpr double kLeastSmoothing_s = 0.001;

/// Constants of the estimators, from the physics of limbs and sensors.
struct InclinationParameters {
  /// Time scale of smoothing, seconds, at least kLeastSmoothing_s; longer is smoother, but less is bridged right at
  /// fast turns.
  double smoothing_s = 0.08;
  /// | |f| − g | that gravity alone explains, m/s² (0.01 g: calibration errors, slow turning about a joint).
  double free_deviation = 0.098;
  /// | |f| − g | beyond `free_deviation` at which trust is one half, m/s² (0.1 g, about 6° of direction).
  double half_trust_deviation = 0.98;
  /// How long before and after a deviation its neighbourhood is suspect, seconds: an acceleration that is across
  /// gravity for a moment does not show in |f|, the burst around it does. Limbs do not keep an acceleration up for
  /// more than half a second.
  double burst_s = 0.15;
  /// Standard deviation of sensor noise assumed until it has been observed, m/s² per axis.
  double sensor_noise = 0.02;
};

/// Trust in one reading by itself, 0..1, from | |f| − g |.
double trust_of(const Vector3d& f, const InclinationParameters& parameters = {});

/// R_WL = Rz(heading) · shortest_arc(up_L → z): the simplest rotation that fits gravity, then the user's rotation
/// about the vertical, radians. Where the limb is upside down (up_L = −z) every horizontal axis is equally short and
/// the simplest rotation is not continuous: a limb that passes beside that direction at a small distance spins about
/// the vertical meanwhile, as at any singularity of a chart of the sphere; one that passes straight through does not
/// turn. Exactly there the axis of `previous_R_WL` is kept, so that no frame flips to an arbitrary one.
Quaterniond orientation(const Vector3d& up_L, double heading = 0.0,
                        const Quaterniond& previous_R_WL = Quaterniond::Identity());

/// `orientation` for a series, each one the predecessor of the next; `headings` has one entry per inclination or none.
std::vector<Quaterniond> orientations(std::span<const Inclination> inclinations, std::span<const double> headings = {});

/// Inclination of every sample of a whole series, any method; forward and backward in time, so without lag.
/// Times must increase; samples that do not are copies of their predecessor's result. `progress` is asked every minute
/// of samples or so; the result is empty when it says to stop.
std::vector<Inclination> estimate_inclinations(std::span<const ForceSample> samples, Smoothing smoothing,
                                               const InclinationParameters& parameters = {},
                                               const Progress& progress = {});

}  // namespace limbwave::estimate
