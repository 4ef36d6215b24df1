/// The level of one channel on a scale in dB, with the range in which it should be.
#pragma once

#include <QString>
#include <QWidget>

namespace limbwave::ui {

class LevelMeter : public QWidget {
  Q_OBJECT
 public:
  explicit LevelMeter(const QString& title, QWidget* parent = nullptr);
  /// Peak of the last second, fraction of full scale; negative: nothing is heard.
  void set_level(double peak, bool clipping);
  [[nodiscard]] QSize sizeHint() const override { return {240, 34}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 34}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title_;
  double peak_ = -1.0;
  bool clipping_ = false;
};

/// Position 0..1 of a level on a scale from −60 dB to 0 dB.
double level_position(double fraction);

inline constexpr double kLevelTooLow = 0.03;   ///< −30 dB: 16 bits then leave less than 11 for the signal.
inline constexpr double kLevelTooHigh = 0.95;  ///< −0.4 dB: the next stronger movement clips.

}  // namespace limbwave::ui
