/// The live page of the range wizard: what to do now, the sphere, the box, how
/// fast, three signals.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "calibration/gauges.h"
#include "calibration/range_wizard_model.h"
#include "calibration/sensor_cube.h"
#include "calibration/signal_strip.h"
#include "calibration/sphere_map.h"

namespace limbwave::ui {

/// What is told about one sensor, short enough to be read from two metres, and
/// the longer sentence.
struct AdviceText {
  QString big, sentence;
};
AdviceText advice_text(const RangeSensorState& state, const QString& sensor, bool all_enough);

class RangeTurnPage : public QWidget {
  Q_OBJECT
 public:
  explicit RangeTurnPage(RangeWizardModel& model, QWidget* parent = nullptr);
  /// A new turning begins.
  void restart();
  void refresh();
  [[nodiscard]] QString big_text() const { return big_->text(); }

 private:
  void refresh_chips();
  RangeWizardModel& model_;
  QLabel* big_;
  QLabel* sentence_;
  SphereMap* map_;
  SensorCube* cube_;
  RateGauge* gauge_;
  QLabel* numbers_;
  QProgressBar* bar_;
  QLabel* strip_title_;
  SignalStrip* strip_;
  QHBoxLayout* chip_row_;
  std::vector<QPushButton*> chips_;
  QPushButton* start_over_;
  int shown_ = -1;
};

}  // namespace limbwave::ui
