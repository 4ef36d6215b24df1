#include "take/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"
#include "take/take_reader.h"

namespace limbwave::take {
namespace {

namespace fs = std::filesystem;
using acquire::SampleType;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

const acquire::StreamFormat kFormat{SampleRate{48000.0}, 2, SampleType::kInt16};

std::vector<std::byte> raw_of(const Take& take) {
  TakeReader reader = must(TakeReader::open(take));
  std::vector<std::byte> raw(static_cast<std::size_t>(reader.frames()) * reader.format().bytes_per_frame());
  EXPECT_EQ(must(reader.read_raw(SampleIndex{0}, raw)), static_cast<std::size_t>(reader.frames()));
  return raw;
}

TEST(Recorder, ARecordingIsWholeAfterClosing) {
  const TemporaryFolder folder;
  const fs::path path = folder / "walk-01.take";
  for (const SampleType type : {SampleType::kInt16, SampleType::kInt24, SampleType::kInt32, SampleType::kFloat32}) {
    const acquire::StreamFormat format{SampleRate{96000.0}, 2, type};
    const std::vector<std::byte> raw = test::random_samples(format, 9600);
    std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(format)));
    const std::size_t half = 5000 * format.bytes_per_frame();
    ASSERT_TRUE(recorder->write(std::span(raw).first(half)).ok());
    ASSERT_TRUE(recorder->add_event({SampleIndex{4000}, "marker", "jump", 0}).ok());
    ASSERT_TRUE(recorder->write(std::span(raw).subspan(half)).ok());
    ASSERT_TRUE(recorder->add_segment({"capture", SampleIndex{100}, SampleCount{9000}}).ok());
    ASSERT_TRUE(recorder->set_calibration(calibrate::nominal_calibration(recorder->info().rig)).ok());
    EXPECT_EQ(recorder->frames(), 9600);
    EXPECT_DOUBLE_EQ(recorder->seconds(), 0.1);
    const Take take = must(recorder->close());
    EXPECT_TRUE(take.info.complete);
    EXPECT_EQ(take.info.frames, 9600);
    EXPECT_FALSE(take.info.created.empty());
    EXPECT_TRUE(take.info.calibration.has_value());
    EXPECT_THAT(codes(take.diagnostics), ElementsAre());
    ASSERT_EQ(take.events.size(), 1U);
    EXPECT_EQ(take.events[0].text, "jump");
    EXPECT_TRUE(raw_of(take) == raw);
    EXPECT_THAT(codes(must(verify_take(path)).findings), ElementsAre());
    EXPECT_THAT(codes(must(recover_take(path))), ElementsAre()) << "nothing to do";
    EXPECT_THAT(names_in(path), ElementsAre("events.jsonl", "signal.wav", "take.json"));
    EXPECT_FALSE(recorder->close().ok());
    EXPECT_FALSE(recorder->write(raw).ok());
    fs::remove_all(path);
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre());
}

TEST(Recorder, TheTakeOpensWhileItIsRecorded) {
  const TemporaryFolder folder;
  const fs::path path = folder / "new" / "walk.take/";
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(kFormat)));
  const std::vector<std::byte> raw = test::random_samples(kFormat, 4800);
  for (int block = 1; block <= 3; ++block) {
    ASSERT_TRUE(recorder->write(raw).ok());
    const Take take = must(open_take(path));
    EXPECT_FALSE(take.info.complete);
    EXPECT_EQ(take.info.frames, 4800 * block);
    EXPECT_THAT(codes(take.diagnostics), ElementsAre("take.recording"));
    EXPECT_EQ(must(TakeReader::open(take)).frames(), 4800 * block);
  }
  EXPECT_THAT(recover_take(path).error().text(), HasSubstr("is being recorded right now"));
  ASSERT_TRUE(recorder->close().ok());
  EXPECT_THAT(codes(must(open_take(path)).diagnostics), ElementsAre());
}

// Other programs may listen in: the header is behind by the interval of its updates at most.
TEST(Recorder, TheHeaderIsValidWhileRecording) {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.take";
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(kFormat)));
  const std::vector<std::byte> raw = test::random_samples(kFormat, 480);
  std::int64_t before = 0;
  for (int block = 0; block < 4; ++block) {
    before = recorder->frames();
    std::this_thread::sleep_for(std::chrono::milliseconds(250));  // so that the next write has to update it
    ASSERT_TRUE(recorder->write(raw).ok());
    SF_INFO info{};
    SNDFILE* file = sf_open((path / "signal.wav").c_str(), SFM_READ, &info);
    ASSERT_NE(file, nullptr);
    sf_close(file);
    EXPECT_EQ(info.frames, before + 480);
    EXPECT_EQ(info.channels, 2);
  }
}

TEST(Recorder, LeavingItClosesTheRecording) {
  const TemporaryFolder folder;
  {
    std::unique_ptr<Recorder> recorder = must(Recorder::create(folder / "x.take", arm_info(kFormat)));
    ASSERT_TRUE(recorder->write(test::random_samples(kFormat, 100)).ok());
  }
  EXPECT_TRUE(must(open_take(folder / "x.take")).info.complete);
}

TEST(Recorder, NeverOverwrites) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "x.take");
  EXPECT_THAT(Recorder::create(folder / "x.take", arm_info(kFormat)).error().text(), HasSubstr("exists already"));
  test::write_bytes(folder / "file", "mine");
  EXPECT_FALSE(Recorder::create(folder / "file", arm_info(kFormat)).ok());
  EXPECT_THAT(Recorder::create(folder / "file" / "x.take", arm_info(kFormat)).error().text(),
              HasSubstr("cannot be made"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("file", "x.take"));
  EXPECT_THAT(names_in(folder / "x.take"), ElementsAre());
}

