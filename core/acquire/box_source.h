/// Where the samples of a driver box come from: its own serial line, or a sound card of many channels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "acquire/driver_box_protocol.h"
#include "acquire/sample_format.h"
#include "base/result.h"
#include "base/time.h"

namespace limbwave::acquire {

/// Something that happened to the stream of samples. `count` is in samples where it has a meaning.
struct BoxEvent {
  SampleIndex sample;
  std::string kind;  ///< "dropped", "wire-pulled", "wire-back", "stall", "line-lost", "line-back", "box-restarted", ...
  std::string text;
  std::int64_t count = 0;
};

struct BoxCounters {
  std::uint64_t blocks = 0, lost_frames = 0, gaps = 0, duplicates = 0, reordered = 0, bad_packets = 0;
  std::uint64_t skipped_bytes = 0, reconnects = 0, stalls = 0;
  bool operator==(const BoxCounters&) const = default;
};

/// A stretch of the stream: frames that were lost, then frames that came. What was lost is not spelled out as zeros, so
/// that a line that was away for an hour costs no memory.
struct BoxPiece {
  std::int64_t lost = 0;
  std::vector<std::byte> bytes;  ///< Whole frames in the source's format, interleaved.
};

/// What has arrived.
struct BoxPart {
  std::vector<BoxPiece> pieces;
  std::vector<BoxEvent> events;  ///< Whose samples are up to the end of `pieces`.
};

/// A running box: samples with an index that never shifts, whatever happens to the line. One consumer thread.
class BoxSource {
 public:
  virtual ~BoxSource() = default;
  [[nodiscard]] virtual BoxHello hello() const = 0;
  [[nodiscard]] virtual StreamFormat format() const = 0;
  /// For people: "driver box 3e9, emulator 1.0".
  [[nodiscard]] virtual std::string title() const = 0;
  /// Which source fires in which slot; kSilentSlot is silence. Before `start`. Fails when the box refuses it.
  virtual Status set_schedule(const std::vector<std::uint8_t>& schedule) = 0;
  virtual Status start() = 0;
  virtual void stop() = 0;
  /// What has arrived since the last call; waits up to `timeout_s` for something.
  virtual BoxPart pull(double timeout_s) = 0;
  [[nodiscard]] virtual BoxCounters counters() const = 0;
  [[nodiscard]] virtual BoxStatus status() const = 0;  ///< `sample` is 0 where there never was one.
  [[nodiscard]] virtual bool connected() const = 0;
};

}  // namespace limbwave::acquire
