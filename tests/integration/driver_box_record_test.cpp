// The emulator on a pseudo-terminal and the program that users run: whatever the line does, every sample is in its
// place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
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
  std::map<std::string, int> all;  // events by kind
};

// Every sample is the box's own of that index, or zero within an event that says so.
Kinds account(const take::Take& take, int& wrong_frames) {
  Kinds kinds;
  std::vector<std::pair<std::int64_t, std::int64_t>> gaps;
  std::vector<std::pair<std::int64_t, std::pair<int, bool>>> wires;
  for (const take::TakeEvent& event : take.events) {
    ++kinds.all[event.kind];
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

// One fault of every kind, at its time; each is told as itself.
TEST_F(DriverBoxRecord, EveryKindOfFaultIsToldOnceAndSurvived) {
  const fs::path faults = folder_.path() / "faults";
  std::ofstream(faults) << "# seconds fault\n"
                           "1.0 lose 5\n2.0 corrupt 3\n3.0 duplicate\n4.0 reorder\n"
                           "5.0 pull 3\n6.0 plug 3\n7.0 stall 3.0\n12.0 unplug 1.5\n";
  start({"--faults", faults.string()});
  const testing_support::CommandLine program(folder_.path());
  const auto outcome = program.run({"record", "each.take", "--driver-box", link_, "--seconds", "16", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  const auto take = take::open_take(folder_.path() / "each.take");
  ASSERT_TRUE(take.ok());
  int wrong = -1;
  Kinds kinds = account(*take, wrong);
  EXPECT_EQ(wrong, 0);
  // Whatever the emulator's log says was lost, and nothing else but what the terminal lost when it was unplugged.
  std::vector<std::pair<std::int64_t, std::int64_t>> lost;
  std::ifstream log(folder_.path() / "log");
  std::map<std::string, int> made;
  for (std::string line; std::getline(log, line);) {
    const auto fault = nlohmann::json::parse(line);
    ++made[fault["fault"].get<std::string>()];
    if (fault["fault"] == "lost" || fault["fault"] == "unsent") {
      lost.emplace_back(fault["first"].get<std::int64_t>(),
                        fault["first"].get<std::int64_t>() + fault["frames"].get<std::int64_t>());
    }
  }
  for (const take::TakeEvent& event : take->events) {
    for (std::int64_t at = event.sample.value; event.kind == "dropped" && at < event.sample.value + event.count;
         at += 280) {
      EXPECT_TRUE(std::any_of(lost.begin(), lost.end(), [&](const auto& stretch) {
        return at >= stretch.first && at < stretch.second;
      })) << at;
    }
  }
  EXPECT_EQ(kinds.all["duplicated"], made["duplicate"]);
  EXPECT_EQ(made["duplicate"], 1);
  EXPECT_EQ(kinds.all["reordered"], made["reorder"]);
  EXPECT_EQ(made["reorder"], 1);
  EXPECT_EQ(kinds.pulled, 1);
  EXPECT_EQ(kinds.back, 1);
  EXPECT_EQ(kinds.line_lost, 1);
  EXPECT_EQ(kinds.line_back, 1);
  EXPECT_GE(kinds.all["stall"], 1);
  EXPECT_EQ(kinds.all["stall"], kinds.all["stall-over"]);
  EXPECT_EQ(kinds.all["box-restarted"], 0);
  // lose, corrupt, stall beyond the box's memory, unplug: one gap each at least.
  EXPECT_GE(kinds.gaps, 4);
  EXPECT_EQ(json["reconnects"].get<int>(), 1);
}

// A box that was off has forgotten everything: the gap is by our clock, whole rounds of slots long, and what follows
// is what a box sends from its start.
TEST_F(DriverBoxRecord, ABoxThatWasOffGoesOnInItsSlots) {
  const fs::path faults = folder_.path() / "faults";
  std::ofstream(faults) << "2.0 reboot 1.0\n";
  start({"--faults", faults.string()});
  const testing_support::CommandLine program(folder_.path());
  const auto outcome = program.run({"record", "off.take", "--driver-box", link_, "--seconds", "6", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto take = take::open_take(folder_.path() / "off.take");
  ASSERT_TRUE(take.ok());
  std::int64_t again = -1;
  std::int64_t told = 0;
  for (const take::TakeEvent& event : take->events) {
    told += event.kind == "box-restarted" ? 1 : 0;
    again = event.kind == "dropped" ? event.sample.value + event.count : again;
  }
  EXPECT_EQ(told, 1);
  ASSERT_GT(again, 0);
  EXPECT_EQ(again % (8 * 1120), 0);
  // About as long as it was away, and longer by a round and what reconnecting takes.
  EXPECT_GT(again, static_cast<std::int64_t>(2.9 * 140000.0));
  auto reader = take::TakeReader::open(*take);
  ASSERT_TRUE(reader.ok());
  std::vector<std::int16_t> block(1120 * 18);
  Expected expected;
  for (std::int64_t slot = 0; slot < 20; ++slot) {
    const auto count = reader->read_raw(SampleIndex{again + 1120 * slot}, std::as_writable_bytes(std::span(block)));
    ASSERT_TRUE(count.ok());
    ASSERT_EQ(*count, 1120U);
    ASSERT_TRUE(std::equal(block.begin(), block.end(), expected.frame(1120 * slot))) << slot;
  }
}

// A program that ended without a word leaves the box running; the next one begins with sample 0 all the same.
TEST_F(DriverBoxRecord, ABoxThatWasLeftRunningBeginsAnew) {
  start({});
  {
    test::ChildProcess first({LIMBWAVE_PROGRAM, "record", (folder_.path() / "first.take").string(), "--driver-box",
                              link_, "--seconds", "60"},
                             {}, folder_.path() / "first.txt");
    std::this_thread::sleep_for(std::chrono::seconds(3));
    first.kill();
  }
  const testing_support::CommandLine program(folder_.path());
  const auto outcome = program.run({"record", "second.take", "--driver-box", link_, "--seconds", "2", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto take = take::open_take(folder_.path() / "second.take");
  ASSERT_TRUE(take.ok());
  int wrong = -1;
  (void)account(*take, wrong);
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(take->info.frames, 5 * 140000) << "nothing of the first run's count";
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
