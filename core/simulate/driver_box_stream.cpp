#include "simulate/driver_box_stream.h"

#include <algorithm>
#include <cmath>
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

Vector3d drawn_vector(Random& random, double sigma) {
  const double x = drawn(random, sigma);
  const double y = drawn(random, sigma);
  const double z = drawn(random, sigma);
  return {x, y, z};
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

// The chips of a board: bias, scale and noise, down to 12-bit readings.
struct DriverBoxStream::Chip {
  Chip(const body::DriverBoxSignal& box, const DriverBoxErrors& all_errors, std::uint64_t seed, int board)
      : errors(all_errors),
        gyroscope_lsb(box.gyroscope_range_rad_s / acquire::kReadingLimit),
        accelerometer_lsb(box.accelerometer_range_g * kStandardGravity / acquire::kReadingLimit),
        frame_s(1.0 / box.word_rate_hz),
        noise(seed, "chip noise " + std::to_string(board)),
        walk(seed, "bias walk " + std::to_string(board)) {
    Random parts(seed, "chip " + std::to_string(board));
    bias = drawn_vector(parts, all_errors.gyroscope_bias);
    gyroscope_scale = drawn_vector(parts, all_errors.gyroscope_scale);
    g_sensitivity = drawn_vector(parts, all_errors.gyroscope_g);
    offset = drawn_vector(parts, all_errors.accelerometer_offset);
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 3; ++column) {
        M(row, column) = row == column ? 1.0 + drawn(parts, all_errors.accelerometer_scale)
                                       : drawn(parts, all_errors.accelerometer_cross_axis);
      }
    }
  }

  int quantised(double value, double lsb, double sigma) {
    const double limit = acquire::kReadingLimit;
    if (!errors.accumulates) {
      const double read = value / lsb + (sigma > 0.0 ? sigma / lsb * noise.normal() : 0.0);
      return static_cast<int>(std::lround(std::clamp(read, -limit, limit - 1.0)));
    }
    int sum = 0;
    for (int i = 0; i < 4; ++i) {
      const double read = 0.25 * value / lsb + 0.5 * sigma / lsb * noise.normal();  // in steps of 10 bits
      sum += static_cast<int>(std::lround(std::clamp(read, -0.25 * limit, 0.25 * limit - 1.0)));
    }
    return sum;
  }

  WordReading read(const ChipTruth& truth) {
    for (Eigen::Index axis = 0; axis < 3 && errors.gyroscope_bias_walk > 0.0; ++axis) {
      bias[axis] += errors.gyroscope_bias_walk * std::sqrt(frame_s) * walk.normal();
    }
    const Vector3d w = truth.w_S + gyroscope_scale.cwiseProduct(truth.w_S) + bias +
                       g_sensitivity.cwiseProduct(truth.f_S) / kStandardGravity;
    const Vector3d f = M * truth.f_S + offset;
    WordReading reading{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      reading[axis] = quantised(w[i], gyroscope_lsb, errors.gyroscope_noise);
      reading[3 + axis] = quantised(f[i], accelerometer_lsb, errors.accelerometer_noise);
    }
    return reading;
  }

  DriverBoxErrors errors;
  double gyroscope_lsb, accelerometer_lsb, frame_s;
  Random noise, walk;
  Vector3d bias, gyroscope_scale, g_sensitivity, offset;
  Eigen::Matrix3d M;
};

DriverBoxStream::~DriverBoxStream() = default;

DriverBoxStream::DriverBoxStream(const body::Rig& rig, std::shared_ptr<const DriverBoxActor> actor,
                                 const DriverBoxErrors& errors, double temperature_c, std::uint64_t seed)
    : box_(rig.driver_box.value()),
      errors_(errors),
      actor_(std::move(actor)),
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
    auto chip = std::make_unique<Chip>(box_, errors, seed, w);
    Chip* const chips = chip.get();
    const auto read = [this, chips, w](double time_s) { return chips->read(actor_->chip(w, std::max(0.0, time_s))); };
    const WordLineErrors word_errors{clock.uniform(-1.0, 1.0) * errors.word_clock, errors.word_drift,
                                     errors.word_bit_errors};
    wires_.push_back(std::unique_ptr<Wire>(
        new Wire{std::move(chip), WordLine(box_.word_rate_hz, word_errors, seed, w, read),
                 Random(seed, "noise " + std::to_string(w)),
                 std::vector<float>(2 * memory_ + 64 * static_cast<std::size_t>(box_.slot_samples)), 0,
                 ears.uniform(0.3, 1.0)}));
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

