#include "simulate/driver_box_stream.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

constexpr double kHumidity = 0.5;
constexpr double kLongestPath = 6.0;  // metres; further echoes are not heard
constexpr double kDisturbance = 0.7;  // seconds that one lasts at most
constexpr double kNearest = 0.02;     // metres; nothing is nearer to a source
constexpr double kReferenceRange = 0.6;
constexpr double kBand = 5000.0;  // Hz, of the SNR's definition
constexpr double kSixtyDegrees = kPi / 3.0;

// Nearly normal: the sum of eight uniform numbers of 16 bits, out to 4.9 standard deviations. Filters make it normal.
float quick_normal(Random& random) {
  float sum = 0.0F;
  for (int half = 0; half < 2; ++half) {
    std::uint64_t bits = random.bits();
    for (int i = 0; i < 4; ++i, bits >>= 16U) {
      sum += static_cast<float>(bits & 0xFFFFU);
    }
  }
  constexpr float kMean = 8.0F * 32767.5F;
  constexpr float kDeviation = 53509.6F;  // sqrt(8 (65536² − 1) / 12)
  return (sum - kMean) / kDeviation;
}

double drawn(Random& random, double sigma) {
  return sigma * std::clamp(random.normal(), -3.0, 3.0);
}

double radiated(const std::vector<double>& radiation, double angle) {
  const double place = std::clamp(angle * 18.0 / kPi, 0.0, 18.0);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(place), 17);
  // Smooth between the table's angles, so that amplitudes have no corners in time.
  const double x = place - static_cast<double>(below);
  const double s = x * x * (3.0 - 2.0 * x);
  return radiation[below] + s * (radiation[below + 1] - radiation[below]);
}

}  // namespace

double air_speed_of_sound(double temperature_c, double relative_humidity) {
  const double saturation = 0.0062 * std::exp(17.5 * temperature_c / (temperature_c + 241.0));  // mole fraction
  return 331.3 * std::sqrt(1.0 + temperature_c / 273.15) * (1.0 + 0.16 * saturation * relative_humidity);
}

DriverBoxStream::~DriverBoxStream() = default;

