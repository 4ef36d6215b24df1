/// glTF 2.0 files (.glb and .gltf) for and from other programs. Takes keep their solves with gltf_clip.h.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/progress.h"
#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::interchange {

struct GltfWriteOptions {
  /// What VRM 1.0 asks for beyond glTF: the extension VRMC_vrm with the bones' roles. Files end in .vrm then.
  bool vrm = false;
};

/// Writes all clips as actors of one scene, all-or-nothing: a node per segment with its rest pose and name (unique in
/// the file), metres, Y up, facing +Z; every mesh with a skin, so that importers make an armature; one animation named
/// as the first clip. Tracks of one interpolation keep their keys, cubic ones as CUBICSPLINE with keys added where a
/// curve of quaternion components would leave ours by more than 0.01°; mixed ones are written as linear keys at the
/// clip's frame rate. The ending chooses the form: .gltf is JSON with the buffer inside, everything else binary.
/// Fails when there is no clip, a clip or mesh is not valid, the file would exceed 4 GB, or when cancelled.
Status write_gltf(std::span<const motion::Clip* const> clips, const std::filesystem::path& path,
                  const GltfWriteOptions& options = {}, const Progress& progress = {});

/// Reads every tree of joints with every animation: a clip for each pair, at least one a tree. Nodes count as bones
/// that are joints of skins, move, were written as bones by Limbwave, or lie between such and the scene; what holds
/// still above them is folded in, with its scale. Reads STEP, LINEAR and CUBICSPLINE, normalised integers, sparse
/// accessors, matrices, skins of any bind pose. Frames and names stay the file's, so that writing gives the same again.
/// Bones have the length that Limbwave wrote beside them, else reach to the mean of their children. Scale that moves or
/// is not uniform, morphs and more than four influences are reported and left out. Other files are read only from the
/// file's own folder. Fails in one line on everything else, with the JSON place where there is one.
Result<std::vector<motion::Clip>> load_gltf(const std::filesystem::path& path, Diagnostics* diagnostics = nullptr);
/// The same from memory; `folder` is where buffers that are named may lie, empty: nowhere.
Result<std::vector<motion::Clip>> read_gltf(std::string_view bytes, const std::string& place,
                                            const std::filesystem::path& folder = {},
                                            Diagnostics* diagnostics = nullptr);

}  // namespace limbwave::interchange
