#include "acquire/container_layout.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <string_view>

namespace limbwave::acquire {
namespace {

// A header is a chain of chunks; a chain longer than this is damaged.
constexpr int kChunkLimit = 4096;

class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& path) : file_(path, std::ios::binary) {
    file_.seekg(0, std::ios::end);
    size_ = file_ ? static_cast<std::uint64_t>(file_.tellg()) : 0;
  }

  [[nodiscard]] std::uint64_t size() const { return size_; }

  bool read(std::uint64_t offset, void* out, std::size_t count) {
    if (count > size_ || offset > size_ - count) {
      return false;
    }
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    return static_cast<bool>(file_.read(static_cast<char*>(out), static_cast<std::streamsize>(count)));
  }

 private:
  std::ifstream file_;
  std::uint64_t size_ = 0;
};

std::uint64_t little(const unsigned char* p, int bytes) {
  std::uint64_t value = 0;
  for (int i = bytes - 1; i >= 0; --i) {
    value = value << 8 | p[i];
  }
  return value;
}

std::uint64_t big(const unsigned char* p, int bytes) {
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) {
    value = value << 8 | p[i];
  }
  return value;
}

bool is(const unsigned char* p, std::string_view marker) {
  return std::memcmp(p, marker.data(), marker.size()) == 0;
}

// True where the size of the whole file in its header fits: then a size of 0 means that there are no samples, not that
// the header was never closed. Some writers leave the byte out that pads the last chunk.
bool was_closed(std::uint64_t declared_bytes, std::uint64_t file_bytes) {
  return declared_bytes == file_bytes || declared_bytes == file_bytes + 1 || declared_bytes + 1 == file_bytes;
}

// The first 16 bytes of a WAVE `fmt ` chunk.
void read_wave_format(const unsigned char* p, ContainerLayout& layout) {
  const auto tag = little(p, 2);
  layout.channels = static_cast<int>(little(p + 2, 2));
  layout.rate_hz = static_cast<double>(little(p + 4, 4));
  const bool plain = tag == 1 || tag == 3 || tag == 0xFFFE;  // PCM, IEEE float, extensible
  layout.bytes_per_frame = plain ? static_cast<int>(little(p + 12, 2)) : 0;
}

std::optional<ContainerLayout> read_wav(Bytes& file, bool is_rf64) {
  ContainerLayout layout;
  layout.file_bytes = file.size();
  std::uint64_t long_data_bytes = 0;
  bool has_format = false;
  unsigned char whole[8];
  const bool is_closed = file.read(0, whole, sizeof whole) && was_closed(little(whole + 4, 4) + 8, file.size());
  std::uint64_t at = 12;
  for (int i = 0; i < kChunkLimit; ++i) {
    unsigned char head[8];
    unsigned char body[16];
    if (!file.read(at, head, sizeof head)) {
      return std::nullopt;
    }
    const std::uint64_t size = little(head + 4, 4);
    if (is(head, "data")) {
      if (!has_format) {
        return std::nullopt;
      }
      layout.data_offset = at + 8;
      const bool is_long = size == 0xFFFFFFFFU;
      if (is_long && is_rf64) {
        layout.data_bytes = long_data_bytes;
      } else if (!is_long && (size != 0 || is_closed || layout.data_offset >= layout.file_bytes)) {
        layout.data_bytes = size;
      }
      return layout;
    }
    if (is(head, "fmt ") && size >= 16 && file.read(at + 8, body, 16)) {
      read_wave_format(body, layout);
      has_format = true;
    } else if (is(head, "ds64") && size >= 16 && file.read(at + 8, body, 16)) {
      long_data_bytes = little(body + 8, 8);
    }
    at += 8 + size + size % 2;
  }
  return std::nullopt;
}

