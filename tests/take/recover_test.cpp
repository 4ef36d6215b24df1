// Takes that something has happened to: what opening, verifying and recovering make of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "acquire/wav_writer.h"
#include "base/files.h"
#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"
#include "take/take_reader.h"

namespace limbwave::take {
namespace {

namespace fs = std::filesystem;
using test::read_bytes;
using test::write_bytes;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class DamagedTake : public testing::Test {
 protected:
  void SetUp() override {
    std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(format)));
    ASSERT_TRUE(recorder->write(raw).ok());
    ASSERT_TRUE(recorder->add_event({SampleIndex{10}, "marker", "one", 1}).ok());
    ASSERT_TRUE(recorder->add_event({SampleIndex{20}, "marker", "two", 2}).ok());
    ASSERT_TRUE(recorder->close().ok());
    ASSERT_THAT(codes(must(verify_take(path)).findings), IsEmpty());
  }

  // As a crash leaves it: take.json says that it is being recorded.
  void leave_open() {
    Take take = must(open_take(path));
    take.info.complete = false;
    take.info.frames = 0;
    ASSERT_TRUE(save_info(take).ok());
  }

  void expect_whole(std::int64_t frames) {
    const Take take = must(open_take(path));
    EXPECT_TRUE(take.info.complete);
    EXPECT_EQ(take.info.frames, frames);
    EXPECT_THAT(codes(must(verify_take(path)).findings), IsEmpty());
    TakeReader reader = must(TakeReader::open(take));
    std::vector<std::byte> kept(static_cast<std::size_t>(frames) * format.bytes_per_frame());
    EXPECT_EQ(must(reader.read_raw(SampleIndex{0}, kept)), static_cast<std::size_t>(frames));
    EXPECT_TRUE(std::equal(kept.begin(), kept.end(), raw.begin()));
    const std::string header = acquire::wav_header(format, frames);
    EXPECT_EQ(read_bytes(signal).substr(0, header.size()), header);
    EXPECT_EQ(fs::file_size(signal), header.size() + kept.size());
    EXPECT_THAT(codes(must(recover_take(path))), IsEmpty()) << "nothing is left to do";
  }

  test::TemporaryFolder folder;
  fs::path path = folder / "x.take";
  fs::path signal = path / "signal.wav";
  acquire::StreamFormat format{SampleRate{48000.0}, 2, acquire::SampleType::kInt24};
  std::vector<std::byte> raw = test::random_samples(format, 5000);
  std::size_t header_size = acquire::wav_header(format, 0).size();
};

TEST_F(DamagedTake, NotATake) {
  EXPECT_THAT(open_take(folder / "none").error().text(), HasSubstr("does not exist"));
  EXPECT_THAT(open_take(signal).error().text(), HasSubstr("is a file, not the folder of a take"));
  EXPECT_THAT(open_take(folder.path()).error().text(), HasSubstr("is not a take"));
  EXPECT_FALSE(verify_take(folder.path()).ok());
  EXPECT_FALSE(recover_take(folder.path()).ok());
  EXPECT_THAT(names_in(folder.path()), ElementsAre("x.take"));
}

TEST_F(DamagedTake, LeftOpenWithAnExactHeader) {
  leave_open();
  const Take take = must(open_take(path));
  EXPECT_EQ(take.info.frames, 5000);
  EXPECT_THAT(codes(take.diagnostics), ElementsAre("take.not-closed"));
  EXPECT_THAT(take.diagnostics[0].message, HasSubstr("0.10 s are there"));
  EXPECT_THAT(codes(must(recover_take(path))), ElementsAre("recover.closed"));
  expect_whole(5000);
}

TEST_F(DamagedTake, LeftOpenWithAHeaderThatIsBehind) {
  leave_open();
  const std::string bytes = read_bytes(signal);
  write_bytes(signal, acquire::wav_header(format, 3000) + bytes.substr(header_size));
  EXPECT_EQ(must(open_take(path)).info.frames, 5000);
  EXPECT_THAT(codes(must(verify_take(path)).findings), Contains("verify.header"));
  EXPECT_THAT(codes(must(recover_take(path))), ElementsAre("recover.header", "recover.closed"));
  expect_whole(5000);
}

