#include "decode/pulse_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/units.h"
#include "body/rig.h"
#include "decode/ranging.h"
#include "simulate/sound_pulse.h"

namespace limbwave::decode {
namespace {

constexpr double kRate = 140000.0;
constexpr double kSpeed = 344.6;

RangingFormat one_source() {
  RangingFormat format;
  format.sources.resize(1);
  format.sources[0].reach = 2.4;
  format.speed_of_sound = kSpeed;
  return format;
}

// One slot with a pulse of amplitude 1 that begins `delay_s` after its start, and white noise.
std::vector<float> slot_with(double delay_s, double noise, std::mt19937_64& random, double phase = 0.0,
                             double rate_of_time = 1.0) {
  const simulate::SoundPulse pulse{body::DriverBoxSignal{}};
  std::vector<float> samples(2 * 1120, 0.0F);
  pulse.add(samples.data(), 1120, -delay_s, 1.0 / kRate, rate_of_time, 0.1, phase);
  std::normal_distribution<float> normal(0.0F, 1.0F);
  for (float& sample : samples) {
    sample += static_cast<float>(noise) * normal(random);
  }
  return samples;
}

RangeReading range_of(const std::vector<float>& samples, RangingMethod method) {
  RangingParameters parameters;
  parameters.method = method;
  static const auto shape = RangingDecoder(one_source(), SampleRate{kRate}, 0).shape();
  RangingDecoder decoder(one_source(), SampleRate{kRate}, 0, parameters, shape);
  decoder.push(samples.data(), samples.size(), 1);
  decoder.finish();
  return decoder.take_readings().front();
}

// σ of a sample for an in-band (5 kHz) peak SNR.
double noise_for(double snr_db) {
  return std::sqrt(0.5 * 0.01 * std::pow(10.0, -snr_db / 10.0) * 0.5 * kRate / 5000.0);
}

// Cramér–Rao bound of the delay of a pulse A e(t - d) cos(2 pi f t + p) in white noise, amplitude and phase unknown:
// var(d) = σ² / (½ A² Σ (e'² - (Σ e e')² / Σ e²)) for a carrier that is fast against the envelope. The carrier itself
// tells nothing when its phase is unknown.
double bound_s(double noise) {
  const simulate::SoundPulse pulse{body::DriverBoxSignal{}};
  double ee = 0.0;
  double ed = 0.0;
  double dd = 0.0;
  for (int n = 0; n < 600; ++n) {
    const double t = n / kRate;
    const double e = pulse.envelope(t);
    const double d = (pulse.envelope(t + 1e-7) - pulse.envelope(t - 1e-7)) / 2e-7;
    ee += e * e;
    ed += e * d;
    dd += d * d;
  }
  return noise / (0.1 * std::sqrt(0.5 * (dd - ed * ed / ee)));
}

struct Errors {
  double mean_mm = 0.0, sd_mm = 0.0;
  int heard = 0;
};

Errors envelope_errors(RangingMethod method, double snr_db, int trials) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> range(0.3, 1.5);
  std::uniform_real_distribution<double> turn(0.0, 6.28);
  Errors errors;
  double sum = 0.0;
  double square = 0.0;
  for (int i = 0; i < trials; ++i) {
    const double r = range(random);
    const RangeReading reading = range_of(slot_with(r / kSpeed, noise_for(snr_db), random, turn(random)), method);
    if (!std::isfinite(reading.envelope_range)) {
      continue;
    }
    const double error = 1e3 * (reading.envelope_range - r);
    ++errors.heard;
    errors.mean_mm += std::abs(error);
    sum += error;
    square += error * error;
  }
  errors.mean_mm /= errors.heard;
  errors.sd_mm = std::sqrt(square / errors.heard - std::pow(sum / errors.heard, 2));
  return errors;
}

TEST(PulseFinder, EnvelopeReachesItsBound) {
  for (const double snr : {15.0, 20.0, 25.0, 30.0, 35.0, 40.0}) {
    const Errors errors = envelope_errors(RangingMethod::kEnvelope, snr, 600);
    const double bound_mm = 1e3 * kSpeed * bound_s(noise_for(snr));
    std::printf("%2.0f dB: sd %.3f mm, bound %.3f mm, ratio %.3f\n", snr, errors.sd_mm, bound_mm,
                errors.sd_mm / bound_mm);
    EXPECT_GT(errors.heard, 590);
    // 600 trials give the deviation to 3 %.
    EXPECT_LT(errors.sd_mm, 1.2 * bound_mm) << snr;
    EXPECT_GT(errors.sd_mm, 0.85 * bound_mm) << snr;
  }
}

TEST(PulseFinder, PaperMethodAsInThePaper) {
  const Errors errors = envelope_errors(RangingMethod::kPaper, 25.0, 600);
  std::printf("paper at 25 dB: mean %.2f mm, sd %.2f mm\n", errors.mean_mm, errors.sd_mm);
  EXPECT_LE(errors.mean_mm, 2.4);
  EXPECT_LE(errors.sd_mm, 2.8);
}

TEST(PulseFinder, WithoutNoiseBothAreExact) {
  std::mt19937_64 random(2);
  for (const double r : {0.12, 0.31, 0.7003, 1.234, 2.1}) {
    const RangeReading reading = range_of(slot_with(r / kSpeed, 1e-7, random), RangingMethod::kEnvelope);
    EXPECT_NEAR(reading.envelope_range, r, 0.03e-3) << r;
    const double wavelength = kSpeed / 40000.0;
    const double left = reading.phase_range - std::fmod(r, wavelength);
    EXPECT_NEAR(left - wavelength * std::round(left / wavelength), 0.0, 0.02e-3) << r;
  }
}

TEST(PulseFinder, FirstArrivalNotStrongest) {
  std::mt19937_64 random(3);
  const simulate::SoundPulse pulse{body::DriverBoxSignal{}};
  for (const double later : {0.15, 0.2, 0.3, 0.6}) {
    std::vector<float> samples = slot_with(0.5 / kSpeed, noise_for(40.0), random);
    pulse.add(samples.data(), 1120, -(0.5 + later) / kSpeed, 1.0 / kRate, 1.0, 0.16, 1.0);
    const RangeReading reading = range_of(samples, RangingMethod::kEnvelope);
    EXPECT_NEAR(reading.envelope_range, 0.5, 3e-3) << later;
  }
}

// A pulse from a limb that moves is heard faster or slower; its middle tells the range at its middle.
TEST(PulseFinder, MovementDoesNotMatterAtThePulsesMiddle) {
  std::mt19937_64 random(4);
  const double middle = RangingDecoder(one_source(), SampleRate{kRate}, 0).shape()->centroid_s();
  const double wavelength = kSpeed / 40000.0;
  for (const double speed : {-3.0, -1.0, 1.0, 3.0}) {
    const double r = 0.8;
    const RangeReading reading =
        range_of(slot_with(r / kSpeed, 1e-7, random, 0.0, 1.0 / (1.0 + speed / kSpeed)), RangingMethod::kEnvelope);
    const double left = reading.phase_range - std::fmod(r + speed * middle, wavelength);
    EXPECT_NEAR(left - wavelength * std::round(left / wavelength), 0.0, 0.05e-3) << speed;
    EXPECT_NEAR(reading.envelope_range, r + speed * middle, 1.5e-3) << speed;
  }
}

struct Claims {
  int heard = 0, beyond = 0, beyond_bound = 0;  // three standard deviations, as stated and of the bound
  double stated = 0.0;                          // mean of stated variances over the bound
};

// Envelopes at 30 dB with an echo `behind` of a given strength at any phase.
Claims claims(double behind, double strength, int trials) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * kPi);
  const simulate::SoundPulse pulse{body::DriverBoxSignal{}};
  const double noise = noise_for(30.0);
  const double bound = kSpeed * bound_s(noise);
  Claims c;
  for (int i = 0; i < trials; ++i) {
    const double r = 0.5 + 1e-3 * (i % 17);
    std::vector<float> samples = slot_with(r / kSpeed, noise, random, turn(random));
    if (strength > 0.0) {
      pulse.add(samples.data(), 1120, -(r + behind) / kSpeed, 1.0 / kRate, 1.0, 0.1 * strength, turn(random));
    }
    const RangeReading reading = range_of(samples, RangingMethod::kEnvelope);
    if (!std::isfinite(reading.envelope_range)) {
      continue;
    }
    const double error = std::abs(reading.envelope_range - r);
    ++c.heard;
    c.beyond += error > 3.0 * std::sqrt(reading.envelope_variance) ? 1 : 0;
    c.beyond_bound += error > 3.0 * bound ? 1 : 0;
    c.stated += reading.envelope_variance / (bound * bound + 0.4e-3 * 0.4e-3);
  }
  c.stated /= std::max(1, c.heard);
  return c;
}

