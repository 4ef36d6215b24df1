#include "calibrate/limb_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::calibrate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The nearest pair of perpendicular unit vectors: both turned by the same angle in their common plane.
std::pair<Vector3d, Vector3d> perpendicular_pair(const Vector3d& a, const Vector3d& b) {
  const Vector3d sum = (a.normalized() + b.normalized()).normalized();
  const Vector3d difference = (a.normalized() - b.normalized()).normalized();
  return {(sum + difference).normalized(), (sum - difference).normalized()};
}

bool nearly_parallel(const Vector3d& a, const Vector3d& b) {
  const double angle = geometry::angle_between(a, b);
  return !(angle > radians(30.0)) || !(angle < radians(150.0));
}

double angle_deg(const Vector3d& a, const Vector3d& b) {
  return degrees(geometry::angle_between(a, b));
}

Verdict judged(double value, double good, double usable) {
  return value <= good ? Verdict::kGood : value <= usable ? Verdict::kUsable : Verdict::kRepeat;
}

}  // namespace

Result<Quaterniond> mounting_from_gravity(const Vector3d& first_S, const Vector3d& second_S, const Vector3d& first_L,
                                          const Vector3d& second_L) {
  if (nearly_parallel(first_S, second_S) || nearly_parallel(first_L, second_L)) {
    return Error{
        fmt::format("the two directions of gravity are {:.0f}° apart, not about 90°",
                    nearly_parallel(first_S, second_S) ? angle_deg(first_S, second_S) : angle_deg(first_L, second_L)),
        "", "hold two poses a right angle apart"};
  }
  const auto [a_S, b_S] = perpendicular_pair(first_S, second_S);
  const auto [a_L, b_L] = perpendicular_pair(first_L, second_L);
  const Matrix3d R_LS = a_L * a_S.transpose() + b_L * b_S.transpose() + a_L.cross(b_L) * a_S.cross(b_S).transpose();
  return Quaterniond(R_LS).normalized();
}

LimbCalibrator::LimbCalibrator(const body::Rig& rig, const RigCalibration& range, int group, std::vector<int> sensors,
                               const LimbParameters& parameters)
    : rig_(rig),
      group_(rig.groups.at(static_cast<std::size_t>(group))),
      sensors_(std::move(sensors)),
      parameters_(parameters) {
  if (sensors_.empty()) {
    sensors_ = group_.sensors;
  }
  for (const int sensor : sensors_) {
    calibrations_.push_back(range.sensors.at(static_cast<std::size_t>(sensor)));
  }
  clear(0);
  clear(1);
}

void LimbCalibrator::clear(int pose) {
  series_.at(static_cast<std::size_t>(pose)).assign(sensors_.size(), {});
}

void LimbCalibrator::push(int pose, const decode::AccelerationFrame& frame) {
  std::vector<SensorSeries>& series = series_.at(static_cast<std::size_t>(pose));
  if (series.empty() || (series.front().size() > 0 && frame.time_s <= series.front().times.back())) {
    return;
  }
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto sensor = static_cast<std::size_t>(sensors_[i]);
    series[i].push(frame.time_s, frame.volts.at(sensor), (frame.usable >> sensor & 1U) != 0);
  }
}

void LimbCalibrator::push(int pose, std::span<const decode::AccelerationFrame> frames) {
  for (const decode::AccelerationFrame& frame : frames) {
    push(pose, frame);
  }
}

const body::LimbPose& LimbCalibrator::pose(int index) const {
  return index == 0 ? group_.first : group_.second;
}

PoseProgress LimbCalibrator::progress(int pose) const {
  const std::vector<SensorSeries>& series = series_.at(static_cast<std::size_t>(pose));
  PoseProgress progress;
  progress.movement_now_g = progress.best_movement_g = kInfinity;
  if (series.empty() || series.front().size() == 0) {
    return progress;
  }
  const std::vector<double>& times = series.front().times;
  progress.seconds = times.back() - times.front();
  std::vector<SensorSeries> newest(series.size());
  for (std::size_t s = 0; s < series.size(); ++s) {
    for (std::size_t i = times.size(); i-- > 0 && times.back() - times[i] <= parameters_.stillness.window_s + 0.1;) {
      newest[s].push(times[i], series[s].volts[i], series[s].usable[i] != 0);
    }
    std::reverse(newest[s].times.begin(), newest[s].times.end());
    std::reverse(newest[s].volts.begin(), newest[s].volts.end());
    std::reverse(newest[s].usable.begin(), newest[s].usable.end());
  }
  if (const auto now = stillest_window(newest, calibrations_, parameters_.stillness)) {
    progress.movement_now_g = now->movement_g;
    progress.still_now = now->movement_g <= parameters_.usable_movement_g;
  }
  if (const auto best = stillest_window(series, calibrations_, parameters_.stillness)) {
    progress.best_movement_g = best->movement_g;
    progress.best_seconds = best->end_s - best->begin_s;
    progress.ready = best->movement_g <= parameters_.good_movement_g;
  }
  return progress;
}

