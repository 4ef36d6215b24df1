/// The health of sensors and of a recording in words and in short.
#pragma once

#include <QString>

#include "solve/live_session.h"
#include "solve/sensor_health.h"

namespace limbwave::ui {

/// Whether samples of the running capture are being lost.
enum class Loss {
  kNone,
  kPast,  ///< Some were; what follows is whole.
  kNow,   ///< They are, or nobody knows whether it is over.
};
Loss loss_of(const solve::LiveSnapshot& snapshot);

/// Translated by `health.code` where the code says it all; texts that carry numbers are the core's own, in English.
QString health_text(const solve::SensorHealth& health);

}  // namespace limbwave::ui
