#include "take/import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <cstring>

#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"
#include "take/take_reader.h"

namespace limbwave::take {
namespace {

namespace fs = std::filesystem;
using acquire::SampleType;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::byte> raw_of(const Take& take) {
  TakeReader reader = must(TakeReader::open(take));
  std::vector<std::byte> raw(static_cast<std::size_t>(reader.frames()) * reader.format().bytes_per_frame());
  EXPECT_EQ(must(reader.read_raw(SampleIndex{0}, raw)), static_cast<std::size_t>(reader.frames()));
  return raw;
}

class Import : public testing::Test {
 protected:
  test::TemporaryFolder folder;
  fs::path path = folder / "x.take";
  body::Rig rig = arm_rig();
  acquire::StreamFormat format{SampleRate{44100.0}, 2, SampleType::kInt16};
};

TEST_F(Import, SamplesAreKeptBitByBit) {
  const std::vector<std::pair<const char*, int>> kinds{{"a.wav", SF_FORMAT_WAV},
                                                       {"a.w64", SF_FORMAT_W64},
                                                       {"a.rf64", SF_FORMAT_RF64},
                                                       {"a.aiff", SF_FORMAT_AIFF},
                                                       {"a.flac", SF_FORMAT_FLAC}};
  for (const auto& [name, container] : kinds) {
    for (const SampleType type : {SampleType::kInt16, SampleType::kInt24, SampleType::kInt32, SampleType::kFloat32}) {
      if (container == SF_FORMAT_FLAC && (type == SampleType::kInt32 || type == SampleType::kFloat32)) {
        continue;  // FLAC has no such samples
      }
      SCOPED_TRACE(std::string(name) + " " + std::string(acquire::name(type)));
      format.type = type;
      const std::vector<std::byte> raw = test::random_samples(format, 80001);
      test::write_audio(folder / name, container, format, raw);
      const Take take = must(import_recordings(path, {folder / name}, rig, Progress(), "Anna"));
      EXPECT_EQ(take.info.format.type, type);
      EXPECT_TRUE(take.info.complete);
      EXPECT_EQ(take.info.source, name);
      EXPECT_EQ(take.info.subject, "Anna");
      EXPECT_EQ(take.info.rig.name, rig.name);
      EXPECT_EQ(take.info.skeleton.name, rig.skeleton);
      EXPECT_TRUE(raw_of(take) == raw);
      EXPECT_THAT(codes(take.diagnostics), IsEmpty());
      EXPECT_THAT(codes(must(verify_take(path)).findings), IsEmpty());
      fs::remove_all(path);
      fs::remove(folder / name);
    }
  }
}

TEST_F(Import, PartsOfOneRecordingAreJoined) {
  const std::vector<std::byte> raw = test::random_samples(format, 3000);
  std::vector<fs::path> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    parts.push_back(folder / ("part" + std::to_string(i) + ".wav"));
    test::write_audio(parts.back(), SF_FORMAT_WAV, format, std::span(raw).subspan(i * 4000, 4000));
  }
  std::vector<double> seen;
  const Progress progress([&](double fraction, std::string_view) {
    seen.push_back(fraction);
    return true;
  });
  const Take take = must(import_recordings(path, parts, rig, progress));
  EXPECT_EQ(take.info.frames, 3000);
  EXPECT_EQ(take.info.source, "part0.wav, part1.wav, part2.wav");
  EXPECT_TRUE(raw_of(take) == raw);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  ASSERT_FALSE(seen.empty());
  EXPECT_NEAR(seen.back(), 1.0, 1e-9);
}

TEST_F(Import, PartsOfDifferentRecordingsAreRefused) {
  test::write_audio(folder / "a.wav", SF_FORMAT_WAV, format, test::random_samples(format, 100));
  format.rate = SampleRate{48000.0};
  test::write_audio(folder / "b.wav", SF_FORMAT_WAV, format, test::random_samples(format, 100));
  const Result<Take> take = import_recordings(path, {folder / "a.wav", folder / "b.wav"}, rig, Progress());
  ASSERT_FALSE(take);
  EXPECT_THAT(take.error().text(),
              HasSubstr("b.wav: has 2 channels at 48000 Hz, int16, but a.wav has 2 channels at 44100 Hz, int16"));
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(Import, MoreThanTwoChannelsAreRefused) {
  format.channels = 4;
  test::write_audio(folder / "a.wav", SF_FORMAT_WAV, format, test::random_samples(format, 100));
  EXPECT_THAT(import_recordings(path, {folder / "a.wav"}, rig, Progress()).error().text(),
              HasSubstr("a.wav: the recording has 4 channels; export the two"));
}

TEST_F(Import, CancelledOrFailedLeavesNothing) {
  test::write_audio(folder / "a.wav", SF_FORMAT_WAV, format, test::random_samples(format, 200000));
  for (const int steps : {0, 1, 3}) {
    int left = steps;
    const Progress progress([&](double, std::string_view) { return left-- > 0; });
    const Result<Take> take = import_recordings(path, {folder / "a.wav"}, rig, progress);
    ASSERT_FALSE(take);
    EXPECT_TRUE(is_cancelled(take.error()));
    EXPECT_THAT(names_in(folder.path()), ElementsAre("a.wav"));
  }
  EXPECT_FALSE(import_recordings(path, {folder / "a.wav", folder / "none.wav"}, rig, Progress()).ok());
  EXPECT_FALSE(import_recordings(path, {}, rig, Progress()).ok());
  body::Rig unknown = rig;
  unknown.skeleton = "dragon";
  EXPECT_FALSE(import_recordings(path, {folder / "a.wav"}, unknown, Progress()).ok());
  EXPECT_THAT(names_in(folder.path()), ElementsAre("a.wav"));
  ASSERT_TRUE(import_recordings(path, {folder / "a.wav"}, rig, Progress()).ok());
  EXPECT_THAT(import_recordings(path, {folder / "a.wav"}, rig, Progress()).error().text(), HasSubstr("exists already"));
}

TEST_F(Import, FloatsThatAreNotNumbersAreRefusedWithTheirCount) {
  std::string data(8000, '\0');
  const float nan = std::nanf("");
  std::memcpy(data.data() + 400, &nan, 4);
  test::write_bytes(folder / "a.wav", test::WavBytes{.tag = 3, .bits = 32, .data = data}.bytes());
  const Result<Take> take = import_recordings(path, {folder / "a.wav"}, rig, Progress());
  ASSERT_FALSE(take);
  EXPECT_THAT(take.error().text(), HasSubstr("a.wav: 1 of 2000 samples are not numbers; export it again"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("a.wav"));
}

TEST_F(Import, FindingsAreKeptInTheTake) {
  test::write_bytes(folder / "a.wav", test::WavBytes{.data = std::string(4003, '\1')}.bytes());
  const Take take = must(import_recordings(path, {folder / "a.wav"}, rig, Progress()));
  EXPECT_EQ(take.info.frames, 1000);
  EXPECT_THAT(codes(take.diagnostics), ElementsAre("recording.partial-frame"));
  const Take again = must(open_take(path));
  ASSERT_EQ(again.events.size(), 1U);
  EXPECT_EQ(again.events[0].kind, "import");
  EXPECT_THAT(again.events[0].text, HasSubstr("a.wav: the last 3 of 4 bytes are only part of a frame"));
}

}  // namespace
}  // namespace limbwave::take
