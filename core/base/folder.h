/// Listing of folders without exceptions.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"

namespace limbwave {

/// Everything directly in a folder, by name. Fails with the operating system's reason when it cannot be listed to its
/// end.
Result<std::vector<std::filesystem::path>> list_folder(const std::filesystem::path& folder);

/// The same, empty when it cannot be listed: where a folder that is not there means that there is nothing.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder);

}  // namespace limbwave
