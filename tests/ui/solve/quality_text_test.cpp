#include "workspaces/solve/quality_text.h"

#include <gtest/gtest.h>

namespace limbwave::ui {
namespace {

solve::QualityReport good() {
  solve::QualityReport report;
  report.sensors = {{"upper", 1.0, 0.9, 1.001}, {"lower", 0.995, 0.7, 0.99}};
  report.line.decided = true;
  report.line.cycles = 6000;
  return report;
}

TEST(Quality, GoodIsSaidShortly) {
  const Verdict verdict = overall_verdict(good());
  EXPECT_EQ(verdict.tone, Tone::kGood);
  EXPECT_TRUE(verdict.remedy.isEmpty());
}

// A driver box has no line with cycles: nothing is said about one.
TEST(Quality, TheBodyFilterIsJudgedByItsFindings) {
  solve::QualityReport report;
  report.take_seconds = 12.0;
  EXPECT_TRUE(is_by_body_filter(report));
  EXPECT_FALSE(is_by_body_filter(good()));
  EXPECT_EQ(overall_verdict(report).tone, Tone::kGood) << overall_verdict(report).text.toStdString();
  report.diagnostics.push_back({Severity::kInfo, "body.foot-stands", "the left foot stood", "", ""});
  EXPECT_EQ(overall_verdict(report).tone, Tone::kGood);
  report.diagnostics.push_back({Severity::kWarning, "body.board-dead", "the hand was never heard", "check it", ""});
  Verdict verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kWarning);
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("never heard")));
  EXPECT_EQ(verdict.remedy, QStringLiteral("Check it"));
  report.diagnostics.push_back({Severity::kError, "body.blackout", "nothing was heard", "check the box", ""});
  verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kDanger);
  EXPECT_EQ(verdict.remedy, QStringLiteral("Check the box"));
}

TEST(Quality, TheWorstPartIsToldWithItsRemedy) {
  solve::QualityReport report = good();
  report.sensors[1].mean_norm_g = 1.09;
  Verdict verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kWarning);
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("lower")));
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("1.090")));
  EXPECT_FALSE(verdict.remedy.isEmpty());
  report.sensors[0].usable = 0.4;
  verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kDanger);
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("upper")));
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("40 %")));
}

TEST(Quality, LinesWithLossOrClippingOrNothingAreNamed) {
  decode::LineInStatus line;
  EXPECT_EQ(line_verdict(line).tone, Tone::kDanger);
  line.decided = true;
  line.cycles = 990;
  line.lost_cycles = 10;
  EXPECT_EQ(line_verdict(line).tone, Tone::kWarning);
  line.lost_cycles = 200;
  EXPECT_EQ(line_verdict(line).tone, Tone::kDanger);
  line.lost_cycles = 0;
  EXPECT_EQ(line_verdict(line).tone, Tone::kGood);
  line.clipped_slots = 3;
  EXPECT_EQ(line_verdict(line).tone, Tone::kWarning);
}

TEST(Quality, ErrorsAmongTheFindingsComeFirst) {
  solve::QualityReport report = good();
  report.diagnostics.push_back({Severity::kError, "x", "the clock stopped", "start again", "", 3.25});
  const Verdict verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kDanger);
  EXPECT_EQ(verdict.text, QStringLiteral("At 3.3 s: The clock stopped"));
  EXPECT_EQ(verdict.remedy, QStringLiteral("Start again"));
}

TEST(Quality, GoodSignalsWithoutCalibrationAreNotGood) {
  solve::QualityReport report = good();
  report.diagnostics.push_back({Severity::kWarning, "calibration.partial", "never calibrated: the range of hand",
                                "calibrate these sensors", "", -1.0});
  const Verdict verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kWarning);
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("ever calibrated: the range of hand")));
  EXPECT_FALSE(verdict.remedy.isEmpty());
}

TEST(Quality, ACalibrationThatIsOnlyUsableIsNotGood) {
  solve::QualityReport report = good();
  report.diagnostics.push_back({Severity::kInfo, "calibration.limb-usable",
                                "the mounting poses were up to 6.5° from perpendicular: hand", "hold them better", "",
                                -1.0});
  Verdict verdict = overall_verdict(report);
  EXPECT_EQ(verdict.tone, Tone::kWarning);
  EXPECT_FALSE(verdict.text.contains(QStringLiteral("Good")));
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("6.5°")));
  // What was never calibrated weighs more than what was calibrated badly.
  report.diagnostics.push_back({Severity::kWarning, "calibration.partial", "never calibrated: the range of hand",
                                "calibrate these sensors", "", -1.0});
  verdict = overall_verdict(report);
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("ever calibrated")));
}

TEST(Quality, TheTruthHasTheLastWord) {
  evaluate::Evaluation evaluation;
  evaluation.all.inclination_mean_deg = 0.8;
  EXPECT_EQ(overall_verdict(good(), &evaluation).tone, Tone::kGood);
  evaluation.all.inclination_mean_deg = 4.9;
  const Verdict verdict = overall_verdict(good(), &evaluation);
  EXPECT_EQ(verdict.tone, Tone::kWarning);
  EXPECT_TRUE(verdict.text.contains(QStringLiteral("4.90°")));
  EXPECT_FALSE(verdict.remedy.isEmpty());
}

TEST(Quality, PercentNeverPromisesAFalseHundred) {
  EXPECT_EQ(percent(1.0), QStringLiteral("100 %"));
  EXPECT_EQ(percent(0.99999), QStringLiteral("99.9 %"));
  EXPECT_EQ(percent(0.9949), QStringLiteral("99.4 %"));
  EXPECT_EQ(percent(0.5), QStringLiteral("50 %"));
  EXPECT_EQ(percent(-1.0), QStringLiteral("0 %"));
}

}  // namespace
}  // namespace limbwave::ui
