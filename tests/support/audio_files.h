/// Audio files as other programs write them, for tests: through libsndfile, or byte by byte where it would refuse.
#pragma once

#include <cstdint>
#include <filesystem>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "acquire/sample_format.h"

namespace limbwave::test {

/// Random raw samples that use the whole range of the type (floats beyond ±1 too).
std::vector<std::byte> random_samples(const acquire::StreamFormat& format, std::size_t frames, unsigned seed = 1);

/// Writes raw samples into a file of a libsndfile container (SF_FORMAT_WAV, SF_FORMAT_AIFF ...), exactly.
void write_audio(const std::filesystem::path& path, int container, const acquire::StreamFormat& format,
                 std::span<const std::byte> raw);

/// The bytes of a plain WAV file; the header says what it is told, true or not.
struct WavBytes {
  std::uint16_t tag = 1;  ///< 1: integers, 3: floats
  std::uint16_t channels = 2;
  std::uint32_t rate = 48000;
  std::uint16_t bits = 16;
  std::string data = {};
  std::int64_t declared = -1;  ///< Length of `data` as the header has it; -1: the true one.
  [[nodiscard]] std::string bytes() const;
};

void write_bytes(const std::filesystem::path& path, const std::string& bytes);
std::string read_bytes(const std::filesystem::path& path);

}  // namespace limbwave::test
