/// Reading a file that was just written back, as it is played.
#pragma once

#include <filesystem>
#include <vector>

#include "interchange/export_file.h"
#include "interchange/read_back.h"

namespace limbwave::interchange {

/// Compares the file with the clips that it was written from, whose memory is given back first: what stays is where
/// their joints are (a third), the file's bytes where the format needs them, and a few minutes of its keys. Fails as
/// `compare_paths`, with kExportTolerance, and on files that cannot be read.
Result<ReadBack> check_export(std::vector<motion::Clip> meant, FileFormat format, FileUnit unit,
                              const std::filesystem::path& path, const Progress& progress = {});

}  // namespace limbwave::interchange
