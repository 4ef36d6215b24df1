/// What scripts rely on: exit codes, one line for every error, names with spaces and umlauts, nothing half-written.
#include "support/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/files.h"
#include "support/audio_files.h"
#include "support/temporary_folder.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing_support::CommandLine;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (const std::string name = entry.path().filename().string(); name != ".stdout" && name != ".stderr") {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

void expect_one_line(const CommandLine::Outcome& outcome) {
  EXPECT_THAT(outcome.errors, AllOf(StartsWith("limbwave: "), EndsWith("\n")));
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
}

std::string stereo_wav(int frames) {
  return test::WavBytes{.data = std::string(static_cast<std::size_t>(frames) * 4, '\x11')}.bytes();
}

class CommandLineContract : public testing::Test {
 protected:
  const test::TemporaryFolder folder;
  const CommandLine limbwave{folder.path()};
};

TEST_F(CommandLineContract, NamesMayHaveSpacesAndUmlauts) {
  ASSERT_EQ(limbwave.run({"simulate", "Größe 1.take", "--motion", "wave", "--seconds", "2"}).status, 0);
  ASSERT_EQ(limbwave.run({"solve", "Größe 1.take", "--name", "zweiter Versuch ä"}).status, 0);
  for (const char* output : {"Über den Zaun.bvh", "Über den Zaun.GLB", "Über den Zaun.csv"}) {
    EXPECT_EQ(limbwave.run({"export", "Größe 1.take", "--solve", "zweiter Versuch ä", "-o", output}).status, 0);
    EXPECT_TRUE(fs::exists(folder / output)) << output;
  }
  EXPECT_EQ(limbwave.run({"export", "Über den Zaun.GLB", "-o", "b.BVH"}).status, 0);
  const auto info = limbwave.run({"info", "Größe 1.take", "--json"});
  EXPECT_THAT(nlohmann::json::parse(info.output).at("solves"), testing::ElementsAre("zweiter Versuch ä"));
  EXPECT_EQ(
      limbwave.run({"evaluate", "Größe 1.take", "--solve", "zweiter Versuch ä", "--json", "Zahlen ö.json"}).status, 0);
  std::ifstream figures(folder / "Zahlen ö.json");
  EXPECT_TRUE(nlohmann::json::parse(figures).contains("all"));
}

TEST_F(CommandLineContract, ReportsAreJsonWhenAsked) {
  test::write_bytes(folder / "a.wav", stereo_wav(48000));
  const auto imported = limbwave.run({"import", "a.take", "a.wav", "--json"});
  EXPECT_EQ(imported.status, 0);
  EXPECT_EQ(nlohmann::json::parse(imported.output).at("frames"), 48000);
  const auto verified = limbwave.run({"verify", "a.take", "--json"});
  EXPECT_EQ(verified.status, 0);
  EXPECT_EQ(nlohmann::json::parse(verified.output).at("whole"), true);
  const auto recorded = limbwave.run({"record", "b.take", "--device", "simulator:wave", "--seconds", "0.3", "--json"});
  EXPECT_EQ(recorded.status, 0);
  EXPECT_GE(nlohmann::json::parse(recorded.output).at("seconds").get<double>(), 0.3);
  const auto devices = limbwave.run({"devices", "--json"});
  EXPECT_TRUE(nlohmann::json::parse(devices.output).contains("devices"));
}

TEST_F(CommandLineContract, ARecordingThatBreaksOffIsTakenOnlyWhenAsked) {
  test::write_bytes(folder / "cut.wav", stereo_wav(96000).substr(0, 44 + 4 * 30000));
  const auto refused = limbwave.run({"import", "a.take", "cut.wav"});
  EXPECT_EQ(refused.status, 1);
  expect_one_line(refused);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("cut off"), HasSubstr("--accept-truncated")));
  EXPECT_FALSE(fs::exists(folder / "a.take"));
  const auto taken = limbwave.run({"import", "a.take", "cut.wav", "--accept-truncated"});
  EXPECT_EQ(taken.status, 0) << taken.errors;
  EXPECT_THAT(taken.errors, HasSubstr("promises 2.0 s, but 0.6 s are there"));
  const auto info = nlohmann::json::parse(limbwave.run({"info", "a.take", "--json"}).output);
  EXPECT_EQ(info.at("frames"), 30000);
  EXPECT_EQ(info.at("events").size(), 1U) << "the take remembers";
}

