#include "take/sample_checksum.h"

#include <zlib.h>

namespace limbwave::take {

void SampleChecksum::add(std::span<const std::byte> bytes) {
  if (bytes.empty()) {
    return;  // zlib takes no data at all for the wish to begin again
  }
  value_ = static_cast<std::uint32_t>(::crc32_z(value_, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace limbwave::take
