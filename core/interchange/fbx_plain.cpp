#include "interchange/fbx_plain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.h"
#include "interchange/euler.h"
#include "interchange/fbx_curve.h"
#include "interchange/fbx_header_writer.h"
#include "interchange/fbx_plain_mesh.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;

// Keys of all nodes and animations together: a person of 25 joints for an hour and a half at 120 Hz, and more in files
// so large that they hold them: this many bytes a key.
constexpr std::size_t kFewKeys = 20'000'000;
constexpr std::size_t kBytesPerKey = 8;
// Of them, keys that are put between the file's own: a few bytes can ask for very many.
constexpr std::size_t kMostAddedKeys = 3'000'000;
// Nodes, and nodes times animations.
constexpr std::size_t kMostModels = 100'000;
constexpr std::size_t kMostModelStacks = 2'000'000;
constexpr std::size_t kMostSkins = 2000;
// Rotations that turn further than this between two keys are given every frame: Euler angles and quaternions go
// different ways.
constexpr double kLargestTurn = 5.0;  // degrees
constexpr double kSame = 1e-9;

FbxChannels channels(const FbxPlacement& placement, EulerAngles& angles) {
  angles = to_euler(placement.R, kZYX, angles);
  return {placement.translation, Vector3d(degrees(angles[2]), degrees(angles[1]), degrees(angles[0])), placement.scale};
}

// The curves that move one node in one stack.
struct Moving {
  const FbxLayer* first;  // of the stack
  const FbxLayer* layer;
  const FbxCurveNode* node;
  std::array<std::optional<FbxCurve>, 3> curves;
};

class PlainWriter {
 public:
  PlainWriter(FbxRecords& records, const FbxScene& scene)
      : records_(records),
        scene_(scene),
        most_keys_(kFewKeys + records.size() / kBytesPerKey),
        out_(sink_),
        file_(out_) {}

  Result<FbxPlain> write() {
    if (scene_.models.size() > kMostModels || scene_.skins.size() > kMostSkins ||
        scene_.models.size() * scene_.stacks.size() > kMostModelStacks) {
      return records_.error(0, fmt::format("it has {} nodes, {} animations and {} skins", scene_.models.size(),
                                           scene_.stacks.size(), scene_.skins.size()));
    }
    choose_models();
    plain_.keys.assign(scene_.stacks.size(), std::vector<FbxPlainKeys>(scene_.models.size()));
    FbxHeader header;
    header.fps = 60.0;
    header.counts = {{"Model", 1},          {"Geometry", 1},           {"Deformer", 1},      {"AnimationStack", 1},
                     {"AnimationLayer", 1}, {"AnimationCurveNode", 1}, {"AnimationCurve", 1}};
    write_fbx_header(out_, file_, header);
    out_.begin("Objects");
    models();
    for (std::size_t skin = 0; skin < scene_.skins.size(); ++skin) {
      Result<FbxPlainMesh> mesh = plain_fbx_mesh(records_, scene_, static_cast<int>(skin), ids_, out_, file_);
      if (!mesh) {
        return mesh.error();
      }
      plain_.meshes.push_back(std::move(*mesh));
    }
    for (std::size_t stack = 0; stack < scene_.stacks.size(); ++stack) {
      if (Status status = animation(stack); !status) {
        return status.error();
      }
    }
    out_.end(true);
    file_.write_connections();
    out_.finish();
    if (!out_.fits()) {
      return records_.error(0, "its animation is too long to be read");
    }
    plain_.bytes = sink_.take();
    return std::move(plain_);
  }

 private:
  void choose_models() {
    const auto& models = scene_.models;
    plain_.kept.assign(models.size(), false);
    for (std::size_t i = models.size(); i-- > 0;) {
      plain_.kept[i] = plain_.kept[i] || models[i].joint;
      if (plain_.kept[i] && models[i].parent >= 0) {
        plain_.kept[static_cast<std::size_t>(models[i].parent)] = true;
      }
    }
  }

  FbxPlacement placement(std::size_t model, const FbxChannels& values) const {
    FbxPlacement result = scene_.models[model].placement(values);
    const int parent = scene_.models[model].parent;
    if (!scene_.models[model].inherits_scale && parent >= 0) {
      const Vector3d& above = scene_.models[static_cast<std::size_t>(parent)].rest[kFbxScaling];
      if ((above.array().abs() > 1e-6).all()) {
        result.scale = result.scale.cwiseQuotient(above);
      }
    }
    return result;
  }

