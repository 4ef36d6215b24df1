// How far the root of a walker drifts: free, by standing feet, given. root_table [MOTION] [ERRORS] [SECONDS] [SEED];
// prints, never decides.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

#include "estimate/body_smoother.h"
#include "estimate/body_watch.h"
#include "support/body_runs.h"
#include "support/pose_readings.h"
#include "support/walking_person.h"

namespace {

using namespace limbwave;

template <typename T>
T need(Result<T> result) {
  if (!result) {
    fmt::print(stderr, "{}\n", result.error().text());
    std::exit(1);
  }
  return std::move(result).value();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string motion = argc > 1 ? argv[1] : "walk";
  const std::string profile = argc > 2 ? argv[2] : "paper";
  simulate::ReadingSettings settings;
  settings.seconds = argc > 3 ? std::atof(argv[3]) : 0.0;
  const auto seed = static_cast<std::uint64_t>(argc > 4 ? std::atoi(argv[4]) : 1);
  const body::Rig rig = need(body::load_rig("driver-box-body"));
  const body::Skeleton skeleton = need(body::load_skeleton(rig.skeleton));
  const estimate::BodyModel model = estimate::body_model(rig, skeleton);
  estimate::BodyReadings readings;
  std::vector<simulate::TruthRow> truth;
  // The way from the rest pose to a recorded motion's beginning is no walk: it begins in mid-motion.
  double begin_s = 0.7;
  if (motion == "overground") {
    const testing_support::WalkingPerson person(skeleton);
    const auto poses = [&](double t) { return person.poses(t); };
    const double seconds = settings.seconds > 0.0 ? settings.seconds : 30.0;
    readings = testing_support::read_poses(
        poses, model, seconds, 140.0,
        profile == "none" ? testing_support::BoardErrors{} : testing_support::BoardErrors::worn(),
        static_cast<unsigned>(seed));
    for (const estimate::RootReading& root : readings.root) {
      truth.push_back({root.time_s, person.poses(root.time_s)});
    }
    begin_s = testing_support::WalkingPerson::kRest;
  } else {
    const simulate::DriverBoxErrors errors = need(simulate::load_driver_box_errors(profile));
    const auto actor = need(simulate::DriverBoxActor::create(motion, 0.0, rig, skeleton, errors, seed, 0.0));
    settings.seconds = settings.seconds > 0.0 ? settings.seconds : actor->duration();
    simulate::SimulatedReadings simulated = simulate::simulate_readings(*actor, rig, errors, settings, seed);
    readings = testing_support::readings_of(simulated);
    truth = std::move(simulated.truth);
  }
  double way = 0.0;
  for (std::size_t i = 1; i < readings.root.size(); ++i) {
    if (readings.root[i].time_s > begin_s) {
      way += (readings.root[i].p_W - readings.root[i - 1].p_W).norm();
    }
  }
  fmt::print("{} errors {} seed {}: {:.0f} s, root's way {:.1f} m\n", motion, profile, seed,
             readings.inertial.back().time_s, way);
  fmt::print(
      "root              place: mean    end    of way | height | tilt mean | heading end | joints | sigma end\n");
  for (const std::string mode : {"free", "contacts", "contacts both", "given"}) {
    if (argc > 5 && std::string(argv[5]).find(mode) == std::string::npos) {
      continue;
    }
    estimate::BodyFilterParameters p;
    p.root = mode == "given" ? estimate::RootMode::kGiven : estimate::RootMode::kFree;
    estimate::BodyWatchParameters watch_parameters;
    watch_parameters.contacts.feet = mode.starts_with("contacts");
    const auto tuned = [](const char* name, double otherwise) {
      const char* value = std::getenv(name);
      return value != nullptr ? std::atof(value) : otherwise;
    };
    p.root_speed = tuned("SPEED", p.root_speed);
    p.acceleration_walk = tuned("WALK", p.acceleration_walk);
    p.gyroscope_relative = tuned("GRELATIVE", p.gyroscope_relative);
    p.accelerometer_relative = tuned("ARELATIVE", p.accelerometer_relative);
    p.bone_scale = tuned("BONE", p.bone_scale);
    p.mount_rotation_walk = tuned("MOUNTWALK", p.mount_rotation_walk);
    p.mount_rotation = tuned("MOUNT", p.mount_rotation);
    estimate::BodyWatch watch(model, watch_parameters);
    const auto begin = std::chrono::steady_clock::now();
    const estimate::BodyRun run = mode.ends_with("both")
                                      ? need(estimate::smooth_body(model, p, readings, 60.0, {}, 1.5, &watch))
                                      : need(estimate::filter_body(model, p, readings, 60.0, {}, &watch));
    const double busy = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    testing_support::Errors place, tilt, joints, height;
    std::map<std::string, testing_support::Errors> by_name;
    double end = 0.0, heading = 0.0;
    std::size_t k = 0;
    // Where the wearer began is the estimate's own; so is the heading.
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    std::vector<double> far;
    for (std::size_t i = 0; i < run.track.times.size(); ++i) {
      while (k + 1 < truth.size() && truth[k].time_s < run.track.times[i] - 1e-4) {
        ++k;
      }
      const body::SegmentPose& real = truth[k].poses.front();
      const Eigen::Quaterniond R = skeleton.segments.front().R_PL_rest * run.track.R_joint[i].front();
      if (run.track.times[i] < begin_s) {
        shift = real.p_WL - run.track.root_p_W[i];
      }
      const Eigen::Vector3d off = run.track.root_p_W[i] + shift - real.p_WL;
      if (run.track.times[i] < begin_s) {
        continue;
      }
      if (std::getenv("TRACE") != nullptr && i % 6 == 0) {
        fmt::print("   {:.2f} s off {:.3f} {:.3f} {:.3f} of {:.3f}\n", run.track.times[i], off.x(), off.y(), off.z(),
                   real.p_WL.x());
      }
      place.add(off.norm());
      height.add(std::abs(off.z()));
      far.push_back(off.norm());
      end = off.norm();
      const Eigen::Vector3d up = R.conjugate() * Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d up_real = real.R_WL.conjugate() * Eigen::Vector3d::UnitZ();
      tilt.add(degrees(std::acos(std::min(1.0, up.dot(up_real)))));
      const Eigen::Quaterniond turn = R * real.R_WL.conjugate();
      heading = degrees(2.0 * std::atan2(turn.z(), turn.w()));
      testing_support::JointErrors one;
      one.add(skeleton, run.track.R_joint[i], truth[k].poses);
      joints.add(one.all.mean());
      for (const auto& [name, e] : one.by_name) {
        by_name[name].add(e.mean());
      }
    }
    fmt::print("{:<16} {:8.3f} m {:7.3f} m {:6.2f} % | {:.3f} | {:6.2f}° | {:8.2f}° | {:6.2f}° | {:.3f} m ({:.1f} x)\n",
               mode, place.mean(), end, 100.0 * end / std::max(way, 0.1), height.mean(), tilt.mean(), heading,
               joints.mean(), run.track.root_sigma.back().norm(), readings.inertial.back().time_s / busy);
    if (std::getenv("VERBOSE") != nullptr) {
      for (const auto& [name, e] : by_name) {
        fmt::print("   {:<16} {:6.2f} max {:6.2f}\n", name, e.mean(), e.largest);
      }
      for (std::size_t i = 0; i < far.size(); i += 60) {
        fmt::print(" {:.2f}", far[i]);
      }
      fmt::print("\n");
    }
    for (const Diagnostic& finding : watch.findings()) {
      fmt::print("    {}\n", finding.text());
    }
    for (const Diagnostic& finding : run.diagnostics) {
      fmt::print("    {}\n", finding.text());
    }
  }
  return 0;
}
