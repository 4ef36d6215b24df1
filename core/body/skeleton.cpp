#include "body/skeleton.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>

#include "base/files.h"
#include "base/folder.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "body/json_geometry.h"

namespace limbwave::body {

std::size_t degrees_of_freedom(JointKind kind) {
  switch (kind) {
    case JointKind::kFixed:
      return 0;
    case JointKind::kHinge:
      return 1;
    case JointKind::kUniversal:
      return 2;
    case JointKind::kSpherical:
      return 3;
  }
  return 0;
}

namespace {

constexpr std::size_t kSegmentLimit = 512;
constexpr double kLengthLimit = 10.0;  // metres

struct KindName {
  JointKind kind;
  const char* name;
};
constexpr KindName kKindNames[] = {{JointKind::kFixed, "fixed"},
                                   {JointKind::kHinge, "hinge"},
                                   {JointKind::kUniversal, "universal"},
                                   {JointKind::kSpherical, "spherical"}};

Joint read_joint(const JsonReader& reader) {
  reader.allow({"kind", "axis", "axis2", "minimum_deg", "maximum_deg"});
  Joint joint;
  const std::string kind = reader.at("kind").string();
  const auto* found = std::find_if(std::begin(kKindNames), std::end(kKindNames),
                                   [&](const KindName& candidate) { return kind == candidate.name; });
  if (found == std::end(kKindNames)) {
    reader.at("kind").fail("is \"" + kind + "\"", "use fixed, hinge, universal or spherical");
    return joint;
  }
  joint.kind = found->kind;
  if (joint.kind == JointKind::kHinge || joint.kind == JointKind::kUniversal) {
    joint.axis = read_direction(reader.at("axis"));
  }
  if (joint.kind == JointKind::kUniversal) {
    joint.axis2 = read_direction(reader.at("axis2"));
    if (joint.axis.cross(joint.axis2).norm() < 0.1) {
      reader.at("axis2").fail("is nearly parallel to axis", "a universal joint has two different axes");
    }
  }
  const std::size_t dof = degrees_of_freedom(joint.kind);
  const auto read_limits = [&](const char* key, Vector3d& limits) {
    if (reader.has(key)) {
      const std::vector<double> values = reader.at(key).numbers(dof);
      for (std::size_t i = 0; i < dof; ++i) {
        limits[static_cast<Eigen::Index>(i)] = radians(values[i]);
      }
    }
  };
  read_limits("minimum_deg", joint.minimum);
  read_limits("maximum_deg", joint.maximum);
  for (std::size_t i = 0; i < dof; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (joint.minimum[axis] > joint.maximum[axis]) {
      reader.at("minimum_deg").fail("is larger than maximum_deg");
    }
  }
  return joint;
}

Capsule read_capsule(const JsonReader& reader) {
  reader.allow({"from_m", "to_m", "radius_m"});
  Capsule capsule{read_vector(reader.at("from_m")), read_vector(reader.at("to_m")),
                  reader.at("radius_m").number(1e-4, 1.0)};
  if (std::max(capsule.from_L.norm(), capsule.to_L.norm()) > kLengthLimit) {
    reader.fail("lies more than 10 m off", "lengths are in metres");
  }
  return capsule;
}

Segment read_segment(const JsonReader& reader, const Skeleton& skeleton) {
  reader.allow({"name", "parent", "joint", "offset_m", "rest", "length_m", "capsules"});
  Segment segment;
  segment.name = reader.at("name").string();
  if (segment.name.empty()) {
    reader.at("name").fail("is empty");
  } else if (skeleton.find(segment.name) >= 0) {
    reader.at("name").fail("is \"" + segment.name + "\", which another segment has already");
  }
  const bool first = skeleton.segments.empty();
  if (!reader.has("parent") || reader.at("parent").raw().is_null()) {
    if (!first) {
      reader.fail("has no parent", "only the first segment, the root, has none");
    }
  } else {
    const std::string parent = reader.at("parent").string();
    segment.parent = skeleton.find(parent);
    if (segment.parent < 0) {
      reader.at("parent").fail("is \"" + parent + "\", which no earlier segment is", "list parents before children");
    }
  }
  if (reader.has("joint")) {
    segment.joint = read_joint(reader.at("joint"));
  }
  if (reader.has("offset_m")) {
    segment.p_PL = read_vector(reader.at("offset_m"));
    if (segment.p_PL.norm() > kLengthLimit) {
      reader.at("offset_m").fail("is longer than 10 m", "lengths are in metres");
    }
  }
  if (reader.has("rest")) {
    segment.R_PL_rest = read_quaternion(reader.at("rest"));
  }
  segment.length = reader.at("length_m").number(0.0, kLengthLimit);
  if (reader.has("capsules")) {
    for (const JsonReader& capsule : reader.at("capsules").items()) {
      segment.capsules.push_back(read_capsule(capsule));
    }
  }
  return segment;
}

// Lengths in centimetres or millimetres ("length_mm") become metres, so that a file in any unit is the same skeleton.
void to_metres(nlohmann::json& json) {
  static constexpr std::array<std::pair<std::string_view, double>, 2> kUnits{{{"_cm", 100.0}, {"_mm", 1000.0}}};
  if (json.is_array()) {
    for (nlohmann::json& item : json) {
      to_metres(item);
    }
    return;
  }
  if (!json.is_object()) {
    return;
  }
  std::vector<std::pair<std::string, nlohmann::json>> converted;
  for (auto& [key, value] : json.items()) {
    to_metres(value);
    for (const auto& [suffix, per_metre] : kUnits) {
      static constexpr std::array kLengths{"height", "length", "offset", "from", "to", "radius"};
      const std::string stem = key.ends_with(suffix) ? key.substr(0, key.size() - suffix.size()) : "";
      if (std::find(kLengths.begin(), kLengths.end(), stem) == kLengths.end() || json.contains(stem + "_m")) {
        continue;
      }
      nlohmann::json metres = value;
      const auto divide = [&, per = per_metre](nlohmann::json& number) {
        number = number.is_number() ? nlohmann::json(number.get<double>() / per) : number;
      };
      if (metres.is_array()) {
        std::for_each(metres.begin(), metres.end(), divide);
      } else {
        divide(metres);
      }
      converted.emplace_back(key, std::move(metres));
    }
  }
  for (auto& [key, metres] : converted) {
    json.erase(key);
    json[key.substr(0, key.rfind('_')) + "_m"] = std::move(metres);
  }
}

}  // namespace

int Skeleton::find(std::string_view segment) const {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].name == segment) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

