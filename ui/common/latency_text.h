/// The age of what is on screen, in words.
#pragma once

#include <QString>

#include "solve/live_latency.h"

namespace limbwave::ui {

/// One line: "sensor to screen 41 ms mean, 55 ms for 95 %, 63 ms at most".
QString latency_line(const solve::LatencyReport& report);
/// The whole account: figures, where the time goes, and what is not counted. `device_s`: the device's own buffer.
QString latency_sentences(const solve::LatencyReport& report, double device_s);

}  // namespace limbwave::ui
