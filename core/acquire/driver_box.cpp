#include "acquire/driver_box.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <libserialport.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

namespace limbwave::acquire {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kReadTimeout = 20;    // milliseconds
constexpr int kWriteTimeout = 500;  // milliseconds
constexpr auto kReopenPause = milliseconds(100);
constexpr auto kLateBlock = milliseconds(60);  // how long a missing block may still come
constexpr auto kAskAgain = milliseconds(500);

double seconds_since(Clock::time_point time) {
  return std::chrono::duration<double>(Clock::now() - time).count();
}

// One opened port; closed when it goes.
class Line {
 public:
  static Result<std::unique_ptr<Line>> open(const std::string& name) {
    // A link that udev or an emulator keeps is followed, since the library knows ports by their own names alone.
    std::error_code code;
    const std::filesystem::path real = std::filesystem::canonical(name, code);
    const std::string path = code ? name : real.string();
    std::unique_ptr<Line> line(new Line);
    // libserialport asks for modem lines, which a pseudo-terminal does not have.
    if (path.starts_with("/dev/pts/")) {
      return line->open_terminal(path) ? Result(std::move(line)) : cannot_open(name);
    }
    if (sp_get_port_by_name(path.c_str(), &line->port_) != SP_OK) {
      return Error{"is no serial port", name, "check the cable, and the port's name"};
    }
    if (sp_open(line->port_, SP_MODE_READ_WRITE) != SP_OK) {
      return cannot_open(name);
    }
    line->port_open_ = true;
    sp_set_baudrate(line->port_, 115200);
    sp_set_bits(line->port_, 8);
    sp_set_parity(line->port_, SP_PARITY_NONE);
    sp_set_stopbits(line->port_, 1);
    sp_set_flowcontrol(line->port_, SP_FLOWCONTROL_NONE);
    return line;
  }
  ~Line() {
    if (port_open_) {
      sp_close(port_);
    }
    if (port_ != nullptr) {
      sp_free_port(port_);
    }
    if (terminal_ >= 0) {
      ::close(terminal_);
    }
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  // Bytes read, 0 when none came, below 0 when the line is gone.
  int read(std::vector<std::byte>& buffer) {
    if (terminal_ < 0) {
      return static_cast<int>(sp_blocking_read_next(port_, buffer.data(), buffer.size(), kReadTimeout));
    }
    pollfd wait{terminal_, POLLIN, 0};
    if (::poll(&wait, 1, kReadTimeout) <= 0) {
      return 0;
    }
    const ssize_t got = ::read(terminal_, buffer.data(), buffer.size());
    // Readable and nothing there: the other end was closed.
    return got > 0 ? static_cast<int>(got) : (got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1);
  }

  bool write(const std::vector<std::byte>& bytes) {
    if (terminal_ < 0) {
      const auto put = static_cast<int>(sp_blocking_write(port_, bytes.data(), bytes.size(), kWriteTimeout));
      return put == static_cast<int>(bytes.size());
    }
    for (std::size_t done = 0; done < bytes.size();) {
      pollfd wait{terminal_, POLLOUT, 0};
      const ssize_t put =
          ::poll(&wait, 1, kWriteTimeout) > 0 ? ::write(terminal_, bytes.data() + done, bytes.size() - done) : -1;
      if (put <= 0) {
        return false;
      }
      done += static_cast<std::size_t>(put);
    }
    return true;
  }

 private:
  Line() = default;
  static Error cannot_open(const std::string& name) {
    return {"cannot be opened", name, "check the cable, and that you may use serial ports (group dialout)"};
  }
  bool open_terminal(const std::string& path) {
    terminal_ = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    termios raw{};
    if (terminal_ < 0 || ::tcgetattr(terminal_, &raw) != 0) {
      return false;
    }
    ::cfmakeraw(&raw);
    raw.c_cflag |= CS8 | CREAD | CLOCAL;
    return ::tcsetattr(terminal_, TCSANOW, &raw) == 0;
  }

  sp_port* port_ = nullptr;
  bool port_open_ = false;
  int terminal_ = -1;
};

}  // namespace

struct DriverBox::Impl {
  std::string port;
  DriverBoxSettings settings;
  BoxHello hello;
  std::unique_ptr<Line> line;
  PacketParser parser;
  std::unique_ptr<BlockSequencer> sequencer;
  std::uint16_t sequence = 0;
  std::thread thread;
  std::atomic<bool> stopping{false}, is_connected{false};

  std::mutex mutex;  // of everything below
  std::condition_variable arrived;
  Part ready;
  BoxCounters shared_counters;
  BoxStatus last_status;

  // The reader's own.
  std::vector<std::byte> buffer = std::vector<std::byte>(65536);
  Clock::time_point last_block, held_since, lost_at;
  bool stalled = false;
  std::uint64_t reconnects = 0, stalls = 0;

