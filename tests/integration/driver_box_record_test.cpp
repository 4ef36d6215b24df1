// The emulator on a pseudo-terminal and the program that users run: whatever the line does, every sample is in its
// place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "simulate/driver_box_stream.h"
#include "support/child_process.h"
#include "support/command_line.h"
#include "support/temporary_folder.h"
#include "take/take.h"
#include "take/take_reader.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 7;

// What the emulator sends, made anew.
class Expected {
 public:
  Expected() {
    const auto rig = body::load_rig("driver-box-body");
    const auto skeleton = body::load_skeleton(rig->skeleton);
    const auto errors = simulate::load_driver_box_errors("calibrated");
    const auto actor = simulate::DriverBoxActor::create("walk", 0.0, *rig, *skeleton, *errors, kSeed);
    stream_ = std::make_unique<simulate::DriverBoxStream>(*rig, *actor, *errors, 22.0, kSeed);
    slot_.resize(static_cast<std::size_t>(stream_->slot_samples() * stream_->wires()));
  }
  const std::int16_t* frame(std::int64_t index) {
    while (index >= end_) {
      stream_->next_slot(slot_);
      end_ = stream_->position();
    }
    return slot_.data() + (index - (end_ - stream_->slot_samples())) * stream_->wires();
  }

 private:
  std::unique_ptr<simulate::DriverBoxStream> stream_;
  std::vector<std::int16_t> slot_;
  std::int64_t end_ = 0;
};

struct Kinds {
  std::int64_t gaps = 0, lost = 0, line_lost = 0, line_back = 0, pulled = 0, back = 0;
};

// Every sample is the box's own of that index, or zero within an event that says so.
Kinds account(const take::Take& take, int& wrong_frames) {
  Kinds kinds;
  std::vector<std::pair<std::int64_t, std::int64_t>> gaps;
  std::vector<std::pair<std::int64_t, std::pair<int, bool>>> wires;
  for (const take::TakeEvent& event : take.events) {
    if (event.kind == "dropped") {
      gaps.emplace_back(event.sample.value, event.sample.value + event.count);
      ++kinds.gaps;
      kinds.lost += event.count;
    }
    kinds.line_lost += event.kind == "line-lost" ? 1 : 0;
    kinds.line_back += event.kind == "line-back" ? 1 : 0;
    if (event.kind == "wire-pulled" || event.kind == "wire-back") {
      const bool pulled = event.kind == "wire-pulled";
      (pulled ? kinds.pulled : kinds.back) += 1;
      wires.emplace_back(event.sample.value, std::pair{static_cast<int>(event.count), pulled});
    }
  }
  auto reader = take::TakeReader::open(take);
  EXPECT_TRUE(reader.ok());
  Expected expected;
  const auto channels = static_cast<std::size_t>(take.info.format.channels);
  std::vector<std::int16_t> block(2800 * channels);
  std::uint64_t pulled = 0;
  std::size_t next_wire = 0;
  wrong_frames = 0;
  for (std::int64_t at = 0;;) {
    const auto count = reader->read_raw(SampleIndex{at}, std::as_writable_bytes(std::span(block)));
    EXPECT_TRUE(count.ok());
    if (!count || *count == 0) {
      break;
    }
    for (std::size_t i = 0; i < *count; ++i, ++at) {
      while (next_wire < wires.size() && wires[next_wire].first <= at) {
        const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(wires[next_wire].second.first);
        pulled = wires[next_wire].second.second ? pulled | bit : pulled & ~bit;
        ++next_wire;
      }
      const bool gone =
          std::any_of(gaps.begin(), gaps.end(), [&](const auto& gap) { return at >= gap.first && at < gap.second; });
      const std::int16_t* sent = expected.frame(at);
      bool same = true;
      for (std::size_t w = 0; w < channels; ++w) {
        const bool silent = gone || ((pulled >> w) & 1U) != 0;
        same = same && block[i * channels + w] == (silent ? 0 : sent[w]);
      }
      wrong_frames += same ? 0 : 1;
    }
  }
  return kinds;
}

class DriverBoxRecord : public testing::Test {
 protected:
  void start(const std::vector<std::string>& more) {
    link_ = (folder_.path() / "box").string();
    std::vector<std::string> arguments{LIMBWAVE_EMULATOR,
                                       "--motion",
                                       "walk",
                                       "--errors",
                                       "calibrated",
                                       "--seed",
                                       std::to_string(kSeed),
                                       "--link",
                                       link_,
                                       "--log",
                                       (folder_.path() / "log").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    emulator_ = std::make_unique<test::ChildProcess>(arguments, std::map<std::string, std::string>{},
                                                     folder_.path() / "emulator.txt");
    for (int i = 0; i < 300 && !fs::exists(fs::symlink_status(link_)); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }

  test::TemporaryFolder folder_;
  std::string link_;
  std::unique_ptr<test::ChildProcess> emulator_;
};

TEST_F(DriverBoxRecord, AQuietLineLosesNothing) {
  start({});
  const testing_support::CommandLine program(folder_.path());
  const auto outcome = program.run({"record", "quiet.take", "--driver-box", link_, "--seconds", "3", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_GE(json["seconds"].get<double>(), 3.0);
  const auto take = take::open_take(folder_.path() / "quiet.take");
  ASSERT_TRUE(take.ok());
  EXPECT_EQ(take->info.kind, "driver-box");
  int wrong = -1;
  const Kinds kinds = account(*take, wrong);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(kinds.gaps, json["gaps"].get<std::int64_t>());
}

TEST_F(DriverBoxRecord, EveryFaultIsAGapOfKnownLengthAndNeverAShift) {
  start({"--faults-every", "0.6"});
  const testing_support::CommandLine program(folder_.path());
  const auto outcome = program.run({"record", "rough.take", "--driver-box", link_, "--seconds", "25", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  const auto take = take::open_take(folder_.path() / "rough.take");
  ASSERT_TRUE(take.ok());
  int wrong = -1;
  const Kinds kinds = account(*take, wrong);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(kinds.gaps, 2);
  EXPECT_EQ(kinds.gaps, json["gaps"].get<std::int64_t>());
  EXPECT_EQ(kinds.lost, json["lost_frames"].get<std::int64_t>());
  EXPECT_EQ(kinds.line_lost - kinds.line_back, 0);
  EXPECT_EQ(kinds.line_back, json["reconnects"].get<std::int64_t>());
  std::printf("%s\n", json.dump().c_str());
}

TEST_F(DriverBoxRecord, ANamedErrorWhereNoBoxIs) {
  const testing_support::CommandLine program(folder_.path());
  const auto outcome = program.run({"record", "none.take", "--driver-box", "/dev/nothing-there", "--seconds", "1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, testing::HasSubstr("/dev/nothing-there"));
  EXPECT_FALSE(fs::exists(folder_.path() / "none.take"));
}

}  // namespace
}  // namespace limbwave
