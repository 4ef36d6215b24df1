/// Packets of the driver box's serial line; driver_box_protocol.md has them byte for byte.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limbwave::acquire {

enum class PacketKind : std::uint8_t {
  kHello = 0x01,
  kBlock = 0x02,
  kStatus = 0x03,
  kAnswer = 0x04,
  kIdentify = 0x81,
  kStart = 0x82,
  kStop = 0x83,
  kSchedule = 0x84,
  kContinue = 0x85,
};

struct BoxHello {
  float rate_hz = 140000.0F;
  int wires = 18;
  int bits = 16;
  int sources = 8;
  int slot_samples = 1120;
  float pulse_hz = 40000.0F;
  std::uint64_t serial = 0, session = 0;
  std::string firmware;
  std::vector<std::uint8_t> schedule;  ///< Source of every slot, 255 is silence; empty: the sources in their order.
  bool operator==(const BoxHello&) const = default;
};

struct BoxBlock {
  std::int64_t first = 0;  ///< Sample index since start.
  int frames = 0, wires = 0;
  std::uint64_t connected = 0;        ///< Bit per wire.
  std::vector<std::int16_t> samples;  ///< frames · wires.
};

struct BoxStatus {
  std::int64_t sample = 0;
  float battery_volts = 0.0F, temperature_c = 0.0F;
  std::uint32_t overruns = 0;
};

struct BoxAnswer {
  std::uint16_t command = 0;
  bool done = false;
};

/// A packet whose checks held.
struct Packet {
  PacketKind kind{};
  std::uint16_t sequence = 0;
  std::vector<std::byte> body;
};

/// Finds packets in a stream of bytes, whatever else is in it. Memory is limited by the longest packet.
class PacketParser {
 public:
  static constexpr std::size_t kLongestBody = std::size_t{1} << 20U;
  /// Appends bytes as they came.
  void push(std::span<const std::byte> bytes);
  /// The next whole packet, if there is one.
  std::optional<Packet> next();
  /// Forgets a packet that has begun, when the line was lost.
  void reset();

  [[nodiscard]] std::uint64_t skipped_bytes() const { return skipped_; }  ///< That belonged to no packet.
  [[nodiscard]] std::uint64_t bad_packets() const { return bad_; }        ///< Headers and bodies whose check failed.

 private:
  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
  std::uint64_t skipped_ = 0, bad_ = 0;
};

/// What a body says; empty when it is not of the form that its kind has.
std::optional<BoxHello> read_hello(std::span<const std::byte> body);
std::optional<BoxBlock> read_block(std::span<const std::byte> body);
std::optional<BoxStatus> read_status(std::span<const std::byte> body);
std::optional<BoxAnswer> read_answer(std::span<const std::byte> body);
/// Sources by slot; kSilentSlot is silence.
inline constexpr std::uint8_t kSilentSlot = 255;
std::optional<std::vector<std::uint8_t>> read_schedule(std::span<const std::byte> body);

std::vector<std::byte> hello_body(const BoxHello& hello);
std::vector<std::byte> block_body(const BoxBlock& block);
std::vector<std::byte> status_body(const BoxStatus& status);
std::vector<std::byte> answer_body(const BoxAnswer& answer);
/// `schedule` has 1 to 64 slots.
std::vector<std::byte> schedule_body(std::span<const std::uint8_t> schedule);

/// The bytes of a packet.
std::vector<std::byte> write_packet(PacketKind kind, std::uint16_t sequence, std::span<const std::byte> body);

/// CRC-32 (ISO 3309).
std::uint32_t packet_crc(std::span<const std::byte> bytes);

}  // namespace limbwave::acquire
