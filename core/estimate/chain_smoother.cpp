#include "estimate/chain_smoother.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "estimate/chain_window.h"
#include "estimate/deviation.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

// Frames further apart than this have a gap between them, seconds; pieces shorter than the least are left alone.
constexpr double kGap = 0.12;
constexpr double kLeastPiece = 0.5;
// Windows: what is estimated at once, and by how much neighbours overlap and are blended, seconds.
constexpr double kWindow = 12.0;
constexpr double kOverlap = 3.0;
// Over how long readings must agree with the chain, seconds to either side; deviations that tell nothing, m/s².
constexpr double kBeliefReach = 2.0;
constexpr double kQuiet = 0.15;
constexpr double kSharp = 6.0;  // how sharply belief goes down
// Rest: for how long to either side, and what turning (rad/s) and deviation from gravity (m/s²) are half of movement;
// how far noise may seem larger than it is.
constexpr double kRestReach = 0.15;
constexpr double kSlow = 0.08;
constexpr double kWeak = 0.3;
constexpr double kNoisy = 1.3;
// What calibration leaves of a direction, radians.
constexpr double kLeastSd = 0.005;

struct Window {
  std::size_t begin, end;    // instants
  double fade_in, fade_out;  // times over which its weight goes up from `begin` and down to `end`; 0: at once
};

std::vector<Window> windows_of(const std::vector<double>& times) {
  std::vector<Window> windows;
  for (std::size_t begin = 0; begin < times.size();) {
    std::size_t end = begin + 1;
    while (end < times.size() && times[end] - times[end - 1] <= kGap) {
      ++end;
    }
    if (times[end - 1] - times[begin] >= kLeastPiece && end - begin > 2 * ChainModel::kReach) {
      double from = times[begin];
      std::size_t first = begin;
      for (bool more = true; more;) {
        // What is left is taken along when it would not fill a window of its own.
        more = times[end - 1] - from > 1.5 * kWindow;
        const std::size_t last =
            more
                ? static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), from + kWindow) - times.begin())
                : end;
        windows.push_back({first, last, first == begin ? 0.0 : kOverlap, more ? kOverlap : 0.0});
        from = from + kWindow - kOverlap;
        first = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), from) - times.begin());
      }
    }
    begin = end;
  }
  return windows;
}

// How far the chain is believed at every instant of a link, 0..1: what it leaves of the readings, by the deviations
// from gravity that there were to explain, the link's own and those of all together; and how likely the movements are
// that it takes to explain them.
std::vector<std::vector<double>> beliefs(const std::vector<double>& times,
                                         const std::vector<std::vector<ForceSample>>& samples,
                                         const ChainEstimate& estimate, const ChainParameters& parameters) {
  const std::size_t links = samples.size();
  std::vector<std::vector<double>> left;
  std::vector<std::vector<double>> deviation;
  for (std::size_t i = 0; i < links; ++i) {
    left.push_back(rms_around(times, estimate.residual[i], kBeliefReach));
    std::vector<double> deviations;
    for (const ForceSample& sample : samples[i]) {
      deviations.push_back(sample.usable ? sample.f_L.norm() - kStandardGravity : std::nan(""));
    }
    deviation.push_back(rms_around(times, deviations, kBeliefReach));
  }
  std::vector<double> roots_of_cost;
  for (const double cost : estimate.cost) {
    roots_of_cost.push_back(std::sqrt(cost / static_cast<double>(links)));
  }
  const std::vector<double> root_of_cost = rms_around(times, roots_of_cost, kBeliefReach);
  const auto belief = [](double value, double half) { return 1.0 / (1.0 + std::pow(value / half, kSharp)); };
  std::vector<std::vector<double>> result(links, std::vector<double>(times.size(), 1.0));
  for (std::size_t k = 0; k < times.size(); ++k) {
    double all_left = 0.0;
    double all_deviation = 0.0;
    for (std::size_t i = 0; i < links; ++i) {
      all_left += left[i][k] * left[i][k];
      all_deviation += std::pow(deviation[i][k] + kQuiet, 2);
    }
    for (std::size_t i = 0; i < links; ++i) {
      const double ratio = std::max(left[i][k] / (deviation[i][k] + kQuiet), std::sqrt(all_left / all_deviation));
      result[i][k] = belief(ratio, parameters.half_belief) *
                     belief(root_of_cost[k] * root_of_cost[k], parameters.half_belief_cost);
    }
  }
  return result;
}

