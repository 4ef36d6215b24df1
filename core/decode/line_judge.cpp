#include "decode/line_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

#include "base/units.h"
#include "decode/cycle_measurement.h"
#include "decode/reference_filter.h"

namespace limbwave::decode {
namespace {

constexpr double kSilentRms = 2e-3;  // -54 dBFS: below it there is only noise
constexpr double kMonoCorrelation = 0.98;
constexpr double kLowestSwing = 0.02;    // peak to peak: -40 dBFS
constexpr double kFewestSamples = 30.0;  // a slot; with fewer a card's filter rings through all of it

double decibels(double level) {
  return 20.0 * std::log10(std::max(level, 1e-9));
}

struct ChannelLevels {
  double rms_left = 0.0, rms_right = 0.0, correlation = 0.0;
};

ChannelLevels measure_levels(const ChannelView& left, const ChannelView& right) {
  const std::int64_t count = left.last - left.first;
  const double mean_left = sum_samples(left.at(left.first), count) / static_cast<double>(count);
  const double mean_right = sum_samples(right.at(right.first), count) / static_cast<double>(count);
  double ll = 0.0;
  double rr = 0.0;
  double lr = 0.0;
  for (std::int64_t n = left.first; n < left.last; ++n) {
    const double l = *left.at(n) - mean_left;
    const double r = *right.at(n) - mean_right;
    ll += l * l;
    rr += r * r;
    lr += l * r;
  }
  ChannelLevels levels{std::sqrt(ll / static_cast<double>(count)), std::sqrt(rr / static_cast<double>(count)), 0.0};
  if (ll > 0.0 && rr > 0.0) {
    levels.correlation = lr / std::sqrt(ll * rr);
  }
  return levels;
}

/// Share of the power that is in the mains' 50 or 60 Hz, whichever is more; which one goes to `frequency`.
double hum_share(const ChannelView& channel, double rms, SampleRate rate, double* frequency) {
  double largest = 0.0;
  const double count = static_cast<double>(channel.last - channel.first);
  for (const double candidate : {50.0, 60.0}) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * kPi * candidate / rate.hz);
    std::complex<double> phase = 1.0;
    std::complex<double> sum = 0.0;
    for (std::int64_t n = channel.first; n < channel.last; ++n) {
      sum += phase * static_cast<double>(*channel.at(n));
      phase *= turn;
    }
    const double share = 2.0 * std::norm(sum / count) / (rms * rms + 1e-12);
    if (share > largest) {
      largest = share;
      *frequency = candidate;
    }
  }
  return largest;
}

/// What one phase of the counter gives: coupling and mean levels.
struct Survey {
  CouplingEstimator coupling;
  std::array<double, kMaxSlots> levels{};
  double swing = 0.0, noise = 0.0;
  int cycles = 0, clipped_counters = 0;
};

Survey survey_cycles(const CounterSearch& search, bool inverted, const ChannelView& data, const ChannelView& counter,
                     const LineInFormat& format, SampleRate rate, double settle_fraction, double memory_cycles) {
  Survey survey{CouplingEstimator(memory_cycles), {}};
  for (const bool final_pass : {false, true}) {
    // The first pass finds how the line is coupled, the second one measures with it.
    DecayRegression::Estimate data_coupling = survey.coupling.data();
    data_coupling.sd = 0.0;
    const double kappa = data_coupling.kappa;
    const double counter_kappa = survey.coupling.counter().kappa;
    const double counter_offset = survey.coupling.counter().offset;
    CouplingEstimator coupling(memory_cycles);
    CycleTracker tracker(format, rate);
    tracker.restart(search.half_samples);
    CycleMeter meter(format, settle_fraction);
    ReferenceFilter reference;
    double variance = 0.0;
    double clipped_swing = 0.0;  // only used when there is nothing better
    for (CounterEdge edge : search.edges) {
      edge.rising = edge.rising != inverted;
      const auto bounds = tracker.push(edge);
      if (!bounds) {
        continue;
      }
      const CycleMeasurement cycle = meter.measure(*bounds, data, counter);
      // Noise is not known yet: zero makes the filter go through every reference, which suits a first look.
      const auto levels =
          relative_levels(cycle, reference.step(cycle, format.slots, data_coupling, 0.0, 1e9), kappa, format.slots);
      coupling.add(cycle, levels, format.slots);
      if (final_pass) {
        ++survey.cycles;
        survey.clipped_counters += cycle.counter_clipped ? 1 : 0;
        for (std::size_t j = 0; j < static_cast<std::size_t>(format.slots); ++j) {
          survey.levels[j] += levels[j];
          variance += cycle.slots[j].variance;
        }
        const double swing = cycle.high.mean - cycle.low.mean +
                             counter_kappa * (cycle.high.integral - cycle.low.integral -
                                              counter_offset * (cycle.high.centre - cycle.low.centre));
        (cycle.counter_clipped ? clipped_swing : survey.swing) += swing;
      }
    }
    survey.coupling = coupling;
    survey.coupling.unlink();
    if (final_pass && survey.cycles > 0) {
      for (double& level : survey.levels) {
        level /= survey.cycles;
      }
      const int good = survey.cycles - survey.clipped_counters;
      survey.swing = std::fabs(good > 0 ? survey.swing / good : clipped_swing / survey.cycles);
      survey.noise = std::sqrt(variance / survey.cycles / format.slots);
    }
  }
  return survey;
}

