#include "estimate/chain_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "estimate/joint_plausibility.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

// Over how long the strength of a movement is taken, seconds to either side.
constexpr double kChangeReach = 0.25;
constexpr double kStrengthReach = 0.1;
// How fast first headings go to where the joints want them, seconds.
constexpr double kHeadingMemory = 0.3;
// The equations are solved again and again while what is tolerated beyond the assumed errors goes down: the first
// orientations may be far off, and Student's t must not take that for knocks.
constexpr int kRounds = 6;
constexpr double kFirstTolerance = 2.0;  // times the residuals that are there
constexpr double kNextTolerance = 0.5;   // times the one before; none in the last two rounds
constexpr int kSteps = 5;                // Gauss-Newton steps a round
constexpr double kDone = 1e-2;           // relative gain of a step below which a round ends
constexpr double kLastDone = 1e-3;
constexpr double kFirstDamping = 1e-7;
constexpr double kLeastDamping = 1e-10;

// What does not change from round to round.
ChainWeights first_weights(const LimbChain& chain, const std::vector<double>& times,
                           const std::vector<std::vector<ForceSample>>& samples, const ChainParameters& parameters) {
  ChainWeights weights;
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    std::vector<double>& turning = weights.turning_sd.emplace_back();
    std::vector<double>& rate = weights.rate_sd.emplace_back();
    std::vector<double> root;
    for (const double change : rms_around(times, reading_changes(times, samples[i]), kChangeReach)) {
      const double turn = change / kStandardGravity;
      turning.push_back(std::hypot(parameters.least_turning_sd, parameters.turning_per_change * turn));
      rate.push_back(std::hypot(parameters.least_rate_sd, parameters.rate_per_change * turn));
      root.push_back(std::hypot(parameters.least_root_sd, parameters.root_per_change * change));
    }
    if (chain.links[i].parent < 0) {
      weights.root_sd.push_back(std::move(root));
    }
  }
  return weights;
}

// What the chain leaves of every reading of a link, RMS per axis.
std::vector<double> residuals(const ChainModel& model, const ChainState& state, std::size_t link) {
  std::vector<double> result(model.instants(), std::numeric_limits<double>::quiet_NaN());
  Vector3d residual;
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (model.force_residual(state, link, k, residual)) {
      result[k] = residual.norm() / std::sqrt(3.0);
    }
  }
  return result;
}

// The errors of readings: the sensor's, what levers that are a little wrong do at this strength of movement, and
// `tolerance` times what is left now.
void set_force_sd(const ChainModel& model, const ChainState& state, const ChainParameters& parameters, double tolerance,
                  ChainWeights& weights) {
  const std::vector<ChainLink>& links = model.chain().links;
  const std::vector<double>& times = model.times();
  std::vector<std::vector<double>> strength(links.size(), std::vector<double>(times.size(), 0.0));
  weights.force_sd.assign(links.size(), std::vector<double>(times.size(), 0.0));
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (std::size_t k = 1; k + 1 < times.size(); ++k) {
      const Vector3d rate = 0.5 * (model.rate(state, i, k) + model.rate(state, i, k - 1));
      strength[i][k] = std::hypot(model.turning(state, i, k).norm(), rate.squaredNorm());
    }
    strength[i] = rms_around(times, strength[i], kStrengthReach);
    const std::vector<double> left = rms_around(times, residuals(model, state, i), kStrengthReach);
    for (std::size_t k = 0; k < times.size(); ++k) {
      double square = std::pow(parameters.sensor_sd, 2) + std::pow(tolerance * left[k], 2);
      for (int j = static_cast<int>(i); j >= 0; j = links[static_cast<std::size_t>(j)].parent) {
        square += std::pow(parameters.lever_sd * strength[static_cast<std::size_t>(j)][k], 2);
      }
      weights.force_sd[i][k] = std::sqrt(square);
    }
  }
}

// Levenberg-Marquardt with fixed weights; `system` ends up with the equations at `state`. False: stopped.
bool descend(const ChainModel& model, const ChainWeights& weights, double done, const Progress& progress,
             ChainState& state, BlockBand& system, BlockBand& damped) {
  double damping = kFirstDamping;
  double cost = model.linearise(state, weights, system);
  for (int step = 0; step < kSteps; ++step) {
    if (!progress.report(static_cast<double>(step) / kSteps, "estimating")) {
      return false;
    }
    damped = system;
    for (std::size_t k = 0; k < model.instants(); ++k) {
      damped.at(k, k).diagonal() *= 1.0 + damping;
    }
    double now = std::numeric_limits<double>::infinity();
    ChainState candidate;
    if (damped.factor()) {
      candidate = model.moved(state, damped.solve());
      now = model.cost(candidate, weights);
    }
    if (!(now < cost)) {
      damping *= 10.0;
      continue;
    }
    const bool enough = cost - now < done * cost;
    state = std::move(candidate);
    damping = std::max(kLeastDamping, 0.1 * damping);
    cost = model.linearise(state, weights, system);
    if (enough) {
      break;
    }
  }
  return true;
}

}  // namespace

