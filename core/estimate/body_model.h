/// What the body filter knows of the wearer: skeleton, boards, sources; and what is measured.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <vector>

#include "body/rig.h"
#include "body/skeleton.h"

namespace limbwave::estimate {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A board: what of a rig's gyroscopes, accelerometers and microphones has the same name. One place for all three.
struct BodyBoard {
  std::string name;
  int segment = 0;
  Quaterniond R_LS = Quaterniond::Identity();
  Vector3d p_LS = Vector3d::Zero();
  bool gyroscope = false, accelerometer = false, microphone = false;
};

/// An ultrasonic source (Vlasic et al. 2007, §3.2).
struct BodySource {
  std::string name;
  int segment = 0;
  Vector3d p_LS = Vector3d::Zero();
  Vector3d normal_L = Vector3d::UnitZ();
};

struct BodyModel {
  body::Skeleton skeleton;
  std::vector<BodyBoard> boards;
  std::vector<BodySource> sources;
  double gyroscope_range = std::numeric_limits<double>::infinity();      ///< Readings beyond are clipped, rad/s.
  double accelerometer_range = std::numeric_limits<double>::infinity();  ///< The same, m/s².

  [[nodiscard]] int find_board(const std::string& name) const;   ///< Index, or -1.
  [[nodiscard]] int find_source(const std::string& name) const;  ///< Index, or -1.
};

BodyModel body_model(const body::Rig& rig, const body::Skeleton& skeleton);

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// One board's words at an instant; NaN: not measured.
struct InertialReading {
  double time_s = 0.0;
  int board = 0;
  Vector3d w_S = Vector3d::Constant(kMissing);  ///< Angular velocity, rad/s, sensor frame.
  Vector3d f_S = Vector3d::Constant(kMissing);  ///< Specific force, m/s², sensor frame.
};

struct RangeReading {
  double time_s = 0.0;  ///< When the pulse was sent.
  int source = 0, board = 0;
  double range = 0.0;       ///< Metres.
  double confidence = 1.0;  ///< 0..1; the standard deviation is divided by it (Vlasic et al. 2007, eq. (4)).
  double variance = 0.0;  ///< Of the range, m², where its decoder tells; used instead of the confidence. 0: not told.
};

/// The root's pose from elsewhere: root segment to world, and its joint's place.
struct RootReading {
  double time_s = 0.0;
  Quaterniond R_WL = Quaterniond::Identity();
  Vector3d p_W = Vector3d::Zero();
};

/// A recording, each list in order of time.
struct BodyReadings {
  std::vector<InertialReading> inertial;
  std::vector<RangeReading> ranges;
  std::vector<RootReading> root;
};

/// What there is at one instant; pointers into a BodyReadings.
struct BodyInstant {
  double time_s = 0.0;
  const InertialReading* inertial = nullptr;
  std::size_t inertials = 0;
  const RangeReading* ranges = nullptr;
  std::size_t range_count = 0;
};

/// Readings grouped by instant, in order of time; what lies within a microsecond counts as one instant.
std::vector<BodyInstant> instants_of(const BodyReadings& readings);

/// The root's path through its readings: rotations and places by cubic interpolation, held beyond both ends.
RootReading root_at(const std::vector<RootReading>& path, double time_s);

}  // namespace limbwave::estimate
