/// Sensors to tick, each with what is known about its calibration.
#pragma once

#include <QCheckBox>
#include <QVBoxLayout>
#include <QWidget>
#include <functional>
#include <vector>

#include "body/rig.h"
#include "calibration/gauges.h"

namespace limbwave::ui {

class SensorChooser : public QWidget {
  Q_OBJECT
 public:
  explicit SensorChooser(QWidget* parent = nullptr);
  /// Shows these sensors of the rig; `state` tells what is known of one.
  void set_sensors(const body::Rig& rig, const std::vector<int>& shown, const std::vector<int>& chosen,
                   const std::function<CalibrationState(int)>& state);

 Q_SIGNALS:
  void toggled(int sensor, bool on);

 private:
  void add_row(int sensor);
  QVBoxLayout* rows_;
  std::vector<int> shown_;
  std::vector<QCheckBox*> checks_;
  std::vector<VerdictBadge*> badges_;
};

/// "forearm", and its serial where it has one.
QString sensor_title(const body::Rig& rig, int sensor);

}  // namespace limbwave::ui
