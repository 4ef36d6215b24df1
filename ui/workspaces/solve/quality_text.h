/// A quality report in words: what is good, what is not, and what to do. No widgets.
#pragma once

#include <QString>
#include <vector>

#include "common/widgets.h"
#include "evaluate/evaluate.h"
#include "solve/solve.h"

namespace limbwave::ui {

struct Verdict {
  Tone tone = Tone::kUnknown;
  QString text;
  QString remedy;  ///< May be empty.
};

/// The report of a driver box or of other sensors' logs: it has neither a line nor single accelerometers to judge.
bool is_by_body_filter(const solve::QualityReport& report);
/// The whole report in one sentence: the worst of its parts. Where the truth is known (null: it is not) it has the last
/// word: a figure that is off is not good, however well its sensors were heard.
Verdict overall_verdict(const solve::QualityReport& report, const evaluate::Evaluation* evaluation = nullptr);
/// One sensor: usable and trusted fractions, gravity at rest.
Verdict sensor_verdict(const solve::SensorQuality& sensor);
/// The line: lost cycles, clipping.
Verdict line_verdict(const decode::LineInStatus& line);
/// Facts of the line with their units, one each.
std::vector<QString> line_facts(const decode::LineInStatus& line);
Verdict diagnostic_verdict(const Diagnostic& diagnostic);
/// With a true minus sign, which is as wide as a digit: "−19.1".
QString signed_number(double value, int decimals);
/// "2.1° mean, 4.8° at most"
QString error_text(double mean_deg, double max_deg);
/// A fraction as percent that never rounds up to a false 100 %: "99.9 %".
QString percent(double fraction);
QString smoothing_name(solve::Smoothing smoothing);
QString smoothing_hint(solve::Smoothing smoothing);

}  // namespace limbwave::ui
