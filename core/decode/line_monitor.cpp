#include "decode/line_monitor.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace limbwave::decode {
namespace {

constexpr double kStretchEnds_s = 0.5;        // clipping that pauses for longer is a new occurrence
constexpr double kHum = 0.002;                // of the counter's swing
constexpr std::size_t kConfirm = 8;           // steady cycles after a change before it is judged
constexpr double kSmallestGainChange = 0.02;  // of the swing, relative
constexpr double kSmallestJump = 0.05;        // of the levels against the swing, relative

/// How far `after` is a multiple of `before`: the factor, and the share of the change that it does not explain.
struct Proportion {
  double factor = 1.0;
  double unexplained = 1.0;
};

Proportion compare(const std::array<double, kMaxSlots>& before, const std::array<double, kMaxSlots>& after, int slots) {
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(slots); ++j) {
    bb += before[j] * before[j];
    ab += after[j] * before[j];
  }
  Proportion result;
  if (bb <= 0.0) {
    return result;
  }
  result.factor = ab / bb;
  double rest = 0.0;
  double change = 0.0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(slots); ++j) {
    const double unexplained = after[j] - result.factor * before[j];
    const double difference = after[j] - before[j];
    rest += unexplained * unexplained;
    change += difference * difference;
  }
  result.unexplained = change > 0.0 ? std::sqrt(rest / change) : 1.0;
  return result;
}

}  // namespace

std::string LineMonitor::slot_name(int slot) const {
  if (slot == format_.slots - 1) {
    return "the reference slot";
  }
  return fmt::format("sensor {} axis {}", slot / 3 + 1, "xyz"[slot % 3]);
}

void LineMonitor::step(const LineInCycle& cycle, bool counter_clipped, const SwingTracker::Reading& swing) {
  const double time_s = cycle.start_sample / rate_.hz;
  watch_clipping(cycle, counter_clipped, time_s);
  watch_gain(cycle, swing, time_s);
}

void LineMonitor::watch_clipping(const LineInCycle& cycle, bool counter_clipped, double time_s) {
  if (cycle.clipped != 0) {
    const int count = std::popcount(cycle.clipped);
    clipped_slots_ += count;
    if (time_s - last_clip_s_ > kStretchEnds_s) {
      ++clip_stretches_;
      told_slots_ += count;
      log_->add({Severity::kWarning, "line-in.clipped",
                 fmt::format("the sensor channel reaches full scale in {} of {} slots, first {}", count, format_.slots,
                             slot_name(std::countr_zero(cycle.clipped))),
                 "Turn the input level down and record this part again", "", time_s});
    }
    last_clip_s_ = time_s;
  }
  if (counter_clipped) {
    if (time_s - last_counter_clip_s_ > kStretchEnds_s) {
      log_->add({Severity::kWarning, "line-in.counter-clipped",
                 "the counter channel reaches full scale, so its swing is no measure of the gain; the last good scale "
                 "is kept",
                 "Turn the input level down until the counter reaches about two thirds of full scale", "", time_s});
    }
    last_counter_clip_s_ = time_s;
  }
}

void LineMonitor::watch_clicks(const LineInCycle& cycle, std::uint32_t clicks) {
  if (clicks == 0) {
    return;
  }
  const double time_s = cycle.start_sample / rate_.hz;
  if (time_s - last_click_s_ > kStretchEnds_s) {
    log_->add({Severity::kWarning, "line-in.click",
               fmt::format("the signal of {} jumps within its slot: a click, or samples that were lost; the reading is "
                           "left out",
                           slot_name(std::countr_zero(clicks))),
               "If it happens often, check plugs and solder joints, close other programs or take a larger buffer", "",
               time_s});
  }
  last_click_s_ = time_s;
}

void LineMonitor::watch_hum(const LineInCycle& cycle, const HumTracker& hum, double unrest, double explained,
                            double swing) {
  const double limit = std::max(4.0 * explained, kHum * swing);
  // As RMS; what is taken out is told from the same strength on.
  const double removed = hum.amplitude() / std::sqrt(2.0);
  const double strength = std::max(unrest, removed);
  if (strength > limit && !humming_) {
    humming_ = true;
    const std::string what =
        removed > unrest
            ? fmt::format(
                  "there is {:.0f} Hz mains hum on the sensor channel, {:.2f} % of the counter's swing; it is "
                  "taken out as far as it is steady",
                  hum.mains_hz(), 100.0 * hum.amplitude() / swing)
            : fmt::format(
                  "the reference level, which should stand still, moves by {:.2f} % of the counter's swing: "
                  "there is hum on the sensor channel",
                  100.0 * unrest / swing);
    log_->add({Severity::kWarning, "line-in.hum", what,
               "Run the computer on its battery, keep the cable away from power supplies and use a shielded one", "",
               cycle.start_sample / rate_.hz});
  } else if (strength < 0.5 * limit) {
    humming_ = false;
  }
}

