#include "acquire/driver_box_protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

// The layout is a contract with hardware: what is written here is what driver_box_protocol.md says.
TEST(DriverBoxProtocol, LayoutIsAsDocumented) {
  const std::vector<std::byte> packet = block_packet(0x0102030405, 0xABCD);
  const auto at = [&](std::size_t i) { return std::to_integer<int>(packet[i]); };
  EXPECT_EQ(at(0), 'L');
  EXPECT_EQ(at(3), 'X');
  EXPECT_EQ(at(4), 2);
  EXPECT_EQ(at(5), 1);
  EXPECT_EQ(at(6), 0xCD);
  EXPECT_EQ(at(7), 0xAB);
  EXPECT_EQ(at(8), 20 + 2 * 15);
  EXPECT_EQ(at(16), 0x05);
  EXPECT_EQ(at(20), 0x01);
  EXPECT_EQ(at(24), 5);
  EXPECT_EQ(at(26), 3);
  EXPECT_EQ(packet.size(), 16U + 50U + 4U);
  // The check value of ISO 3309's CRC.
  const char digits[] = "123456789";
  EXPECT_EQ(packet_crc(std::as_bytes(std::span(digits, 9))), 0xCBF43926U);
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
}

}  // namespace
}  // namespace limbwave::acquire
