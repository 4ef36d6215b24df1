#include "acquire/wav_writer.h"

#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <fstream>

#include "acquire/container_layout.h"
#include "support/audio_files.h"
#include "support/temporary_folder.h"

namespace limbwave::acquire {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

// The number of frames that libsndfile finds, reading the file as any other program would; -1 when it refuses.
std::int64_t frames_by_libsndfile(const fs::path& path, int* format = nullptr) {
  SF_INFO info{};
  SNDFILE* file = sf_open(path.c_str(), SFM_READ, &info);
  if (file == nullptr) {
    return -1;
  }
  sf_close(file);
  if (format != nullptr) {
    *format = info.format & SF_FORMAT_TYPEMASK;
  }
  return info.frames;
}

class Writer : public testing::TestWithParam<SampleType> {
 protected:
  TemporaryFolder folder;
  fs::path path = folder / "x.wav";
  StreamFormat format{SampleRate{96000}, 2, GetParam()};
};

TEST_P(Writer, WhatIsWrittenIsReadAtEveryInstant) {
  const std::vector<std::byte> raw = test::random_samples(format, 5000);
  Result<std::unique_ptr<WavWriter>> writer = WavWriter::create(path, format);
  ASSERT_TRUE(writer.ok()) << writer.error().text();
  EXPECT_EQ(frames_by_libsndfile(path), 0);
  for (int block = 0; block < 5; ++block) {
    ASSERT_TRUE((*writer)->write(std::span(raw).subspan(
        static_cast<std::size_t>(block) * 1000 * format.bytes_per_frame(), 1000 * format.bytes_per_frame())));
    ASSERT_TRUE((*writer)->update_header());
    EXPECT_EQ((*writer)->frames(), 1000 * (block + 1));
    EXPECT_EQ(frames_by_libsndfile(path), 1000 * (block + 1));
  }
  ASSERT_TRUE((*writer)->close());
  const std::string bytes = test::read_bytes(path);
  const std::string header = wav_header(format, 5000);
  EXPECT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + raw.size());
  EXPECT_EQ(std::memcmp(bytes.data() + header.size(), raw.data(), raw.size()), 0);
}

TEST_P(Writer, HeaderKeepsItsLengthBeyondFourGigabytes) {
  const std::size_t length = wav_header(format, 0).size();
  for (const std::int64_t frames :
       {std::int64_t{1}, std::int64_t{400'000'000}, std::int64_t{2'000'000'000}, std::int64_t{100'000'000'000}}) {
    EXPECT_EQ(wav_header(format, frames).size(), length);
  }
  const auto bytes = static_cast<std::int64_t>(format.bytes_per_frame());
  const auto header = static_cast<std::int64_t>(length);
  const std::int64_t last_small = (0xFFFFFFFFLL - 1 - header) / bytes;
  EXPECT_EQ(wav_header(format, last_small).substr(0, 4), "RIFF");
  EXPECT_EQ(wav_header(format, last_small + 2).substr(0, 4), "RF64");
}

// A sparse file stands for hours of samples: the recorder goes on where it ends.
TEST_P(Writer, BecomesRf64WhileItGrows) {
  Result<std::unique_ptr<WavWriter>> writer = WavWriter::create(path, format);
  ASSERT_TRUE(writer.ok());
  const std::vector<std::byte> raw = test::random_samples(format, 1000);
  ASSERT_TRUE((*writer)->write(raw));
  const std::size_t header = wav_header(format, 0).size();
  const auto frames = static_cast<std::int64_t>((std::uint64_t{5} << 30) / format.bytes_per_frame());
  fs::resize_file(path, header + static_cast<std::uint64_t>(frames) * format.bytes_per_frame());
  ASSERT_TRUE((*writer)->update_header());
  int container = 0;
  EXPECT_EQ(frames_by_libsndfile(path, &container), frames);
  EXPECT_EQ(container, SF_FORMAT_RF64);
  const std::optional<ContainerLayout> layout = read_layout(path);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->data_offset, header) << "samples must not move";
  EXPECT_EQ(layout->data_bytes, static_cast<std::uint64_t>(frames) * format.bytes_per_frame());
  std::ifstream file(path, std::ios::binary);
  std::string start(header, '\0');
  file.read(start.data(), static_cast<std::streamsize>(header));
  EXPECT_EQ(start, wav_header(format, frames)) << "the header made in memory is the one libsndfile writes";
}

INSTANTIATE_TEST_SUITE_P(Types, Writer,
                         testing::Values(SampleType::kInt16, SampleType::kInt24, SampleType::kInt32,
                                         SampleType::kFloat32),
                         [](const auto& type) { return std::string(name(type.param)); });

TEST(WavWriter, NeverOverwrites) {
  const TemporaryFolder folder;
  test::write_bytes(folder / "x.wav", "mine");
  EXPECT_FALSE(WavWriter::create(folder / "x.wav", {SampleRate{48000}, 2, SampleType::kInt16}).ok());
  EXPECT_EQ(test::read_bytes(folder / "x.wav"), "mine");
}

TEST(WavWriter, AFailedWriteKeepsWholeFramesBeforeIt) {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.wav";
  const StreamFormat format{SampleRate{48000}, 2, SampleType::kInt24};
  const std::vector<std::byte> raw = test::random_samples(format, 1000);
  const std::size_t header = wav_header(format, 0).size();
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // The disk takes 1500 frames and 4 bytes.
    ::signal(SIGXFSZ, SIG_IGN);
    const rlim_t room = header + 1500 * 6 + 4;
    const rlimit limit{room, room};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    auto writer = WavWriter::create(path, format);
    const bool first = (*writer)->write(raw).ok();
    const bool second = (*writer)->write(raw).ok();
    const bool third = (*writer)->write(raw).ok();
    const bool closed = (*writer)->close().ok();
    ::_exit(first && !second && !third && closed && (*writer)->frames() == 1500 ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(frames_by_libsndfile(path), 1500);
  const std::string bytes = test::read_bytes(path);
  ASSERT_EQ(bytes.size(), header + 1500 * 6);
  EXPECT_EQ(std::memcmp(bytes.data() + header, raw.data(), raw.size()), 0);
  EXPECT_EQ(std::memcmp(bytes.data() + header + raw.size(), raw.data(), 500 * 6), 0);
}

}  // namespace
}  // namespace limbwave::acquire
