#include "acquire/driver_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "acquire/block_sequencer.h"
#include "acquire/box_backlog.h"
#include "acquire/serial_line.h"

namespace limbwave::acquire {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr auto kReopenPause = milliseconds(100);
constexpr auto kLateBlock = milliseconds(60);  // how long a missing block may still come
constexpr auto kAskAgain = milliseconds(500);
constexpr auto kNudge = milliseconds(1000);  // how often a silent box is told to go on
constexpr double kAnswerPatience = 10.0;     // seconds
constexpr double kAhead = 10.0;              // seconds by which a block may be ahead of our clock

double seconds_since(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

}  // namespace

struct DriverBox::Impl {
  std::string port;
  DriverBoxSettings settings;
  std::unique_ptr<SerialLine> line;
  PacketParser parser;
  std::unique_ptr<BlockSequencer> sequencer;
  std::vector<std::uint8_t> schedule;
  std::uint16_t sequence = 0;
  std::thread thread;
  std::atomic<bool> stopping{false}, is_connected{false};

  std::unique_ptr<BoxBacklog> backlog;  // for the consumer

  mutable std::mutex mutex;  // of everything below
  BoxHello hello;
  BoxCounters shared_counters;
  BoxStatus last_status;

  // The reader's own.
  std::vector<std::byte> buffer = std::vector<std::byte>(65536);
  Clock::time_point last_block, held_since, lost_at, nudged;
  std::uint16_t nudge = 0;  // sequence number of the last *continue*
  bool idle = false;        // nothing came at the last look
  bool running = false;     // blocks that come belong to this run
  bool stalled = false;
  std::uint64_t reconnects = 0, stalls = 0, impossible = 0;

  [[nodiscard]] BoxHello known() const {
    const std::lock_guard lock(mutex);
    return hello;
  }

  bool send(PacketKind kind, std::span<const std::byte> body = {}) {
    return line && line->write(write_packet(kind, sequence++, body));
  }

  // Bytes that have come, to the parser; false when the line is gone.
  bool listen() {
    const int got = line ? line->read(buffer) : -1;
    idle = got == 0;
    if (got > 0) {
      parser.push(std::span(buffer).first(static_cast<std::size_t>(got)));
    }
    return got >= 0;
  }

  // Who is there; waits for at most so long.
  std::optional<BoxHello> ask(double patience_s) {
    const auto begin = Clock::now();
    auto asked = begin - kAskAgain;
    while (seconds_since(begin) < patience_s && !stopping) {
      if (Clock::now() - asked >= kAskAgain) {
        asked = Clock::now();
        if (!send(PacketKind::kIdentify)) {
          return std::nullopt;
        }
      }
      if (!listen()) {
        return std::nullopt;
      }
      while (auto packet = parser.next()) {
        if (packet->kind == PacketKind::kHello) {
          if (auto found = read_hello(packet->body)) {
            return found;
          }
        } else if (packet->kind == PacketKind::kBlock) {
          take(*packet);
        }
      }
    }
    return std::nullopt;
  }

  // Gives a command until it is answered: done or refused; empty when the line is gone or nobody answers.
  std::optional<bool> command(PacketKind kind, std::span<const std::byte> body = {}) {
    const auto begin = Clock::now();
    auto asked = begin - kAskAgain;
    std::uint16_t number = 0;
    while (seconds_since(begin) < kAnswerPatience && !stopping) {
      if (Clock::now() - asked >= kAskAgain) {
        asked = Clock::now();
        number = sequence;
        if (!send(kind, body)) {
          return std::nullopt;
        }
      }
      if (!listen()) {
        return std::nullopt;
      }
      while (auto packet = parser.next()) {
        if (packet->kind == PacketKind::kBlock) {
          take(*packet);
        }
        // Only the newest asking counts: an older *start* was undone by it.
        const auto answer = packet->kind == PacketKind::kAnswer ? read_answer(packet->body) : std::nullopt;
        if (answer && answer->command == number) {
          return answer->done;
        }
      }
    }
    return std::nullopt;
  }

