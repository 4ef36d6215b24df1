#include "acquire/serial_line.h"

#include <fcntl.h>
#include <libserialport.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace limbwave::acquire {
namespace {

constexpr int kReadTimeout = 20;    // milliseconds
constexpr int kWriteTimeout = 500;  // milliseconds

Error cannot_open(const std::string& name) {
  return {"cannot be opened", name, "check the cable, and that you may use serial ports (group dialout)"};
}

}  // namespace

Result<std::unique_ptr<SerialLine>> SerialLine::open(const std::string& name) {
  // A link that udev or an emulator keeps is followed, since the library knows ports by their own names alone.
  std::error_code code;
  const std::filesystem::path real = std::filesystem::canonical(name, code);
  const std::string path = code ? name : real.string();
  std::unique_ptr<SerialLine> line(new SerialLine);
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

SerialLine::~SerialLine() {
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

bool SerialLine::open_terminal(const std::string& path) {
  terminal_ = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios raw{};
  if (terminal_ < 0 || ::tcgetattr(terminal_, &raw) != 0) {
    return false;
  }
  ::cfmakeraw(&raw);
  raw.c_cflag |= CS8 | CREAD | CLOCAL;
  return ::tcsetattr(terminal_, TCSANOW, &raw) == 0;
}

int SerialLine::read(std::span<std::byte> buffer) {
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

bool SerialLine::write(std::span<const std::byte> bytes) {
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

}  // namespace limbwave::acquire
