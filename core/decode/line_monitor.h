/// Watches the decoded line for what the user should know: clipping, a moved volume knob, a moved balance.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>

#include "decode/finding_log.h"
#include "decode/hum_tracker.h"
#include "decode/line_in.h"
#include "decode/swing_tracker.h"

namespace limbwave::decode {

class LineMonitor {
 public:
  LineMonitor(const LineInFormat& format, SampleRate rate, FindingLog& log)
      : format_(format), rate_(rate), log_(&log) {}
  /// Every cycle, in order of time; `counter_clipped` and `swing` as measured on the counter channel.
  void step(const LineInCycle& cycle, bool counter_clipped, const SwingTracker::Reading& swing);
  /// Slots of a valid cycle within which something happened, bit per slot.
  void watch_clicks(const LineInCycle& cycle, std::uint32_t clicks);
  /// The hum that is taken out; and RMS by which the reference level is then still off its prediction, and what of it
  /// noise explains, fractions of full scale.
  void watch_hum(const LineInCycle& cycle, const HumTracker& hum, double unrest, double explained, double swing);
  /// Sums up what was clipped.
  void finish();

 private:
  using Volts = std::array<double, kMaxSlots>;
  struct Sample {
    double time_s = 0.0;
    double swing = 0.0;
    Volts volts{};
  };
  void watch_clipping(const LineInCycle& cycle, bool counter_clipped, double time_s);
  void watch_gain(const LineInCycle& cycle, const SwingTracker::Reading& swing, double time_s);
  void judge_change(const Sample& before, const Sample& after);
  void tell_sensor_channel_changed(double factor, double time_s);
  [[nodiscard]] std::string slot_name(int slot) const;

  LineInFormat format_;
  SampleRate rate_;
  FindingLog* log_;
  double last_clip_s_ = -1e9, last_counter_clip_s_ = -1e9, last_click_s_ = -1e9;
  std::int64_t clipped_slots_ = 0, told_slots_ = 0, clip_stretches_ = 0;
  std::deque<Sample> recent_;  // steady cycles, newest last
  bool humming_ = false;
  bool changing_ = false;  // the gain moved; `before_` is what was before
  double change_s_ = 0.0;
  Sample before_;
};

}  // namespace limbwave::decode
