#include "decode/ranging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "base/units.h"
#include "decode/pulse_finder.h"
#include "decode/pulse_shape.h"
#include "decode/range_trackers.h"
#include "decode/steepest_point.h"
#include "signal/fir_design.h"

namespace limbwave::decode {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNoiseMemory = 1.0 / 24.0;  // of a slot
constexpr double kStrong = 0.6;              // of the amplitude expected: fully believed from here
constexpr double kSystematic = 0.4e-3;       // metres, of the envelope beside its noise
constexpr double kCaution = 1.8;             // of variances, before whole cycles are counted
constexpr double kSurprise = 5.0;            // standard deviations
constexpr double kFarthest = 3.7;            // standard deviations of the envelope
constexpr double kFinest = 0.55e-3;          // metres; a carrier whose phase is known worse is none
constexpr double kModel = 0.2e-3;            // metres, of what is expected
constexpr double kNowhere = 0.6;             // radians, of a direction that is not known
constexpr double kPoseAngle = 0.06;          // radians, of one that a pose filter tells
constexpr double kDoubt = 3.2;               // standard deviations of the mean of envelope minus carrier

double wrapped(double value, double period) {
  return value - period * std::floor(value / period);
}

}  // namespace

std::string_view name(RangeVerdict verdict) {
  constexpr std::array<std::string_view, 7> kNames = {"accepted",     "nothing-heard", "too-weak", "ambiguous",
                                                      "inconsistent", "interrupted",   "disturbed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

struct RangingDecoder::Impl {
  Impl(const RangingFormat& ranging_format, SampleRate sample_rate, int receiver_index,
       const RangingParameters& ranging_parameters, std::shared_ptr<const PulseShape> shared)
      : format(ranging_format),
        rate(sample_rate),
        receiver(receiver_index),
        parameters(ranging_parameters),
        plan(format, rate),
        shape(shared ? std::move(shared) : std::make_shared<const PulseShape>(format, plan, rate)),
        finder(*shape, plan),
        trackers(format, parameters),
        paper(parameters.method == RangingMethod::kPaper ? std::make_unique<SteepestPoint>(format, rate) : nullptr),
        slips(format.sources.size()) {
    longest_reach = 0.0;
    for (const RangingSource& source : format.sources) {
      longest_reach = std::max(longest_reach, source.reach);
    }
    // What lies before the first sample is silence.
    const std::size_t before = std::max(plan.taps_re.size(), paper ? paper->margin() : 0) + 64;
    samples.assign(before, 0.0F);
    samples_start = -static_cast<std::int64_t>(before);
    next_value = -static_cast<std::int64_t>(lead_values());
    values_start = next_value;
  }

  RangingFormat format;
  SampleRate rate;
  int receiver;
  RangingParameters parameters;
  BasebandPlan plan;
  std::shared_ptr<const PulseShape> shape;
  PulseFinder finder;
  RangeTrackers trackers;
  std::unique_ptr<SteepestPoint> paper;
  Predict predict;
  double longest_reach;
  std::vector<float> samples;
  std::int64_t samples_start = 0;
  std::vector<std::complex<float>> values;  // value n is about sample n · step, carrier not yet turned back
  std::int64_t values_start = 0, next_value = 0;
  std::int64_t slot = 0;
  double noise = -1.0;
  std::vector<std::pair<std::int64_t, std::int64_t>> missing;  // samples
  struct Slip {
    double mean = 0.0, weight = 0.0;
  };
  std::vector<Slip> slips;
  std::vector<std::complex<float>> window;
  std::vector<float> powers;
  std::vector<RangeReading> readings;

  [[nodiscard]] std::size_t lead_values() const { return shape->lead() + 4; }
  [[nodiscard]] std::int64_t end() const { return samples_start + static_cast<std::int64_t>(samples.size()); }

  void filter() {
    const auto half = static_cast<std::int64_t>(plan.half);
    const auto taps = static_cast<std::int64_t>(plan.taps_re.size());
    while (next_value * plan.step - half + taps <= end()) {
      const float* x = samples.data() + (next_value * plan.step - half - samples_start);
      const signal::DotPair sum = signal::dot_pair(x, plan.taps_re.data(), plan.taps_im.data(), plan.taps_re.size());
      values.emplace_back(sum.first, sum.second);
      ++next_value;
    }
  }

  void advance() {
    filter();
    const std::int64_t margin = paper ? static_cast<std::int64_t>(paper->margin()) : 0;
    while (true) {
      const std::int64_t first = slot * format.slot_samples;
      const std::int64_t last = first + format.slot_samples;
      if (next_value * plan.step < last || (paper && end() < last + margin)) {
        break;
      }
      one_slot(first);
      ++slot;
    }
    // Samples and values behind the present slot are done with.
    const std::int64_t first = slot * format.slot_samples;
    const std::int64_t keep_sample =
        std::min(first - margin - 16, next_value * plan.step - static_cast<std::int64_t>(plan.taps_re.size()));
    if (keep_sample - samples_start > 16384) {
      samples.erase(samples.begin(), samples.begin() + (keep_sample - samples_start));
      samples_start = keep_sample;
    }
    const std::int64_t keep_value = first / plan.step - static_cast<std::int64_t>(lead_values()) - 2;
    if (keep_value - values_start > 2048) {
      values.erase(values.begin(), values.begin() + (keep_value - values_start));
      values_start = keep_value;
    }
    std::erase_if(missing, [&](const auto& gap) { return gap.second < first - format.slot_samples; });
  }

  void measure_noise() {
    powers.clear();
    for (const std::complex<float>& value : window) {
      powers.push_back(std::norm(value));
    }
    const auto quarter = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 4);
    std::nth_element(powers.begin(), quarter, powers.end());
    const double now = std::max(static_cast<double>(*quarter) / 0.2877, 1e-14);
    noise = noise < 0.0 ? now : noise + kNoiseMemory * (now - noise);
    noise_now = now;
  }
  double noise_now = 0.0;

  // The values about the slot, their carrier counted from its first sample.
  double cut_window(std::int64_t first) {
    const auto lead = static_cast<std::int64_t>(lead_values());
    const std::int64_t begin = static_cast<std::int64_t>(std::floor(static_cast<double>(first) / plan.step)) - lead;
    const std::int64_t count = format.slot_samples / plan.step + lead;
    window.clear();
    const double turn = -2.0 * kPi * format.pulse_hz / rate.hz;
    std::complex<double> carrier = std::polar(1.0, turn * static_cast<double>(begin * plan.step - first));
    const std::complex<double> step = std::polar(1.0, turn * plan.step);
    for (std::int64_t n = begin; n < begin + count; ++n) {
      const std::complex<float>& value = values[static_cast<std::size_t>(n - values_start)];
      const std::complex<double> turned = carrier * std::complex<double>(value.real(), value.imag());
      window.emplace_back(static_cast<float>(turned.real()), static_cast<float>(turned.imag()));
      carrier *= step;
    }
    return static_cast<double>(begin * plan.step - first) / rate.hz;
  }

  [[nodiscard]] double radiated(double angle) const {
    if (format.radiation.size() < 2) {
      return 1.0;
    }
    const double place = std::clamp(angle / kPi, 0.0, 1.0) * static_cast<double>(format.radiation.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), format.radiation.size() - 2);
    const double u = place - static_cast<double>(below);
    return (1.0 - u) * format.radiation[below] + u * format.radiation[below + 1];
  }

  void one_slot(std::int64_t first) {
    if (format.sources.empty()) {
      return;
    }
    const auto number = static_cast<int>(slot % static_cast<std::int64_t>(format.sources.size()));
    const RangingSource& source = format.sources[static_cast<std::size_t>(number)];
    RangeReading reading;
    reading.source = number;
    reading.receiver = receiver;
    reading.emission = SampleIndex{first};
    // A pulse is heard as a whole: its range is that of the middle of its energy.
    reading.emission_time = Seconds{rate.seconds(SampleIndex{first}).value + source.delay_s + shape->centroid_s()};
    reading.range = reading.envelope_range = reading.phase_range = reading.expected = kNone;
    reading.variance = reading.envelope_variance = reading.expected_variance = kNever;
    const std::int64_t reach = format.slot_samples + static_cast<std::int64_t>(plan.taps_re.size());
    const bool cut = std::any_of(missing.begin(), missing.end(), [&](const auto& gap) {
      return gap.first < first + reach && gap.second > first - static_cast<std::int64_t>(plan.taps_re.size());
    });
    trackers.advance(reading.emission_time.value);
    if (const auto expected = trackers.expect(number)) {
      reading.expected = expected->range;
      reading.expected_variance = expected->variance;
    }
    if (cut) {
      reading.verdict = RangeVerdict::kInterrupted;
      readings.push_back(reading);
      return;
    }
    const double first_value_s = cut_window(first);
    measure_noise();
    if (paper) {
      paper_range(first, source, reading);
    } else {
      envelope_and_carrier(first_value_s, source, reading);
    }
    readings.push_back(reading);
  }

  // Off a source's normal.
  struct Direction {
    double angle = 0.0, sd = kNowhere;  // radians
  };

  [[nodiscard]] static Direction direction(const std::optional<RangeTracker::Expectation>& expected,
                                           const std::optional<RangePrediction>& told) {
    if (told && std::isfinite(told->angle)) {
      return {told->angle, kPoseAngle};
    }
    return expected ? Direction{expected->angle, std::min(kNowhere, expected->angle_sd)} : Direction{};
  }

  // Strength and angle, as the paper has them, from what is known about the geometry.
  void judge(const RangingSource& source, double range, double amplitude, RangeReading& reading,
             const Direction& towards) const {
    double pattern = 0.25;  // where no direction is known: far off the axis, but in sight
    reading.factors.angle = 1.0;
    if (towards.sd < radians(6.0)) {
      // Of the angles that are possible the one that explains the least strength.
      pattern = radiated(std::min(kPi, towards.angle + towards.sd));
      reading.factors.angle = std::clamp((radians(95.0) - towards.angle) / radians(10.0), 0.0, 1.0);
    }
    const double near = std::max(range, 0.05);
    const double strength =
        source.level * format.level_m * pattern / near * std::pow(10.0, -format.absorption_db_m * near / 20.0);
    const double relative = amplitude / (kStrong * strength);
    reading.factors.strength = relative >= 1.0 ? 1.0 : relative * relative * relative * relative;
    reading.snr_db = 10.0 * std::log10(std::max(1e-9, 0.25 * amplitude * amplitude / std::max(noise * 0.5, 1e-30)));
  }

  void envelope_and_carrier(double first_value_s, const RangingSource& source, RangeReading& reading) {
    const double c = format.speed_of_sound;
    const double assumed = std::max(noise, 0.25 * noise_now);
    const FoundPulse found =
        finder.find(window, first_value_s - source.delay_s, std::min(longest_reach, source.reach) / c + 0.2e-3, assumed,
                    parameters.detection);
    if (found.arrivals.empty()) {
      reading.verdict = noise_now > 8.0 * noise ? RangeVerdict::kDisturbed : RangeVerdict::kNothingHeard;
      return;
    }
    const Arrival& arrival = found.arrivals.front();
    const auto expected = trackers.expect(reading.source);
    reading.envelope_range = c * arrival.delay_s;
    reading.envelope_variance = c * c * arrival.delay_variance + kSystematic * kSystematic;
    const double wavelength = c / format.pulse_hz;
    const std::optional<RangePrediction> told = predict ? predict(reading.source, reading.emission_time) : std::nullopt;
    const Direction towards = direction(expected, told);
    const double u = std::min(1.5, towards.angle / (kPi / 3.0));
    const double turn = u * u * (source.phase + source.phase_2 * u);
    // The carrier is counted from the slot's start, the delay from the source's own.
    const double phase = turn - arrival.phase - 2.0 * kPi * format.pulse_hz * source.delay_s;
    reading.phase_range = wrapped(phase / (2.0 * kPi) * wavelength, wavelength);
    // Off the axis the phase turns: by what is calibrated where the direction is known, by nobody knows what else.
    const double slope = u * (2.0 * source.phase + 3.0 * u * source.phase_2) / (kPi / 3.0);
    const double radian = wavelength / (2.0 * kPi);
    const double turn_sd =
        std::hypot(std::abs(slope) * towards.sd * radian, parameters.phase_sd * std::max(1.0, u * u));
    const double phase_variance = arrival.phase_variance * radian * radian + turn_sd * turn_sd;
    judge(source, reading.envelope_range, arrival.amplitude, reading, towards);
    reading.range = reading.envelope_range;
    reading.variance = reading.envelope_variance;
    reading.flight_s = reading.range / c;

    // Continuity: with all that this microphone has heard so far.
    reading.factors.continuity = 1.0;
    if (expected) {
      const double z = std::abs(reading.envelope_range - expected->range) /
                       std::sqrt(expected->variance + reading.envelope_variance + 9e-6);
      reading.factors.continuity = z <= kSurprise ? 1.0 : std::pow(kSurprise / z, 4);
    }
    if (reading.factors.strength < parameters.least_confidence) {
      reading.verdict = RangeVerdict::kTooWeak;
      return;
    }
    if (!expected) {
      trackers.collect(reading.source, reading.emission_time.value, reading.envelope_range, reading.envelope_variance);
      reading.verdict =
          parameters.method == RangingMethod::kEnvelope ? RangeVerdict::kAccepted : RangeVerdict::kAmbiguous;
      if (reading.envelope_range > source.reach) {
        reading.verdict = RangeVerdict::kInconsistent;
      }
      if (parameters.method == RangingMethod::kCarrier && told && reading.envelope_range <= source.reach) {
        (void)resolve(phase_variance, wavelength, told, reading);  // by what a filter predicts, where there is one
      }
      return;
    }
    if (reading.confidence() < parameters.least_confidence || reading.envelope_range > source.reach) {
      reading.verdict = RangeVerdict::kInconsistent;
      trackers.contradict();
      return;
    }
    if (parameters.method == RangingMethod::kEnvelope) {
      reading.verdict = RangeVerdict::kAccepted;
      trackers.update(reading.source, reading.envelope_range, reading.envelope_variance);
      return;
    }
    if (resolve(phase_variance, wavelength, told, reading)) {
      trackers.update(reading.source, reading.range, reading.variance + 0.01e-6);
      watch(reading);
    } else {
      trackers.update(reading.source, reading.envelope_range, reading.envelope_variance);
    }
  }

  // The whole number of cycles that the envelope, what this microphone did so far, and what a filter predicts agree on,
  // if there is only one.
  bool resolve(double phase_variance, double wavelength, const std::optional<RangePrediction>& told,
               RangeReading& reading) {
    // Echoes that overlap, and a shape that is not quite the template's, disturb envelopes beyond their noise.
    const double envelope_variance = kCaution * reading.envelope_variance + phase_variance;
    const bool predicted = told && told->variance < 1e3 && told->variance >= 0.0;
    const double nearest = std::round((reading.envelope_range - reading.phase_range) / wavelength);
    const int reach = 1 + static_cast<int>(std::ceil(4.5 * std::sqrt(envelope_variance) / wavelength));
    double total = 0.0;
    double best = 0.0;
    double best_range = reading.envelope_range;
    for (int k = -reach; k <= reach; ++k) {
      const double range = reading.phase_range + (nearest + k) * wavelength;
      const double off = range - reading.envelope_range;
      double likelihood = std::exp(-0.5 * off * off / envelope_variance) *
                          trackers.likelihood(reading.source, range, phase_variance + kModel * kModel);
      if (predicted) {
        const double left = range - told->range;
        likelihood *= std::exp(-0.5 * left * left / (told->variance + phase_variance));
      }
      total += likelihood;
      if (likelihood > best) {
        best = likelihood;
        best_range = range;
      }
    }
    const double off = best_range - reading.envelope_range;
    const bool certain = total > 0.0 && best >= parameters.certainty * total &&
                         off * off < kFarthest * kFarthest * envelope_variance && phase_variance < kFinest * kFinest;
    if (!certain) {
      reading.verdict = RangeVerdict::kAmbiguous;
      return false;
    }
    reading.verdict = RangeVerdict::kAccepted;
    reading.range = best_range;
    reading.variance = phase_variance;
    reading.flight_s = best_range / format.speed_of_sound;
    return true;
  }

  // Wrong whole cycles show as a mean difference to the envelope, which has none.
  void watch(const RangeReading& reading) {
    Slip& slip = slips[static_cast<std::size_t>(reading.source)];
    const double weight = 1.0 / reading.envelope_variance;
    slip.mean = 0.9 * slip.mean + weight * (reading.envelope_range - reading.range);
    slip.weight = 0.9 * slip.weight + weight;
    const double mean = slip.mean / slip.weight;
    const double sd = 1.0 / std::sqrt(slip.weight);
    if (std::abs(mean) > 3e-3 && std::abs(mean) > kDoubt * sd) {
      trackers.doubt(reading.source);
      slip = {};
    }
  }

  void paper_range(std::int64_t first, const RangingSource& source, RangeReading& reading) {
    const std::size_t margin = paper->margin();
    const std::size_t at = static_cast<std::size_t>(first - static_cast<std::int64_t>(margin) - samples_start);
    const auto found = paper->find(
        std::span<const float>(samples).subspan(at, static_cast<std::size_t>(format.slot_samples) + 2 * margin));
    if (!found) {
      return;
    }
    const double c = format.speed_of_sound;
    reading.range = reading.envelope_range = c * (found->delay_s - source.delay_s);
    reading.flight_s = reading.range / c;
    const auto expected = trackers.expect(reading.source);
    judge(source, reading.range, found->peak, reading, direction(expected, std::nullopt));
    // σ of 2.5 mm at 25 dB, and in inverse proportion to the amplitude.
    const double sd = 2.5e-3 * std::pow(10.0, (25.0 - std::min(45.0, reading.snr_db)) / 20.0);
    reading.variance = reading.envelope_variance = sd * sd + kSystematic * kSystematic;
    reading.factors.continuity = 1.0;
    if (expected) {
      const double z =
          std::abs(reading.range - expected->range) / std::sqrt(expected->variance + reading.variance + 1e-6);
      reading.factors.continuity = z <= kSurprise ? 1.0 : std::pow(kSurprise / z, 4);
    }
    if (reading.factors.strength < parameters.least_confidence) {
      reading.verdict = RangeVerdict::kTooWeak;
    } else if (reading.range > source.reach || reading.range < 0.0 ||
               reading.confidence() < parameters.least_confidence) {
      reading.verdict = RangeVerdict::kInconsistent;
      trackers.contradict();
    } else {
      reading.verdict = RangeVerdict::kAccepted;
      if (expected) {
        trackers.update(reading.source, reading.range, reading.variance);
      } else {
        trackers.collect(reading.source, reading.emission_time.value, reading.range, reading.variance);
      }
    }
  }
};

