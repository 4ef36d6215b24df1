/// What signal.wav really holds, whatever its header says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "acquire/sample_format.h"
#include "base/result.h"

namespace limbwave::take {

struct SignalFile {
  bool header_readable = false;
  std::uint64_t data_offset = 0;
  std::uint64_t file_bytes = 0;
  std::int64_t frames = 0;          ///< Whole frames from `data_offset` to the end of the file.
  std::int64_t header_frames = 0;   ///< As the header says.
  std::uint64_t partial_bytes = 0;  ///< Behind the last whole frame.
  bool being_written = false;       ///< Another program, or another part of this one, is recording into it.
};

/// Where no header can be read, the samples are taken to begin where a recorder of `format` puts them. Fails when there
/// is no such file, or its header describes another format.
Result<SignalFile> inspect_signal(const std::filesystem::path& path, const acquire::StreamFormat& format);

/// The format that the header alone tells, for a take that lost its take.json; empty when that is not one of ours.
std::optional<acquire::StreamFormat> format_from_header(const std::filesystem::path& path);

}  // namespace limbwave::take
