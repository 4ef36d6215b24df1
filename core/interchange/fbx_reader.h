/// Reading of binary FBX files, as other programs write them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "interchange/bvh_reader.h"
#include "motion/clip.h"

namespace limbwave::interchange {

struct FbxReadOptions {
  /// kFile keeps the file's own axes, so that writing gives the same file again; kAlongBone turns every bone's frame
  /// so that x points to the mean of its children.
  BoneFrames frames = BoneFrames::kFile;
  /// False: skeletons at rest and meshes alone.
  bool animation = true;
};

/// One clip per animation and skeleton of the file, animations first; without animation one still clip per skeleton.
/// Units and axes are those that the file states. Every joint gets its keys where the file has them; where the file's
/// curves are no straight lines, or turn far between two keys, also every frame. Nodes that are no bones but lie
/// between bones count as bones. What bones hang on is made part of the root's movement. Scale has no place in a clip:
/// constant ones are in the lengths; where it changes or differs by direction, positions are kept exactly at keys and
/// bones slide. Skinned meshes come with at most four influences and smooth normals.
///
/// The file is checked and said again in the simplest way (fbx_plain.h) before Assimp turns it into nodes, rotations
/// and weights, so that no broken file reaches it. Fails, with the byte, on text FBX, versions before 7.1, what is cut
/// off, counts and indices that do not fit, numbers that are none or absurd, nodes in a circle, and sizes that no
/// program writes; memory is bounded by a multiple of the file's size and by fixed limits.
Result<std::vector<motion::Clip>> read_fbx(std::string_view bytes, const std::string& place,
                                           const FbxReadOptions& options = {});
/// The same from a file; clips whose animation has no name get the file's.
Result<std::vector<motion::Clip>> load_fbx(const std::filesystem::path& path, const FbxReadOptions& options = {});

}  // namespace limbwave::interchange
