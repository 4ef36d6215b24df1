// Real radio ranges against optical truth, one half of a recording judged by what the other half says about it.
#include "evaluate/radio_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"

namespace limbwave::evaluate {
namespace {

namespace fs = std::filesystem;

fs::path data() {
  const char* folder = std::getenv("LIMBWAVE_DATA");
  return fs::path(folder != nullptr ? folder : "") / "ranges" / "room";
}

TEST(RadioRanges, AreBelievedAsFarAsTheyAreTrue) {
  if (!fs::exists(data() / "README.upstream.md")) {
    GTEST_SKIP() << "LIMBWAVE_DATA has no ranges/room";
  }
  const auto recordings = load_radio_recordings(data());
  ASSERT_TRUE(recordings.ok()) << recordings.error().text();
  for (const RadioRecording& recording : *recordings) {
    ASSERT_EQ(recording.anchors_W.size(), 8U);
    ASSERT_EQ(recording.tags_B.size(), 3U);
    const std::size_t half = recording.rows.size() / 2;
    const auto parameters = radio_parameters(recording);
    const RadioStatistics first = evaluate_radio(recording, parameters, 0, half);
    const RadioStatistics second = evaluate_radio(recording, parameters, half, recording.rows.size());
    for (const auto& [judged, other] : {std::pair{&first, &second}, std::pair{&second, &first}}) {
      std::printf(
          "%s: %lld ranges, %.2f %% accepted; raw median %.0f p95 %.0f, accepted median %.0f p95 %.0f max %.0f mm; "
          "normalised %.2f; %lld of %lld outliers accepted; place %.0f mm\n",
          recording.name.c_str(), static_cast<long long>(judged->count),
          100.0 * static_cast<double>(judged->accepted) / static_cast<double>(judged->count), judged->raw_median_mm,
          judged->raw_p95_mm, judged->median_mm, judged->p95_mm, judged->max_mm, judged->normalised_rms,
          static_cast<long long>(judged->outliers_accepted), static_cast<long long>(judged->outliers),
          judged->place_median_mm);
      EXPECT_GT(judged->count, 50000);
      // Most of what is off by half a metre is refused, and all that is off by a metre; what is left is nearly
      // everything. Reflections that build up over a second are followed as a pair's wandering offset.
      EXPECT_GT(static_cast<double>(judged->accepted), 0.98 * static_cast<double>(judged->count));
      EXPECT_LE(2 * judged->outliers_accepted, judged->outliers);
      EXPECT_LT(judged->max_mm, 1000.0);
      EXPECT_LT(judged->max_mm, 0.5 * std::max(judged->raw_max_mm, other->raw_max_mm));
      // Without the pairs' offsets ranges are better than the other half's are as they came.
      EXPECT_LT(judged->median_mm, 0.5 * other->raw_median_mm);
      EXPECT_LT(judged->p95_mm, 0.75 * other->raw_p95_mm);
      // Variances say how large errors are, to within a factor of two.
      EXPECT_GT(judged->normalised_rms, 0.5);
      EXPECT_LT(judged->normalised_rms, 2.0);
    }
  }
}

TEST(RadioRanges, DamagedFilesAreNamedWithTheirLine) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(load_radio_recordings(folder.path()).ok());
  std::ofstream(folder.path() / "README.upstream.md") << "| Tag 0 | 0 | 0 | 0 |\n| Anchor 0 | 1 | 2 | 3 |\n";
  EXPECT_FALSE(load_radio_recordings(folder.path()).ok()) << "no recording";
  std::ofstream(folder.path() / "UWB_a.csv") << "2022-08-15 9:37:27.039,4.09\n2022-08-15 nine,4.1\n";
  std::ofstream(folder.path() / "motion_capture_a.csv") << "time,x,y,z\n2022-08-15 9:37:27.0,0,0,0,1,0,0,0\n";
  const auto damaged = load_radio_recordings(folder.path());
  ASSERT_FALSE(damaged.ok());
  EXPECT_NE(damaged.error().text().find("UWB_a.csv:2"), std::string::npos) << damaged.error().text();
}

}  // namespace
}  // namespace limbwave::evaluate