DriverBoxStream::DriverBoxStream(const body::Rig& rig, std::shared_ptr<const DriverBoxActor> actor,
                                 const DriverBoxErrors& errors, double temperature_c, std::uint64_t seed)
    : box_(rig.driver_box.value()),
      errors_(errors),
      actor_(std::move(actor)),
      crew_(std::make_unique<Crew>(1)),
      pulse_(box_),
      entered_(air_speed_of_sound(temperature_c, kHumidity)),
      keys_(seed, "keys"),
      brakes_(seed, "brakes"),
      next_key_s_(INFINITY),
      next_brake_s_(INFINITY) {
  Random air(seed, "speed of sound");
  speed_ = entered_ * (1.0 + (air.uniform() < 0.5 ? -1.0 : 1.0) * errors.speed_of_sound);
  wavelength_ = speed_ / box_.pulse_hz;
  if (errors.snr_db < 299.0) {
    const double peak =
        box_.source_level_m / kReferenceRange * std::pow(10.0, -box_.absorption_db_m * kReferenceRange / 20.0);
    const double in_band = 0.5 * peak * peak * std::pow(10.0, -errors.snr_db / 10.0);
    noise_ = std::sqrt(in_band * 0.5 * box_.rate_hz / kBand);
  }
  schedule_.resize(std::max<std::size_t>(1, rig.sources.size()));
  std::iota(schedule_.begin(), schedule_.end(), std::uint8_t{0});
  Random delays(seed, "source delay");
  Random curves(seed, "source phase");
  Random levels(seed, "source level");
  for (std::size_t s = 0; s < rig.sources.size(); ++s) {
    SourceTruth source;
    source.delay_s = delays.uniform(-1.0, 1.0) * errors.source_delay;
    const double shape = curves.uniform(-0.4, 0.4);
    const double total = curves.uniform(-1.0, 1.0) * errors.phase_off_axis;
    source.phase = total * (1.0 - shape);
    source.phase_2 = total * shape;
    source.level = std::pow(10.0, drawn(levels, errors.source_level_db) / 20.0);
    sources_.push_back(source);
  }
  const bool disturbed = errors.keys_per_minute > 0.0 || errors.brakes_per_minute > 0.0;
  const double ahead = kLongestPath / speed_ + 2.0 * pulse_.length() + (disturbed ? kDisturbance : 0.0);
  memory_ = static_cast<std::size_t>(ahead * box_.rate_hz) + static_cast<std::size_t>(box_.slot_samples);
  Random ears(seed, "ears");
  for (int w = 0; w < static_cast<int>(rig.microphones.size()); ++w) {
    Random clock(seed, "word clock " + std::to_string(w));
    auto chip = std::make_unique<BoardChip>(box_, errors, seed, w);
    BoardChip* const chips = chip.get();
    const auto read = [this, chips, w](double time_s) { return chips->read(actor_->chip(w, std::max(0.0, time_s))); };
    const WordLineErrors word_errors{clock.uniform(-1.0, 1.0) * errors.word_clock, errors.word_drift,
                                     errors.word_bit_errors};
    wires_.push_back(std::unique_ptr<Wire>(
        new Wire{std::move(chip),
                 WordLine(box_.word_rate_hz, word_errors, seed, w, read),
                 Random(seed, "noise " + std::to_string(w)),
                 std::vector<float>(2 * memory_ + 64 * static_cast<std::size_t>(box_.slot_samples)),
                 0,
                 ears.uniform(0.3, 1.0),
                 {}}));
  }
  if (errors.floor_echo > 0.0) {
    mirrors_.push_back({Vector3d::UnitZ(), 0.0, errors.floor_echo});
  }
  if (errors.wall_echo > 0.0) {
    mirrors_.push_back({-Vector3d::UnitX(), -2.2, errors.wall_echo});
    mirrors_.push_back({-Vector3d::UnitY(), -1.8, errors.wall_echo});
  }
  if (errors.keys_per_minute > 0.0) {
    next_key_s_ = -std::log(1.0 - keys_.uniform()) * 60.0 / errors.keys_per_minute;
  }
  if (errors.brakes_per_minute > 0.0) {
    next_brake_s_ = -std::log(1.0 - brakes_.uniform()) * 60.0 / errors.brakes_per_minute;
  }
}

// `arrival_s` counts from the present slot's first sample.
void DriverBoxStream::add_pulse(Wire& wire, double arrival_s, double rate_of_time, double amplitude, double phase) {
  const auto first = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(arrival_s * box_.rate_hz)));
  const auto count = static_cast<std::int64_t>(std::ceil(pulse_.length() / rate_of_time * box_.rate_hz)) + 1;
  if (amplitude < 1e-7 || first + count >= static_cast<std::int64_t>(room(wire))) {
    return;
  }
  pulse_.add(wire.sound.data() + wire.head + first, static_cast<int>(count),
             static_cast<double>(first) / box_.rate_hz - arrival_s, 1.0 / box_.rate_hz, rate_of_time, amplitude, phase);
}

// Where everything is when the slot begins, and who fires; the wires then hear it, each for itself.
void DriverBoxStream::emit() {
  emission_.number = schedule_[static_cast<std::size_t>(slot_ % static_cast<std::int64_t>(schedule_.size()))];
  if (emission_.number >= sources_.size()) {
    return;
  }
  const double time = static_cast<double>(position()) / box_.rate_hz;
  actor_->frames(time, frames_);
  capsules_.clear();
  if (errors_.occlusion) {
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      for (const body::Capsule& capsule : actor_->skeleton().segments[i].capsules) {
        const Quaterniond& R = frames_[i].R_W.v;
        const Vector3d& p = frames_[i].p_W.v;
        capsules_.push_back({p + R * capsule.from_L, p + R * capsule.to_L, capsule.radius});
      }
    }
  }
  const WornPlace& mount = actor_->sources()[emission_.number];
  emission_.from = DriverBoxActor::placed(mount, frames_[static_cast<std::size_t>(mount.segment)]);
  emission_.normal = emission_.from.R_W.v * mount.normal_S;
  pulses_.push_back({position(), static_cast<int>(emission_.number), std::vector<PairTruth>(wires_.size())});
}

// One way of sound: from a point that moves with `velocity` to the moving microphone.
struct DriverBoxStream::Way {
  double range, rate;
  Vector3d m;
};

