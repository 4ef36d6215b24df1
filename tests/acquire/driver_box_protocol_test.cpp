#include "acquire/driver_box_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace limbwave::acquire {
namespace {

BoxBlock some_block(std::int64_t first, int frames = 5, int wires = 3) {
  BoxBlock block;
  block.first = first;
  block.frames = frames;
  block.wires = wires;
  block.connected = 7;
  for (int i = 0; i < frames * wires; ++i) {
    block.samples.push_back(static_cast<std::int16_t>(first * wires + i));
  }
  return block;
}

std::vector<std::byte> block_packet(std::int64_t first, std::uint16_t sequence) {
  return write_packet(PacketKind::kBlock, sequence, block_body(some_block(first)));
}

TEST(DriverBoxProtocol, BodiesComeBack) {
  BoxHello hello;
  hello.serial = 0x123456789ABCDEFULL;
  hello.session = 42;
  hello.firmware = "emulator 1";
  EXPECT_EQ(read_hello(hello_body(hello)), hello);
  const auto block = read_block(block_body(some_block(123456789012)));
  ASSERT_TRUE(block);
  EXPECT_EQ(block->first, 123456789012);
  EXPECT_EQ(block->samples, some_block(123456789012).samples);
  const auto status = read_status(status_body({77, 7.25F, 30.5F, 3}));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->battery_volts, 7.25F);
  EXPECT_EQ(status->overruns, 3U);
  const auto answer = read_answer(answer_body({513, false}));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->command, 513);
  EXPECT_FALSE(answer->done);
}

// The layout is a contract with hardware: bytes as driver_box_protocol.md has them, put together here by its offsets
// alone, are read to the values they stand for; and the same values are written as the same bytes.
class Bytes {
 public:
  explicit Bytes(std::size_t size) : bytes_(size) {}
  Bytes& number(std::size_t offset, int count, std::uint64_t value) {
    for (int i = 0; i < count; ++i, value >>= 8U) {
      bytes_.at(offset + static_cast<std::size_t>(i)) = static_cast<std::byte>(value & 0xFFU);
    }
    return *this;
  }
  Bytes& text(std::size_t offset, const std::string& characters) {
    for (std::size_t i = 0; i < characters.size(); ++i) {
      bytes_.at(offset + i) = static_cast<std::byte>(characters[i]);
    }
    return *this;
  }
  [[nodiscard]] const std::vector<std::byte>& all() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

// CRC-32 as the document says it, bit by bit.
std::uint32_t documented_crc(std::span<const std::byte> bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::byte byte : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const std::uint32_t in = std::to_integer<std::uint32_t>(byte) >> bit;
      const bool out = ((crc ^ in) & 1U) != 0;
      crc >>= 1U;
      crc ^= out ? 0xEDB88320U : 0U;  // 0x04C11DB7 reflected
    }
  }
  return ~crc;
}

std::vector<std::byte> documented_packet(int kind, int sequence, const std::vector<std::byte>& body) {
  Bytes packet(16 + body.size() + 4);
  packet.number(0, 4, 0x5842574C).number(4, 1, static_cast<std::uint64_t>(kind)).number(5, 1, 1);
  packet.number(6, 2, static_cast<std::uint64_t>(sequence)).number(8, 4, body.size());
  packet.number(12, 4, documented_crc(std::span(packet.all()).subspan(4, 8)));
  for (std::size_t i = 0; i < body.size(); ++i) {
    packet.number(16 + i, 1, std::to_integer<std::uint64_t>(body[i]));
  }
  return packet.number(16 + body.size(), 4, documented_crc(body)).all();
}

