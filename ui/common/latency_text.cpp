#include "common/latency_text.h"

#include <QCoreApplication>
#include <cmath>

namespace limbwave::ui {
namespace {

using solve::LatencyStage;

/// lupdate knows this as the context "LatencyText".
struct LatencyText {
  Q_DECLARE_TR_FUNCTIONS(LatencyText)
};

QString ms(double seconds) {
  return QString::number(std::lround(seconds * 1000.0));
}

}  // namespace

QString latency_line(const solve::LatencyReport& report) {
  const solve::LatencyFigures& total = report.of(LatencyStage::kTotal);
  return LatencyText::tr("sensor to screen %1 ms mean, %2 ms for 95 %, %3 ms at most")
      .arg(ms(total.mean_s), ms(total.p95_s), ms(total.max_s));
}

QString latency_sentences(const solve::LatencyReport& report, double device_s) {
  const solve::LatencyFigures& total = report.of(LatencyStage::kTotal);
  const auto mean = [&](LatencyStage stage) { return ms(report.of(stage).mean_s); };
  const bool drawn = report.of(LatencyStage::kDraw).max_s > 0.0;
  const QString figures =
      (drawn ? LatencyText::tr("From the board's reading of its oldest sensor to the finished picture: %1 ms on "
                               "average, %2 ms for 95 of 100 poses, %3 ms at most (%4 poses).")
             : LatencyText::tr("From the board's reading of its oldest sensor to the solved pose (nothing is drawn): "
                               "%1 ms on average, %2 ms for 95 of 100 poses, %3 ms at most (%4 poses)."))
          .arg(ms(total.mean_s), ms(total.p95_s), ms(total.max_s))
          .arg(report.poses);
  const QString parts =
      LatencyText::tr(
          "On average: one round of the board %1 ms, waiting for samples %2 ms, solving %3 ms, handing over "
          "%4 ms, drawing %5 ms.")
          .arg(mean(LatencyStage::kCycle), mean(LatencyStage::kArrival), mean(LatencyStage::kSolve),
               mean(LatencyStage::kHandover), mean(LatencyStage::kDraw));
  const QString rest =
      LatencyText::tr("Not counted: the sound card's own buffer (%1 ms) and what the screen itself needs.")
          .arg(ms(device_s));
  return figures + QLatin1Char(' ') + parts + QLatin1Char(' ') + rest;
}

}  // namespace limbwave::ui