/// One way in which the channels may be turned over, and how well the reference slot stands out then: -1 .. 1.
struct PolarityGuess {
  bool left_inverted = false, right_inverted = false;
  double score = -2.0;
};

std::array<PolarityGuess, 2> best_polarities(const std::array<double, kMaxSlots>& levels, const LineInFormat& format,
                                             const LineInParameters& parameters) {
  const auto slots = static_cast<std::size_t>(format.slots);
  const auto [low, high] = std::minmax_element(levels.begin(), levels.begin() + format.slots);
  const double unit = std::max(0.25 * (*high - *low), 1e-9);
  const double direction = format.zero_g_volts > format.reference_volts ? 1.0 : -1.0;
  std::array<PolarityGuess, 2> best{};
  for (const bool right : {false, true}) {
    for (const bool left : {false, true}) {
      if ((parameters.left != Polarity::kAuto && left != (parameters.left == Polarity::kInverted)) ||
          (parameters.right != Polarity::kAuto && right != (parameters.right == Polarity::kInverted))) {
        continue;
      }
      // With the counter inverted everything is half a cycle off: the reference is found in the middle.
      const std::size_t reference = (right ? slots / 2 : slots) - 1;
      double score = 0.0;
      for (std::size_t j = 0; j < slots; ++j) {
        score += std::clamp((left ? -direction : direction) * (levels[j] - levels[reference]) / unit, -1.0, 1.0);
      }
      score /= static_cast<double>(slots - 1);
      if (score > best[0].score) {
        best[1] = best[0];
        best[0] = {left, right, score};
      } else if (score > best[1].score) {
        best[1] = {left, right, score};
      }
    }
  }
  return best;
}

class Judge {
 public:
  Judge(const ChannelView& left, const ChannelView& right, const LineInFormat& format, SampleRate rate,
        const LineInParameters& parameters, double memory_cycles)
      : left_(left), right_(right), format_(format), rate_(rate), parameters_(parameters), memory_(memory_cycles) {
    result_.coupling = CouplingEstimator(memory_cycles);
  }
  LineJudgement run();

 private:
  void find(Severity severity, const char* code, std::string message, std::string remedy, const char* place = "") {
    result_.findings.push_back(
        {severity, code, std::move(message), std::move(remedy), place, static_cast<double>(left_.first) / rate_.hz});
  }
  void explain_missing_counter(const CounterSearch& on_left, const CounterSearch& on_right,
                               const ChannelLevels& levels);
  bool judge_polarity(const CounterSearch& search, const ChannelView& data, const ChannelView& counter);
  void judge_levels(const Survey& survey, bool reference_told);
  [[nodiscard]] bool in_tolerance(const CounterSearch& search) const {
    const double hz = 0.5 * rate_.hz / search.half_samples;
    return search.regular && std::fabs(hz / format_.cycle_rate_hz - 1.0) < format_.cycle_rate_tolerance + 0.01;
  }

  ChannelView left_, right_;
  LineInFormat format_;
  SampleRate rate_;
  LineInParameters parameters_;
  double memory_;
  LineJudgement result_;
};

