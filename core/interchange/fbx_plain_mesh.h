/// Skinned meshes of FBX files, said again in the simplest way.
#pragma once

#include "interchange/fbx_plain.h"
#include "interchange/fbx_scene_writer.h"

namespace limbwave::interchange {

/// Checks the geometry and the clusters of a skin, and writes them: triangles that lie in the world as they are bound,
/// one cluster per bone with the bone's inverse bind matrix. `ids`: of the models that were written.
/// Fails, with the byte, on lists of the wrong length, corners and vertices that are not there, and absurd numbers.
Result<FbxPlainMesh> plain_fbx_mesh(FbxRecords& records, const FbxScene& scene, int skin, const std::vector<FbxId>& ids,
                                    FbxRecordWriter& out, FbxSceneWriter& file);

}  // namespace limbwave::interchange
