#include "workspaces/solve/quality_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "common/core_text.h"
#include "common/shown_names.h"

namespace limbwave::ui {

namespace {

struct Quality {
  Q_DECLARE_TR_FUNCTIONS(Quality)
};

// Below these a person sees the effect in the animation.
constexpr double kUsableGood = 0.98, kUsableBad = 0.90;
constexpr double kTrustedGood = 0.5;
constexpr double kNormGood = 0.02, kNormBad = 0.05;  // Of g, at rest.
constexpr double kInclinationGood = 2.0;             // Degrees, mean: what the line-in paper reaches.
constexpr double kLostGood = 0.002, kLostBad = 0.02;

QString number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

Tone grade(double value, double good, double bad) {
  return value >= good ? Tone::kGood : (value >= bad ? Tone::kWarning : Tone::kDanger);
}

int severity(Tone tone) {
  switch (tone) {
    case Tone::kDanger:
      return 3;
    case Tone::kWarning:
      return 2;
    case Tone::kUnknown:
      return 1;
    case Tone::kGood:
      break;
  }
  return 0;
}

}  // namespace

QString percent(double fraction) {
  if (!std::isfinite(fraction)) {
    return Quality::tr("–");
  }
  const double value = 100.0 * std::clamp(fraction, 0.0, 1.0);
  if (value >= 100.0) {
    return Quality::tr("100 %");
  }
  if (value > 99.0) {
    return Quality::tr("%1 %").arg(number(std::min(99.9, std::floor(value * 10) / 10), 1));
  }
  return Quality::tr("%1 %").arg(number(value, 0));
}

Verdict sensor_verdict(const solve::SensorQuality& sensor) {
  const QString name = shown_name(sensor.sensor);
  if (sensor.usable < kUsableGood) {
    return {grade(sensor.usable, kUsableGood, kUsableBad),
            Quality::tr("%1: only %2 of the readings are usable.").arg(name, percent(sensor.usable)),
            Quality::tr("Check its plug and cable, and that the level does not clip.")};
  }
  const double off = std::abs(sensor.mean_norm_g - 1.0);
  if (sensor.mean_norm_g > 0.0 && off > kNormGood) {
    return {Tone::kWarning,
            Quality::tr("%1: reads %2 g at rest instead of 1.").arg(name, number(sensor.mean_norm_g, 3)),
            off > kNormBad ? Quality::tr("Calibrate its range: turn it slowly about all axes.")
                           : Quality::tr("Calibrate its range again when you have a minute.")};
  }
  if (sensor.trusted < kTrustedGood) {
    return {Tone::kWarning,
            Quality::tr("%1: gravity alone explains only %2 of the readings.").arg(name, percent(sensor.trusted)),
            Quality::tr("The limb moved fast. Smoothing the whole chain helps.")};
  }
  return {Tone::kGood, Quality::tr("%1: good.").arg(name), {}};
}

Verdict line_verdict(const decode::LineInStatus& line) {
  const double all = static_cast<double>(line.cycles + line.lost_cycles);
  const double lost = all > 0 ? static_cast<double>(line.lost_cycles) / all : 0.0;
  if (!line.decided && line.cycles == 0) {
    return {Tone::kDanger, Quality::tr("No signal was found on the line."),
            Quality::tr("Check that the recording is of the sensor board, in stereo.")};
  }
  if (lost > kLostGood) {
    return {lost > kLostBad ? Tone::kDanger : Tone::kWarning,
            Quality::tr("%1 of the signal was lost.").arg(percent(lost)),
            Quality::tr("Look at the events on the timeline for when, and check plugs and levels.")};
  }
  if (line.clipped_slots > 0) {
    return {Tone::kWarning,
            Quality::tr("%1 readings touched full scale.").arg(QLocale().toString(qlonglong(line.clipped_slots))),
            Quality::tr("Turn the recording level down before the next take.")};
  }
  return {Tone::kGood, Quality::tr("The line was heard without loss."), {}};
}

std::vector<QString> line_facts(const decode::LineInStatus& line) {
  std::vector<QString> facts;
  if (line.cycle_rate_hz > 0) {
    facts.push_back(Quality::tr("%1 readings a second, clock jitter %2 %")
                        .arg(number(line.cycle_rate_hz, 2), number(100 * line.clock_jitter, 2)));
  }
  facts.push_back(
      Quality::tr("%1 cycles heard, %2 lost")
          .arg(QLocale().toString(qlonglong(line.cycles)), QLocale().toString(qlonglong(line.lost_cycles))));
  if (line.left_coupling_hz > 0) {
    facts.push_back(
        line.coupling_sd_hz > 0
            ? Quality::tr("Coupling of the sound card %1 ± %2 Hz, undone")
                  .arg(number(line.left_coupling_hz, 2), number(line.coupling_sd_hz, 2))
            : Quality::tr("Coupling of the sound card %1 Hz, undone").arg(number(line.left_coupling_hz, 2)));
  }
  if (line.noise > 0) {
    facts.push_back(Quality::tr("Noise %1 dB").arg(number(20 * std::log10(line.noise), 0)));
  }
  if (line.swapped) {
    facts.push_back(Quality::tr("Left and right were swapped; taken care of"));
  }
  if (line.left_inverted || line.right_inverted) {
    facts.push_back(Quality::tr("The signal came inverted; taken care of"));
  }
  return facts;
}

Verdict diagnostic_verdict(const Diagnostic& diagnostic) {
  const Tone tone = diagnostic.severity == Severity::kInfo      ? Tone::kUnknown
                    : diagnostic.severity == Severity::kWarning ? Tone::kWarning
                                                                : Tone::kDanger;
  QString text = core_text(diagnostic.message);
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  if (diagnostic.time_s >= 0.0) {
    text = Quality::tr("At %1 s: %2").arg(number(diagnostic.time_s, 1), text);
  }
  QString remedy = core_text(diagnostic.remedy);
  if (!remedy.isEmpty()) {
    remedy[0] = remedy[0].toUpper();
  }
  return {tone, text, remedy};
}

bool is_by_body_filter(const solve::QualityReport& report) {
  return report.sensors.empty();
}

// The body filter says all that it has to say in findings: it knows neither cycles nor a line.
static Verdict body_verdict(const solve::QualityReport& report) {
  const Diagnostic* worst_one = nullptr;
  for (const Diagnostic& one : report.diagnostics) {
    if (one.severity != Severity::kInfo && (worst_one == nullptr || one.severity > worst_one->severity)) {
      worst_one = &one;
    }
  }
  if (worst_one == nullptr) {
    return {Tone::kGood, Quality::tr("Good: all boards were heard, and agree."), {}};
  }
  return diagnostic_verdict(*worst_one);
}

Verdict overall_verdict(const solve::QualityReport& report, const evaluate::Evaluation* evaluation) {
  if (is_by_body_filter(report)) {
    return body_verdict(report);
  }
  Verdict worst_part = line_verdict(report.line);
  for (const solve::SensorQuality& sensor : report.sensors) {
    const Verdict verdict = sensor_verdict(sensor);
    if (severity(verdict.tone) > severity(worst_part.tone)) {
      worst_part = verdict;
    }
  }
  if (worst(report.diagnostics) == Severity::kError && worst_part.tone != Tone::kDanger) {
    const auto found = std::find_if(report.diagnostics.begin(), report.diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::kError; });
    return diagnostic_verdict(*found);
  }
  if (worst_part.tone != Tone::kGood) {
    return worst_part;
  }
  // Signals may be heard perfectly and still mean the wrong directions.
  const Diagnostic* calibration = nullptr;
  for (const Diagnostic& one : report.diagnostics) {
    const bool about =
        one.code.rfind("calibration.", 0) == 0 || one.code.rfind("limb.", 0) == 0 || one.code.rfind("range.", 0) == 0;
    if (about && (calibration == nullptr || one.severity > calibration->severity)) {
      calibration = &one;
    }
  }
  if (calibration != nullptr) {
    const Verdict verdict = diagnostic_verdict(*calibration);
    return {Tone::kWarning,
            calibration->severity == Severity::kInfo
                ? Quality::tr("Usable: every sensor was heard, but: %1").arg(verdict.text)
                : Quality::tr("Every sensor was heard, but: %1").arg(verdict.text),
            verdict.remedy};
  }
  if (evaluation != nullptr && evaluation->all.inclination_mean_deg > kInclinationGood) {
    return {Tone::kWarning,
            Quality::tr("Every sensor was heard, but the figure is off by %1.")
                .arg(error_text(evaluation->all.inclination_mean_deg, evaluation->all.inclination_max_deg)),
            Quality::tr("Fast movement does that: try another smoothing, and check the mounting.")};
  }
  return {Tone::kGood, Quality::tr("Good: every sensor was heard and trusted."), {}};
}

