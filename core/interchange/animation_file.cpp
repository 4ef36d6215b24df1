#include "interchange/animation_file.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "interchange/bvh_reader.h"
#include "interchange/fbx_reader.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_file.h"

namespace limbwave::interchange {
namespace {

using Clips = Result<std::vector<motion::Clip>>;

// ".BVH" of another program is ".bvh" too.
std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return ending;
}

Clips one(Result<motion::Clip> clip) {
  if (!clip) {
    return clip.error();
  }
  std::vector<motion::Clip> clips;
  clips.push_back(*std::move(clip));
  return clips;
}

Clips read(const std::filesystem::path& path, const std::string& ending, Diagnostics* diagnostics) {
  if (ending == ".bvh") {
    BvhReadOptions options;
    options.metres_per_unit = std::nullopt;  // the file does not say; the skeleton's size does
    options.diagnostics = diagnostics;
    return one(load_bvh(path, options));
  }
  if (ending == ".fbx") {
    return load_fbx(path);
  }
  // A take's own clip says more than glTF does.
  Result<motion::Clip> own = load_glb(path);
  return own ? one(std::move(own)) : load_gltf(path, diagnostics);
}

}  // namespace

const std::vector<std::string>& animation_endings() {
  static const std::vector<std::string> kEndings{".bvh", ".fbx", ".glb", ".gltf", ".vrm"};
  return kEndings;
}

bool is_animation_file(const std::filesystem::path& path) {
  return std::ranges::find(animation_endings(), ending_of(path)) != animation_endings().end();
}

Clips load_animation(const std::filesystem::path& path, Diagnostics* diagnostics) {
  if (!is_animation_file(path)) {
    return Error{"is no animation that can be read", path.string(), "choose a .bvh, .glb, .gltf, .vrm or .fbx file"};
  }
  Clips clips = read(path, ending_of(path), diagnostics);
  if (!clips) {
    return clips;
  }
  for (motion::Clip& clip : *clips) {
    if (clip.name.empty()) {
      clip.name = path.stem().string();
    }
  }
  return clips;
}

}  // namespace limbwave::interchange
