#include "base/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Files, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  const std::string content("a\0b\n\xFF", 5);
  ASSERT_TRUE(write_file(folder / "x", content));
  const Result<std::string> read = read_file(folder / "x");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(*read, content);
  ASSERT_TRUE(write_file(folder / "x", ""));
  EXPECT_EQ(*read_file(folder / "x"), "");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(Files, ReadingSaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(read_file(folder / "none").error().text(), HasSubstr("none: cannot be read (No such file"));
  EXPECT_THAT(read_file(folder.path()).error().text(), HasSubstr("is a folder"));
  ASSERT_TRUE(write_file(folder / "x", "12345"));
  EXPECT_TRUE(read_file(folder / "x", 5).ok());
  EXPECT_THAT(read_file(folder / "x", 4).error().text(), HasSubstr("is too large"));
}

TEST(Files, ReadingAnEndlessFileStopsAtTheLimit) {
  EXPECT_THAT(read_file("/dev/zero", 100000).error().text(), HasSubstr("is too large"));
}

TEST(Files, WritingIntoNowhereSaysWhy) {
  const TemporaryFolder folder;
  const Status status = write_file(folder / "no" / "x", "content");
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().text(), HasSubstr("cannot be written (No such file"));
  EXPECT_THAT(write_file(folder.path(), "content").error().text(), HasSubstr("cannot be written"));
  EXPECT_EQ(entries(folder.path()), 0U);
}

TEST(Files, ThreadsThatSaveTheSameFileDoNotMixIt) {
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  std::atomic<int> failed{0};
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    threads.emplace_back([&, letter] {
      for (int i = 0; i < 25; ++i) {
        failed += write_file(folder / "x", std::string(200000, letter)).ok() ? 0 : 1;
        const Result<std::string> read = read_file(folder / "x");
        failed += read && *read == std::string(200000, read->front()) ? 0 : 1;
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(Files, FailedWritingKeepsTheOldContentAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "x", "old"));
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(write_file(folder / "x", std::string(100000, 'n')).ok() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << "writing beyond the limit must fail";
  EXPECT_EQ(*read_file(folder / "x"), "old");
  EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(Files, UserDataFolderFollowsTheEnvironment) {
  ::setenv("LIMBWAVE_HOME", "/somewhere", 1);
  EXPECT_EQ(user_data_folder(), "/somewhere");
  ::unsetenv("LIMBWAVE_HOME");
  ::setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(user_data_folder(), "/data/limbwave");
  ::unsetenv("XDG_DATA_HOME");
  ::setenv("HOME", "/home/anna", 1);
  EXPECT_EQ(user_data_folder(), "/home/anna/.local/share/limbwave");
}

}  // namespace
}  // namespace limbwave
