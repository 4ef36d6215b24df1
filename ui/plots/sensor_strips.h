/// All accelerations of the last ten seconds: a row per sensor with its health in shape, colour and words, a strip per
/// axis with its value.
#pragma once

#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

#include "solve/live_session.h"

namespace limbwave::ui {

class SensorStrips : public QWidget {
  Q_OBJECT
 public:
  explicit SensorStrips(QWidget* parent = nullptr);
  void set_sensors(const QStringList& names);
  void set_snapshot(std::shared_ptr<const solve::LiveSnapshot> snapshot);
  void set_selected_sensor(int sensor);
  /// Markers of the running recording, at times of the stream.
  struct Mark {
    double stream_time_s = 0.0;
    QString text;
  };
  void set_marks(std::vector<Mark> marks);
  [[nodiscard]] QSize sizeHint() const override { return {800, 420}; }
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void sensor_clicked(int sensor);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QRectF row(int sensor) const;
  [[nodiscard]] QRectF strip(int sensor, int axis) const;
  void paint_card(QPainter& painter, int sensor) const;
  void paint_strip(QPainter& painter, int sensor, int axis) const;
  void paint_marks(QPainter& painter) const;
  void update_ranges();

  QStringList sensors_;
  int selected_ = -1;
  std::shared_ptr<const solve::LiveSnapshot> snapshot_;
  std::vector<Mark> marks_;
  std::vector<double> ranges_;  ///< Per sensor, m/s².
};

}  // namespace limbwave::ui
