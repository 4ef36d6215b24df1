/// The words of a sensor's health in the user's language.
#pragma once

#include <QString>

#include "solve/sensor_health.h"

namespace limbwave::ui {

/// Translated by `health.code` where the code says it all; texts that carry numbers are the core's own, in English.
QString health_text(const solve::SensorHealth& health);

}  // namespace limbwave::ui
