#include "base/diagnostics.h"

#include <gtest/gtest.h>

namespace limbwave {
namespace {

TEST(Diagnostics, TextNamesEverythingThatIsKnown) {
  const Diagnostic all{Severity::kError, "a.b", "17 samples clip", "turn the volume down", "left", 3.456};
  EXPECT_EQ(all.text(), "error: at 3.46 s: left: 17 samples clip; turn the volume down");
  const Diagnostic bare{Severity::kInfo, "a.b", "it is quiet", "", "", -1.0};
  EXPECT_EQ(bare.text(), "info: it is quiet");
}

TEST(Diagnostics, WorstIsTheMostSevere) {
  EXPECT_EQ(worst({}), Severity::kInfo);
  Diagnostics list(3);
  EXPECT_EQ(worst(list), Severity::kWarning);
  list[1].severity = Severity::kError;
  EXPECT_EQ(worst(list), Severity::kError);
}

}  // namespace
}  // namespace limbwave
