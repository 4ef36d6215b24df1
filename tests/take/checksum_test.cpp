/// Samples that changed on the disk are found out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/sample_checksum.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

const acquire::StreamFormat kFormat{SampleRate{48000.0}, 2, acquire::SampleType::kInt24};

Take recorded(const fs::path& path) {
  const std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(kFormat)));
  const std::vector<std::byte> raw = test::random_samples(kFormat, 100000);
  for (std::size_t done = 0; done < raw.size();) {  // blocks of another size than those that are checked
    const std::size_t count = std::min<std::size_t>(raw.size() - done, 4801 * kFormat.bytes_per_frame());
    EXPECT_TRUE(recorder->write(std::span(raw).subspan(done, count)).ok());
    done += count;
  }
  return must(recorder->close());
}

void flip_bit(const fs::path& path, std::int64_t from_end) {
  std::string bytes = test::read_bytes(path);
  char& byte = bytes.at(bytes.size() - static_cast<std::size_t>(from_end));
  byte = static_cast<char>(byte ^ 0x04);
  test::write_bytes(path, bytes);
}

TEST(SampleChecksum, IsTheStandardOne) {
  SampleChecksum checksum;
  EXPECT_EQ(checksum.value(), 0U);
  const std::string digits = "123456789";
  const auto bytes = std::as_bytes(std::span(digits));
  checksum.add(bytes.first(4));
  checksum.add(bytes.subspan(4));
  checksum.add({});
  EXPECT_EQ(checksum.value(), 0xCBF43926U) << "the check value of CRC-32/ISO-HDLC";
}

TEST(Checksum, AChangedBitIsFound) {
  const test::TemporaryFolder folder;
  const Take take = recorded(folder / "a.take");
  ASSERT_TRUE(take.info.samples_crc32.has_value());
  EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre());
  for (const std::int64_t place : {1, 70000, 599999}) {
    flip_bit(take.signal_path(), place);
    EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre("verify.checksum")) << place;
    // Repairing must not make it look sound.
    (void)recover_take(take.folder);
    EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre("verify.checksum")) << place;
    flip_bit(take.signal_path(), place);
    EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre());
  }
}

TEST(Checksum, OfARecoveredTakeIsOfWhatIsThere) {
  const test::TemporaryFolder folder;
  Take take = recorded(folder / "a.take");
  take.info.complete = false;
  take.info.samples_crc32.reset();
  ASSERT_TRUE(save_info(take).ok());
  fs::resize_file(take.signal_path(), fs::file_size(take.signal_path()) - 30000);
  (void)must(recover_take(take.folder));
  const Take recovered = must(open_take(take.folder));
  EXPECT_EQ(recovered.info.frames, 95000);
  EXPECT_TRUE(recovered.info.samples_crc32.has_value());
  EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre());
  flip_bit(take.signal_path(), 1000);
  EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre("verify.checksum"));
}

TEST(Checksum, TakesWithoutOneAreStillTakes) {
  const test::TemporaryFolder folder;
  Take take = recorded(folder / "a.take");
  take.info.samples_crc32.reset();
  ASSERT_TRUE(save_info(take).ok());
  flip_bit(take.signal_path(), 1000);
  EXPECT_THAT(codes(must(verify_take(take.folder)).findings), ElementsAre());
}

TEST(Checksum, SurvivesWhatElseIsWrittenIntoTheTake) {
  const test::TemporaryFolder folder;
  Take take = recorded(folder / "a.take");
  take.info.calibration = calibrate::nominal_calibration(take.info.rig);
  ASSERT_TRUE(save_info(take).ok());
  EXPECT_EQ(must(open_take(take.folder)).info.samples_crc32, take.info.samples_crc32);
}

}  // namespace
}  // namespace limbwave::take
