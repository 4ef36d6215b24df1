/// Blocks of a driver box, put in order.
#pragma once

#include <cstdint>
#include <vector>

#include "acquire/box_source.h"

namespace limbwave::acquire {

/// Waits a little for a block that is missing, drops those that come twice, and tells what is lost. Every gap is one
/// event of kind "dropped" with its length. Does no input or output itself.
class BlockSequencer {
 public:
  explicit BlockSequencer(int wires) : wires_(wires) {}

  void push(BoxBlock block);
  /// What waits for a missing block is let go: the missing one is lost.
  void give_up();
  /// The box counts anew; its sample 0 is sample `at` of the stream, which is lost up to there.
  void restart(SampleIndex at);

  /// What is in order since the last call: int16 samples.
  std::vector<BoxPiece> take_pieces();
  std::vector<BoxEvent> take_events();
  [[nodiscard]] SampleIndex position() const { return {next_}; }  ///< Of the next sample.
  /// Of a block in the stream.
  [[nodiscard]] std::int64_t place(const BoxBlock& block) const { return block.first + offset_; }
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
  std::vector<BoxPiece> pieces_;
  std::vector<BoxEvent> events_;
  BoxCounters counters_;
};

}  // namespace limbwave::acquire
