#include "acquire/driver_box_protocol.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace limbwave::acquire {
namespace {

constexpr std::array<std::byte, 4> kMagic = {std::byte{0x4C}, std::byte{0x57}, std::byte{0x42}, std::byte{0x58}};
constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kHeader = 16;
constexpr std::size_t kMostFirmware = 64;
constexpr std::size_t kBlockHeader = 20;
constexpr int kMostFrames = 8192;
constexpr int kMostWires = 64;
constexpr std::size_t kMostSlots = 64;

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

template <typename T>
void put(std::vector<std::byte>& bytes, T value) {
  const auto raw = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

template <typename T>
T get(std::span<const std::byte> bytes, std::size_t offset) {
  std::array<std::byte, sizeof(T)> raw;
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
  return std::bit_cast<T>(raw);
}

bool between(float value, float low, float high) {
  return std::isfinite(value) && value >= low && value <= high;
}

}  // namespace

std::uint32_t packet_crc(std::span<const std::byte> bytes) {
  return static_cast<std::uint32_t>(
      ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

void PacketParser::push(std::span<const std::byte> bytes) {
  if (at_ > 65536 && at_ * 2 > bytes_.size()) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = 0;
  }
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<Packet> PacketParser::next() {
  while (true) {
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto magic = std::search(begin, bytes_.end(), kMagic.begin(), kMagic.end());
    if (magic == bytes_.end()) {
      // The last three bytes may be the beginning of a magic.
      const std::size_t left = bytes_.size() - at_;
      const std::size_t gone = left > kMagic.size() - 1 ? left - (kMagic.size() - 1) : 0;
      skipped_ += gone;
      at_ += gone;
      return std::nullopt;
    }
    skipped_ += static_cast<std::uint64_t>(magic - begin);
    at_ += static_cast<std::size_t>(magic - begin);
    const std::span<const std::byte> rest = std::span(bytes_).subspan(at_);
    if (rest.size() < kHeader) {
      return std::nullopt;
    }
    const auto length = get<std::uint32_t>(rest, 8);
    const bool good_header = get<std::uint32_t>(rest, 12) == packet_crc(rest.subspan(4, 8)) && length <= kLongestBody;
    if (good_header && rest.size() < kHeader + length + 4) {
      return std::nullopt;
    }
    if (!good_header || get<std::uint32_t>(rest, kHeader + length) != packet_crc(rest.subspan(kHeader, length))) {
      ++bad_;
      ++skipped_;
      ++at_;
      continue;
    }
    const std::uint8_t version = std::to_integer<std::uint8_t>(rest[5]);
    Packet packet;
    packet.kind = static_cast<PacketKind>(rest[4]);
    packet.sequence = get<std::uint16_t>(rest, 6);
    packet.body.assign(rest.begin() + kHeader, rest.begin() + static_cast<std::ptrdiff_t>(kHeader + length));
    at_ += kHeader + length + 4;
    if (version == kVersion) {
      return packet;
    }
    ++bad_;
  }
}

void PacketParser::reset() {
  skipped_ += bytes_.size() - at_;
  bytes_.clear();
  at_ = 0;
}

std::optional<BoxHello> read_hello(std::span<const std::byte> body) {
  constexpr std::size_t kFixed = 33;
  if (body.size() < kFixed + 1) {
    return std::nullopt;
  }
  BoxHello hello;
  hello.rate_hz = get<float>(body, 0);
  hello.wires = get<std::uint16_t>(body, 4);
  hello.bits = std::to_integer<int>(body[6]);
  hello.sources = std::to_integer<int>(body[7]);
  const auto slot = get<std::uint32_t>(body, 8);
  hello.slot_samples = static_cast<int>(slot & 0x7FFFFFFFU);
  hello.pulse_hz = get<float>(body, 12);
  hello.serial = get<std::uint64_t>(body, 16);
  hello.session = get<std::uint64_t>(body, 24);
  const auto name = std::to_integer<std::size_t>(body[32]);
  if (name > kMostFirmware || body.size() < kFixed + name + 1) {
    return std::nullopt;
  }
  const auto slots = std::to_integer<std::size_t>(body[kFixed + name]);
  if (slots > kMostSlots || body.size() != kFixed + name + 1 + slots) {
    return std::nullopt;
  }
  for (const std::byte source : body.subspan(kFixed + name + 1)) {
    hello.schedule.push_back(std::to_integer<std::uint8_t>(source));
  }
  for (const std::byte character : body.subspan(kFixed, name)) {
    const auto code = std::to_integer<unsigned char>(character);
    if (code < 0x20 || code > 0x7E) {
      return std::nullopt;
    }
    hello.firmware += static_cast<char>(code);
  }
  const bool possible = between(hello.rate_hz, 1000.0F, 10e6F) && hello.wires >= 1 && hello.wires <= kMostWires &&
                        hello.bits >= 12 && hello.bits <= 16 && hello.sources <= kMostWires && slot >= 1 &&
                        slot <= 1000000 && between(hello.pulse_hz, 0.0F, 1e6F);
  return possible ? std::optional(hello) : std::nullopt;
}

std::optional<BoxBlock> read_block(std::span<const std::byte> body) {
  if (body.size() < kBlockHeader) {
    return std::nullopt;
  }
  BoxBlock block;
  block.first = get<std::int64_t>(body, 0);
  block.frames = get<std::uint16_t>(body, 8);
  block.wires = get<std::uint16_t>(body, 10);
  block.connected = get<std::uint64_t>(body, 12);
  const std::size_t count = static_cast<std::size_t>(block.frames) * static_cast<std::size_t>(block.wires);
  if (block.first < 0 || block.first > (std::int64_t{1} << 50U) || block.frames < 1 || block.frames > kMostFrames ||
      block.wires < 1 || block.wires > kMostWires || body.size() != kBlockHeader + 2 * count) {
    return std::nullopt;
  }
  block.samples.resize(count);
  std::memcpy(block.samples.data(), body.data() + kBlockHeader, 2 * count);
  return block;
}

std::optional<BoxStatus> read_status(std::span<const std::byte> body) {
  if (body.size() != 20) {
    return std::nullopt;
  }
  BoxStatus status{get<std::int64_t>(body, 0), get<float>(body, 8), get<float>(body, 12), get<std::uint32_t>(body, 16)};
  const bool possible =
      status.sample >= 0 && between(status.battery_volts, -1e3F, 1e3F) && between(status.temperature_c, -300.0F, 1e4F);
  return possible ? std::optional(status) : std::nullopt;
}

std::optional<BoxAnswer> read_answer(std::span<const std::byte> body) {
  if (body.size() != 3 || std::to_integer<int>(body[2]) > 1) {
    return std::nullopt;
  }
  return BoxAnswer{get<std::uint16_t>(body, 0), body[2] == std::byte{0}};
}

std::optional<std::vector<std::uint8_t>> read_schedule(std::span<const std::byte> body) {
  if (body.empty() || body.size() != 1 + std::to_integer<std::size_t>(body[0]) || body.size() < 2 ||
      body.size() > 1 + kMostSlots) {
    return std::nullopt;
  }
  std::vector<std::uint8_t> schedule;
  for (const std::byte source : body.subspan(1)) {
    schedule.push_back(std::to_integer<std::uint8_t>(source));
  }
  return schedule;
}

std::vector<std::byte> hello_body(const BoxHello& hello) {
  std::vector<std::byte> body;
  put(body, hello.rate_hz);
  put(body, static_cast<std::uint16_t>(hello.wires));
  put(body, static_cast<std::uint8_t>(hello.bits));
  put(body, static_cast<std::uint8_t>(hello.sources));
  put(body, static_cast<std::uint32_t>(hello.slot_samples));
  put(body, hello.pulse_hz);
  put(body, hello.serial);
  put(body, hello.session);
  const std::string name = hello.firmware.substr(0, kMostFirmware);
  put(body, static_cast<std::uint8_t>(name.size()));
  for (const char character : name) {
    put(body, character);
  }
  const std::size_t slots = std::min(hello.schedule.size(), kMostSlots);
  put(body, static_cast<std::uint8_t>(slots));
  for (std::size_t slot = 0; slot < slots; ++slot) {
    put(body, hello.schedule[slot]);
  }
  return body;
}

std::vector<std::byte> block_body(const BoxBlock& block) {
  std::vector<std::byte> body;
  body.reserve(kBlockHeader + 2 * block.samples.size());
  put(body, block.first);
  put(body, static_cast<std::uint16_t>(block.frames));
  put(body, static_cast<std::uint16_t>(block.wires));
  put(body, block.connected);
  const auto samples = std::as_bytes(std::span(block.samples));
  body.insert(body.end(), samples.begin(), samples.end());
  return body;
}

std::vector<std::byte> status_body(const BoxStatus& status) {
  std::vector<std::byte> body;
  put(body, status.sample);
  put(body, status.battery_volts);
  put(body, status.temperature_c);
  put(body, status.overruns);
  return body;
}

std::vector<std::byte> answer_body(const BoxAnswer& answer) {
  std::vector<std::byte> body;
  put(body, answer.command);
  put(body, static_cast<std::uint8_t>(answer.done ? 0 : 1));
  return body;
}

std::vector<std::byte> schedule_body(std::span<const std::uint8_t> schedule) {
  std::vector<std::byte> body;
  put(body, static_cast<std::uint8_t>(schedule.size()));
  for (const std::uint8_t source : schedule) {
    put(body, source);
  }
  return body;
}

std::vector<std::byte> write_packet(PacketKind kind, std::uint16_t sequence, std::span<const std::byte> body) {
  std::vector<std::byte> bytes(kMagic.begin(), kMagic.end());
  bytes.reserve(kHeader + body.size() + 4);
  put(bytes, static_cast<std::uint8_t>(kind));
  put(bytes, kVersion);
  put(bytes, sequence);
  put(bytes, static_cast<std::uint32_t>(body.size()));
  put(bytes, packet_crc(std::span<const std::byte>(bytes).subspan(4, 8)));
  bytes.insert(bytes.end(), body.begin(), body.end());
  put(bytes, packet_crc(body));
  return bytes;
}

}  // namespace limbwave::acquire
