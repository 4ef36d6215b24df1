#include "interchange/fbx_playback.h"

#include <cmath>
#include <utility>

#include "interchange/fbx_format.h"
#include "interchange/fbx_import.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;

// The three properties of a node with the curves that move them.
struct Node {
  FbxChannels still;
  struct Curve {
    FbxChannelIndex channel;
    int axis;
    FbxCurveStream values;
  };
  std::vector<Curve> curves;
};

struct Actor {
  std::vector<int> models;  // what the root hangs on, then joints; parents first
  std::vector<int> above;   // of `models`, by index; -1: the scene
  std::size_t first_joint = 0;
  std::vector<int> parents;
  std::vector<Eigen::Affine3d> places;  // of `models`, used again
};

std::vector<Actor> actors_of(const FbxScene& scene) {
  // As in reading: joints and what they hang on.
  FbxPlain plain;
  plain.kept.assign(scene.models.size(), false);
  for (std::size_t i = scene.models.size(); i-- > 0;) {
    plain.kept[i] = plain.kept[i] || scene.models[i].joint;
    if (plain.kept[i] && scene.models[i].parent >= 0) {
      plain.kept[static_cast<std::size_t>(scene.models[i].parent)] = true;
    }
  }
  std::vector<Actor> actors;
  std::vector<int> place(scene.models.size(), -1);
  for (const FbxActor& found : fbx_actors(scene, plain)) {
    Actor actor;
    actor.models = found.above;
    actor.models.insert(actor.models.end(), found.joints.begin(), found.joints.end());
    actor.first_joint = found.above.size();
    for (std::size_t i = 0; i < actor.models.size(); ++i) {
      const auto model = static_cast<std::size_t>(actor.models[i]);
      const int parent = scene.models[model].parent;
      place[model] = static_cast<int>(i);
      actor.above.push_back(parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]);
      if (i >= actor.first_joint) {
        actor.parents.push_back(i == actor.first_joint ? -1 : actor.above.back() - static_cast<int>(actor.first_joint));
      }
    }
    actor.places.resize(actor.models.size());
    actors.push_back(std::move(actor));
  }
  return actors;
}

}  // namespace

struct FbxPlayback::State {
  FbxRecords records;
  FbxScene scene;
  std::vector<Actor> actors;
  std::vector<Node> nodes;  // one per model
};

FbxPlayback::FbxPlayback(std::unique_ptr<State> state) : state_(std::move(state)) {}
FbxPlayback::FbxPlayback(FbxPlayback&&) noexcept = default;
FbxPlayback::~FbxPlayback() = default;

Result<FbxPlayback> FbxPlayback::open(std::string_view bytes, const std::string& place) {
  Result<FbxRecords> records = FbxRecords::parse(bytes, place);
  if (!records) {
    return records.error();
  }
  auto state = std::make_unique<State>();
  state->records = *std::move(records);
  Result<FbxScene> scene = fbx_scene(state->records);
  if (!scene) {
    return scene.error();
  }
  state->scene = *std::move(scene);
  state->actors = actors_of(state->scene);
  if (state->actors.empty()) {
    return Error{"has no bones", place, "export the skeleton along with the animation"};
  }
  for (const FbxModel& model : state->scene.models) {
    state->nodes.push_back({model.rest, {}});
  }
  if (state->scene.stacks.empty()) {
    return FbxPlayback(std::move(state));
  }
  const FbxStack& stack = state->scene.stacks.front();
  if (stack.layers.size() > 1) {
    return Error{"has several layers of animation", place, "bake them into one"};
  }
  for (const FbxLayer& layer : stack.layers) {
    for (const FbxCurveNode& moved : layer.nodes) {
      Node& node = state->nodes[static_cast<std::size_t>(moved.model)];
      node.still[moved.channel] = moved.constant;
      for (int axis = 0; axis < 3; ++axis) {
        const FbxRecord* record = moved.curves[static_cast<std::size_t>(axis)];
        if (record == nullptr) {
          continue;
        }
        Result<FbxCurveStream> curve = FbxCurveStream::open(
            state->records, *record, state->scene.models[static_cast<std::size_t>(moved.model)].name);
        if (!curve) {
          return curve.error();
        }
        node.curves.push_back({moved.channel, axis, *std::move(curve)});
      }
    }
  }
  return FbxPlayback(std::move(state));
}

std::size_t FbxPlayback::actors() const {
  return state_->actors.size();
}

const std::vector<int>& FbxPlayback::parents(std::size_t actor) const {
  return state_->actors[actor].parents;
}

Status FbxPlayback::places(std::size_t actor, double time_s, std::vector<Vector3d>& p_W) {
  Actor& who = state_->actors[actor];
  const FbxScene& scene = state_->scene;
  const std::int64_t start = scene.stacks.empty() ? 0 : scene.stacks.front().start;
  const std::int64_t ticks = start + std::llround(time_s * kFbxTicksPerSecond);
  p_W.resize(who.parents.size());
  for (std::size_t i = 0; i < who.models.size(); ++i) {
    const auto model = static_cast<std::size_t>(who.models[i]);
    Node& node = state_->nodes[model];
    FbxChannels values = node.still;
    for (Node::Curve& curve : node.curves) {
      const Result<double> value = curve.values.at(ticks);
      if (!value) {
        return value.error();
      }
      values[curve.channel][curve.axis] = *value;
    }
    const FbxPlacement local = scene.models[model].placement(values);
    const Eigen::Affine3d M = Eigen::Translation3d(local.translation) * local.R * Eigen::Scaling(local.scale);
    who.places[i] = who.above[i] < 0 ? M : who.places[static_cast<std::size_t>(who.above[i])] * M;
    if (i >= who.first_joint) {
      p_W[i - who.first_joint] = scene.metres_per_unit * (scene.R_WF * who.places[i].translation());
    }
  }
  return {};
}

}  // namespace limbwave::interchange
