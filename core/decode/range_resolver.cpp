#include "decode/range_resolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace limbwave::decode {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kPoseAngle = 0.06;    // radians, of one that a pose filter tells
constexpr double kDoubt = 4.0;         // standard deviations of the mean of envelope minus carrier
constexpr double kPairForgets = 0.7;   // seconds
constexpr double kOverload = 0.85;     // of full scale: from there on the shape is not the pulse's, but the phase is
constexpr double kOverloaded = 0.020;  // metres
constexpr double kBones = 0.025;       // metres, by which boards and bones are not where they are thought to be
constexpr double kElsewhere = 3.0;     // standard deviations from where the skeleton puts a board
constexpr double kOtherFrame = 0.010;  // metres, of a range in a frame that its source moves in

// What an echo that is not told apart does, by the energy that it leaves (over the noise's) in shape and turn: it may
// shift the envelope by as much energy again, and the phase.
constexpr double kEchoDelay = 4.0, kEchoPhase = 0.9;
constexpr double kTurnNoise = 4.5;
constexpr double kUsualRate = 1.6, kRateSd = 0.2;  // m/s: where nothing is expected; beside what is said of what is

double wrapped(double value, double period) {
  return value - period * std::floor(value / period);
}

}  // namespace

RangeResolver::RangeResolver(SampleRate rate, int receiver, const std::vector<RangingFrame>& frames,
                             const RangingParameters& parameters, double centroid_s)
    : format_(frames.front().format),
      rate_(rate),
      receiver_(receiver),
      parameters_(parameters),
      centroid_s_(centroid_s),
      wavelength_(format_.speed_of_sound / format_.pulse_hz),
      frame_of_(format_.sources.size(), 0),
      stretch_(static_cast<std::size_t>(
          std::max(0.0, std::ceil(parameters.look_ahead_s * rate.hz / format_.slot_samples)))) {
  const Followed::Pair pair{CycleTracker(wavelength_, parameters_.stray, parameters_.stray_m)};
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto& [format, geometry] = frames[f];
    const auto w = static_cast<std::size_t>(receiver);
    const Eigen::Quaterniond rest =
        w < geometry.R_CS_rest.size() ? geometry.R_CS_rest[w] : Eigen::Quaterniond::Identity();
    const Eigen::Vector3d origin = geometry.reference >= 0 ? geometry.reference_place : Eigen::Vector3d::Zero();
    frames_.push_back(
        {RangeTracker(format, parameters, rest, origin), std::vector<Followed::Pair>(format.sources.size(), pair)});
    for (std::size_t s = 0; s < format.sources.size(); ++s) {
      frame_of_[s] = format.sources[s].fixed && frame_of_[s] == 0 ? f : frame_of_[s];
    }
  }
}

void RangeResolver::Followed::pass_on() {
  if (!tracker.corrected()) {
    return;
  }
  for (std::size_t s = 0; s < pairs.size(); ++s) {
    if (pairs[s].cycles.running()) {
      pairs[s].cycles.shift(-tracker.correction_of(static_cast<int>(s), pairs[s].place));
    }
  }
  tracker.forget_corrections();
}

RangeReading RangeResolver::blank(const HeardSlot& heard) const {
  RangeReading reading;
  reading.source = heard.source;
  reading.receiver = receiver_;
  reading.emission = SampleIndex{heard.slot * format_.slot_samples};
  // A pulse is heard as a whole: its range is that of the middle of its energy.
  reading.emission_time = Seconds{rate_.seconds(reading.emission).value +
                                  format_.sources[static_cast<std::size_t>(heard.source)].delay_s + centroid_s_};
  reading.range = reading.envelope_range = reading.phase_range = reading.expected = kNone;
  reading.variance = reading.envelope_variance = reading.expected_variance = kNever;
  return reading;
}

void RangeResolver::add(const HeardSlot& heard, std::vector<TrackerStep> steps) {
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    frames_[f].tracker.advance(steps[f]);
    frames_[f].pass_on();
  }
  Guess guess;
  const RangeReading reading = judge(heard, steps, frames_, true, guess);
  if (stretch_ == 0 || parameters_.method == RangingMethod::kPaper) {
    readings_.push_back(reading);
    return;
  }
  kept_.push_back({heard, std::move(steps), reading, guess});
  if (kept_.size() >= 3 * stretch_) {
    settle(2 * stretch_);
  }
}

void RangeResolver::finish() {
  settle(kept_.size());
}

