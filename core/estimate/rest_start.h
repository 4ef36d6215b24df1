/// The start from the rest pose (Vlasic et al. 2007, §5.4): whoever holds it reads gravity alone, and no rotation. So
/// pose and sensor orientations are refined until the mean specific forces agree with gravity, and the gyroscopes'
/// offsets are what makes their readings integrate to zero.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "estimate/body_filter.h"

namespace limbwave::estimate {

/// What a start may count on.
enum class StartMode {
  kAny,    ///< Rest where there was rest; otherwise a start in mid-motion, with a warning that names who moved.
  kRest,   ///< Fails when the wearer was not still.
  kMoving  ///< In mid-motion: the pose is hardly known.
};

struct RestParameters {
  StartMode mode = StartMode::kAny;
  double window_s = 1.0;                  ///< Of rest that is looked at, from the first reading on.
  double most_spread = 0.06;              ///< Standard deviation of a still gyroscope, rad/s, all axes together.
  double most_rate = 0.05;                ///< Of a still gyroscope's mean, rad/s: more is a turn and no bias.
  double most_tremble = 0.5;              ///< Standard deviation of a still accelerometer, m/s², all axes together.
  double least_force = 4.0;               ///< m/s²: what is at rest and reads less is no accelerometer at work.
  double turned = 1.05;                   ///< rad: gravity further from where it should be is no matter of placement.
  double gravity_noise = 0.1;             ///< Of a mean specific force, m/s²: scale and cross-axis errors of 1 %.
  double rate = 0.1, acceleration = 1.0;  ///< Left when still, rad/s, rad/s².
  double moving_pose = 0.35, moving_rate = 2.0, moving_acceleration = 15.0;  ///< The same in mid-motion.
  double found_pose = 0.2, found_rate = 1.0, found_acceleration = 10.0;  ///< And about a start found from what follows.
};

/// One board's first second.
struct BoardAtRest {
  Vector3d force = Vector3d::Zero(), rate = Vector3d::Zero();  ///< Means, m/s², rad/s.
  double tremble = 0.0, spread = 0.0;                          ///< Standard deviations, all axes together.
  int forces = 0, rates = 0;
  bool moved = false;   ///< Not still.
  bool silent = false;  ///< Nothing, or nothing that a working chip can give.
  double off = 0.0;     ///< Angle from where gravity should be, rad.
  bool turned = false;  ///< `off` is more than placement can be.
};

/// What a start found.
struct RestStart {
  Diagnostics diagnostics;
  std::vector<BoardAtRest> boards;
  bool moving = false;   ///< The wearer was not still.
  bool strange = false;  ///< Nor did he hold the rest pose: many boards feel gravity elsewhere.
};

std::vector<BoardAtRest> look_at_rest(const BodyModel& model, const BodyReadings& readings, const RestParameters& rest);

/// Starts the filter. `root`: where it is given. Fails in mode kRest when a board moved; the error names it. The
/// filter's parameters are the priors; the state starts where prior and gravity agree best, with the prior's
/// covariance, so that the filter may take the same readings in without counting them twice where it matters: they
/// change nothing there. Boards that are turned do not take part.
Result<RestStart> start_at_rest(BodyFilter& filter, const BodyReadings& readings, const RestParameters& rest,
                                const RootReading* root);

/// Refines joint angles, mountings and accelerometer offsets of a state at rest until `boards` agree with gravity:
/// Gauss-Newton on the posterior. `prior` are standard deviations by error state. Returns the largest change, rad.
double refine_at_rest(const BodyFilter& filter, const std::vector<BoardAtRest>& boards, const Eigen::VectorXd& prior,
                      double gravity_noise, BodyState& state);

/// By how much the bones that hang on each link's parent are longer than in the skeleton: place_scale of
/// TreeKinematics::update for a state.
std::vector<double> bone_scales(const body::Tree& tree, const BodyState& state);

/// "\"a\", \"b\" and \"c\"", at most `most` of them.
std::string listed(const std::vector<std::string>& names, std::size_t most = 4);

}  // namespace limbwave::estimate