QString signed_number(double value, int decimals) {
  const QString digits = number(std::abs(value), decimals);
  const bool zero = digits == number(0.0, decimals);
  return value < 0.0 && !zero ? QChar(0x2212) + digits : digits;
}

QString error_text(double mean_deg, double max_deg) {
  return Quality::tr("%1° mean, %2° at most").arg(number(mean_deg, 2), number(max_deg, 1));
}

QString smoothing_name(solve::Smoothing smoothing) {
  switch (smoothing) {
    case solve::Smoothing::kNone:
      return Quality::tr("None");
    case solve::Smoothing::kAdaptive:
      return Quality::tr("Adaptive");
    case solve::Smoothing::kBridging:
      return Quality::tr("Bridging");
    case solve::Smoothing::kChain:
      break;
  }
  return Quality::tr("Whole chain");
}

QString smoothing_hint(solve::Smoothing smoothing) {
  switch (smoothing) {
    case solve::Smoothing::kNone:
      return Quality::tr("Every frame by itself, as measured.");
    case solve::Smoothing::kAdaptive:
      return Quality::tr("Follows trusted readings closely and smooths the others. No lag.");
    case solve::Smoothing::kBridging:
      return Quality::tr("As adaptive, and carries the limb on through bursts of acceleration.");
    case solve::Smoothing::kChain:
      break;
  }
  return Quality::tr(
      "All limbs together: what their own swinging makes the sensors feel is taken into account. Check the bone "
      "lengths.");
}

}  // namespace limbwave::ui
