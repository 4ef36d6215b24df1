#include <cstdlib>

#include "acquire/block_sequencer.h"

// Whatever comes over the line: parsed in one piece and in parts to the same packets, and every sample counted.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace limbwave::acquire;
  const std::span<const std::byte> bytes{reinterpret_cast<const std::byte*>(data), size};
  PacketParser whole;
  PacketParser parts;
  whole.push(bytes);
  BlockSequencer sequencer(3);
  std::size_t cut = 0;
  while (const auto packet = whole.next()) {
    auto other = parts.next();
    while (!other && cut < size) {
      const std::size_t step = std::min<std::size_t>(1 + data[cut] % 61, size - cut);
      parts.push(bytes.subspan(cut, step));
      cut += step;
      other = parts.next();
    }
    if (!other || other->kind != packet->kind || other->body != packet->body) {
      std::abort();
    }
    if (const auto hello = read_hello(packet->body)) {
      if (read_hello(hello_body(*hello)) != hello) {
        std::abort();
      }
    }
    (void)read_status(packet->body);
    (void)read_answer(packet->body);
    (void)read_schedule(packet->body);
    if (auto block = read_block(packet->body)) {
      sequencer.push(*std::move(block));
    }
  }
  sequencer.give_up();
  // Every sample is there, or told as lost.
  std::int64_t frames = 0;
  std::int64_t lost = 0;
  for (const BoxPiece& piece : sequencer.take_pieces()) {
    frames += piece.lost + static_cast<std::int64_t>(piece.bytes.size() / 6);
    lost += piece.lost;
  }
  for (const BoxEvent& event : sequencer.take_events()) {
    lost -= event.kind == "dropped" ? event.count : 0;
  }
  if (frames != sequencer.position().value || lost != 0) {
    std::abort();
  }
  return 0;
}
