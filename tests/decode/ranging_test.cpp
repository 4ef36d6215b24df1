#include "decode/ranging.h"

#include <gtest/gtest.h>

#include <cmath>

#include "decode/driver_box_decoder.h"
#include "simulate/driver_box_stream.h"
#include "solve/driver_box.h"

namespace limbwave::decode {
namespace {

struct World {
  DriverBoxFormat format;
  std::vector<float> samples;  // interleaved
  std::vector<simulate::PulseTruth> pulses;
  std::size_t wires = 0;
};

World simulated(const std::string& motion, const simulate::DriverBoxErrors& errors, double seconds,
                std::uint64_t seed) {
  const auto rig = body::load_rig("driver-box-body");
  const auto skeleton = body::load_skeleton(rig->skeleton);
  const auto actor = simulate::DriverBoxActor::create(motion, 0.0, *rig, *skeleton, errors, seed);
  simulate::DriverBoxStream stream(*rig, *actor, errors, 22.0, seed);
  World world;
  world.wires = static_cast<std::size_t>(stream.wires());
  std::vector<std::int16_t> slot(static_cast<std::size_t>(stream.slot_samples()) * world.wires);
  while (static_cast<double>(stream.position()) < seconds * 140000.0) {
    stream.next_slot(slot);
    for (const std::int16_t sample : slot) {
      world.samples.push_back(static_cast<float>(sample) / 32768.0F);
    }
    for (auto& pulse : stream.take_pulses()) {
      world.pulses.push_back(std::move(pulse));
    }
  }
  world.format = solve::driver_box_format(*rig, *skeleton, simulate::simulated_calibration(*rig, stream, errors, seed));
  return world;
}

std::vector<RangeReading> decoded(const World& world, const DriverBoxParameters& parameters, std::size_t block) {
  DriverBoxDecoder decoder(world.format, parameters);
  std::vector<RangeReading> readings;
  const std::size_t frames = world.samples.size() / world.wires;
  for (std::size_t i = 0; i < frames; i += block) {
    const std::size_t count = std::min(block, frames - i);
    decoder.push(std::span(world.samples).subspan(i * world.wires, count * world.wires));
    const auto fresh = decoder.take_ranges();
    readings.insert(readings.end(), fresh.begin(), fresh.end());
  }
  decoder.finish();
  const auto fresh = decoder.take_ranges();
  readings.insert(readings.end(), fresh.begin(), fresh.end());
  return readings;
}

double error_of(const World& world, const RangeReading& reading) {
  const simulate::PulseTruth& pulse = world.pulses.at(static_cast<std::size_t>(reading.emission.value / 1120));
  const simulate::PairTruth& pair = pulse.pairs.at(static_cast<std::size_t>(reading.receiver));
  const double later = reading.emission_time.value - static_cast<double>(pulse.emission) / 140000.0;
  return reading.range - pair.range - later * pair.rate;
}

TEST(Ranging, PerfectWorldIsExactWhereItIsAccepted) {
  DriverBoxParameters parameters;
  parameters.inertial = false;
  for (const char* motion : {"wave", "box", "squat"}) {
    const World world = simulated(motion, {}, 5.0, 1);
    const auto readings = decoded(world, parameters, 5000);
    ASSERT_EQ(readings.size(), world.pulses.size() * world.wires);
    int accepted = 0;
    double largest = 0.0;
    for (const RangeReading& reading : readings) {
      if (reading.verdict == RangeVerdict::kAccepted) {
        ++accepted;
        largest = std::max(largest, std::abs(error_of(world, reading)));
      }
    }
    EXPECT_GT(accepted, 2000) << motion;
    EXPECT_LT(largest, 0.05e-3) << motion;
  }
}

TEST(Ranging, BlocksAndThreadsDoNotMatter) {
  const auto errors = simulate::load_driver_box_errors("calibrated");
  ASSERT_TRUE(errors.ok());
  const World world = simulated("box", *errors, 5.0, 4);
  DriverBoxParameters parameters;
  const auto whole = decoded(world, parameters, world.samples.size());
  for (const std::size_t block : {std::size_t{301}, std::size_t{1120}, std::size_t{14000}}) {
    parameters.threads = block == 301 ? 1 : 3;
    const auto parts = decoded(world, parameters, block);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      ASSERT_EQ(parts[i].verdict, whole[i].verdict);
      if (std::isfinite(whole[i].range)) {
        ASSERT_EQ(parts[i].range, whole[i].range);
        ASSERT_EQ(parts[i].variance, whole[i].variance);
        ASSERT_EQ(parts[i].confidence(), whole[i].confidence());
      }
    }
  }
}

// A pose filter's expectation resolves whole cycles from the first pulse on.
TEST(Ranging, APredictionResolvesWholeCycles) {
  const auto errors = simulate::load_driver_box_errors("calibrated");
  ASSERT_TRUE(errors.ok());
  const World world = simulated("wave", *errors, 4.0, 2);
  int clear = 0;
  int accepted = 0;
  int slips = 0;
  for (const bool told : {false, true}) {
    DriverBoxParameters parameters;
    parameters.inertial = false;
    DriverBoxDecoder decoder(world.format, parameters);
    for (int w = 0; told && w < static_cast<int>(world.wires); ++w) {
      decoder.set_prediction(w, [&world, w](int, Seconds time) -> std::optional<RangePrediction> {
        const auto slot = static_cast<std::size_t>(time.value * 140000.0 / 1120.0);
        if (slot >= world.pulses.size()) {
          return std::nullopt;
        }
        // Off by a millimetre, to and fro.
        const simulate::PairTruth& pair = world.pulses[slot].pairs[static_cast<std::size_t>(w)];
        return RangePrediction{pair.range + (slot % 2 == 0 ? 1e-3 : -1e-3), 1.5e-6, pair.off_axis};
      });
    }
    decoder.push(world.samples);
    decoder.finish();
    int now_accepted = 0;
    clear = 0;
    slips = 0;
    for (const RangeReading& reading : decoder.take_ranges()) {
      const auto& pair = world.pulses[static_cast<std::size_t>(reading.emission.value / 1120)]
                             .pairs[static_cast<std::size_t>(reading.receiver)];
      const bool in_sight = pair.loss_db < 1.0 && pair.off_axis < 1.047;
      clear += in_sight ? 1 : 0;
      if (reading.verdict == RangeVerdict::kAccepted) {
        now_accepted += in_sight ? 1 : 0;
        slips += std::abs(error_of(world, reading)) > 4.3e-3 ? 1 : 0;
      }
    }
    if (told) {
      EXPECT_GT(now_accepted, accepted);
    }
    accepted = now_accepted;
  }
  EXPECT_GT(accepted, clear * 85 / 100);
  EXPECT_LE(slips, accepted / 500);
}

// The hat's source is not where most are. Its ranges are resolved by what its own segment's board feels. Where limbs
// swing that is worth 4 to 13 % of its ranges; headings that joints tell serve the chest's frame as well.
TEST(Ranging, ASourceOnAnotherSegmentHasAFrameOfItsOwn) {
  const auto errors = simulate::load_driver_box_errors("paper");
  ASSERT_TRUE(errors.ok());
  for (const char* motion : {"walk", "run"}) {
    const World world = simulated(motion, *errors, 8.0, 6);
    constexpr int kHat = 3;
    ASSERT_FALSE(world.format.wires.front().sources[kHat].fixed);
    ASSERT_EQ(world.format.others.size(), 2U);  // abdomen and head
    World one = world;
    one.format.others.clear();
    int without = 0;
    for (const RangeReading& reading : decoded(one, {}, 28000)) {
      without += reading.source == kHat && reading.verdict == RangeVerdict::kAccepted ? 1 : 0;
    }
    int accepted = 0;
    int slips = 0;
    for (const RangeReading& reading : decoded(world, {}, 28000)) {
      if (reading.source == kHat && reading.verdict == RangeVerdict::kAccepted) {
        ++accepted;
        // The operator's speed of sound is off by 0.5 %.
        slips += std::abs(error_of(world, reading)) > 4.3e-3 + 0.006 * reading.range ? 1 : 0;
        EXPECT_LE(reading.failure, RangingParameters{}.failure);
      }
    }
    EXPECT_LE(slips, 2 + accepted / 200) << motion;
    EXPECT_GT(accepted, without + without / 50) << motion;
  }
}

TEST(Ranging, AGapInterruptsItsSlotsAlone) {
  const World world = simulated("still", {}, 2.0, 1);
  DriverBoxParameters parameters;
  parameters.inertial = false;
  DriverBoxDecoder decoder(world.format, parameters);
  decoder.push(std::span(world.samples).first(100000 * world.wires));
  decoder.gap(SampleCount{3000});
  decoder.push(std::span(world.samples).subspan(103000 * world.wires));
  decoder.finish();
  for (const RangeReading& reading : decoder.take_ranges()) {
    const std::int64_t first = reading.emission.value;
    const bool cut = first < 103000 && first + 1120 > 100000;
    if (cut) {
      EXPECT_EQ(reading.verdict, RangeVerdict::kInterrupted);
    } else if (reading.verdict == RangeVerdict::kAccepted) {
      EXPECT_LT(std::abs(error_of(world, reading)), 0.05e-3);
    }
    if (first + 1400 < 100000 || first > 103500) {
      EXPECT_NE(reading.verdict, RangeVerdict::kInterrupted);
    }
  }
}

}  // namespace
}  // namespace limbwave::decode