DriverBoxStream::Way DriverBoxStream::way(const Vector3d& start, const Vector3d& velocity, const FrameJet& to) const {
  double flight = (to.p_W.v - start).norm() / speed_;
  Vector3d m;
  for (int i = 0; i < 6; ++i) {
    m = to.p_W.v + flight * to.p_W.d + 0.5 * flight * flight * to.p_W.dd;
    flight = std::max(kNearest, (m - start).norm()) / speed_;
  }
  const Vector3d u = (m - start).normalized();
  const Vector3d m_velocity = to.p_W.d + flight * to.p_W.dd;
  const double rate = u.dot(m_velocity - velocity) / (1.0 - u.dot(m_velocity) / speed_);
  return {flight * speed_, rate, m};
}

void DriverBoxStream::hear(std::size_t w, const Way& along, const Vector3d& leaves, double gain) {
  const SourceTruth& source = sources_[emission_.number];
  const double off = std::acos(std::clamp(leaves.dot(emission_.normal), -1.0, 1.0));
  const double u = std::min(1.5, off / kSixtyDegrees);
  const double turn = u * u * (source.phase + source.phase_2 * u);
  const double amplitude = gain * source.level * radiated(box_.radiation, off) * box_.source_level_m / along.range *
                           std::pow(10.0, -box_.absorption_db_m * along.range / 20.0);
  // Emission t' seconds after the start is heard at arrival + t' (1 + rate / c).
  add_pulse(*wires_[w], along.range / speed_ + source.delay_s * (1.0 + along.rate / speed_),
            1.0 / (1.0 + along.rate / speed_), amplitude, turn);
}

void DriverBoxStream::receive(std::size_t w) {
  const Vector3d s = emission_.from.p_W.v;
  const WornPlace& board = actor_->boards()[w];
  const FrameJet to = DriverBoxActor::placed(board, frames_[static_cast<std::size_t>(board.segment)]);
  const Way direct = way(s, emission_.from.p_W.d, to);
  const Vector3d leaves = (direct.m - s).normalized();
  const Shade by = shade(s, direct.m, capsules_, wavelength_);
  Way bent = direct;
  bent.range += by.detour;
  hear(w, bent, leaves, std::pow(10.0, -by.loss_db / 20.0));
  for (const Mirror& mirror : mirrors_) {
    if (mirror.height(s) <= 0.0 || mirror.height(direct.m) <= 0.0) {
      continue;
    }
    const Vector3d image_velocity =
        emission_.from.p_W.d - 2.0 * mirror.normal.dot(emission_.from.p_W.d) * mirror.normal;
    const Way echo = way(mirror.image(s), image_velocity, to);
    if (echo.range > kLongestPath) {
      continue;
    }
    const double a = mirror.height(s);
    const Vector3d hit = s + a / (a + mirror.height(echo.m)) * (mirror.image(echo.m) - s);
    const double loss =
        shade(s, hit, capsules_, wavelength_).loss_db + shade(hit, echo.m, capsules_, wavelength_).loss_db;
    hear(w, echo, (hit - s).normalized(), mirror.reflection * std::pow(10.0, -loss / 20.0));
  }
  pulses_.back().pairs[w] = {direct.range, direct.rate, by.loss_db,
                             std::acos(std::clamp(leaves.dot(emission_.normal), -1.0, 1.0))};
}

void DriverBoxStream::advance(Wire& wire) const {
  wire.head += static_cast<std::size_t>(box_.slot_samples);
  if (room(wire) < memory_) {  // back to the front, once in a while
    const auto rest = wire.sound.begin() + static_cast<std::ptrdiff_t>(wire.head);
    std::fill(std::copy(rest, wire.sound.end(), wire.sound.begin()), wire.sound.end(), 0.0F);
    wire.head = 0;
  }
}

