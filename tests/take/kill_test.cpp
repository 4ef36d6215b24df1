// A recorder in a process of its own is killed (SIGKILL) at random instants.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <random>
#include <thread>

#include "support/temporary_folder.h"
#include "take/recorder.h"
#include "take/take_fixture.h"
#include "take/take_reader.h"

namespace limbwave::take {
namespace {

namespace fs = std::filesystem;
using std::chrono::microseconds;

const acquire::StreamFormat kFormat{SampleRate{48000.0}, 2, acquire::SampleType::kInt32};
constexpr std::int64_t kBlockFrames = 480;

// What the recording process tells before it dies.
struct Shared {
  std::atomic<bool> created{false};
  std::atomic<std::int64_t> handed_in{0};  // frames, counted before they are given to the recorder
};

class SharedMemory {
 public:
  SharedMemory()
      : memory_(::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
        shared_(new (memory_) Shared) {}
  ~SharedMemory() { ::munmap(memory_, sizeof(Shared)); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  Shared* operator->() const { return shared_; }

 private:
  void* memory_;
  Shared* shared_;
};

// Sample n of both channels is n, so that every frame tells where it belongs.
void fill(std::vector<std::byte>& block, std::int64_t first) {
  for (std::int64_t i = 0; i < kBlockFrames; ++i) {
    const std::int32_t pair[2] = {static_cast<std::int32_t>(first + i), static_cast<std::int32_t>(~(first + i))};
    std::memcpy(block.data() + 8 * i, pair, 8);
  }
}

// Records until it is killed: a block every `pace` (zero: as fast as the disk takes them), with events and with
// rewriting of take.json in between.
[[noreturn]] void record_until_killed(const fs::path& folder, const TakeInfo& info, microseconds pace,
                                      const SharedMemory& shared) {
  Result<std::unique_ptr<Recorder>> recorder = Recorder::create(folder, info);
  if (!recorder) {
    ::_exit(1);
  }
  shared->created = true;
  std::vector<std::byte> block(kBlockFrames * kFormat.bytes_per_frame());
  auto due = std::chrono::steady_clock::now();
  for (std::int64_t frames = 0;; frames += kBlockFrames) {
    std::this_thread::sleep_until(due);
    due += pace;
    fill(block, frames);
    shared->handed_in += kBlockFrames;
    const bool written = (*recorder)->write(block).ok();
    const bool noted = frames / kBlockFrames % 3 != 0 ||
                       (*recorder)->add_event({SampleIndex{frames}, "marker", "a marker", frames + 1}).ok();
    const bool saved = frames / kBlockFrames % 40 != 39 ||
                       (*recorder)->add_segment({"segment", SampleIndex{frames}, SampleCount{kBlockFrames}}).ok();
    if (!written || !noted || !saved) {
      ::_exit(1);
    }
  }
}

void check_samples(const Take& take) {
  TakeReader reader = must(TakeReader::open(take));
  std::vector<std::byte> raw(static_cast<std::size_t>(reader.frames()) * 8);
  ASSERT_EQ(must(reader.read_raw(SampleIndex{0}, raw)), static_cast<std::size_t>(reader.frames()));
  for (std::int64_t i = 0; i < reader.frames(); ++i) {
    std::int32_t pair[2];
    std::memcpy(pair, raw.data() + 8 * i, 8);
    ASSERT_EQ(pair[0], static_cast<std::int32_t>(i));
    ASSERT_EQ(pair[1], static_cast<std::int32_t>(~i));
  }
}

// One life of a recording: what is left must open, hold everything but the last second, and be mended.
void kill_after(microseconds life, microseconds pace) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "walk.take";
  const SharedMemory shared;
  const TakeInfo info = arm_info(kFormat);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    record_until_killed(path, info, pace, shared);
  }
  std::this_thread::sleep_for(life);
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status)) << "the recorder must not have failed by itself";

  if (!fs::exists(path)) {  // killed before the take had come into being: nothing was handed in
    ASSERT_FALSE(shared->created);
    ASSERT_EQ(shared->handed_in, 0);
    return;
  }
  const Result<Take> take = open_take(path);
  ASSERT_TRUE(take.ok()) << take.error().text();
  EXPECT_FALSE(take->info.complete);
  EXPECT_EQ(codes(take->diagnostics).front(), "take.not-closed");
  EXPECT_GE(take->info.frames, shared->handed_in - static_cast<std::int64_t>(kFormat.rate.hz))
      << "more than the last second is missing";
  EXPECT_LE(take->info.frames, shared->handed_in);
  check_samples(*take);
  for (const TakeEvent& event : take->events) {
    EXPECT_EQ(event.count, event.sample.value + 1);
  }

  const Result<Diagnostics> done = recover_take(path);
  ASSERT_TRUE(done.ok()) << done.error().text();
  const Take mended = must(open_take(path));
  EXPECT_TRUE(mended.info.complete);
  EXPECT_EQ(mended.info.frames, take->info.frames);
  EXPECT_THAT(codes(must(verify_take(path)).findings), testing::IsEmpty());
  check_samples(mended);
  SF_INFO header{};
  SNDFILE* file = sf_open(mended.signal_path().c_str(), SFM_READ, &header);
  ASSERT_NE(file, nullptr);
  sf_close(file);
  EXPECT_EQ(header.frames, mended.info.frames);
}

TEST(KilledRecorder, LeavesATakeThatOpensAtTenRandomInstants) {
  std::mt19937 random(std::random_device{}());
  std::uniform_int_distribution<int> life(0, 900'000);
  for (int i = 0; i < 10; ++i) {
    const microseconds instant(life(random));
    SCOPED_TRACE(testing::Message() << "killed after " << instant.count() << " us");
    kill_after(instant, std::chrono::milliseconds(10));  // 480 frames at 48 kHz: real time
  }
}

TEST(KilledRecorder, LeavesATakeThatOpensWhenKilledWhileItBegins) {
  std::mt19937 random(std::random_device{}());
  std::uniform_int_distribution<int> life(0, 12'000);
  for (int i = 0; i < 40; ++i) {
    const microseconds instant(life(random));
    SCOPED_TRACE(testing::Message() << "killed after " << instant.count() << " us");
    kill_after(instant, microseconds(0));
  }
}

TEST(KilledRecorder, LeavesATakeThatOpensWhenKilledUnderFullLoad) {
  std::mt19937 random(std::random_device{}());
  std::uniform_int_distribution<int> life(20'000, 300'000);
  for (int i = 0; i < 5; ++i) {
    const microseconds instant(life(random));
    SCOPED_TRACE(testing::Message() << "killed after " << instant.count() << " us");
    kill_after(instant, microseconds(200));
  }
}

}  // namespace
}  // namespace limbwave::take