Status LimbCalibrator::find_window(int index, StillWindow& out) const {
  const std::vector<SensorSeries>& series = series_.at(static_cast<std::size_t>(index));
  const std::string place = group_.name + ": pose " + pose(index).name;
  std::optional<StillWindow> found = stillest_window(series, calibrations_, parameters_.stillness);
  if (!found) {
    return Error{
        fmt::format("there is no whole {:.0f} s without lost or clipped readings", parameters_.stillness.window_s),
        place, "check the level and the plugs, then hold the pose again"};
  }
  if (found->movement_g > 2.0 * parameters_.usable_movement_g) {
    return Error{
        fmt::format("it was never held still: the stillest second still moved by {:.0f} mg", 1e3 * found->movement_g),
        place, "hold the pose without moving for two seconds"};
  }
  out = std::move(*found);
  return {};
}

Status LimbCalibrator::check_poses(const std::array<StillWindow, 2>& windows) const {
  int same = 0;
  int opposite = 0;
  int swapped = 0;
  double angle = 0.0;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const Vector3d a = -calibrations_[i].apply(windows[0].mean_volts[i]);
    const Vector3d b = -calibrations_[i].apply(windows[1].mean_volts[i]);
    const double between = angle_deg(a, b);
    angle += between / static_cast<double>(sensors_.size());
    same += between < 45.0 ? 1 : 0;
    opposite += between > 135.0 ? 1 : 0;
    // With the poses in the wrong order the mounting comes out turned by 180°, and the other order fits the rig.
    const Quaterniond& nominal = rig_.accelerometers.at(static_cast<std::size_t>(sensors_[i])).R_LS;
    const auto as_told = mounting_from_gravity(a, b, group_.first.gravity_L, group_.second.gravity_L);
    const auto other_way = mounting_from_gravity(b, a, group_.first.gravity_L, group_.second.gravity_L);
    if (as_told && other_way && geometry::geodesic_angle(*other_way, nominal) < radians(60.0) &&
        geometry::geodesic_angle(*as_told, nominal) > radians(120.0)) {
      ++swapped;
    }
  }
  const auto most = [&](int count) { return 2 * count > static_cast<int>(sensors_.size()); };
  const std::string remedy = fmt::format("hold first \"{}\", then \"{}\"", group_.first.name, group_.second.name);
  if (most(same)) {
    return Error{fmt::format("both poses are the same: gravity turned by only {:.0f}° between them", angle),
                 group_.name, remedy};
  }
  if (most(opposite)) {
    return Error{fmt::format("the poses are opposite: gravity turned by {:.0f}° instead of 90°", angle), group_.name,
                 remedy};
  }
  if (most(swapped) && !parameters_.any_mounting) {
    return Error{"the poses were held in the wrong order", group_.name, remedy};
  }
  return {};
}

