/// Which formats a device offers, and the words for those that it does not.
#include "workspaces/capture/device_format.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>

namespace limbwave::ui {
namespace {

acquire::DeviceInfo interface_with(int channels) {
  acquire::DeviceInfo device;
  device.id = "portaudio:ALSA:Big: interface/4 (hw:1,0)";
  device.channels = channels;
  device.rates_hz = {44100.0, 48000.0, 96000.0};
  device.types = {acquire::SampleType::kInt16, acquire::SampleType::kInt32};
  return device;
}

const FormatChoice* find(const std::vector<FormatChoice>& list, const QString& text) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const FormatChoice& c) { return c.text == text; });
  return found == list.end() ? nullptr : &*found;
}

int chosen(const std::vector<FormatChoice>& list) {
  return static_cast<int>(std::count_if(list.begin(), list.end(), [](const FormatChoice& c) { return c.chosen; }));
}

TEST(FormatChoices, WhatIsNotOfferedIsListedWithAReason) {
  const FormatChoices choices = format_choices(interface_with(2), {});
  ASSERT_NE(find(choices.rates, QStringLiteral("192 kHz")), nullptr);
  EXPECT_FALSE(find(choices.rates, QStringLiteral("192 kHz"))->why_not.isEmpty());
  EXPECT_TRUE(find(choices.rates, QStringLiteral("96 kHz"))->why_not.isEmpty());
  EXPECT_FALSE(find(choices.types, QStringLiteral("24 bit"))->why_not.isEmpty());
  EXPECT_TRUE(find(choices.types, QStringLiteral("32 bit"))->why_not.isEmpty());
  EXPECT_FALSE(choices.inputs.back().why_not.isEmpty()) << "two inputs leave no choice, and that is said";
  for (const auto* list : {&choices.rates, &choices.types, &choices.inputs}) {
    EXPECT_EQ(chosen(*list), 1);
    EXPECT_TRUE(list->front().why_not.isEmpty());
  }
}

TEST(FormatChoices, ChoosingOneKeepsTheOthers) {
  DeviceSetup setup;
  setup.rate_hz = 96000.0;
  setup.left = 4;
  setup.right = 5;
  const FormatChoices choices = format_choices(interface_with(8), setup);
  EXPECT_EQ(choices.inputs.size(), 4U);
  EXPECT_TRUE(choices.inputs[2].chosen);
  EXPECT_TRUE(find(choices.rates, QStringLiteral("96 kHz"))->chosen);
  const DeviceSetup next = find(choices.types, QStringLiteral("16 bit"))->setup;
  EXPECT_EQ(next.rate_hz, 96000.0);
  EXPECT_EQ(next.left, 4);
  EXPECT_EQ(next.type, acquire::SampleType::kInt16);
  EXPECT_EQ(choices.rates.front().setup.rate_hz, 0.0);
  EXPECT_EQ(choices.rates.front().setup.right, 5);
}

TEST(FormatChoices, AnUnusualRateIsListedToo) {
  acquire::DeviceInfo device = interface_with(2);
  device.rates_hz.push_back(50000.0);
  EXPECT_NE(find(format_choices(device, {}).rates, QStringLiteral("50 kHz")), nullptr);
}

TEST(FormatChoices, ADeviceThatIsBusySaysSo) {
  acquire::DeviceInfo device = interface_with(2);
  device.rates_hz.clear();
  device.types.clear();
  const FormatChoices choices = format_choices(device, {});
  EXPECT_TRUE(choices.rates[1].why_not.contains(QStringLiteral("another program")));
  EXPECT_TRUE(choices.types[1].why_not.contains(QStringLiteral("another program")));
}

TEST(RememberedSetup, IsKeptForEachDevice) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
  const acquire::DeviceInfo device = interface_with(8);
  acquire::DeviceInfo other = device;
  other.id += "#2";
  DeviceSetup setup;
  setup.rate_hz = 44100.0;
  setup.type = acquire::SampleType::kInt32;
  setup.left = 6;
  setup.right = 7;
  remember_setup(settings, device, setup);
  EXPECT_EQ(remembered_setup(settings, device), setup);
  EXPECT_EQ(remembered_setup(settings, other), DeviceSetup());
}

TEST(RememberedSetup, ForgetsWhatTheDeviceHasNoMore) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
  DeviceSetup setup;
  setup.rate_hz = 96000.0;
  setup.type = acquire::SampleType::kInt16;
  setup.left = 6;
  setup.right = 7;
  remember_setup(settings, interface_with(8), setup);
  acquire::DeviceInfo less = interface_with(2);
  less.rates_hz = {48000.0};
  const DeviceSetup now = remembered_setup(settings, less);
  EXPECT_EQ(now.rate_hz, 0.0);
  EXPECT_EQ(now.left, 0);
  EXPECT_EQ(now.right, 1);
  EXPECT_EQ(now.type, acquire::SampleType::kInt16);
}

TEST(FormatWords, NameTheInputsWhereTheyMatter) {
  const acquire::StreamFormat format{SampleRate{48000.0}, 2, acquire::SampleType::kInt24};
  EXPECT_EQ(format_words(format, {}), QStringLiteral("48 kHz, 24 bit"));
  DeviceSetup setup;
  setup.left = 2;
  setup.right = 3;
  EXPECT_EQ(format_words(format, setup), QStringLiteral("48 kHz, 24 bit, inputs 3 + 4"));
}

}  // namespace
}  // namespace limbwave::ui