TEST_F(DamagedTake, LeftOpenInTheMiddleOfAFrame) {
  leave_open();
  fs::resize_file(signal, header_size + 4000 * 6 + 5);
  EXPECT_EQ(must(open_take(path)).info.frames, 4000);
  EXPECT_THAT(codes(must(recover_take(path))), Contains("recover.header"));
  expect_whole(4000);
}

TEST_F(DamagedTake, LeftOpenInTheMiddleOfTheHeader) {
  for (std::size_t size = 0; size <= header_size; ++size) {
    SCOPED_TRACE(size);
    leave_open();
    fs::resize_file(signal, size);
    const Take take = must(open_take(path));
    EXPECT_EQ(take.info.frames, 0);
    ASSERT_TRUE(recover_take(path).ok());
    EXPECT_EQ(read_bytes(signal), acquire::wav_header(format, 0));
  }
}

TEST_F(DamagedTake, LeftOpenWithAHeaderOfZeros) {
  leave_open();
  const std::string bytes = read_bytes(signal);
  write_bytes(signal, std::string(header_size, '\0') + bytes.substr(header_size));
  const Take take = must(open_take(path));
  EXPECT_EQ(take.info.frames, 5000);
  EXPECT_THAT(codes(take.diagnostics), Contains("take.header"));
  ASSERT_TRUE(recover_take(path).ok());
  expect_whole(5000);
}

TEST_F(DamagedTake, LeftOpenBeyondFourGigabytes) {
  leave_open();
  const std::int64_t frames = (std::int64_t{5} << 30) / 6;
  fs::resize_file(signal, header_size + static_cast<std::uint64_t>(frames) * 6);  // sparse
  EXPECT_EQ(must(open_take(path)).info.frames, frames);
  ASSERT_TRUE(recover_take(path).ok());
  const Take take = must(open_take(path));
  EXPECT_EQ(take.info.frames, frames);
  EXPECT_THAT(codes(take.diagnostics), IsEmpty());
  std::string start(header_size, '\0');
  std::ifstream(signal, std::ios::binary).read(start.data(), static_cast<std::streamsize>(header_size));
  EXPECT_EQ(start, acquire::wav_header(format, frames));
  TakeReader reader = must(TakeReader::open(take));
  std::vector<std::byte> first(raw.size());
  EXPECT_EQ(must(reader.read_raw(SampleIndex{0}, first)), 5000U);
  EXPECT_TRUE(first == raw);
  EXPECT_EQ(must(reader.read_raw(SampleIndex{frames - 1}, first)), 1U);
}

TEST_F(DamagedTake, WithoutTakeJson) {
  fs::remove(path / "take.json");
  const Take take = must(open_take(path));
  EXPECT_EQ(take.info.frames, 5000);
  EXPECT_EQ(take.info.format.type, format.type);
  EXPECT_THAT(codes(take.diagnostics), Contains("take.no-info"));
  EXPECT_THAT(codes(must(recover_take(path))), Contains("recover.rig"));
  expect_whole(5000);
}

TEST_F(DamagedTake, WithADamagedTakeJson) {
  write_bytes(path / "take.json", "{ \"schema\": 1, \"ki");
  EXPECT_THAT(open_take(path).error().text(), HasSubstr("take.json:1:"));
  ASSERT_TRUE(recover_take(path).ok());
  expect_whole(5000);
  EXPECT_EQ(read_bytes(path / "take.json.damaged"), "{ \"schema\": 1, \"ki");
}

TEST_F(DamagedTake, WithoutSamples) {
  fs::remove(signal);
  EXPECT_THAT(open_take(path).error().text(), HasSubstr("signal.wav: is missing"));
  EXPECT_FALSE(recover_take(path).ok());
}

