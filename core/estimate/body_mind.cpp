// A filter's mind as text, and back to the last bit.
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "estimate/body_watch.h"

namespace limbwave::estimate {
namespace {

using nlohmann::json;

constexpr int kSchema = 2;  // 1 had its states in another order

json list(const Eigen::VectorXd& v) {
  return std::vector<double>(v.data(), v.data() + v.size());
}
json list(const std::vector<Vector3d>& values) {
  json out = json::array();
  for (const Vector3d& v : values) {
    out.push_back({v.x(), v.y(), v.z()});
  }
  return out;
}
json list(const std::vector<Quaterniond>& values) {
  json out = json::array();
  for (const Quaterniond& q : values) {
    out.push_back({q.w(), q.x(), q.y(), q.z()});
  }
  return out;
}

std::vector<double> numbers(const JsonReader& from) {
  std::vector<double> values;
  for (const JsonReader& item : from.items()) {
    values.push_back(item.number());
  }
  return values;
}
Eigen::VectorXd vector(const JsonReader& from) {
  const std::vector<double> values = numbers(from);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}
std::vector<Vector3d> vectors(const JsonReader& from) {
  std::vector<Vector3d> values;
  for (const JsonReader& item : from.items()) {
    const std::vector<double> v = item.numbers(3);
    values.emplace_back(v[0], v[1], v[2]);
  }
  return values;
}
std::vector<Quaterniond> rotations(const JsonReader& from) {
  std::vector<Quaterniond> values;
  for (const JsonReader& item : from.items()) {
    const std::vector<double> v = item.numbers(4);
    values.emplace_back(v[0], v[1], v[2], v[3]);
    if (!(std::abs(values.back().norm() - 1.0) < 1e-6)) {
      item.fail("is not of length 1");
    }
  }
  return values;
}

}  // namespace

std::string mind_to_text(const BodyMind& mind) {
  const BodyState& s = mind.filter.state;
  const json state{{"time_s", s.time_s},
                   {"R_joint", list(s.joints.R_joint)},
                   {"q", list(s.joints.q)},
                   {"qd", list(s.joints.qd)},
                   {"qdd", list(s.joints.qdd)},
                   {"gyroscope_bias", list(s.gyroscope_bias)},
                   {"accelerometer_bias", list(s.accelerometer_bias)},
                   {"mount_place", list(s.mount_place)},
                   {"source_place", list(s.source_place)},
                   {"mount_rotation", list(s.mount_rotation)},
                   {"tissue_angle", list(s.tissue_angle)},
                   {"tissue_gain", list(s.tissue_gain)},
                   {"range_offset", s.range_offset},
                   {"bone_scale", s.bone_scale},
                   {"sound_scale", s.sound_scale}};
  const json all{{"schema", kSchema},
                 {"kind", "body-filter-state"},
                 {"states", mind.states},
                 {"boards", mind.boards},
                 {"state", state},
                 {"next_prior_s", mind.filter.next_prior_s},
                 {"watch", json::parse(mind.watch_text)},
                 {"covariance", mind.filter.P},
                 {"covariance_above", mind.above}};
  return all.dump() + "\n";
}

Result<BodyMind> mind_from_text(const std::string& text, const std::string& place) {
  const Result<json> parsed = parse_json(text, place);
  if (!parsed) {
    return parsed.error();
  }
  JsonReader::State problems{place, {}};
  const JsonReader reader(*parsed, "", problems);
  reader.allow(
      {"schema", "kind", "states", "boards", "state", "next_prior_s", "watch", "covariance", "covariance_above"});
  if (reader.at("kind").string() != "body-filter-state" && !problems.error) {
    reader.at("kind").fail("is not \"body-filter-state\"", "give a file that was saved by --save-state");
  }
  if (reader.at("schema").integer(1, 1 << 16) != kSchema && !problems.error) {
    reader.at("schema").fail("is of another version", "save the state again with this version");
  }
  if (problems.error) {
    return *problems.error;
  }
  constexpr std::int64_t kMost = 1 << 16;
  BodyMind mind;
  mind.states = static_cast<int>(reader.at("states").integer(1, kMost));
  mind.boards = static_cast<int>(reader.at("boards").integer(0, kMost));
  BodyState& s = mind.filter.state;
  const JsonReader state = reader.at("state");
  s.time_s = state.at("time_s").number();
  s.joints.R_joint = rotations(state.at("R_joint"));
  s.joints.q = vector(state.at("q"));
  s.joints.qd = vector(state.at("qd"));
  s.joints.qdd = vector(state.at("qdd"));
  s.gyroscope_bias = vectors(state.at("gyroscope_bias"));
  s.accelerometer_bias = vectors(state.at("accelerometer_bias"));
  s.mount_place = vectors(state.at("mount_place"));
  s.source_place = vectors(state.at("source_place"));
  s.mount_rotation = rotations(state.at("mount_rotation"));
  s.tissue_angle = vectors(state.at("tissue_angle"));
  s.tissue_gain = vectors(state.at("tissue_gain"));
  s.range_offset = numbers(state.at("range_offset"));
  s.bone_scale = numbers(state.at("bone_scale"));
  s.sound_scale = state.at("sound_scale").number();
  mind.filter.next_prior_s = reader.at("next_prior_s").number();
  mind.filter.P = numbers(reader.at("covariance"));
  mind.above = numbers(reader.at("covariance_above"));
  mind.watch_text = reader.at("watch").raw().dump();
  const auto entries = static_cast<std::size_t>(mind.states) * static_cast<std::size_t>(mind.states + 1) / 2;
  if (!problems.error &&
      (mind.filter.P.size() != entries || mind.above.size() + static_cast<std::size_t>(mind.states) != entries)) {
    reader.at("covariance").fail("has not as many entries as the states need");
  }
  if (problems.error) {
    return *problems.error;
  }
  return mind;
}

}  // namespace limbwave::estimate
