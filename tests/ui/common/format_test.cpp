#include "common/format.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QLocale>
#include <QTemporaryDir>
#include <limits>

namespace limbwave::ui {
namespace {

class FormatTest : public ::testing::Test {
 protected:
  void SetUp() override { QLocale::setDefault(QLocale::c()); }
};

TEST_F(FormatTest, ClockCarriesIntoMinutesAndHours) {
  EXPECT_EQ(format_clock(0.0), "0:00");
  EXPECT_EQ(format_clock(59.99), "0:59");
  EXPECT_EQ(format_clock(60.0), "1:00");
  EXPECT_EQ(format_clock(3599.0), "59:59");
  EXPECT_EQ(format_clock(3600.0 + 62.0), "1:01:02");
  EXPECT_EQ(format_clock(-3.0), "0:00");
  EXPECT_EQ(format_clock(std::numeric_limits<double>::quiet_NaN()), "0:00");
  EXPECT_EQ(format_clock_tenths(7.39), "0:07.3");
}

TEST_F(FormatTest, TimeLeftIsNeverMoreExactThanItIsTrue) {
  EXPECT_EQ(format_left(40.2), "40 s");
  EXPECT_EQ(format_left(300.0), "5 min");
  EXPECT_EQ(format_left(23.2 * 3600.0), "23 h");
  EXPECT_EQ(format_left(5.1 * 86400.0), "5 days");
  EXPECT_EQ(format_left(40.0 * 86400.0), "over 9 days");
  EXPECT_EQ(format_left(-1.0), "");
}

TEST_F(FormatTest, LevelsAndRates) {
  EXPECT_EQ(format_level(1.0), "0 dB");
  EXPECT_EQ(format_level(0.5), QStringLiteral("\u22126 dB"));
  EXPECT_EQ(format_level(0.0), "silent");
  EXPECT_EQ(format_level(std::numeric_limits<double>::quiet_NaN()), "silent");
  EXPECT_EQ(format_rate(44100.0), "44.1 kHz");
  EXPECT_EQ(format_rate(48000.0), "48 kHz");
}

TEST_F(FormatTest, SentencesBeginLargeAndEnd) {
  EXPECT_EQ(as_sentence("the cable is loose"), "The cable is loose.");
  EXPECT_EQ(as_sentence("Really?"), "Really?");
  EXPECT_EQ(as_sentence(""), "");
}

TEST_F(FormatTest, FileNamesKeepWhatDisksLike) {
  EXPECT_EQ(file_name_part(QStringLiteral("Zoë B.")), "zoe-b");
  EXPECT_EQ(file_name_part("../../etc/passwd"), "etc-passwd");
  EXPECT_EQ(file_name_part("   "), "");
  EXPECT_EQ(file_name_part(QStringLiteral("日本")), "");
  EXPECT_LE(file_name_part(QString(500, QLatin1Char('a'))).size(), 64);
}

TEST_F(FormatTest, TakeNamesCountUpAndAreChecked) {
  const QTemporaryDir folder;
  EXPECT_EQ(suggest_take_name(folder.path(), "Ann", "20261122"), "ann-20261122-1");
  QDir(folder.path()).mkdir("ann-20261122-1.take");
  EXPECT_EQ(suggest_take_name(folder.path(), "Ann", "20261122"), "ann-20261122-2");
  EXPECT_EQ(suggest_take_name(folder.path(), "", "20261122"), "take-20261122-1");
  EXPECT_TRUE(take_name_problem(folder.path(), "ann-20261122-2").isEmpty());
  EXPECT_FALSE(take_name_problem(folder.path(), "ann-20261122-1").isEmpty());
  EXPECT_FALSE(take_name_problem(folder.path(), "a/b").isEmpty());
  EXPECT_FALSE(take_name_problem(folder.path(), ".hidden").isEmpty());
  EXPECT_FALSE(take_name_problem(folder.path(), " ").isEmpty());
  EXPECT_FALSE(take_name_problem(folder.path(), QString(300, QLatin1Char('x'))).isEmpty());
}

TEST(Clock, HundredthsRoundAsAWhole) {
  EXPECT_EQ(format_clock_hundredths(59.999), QStringLiteral("1:00.00"));
  EXPECT_EQ(format_clock_hundredths(7.326), QStringLiteral("0:07.33"));
  EXPECT_EQ(format_clock_hundredths(-1.0), QStringLiteral("0:00.00"));
}

TEST(Clock, IsReadAsPeopleWriteIt) {
  EXPECT_DOUBLE_EQ(*parse_clock(QStringLiteral("7.3")), 7.3);
  EXPECT_DOUBLE_EQ(*parse_clock(QStringLiteral(" 67,25 ")), 67.25);
  EXPECT_DOUBLE_EQ(*parse_clock(QStringLiteral("1:07.3")), 67.3);
  EXPECT_DOUBLE_EQ(*parse_clock(QStringLiteral("1:02:03")), 3723.0);
  for (const char* text : {"", "abc", "1:60", "1:2:3:4", "-3", "1:", ":", "nan", "inf", "1e999", "1:-2"}) {
    EXPECT_FALSE(parse_clock(QString::fromLatin1(text)).has_value()) << text;
  }
}

}  // namespace
}  // namespace limbwave::ui
