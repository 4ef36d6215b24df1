#include "take/take_reader.h"

#include <gtest/gtest.h>

#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

using acquire::SampleType;

class Reader : public testing::TestWithParam<SampleType> {
 protected:
  void SetUp() override {
    std::unique_ptr<Recorder> recorder = must(Recorder::create(folder / "x.take", arm_info(format)));
    ASSERT_TRUE(recorder->write(raw).ok());
    take = must(recorder->close());
    expected.resize(static_cast<std::size_t>(kFrames) * 3);
    acquire::to_float(format.type, raw, expected);
  }
  static constexpr std::int64_t kFrames = 70001;
  test::TemporaryFolder folder;
  acquire::StreamFormat format{SampleRate{44100.0}, 3, GetParam()};
  std::vector<std::byte> raw = test::random_samples(format, kFrames);
  std::vector<float> expected;
  Take take;
};

TEST_P(Reader, StreamsTheSameInBlocksOfAnySize) {
  for (const std::size_t block :
       {std::size_t{1}, std::size_t{17}, std::size_t{480}, std::size_t{4096}, std::size_t{100000}}) {
    TakeReader reader = must(TakeReader::open(take));
    EXPECT_EQ(reader.frames(), kFrames);
    EXPECT_EQ(reader.format().channels, 3);
    std::vector<float> all;
    std::vector<float> out(block * 3 + 2);  // not a whole number of frames
    while (const std::size_t got = must(reader.next(out))) {
      all.insert(all.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(got * 3));
      ASSERT_EQ(reader.position().value * 3, static_cast<std::int64_t>(all.size()));
    }
    EXPECT_TRUE(all == expected) << block;
  }
}

TEST_P(Reader, ReadsAnywhere) {
  TakeReader reader = must(TakeReader::open(take));
  std::vector<float> out(3 * 100);
  for (const std::int64_t first : {std::int64_t{69950}, std::int64_t{0}, std::int64_t{12345}, kFrames - 1}) {
    const std::size_t got = must(reader.read(SampleIndex{first}, out));
    ASSERT_EQ(got, static_cast<std::size_t>(std::min<std::int64_t>(100, kFrames - first)));
    EXPECT_TRUE(
        std::equal(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(3 * got), expected.begin() + 3 * first));
  }
  EXPECT_EQ(must(reader.read(SampleIndex{kFrames}, out)), 0U);
  EXPECT_EQ(must(reader.read(SampleIndex{-1}, out)), 0U);
  reader.seek(SampleIndex{70000});
  EXPECT_EQ(must(reader.next(out)), 1U);
  EXPECT_EQ(must(reader.next(out)), 0U);
}

INSTANTIATE_TEST_SUITE_P(Types, Reader,
                         testing::Values(SampleType::kInt16, SampleType::kInt24, SampleType::kInt32,
                                         SampleType::kFloat32),
                         [](const auto& type) { return std::string(acquire::name(type.param)); });

}  // namespace
}  // namespace limbwave::take
