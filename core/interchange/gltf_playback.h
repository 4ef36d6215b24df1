/// Playing a glTF file of our own from its first frame to its last, with the keys of a part of it at a time.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

class GltfPlayback {
 public:
  /// Reads the file as `load_gltf` does, with the keys of the first minutes. Fails like it.
  static Result<GltfPlayback> open(const std::filesystem::path& path);
  GltfPlayback(GltfPlayback&&) noexcept;
  ~GltfPlayback();

  /// The clips with the keys of the part that was played last.
  [[nodiscard]] const std::vector<motion::Clip>& clips() const;
  /// p_W of every joint of a clip, metres. Quick while times, in seconds, stay close together.
  Status places(std::size_t clip, double time_s, std::vector<Eigen::Vector3d>& p_W);

 private:
  struct State;
  explicit GltfPlayback(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace limbwave::interchange
