#include "decode/pulse_listener.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulate/sound_pulse.h"

namespace limbwave::decode {
namespace {

constexpr double kRate = 140000.0;
constexpr double kDelay = 2.5e-3;
constexpr int kSlots = 12;

RangingFormat two_sources() {
  RangingFormat format;
  format.sources.resize(2);
  return format;
}

// Every slot has a pulse, and white noise.
std::vector<float> wire(double noise) {
  const simulate::SoundPulse pulse{body::DriverBoxSignal{}};
  std::vector<float> samples(static_cast<std::size_t>(kSlots) * 1120, 0.0F);
  std::mt19937_64 random(5);
  std::normal_distribution<float> normal;
  for (int slot = 0; slot < kSlots; ++slot) {
    // The carrier of every slot begins with it.
    pulse.add(samples.data() + static_cast<std::size_t>(slot) * 1120, 1100, -kDelay, 1.0 / kRate, 1.0, 0.1, 0.0);
  }
  for (float& sample : samples) {
    sample += static_cast<float>(noise) * normal(random);
  }
  return samples;
}

std::vector<HeardSlot> heard(const std::vector<float>& samples, std::size_t block) {
  PulseListener listener(two_sources(), SampleRate{kRate}, {}, nullptr);
  std::vector<HeardSlot> slots;
  for (std::size_t i = 0; i < samples.size(); i += block) {
    listener.push(samples.data() + i, std::min(block, samples.size() - i), 1);
    for (const HeardSlot& slot : listener.take()) {
      slots.push_back(slot);
    }
  }
  listener.finish();
  for (const HeardSlot& slot : listener.take()) {
    slots.push_back(slot);
  }
  return slots;
}

TEST(PulseListener, EverySlotHasItsSourceAndItsPulse) {
  const auto slots = heard(wire(1e-4), 5000);
  ASSERT_EQ(slots.size(), static_cast<std::size_t>(kSlots));
  for (int i = 0; i < kSlots; ++i) {
    const HeardSlot& slot = slots[static_cast<std::size_t>(i)];
    EXPECT_EQ(slot.slot, i);
    EXPECT_EQ(slot.source, i % 2);
    EXPECT_FALSE(slot.cut);
    ASSERT_GE(slot.count, 1U);
    EXPECT_NEAR(slot.arrivals[0].delay_s, kDelay, 3e-6);
    EXPECT_NEAR(slot.arrivals[0].amplitude, 0.1, 2e-3);
  }
}

TEST(PulseListener, BlocksDoNotMatter) {
  const std::vector<float> samples = wire(3e-3);
  const auto whole = heard(samples, samples.size());
  for (const std::size_t block : {std::size_t{1}, std::size_t{333}, std::size_t{1120}}) {
    const auto parts = heard(samples, block);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      ASSERT_EQ(parts[i].count, whole[i].count);
      EXPECT_EQ(parts[i].noise, whole[i].noise);
      EXPECT_EQ(parts[i].arrivals[0].delay_s, whole[i].arrivals[0].delay_s);
      EXPECT_EQ(parts[i].arrivals[0].phase, whole[i].arrivals[0].phase);
    }
  }
}

// The quarter of a slot's values that are weakest tells the noise, whatever the pulse.
TEST(PulseListener, NoiseGoesWithThePower) {
  const double low = heard(wire(1e-3), 5000).back().noise;
  const double high = heard(wire(2e-3), 5000).back().noise;
  EXPECT_NEAR(high / low, 4.0, 0.4);
}

TEST(PulseListener, AGapCutsTheSlotsItTouches) {
  const std::vector<float> samples = wire(1e-4);
  PulseListener listener(two_sources(), SampleRate{kRate}, {}, nullptr);
  listener.push(samples.data(), 4000, 1);
  listener.gap(SampleCount{1000});
  listener.push(samples.data() + 5000, samples.size() - 5000, 1);
  listener.finish();
  for (const HeardSlot& slot : listener.take()) {
    const bool touched = slot.slot * 1120 < 5000 && (slot.slot + 1) * 1120 > 4000;
    if (touched) {
      EXPECT_TRUE(slot.cut) << slot.slot;
    }
    if (slot.slot < 2 || slot.slot > 5) {
      EXPECT_FALSE(slot.cut) << slot.slot;
      EXPECT_NEAR(slot.arrivals[0].delay_s, kDelay, 3e-6);
    }
  }
}

}  // namespace
}  // namespace limbwave::decode
