#include "simulate/body_readings.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "simulate/random.h"

namespace limbwave::simulate {
namespace {

constexpr double kSpeedOfSound = 343.0;
constexpr double kNoiseFreeSnr = 200.0;

double draw(Random& random, double sigma) {
  return sigma * std::clamp(random.normal(), -3.0, 3.0);
}
Vector3d draw_vector(Random& random, double sigma) {
  const double x = draw(random, sigma);
  const double y = draw(random, sigma);
  return {x, y, draw(random, sigma)};
}

// One board's chips: reading = M truth + offset + noise.
struct Chips {
  Eigen::Matrix3d gyroscope, accelerometer, g_sensitivity;
  Vector3d bias, offset;
};

Chips draw_chips(const DriverBoxErrors& errors, std::uint64_t seed, const std::string& board) {
  Random scale(seed, board + " scale");
  Random cross(seed, board + " cross axis");
  Random offset(seed, board + " offset");
  Chips chips;
  for (Eigen::Index r = 0; r < 3; ++r) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      chips.gyroscope(r, c) = r == c ? 1.0 + draw(scale, errors.gyroscope_scale) : 0.0;
      chips.accelerometer(r, c) =
          r == c ? 1.0 + draw(scale, errors.accelerometer_scale) : draw(cross, errors.accelerometer_cross_axis);
      chips.g_sensitivity(r, c) = draw(cross, errors.gyroscope_g);
    }
  }
  chips.bias = draw_vector(offset, errors.gyroscope_bias);
  chips.offset = draw_vector(offset, errors.accelerometer_offset);
  return chips;
}

Vector3d quantised(const Vector3d& v, double range, bool quantise) {
  const double step = 2.0 * range / 4096.0;
  const Vector3d clipped = v.cwiseMax(-range).cwiseMin(range);
  return quantise ? Vector3d((clipped / step).array().round() * step) : clipped;
}

// Distance of a capsule's axis from the straight way of sound.
double distance_between(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d u = a1 - a0;
  const Vector3d v = b1 - b0;
  const Vector3d w = a0 - b0;
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 1e-12 ? std::clamp((uv * v.dot(w) - vv * u.dot(w)) / determinant, 0.0, 1.0) : 0.0;
  const double t = vv > 1e-12 ? std::clamp((uv * s + v.dot(w)) / vv, 0.0, 1.0) : 0.0;
  s = uu > 1e-12 ? std::clamp((uv * t - u.dot(w)) / uu, 0.0, 1.0) : 0.0;
  return (w + s * u - t * v).norm();
}