SensorLimbResult LimbCalibrator::judge(std::size_t index, const std::array<StillWindow, 2>& windows,
                                       const std::string& date) const {
  const body::Accelerometer& accelerometer = rig_.accelerometers.at(static_cast<std::size_t>(sensors_[index]));
  const Vector3d first = calibrations_[index].apply(windows[0].mean_volts[index]);
  const Vector3d second = calibrations_[index].apply(windows[1].mean_volts[index]);
  SensorLimbResult result;
  result.sensor = sensors_[index];
  result.movement_g = std::max(windows[0].sensor_g[index], windows[1].sensor_g[index]);
  const double first_norm = first.norm() / kStandardGravity - 1.0;
  const double second_norm = second.norm() / kStandardGravity - 1.0;
  result.norm_error_g = std::abs(first_norm) > std::abs(second_norm) ? first_norm : second_norm;
  const double between = angle_deg(first, second);
  const double expected = angle_deg(group_.first.gravity_L, group_.second.gravity_L);
  result.angle_error_deg = between - expected;
  result.mount.sensor = accelerometer.name;
  result.mount.method = "nominal";
  result.mount.R_LS = accelerometer.R_LS;
  result.mount.pose_angle_deg = between;
  result.mount.stillness_g = result.movement_g;
  // At rest specific force is opposite to gravity.
  const auto R_LS = mounting_from_gravity(-first, -second, group_.first.gravity_L, group_.second.gravity_L);
  if (!R_LS) {
    result.text = fmt::format("repeat: this sensor's gravity turned by {:.0f}° between the poses, not by 90°", between);
    return result;
  }
  result.mount.method = "two poses";
  result.mount.date = date;
  result.mount.R_LS = *R_LS;
  result.from_nominal_deg = degrees(geometry::geodesic_angle(*R_LS, accelerometer.R_LS));

  const Verdict angle =
      judged(std::abs(result.angle_error_deg), parameters_.good_angle_deg, parameters_.usable_angle_deg);
  const Verdict movement = judged(result.movement_g, parameters_.good_movement_g, parameters_.usable_movement_g);
  const Verdict norm = judged(std::abs(result.norm_error_g), parameters_.good_norm_g, parameters_.usable_norm_g);
  result.verdict = std::max({angle, movement, norm});
  result.text = fmt::format("{}: poses {:.1f}° apart ({:+.1f}° off), held within {:.0f} mg", name(result.verdict),
                            between, result.angle_error_deg, 1e3 * result.movement_g);
  if (angle != Verdict::kGood) {
    result.text += fmt::format("; each direction may be {:.1f}° off: hold the poses more exactly",
                               0.5 * std::abs(result.angle_error_deg));
  }
  if (movement != Verdict::kGood) {
    result.text += "; it moved while it was held";
  }
  if (norm != Verdict::kGood) {
    result.text += fmt::format("; it reads {:.2f} g at rest: calibrate its range, or the volume was moved",
                               1.0 + result.norm_error_g);
  }
  return result;
}

Result<LimbResult> LimbCalibrator::finish(const std::string& date) const {
  LimbResult result;
  for (int pose = 0; pose < 2; ++pose) {
    if (const Status found = find_window(pose, result.windows[static_cast<std::size_t>(pose)]); !found) {
      return found.error();
    }
  }
  if (const Status poses = check_poses(result.windows); !poses) {
    return poses.error();
  }
  result.verdict = Verdict::kGood;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    result.sensors.push_back(judge(i, result.windows, date));
    const SensorLimbResult& sensor = result.sensors.back();
    result.verdict = std::max(result.verdict, sensor.verdict);
    if (sensor.from_nominal_deg > 60.0 && !parameters_.any_mounting) {
      result.diagnostics.push_back(
          {Severity::kWarning, "limb.unlike-rig",
           fmt::format("sits {:.0f}° away from how the rig shows it", sensor.from_nominal_deg),
           "if it is not mounted that way on purpose, two of its axes may be swapped or its slot may be another's",
           sensor.mount.sensor, -1.0});
    }
  }
  return result;
}

Result<std::vector<PoseCheck>> LimbCalibrator::check(int index, const RigCalibration& calibration) const {
  StillWindow window;
  if (const Status found = find_window(index, window); !found) {
    return found.error();
  }
  std::vector<PoseCheck> checks;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const auto sensor = static_cast<std::size_t>(sensors_[i]);
    const Vector3d up_L =
        calibration.mounts.at(sensor).R_LS * calibration.sensors.at(sensor).apply(window.mean_volts[i]);
    PoseCheck check;
    check.sensor = sensors_[i];
    check.error_deg = angle_deg(-up_L, pose(index).gravity_L);
    check.movement_g = window.sensor_g[i];
    check.verdict = std::max(judged(check.error_deg, parameters_.good_angle_deg, parameters_.usable_angle_deg),
                             judged(check.movement_g, parameters_.good_movement_g, parameters_.usable_movement_g));
    checks.push_back(check);
  }
  return checks;
}

}  // namespace limbwave::calibrate
