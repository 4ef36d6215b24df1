#include "acquire/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <cstring>

#include "support/audio_files.h"
#include "support/temporary_folder.h"

namespace limbwave::acquire {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;

std::vector<std::byte> read_all(RecordingFile& file, std::size_t block_frames) {
  std::vector<std::byte> all;
  std::vector<std::byte> block(block_frames * file.format().bytes_per_frame() + 1);  // not a whole number of frames
  for (;;) {
    const Result<std::size_t> got = file.read(block);
    EXPECT_TRUE(got.ok()) << (got.ok() ? "" : got.error().text());
    if (!got || *got == 0) {
      return all;
    }
    all.insert(all.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(*got));
  }
}

std::vector<std::string> codes(const Diagnostics& diagnostics) {
  std::vector<std::string> list;
  for (const Diagnostic& diagnostic : diagnostics) {
    list.push_back(diagnostic.code);
  }
  return list;
}

struct Kind {
  const char* extension;
  int container;
  SampleType type;
};

class ExactRecording : public testing::TestWithParam<Kind> {};

TEST_P(ExactRecording, ComesOutBitByBit) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / (std::string("x.") + GetParam().extension);
  for (const double rate : {44100.0, 192000.0}) {
    const StreamFormat format{SampleRate{rate}, 2, GetParam().type};
    const std::vector<std::byte> raw = test::random_samples(format, 10007);
    test::write_audio(path, GetParam().container, format, raw);
    for (const std::size_t block : {std::size_t{1}, std::size_t{17}, std::size_t{4096}, std::size_t{100000}}) {
      Result<RecordingFile> file = RecordingFile::open(path);
      ASSERT_TRUE(file.ok()) << file.error().text();
      EXPECT_EQ(file->format().type, format.type);
      EXPECT_EQ(file->format().rate, format.rate);
      EXPECT_EQ(file->format().channels, 2);
      EXPECT_EQ(file->frames(), 10007);
      EXPECT_TRUE(read_all(*file, block) == raw) << block;
      EXPECT_THAT(codes(file->diagnostics()), ElementsAre());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ExactRecording,
    testing::Values(Kind{"wav", SF_FORMAT_WAV, SampleType::kInt16}, Kind{"wav", SF_FORMAT_WAV, SampleType::kInt24},
                    Kind{"wav", SF_FORMAT_WAV, SampleType::kInt32}, Kind{"wav", SF_FORMAT_WAV, SampleType::kFloat32},
                    Kind{"wav", SF_FORMAT_WAVEX, SampleType::kInt24}, Kind{"w64", SF_FORMAT_W64, SampleType::kInt16},
                    Kind{"w64", SF_FORMAT_W64, SampleType::kInt24}, Kind{"w64", SF_FORMAT_W64, SampleType::kFloat32},
                    Kind{"rf64", SF_FORMAT_RF64, SampleType::kInt16}, Kind{"rf64", SF_FORMAT_RF64, SampleType::kInt24},
                    Kind{"rf64", SF_FORMAT_RF64, SampleType::kFloat32},
                    Kind{"flac", SF_FORMAT_FLAC, SampleType::kInt16}, Kind{"flac", SF_FORMAT_FLAC, SampleType::kInt24},
                    Kind{"aiff", SF_FORMAT_AIFF, SampleType::kInt16}, Kind{"aiff", SF_FORMAT_AIFF, SampleType::kInt24},
                    Kind{"aiff", SF_FORMAT_AIFF, SampleType::kInt32},
                    Kind{"aifc", SF_FORMAT_AIFF, SampleType::kFloat32}),
    [](const testing::TestParamInfo<Kind>& kind) {
      return std::to_string(kind.index) + "_" + kind.param.extension + "_" + std::string(name(kind.param.type));
    });

TEST(RecordingFile, KeepsAllChannels) {
  const TemporaryFolder folder;
  const StreamFormat format{SampleRate{96000}, 4, SampleType::kInt24};
  const std::vector<std::byte> raw = test::random_samples(format, 999);
  test::write_audio(folder / "x.wav", SF_FORMAT_WAV, format, raw);
  Result<RecordingFile> file = RecordingFile::open(folder / "x.wav");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->format().channels, 4);
  EXPECT_TRUE(read_all(*file, 100) == raw);
}

TEST(RecordingFile, EightBitsBecomeSixteenExactlyAndAreSaidTo) {
  const TemporaryFolder folder;
  test::WavBytes wav;
  wav.bits = 8;
  wav.data = std::string("\x00\x80\xFF\x81", 4);  // 8-bit WAV is unsigned
  test::write_bytes(folder / "x.wav", wav.bytes());
  Result<RecordingFile> file = RecordingFile::open(folder / "x.wav");
  ASSERT_TRUE(file.ok()) << file.error().text();
  EXPECT_EQ(file->format().type, SampleType::kInt16);
  const std::vector<std::byte> raw = read_all(*file, 10);
  std::vector<std::int16_t> samples(raw.size() / 2);
  std::memcpy(samples.data(), raw.data(), raw.size());
  EXPECT_THAT(samples, ElementsAre(-128 * 256, 0, 127 * 256, 256));
  EXPECT_THAT(codes(file->diagnostics()), ElementsAre("recording.converted"));
}

TEST(RecordingFile, LossyCompressionIsReadWithAWarning) {
  const TemporaryFolder folder;
  const StreamFormat format{SampleRate{44100}, 2, SampleType::kFloat32};
  std::vector<float> tone(2 * 44100);
  for (std::size_t i = 0; i < tone.size(); ++i) {
    const std::size_t frame = i / 2;
    tone[i] = 0.5F * std::sin(0.05F * static_cast<float>(frame));
  }
  SF_INFO info{};
  info.samplerate = 44100;
  info.channels = 2;
  info.format = SF_FORMAT_OGG | SF_FORMAT_VORBIS;
  SNDFILE* out = sf_open((folder / "x.ogg").c_str(), SFM_WRITE, &info);
  ASSERT_NE(out, nullptr);
  sf_writef_float(out, tone.data(), 44100);
  sf_close(out);
  Result<RecordingFile> file = RecordingFile::open(folder / "x.ogg");
  ASSERT_TRUE(file.ok()) << file.error().text();
  EXPECT_EQ(file->format().type, format.type);
  EXPECT_EQ(read_all(*file, 1000).size(), 44100U * 8U);
  EXPECT_THAT(codes(file->diagnostics()), ElementsAre("recording.converted", "recording.lossy"));
}

}  // namespace
}  // namespace limbwave::acquire
