#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "acquire/recording_file.h"
#include "support/audio_files.h"
#include "support/temporary_folder.h"

namespace limbwave::acquire {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::WavBytes;
using testing::HasSubstr;
using testing::Not;

// What opening and reading to the end answers: the error's text, else the first finding's code, else "".
std::string outcome(const fs::path& path, const RecordingOptions& options = {}) {
  Result<RecordingFile> file = RecordingFile::open(path, options);
  if (!file) {
    return file.error().text();
  }
  std::vector<std::byte> block(1000 * file->format().bytes_per_frame());
  for (;;) {
    const Result<std::size_t> got = file->read(block);
    if (!got) {
      return got.error().text();
    }
    if (*got == 0) {
      break;
    }
  }
  const Diagnostics diagnostics = file->diagnostics();
  return diagnostics.empty() ? "" : diagnostics.front().code;
}

class MalformedRecording : public testing::Test {
 protected:
  std::string outcome_of(const std::string& bytes) {
    test::write_bytes(path, bytes);
    std::string text = outcome(path);
    EXPECT_THAT(text, Not(HasSubstr("\n"))) << "one line";
    return text;
  }
  TemporaryFolder folder;
  fs::path path = folder / "x.wav";
  const std::string one_second = std::string(48000 * 4, '\x11');
};

TEST_F(MalformedRecording, SoundOneIsAccepted) {
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second}.bytes()), "");
}

TEST_F(MalformedRecording, Missing) {
  EXPECT_EQ(outcome(path), path.string() + ": does not exist; check the path");
}

TEST_F(MalformedRecording, Folder) {
  EXPECT_THAT(outcome(folder.path()), HasSubstr(": is a folder, not a recording; give a WAV"));
}

TEST_F(MalformedRecording, Pipe) {
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_THAT(outcome(path), HasSubstr("is not a file that can be read twice"));
}

TEST_F(MalformedRecording, Empty) {
  EXPECT_EQ(outcome_of(""), path.string() + ": is empty (0 bytes); copy it again from the recorder");
}

TEST_F(MalformedRecording, NotAudio) {
  EXPECT_THAT(outcome_of("Dear diary, today I bought a recorder."), HasSubstr(": is not an audio file"));
  EXPECT_THAT(outcome_of(std::string(100000, '\0')), HasSubstr(": is not an audio file"));
  EXPECT_THAT(outcome_of("RIFF"), HasSubstr(path.string() + ": "));
}

TEST_F(MalformedRecording, NoChannels) {
  EXPECT_EQ(outcome_of(WavBytes{.channels = 0, .data = one_second}.bytes()),
            path.string() + ": the header says that there are no channels; copy it again from the recorder");
}

TEST_F(MalformedRecording, Mono) {
  EXPECT_EQ(outcome_of(WavBytes{.channels = 1, .data = one_second}.bytes()),
            path.string() + ": the recording has one channel; record in stereo");
  const StreamFormat mono{SampleRate{48000}, 1, SampleType::kInt16};
  test::write_audio(folder / "x.flac", SF_FORMAT_FLAC, mono, test::random_samples(mono, 100));
  EXPECT_THAT(outcome(folder / "x.flac"), HasSubstr("has one channel; record in stereo"));
}

TEST_F(MalformedRecording, AbsurdRates) {
  for (const std::uint32_t rate : {0U, 1U, 7999U, 768001U, 0x7FFFFFFFU, 0xFFFFFFFFU}) {
    EXPECT_THAT(
        outcome_of(WavBytes{.rate = rate, .data = one_second}.bytes()),
        HasSubstr("the header says " + std::to_string(rate) + " samples per second; record at 44100 to 192000"));
  }
  EXPECT_EQ(outcome_of(WavBytes{.rate = 8000, .data = one_second}.bytes()), "");
  EXPECT_EQ(outcome_of(WavBytes{.rate = 768000, .data = one_second}.bytes()), "");
}

TEST_F(MalformedRecording, Truncated) {
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second, .declared = 480000 * 4}.bytes()),
            path.string() +
                ": the recording is cut off: its header promises 10.0 s, but 1.0 s are there; copy it again "
                "from the recorder");
  EXPECT_EQ(outcome(path, {.accept_truncated = true}), "recording.truncated");
  // In the middle of the header, at every byte.
  const std::string whole = WavBytes{.data = one_second}.bytes();
  for (std::size_t size = 1; size <= 44; ++size) {
    const std::string text = outcome_of(whole.substr(0, size));
    EXPECT_THAT(text, HasSubstr(path.string() + ": ")) << size;
  }
}

TEST_F(MalformedRecording, TruncatedInOtherContainers) {
  const StreamFormat format{SampleRate{48000}, 2, SampleType::kInt16};
  const std::vector<std::byte> raw = test::random_samples(format, 48000);
  const std::vector<std::pair<const char*, int>> kinds{
      {"x.w64", SF_FORMAT_W64}, {"x.rf64", SF_FORMAT_RF64}, {"x.aiff", SF_FORMAT_AIFF}, {"x.flac", SF_FORMAT_FLAC}};
  for (const auto& [name, container] : kinds) {
    const fs::path whole = folder / name;
    test::write_audio(whole, container, format, raw);
    EXPECT_EQ(outcome(whole), "") << name;
    fs::resize_file(whole, fs::file_size(whole) / 2);
    EXPECT_THAT(outcome(whole), testing::AnyOf(HasSubstr("cut off"), HasSubstr("breaks off"))) << name;
    EXPECT_EQ(outcome(whole, {.accept_truncated = true}), "recording.truncated") << name;
  }
}

