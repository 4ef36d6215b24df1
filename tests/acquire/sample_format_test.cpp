#include "acquire/sample_format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace limbwave::acquire {
namespace {

template <typename T>
std::vector<float> converted(SampleType type, const std::vector<T>& values, std::size_t width = sizeof(T)) {
  std::vector<std::byte> raw(values.size() * width);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::memcpy(raw.data() + i * width, &values[i], width);  // little-endian: the lower bytes
  }
  std::vector<float> out(values.size());
  to_float(type, raw, out);
  return out;
}

TEST(SampleFormat, NamesAndSizes) {
  for (const SampleType type : {SampleType::kInt16, SampleType::kInt24, SampleType::kInt32, SampleType::kFloat32}) {
    EXPECT_EQ(sample_type(name(type)), type);
  }
  EXPECT_EQ(sample_type("int8"), std::nullopt);
  EXPECT_EQ((StreamFormat{SampleRate{48000}, 2, SampleType::kInt24}.bytes_per_frame()), 6U);
}

TEST(SampleFormat, FullScaleIsOne) {
  EXPECT_EQ(converted<std::int16_t>(SampleType::kInt16, {0, 1, -1, 32767, -32768}),
            (std::vector<float>{0.0F, 0x1p-15F, -0x1p-15F, 32767.0F / 32768.0F, -1.0F}));
  EXPECT_EQ(converted<std::int32_t>(SampleType::kInt24, {0, 1, -1, 8388607, -8388608}, 3),
            (std::vector<float>{0.0F, 0x1p-23F, -0x1p-23F, 8388607.0F / 8388608.0F, -1.0F}));
  EXPECT_EQ(converted<std::int32_t>(SampleType::kInt32, {0, 256, -256, std::numeric_limits<std::int32_t>::min()}),
            (std::vector<float>{0.0F, 0x1p-23F, -0x1p-23F, -1.0F}));
  EXPECT_EQ(converted<float>(SampleType::kFloat32, {0.0F, 1.5F, -1e-30F}), (std::vector<float>{0.0F, 1.5F, -1e-30F}));
  EXPECT_TRUE(std::isnan(converted<float>(SampleType::kFloat32, {std::nanf("")})[0]));
}

TEST(SampleFormat, EveryInt24IsExact) {
  for (std::int32_t value = -8388608; value <= 8388607; value += 4099) {
    ASSERT_EQ(converted<std::int32_t>(SampleType::kInt24, {value}, 3)[0], static_cast<float>(value) / 8388608.0F);
  }
}

}  // namespace
}  // namespace limbwave::acquire
