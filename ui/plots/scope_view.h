/// The live scope of both channels: triggered at the cycle's start so that it stands still, slots marked, numbered and
/// coloured by sensor.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <memory>

#include "plots/plot_geometry.h"
#include "solve/live_session.h"

namespace limbwave::ui {

class ScopeView : public QWidget {
  Q_OBJECT
 public:
  explicit ScopeView(QWidget* parent = nullptr);
  /// Names of the sensors, in the rig's order.
  void set_sensors(const QStringList& names, int slot_count);
  /// Null: nothing is heard.
  void set_snapshot(std::shared_ptr<const solve::LiveSnapshot> snapshot);
  void set_selected_sensor(int sensor);
  [[nodiscard]] QSize sizeHint() const override { return {800, 260}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {400, 180}; }

 Q_SIGNALS:
  void sensor_clicked(int sensor);  ///< −1: beside all of them.

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  struct Bands;
  [[nodiscard]] Bands bands() const;
  void paint_slots(QPainter& painter, const Bands& areas, const ScopeWindow& window, const AxisMap& x) const;
  void paint_channel(QPainter& painter, const QRectF& band, const ScopeWindow& window, const AxisMap& x, int channel,
                     bool slots_known) const;
  void paint_ground(QPainter& painter, const QRectF& band) const;
  [[nodiscard]] double peak(int channel) const;

  QStringList sensors_;
  int slot_count_ = 16;
  int selected_ = -1;
  std::shared_ptr<const solve::LiveSnapshot> snapshot_;
  std::array<double, 2> range_{1.0, 1.0};  ///< Of full scale, shown per channel.
  std::array<int, 2> quiet_{0, 0};         ///< Snapshots for which a smaller range would have done.
};

}  // namespace limbwave::ui
