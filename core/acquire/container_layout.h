/// What the headers of WAV, RF64, W64 and AIFF files say about themselves. libsndfile quietly corrects a header that
/// does not fit the file; here it is found out, so that a recording that was cut off can be told from a whole one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace limbwave::acquire {

struct ContainerLayout {
  std::uint64_t file_bytes = 0;
  std::uint64_t data_offset = 0;  ///< Where the samples begin.
  /// As declared; empty when the header was never closed (zero or all ones, as recorders leave it that lose power).
  std::optional<std::uint64_t> data_bytes;
  int channels = 0;
  double rate_hz = 0.0;
  int bytes_per_frame = 0;  ///< 0 for compressed samples.

  /// Bytes of samples that the file really holds, of which `data_bytes` may have promised more.
  [[nodiscard]] std::uint64_t bytes_there() const {
    const std::uint64_t rest = file_bytes > data_offset ? file_bytes - data_offset : 0;
    return data_bytes && *data_bytes < rest ? *data_bytes : rest;
  }
};

/// Empty for other kinds of files, and when the header ends before it has described the samples.
std::optional<ContainerLayout> read_layout(const std::filesystem::path& path);

}  // namespace limbwave::acquire
