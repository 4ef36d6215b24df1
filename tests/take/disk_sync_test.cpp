/// What is recorded reaches the disk itself while the recording goes on, and never on the thread that writes.
#include "take/disk_sync.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"

namespace {

std::atomic<int> g_syncs{0};
std::atomic<int> g_syncs_of_main{0};

}  // namespace

// Takes the place of the C library's: counts, and does the same.
extern "C" int fdatasync(int file) {
  ++g_syncs;
  if (::syscall(SYS_gettid) == ::getpid()) {
    ++g_syncs_of_main;
  }
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}

namespace limbwave::take {
namespace {

using namespace std::chrono_literals;

const acquire::StreamFormat kFormat{SampleRate{48000.0}, 2, acquire::SampleType::kInt16};

TEST(DiskSync, ARecordingIsSyncedByAnotherThreadThanTheWriter) {
  const test::TemporaryFolder folder;
  RecorderSettings settings;
  settings.sync_interval = 10ms;
  const std::unique_ptr<Recorder> recorder = must(Recorder::create(folder / "a.take", arm_info(kFormat), settings));
  const std::vector<std::byte> raw = test::random_samples(kFormat, 480);
  g_syncs = 0;
  g_syncs_of_main = 0;
  while (g_syncs < 6) {  // three rounds of two files; the test's time limit ends it when that never happens
    ASSERT_TRUE(recorder->write(raw).ok());
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(g_syncs_of_main, 0);
  ASSERT_TRUE(recorder->close().ok());
  EXPECT_GE(g_syncs_of_main, 1) << "closing puts everything on the disk before it returns";
}

TEST(DiskSync, IsNotOftenerThanTheInterval) {
  const test::TemporaryFolder folder;
  RecorderSettings settings;
  settings.sync_interval = 1h;
  const std::unique_ptr<Recorder> recorder = must(Recorder::create(folder / "a.take", arm_info(kFormat), settings));
  const std::vector<std::byte> raw = test::random_samples(kFormat, 480);
  g_syncs = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(recorder->write(raw).ok());
  }
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(g_syncs, 0);
  ASSERT_TRUE(recorder->close().ok()) << "which does not wait for the interval";
}

TEST(DiskSync, DoesNothingWhileNothingIsWritten) {
  const test::TemporaryFolder folder;
  test::write_bytes(folder / "x", "content");
  g_syncs = 0;
  {
    const DiskSync sync({folder / "x", folder / "is-not-there"}, 1ms);
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_EQ(g_syncs, 0);
}

}  // namespace
}  // namespace limbwave::take
