/// Tells when a sensor is turned slowly enough that it feels gravity alone, and low-passes it there.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

namespace limbwave::calibrate {

/// One reading after the low pass.
struct SteadySample {
  double time_s = 0.0;
  Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< Low-passed, same unit as the input.
  double unsteadiness = 0.0;                        ///< RMS about the local parabola, same unit, all axes together.
  double rate = 0.0;                                ///< Length of the slope, unit per second.
  bool whole = false;   ///< The window around the sample has no gap and no unusable reading.
  bool steady = false;  ///< Slow and free of jerks here and for a window's half around.
};

struct SteadinessParameters {
  double half_window_s = 0.15;         ///< Of the parabola that is fitted around every reading.
  double largest_unsteadiness = 0.02;  ///< Unit of the input; a jerk leaves more about the parabola.
  double largest_rate = 1.2;           ///< Unit per second; 1.2 g/s is 69°/s of turning.
  double largest_gap_s = 0.1;          ///< Readings further apart are not taken together.
};

/// Streaming: every sample comes out one window (two half windows) after it went in, whatever the block size.
class SteadinessFilter {
 public:
  explicit SteadinessFilter(const SteadinessParameters& parameters = {}) : parameters_(parameters) {}
  /// Times must increase; others are ignored.
  void push(double time_s, const Eigen::Vector3d& value, bool usable);
  /// No more readings: gives out what still waits.
  void finish();
  /// Samples that are complete since the last call.
  std::vector<SteadySample> take();

 private:
  struct Reading {
    double time_s;
    Eigen::Vector3d value;
    bool usable;
  };
  [[nodiscard]] SteadySample fit(std::size_t index) const;
  [[nodiscard]] bool calm(const SteadySample& sample) const;
  void advance(bool finishing);

  SteadinessParameters parameters_;
  std::deque<Reading> readings_;
  std::size_t next_ = 0;             ///< First reading without its parabola.
  std::deque<SteadySample> fitted_;  ///< With parabola; `steady` not known yet from `next_steady_` on.
  std::size_t next_steady_ = 0;
  std::vector<SteadySample> done_;
};

}  // namespace limbwave::calibrate
