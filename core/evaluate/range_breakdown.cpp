#include "evaluate/range_breakdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "solve/driver_box.h"

namespace limbwave::evaluate {
namespace {

using Eigen::Vector3d;

constexpr double kClearLoss = 1.0;        // decibels, as in DriverBoxComparison
constexpr double kClearAngle = 60.0;      // degrees
constexpr double kReferenceRange = 0.6;   // metres, of the noise's definition
constexpr double kBarSnr = 25.0;          // decibels
constexpr double kBarSpeed = 3.0;         // m/s
constexpr int kEnd = 2040;                // of 2048, of a word's value: at the end of its range
constexpr double kClippedTail_s = 0.3;    // how long dead reckoning may suffer from clipped chips
constexpr double kHalfStep_s = 1.0 / 60;  // of a velocity's difference

double radiated(const std::vector<double>& table, double degrees) {
  if (table.size() < 2) {
    return 1.0;
  }
  const double place = std::clamp(degrees / 180.0, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), table.size() - 2);
  return table[below] + (place - static_cast<double>(below)) * (table[below + 1] - table[below]);
}

const Truth::SegmentTruth* find(const Truth& poses, const std::string& name) {
  const auto found = std::find_if(poses.segments.begin(), poses.segments.end(),
                                  [&](const Truth::SegmentTruth& segment) { return segment.name == name; });
  return found == poses.segments.end() ? nullptr : &*found;
}

template <std::size_t N>
std::string class_of(double value, const std::array<double, N>& limits, const char* unit) {
  std::size_t i = 0;
  while (i < N && value >= limits[i]) {
    ++i;
  }
  // The leading letter keeps a map in order of the values.
  const char letter = static_cast<char>('a' + i);
  if (i == 0) {
    return fmt::format("{}: below {:g} {}", letter, limits[0], unit);
  }
  return i == N ? fmt::format("{}: {:g} {} or more", letter, limits[N - 1], unit)
                : fmt::format("{}: {:g} to {:g} {}", letter, limits[i - 1], limits[i], unit);
}

}  // namespace

RangeBreakdown::RangeBreakdown(const DriverBoxTruth& truth, const Truth& poses, const take::TakeInfo& info)
    : truth_(truth), box_(info.rig.driver_box.value()), rate_hz_(info.format.rate.hz) {
  const calibrate::RangingCalibration calibration = solve::ranging_calibration(info);
  const double speed = truth.speed_of_sound > 0.0 ? truth.speed_of_sound : calibration.speed_of_sound;
  scale_ = speed / calibration.speed_of_sound;
  wavelength_ = speed / box_.pulse_hz;
  std::map<std::string, int> sources_on;
  std::string most;
  for (std::size_t s = 0; s < info.rig.sources.size(); ++s) {
    const body::Source& source = info.rig.sources[s];
    levels_.push_back(s < calibration.sources.size() ? calibration.sources[s].level : 1.0);
    sources_.emplace_back(find(poses, source.segment), source.p_LS);
    most = ++sources_on[source.segment] > sources_on[most] ? source.segment : most;
  }
  for (std::size_t w = 0; w < info.rig.microphones.size(); ++w) {
    const body::Microphone& microphone = info.rig.microphones[w];
    Wire wire;
    wire.clear_since.assign(sources_.size(), -1.0);
    wire.last_clear.assign(sources_.size(), -1.0);
    wire.segment = find(poses, microphone.segment);
    wire.p_LS = microphone.p_LS;
    for (const DriverBoxTruth::Frame& frame :
         w < truth.words.size() ? truth.words[w] : std::vector<DriverBoxTruth::Frame>()) {
      if (std::any_of(std::begin(frame.held), std::end(frame.held), [](int held) { return std::abs(held) >= kEnd; })) {
        const double until = frame.start_s + kClippedTail_s;
        if (!wire.clipped.empty() && wire.clipped.back().second >= frame.start_s) {
          wire.clipped.back().second = until;
        } else {
          wire.clipped.emplace_back(frame.start_s, until);
        }
      }
    }
    if (reference_ < 0 && microphone.segment == most) {
      reference_ = static_cast<int>(w);
    }
    wires_.push_back(std::move(wire));
    names_.push_back(microphone.name);
  }
  for (const char* kind : {"in-band SNR", "speed against the source", "range", "receiver", "sources in sight", "chips",
                           "in sight for", "into the take"}) {
    groups_.emplace_back(kind, std::map<std::string, RangeGroup>());
  }
}

Vector3d RangeBreakdown::velocity(const Truth::SegmentTruth& segment, const Vector3d& p_LS, double time_s) {
  const auto at = [&](double time) {
    const auto after = std::lower_bound(segment.times.begin(), segment.times.end(), time);
    const auto i = static_cast<std::size_t>(
        std::min(std::distance(segment.times.begin(), after), static_cast<std::ptrdiff_t>(segment.times.size()) - 1));
    return std::pair(segment.times[i], Vector3d(segment.p_WL[i] + segment.R_WL[i] * p_LS));
  };
  const auto [from, a] = at(time_s - kHalfStep_s);
  const auto [to, b] = at(time_s + kHalfStep_s);
  return to > from ? Vector3d((b - a) / (to - from)) : Vector3d::Zero();
}

