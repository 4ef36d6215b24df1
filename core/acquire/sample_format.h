/// How samples are stored: the raw bytes of a take keep exactly what the device or the file gave.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/time.h"

namespace limbwave::acquire {

/// Little-endian signed integers, or IEEE floats with full scale ±1.
enum class SampleType { kInt16, kInt24, kInt32, kFloat32 };

std::string_view name(SampleType type);                        ///< "int16", "int24", "int32", "float32"
std::optional<SampleType> sample_type(std::string_view text);  ///< The inverse of `name`.
std::size_t bytes_per_sample(SampleType type);                 ///< 2, 3, 4, 4

struct StreamFormat {
  SampleRate rate;
  int channels = 2;
  SampleType type = SampleType::kInt16;
  [[nodiscard]] std::size_t bytes_per_frame() const {
    return bytes_per_sample(type) * static_cast<std::size_t>(channels);
  }
};

/// Raw interleaved bytes to floats of full scale ±1 (int16: value / 32768). `out` has room for bytes /
/// bytes_per_sample.
void to_float(SampleType type, std::span<const std::byte> bytes, std::span<float> out);

}  // namespace limbwave::acquire
