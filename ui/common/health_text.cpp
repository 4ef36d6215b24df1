#include "common/health_text.h"

#include <QCoreApplication>

#include "common/core_text.h"
#include "solve/live_body_session.h"

namespace limbwave::ui {
namespace {

/// lupdate knows this as the context "Health".
struct Health {
  Q_DECLARE_TR_FUNCTIONS(Health)
};

}  // namespace

Loss loss_of(const solve::LiveSnapshot& snapshot) {
  const bool lost = snapshot.counters.overflows > 0 || snapshot.counters.dropped_frames > 0;
  if (snapshot.box) {
    return !snapshot.box->connected ? Loss::kNow : lost ? Loss::kPast : Loss::kNone;
  }
  return lost ? Loss::kNow : Loss::kNone;
}

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
