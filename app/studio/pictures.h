/// `limbwave-studio --pictures FOLDER TAKE`: pictures of a take where there is no display.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace limbwave::studio {

/// Writes FOLDER/skeleton.png (five instants of the newest solve) and FOLDER/signals.png. Needs a solved take.
Status write_pictures(const std::filesystem::path& folder, const std::filesystem::path& take_folder);

}  // namespace limbwave::studio
