/// CRC-32 of the raw samples of a take (ISO 3309, the one of zlib, PNG and `crc32`), over as many blocks as they come
/// in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace limbwave::take {

class SampleChecksum {
 public:
  void add(std::span<const std::byte> bytes);
  /// Of everything added so far; 0 for nothing.
  [[nodiscard]] std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 0;
};

}  // namespace limbwave::take
