/// One sensor's verdict: what was found, in a number, and what to do with it.
#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "calibration/gauges.h"
#include "calibration/sphere_map.h"
#include "calibration/wizard_model.h"

namespace limbwave::ui {

struct VerdictRowContent {
  QString title, serial;
  CalibrationState state;
  QString text;        ///< The reason.
  QString comparison;  ///< Other numbers: both methods, the attempt before.
  Decision decision = Decision::kOpen;
  bool acceptable = false;
  bool repeatable = false;
};

class VerdictRow : public QFrame {
  Q_OBJECT
 public:
  /// Buttons are named accept_N, repeat_N, discard_N.
  explicit VerdictRow(int sensor, bool with_map, QWidget* parent = nullptr);
  void set_content(const VerdictRowContent& content);
  void set_visited(const SphereMap::Cells& visited) { map_->set_visited(visited); }
  [[nodiscard]] int sensor() const { return sensor_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 Q_SIGNALS:
  void accept(int sensor);
  void repeat(int sensor);
  void discard(int sensor);

 private:
  int sensor_;
  QLabel* title_;
  QLabel* serial_;
  VerdictBadge* badge_;
  SphereMap* map_;
  QLabel* text_;
  QLabel* comparison_;
  QBoxLayout* outer_ = nullptr;
  QPushButton* accept_;
  QPushButton* repeat_;
  QPushButton* discard_;
};

/// The state of a refused attempt.
CalibrationState refused_state();

}  // namespace limbwave::ui