Result<Skeleton> skeleton_from_json(const nlohmann::json& json, const std::string& place) {
  JsonReader::State state{place, {}};
  nlohmann::json metric = json;
  to_metres(metric);
  const JsonReader reader(metric, "", state);
  reader.allow({"schema", "name", "height_m", "segments"});
  reader.at("schema").integer(1, 1);
  Skeleton skeleton;
  skeleton.name = reader.at("name").string();
  skeleton.height = reader.number_or("height_m", 0.0, 0.0, 3.0);
  const std::vector<JsonReader> segments = reader.at("segments").items();
  if (segments.empty()) {
    reader.at("segments").fail("is empty", "a skeleton has at least one segment");
  }
  if (segments.size() > kSegmentLimit) {
    reader.at("segments").fail("has more than 512 segments");
    return *state.error;
  }
  for (const JsonReader& segment : segments) {
    skeleton.segments.push_back(read_segment(segment, skeleton));
  }
  if (state.error) {
    return *state.error;
  }
  return skeleton;
}

nlohmann::json skeleton_to_json(const Skeleton& skeleton) {
  nlohmann::json segments = nlohmann::json::array();
  for (const Segment& segment : skeleton.segments) {
    const std::size_t dof = degrees_of_freedom(segment.joint.kind);
    nlohmann::json joint;
    for (const KindName& kind : kKindNames) {
      if (kind.kind == segment.joint.kind) {
        joint["kind"] = kind.name;
      }
    }
    if (dof == 1 || dof == 2) {
      joint["axis"] = to_json(segment.joint.axis);
    }
    if (dof == 2) {
      joint["axis2"] = to_json(segment.joint.axis2);
    }
    nlohmann::json minimum = nlohmann::json::array();
    nlohmann::json maximum = nlohmann::json::array();
    for (std::size_t i = 0; i < dof; ++i) {
      minimum.push_back(degrees(segment.joint.minimum[static_cast<Eigen::Index>(i)]));
      maximum.push_back(degrees(segment.joint.maximum[static_cast<Eigen::Index>(i)]));
    }
    if (dof > 0) {
      joint["minimum_deg"] = minimum;
      joint["maximum_deg"] = maximum;
    }
    nlohmann::json entry = {{"name", segment.name},
                            {"joint", joint},
                            {"offset_m", to_json(segment.p_PL)},
                            {"rest", to_json(segment.R_PL_rest)},
                            {"length_m", segment.length}};
    if (segment.parent >= 0) {
      entry["parent"] = skeleton.segments[static_cast<std::size_t>(segment.parent)].name;
    }
    for (const Capsule& capsule : segment.capsules) {
      entry["capsules"].push_back(
          {{"from_m", to_json(capsule.from_L)}, {"to_m", to_json(capsule.to_L)}, {"radius_m", capsule.radius}});
    }
    segments.push_back(std::move(entry));
  }
  return {{"schema", 1}, {"name", skeleton.name}, {"height_m", skeleton.height}, {"segments", std::move(segments)}};
}

