// Every source of error switches exactly one thing on: what the others do stays the same, bit for bit.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "simulate/line_support.h"
#include "simulate/simulation.h"

namespace limbwave::simulate {
namespace {

// Everything that an error could touch, apart.
struct World {
  std::vector<double> offsets, gains, crosses, mount_angles, mount_offsets;
  std::vector<double> bones;   // true poses
  std::vector<double> forces;  // what the sensors feel in a pose of the motion
  std::vector<double> cycles;  // starts of cycles
  std::vector<std::byte> bytes;
};

World observe(const LineInErrors& errors) {
  SimulateSettings settings;
  settings.motion = "box";  // reaches saturation
  settings.prologue = false;
  settings.errors = errors;
  settings.seed = 11;
  settings.format.type = acquire::SampleType::kInt24;
  auto made = make_simulation(settings);
  EXPECT_TRUE(made) << made.error().text();
  const Simulation& simulation = **made;
  World world;
  for (int s = 0; s < 5; ++s) {
    const ActualSensor& sensor = simulation.wearer->sensors()[static_cast<std::size_t>(s)];
    for (int i = 0; i < 3; ++i) {
      world.offsets.push_back(sensor.offset_g[i]);
      world.mount_offsets.push_back(sensor.p_LS[i]);
      for (int j = 0; j < 3; ++j) {
        (i == j ? world.gains : world.crosses).push_back(sensor.M(i, j));
      }
    }
    world.mount_angles.insert(world.mount_angles.end(), sensor.R_LS.coeffs().begin(), sensor.R_LS.coeffs().end());
    const auto R = simulation.wearer->orientation(s, 2.6)->coeffs();
    world.bones.insert(world.bones.end(), R.begin(), R.end());
    const Vector3d f = simulation.wearer->specific_force(s, 2.6);
    world.forces.insert(world.forces.end(), f.begin(), f.end());
  }
  world.bytes.resize(48000 * 3 * settings.format.bytes_per_frame());
  simulation.stream->read(world.bytes);
  world.cycles = simulation.stream->take_cycle_starts();
  return world;
}

std::set<std::string> differences(const World& a, const World& b) {
  std::set<std::string> names;
  const auto compare = [&](const char* name, const auto& x, const auto& y) {
    if (x != y) {
      names.insert(name);
    }
  };
  compare("offset", a.offsets, b.offsets);
  compare("gain", a.gains, b.gains);
  compare("cross", a.crosses, b.crosses);
  compare("mount angle", a.mount_angles, b.mount_angles);
  compare("mount offset", a.mount_offsets, b.mount_offsets);
  compare("bones", a.bones, b.bones);
  compare("forces", a.forces, b.forces);
  compare("cycles", a.cycles, b.cycles);
  compare("signal", a.bytes, b.bytes);
  return names;
}

using Names = std::set<std::string>;

TEST(SingleErrors, EachDoesItsOwnAndNothingElse) {
  const World perfect = observe({});
  const auto changed = [&](const auto& set) {
    LineInErrors errors;
    set(errors);
    return differences(perfect, observe(errors));
  };
  using E = LineInErrors;
  EXPECT_EQ(changed([](E& e) { e.accelerometer_noise = 0.02; }), (Names{"signal"}));
  EXPECT_EQ(changed([](E& e) { e.offset_g = 0.1; }), (Names{"offset", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.scale = 0.1; }), (Names{"gain", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.cross_axis = 0.01; }), (Names{"cross", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.saturates = true; }), (Names{"signal"}));
  EXPECT_EQ(changed([](E& e) { e.mount_angle = 0.05; }), (Names{"mount angle", "forces", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.mount_offset = 0.005; }), (Names{"mount offset", "forces", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.soft_tissue_angle = 0.03; }), (Names{"forces", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.soft_tissue_offset = 0.004; }), (Names{"forces", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.pose_angle = 0.1; }), Names{});  // no poses without the prologue
  EXPECT_EQ(changed([](E& e) { e.clock_offset = 0.03; }), (Names{"cycles", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.clock_wander = 0.003; }), (Names{"cycles", "signal"}));
  EXPECT_EQ(changed([](E& e) { e.clock_jitter = 0.001; }), (Names{"cycles", "signal"}));
  const Names signal{"signal"};
  EXPECT_EQ(changed([](E& e) { e.settle_s = 2e-5; }), signal);
  EXPECT_EQ(changed([](E& e) { e.coupling_hz = 5; }), signal);
  EXPECT_EQ(changed([](E& e) { e.ringing = 0.1, e.ringing_hz = 9000, e.ringing_decay_s = 1e-4; }), signal);
  EXPECT_EQ(changed([](E& e) { e.anti_alias = true; }), signal);
  EXPECT_EQ(changed([](E& e) { e.noise_db = -60; }), signal);
  EXPECT_EQ(changed([](E& e) { e.hum = 0.01; }), signal);
  EXPECT_EQ(changed([](E& e) { e.gain = 0.3; }), signal);
  EXPECT_EQ(changed([](E& e) { e.dither = true; }), signal);
  EXPECT_EQ(changed([](E& e) { e.left_inverted = true; }), signal);
  EXPECT_EQ(changed([](E& e) { e.right_inverted = true; }), signal);
  EXPECT_EQ(changed([](E& e) { e.swapped = true; }), signal);
  EXPECT_EQ(changed([](E& e) { e.knob_time_s = 1, e.knob_factor = 0.5; }), signal);
  EXPECT_EQ(changed([](E& e) { e.silence_time_s = 1, e.silence_duration_s = 0.1; }), signal);
  EXPECT_EQ(changed([](E& e) { e.drop_every_s = 1, e.drop_frames = 10; }), signal);
}

TEST(SingleErrors, DrawsDoNotDependOnOtherErrors) {
  LineInErrors offset_only;
  offset_only.offset_g = 0.1;
  LineInErrors all = offset_only;
  all.scale = 0.1;
  all.cross_axis = 0.01;
  all.mount_angle = 0.05;
  all.clock_wander = 0.003;
  const World a = observe(offset_only);
  const World b = observe(all);
  EXPECT_EQ(a.offsets, b.offsets);
  LineInErrors wander_only;
  wander_only.clock_wander = 0.003;
  EXPECT_EQ(observe(wander_only).cycles, b.cycles);
}

TEST(SingleErrors, SensorDrawsHaveTheirSpread) {
  LineInErrors errors;
  errors.offset_g = 0.1;
  errors.scale = 0.05;
  errors.cross_axis = 0.01;
  errors.mount_angle = 0.05;
  const auto rig = body::load_rig("line-in-arm");
  const auto skeleton = body::load_skeleton(rig->skeleton);
  double offset = 0.0;
  double gain = 0.0;
  double cross = 0.0;
  double largest = 0.0;
  std::set<std::string> serials;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    for (const ActualSensor& sensor : draw_sensors(*rig, *skeleton, errors, seed)) {
      serials.insert(sensor.serial);
      offset += sensor.offset_g.squaredNorm() / 3000;
      gain += (sensor.M.diagonal() - Vector3d::Ones()).squaredNorm() / 3000;
      Matrix3d rest = sensor.M;
      rest.diagonal().setZero();
      cross += rest.squaredNorm() / 6000;
      largest = std::max(largest, sensor.offset_g.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_NEAR(std::sqrt(offset), 0.1, 0.005);
  EXPECT_NEAR(std::sqrt(gain), 0.05, 0.0025);
  EXPECT_NEAR(std::sqrt(cross), 0.01, 0.0004);
  EXPECT_LE(largest, 0.3 + 1e-12);
  EXPECT_EQ(serials.size(), 1000U);
  EXPECT_TRUE(serials.contains("SIM-7-3"));
}

}  // namespace
}  // namespace limbwave::simulate