void Judge::explain_missing_counter(const CounterSearch& on_left, const CounterSearch& on_right,
                                    const ChannelLevels& levels) {
  const bool silent_left = levels.rms_left < kSilentRms;
  const bool silent_right = levels.rms_right < kSilentRms;
  const CounterSearch& odd = on_right.regular ? on_right : on_left;
  double frequency = 0.0;
  if (silent_left && silent_right) {
    find(Severity::kError, "line-in.silent",
         fmt::format("both channels are silent (left {:.0f} dBFS, right {:.0f} dBFS)", decibels(levels.rms_left),
                     decibels(levels.rms_right)),
         "Switch the board on, plug it into the line-in socket, choose that input in the sound settings and turn its "
         "level up");
  } else if (!silent_left && !silent_right && std::fabs(levels.correlation) > kMonoCorrelation) {
    find(Severity::kError, "line-in.mono",
         fmt::format("both channels carry the same signal (correlation {:.3f})", levels.correlation),
         "Record in stereo, use a stereo cable and a line input: a microphone socket is often mono");
  } else if (odd.regular) {
    find(Severity::kError, "line-in.clock-rate",
         fmt::format("the counter runs at {:.1f} cycles per second, the rig allows {:.0f} to {:.0f}",
                     0.5 * rate_.hz / odd.half_samples, format_.cycle_rate_hz * (1.0 - format_.cycle_rate_tolerance),
                     format_.cycle_rate_hz * (1.0 + format_.cycle_rate_tolerance)),
         "Choose the rig that belongs to this board, or check that the sample rate is really what the file or device "
         "says");
  } else if (silent_left || silent_right) {
    find(Severity::kError, "line-in.mono",
         fmt::format("the {} channel is silent ({:.0f} dBFS) and there is no counter on the other one",
                     silent_right ? "right" : "left", decibels(silent_right ? levels.rms_right : levels.rms_left)),
         "Use a stereo cable, push the plug in fully and record in stereo", silent_right ? "right" : "left");
  } else if (hum_share(left_, levels.rms_left, rate_, &frequency) > 0.7 ||
             hum_share(right_, levels.rms_right, rate_, &frequency) > 0.7) {
    find(Severity::kError, "line-in.wrong-input",
         fmt::format("there is only {:.0f} Hz mains hum, no counter on either channel", frequency),
         "Push the plug in fully, check the cable's ground and that the board is switched on");
  } else {
    find(Severity::kError, "line-in.wrong-input",
         fmt::format("no counter of about {:.0f} cycles per second on either channel (left {:.0f} dBFS, right {:.0f} "
                     "dBFS)",
                     format_.cycle_rate_hz, decibels(levels.rms_left), decibels(levels.rms_right)),
         "Choose the input that the board is plugged into, not a microphone or a player; switch effects such as noise "
         "reduction and automatic gain off");
  }
}

bool Judge::judge_polarity(const CounterSearch& search, const ChannelView& data, const ChannelView& counter) {
  const bool reference_outside =
      std::fabs(format_.zero_g_volts - format_.reference_volts) > 1.2 * std::fabs(format_.volts_per_g);
  result_.left_inverted = parameters_.left == Polarity::kInverted;
  result_.right_inverted = parameters_.right == Polarity::kInverted;
  Survey survey = survey_cycles(search, false, data, counter, format_, rate_, parameters_.settle_fraction, memory_);
  if (survey.cycles < 2) {
    find(Severity::kError, "line-in.too-short",
         fmt::format("only {} whole cycles of the board were heard", survey.cycles), "Record at least a second");
    return false;
  }
  const auto [low, high] = std::minmax_element(survey.levels.begin(), survey.levels.begin() + format_.slots);
  if (*high - *low < 0.02 * survey.swing) {
    find(Severity::kError, "line-in.no-slots",
         fmt::format("the counter is there, but the {} channel carries no sensor values (its slots differ by {:.1f} % "
                     "of the counter's swing)",
                     result_.swapped ? "right" : "left", 100.0 * (*high - *low) / survey.swing),
         "Check the cable's other channel and the balance control", result_.swapped ? "right" : "left");
    return false;
  }
  bool reference_told = reference_outside;
  if (reference_outside) {
    const auto best = best_polarities(survey.levels, format_, parameters_);
    if (best[0].score > 0.6 && best[0].score - best[1].score > 0.2) {
      result_.left_inverted = best[0].left_inverted;
      result_.right_inverted = best[0].right_inverted;
    } else {
      reference_told = false;
      find(Severity::kWarning, "line-in.no-reference",
           fmt::format(
               "the reference slot does not stand out from the sensors (score {:.2f} of 1), so polarity cannot "
               "be told; it is taken as {}",
               best[0].score,
               parameters_.left == Polarity::kAuto && parameters_.right == Polarity::kAuto ? "not inverted" : "set"),
           "Check the reference voltage of the board against the rig, and that all sensors are plugged in");
    }
  }
  if (result_.right_inverted) {
    survey = survey_cycles(search, true, data, counter, format_, rate_, parameters_.settle_fraction, memory_);
  }
  result_.coupling = survey.coupling;
  result_.swing = survey.swing;
  result_.noise = survey.noise;
  judge_levels(survey, reference_told);
  return true;
}

