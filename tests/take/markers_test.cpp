// Markers: set, changed and removed by appending lines only, so that no crash can lose one.
#include "take/markers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/files.h"
#include "support/audio_files.h"
#include "support/temporary_folder.h"
#include "take/take_fixture.h"

namespace limbwave::take {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> words(const std::vector<TakeEvent>& events) {
  std::vector<std::string> list;
  for (const TakeEvent& event : events) {
    list.push_back(event.kind + " " + std::to_string(event.count) + " at " + std::to_string(event.sample.value) + ": " +
                   event.text);
  }
  return list;
}

TEST(EventsInForce, TheLastStateOfAMarkerCountsAtItsFirstPlace) {
  const std::vector<TakeEvent> lines{
      {SampleIndex{10}, kMarker, "one", 1},   {SampleIndex{15}, "dropped", "3 samples", 1},
      {SampleIndex{20}, kMarker, "two", 2},   {SampleIndex{40}, kMarker, "first", 1},
      {SampleIndex{}, kMarkerRemoved, "", 2}, {SampleIndex{50}, kMarker, "three", 3}};
  EXPECT_THAT(words(events_in_force(lines)),
              ElementsAre("marker 1 at 40: first", "dropped 1 at 15: 3 samples", "marker 3 at 50: three"));
  EXPECT_EQ(free_marker_number(events_in_force(lines)), 4);
}

TEST(EventsInForce, ARemovedMarkerComesBackByBeingSetAgain) {
  const std::vector<TakeEvent> lines{{SampleIndex{10}, kMarker, "one", 1},
                                     {SampleIndex{}, kMarkerRemoved, "", 1},
                                     {SampleIndex{}, kMarkerRemoved, "", 1},
                                     {SampleIndex{12}, kMarker, "again", 1}};
  EXPECT_THAT(words(events_in_force(lines)), ElementsAre("marker 1 at 12: again"));
}

TEST(EventsInForce, MarkersWithoutANumberAreKnownByTheirLine) {
  std::vector<TakeEvent> lines{
      {SampleIndex{10}, kMarker, "a", 0}, {SampleIndex{11}, "clipping", "", 0}, {SampleIndex{12}, kMarker, "b", 0}};
  EXPECT_THAT(words(events_in_force(lines)),
              ElementsAre("marker -1 at 10: a", "clipping 0 at 11: ", "marker -3 at 12: b"));
  lines.push_back({SampleIndex{99}, kMarker, "b, moved", -3});
  lines.push_back({SampleIndex{}, kMarkerRemoved, "", -1});
  EXPECT_THAT(words(events_in_force(lines)), ElementsAre("clipping 0 at 11: ", "marker -3 at 99: b, moved"));
  EXPECT_EQ(free_marker_number(events_in_force(lines)), 1);
}

TEST(EventsInForce, RemovingWhatIsNotThereChangesNothing) {
  EXPECT_THAT(events_in_force({{SampleIndex{}, kMarkerRemoved, "", 7}}), IsEmpty());
}

class MarkersOnDisk : public testing::Test {
 protected:
  acquire::StreamFormat format{SampleRate{48000.0}, 2, acquire::SampleType::kInt16};
  std::vector<std::byte> raw{std::vector<std::byte>(4800 * format.bytes_per_frame())};
  test::TemporaryFolder folder;
  std::filesystem::path path = folder / "x.take";
};

TEST_F(MarkersOnDisk, WhatIsChangedWhileRecordingIsThereWithoutClosing) {
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(format)));
  ASSERT_TRUE(recorder->write(raw).ok());
  ASSERT_TRUE(recorder->add_event({SampleIndex{100}, kMarker, "one", 1}).ok());
  ASSERT_TRUE(recorder->add_event({SampleIndex{200}, kMarker, "two", 2}).ok());
  ASSERT_TRUE(recorder->add_event({SampleIndex{300}, kMarker, "jump", 1}).ok());
  ASSERT_TRUE(recorder->add_event({SampleIndex{}, kMarkerRemoved, "", 2}).ok());
  // As another program sees it at this moment, and as it stays when this one dies now.
  EXPECT_THAT(words(must(open_take(path)).events), ElementsAre("marker 1 at 300: jump"));
  ASSERT_TRUE(recorder->close().ok());
  EXPECT_THAT(codes(must(verify_take(path)).findings), IsEmpty());
}

TEST_F(MarkersOnDisk, ALineCutOffByACrashCostsThisChangeAlone) {
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(format)));
  ASSERT_TRUE(recorder->write(raw).ok());
  ASSERT_TRUE(recorder->add_event({SampleIndex{100}, kMarker, "one", 1}).ok());
  ASSERT_TRUE(recorder->close().ok());
  std::ofstream(path / "events.jsonl", std::ios::app) << R"({"sample":0,"kind":"marker-rem)";
  EXPECT_THAT(words(must(open_take(path)).events), ElementsAre("marker 1 at 100: one"));
  ASSERT_TRUE(append_event(path, {SampleIndex{150}, kMarker, "one, later", 1}).ok());
  EXPECT_THAT(words(must(open_take(path)).events), ElementsAre("marker 1 at 150: one, later"));
}

TEST_F(MarkersOnDisk, LinesThatCannotBeReadKeepTheirNumber) {
  std::unique_ptr<Recorder> recorder = must(Recorder::create(path, arm_info(format)));
  ASSERT_TRUE(recorder->write(raw).ok());
  ASSERT_TRUE(recorder->close().ok());
  ASSERT_TRUE(
      write_file(path / "events.jsonl", "not json\n{\"sample\":5,\"kind\":\"marker\",\"text\":\"old\"}\n").ok());
  EXPECT_THAT(words(must(open_take(path)).events), ElementsAre("marker -2 at 5: old"));
}

}  // namespace
}  // namespace limbwave::take