ChainState chain_state_from(const LimbChain& chain, const std::vector<double>& times,
                            const std::vector<std::vector<Inclination>>& start, const ChainPriors& priors) {
  ChainState state;
  const std::size_t count = times.size();
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const ChainLink& link = chain.links[i];
    std::vector<Quaterniond>& R = state.R_WL.emplace_back(count);
    const auto about_z = [](double angle) { return Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ())); };
    // Slope and curvature of the joint's cost by heading.
    const auto judge = [&](std::size_t k, const Quaterniond& R_WL, double& slope, double& curvature) {
      double cost = 0.0;
      slope = curvature = 0.0;
      const Quaterniond R_WP = state.R_WL[static_cast<std::size_t>(link.parent)][k] * link.R_PL_rest;
      for (const JointResidual& r :
           joint_residuals(link.joint, R_WP.conjugate() * R_WL, priors.joint_sd, priors.joint_middle)) {
        const double g = (R_WP * r.gradient).z();
        cost += r.value * r.value;
        slope += r.value * g;
        curvature += g * g;
      }
      return cost;
    };
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3d up = start[i][k].up_L;
      if (k > 0) {
        const Quaterniond carried = geometry::shortest_arc(R[k - 1] * up, Vector3d::UnitZ()) * R[k - 1];
        R[k] = carried.normalized();
        if (link.parent >= 0) {
          double slope = 0.0;
          double curvature = 0.0;
          judge(k, R[k], slope, curvature);
          const double share = std::min(1.0, (times[k] - times[k - 1]) / kHeadingMemory);
          R[k] = about_z(-share * std::clamp(slope / (curvature + 0.1), -1.0, 1.0)) * R[k];
        }
        continue;
      }
      R[k] = geometry::shortest_arc(up, Vector3d::UnitZ());
      if (link.parent >= 0) {
        double best = std::numeric_limits<double>::infinity();
        const Quaterniond simplest = R[k];
        for (int degree = 0; degree < 360; degree += 10) {
          double slope = 0.0;
          double curvature = 0.0;
          const Quaterniond candidate = about_z(radians(degree)) * simplest;
          const double cost = judge(k, candidate, slope, curvature);
          if (cost < best) {
            best = cost;
            R[k] = candidate;
          }
        }
      }
    }
  }
  state.q_W.assign(static_cast<std::size_t>(chain.roots()), std::vector<Vector3d>(count, Vector3d::Zero()));
  return state;
}

std::vector<double> reading_changes(const std::vector<double>& times, const std::vector<ForceSample>& samples) {
  std::vector<double> result(samples.size(), 0.0);
  constexpr std::size_t kHalf = 2;
  for (std::size_t i = kHalf; i + kHalf < samples.size(); ++i) {
    Vector3d slope = Vector3d::Zero();
    double square = 0.0;
    for (std::size_t k = i - kHalf; k <= i + kHalf; ++k) {
      const double t = times[k] - times[i];
      slope += t * samples[k].f_L;
      square += t * t;
    }
    slope /= square;
    result[i] = std::isfinite(slope.norm()) ? slope.norm() : 0.0;
  }
  return result;
}

std::vector<double> rms_around(const std::vector<double>& times, const std::vector<double>& values, double reach_s) {
  std::vector<double> sums(values.size() + 1, 0.0);
  std::vector<std::size_t> counts(values.size() + 1, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool counted = std::isfinite(values[i]);
    sums[i + 1] = sums[i] + (counted ? values[i] * values[i] : 0.0);
    counts[i + 1] = counts[i] + (counted ? 1 : 0);
  }
  std::vector<double> result(values.size(), 0.0);
  std::size_t begin = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    while (times[i] - times[begin] > reach_s) {
      ++begin;
    }
    while (end < times.size() && times[end] - times[i] <= reach_s) {
      ++end;
    }
    if (counts[end] > counts[begin]) {
      result[i] = std::sqrt(std::max(0.0, sums[end] - sums[begin]) / static_cast<double>(counts[end] - counts[begin]));
    }
  }
  return result;
}

std::optional<ChainEstimate> estimate_window(const LimbChain& chain, const std::vector<double>& times,
                                             const std::vector<std::vector<ForceSample>>& samples,
                                             const std::vector<std::vector<Inclination>>& start,
                                             const ChainParameters& parameters, const Progress& progress) {
  const ChainModel model(chain, times, samples, parameters.priors);
  ChainState state = chain_state_from(chain, times, start, parameters.priors);
  ChainWeights weights = first_weights(chain, times, samples, parameters);
  BlockBand system(times.size(), model.block_size(), ChainModel::kReach);
  BlockBand damped = system;
  for (int round = 0; round < kRounds; ++round) {
    const bool last = round + 2 >= kRounds;
    set_force_sd(model, state, parameters, last ? 0.0 : kFirstTolerance * std::pow(kNextTolerance, round), weights);
    const double share = 0.9 / kRounds;
    if (!descend(model, weights, last ? kLastDone : kDone, progress.part(share * round, share * (round + 1)), state,
                 system, damped)) {
      return {};
    }
  }
  ChainEstimate estimate;
  estimate.cost = model.costs(state, weights);
  const bool solved = system.factor();
  const std::vector<Eigen::MatrixXd> covariances = solved ? system.covariances() : std::vector<Eigen::MatrixXd>();
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    std::vector<Vector3d>& up_L = estimate.up_L.emplace_back();
    std::vector<double>& sd_rad = estimate.sd_rad.emplace_back();
    estimate.residual.push_back(residuals(model, state, i));
    const auto column = 3 * static_cast<Eigen::Index>(i);
    for (std::size_t k = 0; k < times.size(); ++k) {
      up_L.push_back((state.R_WL[i][k].conjugate() * Vector3d::UnitZ()).normalized());
      // A turn about x or y of W turns the vertical as much.
      sd_rad.push_back(
          solved ? std::sqrt(0.5 * (covariances[k](column, column) + covariances[k](column + 1, column + 1))) : kPi);
    }
  }
  return estimate;
}

}  // namespace limbwave::estimate