void DriverBoxStream::emit() {
  const double time = static_cast<double>(position()) / box_.rate_hz;
  const auto number = static_cast<std::size_t>(slot_ % static_cast<std::int64_t>(sources_.size()));
  const SourceTruth& source = sources_[number];
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
  const WornPlace& mount = actor_->sources()[number];
  const FrameJet from = DriverBoxActor::placed(mount, frames_[static_cast<std::size_t>(mount.segment)]);
  const Vector3d s = from.p_W.v;
  const Vector3d normal = from.R_W.v * mount.normal_S;
  PulseTruth truth{position(), static_cast<int>(number), {}};
  for (std::size_t w = 0; w < wires_.size(); ++w) {
    const WornPlace& board = actor_->boards()[w];
    const FrameJet to = DriverBoxActor::placed(board, frames_[static_cast<std::size_t>(board.segment)]);
    // One way of sound: from a point that moves with `velocity` to the moving microphone.
    struct Way {
      double range, rate;
      Vector3d m;
    };
    const auto way = [&](const Vector3d& start, const Vector3d& velocity) {
      double flight = (to.p_W.v - start).norm() / speed_;
      Vector3d m;
      for (int i = 0; i < 6; ++i) {
        m = to.p_W.v + flight * to.p_W.d + 0.5 * flight * flight * to.p_W.dd;
        flight = std::max(kNearest, (m - start).norm()) / speed_;
      }
      const Vector3d u = (m - start).normalized();
      const Vector3d m_velocity = to.p_W.d + flight * to.p_W.dd;
      const double rate = u.dot(m_velocity - velocity) / (1.0 - u.dot(m_velocity) / speed_);
      return Way{flight * speed_, rate, m};
    };
    const auto hear = [&](const Way& along, const Vector3d& leaves, double gain) {
      const double off = std::acos(std::clamp(leaves.dot(normal), -1.0, 1.0));
      const double u = off / kSixtyDegrees;
      const double turn = std::min(1.5, u) * std::min(1.5, u) * (source.phase + source.phase_2 * std::min(1.5, u));
      const double amplitude = gain * source.level * radiated(box_.radiation, off) * box_.source_level_m / along.range *
                               std::pow(10.0, -box_.absorption_db_m * along.range / 20.0);
      // Emission t' seconds after the start is heard at arrival + t' (1 + rate / c).
      add_pulse(*wires_[w], along.range / speed_ + source.delay_s * (1.0 + along.rate / speed_),
                1.0 / (1.0 + along.rate / speed_), amplitude, turn);
    };
    const Way direct = way(s, from.p_W.d);
    const Vector3d leaves = (direct.m - s).normalized();
    const Shade by = shade(s, direct.m, capsules_, wavelength_);
    Way bent = direct;
    bent.range += by.detour;
    hear(bent, leaves, std::pow(10.0, -by.loss_db / 20.0));
    for (const Mirror& mirror : mirrors_) {
      if (mirror.height(s) <= 0.0 || mirror.height(direct.m) <= 0.0) {
        continue;
      }
      const Vector3d image_velocity = from.p_W.d - 2.0 * mirror.normal.dot(from.p_W.d) * mirror.normal;
      const Way echo = way(mirror.image(s), image_velocity);
      if (echo.range > kLongestPath) {
        continue;
      }
      const double a = mirror.height(s);
      const Vector3d hit = s + a / (a + mirror.height(echo.m)) * (mirror.image(echo.m) - s);
      const double loss =
          shade(s, hit, capsules_, wavelength_).loss_db + shade(hit, echo.m, capsules_, wavelength_).loss_db;
      hear(echo, (hit - s).normalized(), mirror.reflection * std::pow(10.0, -loss / 20.0));
    }
    truth.pairs.push_back(
        {direct.range, direct.rate, by.loss_db, std::acos(std::clamp(leaves.dot(normal), -1.0, 1.0))});
  }
  pulses_.push_back(std::move(truth));
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

void DriverBoxStream::next_slot(std::span<std::int16_t> out) {
  if (!sources_.empty()) {
    emit();
  }
  disturb();
  const auto slot = static_cast<std::size_t>(box_.slot_samples);
  const std::size_t wires = wires_.size();
  const auto noise = static_cast<float>(noise_);
  const int below = 16 - box_.bits;  // bits that the converter lacks
  const float steps = static_cast<float>(1 << (box_.bits - 1));
  std::vector<float> line(slot);
  for (std::size_t w = 0; w < wires; ++w) {
    Wire& wire = *wires_[w];
    std::copy_n(wire.sound.begin() + static_cast<std::ptrdiff_t>(wire.head), slot, line.begin());
    advance(wire);
    if (noise_ > 0.0) {
      for (float& sample : line) {
        sample += noise * quick_normal(wire.noise);
      }
    }
    wire.words.add(line.data(), static_cast<int>(slot), box_.rate_hz, box_.word_amplitude);
    for (std::size_t n = 0; n < slot; ++n) {
      const float value = std::clamp(line[n] * steps, -steps, steps - 1.0F);
      out[n * wires + w] = static_cast<std::int16_t>(static_cast<int>(std::lrintf(value)) * (1 << below));
    }
  }
  ++slot_;
}

std::vector<PulseTruth> DriverBoxStream::take_pulses() {
  std::vector<PulseTruth> pulses;
  std::swap(pulses, pulses_);
  return pulses;
}

}  // namespace limbwave::simulate
