/// From where a cycle lies to its voltages: measures the slots, undoes the coupling, subtracts the reference, scales by
/// the counter's swing, and marks what cannot be trusted.
#pragma once

#include <cstdint>
#include <limits>

#include "decode/click_guard.h"
#include "decode/coupling.h"
#include "decode/cycle_measurement.h"
#include "decode/finding_log.h"
#include "decode/hum_tracker.h"
#include "decode/line_in.h"
#include "decode/line_judge.h"
#include "decode/line_monitor.h"
#include "decode/reference_filter.h"
#include "decode/swing_tracker.h"

namespace limbwave::decode {

class CycleDecoder {
 public:
  /// `memory_cycles`: over which the coupling is learnt. `log` must outlive it.
  CycleDecoder(const LineInFormat& format, SampleRate rate, const LineInParameters& parameters, double memory_cycles,
               FindingLog& log);

  /// The line was judged (anew): it starts from what the judgement found. Cycles before `judged_until` (samples) are
  /// those that it has learnt the coupling from.
  void start(const LineJudgement& judgement, std::int64_t judged_until);
  /// Samples are missing: the next cycle does not follow the last one.
  void unlink();
  /// Fills in everything from `sample` to `valid`; `out` knows where it lies. The samples of the cycle must be there.
  void decode(const CycleBounds& bounds, const ChannelView& data, const ChannelView& counter, LineInCycle& out);
  /// Corners, swing, noise and clipped slots into a status.
  void tell(LineInStatus& status) const;
  /// Tells again what is still going on, and counts anew.
  void restart_findings() { monitor_.restart(); }
  /// Sums up what the user should know.
  void sum_up_findings() { monitor_.sum_up(); }

  /// First sample that the next cycle still needs, if it follows.
  [[nodiscard]] std::int64_t needs_from() const { return meter_.needs_from(); }
  [[nodiscard]] double swing() const { return swing_.swing(); }
  /// How fast the counter's channel forgets, per sample.
  [[nodiscard]] double counter_kappa() const { return coupling_.counter().kappa; }

 private:
  [[nodiscard]] DecayRegression::Estimate data_coupling() const;
  /// Takes hum out of the counter's levels; `kappa` of its channel.
  void still_counter(CycleMeasurement& measured, double kappa);

  LineInFormat format_;
  SampleRate rate_;
  LineInParameters parameters_;
  CycleMeter meter_;
  CouplingEstimator coupling_;
  ReferenceFilter reference_;
  SwingTracker swing_{0.0, false};
  ClickGuard clicks_{0.0};
  HumTracker hum_;          // of the sensors' channel
  HumTracker counter_hum_;  // of the counter's
  LineMonitor monitor_;
  bool left_inverted_ = false;
  double judged_until_ = -std::numeric_limits<double>::infinity();
  double noise_ = 0.0;
  double first_swing_ = 0.0;
  int cycles_ = 0;  // since the start
  bool was_usable_ = true;
  std::int64_t clipped_slots_ = 0;
};

}  // namespace limbwave::decode
