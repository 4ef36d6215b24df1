/// Recordings of other recorders become takes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "acquire/recording_file.h"
#include "base/progress.h"
#include "base/result.h"
#include "body/rig.h"
#include "take/take.h"

namespace limbwave::take {

/// Makes a take out of one recording, or of several files that are consecutive parts of one (field recorders begin a
/// new file every 2 GB), in the order given; they must agree in rate, channels and sample type. Samples are kept bit by
/// bit. What was noticed (conversions, a trailing part of a frame) is in the take's diagnostics and events. Fails for
/// what RecordingFile refuses (with `reading.accept_truncated` a file that breaks off is taken as far as it goes), for
/// more than two channels, for float samples that are not numbers, and when the folder exists; failed or cancelled,
/// nothing is left on disk.
Result<Take> import_recordings(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files,
                               const body::Rig& rig, const Progress& progress, const std::string& subject = {},
                               const acquire::RecordingOptions& reading = {});

}  // namespace limbwave::take
