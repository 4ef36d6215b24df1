/// The motion as it will be in the file, made beside the window: for the picture and the summary. No widgets.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/progress.h"
#include "interchange/export_file.h"

namespace limbwave::ui {

using SharedClip = std::shared_ptr<const motion::Clip>;
using SharedMesh = std::shared_ptr<const motion::SkinnedMesh>;

/// Own meshes that are skinned already, by mesh file and skeleton: weights take seconds. Safe in any thread.
class MeshCache {
 public:
  /// Skins the file's mesh to the clip's skeleton, unless that was done before and the file has not changed.
  Result<SharedMesh> get(const std::filesystem::path& file, const motion::Clip& clip, const Progress& progress);

 private:
  std::mutex mutex_;
  std::map<std::string, SharedMesh> meshes_;
};

struct PreparedExport {
  std::vector<motion::Clip> clips;   ///< One an actor. Bones keep the axes they had, so that they can be drawn.
  body::Skeleton skeleton;           ///< All actors' bones in a row, x along each; roots have no parent.
  interchange::ExportReport report;  ///< Of the whole file, also where only a part was prepared.
  bool partial = false;              ///< The clips end before the file does: it is very long.
  bool person = false;               ///< A person's bones were found by their names, in the first actor.
  double source_rate_hz = 0.0;       ///< Of the first actor, before.
  double lead_s = 0.0;       ///< Time in the file of the range's begin: one frame where frame 0 is the rest pose.
  std::uintmax_t bytes = 0;  ///< Roughly, of the file.
  std::size_t vertices = 0;  ///< Of all bodies.
  std::vector<Eigen::Quaterniond> R_LX;  ///< Turns x along the bone, for segments of `skeleton`.

  /// World poses of all actors at a time of the file.
  void pose_at(double file_s, std::vector<body::SegmentPose>& poses) const;
  /// The same with every actor at rest.
  void rest_pose(std::vector<body::SegmentPose>& poses) const;
};

/// Prepares the clips as `options` say, without writing: cut, resampled, arranged and reduced. Of very long ranges the
/// beginning. `meshes`: own bodies, one a clip; empty: as `options` say. Fails as the export would.
Result<PreparedExport> prepare_export(const std::vector<SharedClip>& clips, interchange::FileFormat format,
                                      const interchange::ExportOptions& options, const std::vector<SharedMesh>& meshes,
                                      const Progress& progress);

/// How large the file is going to be, from what is in it: right within about a third.
std::uintmax_t estimated_bytes(interchange::FileFormat format, const interchange::ExportReport& report,
                               std::size_t vertices, std::size_t triangles);

}  // namespace limbwave::ui
