/// A take on disk (overview.md, "A take on disk"): a folder with the raw samples and everything known about them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "acquire/sample_format.h"
#include "base/diagnostics.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/time.h"
#include "body/rig.h"
#include "body/skeleton.h"
#include "calibrate/calibration.h"
#include "calibrate/ranging_calibration.h"

namespace limbwave::take {

/// A named stretch of the take: "capture", "range", "pose:Right arm:horizontal".
struct TakeSegment {
  std::string name;
  SampleIndex first;
  SampleCount count;
};

/// What happened at a sample; one line of events.jsonl.
struct TakeEvent {
  SampleIndex sample;
  std::string kind;        ///< "marker", "dropped", "clipping", "sync-lost", "gain-changed" ...
  std::string text;        ///< For people.
  std::int64_t count = 0;  ///< How many samples, cycles ..., where it has a meaning; of a marker its number.
};

/// take.json.
struct TakeInfo {
  int schema = 1;
  std::string kind = "line-in";  ///< Or "driver-box".
  std::string created;           ///< ISO 8601, UTC.
  std::string subject;
  std::string source;  ///< Device or file it came from, for people.
  acquire::StreamFormat format;
  bool complete = false;    ///< False while recording and after a crash.
  std::int64_t frames = 0;  ///< Frames per channel; what the file holds counts if it is not complete.
  /// CRC-32 (as in zlib and PNG) of the raw samples, without the header; empty until the recording is closed, and in
  /// takes that did not have one.
  std::optional<std::uint32_t> samples_crc32;
  body::Rig rig;
  body::Skeleton skeleton;
  std::optional<calibrate::RigCalibration> calibration;
  std::optional<calibrate::RangingCalibration> ranging;  ///< Of a driver box; empty: nominal.
  std::vector<TakeSegment> segments;                     ///< Empty: all of it is the capture.

  /// The segment "capture", or the whole take.
  [[nodiscard]] TakeSegment capture() const;
};

struct Take {
  std::filesystem::path folder;
  TakeInfo info;
  std::vector<TakeEvent> events;  ///< In force: markers as they were changed last (take/markers.h).
  Diagnostics diagnostics;        ///< What opening noticed: not closed properly, short, ...

  [[nodiscard]] std::filesystem::path signal_path() const { return folder / "signal.wav"; }
};

/// Opens a folder; takes that a crash left open as far as they were written, with a diagnostic.
Result<Take> open_take(const std::filesystem::path& folder);
/// Writes take.json (all-or-nothing).
Status save_info(const Take& take);
/// Appends to events.jsonl and flushes.
Status append_event(const std::filesystem::path& folder, const TakeEvent& event);

struct VerifyReport {
  Diagnostics findings;  ///< Empty: whole.
};
/// Checks every file of a take against the others, and the samples against their checksum. Only reads.
Result<VerifyReport> verify_take(const std::filesystem::path& folder, const Progress& progress = {});
/// Repairs headers and take.json after a crash; loses no sample. Says what it did.
Result<Diagnostics> recover_take(const std::filesystem::path& folder);

}  // namespace limbwave::take
