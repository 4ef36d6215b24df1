/// A driver box on a serial line: samples without a shift, whatever the line does to them.
#pragma once

#include <cstdint>
#include <memory>
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

/// Puts blocks in order: waits a little for one that is missing, drops those that come twice, fills what is lost with
/// zeros and says so. Every gap is one event of kind "dropped" with its length. Does no input or output itself.
class BlockSequencer {
 public:
  explicit BlockSequencer(int wires) : wires_(wires) {}

  void push(BoxBlock block);
  /// What waits for a missing block is let go: the missing one is lost.
  void give_up();
  /// The box counts anew; its sample 0 is sample `at` of the stream, which is filled up to there.
  void restart(SampleIndex at);

  /// Samples in order since the last call, interleaved.
  std::vector<std::int16_t> take_samples();
  std::vector<BoxEvent> take_events();
  [[nodiscard]] SampleIndex position() const { return {next_}; }  ///< Of the next sample.
  [[nodiscard]] const BoxCounters& counters() const { return counters_; }
  [[nodiscard]] bool waiting() const { return !held_.empty(); }

 private:
  void accept(const BoxBlock& block);
  void fill(std::int64_t until);
  void release();

  int wires_;
  std::int64_t offset_ = 0;  // of the box's count in the stream
  std::int64_t next_ = 0;
  bool started_ = false;
  std::uint64_t connected_ = 0;
  std::vector<BoxBlock> held_;  // by first sample
  std::vector<std::int16_t> samples_;
  std::vector<BoxEvent> events_;
  BoxCounters counters_;
};

struct DriverBoxSettings {
  double patience_s = 10.0;  ///< How long opening waits for a hello.
  double stall_s = 0.5;      ///< Silence that counts as a stall.
};

/// A running box. A thread of its own reads the line, opens it again when it was lost, and continues.
class DriverBox {
 public:
  /// Opens the port, asks who is there. Fails when the port cannot be opened or nobody answers.
  static Result<std::unique_ptr<DriverBox>> open(const std::string& port, const DriverBoxSettings& settings = {});
  ~DriverBox();
  DriverBox(const DriverBox&) = delete;
  DriverBox& operator=(const DriverBox&) = delete;

  [[nodiscard]] const BoxHello& hello() const;
  [[nodiscard]] StreamFormat format() const;
  Status start();
  void stop();

  struct Part {
    std::vector<std::int16_t> samples;  ///< Interleaved.
    std::vector<BoxEvent> events;       ///< Whose samples are up to the end of `samples`.
  };
  /// What has arrived since the last call; waits up to `timeout_s` for something.
  Part pull(double timeout_s);
  [[nodiscard]] BoxCounters counters() const;
  [[nodiscard]] BoxStatus status() const;
  [[nodiscard]] bool connected() const;

 private:
  struct Impl;
  explicit DriverBox(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::acquire
