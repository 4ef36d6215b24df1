/// What was written reaches the disk itself, so that a loss of power takes no more than a crash of the program does.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

namespace limbwave::take {

/// Asks the operating system again and again to put files that grow onto the disk (fdatasync). That can take a second
/// on a slow card, so that it happens on a thread of its own: neither the writer nor the sound card waits.
class DiskSync {
 public:
  /// The files exist already. At most one round every `interval`, and none while nothing is written.
  DiskSync(const std::vector<std::filesystem::path>& files, std::chrono::milliseconds interval);
  ~DiskSync();  ///< Waits for a round that is going on.
  DiskSync(const DiskSync&) = delete;
  DiskSync& operator=(const DiskSync&) = delete;

  /// Something was written. Never blocks for long; any thread.
  void written();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::take