TEST_F(CommandLineContract, ChangedSamplesAreFound) {
  test::write_bytes(folder / "a.wav", stereo_wav(48000));
  ASSERT_EQ(limbwave.run({"import", "a.take", "a.wav"}).status, 0);
  EXPECT_EQ(limbwave.run({"verify", "a.take"}).status, 0);
  std::string bytes = test::read_bytes(folder / "a.take/signal.wav");
  bytes[bytes.size() / 2] = '\x12';
  test::write_bytes(folder / "a.take/signal.wav", bytes);
  const auto verified = limbwave.run({"verify", "a.take"});
  EXPECT_EQ(verified.status, 1);
  EXPECT_THAT(verified.errors, HasSubstr("the samples are not those that were recorded"));
}

TEST_F(CommandLineContract, WrongUseIsTwoAndNamesTheCommandsHelp) {
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"frobnicate"},
                                                    {"solve"},
                                                    {"solve", "a.take", "--method", "magic"},
                                                    {"solve", "a.take", "b.take"},
                                                    {"record", "a.take", "--rate", "fast"},
                                                    {"calibrate"},
                                                    {"export", "a.take"}};
  for (const std::vector<std::string>& arguments : wrong) {
    const auto outcome = limbwave.run(arguments);
    EXPECT_EQ(outcome.status, 2);
    expect_one_line(outcome);
    const bool known = !arguments.empty() && arguments[0] != "frobnicate";
    EXPECT_THAT(outcome.errors, HasSubstr(known ? "see limbwave " + arguments[0] + " --help" : "see limbwave --help"));
    EXPECT_THAT(names_in(folder.path()), testing::IsEmpty());
  }
}

