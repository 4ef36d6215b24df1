#include "interchange/fbx_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "interchange/fbx_format.h"
#include "interchange/fbx_properties.h"

namespace limbwave::interchange {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Nodes deeper than this are no skeleton.
constexpr int kDeepestNode = 1000;
// Connections followed, each as often as it is met; repeated ones would multiply.
constexpr std::size_t kMostSteps = 4'000'000;

class SceneReader : private FbxPropertyReader {
 public:
  explicit SceneReader(const FbxRecords& records) : FbxPropertyReader(records), records_(records) {}

  Result<FbxScene> read() {
    settings();
    if (Status status = objects(); !status) {
      return status.error();
    }
    connections();
    if (Status status = models(); !status) {
      return status.error();
    }
    skins();
    stacks();
    bones_without_type();
    if (failure()) {
      return *failure();
    }
    return std::move(scene_);
  }

 private:
  struct Connection {
    std::int64_t other;
    std::string_view property;
  };

  void settings() {
    static const FbxRecord kNone;
    const FbxRecord* found = records_.root().find("GlobalSettings");
    const FbxRecord& settings = found == nullptr ? kNone : *found;
    const auto integer = [&](const char* name, int otherwise) {
      return static_cast<int>(property_number(settings, name, otherwise));
    };
    // Y-up axes of the file: to the right, up and to the front.
    Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
    const std::array<int, 3> axes = {integer("CoordAxis", 0), integer("UpAxis", 1), integer("FrontAxis", 2)};
    const std::array<int, 3> signs = {integer("CoordAxisSign", 1), integer("UpAxisSign", 1),
                                      integer("FrontAxisSign", 1)};
    for (int row = 0; row < 3; ++row) {
      const auto n = static_cast<std::size_t>(row);
      R(row, std::clamp(axes[n], 0, 2)) = signs[n] < 0 ? -1.0 : 1.0;
    }
    if (std::abs(R.determinant()) < 0.5) {
      R.setIdentity();
    } else if (R.determinant() < 0.0) {
      R.row(2) *= -1.0;  // left-handed settings are written by mistake: the data is not
    }
    Eigen::Matrix3d from_y_up;
    from_y_up << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    scene_.R_WF = from_y_up * R;
    const double centimetres = property_number(settings, "UnitScaleFactor", 1.0);
    scene_.metres_per_unit = centimetres > 1e-6 ? 0.01 * centimetres : 0.01;

    constexpr std::array<double, 19> kRates = {30, 120,        100,        60,         50,         48,   30,
                                               30, 30 / 1.001, 30 / 1.001, 25,         24,         1000, 24 / 1.001,
                                               0,  96,         72,         60 / 1.001, 120 / 1.001};
    const int mode = integer("TimeMode", 0);
    const double custom = property_number(settings, "CustomFrameRate", -1.0);
    const double rate = mode >= 0 && mode < 19 ? kRates[static_cast<std::size_t>(mode)] : 0.0;
    scene_.fps = rate > 0.0 ? rate : custom > 0.1 && custom <= 1e5 ? custom : 30.0;
  }

  Status objects() {
    const FbxRecord* list = records_.root().find("Objects");
    if (list == nullptr) {
      return records_.error(0, "there are no objects in it");
    }
    for (const FbxRecord& object : list->children) {
      if (object.value(0).type == 'L') {
        objects_.emplace(object.value(0).integer, &object);
      }
    }
    return {};
  }

  void connections() {
    const FbxRecord* list = records_.root().find("Connections");
    for (const FbxRecord& entry : list == nullptr ? std::vector<FbxRecord>() : list->children) {
      const std::string_view kind = entry.value(0).bytes;
      if (!entry.value(1).is_number() || !entry.value(2).is_number() || (kind != "OO" && kind != "OP")) {
        continue;
      }
      const std::string_view name = kind == "OP" ? entry.value(3).bytes : std::string_view();
      children_[entry.value(2).integer].push_back({entry.value(1).integer, name});
      const auto parent = objects_.find(entry.value(2).integer);
      if (kind == "OO" && parent != objects_.end() && parent->second->name == "Model") {
        parents_.emplace(entry.value(1).integer, entry.value(2).integer);
      }
    }
  }

  // What hangs on an object, of one record type.
  template <typename Use>
  void each_child(std::int64_t parent, std::string_view type, const Use& use) {
    const auto list = children_.find(parent);
    if (list == children_.end()) {
      return;
    }
    for (const Connection& child : list->second) {
      if (++steps_ > kMostSteps) {
        fail(records_.root(), "there are more connections than any program writes");
        return;
      }
      const auto object = objects_.find(child.other);
      if (object != objects_.end() && object->second->name == type) {
        use(child.other, *object->second, child.property);
      }
    }
  }
  int model_of(std::int64_t id) const {
    const auto found = index_.find(id);
    return found == index_.end() ? -1 : found->second;
  }

