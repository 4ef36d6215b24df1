#include "calibrate/gain_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace limbwave::calibrate {
namespace {

double residual(const SensorCalibration& sensor, const Vector3d& volts, double gain) {
  return sensor.apply(gain * volts).norm() / kStandardGravity - 1.0;
}

// Derivative of the residual by the gain.
double J_residual_gain(const SensorCalibration& sensor, const Vector3d& volts, double gain) {
  return sensor.apply(gain * volts).normalized().dot(sensor.M * volts) / kStandardGravity;
}

double rms(std::span<const StillReading> readings, std::span<const SensorCalibration> sensors, double gain) {
  double sum = 0.0;
  for (const StillReading& reading : readings) {
    sum += std::pow(residual(sensors[static_cast<std::size_t>(reading.sensor)], reading.volts, gain), 2);
  }
  return std::sqrt(sum / static_cast<double>(readings.size()));
}

}  // namespace

Result<GainResult> estimate_gain(std::span<const StillReading> readings, std::span<const SensorCalibration> sensors) {
  if (readings.size() < 2) {
    return Error{"there are too few readings at rest to check the gain", "", "hold still for two seconds"};
  }
  GainResult result;
  result.readings = static_cast<int>(readings.size());
  result.before_g = rms(readings, sensors, 1.0);
  double information = 0.0;
  double scale = 0.0;
  for (int iteration = 0; iteration < 100; ++iteration) {
    std::vector<double> sizes;
    for (const StillReading& reading : readings) {
      sizes.push_back(
          std::abs(residual(sensors[static_cast<std::size_t>(reading.sensor)], reading.volts, result.gain)));
    }
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    scale = std::max(1.4826 * *middle, 1e-9);
    information = 0.0;
    double gradient = 0.0;
    for (const StillReading& reading : readings) {
      const SensorCalibration& sensor = sensors[static_cast<std::size_t>(reading.sensor)];
      const double r = residual(sensor, reading.volts, result.gain);
      const double J = J_residual_gain(sensor, reading.volts, result.gain);
      const double weight = std::min(1.0, 1.345 * scale / std::max(std::abs(r), 1e-300));
      information += weight * J * J;
      gradient += weight * J * r;
    }
    if (!(information > 0.0)) {
      return Error{"the readings do not depend on the gain", "", "check the sensors' offsets"};
    }
    const double step = std::clamp(-gradient / information, -0.1, 0.1);
    result.gain += step;
    if (!(result.gain > 0.5) || !(result.gain < 2.0)) {
      return Error{"the sensors do not read gravity with any gain", "", "calibrate their range again"};
    }
    if (std::abs(step) < 1e-12) {
      break;
    }
  }
  result.residual_g = rms(readings, sensors, result.gain);
  // The spread that is left, with one degree of freedom used up; at least what the calibrations themselves left.
  double calibration_square = 0.0;
  for (const StillReading& reading : readings) {
    calibration_square += std::pow(sensors[static_cast<std::size_t>(reading.sensor)].residual_g, 2);
  }
  const auto n = static_cast<double>(readings.size());
  const double spread = std::max(scale * std::sqrt(n / (n - 1.0)), std::sqrt(calibration_square / n));
  result.standard_error = spread / std::sqrt(information);
  if (result.standard_error > 0.05) {
    return Error{fmt::format("the gain is uncertain by {:.0f} %", 100.0 * result.standard_error), "",
                 "calibrate the sensors' range, then hold still in several poses"};
  }
  const double change = std::abs(result.gain - 1.0);
  result.moved = change > 0.002 && change > 3.0 * result.standard_error;
  return result;
}

std::vector<StillReading> still_readings(std::span<const decode::AccelerationFrame> frames,
                                         std::span<const SensorCalibration> sensors, double threshold_g) {
  std::vector<SensorSeries> series;
  std::vector<SensorCalibration> calibrations;
  std::vector<int> indices;
  const auto count = std::min<std::size_t>(sensors.size(), decode::kMaxSensors);
  for (std::size_t s = 0; s < count; ++s) {
    SensorSeries one = sensor_series(frames, static_cast<int>(s));
    if (std::any_of(one.usable.begin(), one.usable.end(), [](unsigned char usable) { return usable != 0; })) {
      series.push_back(std::move(one));
      calibrations.push_back(sensors[s]);
      indices.push_back(static_cast<int>(s));
    }
  }
  std::vector<StillReading> readings;
  int number = 0;
  for (const StillWindow& window : still_windows(series, calibrations, threshold_g)) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
      readings.push_back({indices[i], window.mean_volts[i], number});
    }
    ++number;
  }
  return readings;
}

SensorCalibration with_gain(const SensorCalibration& sensor, double gain) {
  SensorCalibration changed = sensor;
  changed.M = sensor.M * gain;
  changed.offset = sensor.offset / gain;
  return changed;
}

}  // namespace limbwave::calibrate