  void models() {
    ids_.assign(scene_.models.size(), kFbxRoot);
    for (std::size_t i = 0; i < scene_.models.size(); ++i) {
      if (!plain_.kept[i]) {
        continue;
      }
      EulerAngles angles{0.0, 0.0, 0.0};
      const FbxChannels values = channels(placement(i, scene_.models[i].rest), angles);
      ids_[i] = file_.begin_object("Model", fmt::format("n{}", i), "Model", "Null");
      out_.leaf("Version", 232);
      out_.begin("Properties70");
      constexpr std::array kNames = {"Lcl Translation", "Lcl Rotation", "Lcl Scaling"};
      for (std::size_t c = 0; c < 3; ++c) {
        file_.property(kNames[c], kNames[c], "", "A", values[c].x(), values[c].y(), values[c].z());
      }
      out_.end();
      out_.end();
      const int parent = scene_.models[i].parent;
      file_.connect(ids_[i], parent < 0 ? kFbxRoot : ids_[static_cast<std::size_t>(parent)]);
    }
  }

  Status animation(std::size_t stack) {
    std::vector<std::vector<std::pair<const FbxLayer*, const FbxCurveNode*>>> by_model(scene_.models.size());
    for (const FbxLayer& layer : scene_.stacks[stack].layers) {
      for (const FbxCurveNode& node : layer.nodes) {
        by_model[static_cast<std::size_t>(node.model)].emplace_back(&layer, &node);
      }
    }
    const FbxId id = file_.begin_object("AnimationStack", fmt::format("s{}", stack), "AnimStack", "");
    out_.end(true);
    const FbxId layer = file_.begin_object("AnimationLayer", "Layer", "AnimLayer", "");
    out_.end(true);
    file_.connect(layer, id);
    for (std::size_t model = 0; model < by_model.size(); ++model) {
      if (!plain_.kept[model] || by_model[model].empty()) {
        continue;
      }
      if (Status status = node(stack, model, by_model[model], layer); !status) {
        return status;
      }
    }
    return {};
  }