TEST(Recorder, PublishedAtCloseIsThereAsAWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.take";
  RecorderSettings settings;
  settings.publish_at_close = true;
  {
    std::unique_ptr<Recorder> left = must(Recorder::create(path, arm_info(kFormat), settings));
    ASSERT_TRUE(left->write(test::random_samples(kFormat, 100)).ok());
    EXPECT_FALSE(fs::exists(path));
  }
  EXPECT_THAT(names_in(folder.path()), ElementsAre());
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(kFormat), settings));
  ASSERT_TRUE(recorder->write(test::random_samples(kFormat, 100)).ok());
  test::write_bytes(recorder->working_folder() / "truth.json", "{}");
  const Take take = must(recorder->close());
  EXPECT_EQ(take.folder, path);
  EXPECT_THAT(names_in(path), ElementsAre("events.jsonl", "signal.wav", "take.json", "truth.json"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("x.take"));
}

TEST(Recorder, AnotherTakeOfThatNameMeanwhileIsNotOverwritten) {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.take";
  RecorderSettings settings;
  settings.publish_at_close = true;
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(kFormat), settings));
  ASSERT_TRUE(recorder->write(test::random_samples(kFormat, 100)).ok());
  fs::create_directory(path);
  EXPECT_THAT(recorder->close().error().text(), HasSubstr("exists already"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("x.take"));
  EXPECT_THAT(names_in(path), ElementsAre());
}

TEST(Recorder, RemovesWhatAKilledOneLeftInTheMaking) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    RecorderSettings settings;
    settings.publish_at_close = true;
    auto recorder = Recorder::create(folder / "x.take", arm_info(kFormat), settings);
    ::_exit(recorder.ok() ? 0 : 1);  // as if killed: no destructor runs
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_THAT(names_in(folder.path()), ElementsAre(".x.take.part" + std::to_string(child)));
  std::unique_ptr<Recorder> recorder = must(Recorder::create(folder / "x.take", arm_info(kFormat)));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("x.take"));
}

TEST(Recorder, StopsCleanlyBeforeTheDiskIsFull) {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.take";
  constexpr std::uint64_t kMegabyte = 1 << 20;
  // A disk with 100 MB, of which 10 are to stay free.
  RecorderSettings settings;
  settings.keep_free_bytes = 10 * kMegabyte;
  settings.free_bytes = [&](const fs::path& where) {
    std::error_code code;
    const auto used = fs::file_size(where / "signal.wav", code);
    return 100 * kMegabyte - (code ? 0 : used);
  };
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(kFormat), settings));
  EXPECT_NEAR(recorder->disk_left_s(), 90.0 * kMegabyte / (48000 * 4), 1.0);
  const std::vector<std::byte> block(kMegabyte);
  Status status;
  int blocks = 0;
  while ((status = recorder->write(block))) {
    ASSERT_LT(++blocks, 200);
  }
  EXPECT_GE(blocks, 88);
  EXPECT_LE(blocks, 90);
  EXPECT_THAT(status.error().text(), HasSubstr("recording stopped because the disk is nearly full (1"));
  ASSERT_TRUE(recorder->stopped().has_value());
  EXPECT_FALSE(recorder->write(block).ok()) << "and stays stopped";
  EXPECT_LT(recorder->disk_left_s(), 2.0 * kMegabyte / (48000 * 4) + 1.0);
  const Take take = must(recorder->close());
  EXPECT_EQ(take.info.frames, blocks * static_cast<std::int64_t>(kMegabyte) / 4);
  EXPECT_THAT(codes(must(verify_take(path)).findings), ElementsAre());
}

TEST(Recorder, DoesNotBeginOnAFullDisk) {
  const TemporaryFolder folder;
  RecorderSettings settings;
  settings.free_bytes = [](const fs::path&) { return std::uint64_t{1} << 20; };
  EXPECT_THAT(Recorder::create(folder / "x.take", arm_info(kFormat), settings).error().text(),
              HasSubstr("the disk is nearly full (1 MB left)"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre());
}

TEST(Recorder, AWriteErrorLosesNothingThatWasWritten) {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.take";
  const std::vector<std::byte> raw = test::random_samples(kFormat, 100000);
  const TakeInfo info = arm_info(kFormat);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{600001, 600001};  // the disk takes one and a half blocks
    ::setrlimit(RLIMIT_FSIZE, &limit);
    auto recorder = Recorder::create(path, info);
    const bool first = recorder.ok() && (*recorder)->write(raw).ok();
    const bool second = (*recorder)->write(raw).ok();
    const bool closed = (*recorder)->close().ok();
    ::_exit(first && !second && closed ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  const Take take = must(open_take(path));
  EXPECT_TRUE(take.info.complete);
  EXPECT_GT(take.info.frames, 149900);
  EXPECT_LE(take.info.frames, 150000);
  std::vector<std::byte> kept = raw_of(take);
  EXPECT_TRUE(std::equal(raw.begin(), raw.end(), kept.begin()));
  EXPECT_TRUE(std::equal(kept.begin() + static_cast<std::ptrdiff_t>(raw.size()), kept.end(), raw.begin()));
  EXPECT_THAT(codes(must(verify_take(path)).findings), ElementsAre());
}

}  // namespace
}  // namespace limbwave::take
