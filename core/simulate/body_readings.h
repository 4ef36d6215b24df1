/// What the boards of a body would report if sound and words were decoded perfectly: angular velocities, specific
/// forces and ranges with the errors of signals.md §4, and the truth beside them. For everything that is judged without
/// the way through samples; shares no kinematics with the filters.
#pragma once

#include <memory>
#include <vector>

#include "simulate/driver_box_actor.h"

namespace limbwave::simulate {

struct ReadingSettings {
  double seconds = 0.0;         ///< 0: the motion's own length.
  double range_noise = 0.0025;  ///< m at 0.6 m on a source's axis, growing with distance (Vlasic et al. 2007, §4.3).
  double outliers = 0.0;        ///< Fraction of ranges that are wrong, by up to `outlier_size`.
  double outlier_size = 0.5;
  double truth_rate_hz = 60.0;
};

struct BoardRow {
  double time_s = 0.0;
  int board = 0;  ///< Index into Rig::gyroscopes.
  Vector3d w_S = Vector3d::Zero(), f_S = Vector3d::Zero();
};

struct RangeRow {
  double time_s = 0.0;  ///< Of the pulse.
  int source = 0, board = 0;
  double range = 0.0, confidence = 1.0;
};

struct TruthRow {
  double time_s = 0.0;
  std::vector<body::SegmentPose> poses;
};

struct SimulatedReadings {
  std::vector<BoardRow> boards;
  std::vector<RangeRow> ranges;
  std::vector<TruthRow> truth;
};

/// Same seed, same readings; every error has a stream of chance of its own.
SimulatedReadings simulate_readings(const DriverBoxActor& actor, const body::Rig& rig, const DriverBoxErrors& errors,
                                    const ReadingSettings& settings, std::uint64_t seed);

}  // namespace limbwave::simulate
