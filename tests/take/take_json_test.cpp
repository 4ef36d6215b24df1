#include "take/take_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TakeInfo full_info() {
  TakeInfo info = arm_info({SampleRate{44100.0}, 2, acquire::SampleType::kInt24});
  info.created = "2026-01-02T03:04:05Z";
  info.complete = true;
  info.frames = 123456789012;
  info.calibration = calibrate::nominal_calibration(info.rig);
  info.segments = {{"range", SampleIndex{0}, SampleCount{1000}}, {"capture", SampleIndex{1000}, SampleCount{5000}}};
  return info;
}

TEST(TakeJson, WhatIsWrittenIsRead) {
  const json written = info_to_json(full_info());
  const TakeInfo read = must(info_from_json(written, "take.json"));
  EXPECT_EQ(info_to_json(read), written);
  EXPECT_EQ(read.subject, "Anna");
  EXPECT_EQ(read.frames, 123456789012);
  EXPECT_EQ(read.format.type, acquire::SampleType::kInt24);
  ASSERT_EQ(read.segments.size(), 2U);
  EXPECT_EQ(read.segments[1].first, SampleIndex{1000});
  ASSERT_TRUE(read.calibration.has_value());
  EXPECT_EQ(read.calibration->sensors.size(), 5U);
}

TEST(TakeJson, NamesTheKeyThatIsWrong) {
  const auto error = [](const std::function<void(json&)>& spoil) {
    json changed = info_to_json(full_info());
    spoil(changed);
    const Result<TakeInfo> info = info_from_json(changed, "take.json");
    return info.ok() ? std::string() : info.error().text();
  };
  EXPECT_EQ(error([](json&) {}), "");
  EXPECT_THAT(error([](json& j) { j["colour"] = 1; }), HasSubstr("take.json: /colour: is not a known key"));
  EXPECT_THAT(error([](json& j) { j.erase("format"); }), HasSubstr("take.json: /format: is missing"));
  EXPECT_THAT(error([](json& j) { j["format"]["type"] = "int8"; }),
              HasSubstr("/format/type: is not a known sample type"));
  EXPECT_THAT(error([](json& j) { j["format"]["channels"] = 0; }), HasSubstr("/format/channels: is 0"));
  EXPECT_THAT(error([](json& j) { j["format"]["rate_hz"] = -1; }), HasSubstr("/format/rate_hz"));
  EXPECT_THAT(error([](json& j) { j["frames"] = -1; }), HasSubstr("/frames: is -1"));
  EXPECT_THAT(error([](json& j) { j["segments"][1]["first"] = "x"; }), HasSubstr("/segments/1/first"));
  EXPECT_THAT(error([](json& j) { j["rig"]["name"] = 3; }), HasSubstr("take.json: /rig: /name"));
  EXPECT_THAT(error([](json& j) { j["skeleton"]["weight"] = 3; }), HasSubstr("take.json: /skeleton: /weight"));
  EXPECT_THAT(error([](json& j) { j["calibration"]["sensors"] = 3; }), HasSubstr("take.json: /calibration: /sensors"));
  EXPECT_THAT(error([](json& j) { j["kind"] = "smell"; }), HasSubstr("/kind: is \"smell\""));
  EXPECT_THAT(error([](json& j) { j["schema"] = 2; }), HasSubstr("newer version"));
  EXPECT_THAT(error([](json& j) { j = json::array(); }), HasSubstr("is not an object"));
}

TEST(TakeJson, NamesThatAreNotUtf8DoNotStopARecording) {
  const test::TemporaryFolder folder;
  Take take;
  take.folder = folder.path();
  take.info = full_info();
  take.info.source = "caf\xE9";
  ASSERT_TRUE(save_info(take).ok());
  const json read = json::parse(must(read_file(folder / "take.json")));
  EXPECT_EQ(read["source"], "caf\xEF\xBF\xBD");
  ASSERT_TRUE(append_event(folder.path(), {SampleIndex{1}, "marker", "caf\xE9", 0}).ok());
}

TEST(TakeJson, EventsAreLines) {
  const TakeEvent event{SampleIndex{42}, "marker", "now \"jump\"\n", 7};
  const std::string line = event_to_line(event);
  EXPECT_EQ(line, R"({"sample":42,"kind":"marker","text":"now \"jump\"\n","count":7})");
  const TakeEvent read = must(event_from_line(line, "x"));
  EXPECT_EQ(read.sample, event.sample);
  EXPECT_EQ(read.text, event.text);
  EXPECT_EQ(read.count, 7);
  EXPECT_EQ(event_from_line(R"({"sample":-1,"kind":"x"})", "events.jsonl:3").error().place, "events.jsonl:3: /sample");
  EXPECT_FALSE(event_from_line(R"({"sample":1})", "x").ok());
  EXPECT_FALSE(event_from_line("", "x").ok());
}

TEST(TakeInfo, CaptureIsItsSegmentOrEverything) {
  TakeInfo info = full_info();
  info.frames = 4000;
  EXPECT_EQ(info.capture().first, SampleIndex{1000});
  EXPECT_EQ(info.capture().count, SampleCount{3000}) << "not beyond the end";
  info.segments.clear();
  EXPECT_EQ(info.capture().first, SampleIndex{0});
  EXPECT_EQ(info.capture().count, SampleCount{4000});
}

}  // namespace
}  // namespace limbwave::take