bool in_the_way(const DriverBoxActor& actor, const std::vector<FrameJet>& frames, const Vector3d& from,
                const Vector3d& to) {
  const Vector3d way = to - from;
  // Both ends lie on the skin: what touches them does not count.
  const Vector3d start = from + 0.06 * way.normalized();
  const Vector3d end = to - 0.06 * way.normalized();
  if (way.norm() < 0.2) {
    return false;
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const body::Capsule& capsule : actor.skeleton().segments[i].capsules) {
      const Vector3d a = frames[i].p_W.v + frames[i].R_W.v * capsule.from_L;
      const Vector3d b = frames[i].p_W.v + frames[i].R_W.v * capsule.to_L;
      if (distance_between(start, end, a, b) < capsule.radius) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

SimulatedReadings simulate_readings(const DriverBoxActor& actor, const body::Rig& rig, const DriverBoxErrors& errors,
                                    const ReadingSettings& settings, std::uint64_t seed) {
  const body::DriverBoxSignal box = rig.driver_box.value_or(body::DriverBoxSignal{});
  const double seconds = settings.seconds > 0.0 ? settings.seconds : actor.duration();
  SimulatedReadings readings;
  std::vector<Chips> chips;
  Random walk(seed, "bias walk");
  Random noise(seed, "readings");
  for (const body::Gyroscope& board : rig.gyroscopes) {
    chips.push_back(draw_chips(errors, seed, board.name));
  }
  const double range = box.gyroscope_range_rad_s;
  const double force_range = box.accelerometer_range_g * kStandardGravity;
  for (std::int64_t k = 0;; ++k) {
    const double t = static_cast<double>(k) / box.word_rate_hz;
    if (t > seconds) {
      break;
    }
    for (std::size_t b = 0; b < chips.size(); ++b) {
      const ChipTruth truth = actor.chip(static_cast<int>(b), t);
      Chips& chip = chips[b];
      chip.bias += draw_vector(walk, errors.gyroscope_bias_walk / std::sqrt(box.word_rate_hz));
      const Vector3d w = chip.gyroscope * truth.w_S + chip.g_sensitivity * truth.f_S / kStandardGravity + chip.bias +
                         draw_vector(noise, errors.gyroscope_noise);
      const Vector3d f = chip.accelerometer * truth.f_S + chip.offset + draw_vector(noise, errors.accelerometer_noise);
      readings.boards.push_back({t, static_cast<int>(b), quantised(w, range, errors.accumulates),
                                 quantised(f, force_range, errors.accumulates)});
    }
  }
  Random sound(seed, "ranges");
  Random wrong(seed, "outliers");
  const double slot = box.slot_samples / box.rate_hz;
  std::vector<FrameJet> frames;
  const bool noisy = errors.snr_db < kNoiseFreeSnr;
  for (std::int64_t k = 0; !actor.sources().empty(); ++k) {
    const double t = static_cast<double>(k) * slot;
    if (t > seconds) {
      break;
    }
    actor.frames(t, frames);
    const auto s = static_cast<std::size_t>(k) % actor.sources().size();
    const WornPlace& place = actor.sources()[s];
    const FrameJet source = DriverBoxActor::placed(place, frames[static_cast<std::size_t>(place.segment)]);
    const Vector3d normal = source.R_W.v * place.normal_S;
    for (std::size_t b = 0; b < actor.boards().size(); ++b) {
      const WornPlace& worn = actor.boards()[b];
      const FrameJet microphone = DriverBoxActor::placed(worn, frames[static_cast<std::size_t>(worn.segment)]);
      // Where the microphone is when the sound gets there.
      double distance = (microphone.p_W.v - source.p_W.v).norm();
      for (int step = 0; step < 3; ++step) {
        const double flight = distance / kSpeedOfSound;
        distance =
            (microphone.p_W.v + flight * microphone.p_W.d + 0.5 * flight * flight * microphone.p_W.dd - source.p_W.v)
                .norm();
      }
      const double noise_draw = draw(sound, settings.range_noise);
      const double wrong_draw = wrong.uniform();
      const double wrong_by = wrong.uniform(-settings.outlier_size, settings.outlier_size);
      const Vector3d way = microphone.p_W.v - source.p_W.v;
      const double cosine = way.normalized().dot(normal);
      if (distance > 2.5 || cosine < 0.0 ||
          (errors.occlusion && in_the_way(actor, frames, source.p_W.v, microphone.p_W.v))) {
        continue;
      }
      // Weaker sound is less certain: with distance and off the source's axis.
      const double weakness = std::max(1.0, distance / 0.6 / std::max(cosine, 0.25));
      double measured = distance * (1.0 + errors.speed_of_sound) + (noisy ? noise_draw * weakness : 0.0);
      measured += wrong_draw < settings.outliers ? wrong_by : 0.0;
      readings.ranges.push_back({t, static_cast<int>(s), static_cast<int>(b), measured, 1.0 / weakness});
    }
  }
  const auto rows = static_cast<std::int64_t>(seconds * settings.truth_rate_hz);
  for (std::int64_t k = 0; k <= rows; ++k) {
    TruthRow row;
    row.time_s = static_cast<double>(k) / settings.truth_rate_hz;
    actor.frames(row.time_s, frames);
    for (const FrameJet& frame : frames) {
      row.poses.push_back({frame.R_W.v, frame.p_W.v});
    }
    readings.truth.push_back(std::move(row));
  }
  return readings;
}

}  // namespace limbwave::simulate
