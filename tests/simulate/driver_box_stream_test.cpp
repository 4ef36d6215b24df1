// What the wires carry, measured from the samples alone, against what the world is said to be.
#include "simulate/driver_box_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace limbwave::simulate {
namespace {

struct World {
  explicit World(const DriverBoxErrors& errors, const std::string& motion = "walk", std::uint64_t seed = 3) {
    rig = *body::load_rig("driver-box-body");
    rig.driver_box->word_amplitude = 0.0;  // sound alone
    skeleton = *body::load_skeleton(rig.skeleton);
    actor = *DriverBoxActor::create(motion, 0.0, rig, skeleton, errors, seed);
    stream = std::make_unique<DriverBoxStream>(rig, actor, errors, 22.0, seed);
    slot.resize(static_cast<std::size_t>(stream->slot_samples() * stream->wires()));
  }
  // The next slot of one wire, full scale 1.
  std::vector<double> wire(int w) {
    std::vector<double> samples;
    for (int n = 0; n < stream->slot_samples(); ++n) {
      samples.push_back(slot[static_cast<std::size_t>(n * stream->wires() + w)] / 32768.0);
    }
    return samples;
  }
  PulseTruth next() {
    stream->next_slot(slot);
    auto pulses = stream->take_pulses();
    return pulses.empty() ? PulseTruth{} : std::move(pulses.back());
  }
  body::Rig rig;
  body::Skeleton skeleton;
  std::shared_ptr<const DriverBoxActor> actor;
  std::unique_ptr<DriverBoxStream> stream;
  std::vector<std::int16_t> slot;
};

double energy(const std::vector<double>& samples, std::size_t from = 0, std::size_t to = SIZE_MAX) {
  double sum = 0.0;
  for (std::size_t n = from; n < std::min(to, samples.size()); ++n) {
    sum += samples[n] * samples[n];
  }
  return sum;
}

// First sample that stands out of silence.
int onset(const std::vector<double>& samples, double peak) {
  for (std::size_t n = 0; n < samples.size(); ++n) {
    if (std::abs(samples[n]) > 0.002 * peak) {
      return static_cast<int>(n);
    }
  }
  return -1;
}

TEST(DriverBoxStream, NothingIsHeardBeforeSoundCanBeThere) {
  World world({});
  int heard = 0;
  for (int s = 0; s < 64; ++s) {
    const PulseTruth truth = world.next();
    for (int w = 0; w < world.stream->wires(); ++w) {
      const auto samples = world.wire(w);
      const double peak = std::abs(*std::max_element(samples.begin(), samples.end()));
      const PairTruth& pair = truth.pairs[static_cast<std::size_t>(w)];
      const double arrival = pair.range / world.stream->speed_of_sound() * 140000.0;
      if (peak < 0.005) {
        continue;
      }
      ++heard;
      EXPECT_GE(onset(samples, peak), std::floor(arrival)) << s << " " << w;
      EXPECT_LE(onset(samples, peak), arrival + 14.0) << s << " " << w;
      EXPECT_LT(energy(samples, 0, static_cast<std::size_t>(std::max(0.0, std::floor(arrival)))), 1e-7);
    }
  }
  EXPECT_GT(heard, 300);
}

// Along one source's way: 1 / r, 1.3 dB/m, the pattern of radiation, nothing else.
TEST(DriverBoxStream, AmplitudeFallsAsTheRigSays) {
  World world({});
  const body::DriverBoxSignal& box = *world.rig.driver_box;
  int compared = 0;
  for (int s = 0; s < 400; ++s) {
    const PulseTruth truth = world.next();
    for (int w = 0; w < world.stream->wires(); ++w) {
      const PairTruth& pair = truth.pairs[static_cast<std::size_t>(w)];
      const double degrees = pair.off_axis * 180.0 / std::numbers::pi;
      const double tenth = std::round(degrees / 10.0);
      // Where the table has an angle, within a degree.
      if (std::abs(degrees - 10.0 * tenth) > 1.0 || degrees > 61.0) {
        continue;
      }
      const auto samples = world.wire(w);
      double peak = 0.0;
      for (const double sample : samples) {
        peak = std::max(peak, std::abs(sample));
      }
      const double expected = box.source_level_m * box.radiation[static_cast<std::size_t>(tenth)] / pair.range *
                              std::pow(10.0, -box.absorption_db_m * pair.range / 20.0);
      // Three and a half samples a cycle miss the crest by a little.
      EXPECT_LT(peak, 1.05 * expected) << s << " " << w;
      EXPECT_GT(peak, 0.88 * expected) << s << " " << w;
      ++compared;
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(DriverBoxStream, NoiseIsThatOfTheProfilesSnr) {
  DriverBoxErrors errors;
  errors.snr_db = 25.0;
  World world(errors);
  world.stream->set_schedule({255});  // silence
  double sum = 0.0;
  std::size_t count = 0;
  for (int s = 0; s < 20; ++s) {
    world.next();
    for (int w = 0; w < world.stream->wires(); ++w) {
      sum += energy(world.wire(w));
      count += static_cast<std::size_t>(world.stream->slot_samples());
    }
  }
  const body::DriverBoxSignal& box = *world.rig.driver_box;
  const double peak = box.source_level_m / 0.6 * std::pow(10.0, -box.absorption_db_m * 0.6 / 20.0);
  const double in_band = sum / static_cast<double>(count) * 5000.0 / (0.5 * box.rate_hz);
  EXPECT_NEAR(10.0 * std::log10(0.5 * peak * peak / in_band), 25.0, 0.1);
}

TEST(DriverBoxStream, AScheduleFiresItsSourcesAndNoOthers) {
  World world({});
  world.stream->set_schedule({6, 255, 1});
  const int expected[] = {6, -1, 1, 6, -1, 1};
  for (const int source : expected) {
    const PulseTruth truth = world.next();
    EXPECT_EQ(truth.pairs.empty() ? -1 : truth.source, source);
  }
}

TEST(DriverBoxStream, ThreadsChangeNothing) {
  const auto errors = load_driver_box_errors("paper");
  ASSERT_TRUE(errors.ok());
  World one(*errors);
  World three(*errors);
  three.stream->set_threads(3);
  for (int s = 0; s < 60; ++s) {
    const PulseTruth a = one.next();
    const PulseTruth b = three.next();
    ASSERT_EQ(one.slot, three.slot) << s;
    for (std::size_t w = 0; w < a.pairs.size(); ++w) {
      ASSERT_EQ(a.pairs[w].range, b.pairs[w].range);
      ASSERT_EQ(a.pairs[w].loss_db, b.pairs[w].loss_db);
    }
  }
}

// A microphone that moves away hears a longer pulse of a lower pitch, and truth says how fast.
TEST(DriverBoxStream, TruthsRateIsThatOfItsRanges) {
  World world({}, "box");
  std::vector<PulseTruth> pulses;
  for (int s = 0; s < 400; ++s) {
    pulses.push_back(world.next());
  }
  double fastest = 0.0;
  for (std::size_t s = 8; s + 8 < pulses.size(); ++s) {
    for (std::size_t w = 0; w < pulses[s].pairs.size(); ++w) {
      const double rate = (pulses[s + 8].pairs[w].range - pulses[s - 8].pairs[w].range) / 0.128;
      const double bend = pulses[s + 8].pairs[w].range - 2.0 * pulses[s].pairs[w].range + pulses[s - 8].pairs[w].range;
      fastest = std::max(fastest, std::abs(pulses[s].pairs[w].rate));
      // Over 0.128 s limbs turn; where they hardly do, the two agree.
      if (std::abs(bend) < 1e-4) {
        EXPECT_NEAR(pulses[s].pairs[w].rate, rate, 0.15);
      }
    }
  }
  EXPECT_GT(fastest, 1.0);
}

// Every error of the sound by itself: what it does to the samples and to the truth, and that it does so again.
TEST(DriverBoxStream, EveryErrorOfTheSoundHasItsOwnSwitch) {
  using E = DriverBoxErrors;
  const struct {
    const char* name;
    std::function<void(E&)> on;
    bool moves_truth;  // ranges as they are
  } switches[] = {
      {"snr_db", [](E& e) { e.snr_db = 25.0; }, false},
      {"occlusion", [](E& e) { e.occlusion = true; }, false},
      {"floor_echo", [](E& e) { e.floor_echo = 0.5; }, false},
      {"wall_echo", [](E& e) { e.wall_echo = 0.6; }, false},
      {"source_delay", [](E& e) { e.source_delay = 36e-6; }, false},
      {"phase_off_axis", [](E& e) { e.phase_off_axis = 0.5; }, false},
      {"speed_of_sound", [](E& e) { e.speed_of_sound = 0.005; }, false},
      {"source_level_db", [](E& e) { e.source_level_db = 1.0; }, false},
      {"keys", [](E& e) { e.keys_per_minute = 300.0; }, false},
      {"brakes", [](E& e) { e.brakes_per_minute = 300.0; }, false},
      {"mount_offset", [](E& e) { e.mount_offset = 0.005; }, true},
      {"soft_tissue", [](E& e) { e.soft_tissue_offset = 0.004; }, true},
      {"bone_length", [](E& e) { e.bone_length = 0.02; }, true},
      {"rest_pose", [](E& e) { e.rest_pose = 0.07; }, true},
  };
  const auto run = [](const E& errors, std::vector<std::int16_t>& samples, std::vector<double>& ranges) {
    World world(errors);
    for (int s = 0; s < 60; ++s) {
      const PulseTruth truth = world.next();
      samples.insert(samples.end(), world.slot.begin(), world.slot.end());
      for (const PairTruth& pair : truth.pairs) {
        ranges.push_back(pair.range);
      }
    }
  };
  std::vector<std::int16_t> none;
  std::vector<double> none_ranges;
  run({}, none, none_ranges);
  for (const auto& entry : switches) {
    E errors;
    entry.on(errors);
    std::vector<std::int16_t> once;
    std::vector<std::int16_t> again;
    std::vector<double> ranges;
    std::vector<double> ranges_again;
    run(errors, once, ranges);
    run(errors, again, ranges_again);
    EXPECT_EQ(once, again) << entry.name;
    EXPECT_NE(once, none) << entry.name << " does nothing";
    double moved = 0.0;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      moved = std::max(moved, std::abs(ranges[i] - none_ranges[i]));
    }
    EXPECT_EQ(moved > 2e-4, entry.moves_truth) << entry.name << " " << moved;
  }
}

}  // namespace
}  // namespace limbwave::simulate