void Judge::judge_levels(const Survey& survey, bool reference_told) {
  const double slot = rate_.hz / (format_.cycle_rate_hz * format_.slots);
  if (slot < kFewestSamples) {
    find(Severity::kWarning, "line-in.low-rate",
         fmt::format(
             "at {:.0f} samples per second a slot has only {:.0f}: readings are off by some thousandths of g and "
             "more",
             rate_.hz, slot),
         "Record at 44100 samples per second or more");
  }
  const char* counter_name = result_.swapped ? "left" : "right";
  const char* data_name = result_.swapped ? "right" : "left";
  if (result_.swapped && !parameters_.swapped) {
    find(Severity::kWarning, "line-in.swapped", "left and right are exchanged: the counter is on the left channel",
         "Nothing is lost, they are exchanged back; exchange the plugs, or set this in the rig's line settings");
  }
  if (result_.left_inverted && parameters_.left == Polarity::kAuto) {
    find(Severity::kInfo, "line-in.left-inverted",
         fmt::format("the {} channel (sensors) is inverted by this sound card", data_name),
         "Nothing to do: it is turned over again", data_name);
  }
  if (result_.right_inverted && parameters_.right == Polarity::kAuto) {
    find(Severity::kInfo, "line-in.right-inverted",
         fmt::format("the {} channel (counter) is inverted by this sound card", counter_name),
         "Nothing to do: it is turned over again", counter_name);
  }
  if (survey.swing < kLowestSwing) {
    find(Severity::kWarning, "line-in.low-level",
         fmt::format("the counter swings by only {:.2f} % of full scale ({:.0f} dBFS)", 100.0 * survey.swing,
                     decibels(0.5 * survey.swing)),
         "Turn the input level up until the counter reaches about two thirds of full scale", counter_name);
  }
  // All sensors together rest about zero g above the reference: that compares the gains of both channels.
  const double expected = (format_.zero_g_volts - format_.reference_volts) / format_.supply_volts;
  if (reference_told && survey.clipped_counters == 0) {
    double mean = 0.0;
    const int sensors = format_.slots - 1;
    for (int j = 0; j < sensors; ++j) {
      mean += survey.levels[static_cast<std::size_t>(j)] / sensors;
    }
    const double ratio = (result_.left_inverted ? -mean : mean) / survey.swing / expected;
    if (ratio > 0.0 && (ratio < 0.65 || ratio > 1.5)) {
      find(Severity::kWarning, "line-in.unbalanced",
           fmt::format("the {} channel seems to be recorded at {:.2f} times the gain of the other", data_name, ratio),
           "Set the balance to the middle and then leave it, or repeat the range calibration with this setting");
    }
  }
}

LineJudgement Judge::run() {
  const double length = static_cast<double>(left_.last - left_.first);
  if (length < 3.0 * rate_.hz / format_.cycle_rate_hz) {
    find(Severity::kError, "line-in.too-short",
         fmt::format("the signal is only {:.0f} ms long", 1e3 * length / rate_.hz), "Record at least a second");
    return result_;
  }
  const ChannelLevels levels = measure_levels(left_, right_);
  CounterSearch on_left = find_counter(left_, format_, rate_, 0.0);
  CounterSearch on_right = find_counter(right_, format_, rate_, 0.0);
  const bool mono =
      levels.rms_left > kSilentRms && levels.rms_right > kSilentRms && std::fabs(levels.correlation) > kMonoCorrelation;
  const bool right_good = in_tolerance(on_right) && !mono;
  const bool left_good = in_tolerance(on_left) && !mono;
  result_.swapped = parameters_.swapped.value_or(!right_good && left_good);
  if (!(result_.swapped ? left_good : right_good)) {
    explain_missing_counter(on_left, on_right, levels);
    return result_;
  }
  const CounterSearch& search = result_.swapped ? on_left : on_right;
  result_.half_samples = search.half_samples;
  result_.usable = judge_polarity(search, result_.swapped ? right_ : left_, result_.swapped ? left_ : right_);
  return result_;
}

}  // namespace

LineJudgement judge_line(const ChannelView& left, const ChannelView& right, const LineInFormat& format, SampleRate rate,
                         const LineInParameters& parameters, double memory_cycles) {
  return Judge(left, right, format, rate, parameters, memory_cycles).run();
}

}  // namespace limbwave::decode
