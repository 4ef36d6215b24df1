/// Simulated takes for tests: made in a folder of their own that goes away again, with the truth at hand.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/so3.h"
#include "simulate/simulate.h"
#include "support/temporary_folder.h"
#include "take/take.h"

namespace limbwave::testing_support {

using test::TemporaryFolder;

/// A test cannot go on without its material.
template <typename T>
T require(Result<T> result) {
  if (!result) {
    throw std::runtime_error(result.error().text());
  }
  return std::move(result).value();
}
inline void require(const Status& status) {
  if (!status) {
    throw std::runtime_error(status.error().text());
  }
}

/// What the sensors of a simulated take really felt, from truth.json.
class SensorTruth {
 public:
  explicit SensorTruth(const std::filesystem::path& take) {
    std::ifstream file(take / "truth.json");
    const nlohmann::json json = nlohmann::json::parse(file);
    rate_hz_ = json.at("rate_hz").get<double>();
    for (const nlohmann::json& sensor : json.at("sensors")) {
      std::vector<Eigen::Vector3d>& forces = forces_.emplace_back();
      for (const nlohmann::json& f : sensor.at("f_S_m_s2")) {
        forces.emplace_back(f.at(0).get<double>(), f.at(1).get<double>(), f.at(2).get<double>());
      }
    }
    cycle_starts_ = json.at("cycles").at("start_s").get<std::vector<double>>();
    for (const nlohmann::json& segment : json.at("segments")) {
      std::vector<Eigen::Quaterniond>& rotations = rotations_.emplace_back();
      for (const nlohmann::json& q : segment.at("q_WL")) {
        // Where the truth is not known (an occluded marker) nothing compares equal.
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        q.is_null() ? rotations.emplace_back(kUnknown, kUnknown, kUnknown, kUnknown)
                    : rotations.emplace_back(q.at(0).get<double>(), q.at(1).get<double>(), q.at(2).get<double>(),
                                             q.at(3).get<double>());
      }
    }
  }

  [[nodiscard]] std::size_t sensors() const { return forces_.size(); }
  /// Cycles of the multiplexer that begin from `begin_s` (inclusive) to `end_s` (exclusive), seconds of the take.
  [[nodiscard]] std::size_t cycles(double begin_s, double end_s) const {
    const auto first = std::lower_bound(cycle_starts_.begin(), cycle_starts_.end(), begin_s);
    return static_cast<std::size_t>(std::lower_bound(first, cycle_starts_.end(), end_s) - first);
  }
  [[nodiscard]] double duration() const { return static_cast<double>(forces_.front().size() - 1) / rate_hz_; }

  /// Specific force, m/s², sensor frame, without the sensor's own errors: by six-point Lagrange interpolation.
  [[nodiscard]] Eigen::Vector3d force(std::size_t sensor, double time_s) const {
    const std::vector<Eigen::Vector3d>& f = forces_.at(sensor);
    const double position = time_s * rate_hz_;
    const auto last = static_cast<std::ptrdiff_t>(f.size()) - 6;
    const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(std::floor(position)) - 2, 0,
                                                            std::max<std::ptrdiff_t>(last, 0));
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (std::ptrdiff_t i = 0; i < 6; ++i) {
      double weight = 1.0;
      for (std::ptrdiff_t j = 0; j < 6; ++j) {
        if (j != i) {
          weight *= (position - static_cast<double>(first + j)) / static_cast<double>(i - j);
        }
      }
      value += weight * f[static_cast<std::size_t>(first + i)];
    }
    return value;
  }

  /// True when no segment turns by more than 0.001° within `reach_s` before and after a time: a pose is being held.
  [[nodiscard]] bool holding(double time_s, double reach_s = 0.25) const {
    const auto sample = static_cast<std::ptrdiff_t>(time_s * rate_hz_);
    const auto reach = static_cast<std::ptrdiff_t>(reach_s * rate_hz_);
    for (const std::vector<Eigen::Quaterniond>& q : rotations_) {
      if (sample < reach || sample + reach >= static_cast<std::ptrdiff_t>(q.size())) {
        return false;
      }
      for (const std::ptrdiff_t other : {sample - reach, sample - reach / 2, sample + reach / 2, sample + reach}) {
        const double turn =
            geometry::geodesic_angle(q[static_cast<std::size_t>(sample)], q[static_cast<std::size_t>(other)]);
        if (!(turn <= 2e-5)) {
          return false;
        }
      }
    }
    return true;
  }

 private:
  double rate_hz_ = 0.0;
  std::vector<std::vector<Eigen::Vector3d>> forces_;
  std::vector<std::vector<Eigen::Quaterniond>> rotations_;
  std::vector<double> cycle_starts_;
};

/// Simulates and opens.
inline take::Take simulated(const std::filesystem::path& folder, const simulate::SimulateSettings& settings) {
  require(simulate::simulate_take(folder, settings, {}));
  return require(take::open_take(folder));
}

}  // namespace limbwave::testing_support