// A single pulse states its bound, hardly more.
TEST(PulseFinder, StatesTheBoundWithoutEchoes) {
  const Claims c = claims(0.0, 0.0, 400);
  std::printf("no echo: stated variance %.3f of the bound, %d of %d beyond 3 sd\n", c.stated, c.beyond, c.heard);
  EXPECT_GT(c.stated, 0.9);
  EXPECT_LT(c.stated, 1.25);
  EXPECT_LE(c.beyond, c.heard / 50);
}

// Echoes that overlap shift the envelope far beyond its bound; the stated variance follows most of them. Those that
// leave nothing but a shift cannot be seen in one pulse.
TEST(PulseFinder, StatesWhatEchoesMayDo) {
  for (const double behind : {0.03, 0.05, 0.08}) {
    const Claims c = claims(behind, 0.5, 300);
    std::printf("echo %.0f mm behind: stated variance %.1f of the bound, beyond 3 sd %d, of the bound %d of %d\n",
                1e3 * behind, c.stated, c.beyond, c.beyond_bound, c.heard);
    EXPECT_GT(c.heard, 290);
    EXPECT_GT(c.beyond_bound, c.heard / 10);
    EXPECT_LT(c.beyond, c.beyond_bound * 3 / 5) << "most echoes are seen";
  }
}

}  // namespace
}  // namespace limbwave::decode
