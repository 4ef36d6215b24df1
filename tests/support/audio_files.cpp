#include "support/audio_files.h"

#include <sndfile.h>

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace limbwave::test {

using acquire::SampleType;

std::vector<std::byte> random_samples(const acquire::StreamFormat& format, std::size_t frames, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::byte> raw(frames * format.bytes_per_frame());
  if (format.type == SampleType::kFloat32) {
    std::normal_distribution<float> normal(0.0F, 0.7F);
    for (std::size_t i = 0; i < raw.size(); i += 4) {
      const float value = normal(random);
      std::memcpy(raw.data() + i, &value, 4);
    }
    return raw;
  }
  for (std::byte& byte : raw) {
    byte = static_cast<std::byte>(random() & 0xFFU);
  }
  return raw;
}

namespace {

int subtype(SampleType type) {
  switch (type) {
    case SampleType::kInt16:
      return SF_FORMAT_PCM_16;
    case SampleType::kInt24:
      return SF_FORMAT_PCM_24;
    case SampleType::kInt32:
      return SF_FORMAT_PCM_32;
    case SampleType::kFloat32:
      return SF_FORMAT_FLOAT;
  }
  return 0;
}

}  // namespace

void write_audio(const std::filesystem::path& path, int container, const acquire::StreamFormat& format,
                 std::span<const std::byte> raw) {
  SF_INFO info{};
  info.samplerate = static_cast<int>(format.rate.hz);
  info.channels = format.channels;
  info.format = container | subtype(format.type);
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  if (file == nullptr) {
    throw std::runtime_error(path.string() + ": " + sf_strerror(nullptr));
  }
  const std::size_t width = acquire::bytes_per_sample(format.type);
  const std::size_t samples = raw.size() / width;
  sf_count_t written = 0;
  if (format.type == SampleType::kInt16) {
    std::vector<short> values(samples);
    std::memcpy(values.data(), raw.data(), raw.size());
    written = sf_write_short(file, values.data(), static_cast<sf_count_t>(samples));
  } else if (format.type == SampleType::kFloat32) {
    std::vector<float> values(samples);
    std::memcpy(values.data(), raw.data(), raw.size());
    written = sf_write_float(file, values.data(), static_cast<sf_count_t>(samples));
  } else {
    std::vector<int> values(samples, 0);  // libsndfile takes integers left-aligned
    for (std::size_t i = 0; i < samples; ++i) {
      std::memcpy(reinterpret_cast<char*>(&values[i]) + 4 - width, raw.data() + i * width, width);
    }
    written = sf_write_int(file, values.data(), static_cast<sf_count_t>(samples));
  }
  sf_close(file);
  if (written != static_cast<sf_count_t>(samples)) {
    throw std::runtime_error(path.string() + ": not all could be written");
  }
}

std::string WavBytes::bytes() const {
  const auto number = [](std::uint64_t value, int width) {
    std::string text;
    for (int i = 0; i < width; ++i) {
      text += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
    return text;
  };
  const auto block = static_cast<std::uint16_t>(channels * ((bits + 7) / 8));
  const auto size = declared < 0 ? data.size() : static_cast<std::size_t>(declared);
  const std::string format = number(tag, 2) + number(channels, 2) + number(rate, 4) +
                             number(std::uint64_t{rate} * block, 4) + number(block, 2) + number(bits, 2);
  return "RIFF" + number(36 + size, 4) + "WAVEfmt " + number(16, 4) + format + "data" + number(size, 4) + data;
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << bytes;
  if (!file.flush()) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

}  // namespace limbwave::test