  bool send(PacketKind kind) { return line && line->write(write_packet(kind, sequence++, {})); }

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
      const int got = line->read(buffer);
      if (got < 0) {
        return std::nullopt;
      }
      parser.push(std::span(buffer).first(static_cast<std::size_t>(got)));
      while (auto packet = parser.next()) {
        if (packet->kind == PacketKind::kHello) {
          if (auto found = read_hello(packet->body)) {
            return found;
          }
        } else if (packet->kind == PacketKind::kBlock && sequencer) {
          take(*packet);
        }
      }
    }
    return std::nullopt;
  }

  void take(const Packet& packet) {
    auto block = read_block(packet.body);
    if (!block) {
      return;
    }
    last_block = Clock::now();
    if (!sequencer->waiting()) {
      held_since = last_block;
    }
    sequencer->push(*std::move(block));
  }

  void event(const std::string& kind, const std::string& text, std::int64_t count = 0) {
    const std::lock_guard lock(mutex);
    ready.events.push_back({sequencer->position(), kind, text, count});
  }

  // Hands what is in order to the consumer.
  void publish() {
    std::vector<std::int16_t> samples = sequencer->take_samples();
    std::vector<BoxEvent> events = sequencer->take_events();
    const std::lock_guard lock(mutex);
    shared_counters = sequencer->counters();
    shared_counters.bad_packets = parser.bad_packets();
    shared_counters.skipped_bytes = parser.skipped_bytes();
    shared_counters.reconnects = reconnects;
    shared_counters.stalls = stalls;
    ready.events.insert(ready.events.end(), events.begin(), events.end());
    ready.samples.insert(ready.samples.end(), samples.begin(), samples.end());
    if (!samples.empty() || !events.empty()) {
      arrived.notify_one();
    }
  }

  void reconnect() {
    line.reset();
    parser.reset();
    is_connected = false;
    lost_at = Clock::now();
    event("line-lost", "the driver box does not answer any more; waiting for it");
    publish();
    while (!stopping) {
      std::this_thread::sleep_for(kReopenPause);
      auto opened = Line::open(port);
      if (!opened) {
        continue;
      }
      line = *std::move(opened);
      const auto found = ask(2.0);
      if (!found || found->wires != hello.wires || found->rate_hz != hello.rate_hz) {
        line.reset();
        parser.reset();
        continue;
      }
      const bool same = found->session == hello.session && found->serial == hello.serial;
      if (same) {
        send(PacketKind::kContinue);
      } else {
        // It was off: how long is known by our own clock alone. Slots keep their places.
        const std::int64_t round =
            std::max<std::int64_t>(1, std::int64_t{hello.slot_samples} * std::max(1, hello.sources));
        const auto passed = static_cast<std::int64_t>(seconds_since(last_block) * hello.rate_hz);
        const std::int64_t at = (sequencer->position().value + passed + round - 1) / round * round;
        sequencer->restart(SampleIndex{at});
        event("box-restarted",
              "the driver box was switched on again; the length of the gap is by the computer's clock");
        hello = *found;
        send(PacketKind::kStart);
      }
      ++reconnects;
      is_connected = true;
      last_block = Clock::now();
      stalled = false;
      event("line-back", fmt::format("the driver box is back after {:.1f} s", seconds_since(lost_at)));
      return;
    }
  }

  void run() {
    last_block = Clock::now();
    auto asked = Clock::now();
    while (!stopping) {
      const int got = line ? line->read(buffer) : -1;
      if (got < 0) {
        reconnect();
        continue;
      }
      parser.push(std::span(buffer).first(static_cast<std::size_t>(got)));
      while (auto packet = parser.next()) {
        if (packet->kind == PacketKind::kBlock) {
          if (stalled) {
            stalled = false;
            event("stall-over", fmt::format("samples come again after {:.1f} s", seconds_since(last_block)));
          }
          take(*packet);
        } else if (packet->kind == PacketKind::kStatus) {
          if (const auto status = read_status(packet->body)) {
            const std::lock_guard lock(mutex);
            last_status = *status;
          }
        }
      }
      if (sequencer->waiting() && Clock::now() - held_since > kLateBlock) {
        sequencer->give_up();
      }
      if (!stalled && seconds_since(last_block) > settings.stall_s) {
        stalled = true;
        ++stalls;
        event("stall", "no samples come from the driver box");
      }
      // A box that was plugged out and in unnoticed waits to be told.
      if (stalled && Clock::now() - asked > milliseconds(1000)) {
        asked = Clock::now();
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
  auto line = Line::open(port);
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
  impl->is_connected = true;
  return std::unique_ptr<DriverBox>(new DriverBox(std::move(impl)));
}

const BoxHello& DriverBox::hello() const {
  return impl_->hello;
}

StreamFormat DriverBox::format() const {
  return {SampleRate{static_cast<double>(impl_->hello.rate_hz)}, impl_->hello.wires, SampleType::kInt16};
}

Status DriverBox::start() {
  if (impl_->thread.joinable()) {
    return {};
  }
  if (!impl_->send(PacketKind::kStart)) {
    return Error{"cannot be written to", impl_->port, "check the cable"};
  }
  impl_->stopping = false;
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
  return {};
}

void DriverBox::stop() {
  impl_->stopping = true;
  if (impl_->thread.joinable()) {
    impl_->thread.join();
    impl_->send(PacketKind::kStop);
    impl_->sequencer->give_up();
    impl_->publish();
  }
}

DriverBox::Part DriverBox::pull(double timeout_s) {
  std::unique_lock lock(impl_->mutex);
  impl_->arrived.wait_for(lock, std::chrono::duration<double>(timeout_s),
                          [&] { return !impl_->ready.samples.empty() || !impl_->ready.events.empty(); });
  Part part;
  std::swap(part, impl_->ready);
  return part;
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
