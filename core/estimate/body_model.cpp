#include "estimate/body_model.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

constexpr double kSameInstant = 1e-6;

BodyBoard& board_named(BodyModel& model, const std::string& name, const std::string& segment) {
  const int found = model.find_board(name);
  if (found >= 0) {
    return model.boards[static_cast<std::size_t>(found)];
  }
  BodyBoard board;
  board.name = name;
  board.segment = model.skeleton.find(segment);
  return model.boards.emplace_back(std::move(board));
}

}  // namespace

int BodyModel::find_board(const std::string& name) const {
  const auto at = std::find_if(boards.begin(), boards.end(), [&](const BodyBoard& b) { return b.name == name; });
  return at == boards.end() ? -1 : static_cast<int>(at - boards.begin());
}

int BodyModel::find_source(const std::string& name) const {
  const auto at = std::find_if(sources.begin(), sources.end(), [&](const BodySource& s) { return s.name == name; });
  return at == sources.end() ? -1 : static_cast<int>(at - sources.begin());
}

BodyModel body_model(const body::Rig& rig, const body::Skeleton& skeleton) {
  BodyModel model;
  model.skeleton = skeleton;
  for (const body::Microphone& microphone : rig.microphones) {
    BodyBoard& board = board_named(model, microphone.name, microphone.segment);
    board.p_LS = microphone.p_LS;
    board.microphone = true;
  }
  for (const body::Gyroscope& gyroscope : rig.gyroscopes) {
    BodyBoard& board = board_named(model, gyroscope.name, gyroscope.segment);
    board.R_LS = gyroscope.R_LS;
    board.p_LS = gyroscope.p_LS;
    board.gyroscope = true;
  }
  for (const body::Accelerometer& accelerometer : rig.accelerometers) {
    BodyBoard& board = board_named(model, accelerometer.name, accelerometer.segment);
    board.R_LS = accelerometer.R_LS;
    board.p_LS = accelerometer.p_LS;
    board.accelerometer = true;
  }
  for (const body::Source& source : rig.sources) {
    model.sources.push_back({source.name, skeleton.find(source.segment), source.p_LS, source.normal_L});
  }
  if (rig.driver_box) {
    model.gyroscope_range = rig.driver_box->gyroscope_range_rad_s;
    model.accelerometer_range = rig.driver_box->accelerometer_range_g * kStandardGravity;
  }
  return model;
}

std::vector<BodyInstant> instants_of(const BodyReadings& readings) {
  std::vector<BodyInstant> instants;
  std::size_t i = 0;
  std::size_t r = 0;
  while (i < readings.inertial.size() || r < readings.ranges.size()) {
    BodyInstant instant;
    instant.time_s = std::min(i < readings.inertial.size() ? readings.inertial[i].time_s : INFINITY,
                              r < readings.ranges.size() ? readings.ranges[r].time_s : INFINITY);
    instant.inertial = readings.inertial.data() + i;
    instant.ranges = readings.ranges.data() + r;
    const double end = instant.time_s + kSameInstant;
    while (i < readings.inertial.size() && readings.inertial[i].time_s <= end) {
      ++i;
      ++instant.inertials;
    }
    while (r < readings.ranges.size() && readings.ranges[r].time_s <= end) {
      ++r;
      ++instant.range_count;
    }
    instants.push_back(instant);
  }
  return instants;
}

RootReading root_at(const std::vector<RootReading>& path, double time_s) {
  const auto after = std::upper_bound(path.begin(), path.end(), time_s,
                                      [](double t, const RootReading& reading) { return t < reading.time_s; });
  if (after == path.begin() || after == path.end()) {
    RootReading held = after == path.end() ? path.back() : path.front();
    held.time_s = time_s;
    return held;
  }
  const auto i = static_cast<std::ptrdiff_t>(after - path.begin()) - 1;
  const auto last = static_cast<std::ptrdiff_t>(path.size()) - 1;
  const RootReading& a = path[static_cast<std::size_t>(i)];
  const RootReading& b = path[static_cast<std::size_t>(i + 1)];
  const double h = b.time_s - a.time_s;
  const double u = (time_s - a.time_s) / h;
  // Cubic Hermite with the neighbours' slopes, in the tangent space of the first of the two for rotations.
  const auto turn = [&](const RootReading& x) { return geometry::log_so3(a.R_WL.conjugate() * x.R_WL); };
  const auto slope = [&](std::ptrdiff_t k, const auto& value) {
    const RootReading& before = path[static_cast<std::size_t>(std::max<std::ptrdiff_t>(k - 1, 0))];
    const RootReading& behind = path[static_cast<std::size_t>(std::min(k + 1, last))];
    return Vector3d((value(behind) - value(before)) / (behind.time_s - before.time_s));
  };
  const auto place = [](const RootReading& x) { return x.p_W; };
  const double u2 = u * u;
  const double u3 = u2 * u;
  const auto hermite = [&](const auto& value) {
    return Vector3d((2 * u3 - 3 * u2 + 1) * value(a) + (u3 - 2 * u2 + u) * h * slope(i, value) +
                    (3 * u2 - 2 * u3) * value(b) + (u3 - u2) * h * slope(i + 1, value));
  };
  return {time_s, (a.R_WL * geometry::exp_so3(hermite(turn))).normalized(), hermite(place)};
}

}  // namespace limbwave::estimate
