#include "workspaces/status_facts.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "common/core_text.h"
#include "common/format.h"
#include "common/health_text.h"
#include "common/latency_text.h"
#include "solve/live_body_session.h"

namespace limbwave::ui {
namespace {

/// Red is for losing data: without a recording the same trouble is a warning.
Tone trouble(const StatusInput& in) {
  return in.recording ? Tone::kDanger : Tone::kWarning;
}

/// lupdate knows this as the context "StatusFacts".
struct StatusFacts {
  Q_DECLARE_TR_FUNCTIONS(StatusFacts)
 public:
  static StatusFact record(const StatusInput& in);
  static StatusFact disk(const StatusInput& in);
  static StatusFact sensors(const StatusInput& in);
  static StatusFact sync(const StatusInput& in);
  static StatusFact box(const StatusInput& in);
  static StatusFact latency(const StatusInput& in);
};

StatusFact StatusFacts::record(const StatusInput& in) {
  StatusFact fact{QStringLiteral("record"), Tone::kUnknown, tr("not recording"), tr("Nothing is being recorded."),
                  QStringLiteral("record")};
  const solve::LiveSnapshot* live = in.snapshot;
  if (live != nullptr && !live->recording_error.empty()) {
    fact.tone = Tone::kDanger;
    fact.text = tr("recording stopped");
    fact.detail = core_text(live->recording_error);
  } else if (in.aside && (in.recording || in.finishing)) {
    fact.text = tr("calibrating");
    fact.detail = tr("A calibration is under way; its raw signals are kept in a take of their own.");
    fact.workspace = QStringLiteral("calibrate");
  } else if (in.finishing) {
    fact.text = tr("closing the take");
    fact.detail = tr("The last samples are being written.");
  } else if (in.recording && live != nullptr) {
    const Loss loss = loss_of(*live);
    const bool losing = loss != Loss::kNone;
    fact.tone = loss == Loss::kNow ? Tone::kDanger : losing ? Tone::kWarning : Tone::kGood;
    fact.text = tr("REC %1").arg(format_clock_tenths(live->recorded_s));
    fact.detail =
        losing && live->box ? tr("Samples that were lost so far: %1, in %2 gaps. What follows keeps its time.")
                                  .arg(live->counters.dropped_frames)
                                  .arg(live->counters.overflows)
        : losing ? tr("Times at which the device lost samples: %1. Close other programs, or choose a lower rate.")
                       .arg(live->counters.overflows)
                 : tr("Recording. No sample has been lost.");
    if (losing) {
      fact.text += QLatin1Char(' ') + (loss == Loss::kNow ? tr("(losing samples)") : tr("(samples were lost)"));
    }
  } else if (!in.problem.isEmpty()) {
    fact.tone = trouble(in);
    fact.text = in.state == LiveState::kOff ? tr("no device") : tr("device lost");
    fact.detail = in.problem + QLatin1Char(' ') + in.remedy;
    fact.topic = QStringLiteral("devices");
  }
  return fact;
}

StatusFact StatusFacts::disk(const StatusInput& in) {
  StatusFact fact{QStringLiteral("disk"), Tone::kUnknown, tr("disk –"), {}, QStringLiteral("disk")};
  if (!(in.disk_left_s >= 0.0)) {
    return fact;
  }
  const double left = in.disk_left_s;
  fact.tone = left < 300.0 ? trouble(in) : left < 3600.0 ? Tone::kWarning : Tone::kGood;
  fact.text = tr("disk %1").arg(format_left(left));
  fact.detail = left < 3600.0 ? tr("The disk is full after %1 of recording. Free some space or choose another folder.")
                                    .arg(format_left(left))
                              : tr("The disk has room for %1 of recording.").arg(format_left(left));
  return fact;
}

StatusFact StatusFacts::sensors(const StatusInput& in) {
  StatusFact fact{QStringLiteral("sensors"), Tone::kUnknown, tr("sensors –"), tr("Known while a device is open."),
                  QStringLiteral("sensors")};
  if (in.snapshot == nullptr || in.snapshot->health.empty()) {
    return fact;
  }
  const auto& health = in.snapshot->health;
  std::size_t working = 0;
  for (std::size_t i = 0; i < health.size(); ++i) {
    const solve::SensorHealth& sensor = health[i];
    working += sensor.state == solve::HealthState::kGood || sensor.state == solve::HealthState::kWarning ? 1U : 0U;
    const Tone tone = sensor.state == solve::HealthState::kBad       ? trouble(in)
                      : sensor.state == solve::HealthState::kWarning ? Tone::kWarning
                      : sensor.state == solve::HealthState::kGood    ? Tone::kGood
                                                                     : Tone::kUnknown;
    // The first of the worst ones gets the word.
    const bool worse = tone != Tone::kUnknown && (fact.tone == Tone::kUnknown || tone > fact.tone);
    if (worse) {
      fact.tone = tone;
      if (tone != Tone::kGood) {
        fact.detail = tr("Sensor %1: %2").arg(i + 1).arg(health_text(sensor));
        fact.topic = QStringLiteral("sensor:%1").arg(i);
        fact.workspace = sensor.code == "no-calibration" ? QStringLiteral("calibrate") : QStringLiteral("capture");
      }
    }
  }
  if (fact.tone == Tone::kGood) {
    fact.detail = tr("All sensors send plausible accelerations.");
  } else if (fact.tone == Tone::kUnknown) {
    fact.detail = tr("The sensors have not been heard yet.");
  }
  fact.text = tr("sensors %1/%2").arg(working).arg(health.size());
  return fact;
}

StatusFact StatusFacts::sync(const StatusInput& in) {
  StatusFact fact{QStringLiteral("sync"), Tone::kUnknown, tr("sync –"), tr("Known while a device is open."),
                  QStringLiteral("line")};
  if (in.snapshot == nullptr) {
    return fact;
  }
  if (in.snapshot->box) {
    return box(in);
  }
  const decode::LineInStatus& line = in.snapshot->line;
  if (!in.snapshot->source_alive) {
    fact.tone = trouble(in);
    fact.text = tr("no signal");
    fact.detail = tr("The device has stopped sending.");
  } else if (line.locked) {
    fact.tone = Tone::kGood;
    fact.text = tr("sync %1 Hz").arg(QLocale().toString(line.cycle_rate_hz, 'f', 1));
    fact.detail = line.lost_cycles > 0
                      ? tr("In step with the board; cycles lost since the start: %1.").arg(line.lost_cycles)
                      : tr("In step with the board; no cycle has been lost.");
  } else if (line.decided || line.cycles > 0) {
    fact.tone = trouble(in);
    fact.text = tr("no sync");
    fact.detail = tr("The board's clock is not heard on the right channel. Look at the scope.");
  } else {
    fact.text = tr("listening");
    fact.detail = tr("Looking for the board's clock.");
  }
  return fact;
}

StatusFact StatusFacts::box(const StatusInput& in) {
  StatusFact fact{QStringLiteral("sync"), Tone::kUnknown, tr("box –"), tr("The driver box has not been heard yet."),
                  QStringLiteral("line")};
  const solve::LiveBodySnapshot& box = *in.snapshot->box;
  if (!box.connected) {
    fact.tone = trouble(in);
    fact.text = tr("box away");
    fact.detail = tr("The driver box does not answer. It is taken back by itself as soon as it does.");
  } else if (!box.wires.empty()) {
    fact.tone = box.counters.gaps == 0 ? Tone::kGood : Tone::kWarning;
    fact.text = tr("box: %n gap(s)", nullptr, static_cast<int>(box.counters.gaps));
    fact.detail = tr("Gaps on the line: %1, with %2 samples; reconnections: %3. Every gap has its length in the take.")
                      .arg(box.counters.gaps)
                      .arg(box.counters.lost_frames)
                      .arg(box.counters.reconnects);
  }
  return fact;
}

StatusFact StatusFacts::latency(const StatusInput& in) {
  StatusFact fact{
      QStringLiteral("latency"), Tone::kUnknown, tr("latency –"),
      tr("From the sensor to the screen, beyond the device's own buffer; known while a skeleton is shown live."),
      QStringLiteral("line")};
  if (in.latency.poses == 0) {
    return fact;
  }
  const solve::LatencyFigures& total = in.latency.of(solve::LatencyStage::kTotal);
  fact.tone = total.p95_s <= solve::kLatencyBudget_s ? Tone::kGood : Tone::kWarning;
  fact.text = tr("latency %1 ms").arg(std::lround(total.mean_s * 1000.0));
  fact.detail = latency_sentences(in.latency, in.snapshot != nullptr ? in.snapshot->device_latency_s : 0.0);
  return fact;
}

}  // namespace

std::vector<StatusFact> status_facts(const StatusInput& input) {
  return {StatusFacts::record(input), StatusFacts::disk(input), StatusFacts::sensors(input), StatusFacts::sync(input),
          StatusFacts::latency(input)};
}

}  // namespace limbwave::ui