TEST_F(DamagedTake, CompleteButShort) {
  fs::resize_file(signal, header_size + 4000 * 6);
  const Take take = must(open_take(path));
  EXPECT_EQ(take.info.frames, 4000);
  EXPECT_THAT(codes(take.diagnostics), ElementsAre("take.short"));
  EXPECT_THAT(codes(must(verify_take(path)).findings), Contains("take.short"));
  ASSERT_TRUE(recover_take(path).ok());
  expect_whole(4000);
}

TEST_F(DamagedTake, SamplesOfAnotherTake) {
  const acquire::StreamFormat other{SampleRate{44100.0}, 2, acquire::SampleType::kInt16};
  fs::remove(signal);
  must(acquire::WavWriter::create(signal, other));
  EXPECT_THAT(open_take(path).error().text(), HasSubstr("holds 2 channels at 44100 Hz with 4 bytes per frame"));
}

TEST_F(DamagedTake, EventsThatAreCutOffOrWrong) {
  std::string events = read_bytes(path / "events.jsonl");
  write_bytes(path / "events.jsonl", "{\"sample\": \"x\"}\n" + events + "{\"sample\":30,\"ki");
  const Take take = must(open_take(path));
  EXPECT_EQ(take.events.size(), 2U);
  EXPECT_THAT(codes(take.diagnostics), ElementsAre("take.event", "take.event-cut-off"));
  EXPECT_THAT(take.diagnostics[0].place, HasSubstr("events.jsonl:1: /sample"));
  EXPECT_THAT(take.diagnostics[1].place, HasSubstr("events.jsonl:4"));
  // An event that is added now does not glue to the one that was cut off.
  ASSERT_TRUE(append_event(path, {SampleIndex{40}, "marker", "three", 3}).ok());
  EXPECT_EQ(must(open_take(path)).events.size(), 3U);
}

TEST_F(DamagedTake, RecoverRemovesAnEventThatWasCutOff) {
  const std::string events = read_bytes(path / "events.jsonl");
  write_bytes(path / "events.jsonl", events + "{\"sample\":30,\"ki");
  write_bytes(path / "take.json.part123", "{");
  EXPECT_THAT(codes(must(recover_take(path))), ElementsAre("recover.events"));
  EXPECT_EQ(read_bytes(path / "events.jsonl"), events);
  EXPECT_FALSE(fs::exists(path / "take.json.part123"));
  write_bytes(path / "events.jsonl", events.substr(0, events.size() - 1));  // only the end of the line is missing
  ASSERT_TRUE(recover_take(path).ok());
  EXPECT_EQ(read_bytes(path / "events.jsonl"), events);
}

TEST_F(DamagedTake, VerifyChecksTheFilesAgainstEachOther) {
  Take take = must(open_take(path));
  take.info.segments = {{"capture", SampleIndex{4000}, SampleCount{2000}}};
  take.info.rig.accelerometers[0].segment = "tail";
  take.info.calibration = calibrate::nominal_calibration(take.info.rig);
  take.info.calibration->sensors.pop_back();
  take.info.calibration->mounts.pop_back();
  ASSERT_TRUE(save_info(take).ok());
  ASSERT_TRUE(append_event(path, {SampleIndex{5001}, "marker", "late", 0}).ok());
  write_bytes(path / "truth.json", "{");
  fs::create_directories(path / "solves" / "default");
  write_bytes(path / "solves" / "default" / "report.json", "");
  const std::vector<std::string> found = codes(must(verify_take(path)).findings);
  EXPECT_THAT(found, testing::UnorderedElementsAre("verify.segment", "verify.rig", "take.calibration", "verify.event",
                                                   "verify.file", "verify.file"));
}

