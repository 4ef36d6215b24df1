/// What stands in an FBX file before its objects.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "interchange/fbx_scene_writer.h"
#include "interchange/fbx_writer.h"

namespace limbwave::interchange {

struct FbxHeader {
  double fps = 60.0;
  FbxUpAxis up = FbxUpAxis::kY;
  double metres_per_unit = 0.01;
  std::int64_t stop_ticks = 0;                               ///< End of the animation.
  std::string stack;                                         ///< Name of the animation; empty: none.
  std::vector<std::pair<std::string, std::int32_t>> counts;  ///< How many objects of which type follow.
};

/// The number by which FBX names a frame rate; 14 (custom) for those without a name.
std::int32_t fbx_time_mode(double fps);

void write_fbx_header(FbxRecordWriter& out, FbxSceneWriter& scene, const FbxHeader& header);
/// The list of animations at the end.
void write_fbx_takes(FbxRecordWriter& out, const FbxHeader& header);

}  // namespace limbwave::interchange
