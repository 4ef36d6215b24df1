/// Playing a BVH file of our own from its first frame to its last, holding a small part of it in memory.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "interchange/bvh_reader.h"

namespace limbwave::interchange {

class BvhPlayback {
 public:
  /// Reads the hierarchy and the first frames. Fails as `load_bvh` does, and on files without a frame.
  static Result<BvhPlayback> open(const std::filesystem::path& path, const BvhReadOptions& options);

  [[nodiscard]] const body::Skeleton& skeleton() const { return block_.skeleton; }
  /// p_W of every joint, metres. Times, in seconds, must not decrease from call to call. Fails where the file ends
  /// before the time, or holds another number of frames than it says.
  Status places(double time_s, std::vector<Eigen::Vector3d>& p_W);

 private:
  BvhPlayback(std::ifstream file, std::string place, BvhReadOptions options);
  // Puts the frames that follow into `block_`, behind the last line that is there.
  Status load();

  std::ifstream file_;
  std::string place_;
  BvhReadOptions options_;
  std::string head_;    ///< Up to and without the count of frames.
  std::string timing_;  ///< The line that says the frame time.
  std::vector<std::string> lines_;
  std::size_t declared_ = 0;
  std::size_t first_ = 0;  ///< Frame of the first line.
  bool ended_ = false;
  motion::Clip block_;
  std::vector<body::SegmentPose> poses_;
};

}  // namespace limbwave::interchange
