// A serial line on a pseudo-terminal: the other end is ours.
#include "acquire/serial_line.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <numeric>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace limbwave::acquire {
namespace {

class SerialLineTest : public testing::Test {
 protected:
  void SetUp() override {
    char name[256] = {};
    ASSERT_EQ(::openpty(&master_, &slave_, name, nullptr, nullptr), 0);
    path_ = name;
  }
  void TearDown() override { hang_up(); }
  void hang_up() {
    for (int* end : {&master_, &slave_}) {
      if (*end >= 0) {
        ::close(*end);
        *end = -1;
      }
    }
  }
  int master_ = -1, slave_ = -1;
  std::string path_;
};

// As many bytes as are wanted, or what came until the line was quiet for long.
std::vector<std::byte> read_all(SerialLine& line, std::size_t wanted) {
  std::vector<std::byte> all;
  std::vector<std::byte> some(4096);
  for (int quiet = 0; all.size() < wanted && quiet < 500;) {
    const int got = line.read(some);
    if (got < 0) {
      break;
    }
    quiet = got == 0 ? quiet + 1 : 0;
    all.insert(all.end(), some.begin(), some.begin() + got);
  }
  return all;
}

// Every byte as it is: no echo, no line ends translated, none taken for an interrupt.
TEST_F(SerialLineTest, EveryByteArrivesAsItIsInBothDirections) {
  auto line = SerialLine::open(path_);
  ASSERT_TRUE(line.ok());
  std::vector<std::byte> all(256 * 40);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<std::byte>((i + i / 256) % 256);
  }
  std::thread other([&] {
    for (std::size_t done = 0; done < all.size();) {
      const ssize_t put = ::write(master_, all.data() + done, all.size() - done);
      done += put > 0 ? static_cast<std::size_t>(put) : 0;
    }
  });
  EXPECT_EQ(read_all(**line, all.size()), all);
  other.join();

  std::vector<std::byte> got;
  std::thread reader([&] {
    std::vector<std::byte> some(4096);
    while (got.size() < all.size()) {
      const ssize_t count = ::read(master_, some.data(), some.size());
      if (count <= 0) {
        break;
      }
      got.insert(got.end(), some.begin(), some.begin() + count);
    }
  });
  EXPECT_TRUE((*line)->write(all));
  reader.join();
  EXPECT_EQ(got, all);
}

TEST_F(SerialLineTest, AQuietLineIsNoLostLine) {
  auto line = SerialLine::open(path_);
  ASSERT_TRUE(line.ok());
  std::vector<std::byte> some(16);
  EXPECT_EQ((*line)->read(some), 0);
}

TEST_F(SerialLineTest, AnEndThatWasPulledIsTold) {
  auto line = SerialLine::open(path_);
  ASSERT_TRUE(line.ok());
  hang_up();
  std::vector<std::byte> some(16);
  int got = 0;
  for (int i = 0; i < 100 && got == 0; ++i) {
    got = (*line)->read(some);
  }
  EXPECT_LT(got, 0);
  EXPECT_FALSE((*line)->write(some));
}

// A box that does not listen holds nobody up for ever.
TEST_F(SerialLineTest, WritingToWhoDoesNotReadEnds) {
  auto line = SerialLine::open(path_);
  ASSERT_TRUE(line.ok());
  EXPECT_FALSE((*line)->write(std::vector<std::byte>(1 << 20)));
}

TEST_F(SerialLineTest, ALinkToATerminalIsFollowed) {
  const test::TemporaryFolder folder;
  std::filesystem::create_symlink(path_, folder.path() / "box");
  auto line = SerialLine::open((folder.path() / "box").string());
  ASSERT_TRUE(line.ok());
  const std::byte sent{42};
  ASSERT_EQ(::write(master_, &sent, 1), 1);
  EXPECT_EQ(read_all(**line, 1), std::vector<std::byte>{sent});
}

TEST(SerialLine, WhatIsNoPortIsNamed) {
  for (const char* name : {"/dev/nothing-there", "/dev/pts/999999", "", "/etc/hostname"}) {
    const auto line = SerialLine::open(name);
    ASSERT_FALSE(line.ok()) << name;
    EXPECT_THAT(line.error().text(), testing::HasSubstr(name));
    EXPECT_FALSE(line.error().remedy.empty());
  }
}

}  // namespace
}  // namespace limbwave::acquire
