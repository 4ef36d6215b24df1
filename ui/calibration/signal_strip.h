/// The newest seconds of one sensor's three axes, in nominal g.
#pragma once

#include <QWidget>
#include <deque>

#include "body/rig.h"
#include "decode/slot_alignment.h"

namespace limbwave::ui {

class SignalStrip : public QWidget {
  Q_OBJECT
 public:
  explicit SignalStrip(QWidget* parent = nullptr);
  /// Copies the part that is shown: `seconds` up to the newest reading of sensor `sensor`.
  void set_readings(const std::deque<decode::AccelerationFrame>& frames, int sensor, const body::LineInSignal& signal,
                    double seconds);
  [[nodiscard]] QSize sizeHint() const override { return {480, 150}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Reading {
    double time_s;
    Eigen::Vector3d g;
    bool usable;
  };
  std::vector<Reading> readings_;
  double seconds_ = 8.0;
};

}  // namespace limbwave::ui