  Status models() {
    struct Open {
      std::int64_t id;
      int parent;
      int depth;
    };
    std::vector<Open> open = {{0, -1, 0}};
    while (!open.empty()) {
      const Open top = open.back();
      open.pop_back();
      std::vector<Open> found;
      each_child(top.id, "Model", [&](std::int64_t id, const FbxRecord& record, std::string_view) {
        if (index_.contains(id) || failure()) {
          return;  // hangs on several: the first counts
        }
        if (top.depth > kDeepestNode) {
          fail(record, "bones hang on each other deeper than in any skeleton");
          return;
        }
        index_.emplace(id, static_cast<int>(scene_.models.size()));
        found.push_back({id, static_cast<int>(scene_.models.size()), top.depth + 1});
        scene_.models.push_back(model(record, top.parent));
      });
      open.insert(open.end(), found.rbegin(), found.rend());
    }
    as_in_file();
    circles();
    return failure() ? Status(*failure()) : Status();
  }

  // A node that cannot be reached from the scene's root hangs on nothing, or in a circle. Each is passed once.
  void circles() {
    std::unordered_map<std::int64_t, std::int64_t> passed_from;
    for (const auto& [start, parent] : parents_) {
      std::int64_t at = start;
      while (!index_.contains(at) && passed_from.emplace(at, start).second) {
        const auto next = parents_.find(at);
        if (next == parents_.end()) {
          break;
        }
        at = next->second;
        if (const auto passed = passed_from.find(at); passed != passed_from.end() && passed->second == start) {
          const FbxRecord& record = *objects_.at(at);
          fail(record, fmt::format("\"{}\" hangs on itself", fbx_plain_name(record.value(1).bytes)));
        }
      }
    }
  }

  // The order of the file, where it has parents before children as most have.
  void as_in_file() {
    std::vector<FbxModel>& models = scene_.models;
    const auto offset = [&](int i) { return models[static_cast<std::size_t>(i)].offset; };
    std::vector<int> order(models.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = static_cast<int>(i);
      if (models[i].parent >= 0 && offset(models[i].parent) > models[i].offset) {
        return;
      }
    }
    std::ranges::sort(order, {}, offset);
    std::vector<int> place(order.size());
    std::vector<FbxModel> sorted;
    for (std::size_t i = 0; i < order.size(); ++i) {
      place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
      sorted.push_back(std::move(models[static_cast<std::size_t>(order[i])]));
    }
    models = std::move(sorted);
    for (FbxModel& model : models) {
      model.parent = model.parent < 0 ? -1 : place[static_cast<std::size_t>(model.parent)];
    }
    for (auto& [id, index] : index_) {
      index = place[static_cast<std::size_t>(index)];
    }
  }

  FbxModel model(const FbxRecord& record, int parent) {
    FbxModel model;
    model.name = fbx_plain_name(record.value(1).bytes);
    model.type = std::string(record.value(2).bytes);
    model.offset = record.offset;
    model.parent = parent;
    model.joint = model.type == "LimbNode" || model.type == "Limb" || model.type == "Root";
    const Vector3d zero = Vector3d::Zero();
    model.rest = {property_vector(record, "Lcl Translation", zero), property_vector(record, "Lcl Rotation", zero),
                  property_vector(record, "Lcl Scaling", Vector3d::Ones())};
    // Autodesk's SDK takes no notice of order, pre- and post-rotation otherwise.
    if (property_number(record, "RotationActive", 0.0) != 0.0) {
      const double order = property_number(record, "RotationOrder", 0.0);
      model.rotation_order = order >= 0.0 && order < 6.0 ? static_cast<int>(order) : 0;
      model.pre = fbx_rotation(property_vector(record, "PreRotation", zero), 0);
      model.post = fbx_rotation(property_vector(record, "PostRotation", zero), 0);
    }
    model.rotation_offset = property_vector(record, "RotationOffset", zero);
    model.rotation_pivot = property_vector(record, "RotationPivot", zero);
    model.scaling_offset = property_vector(record, "ScalingOffset", zero);
    model.scaling_pivot = property_vector(record, "ScalingPivot", zero);
    model.geometric = Eigen::Translation3d(property_vector(record, "GeometricTranslation", zero)) *
                      fbx_rotation(property_vector(record, "GeometricRotation", zero), 0) *
                      Eigen::Scaling(property_vector(record, "GeometricScaling", Vector3d::Ones()));
    model.inherits_scale = property_number(record, "InheritType", 1.0) != 2.0;
    model.length_m = property_number(record, kFbxLengthProperty, -1.0);
    return model;
  }

  void skins() {
    for (const auto& [id, index] : std::vector<std::pair<std::int64_t, int>>(index_.begin(), index_.end())) {
      const int mesh = index;
      each_child(id, "Geometry", [&](std::int64_t geometry, const FbxRecord& shape, std::string_view) {
        each_child(geometry, "Deformer", [&](std::int64_t skin_id, const FbxRecord& deformer, std::string_view) {
          FbxSkin skin{scene_.models[static_cast<std::size_t>(mesh)].name, &shape, mesh, {}};
          if (deformer.value(2).bytes != "Skin") {
            return;
          }
          each_child(skin_id, "Deformer", [&](std::int64_t cluster_id, const FbxRecord& cluster, std::string_view) {
            each_child(cluster_id, "Model", [&](std::int64_t bone, const FbxRecord&, std::string_view) {
              if (const int found = model_of(bone); found >= 0) {
                scene_.models[static_cast<std::size_t>(found)].joint = true;
                skin.clusters.push_back({found, &cluster});
              }
            });
          });
          if (!skin.clusters.empty()) {
            scene_.skins.push_back(std::move(skin));
          }
        });
      });
    }
    // In the order of the file, whatever the hash.
    std::ranges::sort(scene_.skins, {}, [](const FbxSkin& skin) { return skin.geometry->offset; });
  }

