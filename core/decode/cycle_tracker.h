/// Whole cycles of the carrier between one source and one microphone.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace limbwave::decode {

/// What one pulse says.
struct CycleReading {
  double nominal = 0.0;  ///< Range by the microphone's tracker, metres: what the residual is counted from.
  double envelope = 0.0, envelope_variance = 0.0;
  double phase = 0.0, phase_variance = 0.0;  ///< Range by the carrier but for whole wavelengths, metres.
  double told = 0.0, told_variance = -1.0;   ///< A pose filter's range and its variance, m²; < 0: none.
};

struct CycleResult {
  double range = 0.0;          ///< Of the likeliest number of cycles, metres.
  double failure = 1.0;        ///< Probability that the number is another one.
  std::int64_t cycles = 0;     ///< That number, counted from the phase.
  std::int64_t moved = 0;      ///< By how many of them the range has most likely changed since the last pulse,
  double moved_failure = 1.0;  ///< and the probability that it was by another number.
};

/// A Gaussian sum (Alspach & Sorenson 1972) over numbers of whole cycles. The residual of the range against what the
/// microphone's tracker dead-reckons has three states: itself, its rate, its acceleration. Every pulse's phase fits
/// each hypothesis with several numbers of cycles; each of these is a hypothesis of the next generation, weighted by
/// how well the phase fits its movement, and the envelope its range. Phases are sixty times finer than envelopes: wrong
/// numbers that change from pulse to pulse soon contradict the movement, and those that are wrong by the same number
/// all the time contradict the mean of the envelopes. Unlikely hypotheses are dropped, equal ones joined.
class CycleTracker {
 public:
  CycleTracker(double wavelength, double stray, double stray_m)
      : wavelength_(wavelength), stray_(stray), stray_m_(stray_m) {}

  [[nodiscard]] bool running() const { return !hypotheses_.empty(); }
  void stop() { hypotheses_.clear(); }
  /// Begins with no residual, uncertain as `P` says.
  void start(const Eigen::Matrix3d& P);
  /// The tracker has been corrected: what is counted from it moves by as much.
  void shift(const Eigen::Vector3d& by);
  /// Time passes, seconds, of either sign; acceleration errors forget in `memory_s`; noise per √s, and the variance of
  /// what the source has wandered.
  void advance(double dt, double memory_s, double jerk, double acceleration_walk, double wandered);
  CycleResult take(const CycleReading& reading);

 private:
  static constexpr std::size_t kMost = 24;
  struct Hypothesis {
    Eigen::Vector3d x;
    Eigen::Matrix3d P;
    double weight;
    std::int64_t cycles, moved;
  };
  double wavelength_, stray_, stray_m_;
  std::vector<Hypothesis> hypotheses_, next_;
  bool fresh_ = true;
};

}  // namespace limbwave::decode