RangingDecoder::RangingDecoder(const RangingFormat& format, SampleRate rate, int receiver,
                               const RangingParameters& parameters, std::shared_ptr<const PulseShape> shape)
    : impl_(std::make_unique<Impl>(format, rate, receiver, parameters, std::move(shape))) {}
RangingDecoder::~RangingDecoder() = default;
RangingDecoder::RangingDecoder(RangingDecoder&&) noexcept = default;
RangingDecoder& RangingDecoder::operator=(RangingDecoder&&) noexcept = default;

std::shared_ptr<const PulseShape> RangingDecoder::shape() const {
  return impl_->shape;
}

void RangingDecoder::set_prediction(Predict predict) {
  impl_->predict = std::move(predict);
}

void RangingDecoder::push(const float* samples, std::size_t count, std::size_t stride) {
  Impl& d = *impl_;
  while (count > 0) {
    const std::size_t part = std::min<std::size_t>(count, 4096);
    const std::size_t old = d.samples.size();
    d.samples.resize(old + part);
    for (std::size_t i = 0; i < part; ++i) {
      const float sample = samples[i * stride];
      d.samples[old + i] = std::isfinite(sample) ? sample : 0.0F;
    }
    samples += part * stride;
    count -= part;
    d.advance();
  }
}

void RangingDecoder::gap(SampleCount count) {
  if (count.value <= 0) {
    return;
  }
  impl_->missing.emplace_back(impl_->end(), impl_->end() + count.value);
  const std::vector<float> silence(4096, 0.0F);
  for (std::int64_t left = count.value; left > 0; left -= 4096) {
    push(silence.data(), static_cast<std::size_t>(std::min<std::int64_t>(left, 4096)), 1);
  }
}

void RangingDecoder::finish() {
  Impl& d = *impl_;
  const std::int64_t end = d.end();
  const std::vector<float> silence(static_cast<std::size_t>(d.format.slot_samples) + 1024, 0.0F);
  push(silence.data(), silence.size(), 1);
  // Slots that began after the last sample are not there.
  std::erase_if(d.readings, [&](const RangeReading& reading) { return reading.emission.value >= end; });
}

std::vector<RangeReading> RangingDecoder::take_readings() {
  std::vector<RangeReading> readings;
  std::swap(readings, impl_->readings);
  return readings;
}

}  // namespace limbwave::decode