std::optional<ContainerLayout> read_wave64(Bytes& file) {
  ContainerLayout layout;
  layout.file_bytes = file.size();
  bool has_format = false;
  unsigned char whole[24];
  const bool is_closed = file.read(0, whole, sizeof whole) && was_closed(little(whole + 16, 8), file.size());
  std::uint64_t at = 40;  // two markers of 16 bytes around a size of 8
  for (int i = 0; i < kChunkLimit; ++i) {
    unsigned char head[24];
    unsigned char body[16];
    if (!file.read(at, head, sizeof head)) {
      return std::nullopt;
    }
    const std::uint64_t size = little(head + 16, 8);  // with its header
    if (is(head, "data")) {
      if (!has_format) {
        return std::nullopt;
      }
      layout.data_offset = at + 24;
      if (size > 24 || is_closed || layout.data_offset >= layout.file_bytes) {
        layout.data_bytes = size > 24 ? size - 24 : 0;
      }
      return layout;
    }
    if (is(head, "fmt ") && size >= 40 && file.read(at + 24, body, 16)) {
      read_wave_format(body, layout);
      has_format = true;
    }
    if (size < 24 || size > layout.file_bytes) {
      return std::nullopt;
    }
    at += (size + 7) / 8 * 8;
  }
  return std::nullopt;
}

// An 80-bit IEEE 754 number, as AIFF stores its rate.
double read_extended(const unsigned char* p) {
  const int exponent = static_cast<int>(big(p, 2) & 0x7FFF) - 16383 - 63;
  return std::ldexp(static_cast<double>(big(p + 2, 8)), exponent);
}

std::optional<ContainerLayout> read_aiff(Bytes& file, bool is_aifc) {
  ContainerLayout layout;
  layout.file_bytes = file.size();
  std::uint64_t frames = 0;
  bool has_format = false;
  bool has_data = false;
  std::uint64_t at = 12;
  for (int i = 0; i < kChunkLimit && !(has_format && has_data); ++i) {
    unsigned char head[8];
    unsigned char body[22];
    if (!file.read(at, head, sizeof head)) {
      break;
    }
    const std::uint64_t size = big(head + 4, 4);
    if (is(head, "COMM") && size >= 18 && file.read(at + 8, body, is_aifc && size >= 22 ? 22 : 18)) {
      layout.channels = static_cast<int>(big(body, 2));
      frames = big(body + 2, 4);
      layout.rate_hz = read_extended(body + 8);
      const bool plain = !is_aifc || (size >= 22 && (is(body + 18, "NONE") || is(body + 18, "sowt") ||
                                                     is(body + 18, "fl32") || is(body + 18, "FL32")));
      layout.bytes_per_frame = plain ? layout.channels * static_cast<int>((big(body + 6, 2) + 7) / 8) : 0;
      has_format = true;
    } else if (is(head, "SSND") && file.read(at + 8, body, 8)) {
      layout.data_offset = at + 16 + big(body, 4);
      has_data = true;
    }
    at += 8 + size + size % 2;
  }
  if (!has_format || !has_data) {
    return std::nullopt;
  }
  unsigned char whole[8];
  const bool is_closed = file.read(0, whole, sizeof whole) && was_closed(big(whole + 4, 4) + 8, file.size());
  const std::uint64_t declared = frames * static_cast<std::uint64_t>(layout.bytes_per_frame);
  if (declared != 0 || (frames == 0 && (is_closed || layout.data_offset >= layout.file_bytes))) {
    layout.data_bytes = declared;
  }
  return layout;
}

}  // namespace

std::optional<ContainerLayout> read_layout(const std::filesystem::path& path) {
  Bytes file(path);
  unsigned char head[12];
  if (!file.read(0, head, sizeof head)) {
    return std::nullopt;
  }
  if (is(head + 8, "WAVE") && (is(head, "RIFF") || is(head, "RF64") || is(head, "BW64"))) {
    return read_wav(file, !is(head, "RIFF"));
  }
  if (is(head, "riff\x2E\x91\xCF\x11")) {
    return read_wave64(file);
  }
  if (is(head, "FORM") && (is(head + 8, "AIFF") || is(head + 8, "AIFC"))) {
    return read_aiff(file, is(head + 8, "AIFC"));
  }
  return std::nullopt;
}

}  // namespace limbwave::acquire
