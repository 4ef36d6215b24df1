/// Whole-file reading and all-or-nothing writing.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace limbwave {

/// The bytes of a file. Fails when it cannot be read or is larger than `limit_bytes`.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t limit_bytes = std::size_t{1} << 30);

/// Writes beside `path`, flushes to disk and renames over it: after a crash the old or the new content is there,
/// never a part. Fails with the operating system's reason.
Status write_file(const std::filesystem::path& path, std::string_view content);

/// Puts the names in a folder onto the disk: a file that was made, renamed or removed there stays so when the power
/// goes. File systems that cannot do that are left alone.
void sync_folder(const std::filesystem::path& folder);

/// Folder of rigs, skeletons and other shipped files: $LIMBWAVE_RESOURCES, else beside the program, else where it
/// was built or installed.
std::filesystem::path resources_folder();

/// Folder for what belongs to the user across takes (calibration library, recent takes): $LIMBWAVE_HOME, else
/// $XDG_DATA_HOME/limbwave, else ~/.local/share/limbwave. Not created here.
std::filesystem::path user_data_folder();

}  // namespace limbwave
