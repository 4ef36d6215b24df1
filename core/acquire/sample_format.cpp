#include "acquire/sample_format.h"

#include <bit>
#include <cassert>
#include <cstring>

namespace limbwave::acquire {
namespace {

static_assert(std::endian::native == std::endian::little, "raw samples are little-endian, as the program's own");

template <typename T>
void scaled(std::span<const std::byte> bytes, float scale, std::span<float> out) {
  const std::size_t count = bytes.size() / sizeof(T);
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    out[i] = static_cast<float>(value) * scale;
  }
}

}  // namespace

std::string_view name(SampleType type) {
  switch (type) {
    case SampleType::kInt16:
      return "int16";
    case SampleType::kInt24:
      return "int24";
    case SampleType::kInt32:
      return "int32";
    case SampleType::kFloat32:
      return "float32";
  }
  return "unknown";
}

std::optional<SampleType> sample_type(std::string_view text) {
  for (const SampleType type : {SampleType::kInt16, SampleType::kInt24, SampleType::kInt32, SampleType::kFloat32}) {
    if (name(type) == text) {
      return type;
    }
  }
  return std::nullopt;
}

std::size_t bytes_per_sample(SampleType type) {
  switch (type) {
    case SampleType::kInt16:
      return 2;
    case SampleType::kInt24:
      return 3;
    case SampleType::kInt32:
    case SampleType::kFloat32:
      return 4;
  }
  return 4;
}

void to_float(SampleType type, std::span<const std::byte> bytes, std::span<float> out) {
  assert(bytes.size() % bytes_per_sample(type) == 0);
  assert(out.size() >= bytes.size() / bytes_per_sample(type));
  switch (type) {
    case SampleType::kInt16:
      scaled<std::int16_t>(bytes, 0x1p-15F, out);
      return;
    case SampleType::kInt24:
      for (std::size_t i = 0; i < bytes.size() / 3; ++i) {
        const auto byte = [&](std::size_t k) { return std::to_integer<std::uint32_t>(bytes[3 * i + k]); };
        // Into the upper three bytes, so that the sign bit is the integer's own.
        const std::uint32_t left = byte(0) << 8 | byte(1) << 16 | byte(2) << 24;
        out[i] = static_cast<float>(static_cast<std::int32_t>(left)) * 0x1p-31F;
      }
      return;
    case SampleType::kInt32:
      scaled<std::int32_t>(bytes, 0x1p-31F, out);
      return;
    case SampleType::kFloat32:
      std::memcpy(out.data(), bytes.data(), bytes.size());
      return;
  }
}

}  // namespace limbwave::acquire
