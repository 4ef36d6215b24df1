/// A recording of an MP3 recorder becomes a BVH file that says where the arm really was; by the program that users run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "interchange/bvh_reader.h"
#include "support/command_line.h"
#include "support/simulated_take.h"

namespace limbwave {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing_support::CommandLine;
using testing_support::require;
using testing_support::TemporaryFolder;

class WavToBvh : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Motions, WavToBvh, ::testing::Values("arm-raise", "reach", "walk"));

TEST_P(WavToBvh, ThroughTheCommandLine) {
  const TemporaryFolder folder;
  const CommandLine limbwave(folder.path());
  ASSERT_EQ(
      limbwave.run({"simulate", "sim.take", "--motion", GetParam(), "--errors", "accurate", "--seed", "5"}).status, 0);
  // The recorder knows nothing of takes: only its WAV is taken over.
  std::filesystem::rename(folder / "sim.take/signal.wav", folder / "RECORD01.WAV");
  const auto imported = limbwave.run({"import", "walk.take", "RECORD01.WAV"});
  ASSERT_EQ(imported.status, 0) << imported.errors;

  // Where the movements are, the operator knows.
  std::ifstream info_file(folder / "sim.take/take.json");
  const nlohmann::json info = nlohmann::json::parse(info_file);
  const double rate = 48000.0;
  const auto times = [&](const std::string& name) {
    for (const nlohmann::json& segment : info.at("segments")) {
      if (segment.at("name") == name) {
        const double first = segment.at("first").get<double>() / rate;
        const double count = segment.at("count").get<double>() / rate;
        return std::pair{std::to_string(first), std::to_string(first + count)};
      }
    }
    ADD_FAILURE() << "no segment " << name;
    return std::pair{std::string("0"), std::string("1")};
  };
  const auto range = times("range");
  const auto ranged = limbwave.run({"calibrate", "range", "walk.take", "--from", range.first, "--to", range.second});
  ASSERT_EQ(ranged.status, 0) << ranged.errors << ranged.output;
  for (const std::string group : {"Right arm", "Torso"}) {
    const auto first = times("pose:" + group + ":first");
    const auto second = times("pose:" + group + ":second");
    const auto limb = limbwave.run({"calibrate", "limb", "walk.take", "--group", group, "--from", first.first, "--to",
                                    first.second, "--second-from", second.first, "--second-to", second.second});
    ASSERT_EQ(limb.status, 0) << limb.errors << limb.output;
  }
  const auto solved = limbwave.run({"solve", "walk.take"});
  ASSERT_EQ(solved.status, 0) << solved.errors;
  const auto exported = limbwave.run({"export", "walk.take", "-o", "walk.bvh", "--fps", "30"});
  ASSERT_EQ(exported.status, 0) << exported.errors;

  const motion::Clip clip = require(interchange::load_bvh(folder / "walk.bvh"));
  EXPECT_GE(clip.joints.size(), 5U);
  EXPECT_NEAR(clip.frame_rate_hz, 30.0, 1e-3);
  // The same through the truth's own take: world inclinations agree with what was simulated.
  std::filesystem::rename(folder / "RECORD01.WAV", folder / "sim.take/signal.wav");
  ASSERT_EQ(limbwave.run({"solve", "sim.take"}).status, 0);
  const auto evaluated = limbwave.run({"evaluate", "sim.take", "--json", "-"});
  ASSERT_EQ(evaluated.status, 0) << evaluated.errors;
  const nlohmann::json figures = nlohmann::json::parse(evaluated.output);
  EXPECT_LT(figures.at("all").at("inclination_mean_deg").get<double>(), 3.0);
  const auto csv = limbwave.run({"export", "sim.take", "-o", "poses.csv"});
  EXPECT_EQ(csv.status, 0) << csv.errors;
}

TEST(CommandLineErrors, MalformedRecordingsGetOneLineAndExitOne) {
  const TemporaryFolder folder;
  const CommandLine limbwave(folder.path());
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  write("empty.wav", "");
  write("text.wav", "this is not a recording at all, it only has the name of one");
  write("riff.wav", std::string("RIFF\x24\0\0\0WAVE", 12));
  const auto header = [](int channels, unsigned rate, int format, int bits, unsigned data) {
    std::string h = "RIFF";
    const auto u32 = [&](unsigned v) { h.append(reinterpret_cast<const char*>(&v), 4); };
    const auto u16 = [&](int v) {
      const auto s = static_cast<unsigned short>(v);
      h.append(reinterpret_cast<const char*>(&s), 2);
    };
    u32(36 + data);
    h += "WAVEfmt ";
    u32(16);
    u16(format);
    u16(channels);
    u32(rate);
    u32(rate * static_cast<unsigned>(channels * bits / 8));
    u16(channels * bits / 8);
    u16(bits);
    h += "data";
    u32(data);
    return h;
  };
  write("zero_channels.wav", header(0, 48000, 1, 16, 4000) + std::string(4000, '\0'));
  write("mono.wav", header(1, 48000, 1, 16, 4000) + std::string(4000, '\0'));
  write("slow.wav", header(2, 3, 1, 16, 4000) + std::string(4000, '\0'));
  write("fast.wav", header(2, 4000000000U, 1, 16, 4000) + std::string(4000, '\0'));
  write("truncated.wav", header(2, 48000, 1, 16, 400000) + std::string(1000, '\0'));
  std::string nans;
  for (int i = 0; i < 2000; ++i) {
    nans += std::string("\x00\x00\xc0\x7f", 4);
  }
  write("nan.wav", header(2, 48000, 3, 32, 8000) + nans);
  for (const char* name : {"empty.wav", "text.wav", "riff.wav", "zero_channels.wav", "mono.wav", "slow.wav", "fast.wav",
                           "truncated.wav", "nan.wav", "missing.wav", "."}) {
    const auto result = limbwave.run({"import", "x.take", name});
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_THAT(result.errors, StartsWith("limbwave: ")) << name;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << name << ": " << result.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "x.take")) << name;
  }
}

TEST(CommandLineErrors, WrongUseSaysWhatIsWrong) {
  const TemporaryFolder folder;
  const CommandLine limbwave(folder.path());
  EXPECT_EQ(limbwave.run({"solve", "nowhere.take"}).status, 1);
  EXPECT_THAT(limbwave.run({"solve", "nowhere.take"}).errors, HasSubstr("nowhere.take"));
  EXPECT_EQ(limbwave.run({"frobnicate"}).status, 2);
  EXPECT_EQ(limbwave.run({"--help"}).status, 0);
  for (const char* command : {"devices", "record", "import", "calibrate", "solve", "export", "simulate", "evaluate",
                              "info", "verify", "recover"}) {
    const auto help = limbwave.run({command, "--help"});
    EXPECT_EQ(help.status, 0) << command;
    if (std::string(command) != "calibrate") {
      EXPECT_THAT(help.output, HasSubstr("Example: ")) << command;
    }
  }
  const auto errors = limbwave.run({"simulate", "x.take", "--errors", "no-such-profile"});
  EXPECT_EQ(errors.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "x.take"));
}

}  // namespace
}  // namespace limbwave