// Backward over all that is kept, to the first `count` of them, which then are done.
void RangeResolver::settle(std::size_t count) {
  Frames back = frames_;
  for (Followed& frame : back) {
    frame.tracker.turn_round();
    frame.tracker.forget_corrections();
    for (Followed::Pair& pair : frame.pairs) {
      pair.cycles.stop();
      pair.counted = pair.fixed = false;
    }
  }
  for (std::size_t i = kept_.size(); i-- > 0;) {
    Kept& kept = kept_[i];
    for (std::size_t f = 0; f < back.size(); ++f) {
      back[f].tracker.sit(kept.steps[f].board);
    }
    Guess guess;
    const RangeReading reading = judge(kept.heard, kept.steps, back, false, guess);
    if (i < count) {
      kept.reading = better(kept, reading, guess);
    }
    for (std::size_t f = 0; f < back.size(); ++f) {
      back[f].tracker.retreat(kept.steps[f]);
    }
  }
  for (; count > 0; --count) {
    readings_.push_back(kept_.front().reading);
    kept_.pop_front();
  }
}

RangeReading RangeResolver::judge(const HeardSlot& heard, const std::vector<TrackerStep>& steps, Frames& frames,
                                  bool forward, Guess& guess) {
  const std::size_t own = frame_of_[static_cast<std::size_t>(heard.source)];
  const TrackerStep& step = steps[own];
  Followed& followed = frames[own];
  RangeTracker& tracker = followed.tracker;
  RangeReading reading = blank(heard);
  if (const auto expected = tracker.expect(heard.source, step.source)) {
    reading.expected = expected->range;
    reading.expected_variance = expected->variance;
  }
  if (heard.cut) {
    reading.verdict = RangeVerdict::kInterrupted;
  } else if (parameters_.method == RangingMethod::kPaper) {
    by_paper(heard, step, tracker, reading);
  } else if (heard.count == 0) {
    reading.verdict = heard.noise_now > 8.0 * heard.noise ? RangeVerdict::kDisturbed : RangeVerdict::kNothingHeard;
  } else {
    by_envelope(heard, step, followed, forward, reading, guess);
  }
  tell_others(reading, steps, frames, own);
  return reading;
}

// Frames in which the source moves learn about where it is, coarsely: segments between them have no boards.
void RangeResolver::tell_others(const RangeReading& reading, const std::vector<TrackerStep>& steps, Frames& frames,
                                std::size_t own) const {
  if (reading.verdict != RangeVerdict::kAccepted && reading.verdict != RangeVerdict::kAmbiguous) {
    return;
  }
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (f == own) {
      continue;
    }
    RangeTracker& tracker = frames[f].tracker;
    const double variance = reading.variance + kOtherFrame * kOtherFrame;
    const auto expected = tracker.expect(reading.source, steps[f].source);
    const double off = expected ? reading.range - expected->range : 0.0;
    if (expected && off * off < kSurprise * kSurprise * (expected->variance + variance)) {
      tracker.update(reading.source, steps[f].source, reading.range, variance);
      frames[f].pass_on();
    }
    tracker.collect(reading.source, steps[f].source, reading.range, variance);
  }
}

// Where the skeleton sees the microphone from the source that fires.
std::optional<RangeResolver::Direction> RangeResolver::by_skeleton(const TrackerStep& step) {
  const Eigen::Vector3d way = step.board.place - step.source.place;
  const double distance = way.norm();
  if (!step.board.placed || distance < 0.02) {
    return std::nullopt;
  }
  const double angle = std::acos(std::clamp(way.dot(step.source.normal) / distance, -1.0, 1.0));
  return Direction{angle, std::min(kNowhere, std::hypot(step.board.place_sd, kBones) / distance)};
}

// What an echo that is not told apart leaves: in the pulse's shape, and in how its carrier turns, which the
// microphone's movement has to explain. Energy over the noise's.
double RangeResolver::misfit_of(const Arrival& arrival,
                                const std::optional<RangeTracker::Expectation>& expected) const {
  const double per_speed = 2.0 * kPi / wavelength_;
  const double turn = expected ? -per_speed * expected->rate : 0.0;
  const double rate_variance = expected ? expected->P(1, 1) + kRateSd * kRateSd : kUsualRate * kUsualRate;
  const double variance = arrival.doppler_variance + per_speed * per_speed * rate_variance;
  const double off = arrival.doppler - turn;
  // A real value has half the noise.
  return arrival.misfit + std::max(0.0, 0.5 * off * off / variance - kTurnNoise);
}