  // Starts the box from sample 0. What it sent before its answer belongs to an earlier run.
  std::optional<bool> begin() {
    running = false;
    if (!schedule.empty()) {
      const auto told =
          command(PacketKind::kStop) ? command(PacketKind::kSchedule, schedule_body(schedule)) : std::optional<bool>();
      if (!told.value_or(false)) {
        return told;
      }
    }
    const auto started = command(PacketKind::kStart);
    running = started.value_or(false);
    last_block = Clock::now();
    return started;
  }

  void take(const Packet& packet) {
    auto block = running ? read_block(packet.body) : std::nullopt;
    if (!block) {
      return;
    }
    // What no box could have sampled meanwhile is not believed: its gap would fill the disk.
    const double ahead = static_cast<double>(sequencer->place(*block) - sequencer->position().value);
    if (ahead > (1.1 * seconds_since(last_block) + kAhead) * static_cast<double>(known().rate_hz)) {
      ++impossible;
      return;
    }
    last_block = Clock::now();
    if (!sequencer->waiting()) {
      held_since = last_block;
    }
    sequencer->push(*std::move(block));
  }

  void event(const std::string& kind, const std::string& text, std::int64_t count = 0) {
    backlog->push({{}, {{sequencer->position(), kind, text, count}}});
  }

  // Hands what is in order to the consumer.
  void publish(bool last = false) {
    std::vector<BoxPiece> pieces = sequencer->take_pieces();
    backlog->push({std::move(pieces), sequencer->take_events()}, last);
    BoxCounters counters = sequencer->counters();
    counters.bad_packets = parser.bad_packets() + impossible;
    counters.skipped_bytes = parser.skipped_bytes();
    counters.reconnects = reconnects;
    counters.stalls = stalls;
    backlog->add_to(counters);
    const std::lock_guard lock(mutex);
    shared_counters = counters;
  }

  // The box was off or has forgotten its run: how long is known by our own clock alone. Slots keep their places.
  bool begin_anew(const BoxHello& found) {
    const std::int64_t round =
        std::max<std::int64_t>(1, std::int64_t{found.slot_samples} *
                                      static_cast<std::int64_t>(schedule.empty() ? std::max(1, found.sources)
                                                                                 : static_cast<int>(schedule.size())));
    const auto since = last_block;
    if (!begin().value_or(false)) {
      return false;
    }
    const auto passed = static_cast<std::int64_t>(seconds_since(since) * static_cast<double>(found.rate_hz));
    sequencer->restart(SampleIndex{(sequencer->position().value + passed + round - 1) / round * round});
    event("box-restarted", "the driver box was switched on again; the length of the gap is by the computer's clock");
    const std::lock_guard lock(mutex);
    hello = found;
    return true;
  }

  void reconnect() {
    line.reset();
    parser.reset();
    is_connected = false;
    lost_at = Clock::now();
    event("line-lost", "the driver box does not answer any more; waiting for it");
    publish();
    const BoxHello before = known();
    while (!stopping) {
      std::this_thread::sleep_for(kReopenPause);
      auto opened = SerialLine::open(port);
      if (!opened) {
        continue;
      }
      line = *std::move(opened);
      const auto found = ask(2.0);
      const bool fits = found && found->wires == before.wires && found->rate_hz == before.rate_hz;
      const bool same = fits && found->session == before.session && found->serial == before.serial;
      // A box that still counts is not made to begin anew: without an answer it is asked again.
      const auto goes_on = same ? command(PacketKind::kContinue) : std::optional<bool>(false);
      if (!fits || !goes_on || (!*goes_on && !begin_anew(*found))) {
        line.reset();
        parser.reset();
        continue;
      }
      ++reconnects;
      is_connected = true;
      last_block = Clock::now();
      stalled = false;
      event("line-back", fmt::format("the driver box is back after {:.1f} s", seconds_since(lost_at)));
      return;
    }
  }

  void hear(const Packet& packet) {
    if (packet.kind == PacketKind::kBlock) {
      if (stalled) {
        stalled = false;
        event("stall-over", fmt::format("samples come again after {:.1f} s", seconds_since(last_block)));
      }
      take(packet);
    } else if (packet.kind == PacketKind::kStatus) {
      if (const auto status = read_status(packet.body)) {
        const std::lock_guard lock(mutex);
        last_status = *status;
      }
    } else if (packet.kind == PacketKind::kAnswer && stalled) {
      const auto answer = read_answer(packet.body);
      if (answer && answer->command == nudge && !answer->done) {
        (void)begin_anew(known());
      }
    }
  }

