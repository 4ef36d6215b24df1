/// What can be exported: the solve that is open, with its edits, other solves and takes, and animation files. No
/// widgets.
#pragma once

#include <QString>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "common/studio_services.h"
#include "workspaces/export/export_prepare.h"
#include "workspaces/solve/solve_services.h"

namespace limbwave::ui {

struct ExportSource {
  enum class Kind { kOpenSolve, kSolve, kTake, kAnimation };
  Kind kind = Kind::kOpenSolve;
  QString title;
  std::string solve;             ///< Name of the solve; empty for animations and for a take's first one.
  std::filesystem::path origin;  ///< The take's folder, or the animation file.
  SharedClip clip;               ///< Of animations, which are read when they are chosen.
  /// What tells sources apart: one that stands for the same has the same.
  [[nodiscard]] std::string key() const;
  bool operator==(const ExportSource&) const = default;
};

/// Reads a take's solve from disk; in a job.
Result<motion::Clip> load_take_clip(const StudioServices& studio, const SolveServices& solving,
                                    const std::filesystem::path& folder, const std::string& solve);

/// Clips that were read or edited already. Replaced as a whole when something changes: jobs that still run fill the old
/// one. Safe in any thread.
class ClipCache {
 public:
  using Load = std::function<Result<motion::Clip>()>;
  Result<SharedClip> get(const std::string& key, const Load& load);

 private:
  std::mutex mutex_;
  std::map<std::string, SharedClip> clips_;
};

/// Sources of an export and how to get them, for a job.
struct ClipRequest {
  std::string key;
  SharedClip clip;       ///< If it is there already.
  ClipCache::Load load;  ///< Else.
};
Result<std::vector<SharedClip>> load_clips(const std::vector<ClipRequest>& requests, ClipCache& cache,
                                           const Progress& progress);

}  // namespace limbwave::ui