void RangeResolver::by_envelope(const HeardSlot& heard, const TrackerStep& step, Followed& followed, bool forward,
                                RangeReading& reading, Guess& guess) {
  RangeTracker& tracker = followed.tracker;
  const RangingSource& source = format_.sources[static_cast<std::size_t>(heard.source)];
  const double c = format_.speed_of_sound;
  const auto expected = tracker.expect(heard.source, step.source);
  const std::optional<RangePrediction> told = predict_ ? predict_(reading.source, reading.emission_time) : std::nullopt;
  const Arrival& arrival = straight(heard, expected);
  const double misfit = misfit_of(arrival, expected);
  reading.envelope_range = c * arrival.delay_s;
  reading.envelope_variance = c * c * arrival.delay_variance * (1.0 + kEchoDelay * misfit) + kSystematic * kSystematic;
  if (arrival.amplitude > kOverload) {
    reading.envelope_variance += kOverloaded * kOverloaded;
  }
  Direction towards{0.0, kNowhere};
  if (told && std::isfinite(told->angle)) {
    towards = {told->angle, kPoseAngle};
  } else if (expected) {
    towards = {expected->angle, std::min(kNowhere, expected->angle_sd)};
  }
  const std::optional<Direction> worn = by_skeleton(step);
  if (worn && worn->sd < towards.sd) {
    towards = *worn;
  }
  const double u = std::min(1.5, towards.angle / (kPi / 3.0));
  const double turn = u * u * (source.phase + source.phase_2 * u);
  // The carrier is counted from the slot's start, the delay from the source's own.
  const double phase = turn - arrival.phase - 2.0 * kPi * format_.pulse_hz * source.delay_s;
  reading.phase_range = wrapped(phase / (2.0 * kPi) * wavelength_, wavelength_);
  // Off the axis the phase turns: by what is calibrated where the direction is known, by nobody knows what else.
  const double slope = u * (2.0 * source.phase + 3.0 * u * source.phase_2) / (kPi / 3.0);
  const double radian = wavelength_ / (2.0 * kPi);
  const double turn_sd = std::hypot(std::abs(slope) * towards.sd * radian, parameters_.phase_sd * std::max(1.0, u * u));
  const double phase_variance =
      arrival.phase_variance * (1.0 + kEchoPhase * misfit) * radian * radian + turn_sd * turn_sd;
  weigh(source, reading.envelope_range, arrival.amplitude, heard.noise, towards, worn, reading);
  reading.range = reading.envelope_range;
  reading.variance = reading.envelope_variance;
  reading.flight_s = reading.range / c;
  // Continuity: with all that this microphone has heard and felt so far.
  reading.factors.continuity = 1.0;
  if (expected) {
    const double z = std::abs(reading.envelope_range - expected->range) /
                     std::sqrt(expected->variance + reading.envelope_variance + 9e-6);
    reading.factors.continuity = z <= kSurprise ? 1.0 : std::pow(kSurprise / z, 4);
  }
  if (step.board.placed) {
    // Who is far from where the skeleton can put him has been heard by way of a wall.
    const double z = std::abs(reading.envelope_range - (step.board.place - step.source.place).norm()) /
                     std::hypot(step.board.place_sd, kBones);
    reading.factors.continuity *= z <= kElsewhere ? 1.0 : std::pow(kElsewhere / z, 4);
  }
  if (reading.factors.strength < parameters_.least_confidence) {
    reading.verdict = RangeVerdict::kTooWeak;
    return;
  }
  if (reading.confidence() < parameters_.least_confidence || reading.envelope_range > source.reach) {
    reading.verdict = RangeVerdict::kInconsistent;
    tracker.contradict();
    return;
  }
  if (parameters_.method == RangingMethod::kEnvelope) {
    reading.verdict = RangeVerdict::kAccepted;
    tracker.update(reading.source, step.source, reading.envelope_range, reading.envelope_variance);
    tracker.collect(reading.source, step.source, reading.envelope_range, reading.envelope_variance);
    return;
  }
  tracker.collect(reading.source, step.source, reading.envelope_range, reading.envelope_variance);
  reading.verdict = RangeVerdict::kAmbiguous;
  if (!expected) {
    return;
  }
  const CycleResult result = resolve(phase_variance, step, *expected, told, reading, followed);
  guess = {result.range, result.failure, phase_variance};
  reading.carrier_range = result.range;
  reading.failure = result.failure;
  const double off = result.range - reading.envelope_range;
  const bool near =
      off * off <= kFarthest * kFarthest * (parameters_.caution * reading.envelope_variance + phase_variance);
  if (near && result.failure <= parameters_.failure && phase_variance < parameters_.finest * parameters_.finest) {
    reading.verdict = RangeVerdict::kAccepted;
    reading.range = result.range;
    reading.variance = phase_variance;
    reading.flight_s = result.range / c;
    if (forward) {
      watch(reading);
    }
  }
  follow(result, phase_variance, step.source, reading, followed);
  followed.pass_on();
}

