#include "decode/settled_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "signal/lanes.h"

namespace limbwave::decode {

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
  double after = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    const double weight = 0.5 * (step[i] + step[i + 1]);
    mean[i] = static_cast<float>(weight);
    slope[i] = static_cast<float>(step[i] - step[i + 1]);
    integral[i] = static_cast<float>(after + 0.5 * weight);
    after += weight;
    integral_sum += integral[i];
    const double distance = static_cast<double>(i) - centre();
    spread += weight * distance * distance;
    noise_gain += weight * weight;
  }
}

WindowSums sum_window(const SettledWindow& window, const float* samples) {
  // Relative to a sample in the middle the values are small, so that single precision is plenty.
  using signal::load_lanes;
  const float pivot = samples[window.length / 2];
  const signal::Lanes pivots = signal::all_lanes(pivot);
  signal::Lanes mean{};
  signal::Lanes square{};
  signal::Lanes integral{};
  signal::Lanes slope{};
  signal::Lanes sum{};
  signal::Lanes largest{};
  const float* w = window.mean.data();
  const float* c = window.integral.data();
  const float* v = window.slope.data();
  const int whole = window.length / signal::kLanes * signal::kLanes;
  for (int i = 0; i < whole; i += signal::kLanes) {
    const signal::Lanes y = load_lanes(samples + i);
    const signal::Lanes d = y - pivots;
    const signal::Lanes weighted = load_lanes(w + i) * d;
    mean += weighted;
    square += weighted * d;
    integral += load_lanes(c + i) * d;
    slope += load_lanes(v + i) * d;
    sum += d;
    largest = signal::larger(signal::magnitude(y), largest);
  }
  double mean_d = signal::sum_of(mean);
  double square_d = signal::sum_of(square);
  WindowSums result;
  result.integral = signal::sum_of(integral) + window.integral_sum * pivot;
  result.slope = signal::sum_of(slope);
  result.sum = signal::sum_of(sum) + static_cast<double>(window.length) * pivot;
  result.largest = signal::largest_of(largest);
  for (int i = whole; i < window.length; ++i) {
    const double d = samples[i] - pivot;
    mean_d += w[i] * d;
    square_d += w[i] * d * d;
    result.integral += c[i] * d;
    result.slope += v[i] * d;
    result.sum += d;
    result.largest = std::max(result.largest, std::fabs(samples[i]));
  }
  result.mean = pivot + mean_d;
  result.variance = std::max(0.0, square_d - mean_d * mean_d - result.slope * result.slope * window.spread);
  return result;
}

double sum_samples(const float* samples, std::ptrdiff_t count) {
  double even = 0.0;
  double odd = 0.0;
  std::ptrdiff_t i = 0;
  for (; i + 2 <= count; i += 2) {
    even += samples[i];
    odd += samples[i + 1];
  }
  return even + odd + (i < count ? samples[i] : 0.0F);
}

const SettledWindow& WindowBank::get(int length) {
  std::unique_ptr<SettledWindow>& window = windows_[length];
  if (!window) {
    window = std::make_unique<SettledWindow>(length);
  }
  return *window;
}

}  // namespace limbwave::decode