// How far a limb moves at all, 0..1. Where its readings stand still and are as strong as gravity it rests, and they
// say how it is inclined by themselves.
std::vector<double> movement(const std::vector<double>& times, const std::vector<ForceSample>& samples) {
  const std::vector<double> changes = rms_around(times, reading_changes(times, samples), kRestReach);
  const std::vector<double> noise = noise_around(samples, InclinationParameters{}.sensor_noise);
  std::vector<double> result;
  for (std::size_t k = 0; k < times.size(); ++k) {
    // Noise of a slope through five readings, all axes together.
    const double step = k == 0 ? times[1] - times[0] : times[k] - times[k - 1];
    const double of_noise = kNoisy * noise[k] * std::sqrt(3.0 / 10.0) / step;
    const double turning = std::sqrt(std::max(0.0, changes[k] * changes[k] - of_noise * of_noise)) / kStandardGravity;
    const double deviation = std::max(0.0, deviation_around(samples, k, kRestReach, kRestReach) - kNoisy * noise[k]);
    const double strength = std::pow(std::max(turning / kSlow, deviation / kWeak), kSharp);
    result.push_back(strength / (1.0 + strength));
  }
  return result;
}

// `weight` of another estimate into one.
void blend(Inclination& inclination, const Vector3d& up_L, double sd_rad, double weight) {
  const Vector3d mean = (1.0 - weight) * inclination.up_L + weight * up_L;
  if (!inclination.known || !(mean.norm() > 1e-6)) {
    return;
  }
  const Vector3d direction = mean.normalized();
  const auto spread = [&](const Vector3d& one, double sd) {
    return sd * sd + 0.5 * std::pow(geometry::angle_between(one, direction), 2);
  };
  inclination.sd_rad =
      std::sqrt((1.0 - weight) * spread(inclination.up_L, inclination.sd_rad) + weight * spread(up_L, sd_rad));
  inclination.up_L = direction;
}

template <typename T>
std::vector<std::vector<T>> cut(const LimbChain& chain, std::span<const std::vector<T>> by_sensor, const Window& w) {
  std::vector<std::vector<T>> by_link;
  for (const int sensor : chain.sensors) {
    const std::vector<T>& all = by_sensor[static_cast<std::size_t>(sensor)];
    by_link.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(w.begin),
                         all.begin() + static_cast<std::ptrdiff_t>(w.end));
  }
  return by_link;
}

}  // namespace

Result<std::vector<std::vector<Inclination>>> smooth_chain(const LimbChain& chain,
                                                           std::span<const std::vector<ForceSample>> samples,
                                                           std::span<const std::vector<Inclination>> start,
                                                           const ChainParameters& parameters,
                                                           const Progress& progress) {
  if (!progress.report(0.0, "estimating")) {
    return cancelled();
  }
  std::vector<std::vector<Inclination>> result(start.begin(), start.end());
  if (chain.links.empty()) {
    return result;
  }
  std::vector<double> all_times;
  for (const ForceSample& sample : samples[static_cast<std::size_t>(chain.sensors.front())]) {
    all_times.push_back(sample.time_s);
  }
  const std::vector<Window> windows = windows_of(all_times);
  for (std::size_t n = 0; n < windows.size(); ++n) {
    const Window& window = windows[n];
    const auto count = static_cast<double>(windows.size());
    const std::vector<double> times(all_times.begin() + static_cast<std::ptrdiff_t>(window.begin),
                                    all_times.begin() + static_cast<std::ptrdiff_t>(window.end));
    const std::vector<std::vector<ForceSample>> readings = cut(chain, samples, window);
    const auto estimate =
        estimate_window(chain, times, readings, cut(chain, start, window), parameters,
                        progress.part(static_cast<double>(n) / count, static_cast<double>(n + 1) / count));
    if (!estimate) {
      return cancelled();
    }
    const std::vector<std::vector<double>> belief = beliefs(times, readings, *estimate, parameters);
    for (std::size_t i = 0; i < chain.links.size(); ++i) {
      const auto sensor = static_cast<std::size_t>(chain.sensors[i]);
      const std::vector<double> moving = movement(times, readings[i]);
      for (std::size_t k = 0; k < times.size(); ++k) {
        Inclination own = start[sensor][window.begin + k];
        blend(own, estimate->up_L[i][k], std::hypot(estimate->sd_rad[i][k], kLeastSd), moving[k] * belief[i][k]);
        // From the window before, which ends within this one's beginning, to this one.
        Inclination& there = result[sensor][window.begin + k];
        const double since = times[k] - times.front();
        if (window.fade_in > 0.0 && since < window.fade_in) {
          blend(there, own.up_L, own.sd_rad, since / window.fade_in);
        } else {
          there = own;
        }
      }
    }
  }
  return result;
}

}  // namespace limbwave::estimate
