#include "base/folder.h"

#include <algorithm>
#include <system_error>

namespace limbwave {
namespace fs = std::filesystem;

Result<std::vector<fs::path>> list_folder(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code code;
  // Not a range-for: its ++ throws.
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    paths.push_back(entry->path());
  }
  if (code) {
    return Error{"cannot be listed (" + code.message() + ")", folder.string(), "check its permissions"};
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  Result<std::vector<fs::path>> paths = list_folder(folder);
  return paths ? *std::move(paths) : std::vector<fs::path>();
}

}  // namespace limbwave