  void run() {
    last_block = nudged = Clock::now();
    while (!stopping) {
      if (!listen()) {
        reconnect();
        continue;
      }
      while (auto packet = parser.next()) {
        hear(*packet);
      }
      // As long as more is coming, the number of blocks that are held decides: this thread may have been late itself.
      if (sequencer->waiting() && idle && Clock::now() - held_since > kLateBlock) {
        sequencer->give_up();
      }
      if (!stalled && seconds_since(last_block) > settings.stall_s) {
        stalled = true;
        ++stalls;
        event("stall", "no samples come from the driver box");
      }
      // A box that was plugged out and in unnoticed waits to be told.
      if (stalled && Clock::now() - nudged > kNudge) {
        nudged = Clock::now();
        nudge = sequence;
        send(PacketKind::kContinue);
      }
      publish();
    }
  }
};

DriverBox::DriverBox(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

DriverBox::~DriverBox() {
  stop();
}

Result<std::unique_ptr<DriverBox>> DriverBox::open(const std::string& port, const DriverBoxSettings& settings) {
  auto impl = std::make_unique<Impl>();
  impl->port = port;
  impl->settings = settings;
  auto line = SerialLine::open(port);
  if (!line) {
    return line.error();
  }
  impl->line = *std::move(line);
  const auto hello = impl->ask(settings.patience_s);
  if (!hello) {
    return Error{"does not answer as a driver box does", port, "check that it is the box's port, and that it is on"};
  }
  impl->hello = *hello;
  impl->sequencer = std::make_unique<BlockSequencer>(hello->wires);
  const std::size_t frame = 2 * static_cast<std::size_t>(hello->wires);
  impl->backlog = std::make_unique<BoxBacklog>(
      static_cast<std::size_t>(settings.backlog_s * static_cast<double>(hello->rate_hz)) * frame, frame);
  impl->is_connected = true;
  return std::unique_ptr<DriverBox>(new DriverBox(std::move(impl)));
}

BoxHello DriverBox::hello() const {
  return impl_->known();
}

StreamFormat DriverBox::format() const {
  const BoxHello hello = impl_->known();
  return {SampleRate{static_cast<double>(hello.rate_hz)}, hello.wires, SampleType::kInt16};
}

std::string DriverBox::title() const {
  const BoxHello hello = impl_->known();
  return fmt::format("driver box {:x}, {}", hello.serial, hello.firmware);
}

Status DriverBox::set_schedule(const std::vector<std::uint8_t>& schedule) {
  if (impl_->thread.joinable()) {
    return Error{"is running", impl_->port, "stop it before its schedule is changed"};
  }
  impl_->schedule = schedule;
  impl_->stopping = false;
  // A box that was left running by somebody else does not take it.
  const bool told = impl_->command(PacketKind::kStop).has_value() &&
                    impl_->command(PacketKind::kSchedule, schedule_body(schedule)).value_or(false);
  if (!told) {
    return Error{"refuses the order in which sources are to fire", impl_->port,
                 "check that the rig belongs to this box"};
  }
  const std::lock_guard lock(impl_->mutex);
  impl_->hello.schedule = schedule;
  return {};
}

Status DriverBox::start() {
  if (impl_->thread.joinable()) {
    return {};
  }
  impl_->stopping = false;
  if (!impl_->begin().value_or(false)) {
    return Error{"does not start", impl_->port, "check the cable, and switch the box off and on"};
  }
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
  return {};
}

void DriverBox::stop() {
  impl_->stopping = true;
  if (impl_->thread.joinable()) {
    impl_->thread.join();
    impl_->send(PacketKind::kStop);
    impl_->sequencer->give_up();
    impl_->publish(true);
  }
}

BoxPart DriverBox::pull(double timeout_s) {
  return impl_->backlog->pull(timeout_s);
}

BoxCounters DriverBox::counters() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->shared_counters;
}

BoxStatus DriverBox::status() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->last_status;
}

bool DriverBox::connected() const {
  return impl_->is_connected;
}

}  // namespace limbwave::acquire
