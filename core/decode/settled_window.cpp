#include "decode/settled_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace limbwave::decode {
namespace {

// Lanes that do not depend on each other let the compiler vectorise sums without being allowed to reorder them.
constexpr int kLanes = 4;
using Lanes = std::array<double, kLanes>;

double total(const Lanes& lanes) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

}  // namespace

SettledWindow::SettledWindow(int samples) : length(std::max(samples, 2)) {
  const auto count = static_cast<std::size_t>(length);
  // Weights of the steps between neighbours; those of samples follow by summation by parts.
  std::vector<double> step(count + 1, 0.0);
  double sum = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    const double u = (2.0 * static_cast<double>(i) - length) / length;
    const double square = u * u;
    const double flank = 1.0 - square * square;
    step[i] = flank * flank;
    sum += step[i];
  }
  for (double& weight : step) {
    weight /= sum;
  }
  mean.resize(count);
  slope.resize(count);
  integral.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    mean[i] = 0.5 * (step[i] + step[i + 1]);
    slope[i] = step[i] - step[i + 1];
  }
  double after = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    integral[i] = after + 0.5 * mean[i];
    after += mean[i];
    const double distance = static_cast<double>(i) - centre();
    spread += mean[i] * distance * distance;
    noise_gain += mean[i] * mean[i];
  }
}

double WindowSums::residual_variance(const SettledWindow& window) const {
  return std::max(0.0, square - mean * mean - slope * slope * window.spread);
}

WindowSums sum_window(const SettledWindow& window, const float* samples) {
  Lanes mean{};
  Lanes integral{};
  Lanes slope{};
  Lanes square{};
  Lanes sum{};
  const double* w = window.mean.data();
  const double* c = window.integral.data();
  const double* v = window.slope.data();
  const int whole = window.length / kLanes * kLanes;
  for (int i = 0; i < whole; i += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double y = samples[i + lane];
      const double weighted = w[i + lane] * y;
      mean[static_cast<std::size_t>(lane)] += weighted;
      square[static_cast<std::size_t>(lane)] += weighted * y;
      integral[static_cast<std::size_t>(lane)] += c[i + lane] * y;
      slope[static_cast<std::size_t>(lane)] += v[i + lane] * y;
      sum[static_cast<std::size_t>(lane)] += y;
    }
  }
  WindowSums result{total(mean), total(integral), total(slope), total(square), total(sum)};
  for (int i = whole; i < window.length; ++i) {
    const double y = samples[i];
    result.mean += w[i] * y;
    result.square += w[i] * y * y;
    result.integral += c[i] * y;
    result.slope += v[i] * y;
    result.sum += y;
  }
  return result;
}

double sum_samples(const float* samples, std::ptrdiff_t count) {
  Lanes lanes{};
  const std::ptrdiff_t whole = count / kLanes * kLanes;
  for (std::ptrdiff_t i = 0; i < whole; i += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      lanes[static_cast<std::size_t>(lane)] += samples[i + lane];
    }
  }
  double sum = total(lanes);
  for (std::ptrdiff_t i = whole; i < count; ++i) {
    sum += samples[i];
  }
  return sum;
}

float largest_magnitude(const float* samples, std::ptrdiff_t count) {
  std::array<float, 8> lanes{};
  const std::ptrdiff_t whole = count / 8 * 8;
  for (std::ptrdiff_t i = 0; i < whole; i += 8) {
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) {
      const float magnitude = std::fabs(samples[i + lane]);
      float& largest = lanes[static_cast<std::size_t>(lane)];
      largest = magnitude > largest ? magnitude : largest;
    }
  }
  float largest = 0.0F;
  for (const float lane : lanes) {
    largest = std::max(largest, lane);
  }
  for (std::ptrdiff_t i = whole; i < count; ++i) {
    largest = std::max(largest, std::fabs(samples[i]));
  }
  return largest;
}

const SettledWindow& WindowBank::get(int length) {
  std::unique_ptr<SettledWindow>& window = windows_[length];
  if (!window) {
    window = std::make_unique<SettledWindow>(length);
  }
  return *window;
}

}  // namespace limbwave::decode