TEST_F(CommandLineContract, WhatCannotBeWrittenIsOneLineAndLeavesNothing) {
  test::write_bytes(folder / "a.wav", stereo_wav(48000));
  ASSERT_EQ(limbwave.run({"import", "a.take", "a.wav"}).status, 0);
  test::write_bytes(folder / "file", "no folder");  // also root cannot make anything below a file
  const std::vector<std::vector<std::string>> commands{
      {"import", "file/b.take", "a.wav"},
      {"simulate", "file/b.take", "--motion", "wave", "--seconds", "1"},
      {"record", "file/b.take", "--device", "simulator:wave", "--seconds", "1"},
      {"solve", "missing.take"},
      {"export", "a.take", "-o", "b.bvh"},  // it has no solve
      {"export", "a.take", "-o", "b.doc"},
      {"info", "file"},
      {"verify", "missing.take"},
      {"recover", "file"},
      {"evaluate", "a.take"},
      {"calibrate", "range", "missing.take"}};
  for (const std::vector<std::string>& arguments : commands) {
    const auto outcome = limbwave.run(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments[0] << " " << arguments[1];
    expect_one_line(outcome);
    EXPECT_THAT(names_in(folder.path()), testing::IsSubsetOf({"a.take", "a.wav", "file", "home"}));
  }
}

TEST_F(CommandLineContract, CalibrationSaysWhatItLacksAndKeepsNothingOfAFailure) {
  test::write_bytes(folder / "a.wav", stereo_wav(96000));
  ASSERT_EQ(limbwave.run({"import", "a.take", "a.wav"}).status, 0);
  const std::vector<std::pair<std::vector<std::string>, std::string>> refused{
      {{"range", "a.take", "--from", "1"}, "--to"},
      {{"range", "a.take", "--from", "2", "--to", "1"}, "later end"},
      {{"limb", "a.take", "--from", "0", "--to", "1"}, "--second-from"},
      {{"limb", "a.take", "--from", "0", "--to", "1", "--second-from", "1", "--second-to", "2"}, "\"Right arm\""},
      {{"limb", "a.take", "--group", "Tail"}, "\"Torso\""},
      {{"limb", "a.take", "--sensor", "tail"}, "upper arm"}};
  for (auto [arguments, expected] : refused) {
    arguments.insert(arguments.begin(), "calibrate");
    const auto outcome = limbwave.run(arguments);
    EXPECT_EQ(outcome.status, 1);
    expect_one_line(outcome);
    EXPECT_THAT(outcome.errors, HasSubstr(expected));
  }
  const auto info = nlohmann::json::parse(limbwave.run({"info", "a.take", "--json"}).output);
  EXPECT_EQ(info.at("calibrated"), false);
  EXPECT_EQ(info.at("groups").size(), 2U);
  EXPECT_THAT(limbwave.run({"info", "a.take"}).output,
              AllOf(HasSubstr("Right arm"), HasSubstr("fingers"), HasSubstr("not calibrated"),
                    HasSubstr("no calibration movements")));
  EXPECT_TRUE(info.at("calibration_movements").empty());
}

// A take that simulates the wearer's session as a recording without segments: times alone say what is what.
TEST_F(CommandLineContract, CalibratesByTimesWhatASoundCardRecorded) {
  ASSERT_EQ(limbwave.run({"simulate", "made.take", "--motion", "reach", "--errors", "accurate", "--seed", "5"}).status,
            0);
  const auto made = nlohmann::json::parse(limbwave.run({"info", "made.take", "--json"}).output);
  // What was done for calibrations is told, with its times.
  const nlohmann::json& movements = made.at("calibration_movements");
  ASSERT_EQ(movements.size(), 3U) << movements;
  EXPECT_EQ(movements.at(0).at("procedure"), "range");
  EXPECT_EQ(movements.at(1).at("group"), "Right arm");
  EXPECT_EQ(movements.at(1).at("parts").size(), 2U);
  EXPECT_EQ(movements.at(1).at("parts").at(0).at("name"), "horizontal");
  EXPECT_EQ(movements.at(2).at("complete"), true);
  EXPECT_THAT(limbwave.run({"info", "made.take"}).output,
              testing::ContainsRegex("calibration movement Right arm +horizontal [0-9.]+ to [0-9.]+ s, vertical"));
  ASSERT_EQ(limbwave.run({"import", "session.take", "made.take/signal.wav", "--subject", "Anna"}).status, 0);
  const auto times = [&](const std::string& segment, const std::string& from, const std::string& to) {
    for (const nlohmann::json& candidate : made.at("segments")) {
      if (candidate.at("name") == segment) {
        const double start = candidate.at("start_s").get<double>();
        return std::vector<std::string>{from, std::to_string(start), to,
                                        std::to_string(start + candidate.at("seconds").get<double>())};
      }
    }
    throw std::runtime_error("no segment " + segment);
  };
  std::vector<std::string> range{"calibrate", "range", "session.take"};
  const auto turns = times("range", "--from", "--to");
  range.insert(range.end(), turns.begin(), turns.end());
  const auto ranged = limbwave.run(range);
  EXPECT_EQ(ranged.status, 0) << ranged.errors;
  EXPECT_THAT(ranged.output, testing::Not(HasSubstr("good: good")));
  for (const std::string group : {"Right arm", "Torso"}) {
    std::vector<std::string> limb{"calibrate", "limb", "session.take", "--group", group};
    const auto first = times("pose:" + group + ":first", "--from", "--to");
    const auto second = times("pose:" + group + ":second", "--second-from", "--second-to");
    limb.insert(limb.end(), first.begin(), first.end());
    limb.insert(limb.end(), second.begin(), second.end());
    const auto outcome = limbwave.run(limb);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
  }
  const auto info = nlohmann::json::parse(limbwave.run({"info", "session.take", "--json"}).output);
  EXPECT_EQ(info.at("calibrated"), true);
  // The next recording of the same person and board finds it in the library.
  ASSERT_EQ(limbwave.run({"import", "next.take", "made.take/signal.wav", "--subject", "Anna"}).status, 0);
  const auto solved = limbwave.run({"solve", "next.take"});
  EXPECT_EQ(solved.status, 0) << solved.errors;
  EXPECT_THAT(solved.output, HasSubstr("library")) << solved.output;
}

TEST_F(CommandLineContract, OutputThatCannotBeWrittenIsAFailure) {
  test::write_bytes(folder / "a.wav", stereo_wav(4800));
  ASSERT_EQ(limbwave.run({"import", "a.take", "a.wav"}).status, 0);
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full";
  }
  const auto outcome = limbwave.run({"info", "a.take"}, "/dev/full");
  EXPECT_EQ(outcome.status, 1);
  expect_one_line(outcome);
}

