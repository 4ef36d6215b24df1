/// A take's description for tests, and small helpers around takes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "body/rig.h"
#include "body/skeleton.h"
#include "take/recorder.h"
#include "take/take.h"

namespace limbwave::take {

inline body::Rig arm_rig() {
  Result<body::Rig> rig = body::load_rig("line-in-arm");
  EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().text());
  return *std::move(rig);
}

inline TakeInfo arm_info(const acquire::StreamFormat& format) {
  TakeInfo info;
  info.subject = "Anna";
  info.source = "test";
  info.format = format;
  info.rig = arm_rig();
  Result<body::Skeleton> skeleton = body::load_skeleton(info.rig.skeleton);
  EXPECT_TRUE(skeleton.ok());
  info.skeleton = *std::move(skeleton);
  return info;
}

inline std::vector<std::string> codes(const Diagnostics& diagnostics) {
  std::vector<std::string> list;
  for (const Diagnostic& diagnostic : diagnostics) {
    list.push_back(diagnostic.code);
  }
  return list;
}

/// Everything that a folder holds, hidden files too.
inline std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The value of a result; a failed one fails the test with its text and throws.
template <typename T>
T must(Result<T> result) {
  if (!result) {
    throw std::runtime_error(result.error().text());
  }
  return *std::move(result);
}

}  // namespace limbwave::take
