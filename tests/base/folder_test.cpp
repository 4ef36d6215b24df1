#include "base/folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.h"

namespace limbwave {
namespace {

namespace fs = std::filesystem;

TEST(Folder, EverythingByName) {
  const test::TemporaryFolder folder;
  for (const char* name : {"b", "a", ".hidden"}) {
    std::ofstream(folder / name) << name;
  }
  fs::create_directory(folder / "c");
  std::ofstream(folder / "c" / "not-listed") << "x";
  const Result<std::vector<fs::path>> paths = list_folder(folder.path());
  ASSERT_TRUE(paths);
  EXPECT_EQ(*paths, (std::vector<fs::path>{folder / ".hidden", folder / "a", folder / "b", folder / "c"}));
  EXPECT_EQ(entries_of(folder.path()), *paths);
  EXPECT_EQ(list_folder(folder / "c")->size(), 1U);
}

TEST(Folder, WhatCannotBeListedIsAnErrorAndNeverAnException) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  for (const fs::path& path : {folder / "none", folder / "file"}) {
    const Result<std::vector<fs::path>> paths = list_folder(path);
    ASSERT_FALSE(paths) << path;
    EXPECT_EQ(paths.error().place, path.string());
    EXPECT_TRUE(entries_of(path).empty());
  }
}

}  // namespace
}  // namespace limbwave
