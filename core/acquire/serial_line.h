/// One opened serial port, also a pseudo-terminal.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "base/result.h"

struct sp_port;

namespace limbwave::acquire {

/// Closed when it goes. libserialport, but for pseudo-terminals, which have no modem lines to ask for.
class SerialLine {
 public:
  /// Fails when there is no such port, or it may not be opened.
  static Result<std::unique_ptr<SerialLine>> open(const std::string& name);
  ~SerialLine();
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  /// Waits a little; the number of bytes read, 0 when none came, below 0 when the line is gone.
  int read(std::span<std::byte> buffer);
  /// All of them; false when the line does not take them within half a second.
  bool write(std::span<const std::byte> bytes);

 private:
  SerialLine() = default;
  bool open_terminal(const std::string& path);

  sp_port* port_ = nullptr;
  bool port_open_ = false;
  int terminal_ = -1;
};

}  // namespace limbwave::acquire
