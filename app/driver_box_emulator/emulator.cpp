#include "emulator.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pty.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <set>
#include <sstream>
#include <thread>

namespace limbwave::emulator {
namespace {

using acquire::PacketKind;

constexpr double kMemory = 1.0;       // seconds of blocks that the box keeps when the line does not take them
constexpr std::int64_t kKernel = 32;  // blocks that the terminal itself may hold

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Emulator::Emulator(acquire::BoxHello hello, EmulatorSettings settings, Samples samples, Schedule schedule)
    : hello_(std::move(hello)),
      settings_(std::move(settings)),
      samples_(std::move(samples)),
      schedule_(std::move(schedule)),
      faults_(settings_.faults, settings_.faults_every_s, hello_.wires, settings_.seed) {}

Emulator::~Emulator() {
  close();
  if (log_ != nullptr) {
    std::fclose(log_);
  }
  if (!settings_.link.empty()) {
    ::unlink(settings_.link.c_str());
  }
}

Status Emulator::open() {
  char name[256] = {};
  termios raw{};
  ::cfmakeraw(&raw);
  raw.c_cflag |= CS8 | CREAD | CLOCAL;
  if (::openpty(&master_, &slave_, name, &raw, nullptr) != 0) {
    return Error{fmt::format("cannot be opened ({})", std::strerror(errno)), "pseudo-terminal", "free some terminals"};
  }
  ::fcntl(master_, F_SETFL, O_NONBLOCK);
  ::fcntl(master_, F_SETFD, FD_CLOEXEC);
  ::fcntl(slave_, F_SETFD, FD_CLOEXEC);
  path_ = name;
  if (!settings_.link.empty()) {
    // Renamed over the old link, so that there is always one.
    const std::string fresh = settings_.link + ".new";
    ::unlink(fresh.c_str());
    if (::symlink(name, fresh.c_str()) != 0 || ::rename(fresh.c_str(), settings_.link.c_str()) != 0) {
      return Error{fmt::format("cannot be made ({})", std::strerror(errno)), settings_.link, "choose another place"};
    }
  }
  if (log_ == nullptr && !settings_.log.empty()) {
    log_ = std::fopen(settings_.log.c_str(), "w");
    if (log_ == nullptr) {
      return Error{fmt::format("cannot be written ({})", std::strerror(errno)), settings_.log, "choose another place"};
    }
  }
  parser_.reset();
  send(PacketKind::kHello, acquire::hello_body(hello_));
  return {};
}

void Emulator::close() {
  // What was not sent, and what the terminal may still have held, may not have arrived.
  std::int64_t unsent = frame_;
  for (const Waiting& waiting : waiting_) {
    unsent = waiting.first >= 0 ? std::min(unsent, waiting.first) : unsent;
  }
  if (running_ && master_ >= 0) {
    unsent = std::max<std::int64_t>(0, unsent - kKernel * settings_.block_frames);
    log("unsent", unsent, frame_ - unsent);
  }
  for (int* descriptor : {&master_, &slave_}) {
    if (*descriptor >= 0) {
      ::close(*descriptor);
      *descriptor = -1;
    }
  }
  waiting_.clear();
  held_back_ = {};
  written_ = 0;
}

void Emulator::log(const std::string& kind, std::int64_t first, std::int64_t frames) {
  if (log_ != nullptr) {
    std::fputs(fmt::format("{{\"fault\":\"{}\",\"first\":{},\"frames\":{}}}\n", kind, first, frames).c_str(), log_);
    std::fflush(log_);
  }
}

void Emulator::send(PacketKind kind, const std::vector<std::byte>& body) {
  if (master_ >= 0) {
    waiting_.push_back({acquire::write_packet(kind, sequence_++, body), -1});
  }
}

void Emulator::begin() {
  // Blocks of an earlier run are forgotten, but for one that is half on the line.
  const std::size_t keep = written_ > 0 ? 1 : 0;
  for (std::size_t i = waiting_.size(); i-- > keep;) {
    if (waiting_[i].first >= 0) {
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  held_back_ = {};
  running_ = true;
  from_start_ = true;
  frame_ = 0;
  overruns_ = 0;
  started_s_ = now_s();
  next_status_s_ = started_s_;
  first_start_s_ = first_start_s_ < 0.0 ? started_s_ : first_start_s_;
}

void Emulator::answer(const acquire::Packet& packet) {
  bool done = true;
  switch (packet.kind) {
    case PacketKind::kIdentify:
      send(PacketKind::kHello, acquire::hello_body(hello_));
      return;
    case PacketKind::kStart:
      begin();
      break;
    case PacketKind::kStop:
      running_ = false;
      break;
    case PacketKind::kSchedule: {
      const auto schedule = acquire::read_schedule(packet.body);
      done = schedule && !running_ &&
             std::all_of(schedule->begin(), schedule->end(),
                         [&](int source) { return source < hello_.sources || source == acquire::kSilentSlot; }) &&
             schedule_(*schedule);
      if (done) {
        hello_.schedule = *schedule;
      }
      break;
    }
    case PacketKind::kContinue:
      done = running_;
      break;
    default:
      done = false;
  }
  send(PacketKind::kAnswer, acquire::answer_body({packet.sequence, done}));
}

void Emulator::hear() {
  std::byte bytes[4096];
  while (master_ >= 0) {
    const ssize_t got = ::read(master_, bytes, sizeof bytes);
    if (got <= 0) {
      break;
    }
    parser_.push({bytes, static_cast<std::size_t>(got)});
  }
  while (auto packet = parser_.next()) {
    answer(*packet);
  }
}

bool Emulator::command(const std::string& line) {
  std::istringstream words(line);
  std::string what;
  double value = 0.0;
  words >> what;
  const bool has_value = static_cast<bool>(words >> value);
  if (what == "lose") {
    lose_ = has_value ? std::max(1, static_cast<int>(value)) : 1;
  } else if (what == "corrupt") {
    corrupt_ = has_value ? std::max(1, static_cast<int>(value)) : 1;
  } else if (what == "duplicate") {
    duplicate_ = true;
  } else if (what == "reorder") {
    reorder_ = true;
  } else if ((what == "pull" || what == "plug") && has_value && value >= 1.0 && value <= hello_.wires) {
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(value - 1.0);
    connected_ = what == "pull" ? connected_ & ~bit : connected_ | bit;
    log(what, frame_, static_cast<std::int64_t>(value));
  } else if (what == "stall" && has_value) {
    stalled_until_s_ = now_s() + value;
    log(what, frame_, 0);
  } else if ((what == "unplug" || what == "reboot") && has_value) {
    log(what, frame_, 0);
    close();
    unplugged_until_s_ = now_s() + value;
    if (what == "reboot") {
      running_ = false;
      ++hello_.session;
      if (!hello_.schedule.empty()) {
        hello_.schedule.clear();
        std::vector<std::uint8_t> own(static_cast<std::size_t>(hello_.sources));
        std::iota(own.begin(), own.end(), std::uint8_t{0});
        (void)schedule_(own);
      }
    }
  } else if (what == "help") {
    std::fputs(fault_help().c_str(), stderr);
  } else {
    return false;
  }
  return true;
}

void Emulator::own_faults(double now) {
  const double since_start = first_start_s_ < 0.0 ? -1.0 : now - first_start_s_;
  for (const std::string& fault : faults_.due(now, since_start, running_, unplugged_until_s_ > 0.0)) {
    obey(fault);
  }
}

void Emulator::obey(const std::string& line) {
  if (!command(line)) {
    std::fputs(fmt::format("limbwave-driver-box-emulator: {}: is no fault; help lists them\n", line).c_str(), stderr);
  }
}

void Emulator::make_block() {
  acquire::BoxBlock block;
  block.first = frame_;
  block.frames = settings_.block_frames;
  block.wires = hello_.wires;
  block.connected = connected_;
  samples_(block.samples, block.frames, from_start_);
  from_start_ = false;
  frame_ += block.frames;
  for (int w = 0; w < block.wires; ++w) {
    if (((connected_ >> static_cast<unsigned>(w)) & 1U) == 0) {
      for (int n = 0; n < block.frames; ++n) {
        block.samples[static_cast<std::size_t>(n) * static_cast<std::size_t>(block.wires) +
                      static_cast<std::size_t>(w)] = 0;
      }
    }
  }
  if (master_ < 0) {
    log("lost", block.first, block.frames);  // the line is unplugged
    return;
  }
  if (lose_ > 0) {
    --lose_;
    log("lost", block.first, block.frames);
    return;
  }
  const double bytes_s = hello_.rate_hz * hello_.wires * 2.0;
  if (static_cast<double>(waiting_.size()) * block.frames * block.wires * 2.0 > kMemory * bytes_s) {
    ++overruns_;
    log("lost", block.first, block.frames);
    return;
  }
  Waiting packet{acquire::write_packet(PacketKind::kBlock, sequence_++, acquire::block_body(block)), block.first};
  if (corrupt_ > 0) {
    --corrupt_;
    std::set<std::size_t> places;
    while (places.size() < 3) {
      places.insert(faults_.random()() % packet.packet.size());
    }
    for (const std::size_t place : places) {
      packet.packet[place] ^= static_cast<std::byte>(1U + faults_.random()() % 255U);
    }
    log("lost", block.first, block.frames);
  }
  if (reorder_ && held_back_.packet.empty()) {
    reorder_ = false;
    log("reorder", block.first, block.frames);
    held_back_ = std::move(packet);
    return;
  }
  if (duplicate_) {
    duplicate_ = false;
    log("duplicate", block.first, block.frames);
    waiting_.push_back(packet);
  }
  waiting_.push_back(std::move(packet));
  if (!held_back_.packet.empty()) {
    waiting_.push_back(std::exchange(held_back_, {}));
  }
}

void Emulator::flush() {
  while (master_ >= 0 && !waiting_.empty()) {
    const std::vector<std::byte>& packet = waiting_.front().packet;
    const ssize_t put = ::write(master_, packet.data() + written_, packet.size() - written_);
    if (put <= 0) {
      return;
    }
    written_ += static_cast<std::size_t>(put);
    if (written_ == packet.size()) {
      waiting_.pop_front();
      written_ = 0;
    }
  }
}

// Lines on standard input.
void Emulator::read_lines(int& input) {
  char text[256];
  const ssize_t got = ::read(input, text, sizeof text);
  if (got <= 0) {
    input = -1;
  }
  for (ssize_t i = 0; i < got; ++i) {
    if (text[i] != '\n') {
      input_line_ += text[i];
      continue;
    }
    if (!input_line_.empty()) {
      obey(input_line_);
    }
    input_line_.clear();
  }
}

Status Emulator::run(const std::function<bool()>& stop, int input) {
  const double begin = now_s();
  const double block_s = settings_.block_frames / (static_cast<double>(hello_.rate_hz) * settings_.speed);
  while (!stop()) {
    const double now = now_s();
    if (settings_.seconds > 0.0 && now - begin > settings_.seconds) {
      break;
    }
    if (unplugged_until_s_ > 0.0 && now >= unplugged_until_s_) {
      unplugged_until_s_ = -1.0;
      if (Status opened = open(); !opened) {
        return opened;
      }
    }
    hear();
    own_faults(now);
    // Blocks that are due; not too many at once, so that commands are heard.
    for (int i = 0; running_ && i < 64 &&
                    started_s_ + static_cast<double>(frame_) / settings_.block_frames * block_s + block_s <= now;
         ++i) {
      make_block();
    }
    if (running_ && now >= next_status_s_) {
      next_status_s_ += 1.0;
      send(PacketKind::kStatus, acquire::status_body({frame_, 7.4F, 31.5F, overruns_}));
    }
    if (now >= stalled_until_s_) {
      flush();
    }
    pollfd waits[2] = {
        {master_, static_cast<short>(POLLIN | (waiting_.empty() || now < stalled_until_s_ ? 0 : POLLOUT)), 0},
        {input, POLLIN, 0}};
    ::poll(waits, 2, 1);
    if (input >= 0 && (waits[1].revents & (POLLIN | POLLHUP)) != 0) {
      read_lines(input);
    }
  }
  return {};
}

}  // namespace limbwave::emulator
