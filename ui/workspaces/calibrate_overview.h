/// The rig's sensors and what is known of each: range, mounting, a verdict in
/// colour and words, what to do next.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <optional>
#include <vector>

#include "calibration/calibration_desk.h"
#include "calibration/gauges.h"

namespace limbwave::ui {

/// One sensor of the overview. A click selects it everywhere.
class SensorRow : public QFrame {
  Q_OBJECT
 public:
  SensorRow(int sensor, QWidget* parent);
  void set_content(const QString& title, const QString& serial, const CalibrationState& range,
                   const CalibrationState& mount, bool mountable);
  void set_selected(bool selected);

 Q_SIGNALS:
  void chosen(int sensor);
  void range_wanted(int sensor);
  void mount_wanted(int sensor);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  int sensor_;
  bool selected_ = false;
  QLabel* title_;
  QLabel* serial_;
  VerdictBadge* range_;
  VerdictBadge* mount_;
  QPushButton* repeat_range_;
  QPushButton* repeat_mount_;
};

class CalibrateOverview : public QWidget {
  Q_OBJECT
 public:
  explicit CalibrateOverview(CalibrationDesk& desk, QWidget* parent = nullptr);
  void refresh();
  /// What a solve of the open take used; it stands where the take itself carries nothing measured.
  void set_used(std::optional<calibrate::RigCalibration> used);

 Q_SIGNALS:
  /// Empty: the wizard's own choice.
  void range_wanted(const std::vector<int>& sensors);
  void mount_wanted(int sensor, bool only);
  void recording_wanted();

 private:
  void refresh_rows();
  void refresh_sources();
  /// The take's or the capture's calibration, completed by what the solve used; `from_solve` counts what came from it.
  [[nodiscard]] calibrate::RigCalibration shown(int* from_solve = nullptr) const;

  CalibrationDesk& desk_;
  std::optional<calibrate::RigCalibration> used_;
  QLabel* headline_;
  QLabel* subline_;
  QPushButton* range_;
  QPushButton* mount_;
  QPushButton* from_take_;
  QPushButton* library_;
  QVBoxLayout* rows_layout_;
  std::vector<SensorRow*> rows_;
};

/// How far a rig's calibration is: "5 of 5 ranges, 3 of 5 mountings", and what
/// comes next.
struct CalibrationSummary {
  QString headline, next;
  int ranges = 0, mounts = 0;
};
CalibrationSummary summarize(const body::Rig& rig, const calibrate::RigCalibration& calibration);

}  // namespace limbwave::ui
