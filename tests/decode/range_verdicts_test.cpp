// Verdicts of a resolver on slots that are written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "body/rig.h"
#include "decode/range_resolver.h"

namespace limbwave::decode {
namespace {

constexpr double kNoise = 1e-8;  // power of a complex value

RangingFormat one_source() {
  RangingFormat format;
  format.radiation = body::default_radiation();
  format.sources.resize(1);
  format.sources[0].reach = 2.0;
  return format;
}

// A pulse as strong as a source straight ahead at that range is, times `strength`.
Arrival arrival_at(const RangingFormat& format, double range, double strength = 1.0) {
  Arrival arrival;
  arrival.delay_s = range / format.speed_of_sound;
  arrival.amplitude = strength * format.level_m / range * std::pow(10.0, -format.absorption_db_m * range / 20.0);
  arrival.delay_variance = std::pow(2e-3 / format.speed_of_sound, 2);
  arrival.phase_variance = 1e-4;
  arrival.doppler_variance = 1e4;
  arrival.phase = -2.0 * kPi * format.pulse_hz * arrival.delay_s;
  return arrival;
}

HeardSlot slot_of(std::initializer_list<Arrival> arrivals) {
  HeardSlot heard;
  heard.noise = heard.noise_now = kNoise;
  for (const Arrival& arrival : arrivals) {
    heard.arrivals[heard.count++] = arrival;
  }
  return heard;
}

TrackerStep at_rest(double time_s = 0.0) {
  TrackerStep step;
  step.source.time_s = time_s;
  return step;
}

RangeReading judged(const RangingFormat& format, const HeardSlot& heard, const TrackerStep& step = at_rest(),
                    RangingMethod method = RangingMethod::kEnvelope) {
  RangingParameters parameters;
  parameters.method = method;
  parameters.look_ahead_s = 0.0;
  RangeResolver resolver(SampleRate{140000.0}, 0, {{format, {}}}, parameters, 0.25e-3);
  resolver.add(heard, {step});
  return resolver.take().at(0);
}

TEST(RangeVerdicts, APulseAsStrongAsItsRangeMakesItIsAccepted) {
  const RangingFormat format = one_source();
  const RangeReading reading = judged(format, slot_of({arrival_at(format, 0.7)}));
  EXPECT_EQ(reading.verdict, RangeVerdict::kAccepted);
  EXPECT_NEAR(reading.range, 0.7, 1e-12);
  EXPECT_NEAR(reading.flight_s, 0.7 / format.speed_of_sound, 1e-12);
  EXPECT_EQ(reading.confidence(), 1.0);
}

TEST(RangeVerdicts, SilenceNoiseAndGapsHaveTheirNames) {
  const RangingFormat format = one_source();
  HeardSlot heard = slot_of({});
  EXPECT_EQ(judged(format, heard).verdict, RangeVerdict::kNothingHeard);
  EXPECT_TRUE(std::isnan(judged(format, heard).range));
  EXPECT_TRUE(std::isinf(judged(format, heard).variance));
  heard.noise_now = 20.0 * kNoise;
  EXPECT_EQ(judged(format, heard).verdict, RangeVerdict::kDisturbed);
  heard = slot_of({arrival_at(format, 0.7)});
  heard.cut = true;
  EXPECT_EQ(judged(format, heard).verdict, RangeVerdict::kInterrupted);
}

// Bent round a limb: 20 dB less than a source in sight has, even far off its axis.
TEST(RangeVerdicts, AWeakPulseIsFlagged) {
  const RangingFormat format = one_source();
  const RangeReading weak = judged(format, slot_of({arrival_at(format, 0.7, 0.03)}));
  EXPECT_EQ(weak.verdict, RangeVerdict::kTooWeak);
  EXPECT_LT(weak.confidence(), 0.1);
  EXPECT_EQ(judged(format, slot_of({arrival_at(format, 0.7, 0.3)})).verdict, RangeVerdict::kAccepted);
}

TEST(RangeVerdicts, TheFirstArrivalCountsNotTheStrongest) {
  const RangingFormat format = one_source();
  const RangeReading reading = judged(format, slot_of({arrival_at(format, 0.7, 0.5), arrival_at(format, 0.9, 1.0)}));
  EXPECT_NEAR(reading.range, 0.7, 1e-12);
}

TEST(RangeVerdicts, NoLimbReachesBeyondItself) {
  RangingFormat format = one_source();
  format.sources[0].reach = 0.6;
  EXPECT_EQ(judged(format, slot_of({arrival_at(format, 0.7)})).verdict, RangeVerdict::kInconsistent);
}

// Where joints let a microphone only come behind a source, what is heard is an echo.
TEST(RangeVerdicts, WhatLeavesASourceBackwardIsAnEcho) {
  RangingFormat format = one_source();
  format.sources[0].foremost = radians(84.0);
  EXPECT_EQ(judged(format, slot_of({arrival_at(format, 0.7)})).factors.angle, 1.0);
  format.sources[0].foremost = radians(90.0);
  EXPECT_NEAR(judged(format, slot_of({arrival_at(format, 0.7)})).factors.angle, 0.5, 1e-9);
  format.sources[0].foremost = radians(96.0);
  const RangeReading behind = judged(format, slot_of({arrival_at(format, 0.7)}));
  EXPECT_EQ(behind.factors.angle, 0.0);
  EXPECT_EQ(behind.verdict, RangeVerdict::kInconsistent);
}

// The same by where the skeleton puts the board, as far as that is known: behind the source, 0.5 m away.
TEST(RangeVerdicts, TheSkeletonTellsWhoIsBehind) {
  const RangingFormat format = one_source();
  const HeardSlot heard = slot_of({arrival_at(format, 0.5)});
  TrackerStep step = at_rest();
  step.board.placed = true;
  step.board.place = Eigen::Vector3d(-0.5, 0.0, 0.0);  // the normal is x
  step.board.place_sd = 0.05;
  EXPECT_EQ(judged(format, heard, step).factors.angle, 0.0);
  step.board.place_sd = 0.6;  // may be anywhere
  EXPECT_EQ(judged(format, heard, step).factors.angle, 1.0);
  step.board.place_sd = 0.05;
  step.board.place = Eigen::Vector3d(0.5, 0.0, 0.0);
  EXPECT_EQ(judged(format, heard, step).factors.angle, 1.0);
}

TEST(RangeVerdicts, WhoIsFarFromTheSkeletonsPlaceIsNotContinuous) {
  const RangingFormat format = one_source();
  TrackerStep step = at_rest();
  step.board.placed = true;
  step.board.place = Eigen::Vector3d(0.5, 0.0, 0.0);
  step.board.place_sd = 0.03;
  EXPECT_EQ(judged(format, slot_of({arrival_at(format, 0.6)}), step).factors.continuity, 1.0);
  EXPECT_LT(judged(format, slot_of({arrival_at(format, 0.9)}), step).factors.continuity, 0.1);
}

// What an echo leaves in a pulse's shape, and a carrier that turns faster than limbs move, widen the envelope.
TEST(RangeVerdicts, WhatNoSinglePulseExplainsWidensTheEnvelope) {
  const RangingFormat format = one_source();
  const double clean = judged(format, slot_of({arrival_at(format, 0.7)})).envelope_variance;
  EXPECT_NEAR(clean, 4e-6 + 0.16e-6, 1e-9);
  Arrival bent = arrival_at(format, 0.7);
  bent.misfit = 10.0;
  EXPECT_NEAR(judged(format, slot_of({bent})).envelope_variance, 41.0 * 4e-6 + 0.16e-6, 1e-8);
  Arrival turning = arrival_at(format, 0.7);
  turning.doppler = 1000.0;  // 1.4 m/s: limbs do
  EXPECT_NEAR(judged(format, slot_of({turning})).envelope_variance, clean, 1e-9);
  turning.doppler = 8000.0;  // 11 m/s
  EXPECT_GT(judged(format, slot_of({turning})).envelope_variance, 4.0 * clean);
}

// The number of cycles is not told by one pulse: the reading is the envelope's until it is known.
TEST(RangeVerdicts, OnePulseDoesNotTellItsCycles) {
  const RangingFormat format = one_source();
  const RangeReading reading = judged(format, slot_of({arrival_at(format, 0.7)}), at_rest(), RangingMethod::kCarrier);
  EXPECT_EQ(reading.verdict, RangeVerdict::kAmbiguous);
  EXPECT_NEAR(reading.range, reading.envelope_range, 1e-12);
  EXPECT_EQ(reading.variance, reading.envelope_variance);
}

}  // namespace
}  // namespace limbwave::decode
