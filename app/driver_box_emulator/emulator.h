/// The driver box in software: answers commands and sends blocks in real time over a pseudo-terminal.
#pragma once

#include <cstdint>
#include <cstdio>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "acquire/driver_box_protocol.h"
#include "base/result.h"
#include "faults.h"

namespace limbwave::emulator {

/// Fills `frames` · wires interleaved samples with what comes next; begins anew when `from_start`.
using Samples = std::function<void(std::vector<std::int16_t>& out, int frames, bool from_start)>;
/// Which source fires in which slot, from the next start on; false where that cannot be.
using Schedule = std::function<bool(const std::vector<std::uint8_t>& schedule)>;

struct EmulatorSettings {
  std::string link;  ///< A symbolic link that always leads to the present terminal; empty: none.
  std::string log;   ///< A file that tells every fault, one JSON object a line; empty: none.
  int block_frames = 280;
  double speed = 1.0;              ///< Times real time.
  double seconds = 0.0;            ///< Ends after so long; 0: never.
  double faults_every_s = 0.0;     ///< Mean time between faults of its own; 0: none.
  std::vector<TimedFault> faults;  ///< In order of time.
  std::uint64_t seed = 1;
};

class Emulator {
 public:
  Emulator(acquire::BoxHello hello, EmulatorSettings settings, Samples samples, Schedule schedule);
  ~Emulator();
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  /// Opens the terminal. Its path is then `path()`.
  Status open();
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Runs until `stop()` answers true, the time is over, or the terminal cannot be opened again. Lines of commands
  /// (see `command`) are read from `input`, a file descriptor; below 0: none.
  Status run(const std::function<bool()>& stop, int input);

  /// A fault, as `fault_help` lists them. False when it is none.
  bool command(const std::string& line);

 private:
  void hear();
  void answer(const acquire::Packet& packet);
  void send(acquire::PacketKind kind, const std::vector<std::byte>& body);
  void begin();
  void obey(const std::string& line);
  void read_lines(int& input);
  void make_block();
  void flush();
  void own_faults(double now);
  void log(const std::string& kind, std::int64_t first, std::int64_t frames);
  void close();

  acquire::BoxHello hello_;
  EmulatorSettings settings_;
  Samples samples_;
  Schedule schedule_;
  std::string path_;
  int master_ = -1, slave_ = -1;
  std::FILE* log_ = nullptr;
  acquire::PacketParser parser_;
  std::uint16_t sequence_ = 0;
  bool running_ = false, from_start_ = true;
  std::int64_t frame_ = 0;  // of the next block
  double started_s_ = 0.0;  // when frame 0 was due
  std::uint64_t connected_ = ~std::uint64_t{0};
  struct Waiting {
    std::vector<std::byte> packet;
    std::int64_t first = -1;  // of a block
  };
  std::deque<Waiting> waiting_;  // for the line
  std::size_t written_ = 0;      // of the first one
  std::uint32_t overruns_ = 0;
  int lose_ = 0, corrupt_ = 0;
  bool duplicate_ = false, reorder_ = false;
  Waiting held_back_;
  double stalled_until_s_ = -1.0, unplugged_until_s_ = -1.0;
  double next_status_s_ = 0.0;
  double first_start_s_ = -1.0;
  FaultPlan faults_;
  std::string input_line_;
};

}  // namespace limbwave::emulator