TEST_F(MalformedRecording, PartOfAFrameAtTheEnd) {
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second + "abc"}.bytes()), "recording.partial-frame");
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second + "a"}.bytes()), "recording.partial-frame");
  // The header counts a last frame of which only a part is there.
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second + "ab", .declared = 48001 * 4}.bytes()), "recording.partial-frame");
}

TEST_F(MalformedRecording, NeverClosed) {
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second, .declared = 0}.bytes()), "recording.not-closed");
  EXPECT_EQ(outcome_of(WavBytes{.data = one_second, .declared = 0xFFFFFFFF}.bytes()), "recording.not-closed");
  for (const std::int64_t declared : {std::int64_t{0}, std::int64_t{0xFFFFFFFF}}) {
    const StreamFormat format{SampleRate{48000}, 2, SampleType::kInt24};
    const std::vector<std::byte> raw = test::random_samples(format, 1234);
    WavBytes wav{.bits = 24, .declared = declared};
    wav.data.assign(reinterpret_cast<const char*>(raw.data()), raw.size());
    test::write_bytes(path, wav.bytes());
    Result<RecordingFile> file = RecordingFile::open(path);
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->frames(), 1234);
    std::vector<std::byte> all(raw.size() + 600);
    ASSERT_EQ(*file->read(all), raw.size());
    all.resize(raw.size());
    EXPECT_TRUE(all == raw);
  }
}

TEST_F(MalformedRecording, WithoutSamples) {
  EXPECT_THAT(outcome_of(WavBytes{}.bytes()), HasSubstr("the recording has no samples"));
}

// As editors write an empty selection: what follows the samples that are not there is no sound.
TEST_F(MalformedRecording, ChunksAfterNoSamplesAreNoSamples) {
  const auto little = [](std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) {
      bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    }
    return bytes;
  };
  const std::string list = "LIST" + little(204) + "INFO" + std::string(200, 'x');
  std::string wav = WavBytes{}.bytes() + list;
  EXPECT_EQ(outcome_of(wav), "recording.not-closed") << "a header that does not count them was never closed";
  wav.replace(4, 4, little(static_cast<std::uint32_t>(wav.size()) - 8));
  EXPECT_THAT(outcome_of(wav), HasSubstr("the recording has no samples"));
  EXPECT_THAT(outcome_of(wav.substr(0, wav.size() - 1)), HasSubstr("the recording has no samples")) << "no pad byte";
}

TEST_F(MalformedRecording, NotNumbers) {
  std::string data(48000 * 8, '\0');
  const float bad[3] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                        -std::numeric_limits<float>::infinity()};
  for (std::size_t i = 0; i < 3; ++i) {
    std::memcpy(data.data() + 8 * (24000 + 3000 * i), &bad[i], 4);
  }
  EXPECT_EQ(outcome_of(WavBytes{.tag = 3, .bits = 32, .data = data}.bytes()), "recording.not-a-number");
  Result<RecordingFile> file = RecordingFile::open(path);
  ASSERT_TRUE(file.ok());
  std::vector<std::byte> all(data.size());
  ASSERT_EQ(*file->read(all), data.size());
  const Diagnostics diagnostics = file->diagnostics();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics[0].severity, Severity::kError);
  EXPECT_EQ(diagnostics[0].message, "3 of 96000 samples are not numbers");
  EXPECT_DOUBLE_EQ(diagnostics[0].time_s, 0.5);
}

TEST_F(MalformedRecording, DamagedFlacDoesNotComeOutAsSamples) {
  const StreamFormat format{SampleRate{48000}, 2, SampleType::kInt24};
  const fs::path flac = folder / "x.flac";
  test::write_audio(flac, SF_FORMAT_FLAC, format, test::random_samples(format, 48000));
  std::string bytes = test::read_bytes(flac);
  for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 5000; ++i) {
    bytes[i] = static_cast<char>(bytes[i] ^ 0x55);
  }
  test::write_bytes(flac, bytes);
  EXPECT_THAT(outcome(flac), HasSubstr("breaks off or is damaged"));
}

// Whatever a byte of the header says, the answer is a sound recording or one line, never a crash or a hang.
TEST_F(MalformedRecording, AnyByteOfTheHeaderMayBeWrong) {
  const std::string whole = WavBytes{.data = one_second.substr(0, 4000)}.bytes();
  for (std::size_t at = 0; at < 44; ++at) {
    for (const int value : {0x00, 0x01, 0x7F, 0x80, 0xFF}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(value);
      (void)outcome_of(bytes);
    }
  }
}

TEST_F(MalformedRecording, AnythingMayBeWrongInOtherContainers) {
  std::mt19937 random(3);
  const StreamFormat format{SampleRate{48000}, 2, SampleType::kInt16};
  const std::vector<std::byte> raw = test::random_samples(format, 500);
  const std::vector<std::pair<const char*, int>> kinds{
      {"x.w64", SF_FORMAT_W64}, {"x.rf64", SF_FORMAT_RF64}, {"x.aiff", SF_FORMAT_AIFF}, {"x.flac", SF_FORMAT_FLAC}};
  for (const auto& [name, container] : kinds) {
    test::write_audio(folder / name, container, format, raw);
    const std::string whole = test::read_bytes(folder / name);
    for (int i = 0; i < 400; ++i) {
      std::string bytes = whole.substr(0, i % 4 == 0 ? random() % whole.size() : whole.size());
      for (unsigned changes = 1 + random() % 3; changes > 0 && !bytes.empty(); --changes) {
        const std::size_t reach = std::min<std::size_t>(bytes.size(), 160);  // the headers, mostly
        bytes[random() % reach] = static_cast<char>(i % 3 == 0 ? 0xFF : random() & 0xFFU);
      }
      (void)outcome_of(bytes);
    }
  }
}

}  // namespace
}  // namespace limbwave::acquire