  void stacks() {
    for (const auto& [id, record] : objects_) {
      if (record->name != "AnimationStack") {
        continue;
      }
      FbxStack stack{fbx_plain_name(record->value(1).bytes),
                     property_ticks(*record, "LocalStart"),
                     property_ticks(*record, "LocalStop"),
                     {}};
      each_child(id, "AnimationLayer", [&](std::int64_t layer_id, const FbxRecord& layer_record, std::string_view) {
        FbxLayer layer;
        layer.weight = std::clamp(property_number(layer_record, "Weight", 100.0) / 100.0, 0.0, 1.0);
        layer.additive = property_number(layer_record, "BlendMode", 0.0) == 0.0;
        each_child(layer_id, "AnimationCurveNode", [&](std::int64_t node_id, const FbxRecord& node, std::string_view) {
          curve_node(layer, node_id, node);
        });
        stack.layers.push_back(std::move(layer));
      });
      order_.push_back(record->offset);
      scene_.stacks.push_back(std::move(stack));
    }
    std::vector<std::size_t> by_offset(order_.size());
    for (std::size_t i = 0; i < by_offset.size(); ++i) {
      by_offset[i] = i;
    }
    std::ranges::sort(by_offset, {}, [this](std::size_t i) { return order_[i]; });
    std::vector<FbxStack> sorted;
    sorted.reserve(by_offset.size());
    for (const std::size_t i : by_offset) {
      sorted.push_back(std::move(scene_.stacks[i]));
    }
    scene_.stacks = std::move(sorted);
  }

  // Some programs write skeletons of plain nodes.
  void bones_without_type() {
    if (std::ranges::any_of(scene_.models, &FbxModel::joint)) {
      return;
    }
    for (const FbxStack& stack : scene_.stacks) {
      for (const FbxLayer& layer : stack.layers) {
        for (const FbxCurveNode& node : layer.nodes) {
          FbxModel& model = scene_.models[static_cast<std::size_t>(node.model)];
          model.joint = model.type == "Null" || model.type.empty();
        }
      }
    }
  }

  void curve_node(FbxLayer& layer, std::int64_t node_id, const FbxRecord& node) {
    if (targets_.empty()) {
      // The other way round: which nodes move which models.
      for (const auto& [parent, list] : children_) {
        for (const Connection& child : list) {
          if (!child.property.empty() && index_.contains(parent)) {
            targets_[child.other].push_back({parent, child.property});
          }
        }
      }
    }
    const auto found = targets_.find(node_id);
    if (found == targets_.end()) {
      return;
    }
    for (const Connection& target : found->second) {
      if (++steps_ > kMostSteps) {
        fail(node, "there are more connections than any program writes");
        return;
      }
      constexpr std::array<std::string_view, 3> kProperties = {"Lcl Translation", "Lcl Rotation", "Lcl Scaling"};
      const auto channel = std::ranges::find(kProperties, target.property);
      if (channel == kProperties.end()) {
        continue;
      }
      FbxCurveNode curves;
      curves.model = model_of(target.other);
      curves.channel = static_cast<FbxChannelIndex>(channel - kProperties.begin());
      curves.constant = scene_.models[static_cast<std::size_t>(curves.model)].rest[curves.channel];
      constexpr std::array<std::string_view, 3> kAxes = {"d|X", "d|Y", "d|Z"};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        curves.constant[static_cast<int>(axis)] =
            property_number(node, kAxes[axis], curves.constant[static_cast<int>(axis)]);
      }
      bool any = false;
      each_child(node_id, "AnimationCurve", [&](std::int64_t, const FbxRecord& curve, std::string_view axis_name) {
        const auto axis = std::ranges::find(kAxes, axis_name);
        if (axis != kAxes.end()) {
          curves.curves[static_cast<std::size_t>(axis - kAxes.begin())] = &curve;
          any = true;
        }
      });
      if (any) {
        layer.nodes.push_back(curves);
      }
    }
  }

  const FbxRecords& records_;
  FbxScene scene_;
  std::unordered_map<std::int64_t, const FbxRecord*> objects_;
  std::unordered_map<std::int64_t, std::vector<Connection>> children_;
  std::unordered_map<std::int64_t, std::vector<Connection>> targets_;
  std::unordered_map<std::int64_t, std::int64_t> parents_;
  std::unordered_map<std::int64_t, int> index_;
  std::vector<std::size_t> order_;
  std::size_t steps_ = 0;
};

}  // namespace

Result<FbxScene> fbx_scene(const FbxRecords& records) {
  return SceneReader(records).read();
}

}  // namespace limbwave::interchange