TEST_F(CommandLineContract, OneOfSeveralMovementsIsChosenByNameOrNumber) {
  ASSERT_EQ(limbwave.run({"simulate", "a.take", "--motion", "wave", "--seconds", "2"}).status, 0);
  ASSERT_EQ(limbwave.run({"solve", "a.take"}).status, 0);
  ASSERT_EQ(limbwave.run({"export", "a.take", "-o", "one.gltf", "--no-mesh"}).status, 0);
  // A second movement in which only the last bone turns.
  nlohmann::json file = nlohmann::json::parse(std::ifstream(folder / "one.gltf"));
  nlohmann::json second = file["animations"][0];
  second["name"] = "second";
  second["channels"] = nlohmann::json::array({second["channels"].back()});
  file["animations"].push_back(second);
  std::ofstream(folder / "two.gltf") << file;

  const auto first = limbwave.run({"export", "two.gltf", "-o", "first.csv"});
  EXPECT_EQ(first.status, 0);
  EXPECT_THAT(first.errors + first.output, HasSubstr("--clip chooses another"));
  EXPECT_EQ(limbwave.run({"export", "two.gltf", "--clip", "second", "-o", "name.csv"}).status, 0);
  EXPECT_EQ(limbwave.run({"export", "two.gltf", "--clip", "2", "-o", "number.csv"}).status, 0);
  const auto text = [this](const char* name) { return read_file(folder / name).value(); };
  EXPECT_FALSE(text("name.csv").empty());
  EXPECT_EQ(text("name.csv"), text("number.csv"));
  EXPECT_NE(text("name.csv"), text("first.csv"));

  const auto unknown = limbwave.run({"export", "two.gltf", "--clip", "third", "-o", "x.csv"});
  EXPECT_EQ(unknown.status, 1);
  expect_one_line(unknown);
  EXPECT_THAT(unknown.errors, HasSubstr("\"second\""));
  EXPECT_FALSE(fs::exists(folder / "x.csv"));
}

TEST_F(CommandLineContract, WhatIsNotANumberIsRefusedAsOne) {
  ASSERT_EQ(limbwave.run({"simulate", "a.take", "--motion", "wave", "--seconds", "2"}).status, 0);
  const std::vector<std::vector<std::string>> wrong{{"solve", "a.take", "--smoothing-time", "nan"},
                                                    {"export", "a.take", "-o", "a.bvh", "--fps", "nan"},
                                                    {"export", "a.take", "-o", "a.bvh", "--from", "inf"},
                                                    {"export", "a.take", "-o", "a.bvh", "--to", "-1"},
                                                    {"simulate", ""}};
  for (const std::vector<std::string>& arguments : wrong) {
    const auto outcome = limbwave.run(arguments);
    EXPECT_NE(outcome.status, 0) << arguments.back();
    expect_one_line(outcome);
  }
}

TEST_F(CommandLineContract, ASolveKeepsTheUsersHeadings) {
  ASSERT_EQ(limbwave.run({"simulate", "a.take", "--motion", "wave", "--seconds", "2"}).status, 0);
  std::ofstream(folder / "a.take" / "live_headings.json") << R"({"schema": 1, "headings_s_rad": [[], [[0.0, 0.5]]]})";
  const auto headings = [this] {
    std::ifstream in(folder / "a.take" / "solves" / "default" / "settings.json");
    return nlohmann::json::parse(in).at("headings_s_rad").dump();
  };
  ASSERT_EQ(limbwave.run({"solve", "a.take"}).status, 0);
  EXPECT_EQ(headings(), "[[],[[0.0,0.5]]]");
  fs::remove(folder / "a.take" / "live_headings.json");
  ASSERT_EQ(limbwave.run({"solve", "a.take", "--smoothing", "adaptive"}).status, 0);
  EXPECT_EQ(headings(), "[[],[[0.0,0.5]]]");
}

TEST_F(CommandLineContract, InterruptedWorkLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t child = limbwave.start({"simulate", "long.take", "--motion", "walk", "--seconds", "36000"});
    ASSERT_GT(child, 0);
    while (names_in(folder.path()).empty()) {  // until it has begun to write; the test's time limit ends it otherwise
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_EQ(::kill(child, signal), 0);
    const auto outcome = limbwave.wait(child);
    EXPECT_EQ(outcome.status, 130);
    expect_one_line(outcome);
    EXPECT_THAT(names_in(folder.path()), testing::IsEmpty());
  }
}

TEST_F(CommandLineContract, EveryCommandHasHelpWithAnExample) {
  const std::vector<std::vector<std::string>> commands{{"devices"},
                                                       {"record"},
                                                       {"import"},
                                                       {"calibrate"},
                                                       {"calibrate", "range"},
                                                       {"calibrate", "limb"},
                                                       {"solve"},
                                                       {"export"},
                                                       {"simulate"},
                                                       {"evaluate"},
                                                       {"info"},
                                                       {"verify"},
                                                       {"recover"}};
  for (std::vector<std::string> arguments : commands) {
    arguments.emplace_back("--help");
    const auto help = limbwave.run(arguments);
    EXPECT_EQ(help.status, 0) << arguments[0];
    EXPECT_THAT(help.output, HasSubstr("Example: limbwave " + arguments[0])) << arguments[0];
    EXPECT_EQ(help.errors, "");
  }
}

}  // namespace
}  // namespace limbwave
