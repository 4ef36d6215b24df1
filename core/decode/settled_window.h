/// The smooth window that every level is read through, and its sums over samples.
#pragma once

#include <map>
#include <memory>
#include <vector>

namespace limbwave::decode {

/// Weights for `length` samples. The window rises and falls smoothly, so that ringing left and right of it and within
/// its flanks averages out; it starts on a whole sample, so that its weights and moments are known beforehand.
struct SettledWindow {
  explicit SettledWindow(int samples);
  int length;
  std::vector<float> mean;      ///< w: weights of the mean, sum 1.
  std::vector<float> integral;  ///< Give Σ w_n ∫y up to sample n by the trapezoid rule, from the window's start.
  /// v with Σ v y = Σ w y' per sample: exactly −κ Σ w y for a signal that decays by the trapezoid rule
  /// y_n − y_{n−1} = −κ (y_n + y_{n−1}) / 2.
  std::vector<float> slope;
  double integral_sum = 0.0;  ///< Sum of `integral`.
  double spread = 0.0;        ///< Σ w (n − centre)², samples².
  double noise_gain = 0.0;    ///< Σ w²: variance of the mean for white noise of variance 1.
  /// Distance of the window's centre from its first sample, samples.
  [[nodiscard]] double centre() const { return 0.5 * (length - 1); }
};

/// What a window sees of a signal.
struct WindowSums {
  double mean = 0.0;      ///< Σ w y
  double integral = 0.0;  ///< Mean of the running integral from the window's first sample, value · samples.
  double slope = 0.0;     ///< Mean slope, value per sample.
  double variance = 0.0;  ///< Σ w (y − line)², about the straight line of that mean and slope.
  double sum = 0.0;       ///< Σ y
  float largest = 0.0F;   ///< Largest |y|.
};

/// One pass over `window.length` samples. The order of the additions is fixed.
WindowSums sum_window(const SettledWindow& window, const float* samples);
/// Σ samples; the order of the additions is fixed.
double sum_samples(const float* samples, std::ptrdiff_t count);
/// Windows by length, made when first asked for.
class WindowBank {
 public:
  const SettledWindow& get(int length);

 private:
  std::map<int, std::unique_ptr<SettledWindow>> windows_;
};

}  // namespace limbwave::decode
