/// `limbwave record` from a sound server that dies: what was recorded is kept, and scripts are told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "support/command_line.h"
#include "support/pulse_server.h"
#include "support/temporary_folder.h"
#include "take/take.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;

TEST(RecordDeviceLoss, ExitsWithAnErrorAndKeepsTheTake) {
  std::string why_not;
  if (!test::PulseServer::available(why_not)) {
    GTEST_SKIP() << why_not;
  }
  const test::TemporaryFolder folder;
  test::PulseServer server(48000);
  const testing_support::CommandLine limbwave(folder.path());
  const pid_t recording =
      limbwave.start({"record", "dead.take", "--device", test::PulseServer::capture_id(), "--seconds", "300"});
  const fs::path signal = folder / "dead.take" / "signal.wav";
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(100);
  std::error_code code;
  while (!(fs::file_size(signal, code) > 100000 && !code)) {
    ASSERT_LT(std::chrono::steady_clock::now(), until) << "nothing is recorded";
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  server.stop();
  const auto outcome = limbwave.wait(recording);
  EXPECT_EQ(outcome.status, 1) << outcome.output << outcome.errors;
  EXPECT_THAT(outcome.errors, testing::HasSubstr("stopped giving samples"));
  const Result<take::Take> take = take::open_take(folder / "dead.take");
  ASSERT_TRUE(take.ok()) << take.error().text();
  EXPECT_TRUE(take->info.complete);
  EXPECT_GT(take->info.frames, 20000);
  EXPECT_TRUE(std::any_of(take->events.begin(), take->events.end(),
                          [](const take::TakeEvent& event) { return event.kind == "source.gone"; }));
}

}  // namespace
}  // namespace limbwave