TEST(DriverBoxProtocol, HelloIsAsDocumented) {
  Bytes body(33 + 5 + 1 + 3);
  body.number(0, 4, 0x4808B800).number(4, 2, 18).number(6, 1, 14).number(7, 1, 8);  // 140000.0 as a float
  body.number(8, 4, 1120).number(12, 4, 0x471C4000);                                // 40000.0
  body.number(16, 8, 0x1122334455667788).number(24, 8, 0x99AABBCCDDEEFF00).number(32, 1, 5).text(33, "fw1.2");
  body.number(38, 1, 3).number(39, 1, 7).number(40, 1, 0xFF).number(41, 1, 2);
  const auto hello = read_hello(body.all());
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->rate_hz, 140000.0F);
  EXPECT_EQ(hello->wires, 18);
  EXPECT_EQ(hello->bits, 14);
  EXPECT_EQ(hello->sources, 8);
  EXPECT_EQ(hello->slot_samples, 1120);
  EXPECT_EQ(hello->pulse_hz, 40000.0F);
  EXPECT_EQ(hello->serial, 0x1122334455667788U);
  EXPECT_EQ(hello->session, 0x99AABBCCDDEEFF00U);
  EXPECT_EQ(hello->firmware, "fw1.2");
  EXPECT_EQ(hello->schedule, (std::vector<std::uint8_t>{7, kSilentSlot, 2}));
  EXPECT_EQ(hello_body(*hello), body.all());
  EXPECT_EQ(write_packet(PacketKind::kHello, 0xABCD, body.all()), documented_packet(0x01, 0xABCD, body.all()));
}

TEST(DriverBoxProtocol, BlockIsAsDocumented) {
  Bytes body(20 + 2 * 2 * 3);
  body.number(0, 8, 0x0102030405).number(8, 2, 2).number(10, 2, 3).number(12, 8, 5);
  const std::int16_t samples[] = {1, -1, 256, -32768, 32767, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    body.number(20 + 2 * i, 2, static_cast<std::uint16_t>(samples[i]));
  }
  const auto block = read_block(body.all());
  ASSERT_TRUE(block);
  EXPECT_EQ(block->first, 0x0102030405);
  EXPECT_EQ(block->frames, 2);
  EXPECT_EQ(block->wires, 3);
  EXPECT_EQ(block->connected, 5U);
  EXPECT_EQ(block->samples, std::vector<std::int16_t>(std::begin(samples), std::end(samples)));
  EXPECT_EQ(block_body(*block), body.all());
  EXPECT_EQ(write_packet(PacketKind::kBlock, 1, body.all()), documented_packet(0x02, 1, body.all()));
}

TEST(DriverBoxProtocol, StatusAnswerAndScheduleAreAsDocumented) {
  Bytes status(20);
  status.number(0, 8, 1400000).number(8, 4, 0x40ECCCCD).number(12, 4, 0x41FC0000).number(16, 4, 3);  // 7.4, 31.5
  const auto read = read_status(status.all());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->sample, 1400000);
  EXPECT_EQ(read->battery_volts, 7.4F);
  EXPECT_EQ(read->temperature_c, 31.5F);
  EXPECT_EQ(read->overruns, 3U);
  EXPECT_EQ(status_body(*read), status.all());
  const Bytes answer = Bytes(3).number(0, 2, 513).number(2, 1, 1);
  ASSERT_TRUE(read_answer(answer.all()));
  EXPECT_EQ(read_answer(answer.all())->command, 513);
  EXPECT_FALSE(read_answer(answer.all())->done);
  EXPECT_EQ(answer_body({513, false}), answer.all());
  const Bytes schedule = Bytes(4).number(0, 1, 3).number(1, 1, 2).number(2, 1, 0xFF).number(3, 1, 0);
  EXPECT_EQ(read_schedule(schedule.all()), (std::vector<std::uint8_t>{2, kSilentSlot, 0}));
  EXPECT_EQ(schedule_body(*read_schedule(schedule.all())), schedule.all());
}

TEST(DriverBoxProtocol, CommandsHaveTheDocumentedKinds) {
  const std::pair<PacketKind, int> kinds[] = {{PacketKind::kStatus, 0x03},   {PacketKind::kAnswer, 0x04},
                                              {PacketKind::kIdentify, 0x81}, {PacketKind::kStart, 0x82},
                                              {PacketKind::kStop, 0x83},     {PacketKind::kSchedule, 0x84},
                                              {PacketKind::kContinue, 0x85}};
  for (const auto& [kind, number] : kinds) {
    EXPECT_EQ(write_packet(kind, 9, {}), documented_packet(number, 9, {})) << number;
  }
  // The document's example.
  const unsigned char identify[] = {0x4C, 0x57, 0x42, 0x58, 0x81, 1,    7, 0, 0, 0,
                                    0,    0,    0x21, 0x61, 0xC1, 0x41, 0, 0, 0, 0};
  const auto bytes = std::as_bytes(std::span(identify));
  EXPECT_EQ(write_packet(PacketKind::kIdentify, 7, {}), std::vector<std::byte>(bytes.begin(), bytes.end()));
  PacketParser parser;
  parser.push(bytes);
  const auto packet = parser.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->kind, PacketKind::kIdentify);
  EXPECT_EQ(packet->sequence, 7);
  EXPECT_EQ(packet->body.size(), 0U);
  // The check value of ISO 3309's CRC.
  const char digits[] = "123456789";
  EXPECT_EQ(packet_crc(std::as_bytes(std::span(digits, 9))), 0xCBF43926U);
  EXPECT_EQ(documented_crc(std::as_bytes(std::span(digits, 9))), 0xCBF43926U);
}

