#include "take/signal_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <string>

#include "acquire/container_layout.h"
#include "acquire/recording_file.h"
#include "acquire/wav_writer.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

bool is_locked(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return false;
  }
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

}  // namespace

Result<SignalFile> inspect_signal(const fs::path& path, const acquire::StreamFormat& format) {
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    return Error{"is missing", path.string(), "the samples of this take are lost unless you have a copy of that file"};
  }
  SignalFile signal;
  signal.being_written = is_locked(path);
  signal.file_bytes = fs::file_size(path, code);
  const std::uint64_t frame = format.bytes_per_frame();
  const std::optional<acquire::ContainerLayout> layout = acquire::read_layout(path);
  if (layout) {
    if (layout->channels != format.channels || std::lround(format.rate.hz) != std::lround(layout->rate_hz) ||
        static_cast<std::uint64_t>(layout->bytes_per_frame) != frame) {
      return Error{fmt::format("holds {} channels at {:.0f} Hz with {} bytes per frame, but take.json says {} at "
                               "{:.0f} Hz with {}",
                               layout->channels, layout->rate_hz, layout->bytes_per_frame, format.channels,
                               format.rate.hz, frame),
                   path.string(), "put back the file that belongs to this take"};
    }
    signal.header_readable = true;
    signal.data_offset = layout->data_offset;
    signal.header_frames = static_cast<std::int64_t>(layout->data_bytes.value_or(0) / frame);
  } else {
    signal.data_offset = acquire::wav_header(format, 0).size();
  }
  const std::uint64_t bytes = signal.file_bytes - std::min(signal.file_bytes, signal.data_offset);
  signal.frames = static_cast<std::int64_t>(bytes / frame);
  signal.partial_bytes = bytes % frame;
  return signal;
}

std::optional<acquire::StreamFormat> format_from_header(const fs::path& path) {
  const Result<acquire::RecordingFile> file =
      acquire::RecordingFile::open(path, {.accept_truncated = true, .minimum_channels = 1});
  if (!file || !acquire::read_layout(path)) {
    return std::nullopt;
  }
  const auto converted = [](const Diagnostic& finding) { return finding.code == "recording.converted"; };
  const Diagnostics findings = file->diagnostics();
  if (std::any_of(findings.begin(), findings.end(), converted)) {
    return std::nullopt;
  }
  return file->format();
}

}  // namespace limbwave::take
