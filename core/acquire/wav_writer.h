/// A WAV file that is valid at every instant while it grows, and becomes RF64 when it passes 4 GiB.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "acquire/sample_format.h"
#include "base/result.h"

namespace limbwave::acquire {

/// The header of a WAV file with so many frames, as WavWriter leaves it: RIFF, or RF64 beyond 4 GiB. Its length depends
/// on the format alone.
std::string wav_header(const StreamFormat& format, std::int64_t frames);

/// Writes raw samples. The file is locked (flock) as long as it is open, so that others can tell a recording that is
/// going on from one that a crash left.
class WavWriter {
 public:
  /// Makes the file, which must not exist, with the header of an empty recording.
  static Result<std::unique_ptr<WavWriter>> create(const std::filesystem::path& path, const StreamFormat& format);
  ~WavWriter();  ///< Closes.
  WavWriter(const WavWriter&) = delete;
  WavWriter& operator=(const WavWriter&) = delete;

  /// Appends whole frames: to the operating system, not necessarily to the disk. On failure whole frames that could be
  /// written are kept, and nothing more may be written.
  Status write(std::span<const std::byte> bytes);
  /// Makes the header describe everything that was written.
  Status update_header();
  /// Exact header, everything on disk. Frames are safe also when this fails.
  Status close();

  [[nodiscard]] std::int64_t frames() const;

 private:
  struct Impl;
  explicit WavWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::acquire
