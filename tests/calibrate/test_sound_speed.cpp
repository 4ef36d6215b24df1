#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calibrate/ranging_calibration.h"
#include "calibrate/sound_speed.h"
#include "decode/driver_box_decoder.h"
#include "simulate/driver_box_stream.h"
#include "solve/driver_box.h"

namespace limbwave::calibrate {
namespace {

// Cramer, J. Acoust. Soc. Am. 93 (1993), 2510–2516, equation (15), at 101 325 Pa and 0.04 % carbon dioxide.
struct Published {
  double temperature_c, humidity, speed;
};
constexpr Published kCramer[] = {{0.0, 0.0, 331.448},  {0.0, 1.0, 331.759},  {10.0, 0.5, 337.781},
                                 {20.0, 0.0, 343.359}, {20.0, 0.5, 343.987}, {20.0, 1.0, 344.613},
                                 {30.0, 0.5, 350.310}, {30.0, 1.0, 351.469}, {35.0, 1.0, 355.102}};

TEST(SpeedOfSound, IsAsPublished) {
  for (const Published& p : kCramer) {
    // 331.3 m/s at 0 °C (signals.md) is 0.15 m/s below Cramer's: 0.05 %, half a millimetre at a metre.
    EXPECT_NEAR(speed_of_sound(p.temperature_c, p.humidity), p.speed, 5e-4 * p.speed) << p.temperature_c;
  }
}

TEST(SpeedOfSound, HumidityTermIsAsPublished) {
  const struct {
    double temperature_c, humidity, more;  // than dry air, m/s
  } terms[] = {{0.0, 1.0, 0.311},  {10.0, 1.0, 0.644}, {20.0, 0.5, 0.628},
               {20.0, 1.0, 1.254}, {30.0, 1.0, 2.321}, {35.0, 1.0, 3.101}};
  for (const auto& t : terms) {
    const double more = speed_of_sound(t.temperature_c, t.humidity) - speed_of_sound(t.temperature_c, 0.0);
    EXPECT_NEAR(more, t.more, 0.03 * t.more) << t.temperature_c;
  }
}

TEST(RigidPairs, AreThoseOnOneSegment) {
  const auto rig = body::load_rig("driver-box-body");
  ASSERT_TRUE(rig.ok());
  const auto skeleton = body::load_skeleton(rig->skeleton);
  ASSERT_TRUE(skeleton.ok());
  const auto pairs = rigid_pairs(*rig, *skeleton);
  EXPECT_EQ(pairs.size(),
            8U);  // four sources with the chest's microphone, three with the abdomen's, the hat with the head's
  for (const RigidPair& pair : pairs) {
    EXPECT_EQ(rig->sources[static_cast<std::size_t>(pair.source)].segment,
              rig->microphones[static_cast<std::size_t>(pair.receiver)].segment);
    EXPECT_GT(pair.length, 0.05);
    EXPECT_LT(pair.length, 0.3);
  }
}

TEST(SoundSpeed, OnePairThatIsWrongIsLeftOut) {
  constexpr double kSpeed = 347.0;
  std::vector<RigidPair> pairs;
  for (int s = 0; s < 6; ++s) {
    pairs.push_back({s, 0, 0.1 + 0.03 * s, 0.5});
  }
  SoundSpeedSettings settings;
  settings.length_sd = 0.3e-3;  // measured with a calliper
  SoundSpeedEstimator estimator(pairs, 40000.0, settings);
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 0.3e-3);
  for (int n = 0; n < 20000; ++n) {
    decode::RangeReading reading;
    reading.source = n % 6;
    reading.verdict = decode::RangeVerdict::kAccepted;
    const double length = pairs[static_cast<std::size_t>(reading.source)].length + (reading.source == 2 ? 0.003 : 0.0);
    // Decoded with 345 m/s.
    reading.envelope_range = (length + 3.0 * noise(random)) / kSpeed * 345.0;
    reading.envelope_variance = 1e-6;
    reading.phase_range = std::fmod((length + noise(random)) / kSpeed * 345.0, 345.0 / 40000.0);
    reading.snr_db = 20.0;
    estimator.add(reading, 345.0);
  }
  const auto found = estimator.estimate();
  ASSERT_TRUE(found.ok()) << found.error().text();
  EXPECT_EQ(found->left_out, std::vector<int>{2});
  EXPECT_NEAR(found->speed, kSpeed, 0.1);
  EXPECT_LT(found->sd, 0.006 * kSpeed);
  EXPECT_FALSE(SoundSpeedEstimator(pairs, 40000.0).estimate().ok());
}

// The operator entered a speed that is half a per cent off; the ranges on chest and belly find it, out of sound.
TEST(SoundSpeed, AWrongEntryIsFoundFromTheSound) {
  const auto rig = body::load_rig("driver-box-body");
  const auto skeleton = body::load_skeleton(rig->skeleton);
  auto errors = simulate::load_driver_box_errors("calibrated");
  ASSERT_TRUE(errors.ok());
  errors->speed_of_sound = 0.005;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto actor = simulate::DriverBoxActor::create("walk", 0.0, *rig, *skeleton, *errors, seed);
    ASSERT_TRUE(actor.ok());
    simulate::DriverBoxStream stream(*rig, *actor, *errors, 22.0, seed);
    const auto calibration = simulate::simulated_calibration(*rig, stream, *errors, seed);
    decode::DriverBoxParameters parameters;
    parameters.inertial = false;
    decode::DriverBoxDecoder decoder(solve::driver_box_format(*rig, *skeleton, calibration), parameters);
    const std::vector<RigidPair> pairs = rigid_pairs(*rig, *skeleton);
    for (int w = 0; w < stream.wires(); ++w) {
      decoder.set_prediction(w, rigid_prediction(pairs, w));
    }
    SoundSpeedEstimator estimator(pairs, rig->driver_box->pulse_hz);
    std::vector<std::int16_t> slot(static_cast<std::size_t>(stream.slot_samples() * stream.wires()));
    std::vector<float> block(slot.size());
    while (stream.position() < 8 * 140000) {
      stream.next_slot(slot);
      for (std::size_t i = 0; i < slot.size(); ++i) {
        block[i] = static_cast<float>(slot[i]) / 32768.0F;
      }
      decoder.push(block);
      for (const decode::RangeReading& reading : decoder.take_ranges()) {
        estimator.add(reading, calibration.speed_of_sound);
      }
    }
    decoder.finish();
    for (const decode::RangeReading& reading : decoder.take_ranges()) {
      estimator.add(reading, calibration.speed_of_sound);
    }
    const auto found = estimator.estimate();
    ASSERT_TRUE(found.ok()) << found.error().text();
    const double wrong = calibration.speed_of_sound / stream.speed_of_sound() - 1.0;
    const double left = found->speed / stream.speed_of_sound() - 1.0;
    std::printf("entered %+.3f %%, found %+.3f %%, sd %.3f %%, %d pairs\n", 100.0 * wrong, 100.0 * left,
                100.0 * found->sd / found->speed, found->pairs);
    EXPECT_GT(std::abs(wrong), 0.0045);
    EXPECT_LT(std::abs(left), 0.0015);
    EXPECT_LT(std::abs(left), 4.0 * found->sd / found->speed);
  }
}

}  // namespace
}  // namespace limbwave::calibrate
