// Table 1 of Vlasic et al. 2007 on simulated takes: all seven combinations of sensors, side by side with the paper.
// body_table [MOTION] [ERRORS] [SECONDS] [SEED] [COMBINATIONS...]; prints, never decides.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "support/body_runs.h"

namespace {

using namespace limbwave;
using testing_support::JointErrors;

struct PaperRow {
  const char* sensors;
  double figures[6];
};
constexpr PaperRow kPaper[] = {{"A", {159.7, 147.7, 168.6, 105.9, 184.0, 146.0}},
                               {"AD", {74.0, 125.4, 178.6, 110.9, 165.5, 144.5}},
                               {"D", {120.2, 93.4, 54.7, 37.0, 117.4, 79.2}},
                               {"G", {25.9, 15.9, 10.1, 7.0, 8.3, 8.0}},
                               {"GD", {18.4, 7.4, 8.1, 5.8, 9.8, 5.4}},
                               {"AG", {9.5, 3.4, 10.9, 6.4, 5.6, 4.0}},
                               {"AGD", {5.7, 2.9, 8.0, 5.0, 6.6, 3.8}}};

template <typename T>
T need(Result<T> result) {
  if (!result) {
    fmt::print(stderr, "{}\n", result.error().text());
    std::exit(1);
  }
  return std::move(result).value();
}

double tuned(const char* name, double otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::atof(value) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string motion = argc > 1 ? argv[1] : "every-joint";
  const std::string profile = argc > 2 ? argv[2] : "paper";
  simulate::ReadingSettings settings;
  settings.seconds = argc > 3 ? std::atof(argv[3]) : 0.0;
  const auto seed = static_cast<std::uint64_t>(argc > 4 ? std::atoi(argv[4]) : 1);
  const body::Rig rig = need(body::load_rig("driver-box-body"));
  const body::Skeleton skeleton = need(body::load_skeleton(rig.skeleton));
  const simulate::DriverBoxErrors errors = need(simulate::load_driver_box_errors(profile));
  const auto actor = need(simulate::DriverBoxActor::create(motion, 0.0, rig, skeleton, errors, seed, 3.0));
  const simulate::SimulatedReadings simulated = simulate::simulate_readings(*actor, rig, errors, settings, seed);
  const estimate::BodyReadings readings = testing_support::readings_of(simulated);
  const auto instants = estimate::instants_of(readings);
  fmt::print("{} errors {}: {:.0f} s, {} inertial readings, {} ranges\n", motion, profile,
             readings.inertial.back().time_s, readings.inertial.size(), readings.ranges.size());
  fmt::print(
      "sensors |     neck          right shoulder    left hip      | paper's                               | all "
      "joints | x real time\n");
  for (const PaperRow& row : kPaper) {
    if (argc > 5) {
      bool wanted = false;
      for (int i = 5; i < argc; ++i) {
        wanted = wanted || std::string(argv[i]) == row.sensors;
      }
      if (!wanted) {
        continue;
      }
    }
    const std::string sensors = row.sensors;
    estimate::BodyFilterParameters p;
    p.root = estimate::RootMode::kGiven;
    p.use_accelerometers = sensors.find('A') != std::string::npos;
    p.use_gyroscopes = sensors.find('G') != std::string::npos;
    p.use_ranges = sensors.find('D') != std::string::npos;
    p.acceleration_walk = tuned("WALK", p.acceleration_walk);
    p.mount_rotation_walk = tuned("MOUNTWALK", p.mount_rotation_walk);
    p.mount_rotation = tuned("MOUNT", p.mount_rotation);
    p.mount_place_walk = tuned("PLACEWALK", p.mount_place_walk);
    p.accelerometer_relative = tuned("ARELATIVE", p.accelerometer_relative);
    p.gyroscope_relative = tuned("GRELATIVE", p.gyroscope_relative);
    p.rest_pose = tuned("REST", p.rest_pose);
    p.bone_scale = tuned("BONE", p.bone_scale);
    p.mount_place = tuned("PLACE", p.mount_place);
    p.range_noise = tuned("RANGE", p.range_noise);
    p.source_place = tuned("SOURCE", p.source_place);
    p.gate_probability = tuned("GATE", p.gate_probability);
    p.limit_softness = tuned("LIMIT", p.limit_softness);
    p.accelerometer_noise = tuned("ANOISE", p.accelerometer_noise);
    estimate::BodyFilter filter(estimate::body_model(rig, skeleton), p);
    filter.start(0.0, &readings.root.front());
    JointErrors joints;
    std::size_t next = 0;
    std::chrono::duration<double> busy{};
    for (const estimate::BodyInstant& instant : instants) {
      const auto begin = std::chrono::steady_clock::now();
      if (instant.inertials > 0) {
        const estimate::RootReading root = estimate::root_at(readings.root, instant.time_s);
        filter.step(instant, &root);
      } else if (p.use_ranges) {
        filter.step(instant, nullptr);
      }
      busy += std::chrono::steady_clock::now() - begin;
      // Poses at the first instant that is not before the truth's.
      while (next < simulated.truth.size() && simulated.truth[next].time_s <= instant.time_s + 1e-6) {
        const bool near = instant.time_s - simulated.truth[next].time_s < 1e-6;
        std::vector<simulate::FrameJet> frames;
        std::vector<body::SegmentPose> truth = simulated.truth[next].poses;
        if (!near) {
          actor->frames(filter.state().time_s, frames);
          for (std::size_t i = 0; i < frames.size(); ++i) {
            truth[i] = {frames[i].R_W.v, frames[i].p_W.v};
          }
        }
        joints.add(skeleton, filter.tree().segment_rotations(filter.state().joints), truth);
        ++next;
      }
    }
    const auto cell = [&](const char* name) {
      const auto& e = joints.by_name[name];
      return fmt::format("{:6.2f}/{:6.2f}", e.mean(), e.sd());
    };
    fmt::print(
        "{:<7} | {}   {}   {} | {:5.1f}/{:5.1f} {:5.1f}/{:5.1f} {:5.1f}/{:5.1f} | {:5.2f} max {:5.2f} | {:.1f} ({} "
        "states)\n",
        row.sensors, cell("neck"), cell("right_upper_arm"), cell("left_thigh"), row.figures[0], row.figures[1],
        row.figures[2], row.figures[3], row.figures[4], row.figures[5], joints.all.mean(), joints.all.largest,
        readings.inertial.back().time_s / busy.count(), filter.layout().size);
    if (std::getenv("VERBOSE") != nullptr) {
      for (const auto& [name, e] : joints.by_name) {
        fmt::print("   {:<16} {:6.2f} / {:5.2f}  max {:6.2f}\n", name, e.mean(), e.sd(), e.largest);
      }
      for (std::size_t b = 0; b < filter.model().boards.size(); ++b) {
        const auto& g = filter.gyroscope_counts()[b];
        const auto& a = filter.accelerometer_counts()[b];
        fmt::print("   {:<16} G {} gated {} clipped {} nis {:.2f}   A {} gated {} clipped {} nis {:.2f}\n",
                   filter.model().boards[b].name, g.used, g.gated, g.clipped,
                   g.nis_sum / static_cast<double>(std::max<std::int64_t>(1, g.used + g.gated)), a.used, a.gated,
                   a.clipped, a.nis_sum / static_cast<double>(std::max<std::int64_t>(1, a.used + a.gated)));
      }
      for (std::size_t s = 0; s < filter.model().sources.size(); ++s) {
        const auto& d = filter.range_counts()[s];
        fmt::print("   {:<16} D {} gated {} nis {:.2f}\n", filter.model().sources[s].name, d.used, d.gated,
                   d.nis_sum / static_cast<double>(std::max<std::int64_t>(1, d.used + d.gated)));
      }
    }
  }
  return 0;
}
