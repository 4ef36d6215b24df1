/// The line-in board and the cable as continuous time: slot clock, multiplexer, ringing, the card's high pass.
#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include "body/rig.h"
#include "simulate/errors.h"
#include "simulate/random.h"

namespace limbwave::simulate {

/// What the accelerometers put out.
class SlotVoltages {
 public:
  virtual ~SlotVoltages() = default;
  SlotVoltages() = default;
  SlotVoltages(const SlotVoltages&) = delete;
  SlotVoltages& operator=(const SlotVoltages&) = delete;
  /// A slot begins: draw what stays the same throughout it.
  virtual void begin_slot() = 0;
  /// Voltage of an axis (0, 1, 2) of a sensor at a time, volts. Times need not increase.
  virtual double volts(int sensor, int axis, double time_s) = 0;
};

/// Mean voltages of both channels over one sampling period after the other.
class AnalogLine {
 public:
  struct Pair {
    double left = 0.0, right = 0.0;
  };

  /// Periods of 1/rate_hz; the first one returned by `next` is centred on the period with number `first`. The board has
  /// been running, and the card listening, for a while by then. `voltages` must outlive the line.
  AnalogLine(const body::LineInSignal& board, const LineInErrors& errors, std::uint64_t seed, SlotVoltages& voltages,
             double rate_hz, std::int64_t first);

  /// Mean over [n − 1/2, n + 1/2) / rate_hz for n = first, first + 1, ..., in volts around the card's zero. Within a
  /// slot the sensors' voltage goes on moving (a parabola through its start, middle and end).
  Pair next();

  /// Starts of cycles (of slot 0) since the last call, seconds of real time; may be a little ahead of `next`.
  std::vector<double> take_cycle_starts();

 private:
  void next_slot();
  void integrate(double duration, bool whole_period, Pair& sum);
  [[nodiscard]] double high_pass(double& state, double mean, double duration, double decay) const;

  body::LineInSignal board_;
  LineInErrors errors_;
  SlotVoltages& voltages_;
  Random wander_random_, jitter_random_;
  double period_;
  std::int64_t number_;
  double time_;  // up to here everything is integrated

  // The slot that is on the line.
  int slot_ = 0;
  double slot_start_ = 0.0, slot_end_ = 0.0;
  double a_ = 0.0, b_ = 0.0, c_ = 0.0;  // left volts = a + b τ + c τ²
  double right_level_ = 0.0;
  double wander_ = 0.0;
  std::vector<double> cycle_starts_;

  // Linear systems, whose states add up over slots.
  double settle_ = 0.0;
  std::complex<double> ring_pole_, ring_step_;  // per second, and over one whole period
  std::complex<double> left_ring_, right_ring_;
  double coupling_ = 0.0;  // 1/s
  double left_mean_ = 0.0, right_mean_ = 0.0;
};

}  // namespace limbwave::simulate