  Status node(std::size_t stack, std::size_t model,
              const std::vector<std::pair<const FbxLayer*, const FbxCurveNode*>>& nodes, FbxId layer) {
    std::vector<Moving> moving;
    for (const auto& [from_layer, from_node] : nodes) {
      Moving& entry = moving.emplace_back(Moving{&scene_.stacks[stack].layers.front(), from_layer, from_node, {}});
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (from_node->curves[axis] == nullptr) {
          continue;
        }
        Result<FbxCurve> curve = FbxCurve::load(records_, *from_node->curves[axis], scene_.models[model].name);
        if (!curve) {
          return curve.error();
        }
        entry.curves[axis] = std::move(*curve);
      }
    }
    FbxPlainKeys& keys = plain_.keys[stack][model];
    if (!key_times(moving, keys)) {
      return records_.error(
          scene_.models[model].offset,
          fmt::format("the animation of \"{}\" has more keys than can be read", scene_.models[model].name));
    }
    const FbxPlacement rest = placement(model, scene_.models[model].rest);
    std::array<std::array<std::vector<float>, 3>, 3> values;
    std::array<bool, 3> moves{};
    EulerAngles angles{0.0, 0.0, 0.0};
    const FbxChannels still = channels(rest, angles);
    for (const std::int64_t tick : keys.times) {
      const FbxChannels now = channels(placement(model, sample(moving, model, tick)), angles);
      for (std::size_t c = 0; c < 3; ++c) {
        moves[c] = moves[c] || (now[c] - still[c]).cwiseAbs().maxCoeff() > kSame;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          values[c][axis].push_back(static_cast<float>(now[c][static_cast<int>(axis)]));
        }
      }
    }
    constexpr std::array kNames = {"Lcl Translation", "Lcl Rotation", "Lcl Scaling"};
    for (std::size_t c = 0; c < 3; ++c) {
      // At least the rotation, so that the keys are there.
      if (moves[c] || (c == kFbxRotation && !moves[kFbxTranslation])) {
        curves(keys.times, values[c], layer, ids_[model], kNames[c]);
      }
    }
    return {};
  }

  static Vector3d value_of(const Moving& entry, std::int64_t tick) {
    Vector3d own = entry.node->constant;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (entry.curves[axis]) {
        own[static_cast<int>(axis)] = entry.curves[axis]->at(tick);
      }
    }
    return own;
  }

  // All layers together: the first as it is, additive ones on top, others in its place by their weight.
  FbxChannels sample(const std::vector<Moving>& moving, std::size_t model, std::int64_t tick) const {
    FbxChannels values = scene_.models[model].rest;
    for (const Moving& entry : moving) {
      const FbxChannelIndex c = entry.node->channel;
      const Vector3d own = value_of(entry, tick);
      const double weight = entry.layer->weight;
      if (entry.layer == moving.front().first) {
        values[c] = own;
      } else if (!entry.layer->additive) {
        values[c] += weight * (own - values[c]);
      } else if (c == kFbxScaling) {
        values[c] = values[c].cwiseProduct(Vector3d::Ones() + weight * (own - Vector3d::Ones()));
      } else {
        values[c] += weight * own;
      }
    }
    return values;
  }

  // The curves' own key times, and frames where straight lines from key to key would go elsewhere.
  bool key_times(const std::vector<Moving>& moving, FbxPlainKeys& keys) {
    std::vector<std::int64_t> own;
    const std::vector<std::int64_t>* last = nullptr;
    std::vector<const FbxCurve*> all;
    for (const Moving& entry : moving) {
      for (const std::optional<FbxCurve>& curve : entry.curves) {
        if (!curve) {
          continue;
        }
        all.push_back(&*curve);
        if (last == nullptr || *last != curve->times()) {
          own.insert(own.end(), curve->times().begin(), curve->times().end());
          last = &curve->times();
        }
      }
    }
    std::ranges::sort(own);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    const double frame = kFbxTicksPerSecond / scene_.fps;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const std::int64_t from = own[i];
      if (++keys_ > most_keys_) {
        return false;
      }
      keys.times.push_back(from);
      const bool last_key = i + 1 == own.size();
      const auto on_all = [&](bool (FbxCurve::*asks)(std::int64_t) const) {
        return std::ranges::all_of(all, [&](const FbxCurve* curve) { return (curve->*asks)(from); });
      };
      const bool holds = !last_key && on_all(&FbxCurve::holds_after) && !on_all(&FbxCurve::straight_after);
      keys.holds.push_back(holds);
      if (last_key || holds || !bends(moving, all, from, own[i + 1])) {
        continue;
      }
      for (double at = std::floor(static_cast<double>(from) / frame + 1e-3) + 1.0;
           at * frame < static_cast<double>(own[i + 1]) - 1e-3 * frame; at += 1.0) {
        const std::int64_t tick = std::llround(at * frame);
        if (++keys_ > most_keys_ || ++added_ > kMostAddedKeys) {
          return false;
        }
        if (tick > keys.times.back()) {
          keys.times.push_back(tick);
          keys.holds.push_back(false);
        }
      }
    }
    return true;
  }

  static bool bends(const std::vector<Moving>& moving, const std::vector<const FbxCurve*>& all, std::int64_t from,
                    std::int64_t to) {
    if (!std::ranges::all_of(all, [&](const FbxCurve* curve) { return curve->straight_after(from); })) {
      return true;
    }
    double turn = 0.0;
    for (const Moving& entry : moving) {
      for (const std::optional<FbxCurve>& curve : entry.curves) {
        if (entry.node->channel == kFbxRotation && curve) {
          turn += std::abs(curve->at(to) - curve->at(from));
        }
      }
    }
    return turn > kLargestTurn;
  }

  void curves(const std::vector<std::int64_t>& times, const std::array<std::vector<float>, 3>& values, FbxId layer,
              FbxId model, const char* property) {
    const FbxId node = file_.begin_object("AnimationCurveNode", "c", "AnimCurveNode", "");
    out_.end(true);
    file_.connect(node, layer);
    file_.connect(node, model, property);
    const FbxArray packed = fbx_array(std::span<const std::int64_t>(times), 0);
    constexpr std::array kAxes = {"d|X", "d|Y", "d|Z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const FbxId curve = file_.begin_object("AnimationCurve", "", "AnimCurve", "");
      out_.leaf("KeyVer", 4009);
      out_.leaf_array("KeyTime", packed);
      out_.leaf_array("KeyValueFloat", fbx_array(std::span<const float>(values[axis]), 0));
      const std::array<std::int32_t, 1> flag = {kFbxLinear};
      const std::array<float, 4> data{};
      const std::array<std::int32_t, 1> count = {static_cast<std::int32_t>(times.size())};
      out_.leaf_array("KeyAttrFlags", fbx_array(std::span<const std::int32_t>(flag)));
      out_.leaf_array("KeyAttrDataFloat", fbx_array(std::span<const float>(data)));
      out_.leaf_array("KeyAttrRefCount", fbx_array(std::span<const std::int32_t>(count)));
      out_.end();
      file_.connect(curve, node, kAxes[axis]);
    }
  }

  FbxRecords& records_;
  const FbxScene& scene_;
  std::size_t most_keys_;
  MemorySink sink_;
  FbxRecordWriter out_;
  FbxSceneWriter file_;
  FbxPlain plain_;
  std::vector<FbxId> ids_;
  std::size_t keys_ = 0;
  std::size_t added_ = 0;
};

}  // namespace

Result<FbxPlain> plain_fbx(FbxRecords& records, const FbxScene& scene) {
  return PlainWriter(records, scene).write();
}

}  // namespace limbwave::interchange
