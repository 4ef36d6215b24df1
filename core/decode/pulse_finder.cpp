#include "decode/pulse_finder.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "signal/fir_design.h"

namespace limbwave::decode {
namespace {

constexpr int kMostArrivals = 4;
// An earlier arrival that is weaker than this beside a later one is what the later one's model did not explain.
constexpr double kModelError = 0.06;   // of amplitudes
constexpr double kUsualTurn = 1200.0;  // radians/s, standard deviation: 1.6 m/s towards or away
constexpr double kOverlap = 1.1e-3;    // seconds; later echoes do not reach back to the first arrival
constexpr double kMisfitNoise = 4.0;   // energy over the noise's, up to which what is left of a pulse is noise
constexpr double kLaterNoise = 5.0;    // likewise, of the strongest arrival that may hide behind it
constexpr std::size_t kLater = 9;      // values: 0.45 ms
constexpr double kMostCrowding = 1e3;

}  // namespace

PulseFinder::PulseFinder(const PulseShape& shape, const BasebandPlan& plan) : shape_(shape), rate_hz_(plan.rate_hz) {}

// Energy ratio at whole lags: lag l is a template that begins at value l, a pulse that begins at l + lead.
void PulseFinder::correlate(std::size_t first, std::size_t last) {
  const float* g = shape_.shape(0);
  for (std::size_t l = first; l < last; ++l) {
    const signal::DotPair c = signal::dot_pair(g, re_.data() + l, im_.data() + l, shape_.length());
    power_[l] = c.first * c.first + c.second * c.second;
  }
}

std::pair<int, std::size_t> PulseFinder::phase_of(double place) const {
  const double start = std::max(0.0, place - static_cast<double>(shape_.lead()));
  auto whole = static_cast<std::size_t>(start);
  int phase = static_cast<int>(std::lround((start - static_cast<double>(whole)) * PulseShape::kPhases));
  if (phase == PulseShape::kPhases) {
    phase = 0;
    ++whole;
  }
  return {phase, whole};
}

PulseFinder::Fit PulseFinder::fit(std::size_t lag, double noise) const {
  Fit fit;
  const std::size_t length = shape_.length();
  fit.place = static_cast<double>(lag + shape_.lead());
  double rest = 0.0;
  for (int round = 0; round < 5; ++round) {
    const auto [phase, start] = phase_of(fit.place + rest);
    if (start + length > re_.size()) {
      break;
    }
    fit.place = static_cast<double>(start + shape_.lead()) + static_cast<double>(phase) / PulseShape::kPhases;
    const float* g = shape_.shape(phase);
    const float* d = shape_.slope(phase);
    const signal::DotPair c = signal::dot_pair(g, re_.data() + start, im_.data() + start, length);
    const signal::DotPair s = signal::dot_pair(d, re_.data() + start, im_.data() + start, length);
    const double gg = signal::dot(g, g, length);
    const double gd = signal::dot(g, d, length);
    const double dd = signal::dot(d, d, length);
    fit.a = std::complex<double>(c.first, c.second) / gg;
    // One step of Gauss–Newton in the delay, the complex amplitude eliminated.
    const std::complex<double> left = std::complex<double>(s.first, s.second) - fit.a * gd;
    const double curvature = std::norm(fit.a) * (dd - gd * gd / gg);
    rest = curvature > 0.0 ? std::clamp(std::real(std::conj(fit.a) * left) / curvature, -1.5, 1.5) : 0.0;
    if (std::abs(rest) < 0.6 / PulseShape::kPhases) {
      break;
    }
  }
  // How fast the phase turns within the pulse, about the middle of its energy: what movement does (Doppler). Shrunk by
  // what limbs usually do, so that noise is not taken for it.
  const auto [phase, start] = phase_of(fit.place);
  if (start + length <= re_.size() && std::norm(fit.a) > 0.0) {
    const float* g = shape_.shape(phase);
    const double middle = shape_.middle() + static_cast<double>(phase) / PulseShape::kPhases;
    std::complex<double> moment;
    for (std::size_t i = 0; i < length; ++i) {
      const double weight = g[i] * (static_cast<double>(i) - middle);
      moment += weight * std::complex<double>(re_[start + i], im_[start + i]);
    }
    const double power = std::norm(fit.a);
    fit.turn_variance = noise / (2.0 * power * shape_.spread());
    const double usual = kUsualTurn * kUsualTurn / (rate_hz_ * rate_hz_);
    fit.measured_turn = std::imag(std::conj(fit.a) * moment) / (power * shape_.spread());
    fit.turn = std::clamp(fit.measured_turn * usual / (usual + fit.turn_variance), -0.25, 0.25);
  }
  fit.place += rest;
  return fit;
}

void PulseFinder::subtract(const Fit& fit, double sign) {
  const auto [phase, start] = phase_of(fit.place);
  const double nearest = static_cast<double>(start + shape_.lead()) + static_cast<double>(phase) / PulseShape::kPhases;
  const auto rest = static_cast<float>(fit.place - nearest);
  const float* g = shape_.shape(phase);
  const float* d = shape_.slope(phase);
  const double middle = shape_.middle() + static_cast<double>(phase) / PulseShape::kPhases;
  std::complex<double> carrier = sign * fit.a * std::polar(1.0, -fit.turn * middle);
  const std::complex<double> step = std::polar(1.0, fit.turn);
  for (std::size_t i = 0; i < shape_.length() && start + i < re_.size(); ++i) {
    const float value = g[i] + rest * d[i];
    re_[start + i] -= static_cast<float>(carrier.real()) * value;
    im_[start + i] -= static_cast<float>(carrier.imag()) * value;
    carrier *= step;
  }
}

// Of what is left when all arrivals are taken out.
double PulseFinder::misfit(const Fit& fit, double noise) const {
  const auto [phase, start] = phase_of(fit.place);
  const std::size_t length = shape_.length();
  const auto energy = [&](const float* shape, std::size_t at) {
    if (at + length > re_.size()) {
      return 0.0;
    }
    const signal::DotPair c = signal::dot_pair(shape, re_.data() + at, im_.data() + at, length);
    return (static_cast<double>(c.first) * c.first + static_cast<double>(c.second) * c.second) / noise;
  };
  double later = 0.0;
  for (std::size_t l = start; l < start + kLater; ++l) {
    later = std::max(later, energy(shape_.shape(0), l) / shape_.energy());
  }
  return std::max({0.0, energy(shape_.bend(phase), start) - kMisfitNoise, later - kLaterNoise});
}

std::pair<double, double> PulseFinder::crowding(const Fit& fit, const std::vector<Fit>& fits) const {
  const auto length = static_cast<Eigen::Index>(shape_.length());
  const auto [phase, start] = phase_of(fit.place);
  std::vector<Eigen::VectorXd> taken;  // orthonormal: what others may explain
  const auto left_of = [&](Eigen::VectorXd v) {
    for (const Eigen::VectorXd& unit : taken) {
      v -= unit.dot(v) * unit;
    }
    return v;
  };
  for (const Fit& other : fits) {
    if (&other == &fit || std::abs(other.place - fit.place) > kOverlap * rate_hz_) {
      continue;
    }
    const auto [other_phase, other_start] = phase_of(other.place);
    const auto ahead = static_cast<Eigen::Index>(other_start) - static_cast<Eigen::Index>(start);
    for (const float* table : {shape_.shape(other_phase), shape_.slope(other_phase)}) {
      Eigen::VectorXd v = Eigen::VectorXd::Zero(length);
      for (Eigen::Index i = std::max<Eigen::Index>(0, ahead); i < std::min(length, length + ahead); ++i) {
        v[i] = table[i - ahead];
      }
      const double before = v.norm();
      v = left_of(v);
      if (v.norm() > 1e-3 * before) {
        taken.push_back(v.normalized());
      }
    }
  }
  const auto own = [&](const float* table) {
    return Eigen::Map<const Eigen::VectorXf>(table, length).cast<double>().eval();
  };
  const Eigen::VectorXd g = own(shape_.shape(phase));
  Eigen::VectorXd d = own(shape_.slope(phase));
  const double alone = d.squaredNorm() - std::pow(g.dot(d), 2) / g.squaredNorm();
  const Eigen::VectorXd g_left = left_of(g);
  const double phase_factor = g.squaredNorm() / std::max(g_left.squaredNorm(), g.squaredNorm() / kMostCrowding);
  d = left_of(d);
  d -= g_left.dot(d) / std::max(g_left.squaredNorm(), 1e-12) * g_left;
  return {alone / std::max(d.squaredNorm(), alone / kMostCrowding), phase_factor};
}

FoundPulse PulseFinder::find(std::span<const std::complex<float>> values, double first_value_s, double longest_s,
                             double noise, double detection) {
  FoundPulse found;
  found.noise = noise;
  const std::size_t length = shape_.length();
  re_.resize(values.size());
  im_.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    re_[i] = values[i].real();
    im_[i] = values[i].imag();
  }
  if (values.size() < length + 3) {
    return found;
  }
  const std::size_t lags = values.size() - length;
  power_.assign(values.size(), 0.0F);
  correlate(0, lags);
  const double threshold = detection * noise * shape_.energy();
  const auto seconds = [&](double place) { return first_value_s + place / rate_hz_; };
  std::vector<Fit> fits;
  std::size_t end = lags;
  for (int round = 0; round < kMostArrivals; ++round) {
    // The strongest of what may come first or disturb it.
    std::size_t best = 0;
    for (std::size_t l = 1; l + 1 < end; ++l) {
      if (power_[l] > power_[best] && power_[l] >= power_[l - 1] && power_[l] >= power_[l + 1]) {
        const double at = seconds(static_cast<double>(l + shape_.lead()));
        if (at > -0.2e-3 && at < longest_s) {
          best = l;
        }
      }
    }
    if (best == 0 || power_[best] < threshold) {
      break;
    }
    Fit next = fit(best, noise);
    bool artefact = false;
    for (const Fit& other : fits) {
      const double apart = std::abs(other.place - next.place) / rate_hz_;
      artefact =
          artefact || (std::abs(next.a) < kModelError * std::abs(other.a) && apart < kOverlap) || apart < 0.06e-3;
    }
    if (artefact || !std::isfinite(next.place)) {
      break;
    }
    subtract(next, 1.0);
    fits.push_back(next);
    const double earliest =
        std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.place < b.place; })->place;
    end = std::min(lags, static_cast<std::size_t>(
                             std::max(2.0, earliest - static_cast<double>(shape_.lead()) + kOverlap * rate_hz_)));
    const auto low = static_cast<std::size_t>(std::max(0.0, next.place - 2.0 * static_cast<double>(length)));
    correlate(low, std::min(lags, low + 3 * length));
  }
  // Each once more with all others taken out.
  if (fits.size() > 1) {
    for (int pass = 0; pass < 2; ++pass) {
      for (Fit& one : fits) {
        subtract(one, -1.0);
        const double start = std::max(0.0, one.place - static_cast<double>(shape_.lead()));
        const Fit again = fit(static_cast<std::size_t>(std::lround(start)), noise);
        if (std::isfinite(again.place) && std::abs(again.place - one.place) < 2.0) {
          one = again;
        }
        subtract(one, 1.0);
      }
    }
  }
  std::sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.place < b.place; });
  for (const Fit& one : fits) {
    Arrival arrival;
    const double power = std::norm(one.a);
    arrival.delay_s = seconds(one.place);
    arrival.amplitude = std::abs(one.a);
    arrival.energy_ratio = power * shape_.energy() / std::max(noise, 1e-30);
    // Half the noise is in phase with the slope: var = N / (2 |a|² ∫ slope²).
    arrival.delay_variance = noise / (2.0 * power * shape_.slope_energy() * rate_hz_ * rate_hz_);
    arrival.phase_variance = noise / (2.0 * power * shape_.energy());
    arrival.phase = std::arg(one.a);
    if (fits.size() > 1) {
      const auto [delay_factor, phase_factor] = crowding(one, fits);
      arrival.delay_variance *= delay_factor;
      arrival.phase_variance *= phase_factor;
    }
    arrival.doppler = one.measured_turn * rate_hz_;
    arrival.doppler_variance = one.turn_variance * rate_hz_ * rate_hz_;
    arrival.misfit = misfit(one, noise);
    found.arrivals.push_back(arrival);
  }
  return found;
}

}  // namespace limbwave::decode