TEST_F(DamagedTake, ACalibrationOfAnotherRigIsNotUsed) {
  const Take whole = must(open_take(path));
  const calibrate::RigCalibration nominal = calibrate::nominal_calibration(whole.info.rig);
  const auto opened_with = [&](const calibrate::RigCalibration& calibration) {
    Take take = whole;
    take.info.calibration = calibration;
    EXPECT_TRUE(save_info(take).ok());
    return must(open_take(path));
  };
  EXPECT_TRUE(opened_with(nominal).info.calibration.has_value());
  calibrate::RigCalibration fewer = nominal;
  fewer.sensors.resize(2);
  fewer.mounts.resize(2);
  calibrate::RigCalibration reordered = nominal;
  std::swap(reordered.sensors[0], reordered.sensors[1]);
  std::swap(reordered.mounts[0], reordered.mounts[1]);
  for (const calibrate::RigCalibration& wrong : {fewer, reordered}) {
    const Take take = opened_with(wrong);
    EXPECT_FALSE(take.info.calibration.has_value());
    EXPECT_THAT(codes(take.diagnostics), ElementsAre("take.calibration"));
    EXPECT_EQ(take.diagnostics.front().severity, Severity::kError);
    EXPECT_THAT(codes(must(verify_take(path)).findings), Contains("take.calibration"));
  }
  EXPECT_THAT(codes(must(recover_take(path))), Contains("recover.calibration"));
  expect_whole(5000);
}

TEST_F(DamagedTake, RecoverTellsWhichSegmentItShortened) {
  Take take = must(open_take(path));
  take.info.segments = {{"range", SampleIndex{0}, SampleCount{4000}},
                        {"capture", SampleIndex{4000}, SampleCount{1000}}};
  ASSERT_TRUE(save_info(take).ok());
  fs::resize_file(signal, header_size + 4500 * 6);
  const Diagnostics done = must(recover_take(path));
  EXPECT_THAT(done, testing::Contains(testing::AllOf(testing::Field(&Diagnostic::code, "recover.segment"),
                                                     testing::Field(&Diagnostic::message, HasSubstr("\"capture\"")))));
  EXPECT_EQ(must(open_take(path)).info.segments[1].count, SampleCount{500});
}

TEST_F(DamagedTake, RecoverPutsASolveBackThatWasBeingReplaced) {
  const fs::path solves = path / "solves";
  for (const char* name : {".first.old", ".second.part", ".third.old", "third"}) {
    fs::create_directories(solves / name);
    write_bytes(solves / name / "settings.json", "{}");
  }
  EXPECT_THAT(codes(must(recover_take(path))), ElementsAre("recover.solve"));
  EXPECT_THAT(names_in(solves), ElementsAre("first", "third"));
  EXPECT_TRUE(fs::exists(solves / "first" / "settings.json"));
}

// The superuser may list everything, so somebody else looks.
TEST_F(DamagedTake, VerifyTellsOfAFolderThatCannotBeListed) {
  const fs::path locked = path / "solves" / "default";
  fs::create_directories(locked);
  fs::permissions(locked, fs::perms::none);
  // The child keeps the superuser's group.
  fs::permissions(folder.path(), fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                     fs::perms::others_read | fs::perms::others_exec);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (::geteuid() == 0 && ::setuid(65534) != 0) {
      ::_exit(2);
    }
    const Result<VerifyReport> report = verify_take(path);
    const std::vector<std::string> found = report ? codes(report->findings) : std::vector<std::string>();
    ::_exit(std::find(found.begin(), found.end(), "verify.folder") != found.end() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  fs::permissions(locked, fs::perms::owner_all);
  ASSERT_TRUE(WIFEXITED(status)) << "an exception left verify_take";
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(DamagedTake, VerifyOnlyReads) {
  leave_open();
  fs::resize_file(signal, header_size + 4000 * 6 + 5);
  const std::string before = read_bytes(signal) + read_bytes(path / "take.json") + read_bytes(path / "events.jsonl");
  ASSERT_TRUE(verify_take(path).ok());
  EXPECT_EQ(read_bytes(signal) + read_bytes(path / "take.json") + read_bytes(path / "events.jsonl"), before);
  EXPECT_THAT(names_in(path), ElementsAre("events.jsonl", "signal.wav", "take.json"));
}

}  // namespace
}  // namespace limbwave::take
