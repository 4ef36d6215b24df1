#include "common/health_text.h"

#include <QCoreApplication>

#include "common/core_text.h"

namespace limbwave::ui {
namespace {

/// lupdate knows this as the context "Health".
struct Health {
  Q_DECLARE_TR_FUNCTIONS(Health)
};

}  // namespace

QString health_text(const solve::SensorHealth& health) {
  if (health.text.empty()) {
    return Health::tr("not heard yet");
  }
  if (health.code == "good") {
    return Health::tr("good");
  }
  if (health.code == "no-signal") {
    return health.state == solve::HealthState::kBad ? Health::tr("reads nothing; check that the sensor is plugged in")
                                                    : Health::tr("no readings yet");
  }
  if (health.code == "no-calibration") {
    return Health::tr("never calibrated; calibrate its range");
  }
  return core_text(health.text);
}

}  // namespace limbwave::ui
