/// Writes a take while it happens, so that killing the program at any instant leaves a take that opens.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "base/result.h"
#include "take/take.h"

namespace limbwave::take {

struct RecorderSettings {
  /// Recording stops by itself while this much is still free, so that everything can be closed properly; bytes.
  std::uint64_t keep_free_bytes = std::uint64_t{64} << 20;
  /// Free bytes of the disk that holds a folder; empty: asks the operating system.
  std::function<std::uint64_t(const std::filesystem::path&)> free_bytes;
  /// True for work that makes a take in one go (import, simulation): the folder appears under its name only when
  /// `close` succeeds, and nothing is left otherwise. False for recording: it is there from the start.
  bool publish_at_close = false;
  /// While recording, what was written is put onto the disk itself at most this often.
  std::chrono::milliseconds sync_interval{1000};
};

/// One recording. Not thread-safe: one thread writes. Raw samples go to the operating system with every `write`, the
/// header of signal.wav is brought up to date at least four times a second while samples come, events at once. A thread
/// of the recorder's own puts all that onto the disk once a second, so that a loss of power costs little more.
class Recorder {
 public:
  /// Makes the folder (its parents too) with take.json, an empty signal.wav and events.jsonl, all of it or nothing.
  /// `info` gives everything but `created` (set when empty), `complete` and `frames`. Fails when the folder exists or
  /// cannot be made, or the disk is nearly full.
  static Result<std::unique_ptr<Recorder>> create(const std::filesystem::path& folder, TakeInfo info,
                                                  RecorderSettings settings = {});

  /// Closes a recording properly when that was not done; discards one that is published at close.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Appends whole interleaved frames as they came. After a failure (disk full, write error) everything before it is
  /// safe, `close` still works, and further writes return the same error.
  Status write(std::span<const std::byte> frames);

  /// Appends to events.jsonl at once.
  Status add_event(const TakeEvent& event);
  /// Names a stretch; into take.json at once (with `publish_at_close`, when closing).
  Status add_segment(const TakeSegment& segment);
  /// Replaces the snapshot of the calibration; into take.json as above.
  Status set_calibration(const calibrate::RigCalibration& calibration);

  [[nodiscard]] std::int64_t frames() const;
  [[nodiscard]] double seconds() const;  ///< Recorded so far.
  /// How long the disk lasts at this rate until recording stops by itself, seconds; looked up once a second.
  [[nodiscard]] double disk_left_s() const;
  /// Why `write` refuses; empty as long as it does not.
  [[nodiscard]] const std::optional<Error>& stopped() const;
  [[nodiscard]] const TakeInfo& info() const;
  /// Where the files are now: the take's folder, or a hidden one beside it until a `publish_at_close` take is closed.
  /// Further files of the take (truth.json) may be put there.
  [[nodiscard]] const std::filesystem::path& working_folder() const;

  /// Ends the recording: exact header, complete = true, all on disk. The take as `open_take` gives it.
  Result<Take> close();
  /// Removes everything that was written.
  void discard();

 private:
  struct Impl;
  explicit Recorder(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::take
