#include "calibrate/sound_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace limbwave::calibrate {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMost = 4096;     // times of a pair that are kept
constexpr double kShortest = 0.03;      // metres; shorter pairs say nothing
constexpr double kFar = 5e-3;           // metres, of an envelope from where the pair is
constexpr double kContradiction = 4.0;  // standard deviations

struct Carried {
  int segment = -1;
  Vector3d p = Vector3d::Zero();
  Vector3d direction = Vector3d::Zero();
};

// The segment that carries it, its place there and a direction, through fixed joints upwards.
Carried carried(const body::Skeleton& skeleton, const std::string& name, Vector3d p, Vector3d direction) {
  int segment = skeleton.find(name);
  while (segment >= 0) {
    const body::Segment& own = skeleton.segments[static_cast<std::size_t>(segment)];
    if (own.parent < 0 || own.joint.kind != body::JointKind::kFixed) {
      break;
    }
    p = own.p_PL + own.R_PL_rest * p;
    direction = own.R_PL_rest * direction;
    segment = own.parent;
  }
  return {segment, p, direction};
}

struct Middle {
  double median = 0.0, sd = 0.0;
};

Middle middle_of(std::vector<float> values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), half, values.end());
  const float median = *half;
  for (float& value : values) {
    value = std::abs(value - median);
  }
  std::nth_element(values.begin(), half, values.end());
  return {static_cast<double>(median), 1.4826 * static_cast<double>(*half)};
}

}  // namespace

std::vector<RigidPair> rigid_pairs(const body::Rig& rig, const body::Skeleton& skeleton) {
  std::vector<RigidPair> pairs;
  for (std::size_t s = 0; s < rig.sources.size(); ++s) {
    const body::Source& source = rig.sources[s];
    const Carried from = carried(skeleton, source.segment, source.p_LS, source.normal_L);
    for (std::size_t m = 0; m < rig.microphones.size(); ++m) {
      const body::Microphone& microphone = rig.microphones[m];
      const Carried to = carried(skeleton, microphone.segment, microphone.p_LS, Vector3d::Zero());
      const Vector3d way = to.p - from.p;
      if (from.segment >= 0 && from.segment == to.segment && way.norm() >= kShortest) {
        const double cosine = way.normalized().dot(from.direction.normalized());
        pairs.push_back(
            {static_cast<int>(s), static_cast<int>(m), way.norm(), std::acos(std::clamp(cosine, -1.0, 1.0))});
      }
    }
  }
  return pairs;
}

decode::RangingDecoder::Predict rigid_prediction(const std::vector<RigidPair>& pairs, int receiver) {
  return [pairs, receiver](int source, Seconds) -> std::optional<decode::RangePrediction> {
    const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const RigidPair& pair) {
      return pair.source == source && pair.receiver == receiver;
    });
    if (found == pairs.end()) {
      return std::nullopt;
    }
    const double sd = 0.01 * found->length + 1e-3;
    return decode::RangePrediction{found->length, sd * sd, found->angle};
  };
}

std::string SoundSpeed::text() const {
  return fmt::format(
      "{:.2f} m/s, within {:.2f} m/s, from {} pairs on one segment{}", speed, 2.0 * sd, pairs,
      left_out.empty() ? "" : fmt::format("; {} pairs that contradict them are left out", left_out.size()));
}

SoundSpeedEstimator::SoundSpeedEstimator(std::vector<RigidPair> pairs, double pulse_hz,
                                         const SoundSpeedSettings& settings)
    : pairs_(std::move(pairs)), pulse_hz_(pulse_hz), settings_(settings), times_(pairs_.size()) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    index_[{pairs_[i].source, pairs_[i].receiver}] = i;
  }
}

void SoundSpeedEstimator::add(const decode::RangeReading& reading, double assumed) {
  const auto found = index_.find({reading.source, reading.receiver});
  if (found == index_.end() || reading.verdict == decode::RangeVerdict::kInterrupted ||
      reading.verdict == decode::RangeVerdict::kDisturbed || !std::isfinite(reading.phase_range) ||
      reading.snr_db < settings_.least_snr_db) {
    return;
  }
  const double length = pairs_[found->second].length;
  // An echo, or another pulse's end.
  if (std::abs(reading.envelope_range - length) > kFar + 3.0 * std::sqrt(reading.envelope_variance)) {
    return;
  }
  const double wavelength = assumed / pulse_hz_;
  const double range = reading.phase_range + std::round((length - reading.phase_range) / wavelength) * wavelength;
  Times& times = times_[found->second];
  if (times.seen++ % times.stride != 0) {
    return;
  }
  times.seconds.push_back(static_cast<float>(range / assumed));
  if (times.seconds.size() >= kMost) {
    for (std::size_t i = 0; 2 * i < times.seconds.size(); ++i) {
      times.seconds[i] = times.seconds[2 * i];
    }
    times.seconds.resize((times.seconds.size() + 1) / 2);
    times.stride *= 2;
  }
}

Result<SoundSpeed> SoundSpeedEstimator::estimate() const {
  struct Pair {
    int index;
    double length, time, variance;  // of the length that the time says
  };
  std::vector<Pair> pairs;
  constexpr double kAbout = 345.0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const auto count = times_[i].seconds.size();
    if (count < static_cast<std::size_t>(settings_.least_readings)) {
      continue;
    }
    const Middle time = middle_of(times_[i].seconds);
    const double noise = kAbout * time.sd / std::sqrt(static_cast<double>(count));
    pairs.push_back(
        {static_cast<int>(i), pairs_[i].length, time.median,
         settings_.length_sd * settings_.length_sd + settings_.system_sd * settings_.system_sd + 1.57 * noise * noise});
  }
  SoundSpeed result;
  while (pairs.size() >= 2) {
    double lt = 0.0;
    double tt = 0.0;
    for (const Pair& pair : pairs) {
      lt += pair.length * pair.time / pair.variance;
      tt += pair.time * pair.time / pair.variance;
    }
    result.speed = lt / tt;
    double chi2 = 0.0;
    auto worst = pairs.begin();
    double most = 0.0;
    for (auto pair = pairs.begin(); pair != pairs.end(); ++pair) {
      const double z = std::abs(pair->length - result.speed * pair->time) / std::sqrt(pair->variance);
      chi2 += z * z;
      if (z > most) {
        most = z;
        worst = pair;
      }
    }
    if (most > kContradiction && pairs.size() > 2) {
      result.left_out.push_back(worst->index);
      pairs.erase(worst);
      continue;
    }
    result.pairs = static_cast<int>(pairs.size());
    result.sd = std::sqrt(std::max(1.0, chi2 / static_cast<double>(pairs.size() - 1)) / tt);
    return result;
  }
  return Error{"has too few ranges between sources and microphones on one segment", "speed of sound",
               "take more of the recording, or enter temperature and humidity"};
}

}  // namespace limbwave::calibrate
