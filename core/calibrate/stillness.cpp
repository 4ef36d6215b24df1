#include "calibrate/stillness.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace limbwave::calibrate {
namespace {

// Sums over prefixes make the movement of any window a matter of a few operations. Values are taken relative to the
// first reading, so that the difference of sums keeps its digits.
class Movement {
 public:
  Movement(std::span<const SensorSeries> series, std::span<const SensorCalibration> calibrations,
           const StillnessParameters& parameters)
      : series_(series), parameters_(parameters), sums_(series.size()), squares_(series.size()) {
    assert(series.size() == calibrations.size());
    const std::size_t n = series.empty() ? 0 : series.front().size();
    run_.assign(n, 0);
    for (std::size_t s = 0; s < series.size(); ++s) {
      assert(series[s].size() == n);
      Vector3d sum = Vector3d::Zero();
      double square = 0.0;
      Vector3d origin = Vector3d::Zero();
      bool have_origin = false;
      sums_[s].push_back(sum);
      squares_[s].push_back(square);
      for (std::size_t i = 0; i < n; ++i) {
        if (series[s].usable[i] != 0 && series[s].volts[i].allFinite()) {
          const Vector3d f = calibrations[s].M * series[s].volts[i] / kStandardGravity;
          if (!have_origin) {
            origin = f;
            have_origin = true;
          }
          sum += f - origin;
          square += (f - origin).squaredNorm();
        }
        sums_[s].push_back(sum);
        squares_[s].push_back(square);
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      const bool whole = std::all_of(series.begin(), series.end(), [i](const SensorSeries& one) {
        return one.usable[i] != 0 && one.volts[i].allFinite();
      });
      const bool joined = i > 0 && series.front().times[i] - series.front().times[i - 1] <= parameters.largest_gap_s;
      run_[i] = !whole ? 0 : joined ? run_[i - 1] + 1 : 1;
    }
  }

  [[nodiscard]] std::size_t size() const { return run_.size(); }
  [[nodiscard]] double time(std::size_t i) const { return series_.front().times[i]; }
  /// Whether the readings [begin, end) have no gap.
  [[nodiscard]] bool whole(std::size_t begin, std::size_t end) const { return run_[end - 1] >= end - begin; }
  /// Readings without a gap that end with `last`.
  [[nodiscard]] std::size_t run(std::size_t last) const { return run_[last]; }

  [[nodiscard]] double of_sensor(std::size_t s, std::size_t begin, std::size_t end) const {
    const auto n = static_cast<double>(end - begin);
    const Vector3d mean = (sums_[s][end] - sums_[s][begin]) / n;
    return std::sqrt(std::max(0.0, (squares_[s][end] - squares_[s][begin]) / n - mean.squaredNorm()));
  }
  [[nodiscard]] double of_all(std::size_t begin, std::size_t end) const {
    double square = 0.0;
    for (std::size_t s = 0; s < series_.size(); ++s) {
      const double movement = std::min(parameters_.cap_g, of_sensor(s, begin, end));
      square += movement * movement;
    }
    return std::sqrt(square / static_cast<double>(series_.size()));
  }
  /// Smallest end such that [begin, end) lasts for window_s; size() + 1 when there is none.
  [[nodiscard]] std::size_t window_end(std::size_t begin, std::size_t hint) const {
    std::size_t end = std::max(hint, begin + 2);
    while (end <= size() && time(end - 1) - time(begin) < parameters_.window_s - 1e-9) {
      ++end;
    }
    return end;
  }
  [[nodiscard]] StillWindow window(std::size_t begin, std::size_t end) const {
    StillWindow window;
    window.begin = begin;
    window.end = end;
    window.begin_s = time(begin);
    window.end_s = time(end - 1);
    window.movement_g = of_all(begin, end);
    for (std::size_t s = 0; s < series_.size(); ++s) {
      window.sensor_g.push_back(of_sensor(s, begin, end));
      Vector3d mean = Vector3d::Zero();
      for (std::size_t i = begin; i < end; ++i) {
        mean += series_[s].volts[i];
      }
      window.mean_volts.emplace_back(mean / static_cast<double>(end - begin));
    }
    return window;
  }

 private:
  std::span<const SensorSeries> series_;
  const StillnessParameters& parameters_;
  std::vector<std::vector<Vector3d>> sums_;
  std::vector<std::vector<double>> squares_;
  std::vector<std::size_t> run_;
};

}  // namespace

std::optional<StillWindow> stillest_window(std::span<const SensorSeries> series,
                                           std::span<const SensorCalibration> calibrations,
                                           const StillnessParameters& parameters) {
  if (series.empty()) {
    return std::nullopt;
  }
  const Movement movement(series, calibrations, parameters);
  double best = std::numeric_limits<double>::infinity();
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t window_end = 0;
  for (std::size_t i = 0; i < movement.size(); ++i) {
    window_end = movement.window_end(i, window_end);
    if (window_end > movement.size()) {
      break;
    }
    if (movement.whole(i, window_end) && movement.of_all(i, window_end) < best) {
      best = movement.of_all(i, window_end);
      begin = i;
      end = window_end;
    }
  }
  if (end == 0) {
    return std::nullopt;
  }
  // Grow towards the calmer side; a microgravity of slack lets a perfectly still stretch grow too.
  const double limit = best * parameters.extend_factor + 1e-6;
  for (bool growing = true; growing;) {
    growing = false;
    const double left = begin > 0 && movement.whole(begin - 1, end) ? movement.of_all(begin - 1, end)
                                                                    : std::numeric_limits<double>::infinity();
    const double right = end < movement.size() && movement.whole(begin, end + 1)
                             ? movement.of_all(begin, end + 1)
                             : std::numeric_limits<double>::infinity();
    if (std::min(left, right) <= limit) {
      left < right ? --begin : ++end;
      growing = true;
    }
  }
  return movement.window(begin, end);
}

std::vector<StillWindow> still_windows(std::span<const SensorSeries> series,
                                       std::span<const SensorCalibration> calibrations, double threshold_g,
                                       const StillnessParameters& parameters) {
  std::vector<StillWindow> windows;
  if (series.empty()) {
    return windows;
  }
  const Movement movement(series, calibrations, parameters);
  std::size_t begin = 0;
  while (begin < movement.size()) {
    std::size_t end = movement.window_end(begin, 0);
    if (end > movement.size()) {
      break;
    }
    if (!movement.whole(begin, end) || movement.of_all(begin, end) > threshold_g) {
      ++begin;
      continue;
    }
    while (end < movement.size() && movement.whole(begin, end + 1) && movement.of_all(begin, end + 1) <= threshold_g) {
      ++end;
    }
    windows.push_back(movement.window(begin, end));
    begin = end;
  }
  return windows;
}

}  // namespace limbwave::calibrate
