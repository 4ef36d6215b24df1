/// Recording survives the end of the program at any instant.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <random>
#include <thread>

#include "support/command_line.h"
#include "support/simulated_take.h"

namespace limbwave {
namespace {

using testing_support::CommandLine;
using testing_support::TemporaryFolder;

TEST(KilledRecording, OpensAndLacksAtMostTheLastSecond) {
  std::mt19937 random(20261122);
  std::uniform_real_distribution<double> instant(0.2, 4.0);
  for (int run = 0; run < 10; ++run) {
    const TemporaryFolder folder;
    const CommandLine limbwave(folder.path());
    const std::filesystem::path take_folder = folder / "killed.take";
    const pid_t child = limbwave.start({"record", "killed.take", "--device", "simulator:wave"});
    ASSERT_GT(child, 0);
    // The instant counts from the first sample on disk, so that the start-up time of the program does not matter.
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    std::error_code code;
    while (!(std::filesystem::file_size(take_folder / "signal.wav", code) > 4096 && !code) &&
           std::chrono::steady_clock::now() < patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const auto begin = std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::chrono::duration<double>(instant(random)));
    ::kill(child, SIGKILL);
    const double ran = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    EXPECT_EQ(limbwave.wait(child).status, 128 + SIGKILL);

    const Result<take::Take> take = take::open_take(take_folder);
    ASSERT_TRUE(take.ok()) << take.error().text();
    const double kept = static_cast<double>(take->info.frames) / take->info.format.rate.hz;
    EXPECT_GE(kept, ran - 1.0) << "run " << run << " of " << ran << " s";
    EXPECT_FALSE(take->info.complete);
    ASSERT_EQ(limbwave.run({"recover", "killed.take"}).status, 0);
    EXPECT_EQ(limbwave.run({"verify", "killed.take"}).status, 0);
  }
}

TEST(Recording, EndsProperlyOnInterrupt) {
  const TemporaryFolder folder;
  const CommandLine limbwave(folder.path());
  const pid_t child = limbwave.start({"record", "walk.take", "--device", "simulator:walk"});
  std::error_code code;
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!(std::filesystem::file_size(folder / "walk.take/signal.wav", code) > 100000 && !code) &&
         std::chrono::steady_clock::now() < patience) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(child, SIGINT);
  const auto outcome = limbwave.wait(child);
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(limbwave.run({"verify", "walk.take"}).status, 0);
}

}  // namespace
}  // namespace limbwave