// What the microphone's tracker learns of it. Cycles whose number is not known tell, once they are followed from pulse
// to pulse, how the range changes as finely as known ones; what is wrong with their number is a state until it is
// known.
void RangeResolver::follow(const CycleResult& result, double phase_variance, const SourceStep& step,
                           const RangeReading& reading, Followed& followed) const {
  RangeTracker& tracker = followed.tracker;
  Followed::Pair& pair = followed.pairs[static_cast<std::size_t>(reading.source)];
  const double fine = phase_variance + 0.01e-6;
  const bool went_on = pair.counted && result.moved_failure <= parameters_.failure;
  if (reading.verdict == RangeVerdict::kAccepted) {
    if (went_on && !pair.fixed) {
      tracker.fix(reading.source, static_cast<double>(pair.count + result.moved - result.cycles) * wavelength_);
    }
    pair.counted = pair.fixed = true;
    pair.count = result.cycles;
    tracker.update(reading.source, step, reading.range, fine);
    return;
  }
  if (went_on) {
    pair.count += result.moved;
  } else {
    pair.counted = pair.cycles.running();
    pair.fixed = false;
    pair.count = result.cycles;
    tracker.set_floating(reading.source);
  }
  if (pair.counted) {
    tracker.update(reading.source, step, reading.phase_range + static_cast<double>(pair.count) * wavelength_, fine,
                   !pair.fixed);
  }
  if (!pair.fixed) {
    tracker.update(reading.source, step, reading.envelope_range, parameters_.caution * reading.envelope_variance);
  }
}

CycleResult RangeResolver::resolve(double phase_variance, const TrackerStep& step,
                                   const RangeTracker::Expectation& expected,
                                   const std::optional<RangePrediction>& told, const RangeReading& reading,
                                   Followed& followed) const {
  Followed::Pair& pair = followed.pairs[static_cast<std::size_t>(reading.source)];
  const double dt = step.source.time_s - pair.time_s;
  if (pair.cycles.running() && std::abs(dt) < kPairForgets) {
    const double jerk = std::sqrt(std::max(0.0, followed.tracker.jerk_sum() - pair.jerk_sum) / std::abs(dt));
    pair.cycles.advance(dt, RangeTracker::memory_s(), jerk, RangeTracker::velocity_walk(),
                        followed.tracker.wander_sum(reading.source) - pair.wander_sum);
  } else {
    Eigen::Matrix3d P = 1.5 * expected.P;
    P(0, 0) += 0.25e-6;
    P(1, 1) += 1e-4;
    P(2, 2) += 0.04;
    pair.cycles.start(P);
    pair.counted = pair.fixed = false;
  }
  pair.time_s = step.source.time_s;
  pair.jerk_sum = followed.tracker.jerk_sum();
  pair.wander_sum = followed.tracker.wander_sum(reading.source);
  pair.place = step.source.place;
  CycleReading r;
  r.nominal = expected.range;
  r.envelope = reading.envelope_range;
  r.envelope_variance = parameters_.caution * reading.envelope_variance + phase_variance;
  r.phase = reading.phase_range;
  r.phase_variance = phase_variance;
  if (told && told->variance < 1e3 && told->variance >= 0.0) {
    r.told = told->range;
    r.told_variance = told->variance;
  }
  return pair.cycles.take(r);
}

// Wrong whole cycles show as a mean difference to the envelope, which has none.
void RangeResolver::watch(const RangeReading& reading) {
  const double weight = 1.0 / reading.envelope_variance;
  slip_.mean = 0.95 * slip_.mean + weight * (reading.envelope_range - reading.range);
  slip_.weight = 0.95 * slip_.weight + weight;
  const double mean = slip_.mean / slip_.weight;
  const double sd = 1.0 / std::sqrt(slip_.weight);
  if (std::abs(mean) > 3e-3 && std::abs(mean) > kDoubt * sd) {
    for (Followed& frame : frames_) {
      frame.tracker.doubt();
      for (Followed::Pair& pair : frame.pairs) {
        pair.cycles.stop();
        pair.counted = pair.fixed = false;
      }
    }
    slip_ = {};
  }
}

std::vector<RangeReading> RangeResolver::take() {
  std::vector<RangeReading> readings;
  std::swap(readings, readings_);
  return readings;
}

}  // namespace limbwave::decode
