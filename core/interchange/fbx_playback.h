/// Playing an FBX file of our own from its first frame to its last, holding next to nothing of it in memory.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "interchange/fbx_scene.h"

namespace limbwave::interchange {

/// An animation curve that is unpacked as time passes. Straight, constant and, with given tangents, cubic pieces.
class FbxCurveStream {
 public:
  /// The record must outlive it. Fails as FbxCurve::load does, but on single keys only when they are reached, and on
  /// key times and values of another type than ours.
  static Result<FbxCurveStream> open(FbxRecords& records, const FbxRecord& record, const std::string& name);
  FbxCurveStream(FbxCurveStream&&) noexcept;
  ~FbxCurveStream();

  /// The value at a time, held before the first and after the last key. Times must not decrease from call to call.
  Result<double> at(std::int64_t ticks);

 private:
  struct State;
  explicit FbxCurveStream(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Where the joints of a file are at one time after another, computed from its curves and nodes as FBX defines them.
/// Memory grows with the number of curves alone.
class FbxPlayback {
 public:
  /// `bytes` must outlive it. The first animation is played. Fails on whatever `read_fbx` refuses in a file's records
  /// and nodes, on several layers, and on skeletons without bones.
  static Result<FbxPlayback> open(std::string_view bytes, const std::string& place);
  FbxPlayback(FbxPlayback&&) noexcept;
  ~FbxPlayback();

  [[nodiscard]] std::size_t actors() const;
  /// Parent of every joint of an actor, by index; -1 for the root. Parents come first.
  [[nodiscard]] const std::vector<int>& parents(std::size_t actor) const;
  /// p_W of every joint of an actor, metres. Times, in seconds, must not decrease from call to call for one actor.
  Status places(std::size_t actor, double time_s, std::vector<Eigen::Vector3d>& p_W);

 private:
  struct State;
  explicit FbxPlayback(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace limbwave::interchange
