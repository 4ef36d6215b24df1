#include "workspaces/export/export_sources.h"

#include <utility>

namespace limbwave::ui {

std::string ExportSource::key() const {
  if (kind == Kind::kOpenSolve) {
    return std::to_string(static_cast<int>(kind)) + '\n' + solve;  // Whatever the take is called.
  }
  return std::to_string(static_cast<int>(kind)) + '\n' + origin.string() + '\n' + solve +
         (kind == Kind::kAnimation ? '\n' + title.toStdString() : std::string());
}

Result<motion::Clip> load_take_clip(const StudioServices& studio, const SolveServices& solving,
                                    const std::filesystem::path& folder, const std::string& solve) {
  const Result<take::Take> take = studio.open_take(folder);
  if (!take) {
    return take.error();
  }
  std::string name = solve;
  if (name.empty()) {
    const std::vector<std::string> names = solving.list(*take);
    if (names.empty()) {
      return Error{"the take is not solved yet", folder.string(), "open it, and add it again when it is solved"};
    }
    name = names.front();
  }
  Result<solve::Solve> loaded = solving.load(*take, name);
  if (!loaded) {
    return loaded.error();
  }
  return std::move(loaded->clip);
}

Result<SharedClip> ClipCache::get(const std::string& key, const Load& load) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = clips_.find(key); found != clips_.end()) {
      return found->second;
    }
  }
  Result<motion::Clip> clip = load();
  if (!clip) {
    return clip.error();
  }
  auto shared = std::make_shared<const motion::Clip>(*std::move(clip));
  const std::lock_guard lock(mutex_);
  clips_[key] = shared;
  return SharedClip(std::move(shared));
}

Result<std::vector<SharedClip>> load_clips(const std::vector<ClipRequest>& requests, ClipCache& cache,
                                           const Progress& progress) {
  std::vector<SharedClip> clips;
  for (const ClipRequest& request : requests) {
    if (!progress.report(static_cast<double>(clips.size()) / static_cast<double>(requests.size()), "reading")) {
      return cancelled();
    }
    Result<SharedClip> clip = request.clip ? Result<SharedClip>(request.clip) : cache.get(request.key, request.load);
    if (!clip) {
      return clip.error();
    }
    clips.push_back(*std::move(clip));
  }
  return clips;
}

}  // namespace limbwave::ui
