#include "acquire/box_ports.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "support/child_process.h"
#include "support/temporary_folder.h"

namespace limbwave::acquire {
namespace {

TEST(BoxPorts, AnIdIsThePrefixAndThePort) {
  EXPECT_EQ(box_port("driver-box:/dev/ttyACM0"), "/dev/ttyACM0");
  EXPECT_EQ(box_port("/dev/ttyACM0"), "/dev/ttyACM0");
  EXPECT_EQ(box_port("driver-box:portaudio:JACK:system"), "portaudio:JACK:system");
  EXPECT_TRUE(is_card_port("portaudio:JACK:system"));
  EXPECT_FALSE(is_card_port("/dev/ttyACM0"));
}

TEST(BoxPorts, LargeCardsMayServeAsBoxes) {
  DeviceInfo small{"portaudio:ALSA:hw", "Built-in", 2, 48000.0, {48000.0}, {}, true};
  DeviceInfo large{"portaudio:JACK:system", "system", 20, 192000.0, {192000.0}, {}, false};
  const auto boxes = cards_as_boxes({small, large}, 18);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(boxes[0].id, "driver-box:portaudio:JACK:system");
  EXPECT_EQ(boxes[0].channels, 20);
}

// A link of a program that is gone, or of another program, is no emulator: its terminal may be anybody's.
TEST(BoxPorts, LeftoversAreNoEmulators) {
  const test::TemporaryFolder folder;
  const test::ScopedEnvironment home({{"LIMBWAVE_HOME", folder.path().string()}});
  ASSERT_EQ(emulator_folder(), folder.path() / "emulators");
  std::filesystem::create_directories(emulator_folder());
  for (const std::string& name : {std::to_string(::getpid()), std::string("999999999"), std::string("note.txt")}) {
    std::filesystem::create_symlink("/dev/null", emulator_folder() / name);
  }
  const auto boxes = list_box_ports();
  EXPECT_TRUE(std::none_of(boxes.begin(), boxes.end(),
                           [](const DeviceInfo& box) { return box.id.find("/emulators/") != std::string::npos; }));
}

}  // namespace
}  // namespace limbwave::acquire
