#include "decode/golay.h"

#include <array>
#include <bit>

#include "acquire/inertial_word_format.h"

namespace limbwave::decode {
namespace {

constexpr unsigned kPerfectBits = 23;  // the code without its parity bit is perfect: every syndrome has one cause

// Multiplying by x, modulo the generator, bit after bit.
constexpr std::array<std::uint32_t, kPerfectBits> make_powers() {
  std::array<std::uint32_t, kPerfectBits> powers{};
  std::uint32_t power = 1;
  for (std::uint32_t& entry : powers) {
    entry = power;
    power <<= 1U;
    if ((power & 0x800U) != 0) {
      power ^= acquire::kGolayGenerator;
    }
  }
  return powers;
}
constexpr std::array<std::uint32_t, kPerfectBits> kPowers = make_powers();

std::uint32_t syndrome(std::uint32_t word) {
  std::uint32_t sum = 0;
  for (; word != 0; word &= word - 1) {
    sum ^= kPowers[static_cast<std::size_t>(std::countr_zero(word))];
  }
  return sum;
}

// The lightest cause of every syndrome.
std::array<std::uint32_t, 2048> make_causes() {
  std::array<std::uint32_t, 2048> causes{};
  for (unsigned i = 0; i < kPerfectBits; ++i) {
    const std::uint32_t one = 1U << i;
    causes[syndrome(one)] = one;
    for (unsigned j = 0; j < i; ++j) {
      const std::uint32_t two = one | (1U << j);
      causes[syndrome(two)] = two;
      for (unsigned k = 0; k < j; ++k) {
        const std::uint32_t three = two | (1U << k);
        causes[syndrome(three)] = three;
      }
    }
  }
  return causes;
}

// Checks of the upper 12 bits and the lower 11, so that a syndrome costs two look-ups.
struct Tables {
  std::array<std::uint32_t, 2048> causes = make_causes();
  std::array<std::uint16_t, 4096> upper{};
  Tables() {
    for (std::uint32_t data = 0; data < 4096; ++data) {
      upper[data] = static_cast<std::uint16_t>(syndrome(data << 11U));
    }
  }
};
const Tables kTables;

}  // namespace

GolayWord golay_decode(std::uint32_t received) {
  const std::uint32_t perfect = received >> 1U;
  const std::uint32_t found = kTables.upper[perfect >> 11U] ^ (perfect & 0x7FFU);
  const std::uint32_t cause = kTables.causes[found];
  std::uint32_t pattern = cause << 1U;
  // The parity bit counts as the last that may be wrong.
  pattern |= static_cast<std::uint32_t>(std::popcount(received ^ pattern)) & 1U;
  const int errors = std::popcount(pattern);
  if (errors > 3) {
    return {0, 4, 0};
  }
  return {((received ^ pattern) >> 12U) & 0xFFFU, errors, pattern};
}

}  // namespace limbwave::decode
