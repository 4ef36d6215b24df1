/// The facts that ruin takes when nobody sees them, as the status strip words them. A pure function, tested without a
/// window.
#pragma once

#include <QString>
#include <vector>

#include "common/live_model.h"
#include "common/widgets.h"

namespace limbwave::ui {

struct StatusFact {
  QString id;  ///< "record", "disk", "sensors", "sync", "latency"
  Tone tone = Tone::kUnknown;
  QString text;                                   ///< "disk 23 h"
  QString detail;                                 ///< Tooltip: the whole sentence, and what a click does.
  QString topic;                                  ///< Where a click leads to: "sensors", "sensor:2", "line" ...
  QString workspace = QStringLiteral("capture");  ///< And in which workspace.
};

/// What the facts are made of; plain, so that tests can make it up.
struct StatusInput {
  LiveState state = LiveState::kOff;
  bool recording = false, finishing = false;
  bool aside = false;                             ///< The raw signals of a calibration are recorded, not a take.
  const solve::LiveSnapshot* snapshot = nullptr;  ///< May be null.
  double disk_left_s = -1.0;                      ///< Negative: not known.
  solve::LatencyReport latency = {};              ///< Without poses: not known.
  QString problem, remedy;                        ///< Of the live model.
};

std::vector<StatusFact> status_facts(const StatusInput& input);

}  // namespace limbwave::ui