std::string shipped_or_path(const std::string& folder, const std::string& name_or_path) {
  const std::filesystem::path shipped = resources_folder() / folder / (name_or_path + ".json");
  std::error_code code;
  const bool plain_name = name_or_path.find('/') == std::string::npos;
  return plain_name && std::filesystem::exists(shipped, code) ? shipped.string() : name_or_path;
}

std::vector<std::string> shipped_names(const std::string& folder) {
  std::vector<std::string> names;
  for (const std::filesystem::path& entry : entries_of(resources_folder() / folder)) {
    if (entry.extension() == ".json") {
      names.push_back(entry.stem().string());
    }
  }
  return names;
}

Result<Skeleton> load_skeleton(const std::string& name_or_path) {
  const std::string path = shipped_or_path("skeletons", name_or_path);
  const Result<std::string> text = read_file(path, std::size_t{16} << 20);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, path);
  if (!json) {
    return json.error();
  }
  return skeleton_from_json(*json, path);
}

std::vector<std::string> shipped_skeletons() {
  return shipped_names("skeletons");
}

Skeleton scaled_to_height(const Skeleton& skeleton, double height) {
  assert(skeleton.height > 0.0 && height > 0.0);
  Skeleton scaled = skeleton;
  const double factor = height / skeleton.height;
  scaled.height = height;
  for (Segment& segment : scaled.segments) {
    segment.length *= factor;
    segment.p_PL *= factor;
    for (Capsule& capsule : segment.capsules) {
      capsule.from_L *= factor;
      capsule.to_L *= factor;
      capsule.radius *= factor;
    }
  }
  return scaled;
}

Skeleton with_length(Skeleton skeleton, int segment, double length) {
  Segment& changed = skeleton.segments.at(static_cast<std::size_t>(segment));
  for (Segment& child : skeleton.segments) {
    // What hangs on the end, to a tenth of a millimetre, moves with it; a shoulder beside the spine stays beside it.
    if (child.parent == segment && std::abs(child.p_PL.x() - changed.length) < 1e-4) {
      child.p_PL.x() = length;
    }
  }
  changed.length = length;
  return skeleton;
}

}  // namespace limbwave::body