PairCircumstances RangeBreakdown::circumstances(const DriverBoxTruth::Pulse& pulse, int receiver, double time_s) const {
  const auto w = static_cast<std::size_t>(receiver);
  const auto s = static_cast<std::size_t>(pulse.source);
  const DriverBoxTruth::Pair& pair = pulse.pairs[w];
  const Wire& wire = wires_[w];
  PairCircumstances c;
  c.range = pair.range;
  const double gain = levels_[s] * radiated(box_.radiation, pair.off_axis_deg) * kReferenceRange /
                      std::max(0.02, static_cast<double>(pair.range));
  c.snr_db = truth_.snr_db + 20.0 * std::log10(std::max(1e-6, gain)) -
             box_.absorption_db_m * (pair.range - kReferenceRange) - pair.loss_db;
  const auto& [on, place] = sources_[s];
  if (wire.segment != nullptr && on != nullptr && !on->times.empty() && !wire.segment->times.empty()) {
    c.speed = (velocity(*wire.segment, wire.p_LS, time_s) - velocity(*on, place, time_s)).norm();
  }
  const double round_s = box_.slot_samples * static_cast<double>(sources_.size()) / rate_hz_;
  c.sources = static_cast<int>(std::count_if(wire.last_clear.begin(), wire.last_clear.end(), [&](double last) {
    return last >= 0.0 && time_s - last < round_s - 1e-6;
  }));
  const auto ends = [&](int board) {
    const auto& stretches = wires_[static_cast<std::size_t>(board)].clipped;
    const auto after =
        std::upper_bound(stretches.begin(), stretches.end(), std::pair(time_s, std::numeric_limits<double>::max()));
    return after != stretches.begin() && std::prev(after)->second >= time_s;
  };
  c.clipped = ends(receiver) || (reference_ >= 0 && ends(reference_));
  c.in_sight_s = time_s - wire.clear_since[s];
  c.into_take_s = time_s;
  return c;
}

void RangeBreakdown::add(const decode::RangeReading& reading) {
  const auto pulse =
      std::lower_bound(truth_.pulses.begin(), truth_.pulses.end(), reading.emission.value,
                       [](const DriverBoxTruth::Pulse& p, std::int64_t emission) { return p.emission < emission; });
  const auto w = static_cast<std::size_t>(reading.receiver);
  if (pulse == truth_.pulses.end() || pulse->emission != reading.emission.value || w >= pulse->pairs.size() ||
      w >= wires_.size() || reading.verdict == decode::RangeVerdict::kInterrupted) {
    return;
  }
  const DriverBoxTruth::Pair& pair = pulse->pairs[w];
  const double time_s = static_cast<double>(pulse->emission) / rate_hz_;
  const double later = reading.emission_time.value - time_s;
  const double range = pair.range + later * pair.rate;
  if (std::isfinite(reading.carrier_range)) {
    const auto decade = static_cast<std::size_t>(std::clamp(-std::log10(std::max(1e-12, reading.failure)), 0.0, 6.0));
    Claim& claim = claims_[decade];
    ++claim.count;
    claim.claimed += reading.failure;
    claim.wrong += std::abs(scale_ * reading.carrier_range - range) > 0.5 * wavelength_ ? 1 : 0;
  }
  Wire& wire = wires_[w];
  const auto s = static_cast<std::size_t>(pulse->source);
  if (!(pair.loss_db < kClearLoss && pair.off_axis_deg <= kClearAngle)) {
    wire.clear_since[s] = -1.0;
    return;
  }
  wire.clear_since[s] = wire.clear_since[s] < 0.0 ? time_s : wire.clear_since[s];
  wire.last_clear[s] = time_s;
  const PairCircumstances c = circumstances(*pulse, reading.receiver, time_s);
  const bool accepted = reading.verdict == decode::RangeVerdict::kAccepted;
  const bool slipped = accepted && std::abs(scale_ * reading.range - range) > 0.5 * wavelength_;
  const auto count = [&](RangeGroup& group) {
    ++group.clear;
    ++group.by_verdict[static_cast<std::size_t>(reading.verdict)];
    group.slips += slipped ? 1 : 0;
    group.claimed += accepted ? reading.failure : 0.0;
  };
  count(all_);
  if (c.snr_db >= kBarSnr && c.speed <= kBarSpeed) {
    count(at_bar_);
  }
  const std::array<std::string, 8> classes = {class_of(c.snr_db, std::array{12.0, 15.0, 18.0, 21.0, 25.0, 30.0}, "dB"),
                                              class_of(c.speed, std::array{0.5, 1.0, 2.0, 3.0, 5.0}, "m/s"),
                                              class_of(c.range, std::array{0.1, 0.3, 0.6, 1.0, 1.4}, "m"),
                                              names_[w],
                                              fmt::format("{}", c.sources),
                                              c.clipped ? "at an end of their range" : "within their range",
                                              class_of(c.in_sight_s, std::array{0.1, 0.25, 0.5, 1.0, 2.0}, "s"),
                                              class_of(c.into_take_s, std::array{0.5, 1.0, 2.0, 4.0}, "s")};
  for (std::size_t i = 0; i < classes.size(); ++i) {
    count(groups_[i].second[classes[i]]);
  }
}

}  // namespace limbwave::evaluate