TEST(DriverBoxProtocol, AnotherVersionIsPassedOverAsAWhole) {
  auto strange = documented_packet(0x01, 0, std::vector<std::byte>(40));
  strange[5] = std::byte{2};
  const std::uint32_t crc = documented_crc(std::span(strange).subspan(4, 8));
  for (unsigned i = 0; i < 4; ++i) {
    strange[12 + i] = static_cast<std::byte>((crc >> (8 * i)) & 0xFFU);
  }
  PacketParser parser;
  parser.push(strange);
  parser.push(block_packet(5, 1));
  const auto packet = parser.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->kind, PacketKind::kBlock);
  EXPECT_EQ(parser.bad_packets(), 1U);
  EXPECT_EQ(parser.skipped_bytes(), 0U);
}

TEST(DriverBoxProtocol, FindsPacketsHoweverTheyAreCut) {
  std::vector<std::byte> bytes;
  for (int i = 0; i < 20; ++i) {
    const auto packet = block_packet(5 * i, static_cast<std::uint16_t>(i));
    bytes.insert(bytes.end(), packet.begin(), packet.end());
  }
  for (const std::size_t cut : {std::size_t{1}, std::size_t{7}, std::size_t{64}, bytes.size()}) {
    PacketParser parser;
    std::int64_t expected = 0;
    for (std::size_t i = 0; i < bytes.size(); i += cut) {
      parser.push(std::span(bytes).subspan(i, std::min(cut, bytes.size() - i)));
      while (const auto packet = parser.next()) {
        EXPECT_EQ(read_block(packet->body)->first, expected);
        expected += 5;
      }
    }
    EXPECT_EQ(expected, 100) << cut;
    EXPECT_EQ(parser.skipped_bytes(), 0U);
  }
}

TEST(DriverBoxProtocol, ADamagedPacketCostsOnlyItself) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::byte> bytes;
    const int hurt = static_cast<int>(random() % 9);
    for (int i = 0; i < 10; ++i) {
      auto packet = block_packet(5 * i, static_cast<std::uint16_t>(i));
      if (i == hurt) {
        packet[random() % packet.size()] ^= static_cast<std::byte>(1U + random() % 255U);
      }
      bytes.insert(bytes.end(), packet.begin(), packet.end());
    }
    PacketParser parser;
    parser.push(bytes);
    std::vector<std::int64_t> found;
    while (const auto packet = parser.next()) {
      found.push_back(read_block(packet->body)->first);
    }
    ASSERT_EQ(found.size(), 9U);
    EXPECT_EQ(std::count(found.begin(), found.end(), 5 * hurt), 0);
  }
}

TEST(DriverBoxProtocol, RefusesImpossibleBodies) {
  auto body = block_body(some_block(0));
  body.pop_back();
  EXPECT_FALSE(read_block(body));
  BoxBlock none = some_block(0);
  none.frames = 0;
  none.samples.clear();
  EXPECT_FALSE(read_block(block_body(none)));
  BoxBlock before = some_block(-1);
  EXPECT_FALSE(read_block(block_body(before)));
  BoxHello hello;
  hello.rate_hz = NAN;
  EXPECT_FALSE(read_hello(hello_body(hello)));
  hello = {};
  hello.wires = 0;
  EXPECT_FALSE(read_hello(hello_body(hello)));
  EXPECT_FALSE(read_schedule({}));
  hello = {};
  hello.schedule.assign(3, 0);
  auto longer = hello_body(hello);
  longer.push_back(std::byte{0});
  EXPECT_FALSE(read_hello(longer));
  longer.resize(longer.size() - 2);
  EXPECT_FALSE(read_hello(longer));
  EXPECT_FALSE(read_schedule(schedule_body(std::vector<std::uint8_t>(65))));
}

}  // namespace
}  // namespace limbwave::acquire