void LineMonitor::watch_gain(const LineInCycle& cycle, const SwingTracker::Reading& swing, double time_s) {
  const bool disturbed = swing.moved || !swing.usable || swing.fallback;
  if (disturbed || cycle.gap_before) {
    if (!changing_ && !recent_.empty()) {
      changing_ = true;
      change_s_ = time_s;
      before_ = recent_.back();
    }
    recent_.clear();
  }
  if (disturbed) {
    return;
  }
  if (!cycle.valid || cycle.clipped != 0) {
    return;
  }
  recent_.push_back({time_s, swing.swing, cycle.volts});
  if (changing_) {
    if (recent_.size() < kConfirm) {
      return;
    }
    changing_ = false;
    judge_change(before_, recent_.front());
  } else if (recent_.size() >= 5 + kConfirm) {
    // Only the sensor channel: all levels jump by one factor between two cycles and stay there.
    const std::size_t middle = recent_.size() - kConfirm;
    const Proportion jump = compare(recent_[middle - 2].volts, recent_[middle].volts, format_.slots);
    if (std::fabs(jump.factor - 1.0) > kSmallestJump && jump.unexplained < 0.15) {
      const Proportion later = compare(recent_[middle - 2].volts, recent_.back().volts, format_.slots);
      const Proportion earlier = compare(recent_[middle - 5].volts, recent_[middle - 2].volts, format_.slots);
      if (std::fabs(later.factor / jump.factor - 1.0) < 0.2 * std::fabs(jump.factor - 1.0) &&
          std::fabs(earlier.factor - 1.0) < 0.2 * std::fabs(jump.factor - 1.0)) {
        tell_sensor_channel_changed(jump.factor, recent_[middle - 1].time_s);
        recent_.erase(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(middle + 1));
      }
    }
  }
  while (recent_.size() > 5 + kConfirm) {
    recent_.pop_front();
  }
}

void LineMonitor::tell_sensor_channel_changed(double factor, double time_s) {
  log_->add({Severity::kWarning, "line-in.balance-changed",
             fmt::format("the sensor channel changed by a factor of {:.3f}, the counter channel did not", factor),
             "Set the balance back to where it was, or repeat the range calibration", "", time_s});
}

void LineMonitor::judge_change(const Sample& before, const Sample& after) {
  const double factor = after.swing / before.swing;
  const Proportion levels = compare(before.volts, after.volts, format_.slots);
  if (std::fabs(factor - 1.0) <= kSmallestGainChange) {
    // The counter is as it was. All levels changed by one factor, and quickly: only the sensor channel did.
    if (std::fabs(levels.factor - 1.0) > kSmallestJump && levels.unexplained < 0.15 &&
        after.time_s - before.time_s < 0.2) {
      tell_sensor_channel_changed(levels.factor, change_s_);
    }
  } else if (std::fabs(levels.factor * factor - 1.0) < 0.4 * std::fabs(factor - 1.0) && levels.unexplained < 0.3) {
    // The levels in volts stand still when both channels changed alike; here those in the signal did.
    log_->add({Severity::kWarning, "line-in.balance-changed",
               fmt::format("the counter channel changed by a factor of {:.3f}, the sensor channel did not", factor),
               "Set the balance back to where it was, or repeat the range calibration", "", change_s_});
  } else {
    log_->add({Severity::kWarning, "line-in.level-changed",
               fmt::format("the input level changed by a factor of {:.3f}; values are scaled back by the counter's "
                           "swing",
                           factor),
               "Leave the volume knob alone while recording; check this part of the take", "", change_s_});
  }
}

void LineMonitor::finish() {
  if (clipped_slots_ > told_slots_) {
    log_->add({Severity::kWarning, "line-in.clipped-total",
               fmt::format("{} slots reached full scale in all, in {} stretches", clipped_slots_, clip_stretches_),
               "Turn the input level down and record again", "", -1.0});
  }
}

}  // namespace limbwave::decode