// What rings and squeaks begins in this slot and goes on in the rings of all wires.
void DriverBoxStream::disturb() {
  const double start = static_cast<double>(position()) / box_.rate_hz;
  const double end = start + box_.slot_samples / box_.rate_hz;
  while (next_key_s_ < end) {
    // A jingle: clicks in quick succession, each a decaying tone of a random pitch.
    const int clicks = 5 + static_cast<int>(keys_.uniform() * 30.0);
    double at = std::max(0.0, next_key_s_ - start);
    for (int c = 0; c < clicks; ++c) {
      at += keys_.uniform(0.001, 0.015);
      const double pitch = keys_.uniform(25e3, 60e3);
      const double decay = keys_.uniform(0.1e-3, 0.6e-3);
      const double level = 0.08 * keys_.uniform(0.2, 1.0);
      const auto first = static_cast<std::size_t>(at * box_.rate_hz);
      for (const auto& wire : wires_) {
        const double phase = keys_.uniform(0.0, 2.0 * kPi);
        for (std::size_t n = 0; n < 400 && first + n < room(*wire); ++n) {
          const double t = static_cast<double>(n) / box_.rate_hz;
          wire->sound[wire->head + first + n] +=
              static_cast<float>(wire->ear * level * std::exp(-t / decay) * std::sin(2.0 * kPi * pitch * t + phase));
        }
      }
    }
    next_key_s_ -= std::log(1.0 - keys_.uniform()) * 60.0 / errors_.keys_per_minute;
  }
  while (next_brake_s_ < end) {
    const double length = brakes_.uniform(0.1, 0.5);
    const double pitch = brakes_.uniform(37e3, 43e3);
    const double level = 0.05 * brakes_.uniform(0.2, 1.0);
    const auto first = static_cast<std::size_t>(std::max(0.0, next_brake_s_ - start) * box_.rate_hz);
    for (const auto& wire : wires_) {
      const double phase = brakes_.uniform(0.0, 2.0 * kPi);
      for (std::size_t n = 0; first + n < room(*wire); ++n) {
        const double t = static_cast<double>(n) / box_.rate_hz;
        if (t > length) {
          break;
        }
        const double fade = std::sin(kPi * t / length);
        wire->sound[wire->head + first + n] +=
            static_cast<float>(wire->ear * level * fade * std::sin(2.0 * kPi * (pitch + 500.0 * t) * t + phase));
      }
    }
    next_brake_s_ -= std::log(1.0 - brakes_.uniform()) * 60.0 / errors_.brakes_per_minute;
  }
}

// What one wire carries in this slot.
void DriverBoxStream::sample(std::size_t w, std::span<std::int16_t> out) {
  const auto slot = static_cast<std::size_t>(box_.slot_samples);
  const auto noise = static_cast<float>(noise_);
  const int below = 16 - box_.bits;  // bits that the converter lacks
  const float steps = static_cast<float>(1 << (box_.bits - 1));
  Wire& wire = *wires_[w];
  std::vector<float>& line = wire.line;
  line.assign(wire.sound.begin() + static_cast<std::ptrdiff_t>(wire.head),
              wire.sound.begin() + static_cast<std::ptrdiff_t>(wire.head + slot));
  advance(wire);
  if (noise_ > 0.0) {
    for (float& value : line) {
      value += noise * quick_normal(wire.noise);
    }
  }
  wire.words.add(line.data(), static_cast<int>(slot), box_.rate_hz, box_.word_amplitude);
  for (std::size_t n = 0; n < slot; ++n) {
    const float value = std::clamp(line[n] * steps, -steps, steps - 1.0F);
    out[n * wires_.size() + w] = static_cast<std::int16_t>(static_cast<int>(std::lrintf(value)) * (1 << below));
  }
}

void DriverBoxStream::next_slot(std::span<std::int16_t> out) {
  emission_.number = SIZE_MAX;
  if (!sources_.empty()) {
    emit();
  }
  disturb();
  const bool fired = emission_.number < sources_.size();
  crew_->each(wires_.size(), [&](std::size_t w) {
    if (fired) {
      receive(w);
    }
    sample(w, out);
  });
  ++slot_;
}

void DriverBoxStream::set_threads(int threads) {
  crew_ = std::make_unique<Crew>(std::max(1, threads));
}

void DriverBoxStream::set_schedule(const std::vector<std::uint8_t>& schedule) {
  assert(!schedule.empty());
  schedule_ = schedule;
}

std::vector<PulseTruth> DriverBoxStream::take_pulses() {
  std::vector<PulseTruth> pulses;
  std::swap(pulses, pulses_);
  return pulses;
}

}  // namespace limbwave::simulate
