/// Recordings of field and MP3 recorders, read exactly: WAV, W64, RF64, FLAC, AIFF and what else libsndfile knows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "acquire/sample_format.h"
#include "base/diagnostics.h"
#include "base/result.h"

namespace limbwave::acquire {

inline constexpr double kLowestRateHz = 8000.0;     ///< A cycle of the multiplexer needs several samples per slot.
inline constexpr double kHighestRateHz = 768000.0;  ///< No sound card goes beyond.

/// What to do about a recording that breaks off and that `accept_truncated` would take.
inline constexpr const char* kBreaksOffRemedy = "copy it again from the recorder, or accept what is there";

struct RecordingOptions {
  /// Read a file whose header promises more samples than are there as far as it goes, with a diagnostic.
  bool accept_truncated = false;
  int minimum_channels = 2;
};

/// Streams the raw samples of one recording from front to back. 16, 24 and 32 bit integers and 32-bit floats come out
/// bit-exactly; other types are converted to the nearest of them that loses least, with a diagnostic.
class RecordingFile {
 public:
  /// Fails in one line for what is missing, a folder, empty, not audio, cut off, has too few channels or a rate beyond
  /// kLowestRateHz..kHighestRateHz.
  static Result<RecordingFile> open(const std::filesystem::path& path, const RecordingOptions& options = {});

  ~RecordingFile();
  RecordingFile(RecordingFile&&) noexcept;
  RecordingFile& operator=(RecordingFile&&) noexcept;

  /// Of the bytes that `read` gives; the sample type may differ from the file's, see `diagnostics`.
  [[nodiscard]] const StreamFormat& format() const;
  /// Frames in the file; empty when its header does not say (some FLAC streams).
  [[nodiscard]] std::optional<std::int64_t> frames() const;
  [[nodiscard]] const std::filesystem::path& path() const;

  /// Reads whole interleaved frames into `out`; returns the bytes written, 0 at the end. Fails where the file breaks
  /// off or cannot be decoded.
  Result<std::size_t> read(std::span<std::byte> out);

  /// What opening and reading so far have noticed: conversions, a trailing part of a frame, a header that was never
  /// closed, float samples that are not numbers (an error, with their count). Complete once `read` has returned 0.
  [[nodiscard]] Diagnostics diagnostics() const;

 private:
  struct Impl;
  explicit RecordingFile(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::acquire
