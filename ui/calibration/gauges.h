/// Instruments of the wizards: how fast it is turned, who moves, the countdown, a verdict. All paint themselves and say
/// in words what they say in colour.
#pragma once

#include <QWidget>
#include <vector>

#include "calibration/calibration_words.h"

namespace limbwave::ui {

/// Colour of a finding. "Repeat" is vermilion: red is kept for data that is being lost.
QColor finding_color(const QPalette& palette, Tone tone);

/// Turning rate against the limit, with its word.
class RateGauge : public QWidget {
  Q_OBJECT
 public:
  explicit RateGauge(QWidget* parent = nullptr);
  /// Both in g per second; `jerky`: slow enough, but not smooth.
  void set_rate(double rate, double limit, bool jerky, bool signal);
  [[nodiscard]] const QString& word() const { return word_; }
  [[nodiscard]] QSize sizeHint() const override { return {320, 52}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 52}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double rate_ = 0.0, limit_ = 1.0;
  Tone tone_ = Tone::kUnknown;
  QString word_;
};

/// One row per sensor: its movement against the threshold of stillness.
class MovementBars : public QWidget {
  Q_OBJECT
 public:
  struct Row {
    QString name;
    double movement_g = 0.0;
    bool has_signal = true;
    bool heard = true;  ///< False: nothing to say yet.
  };
  explicit MovementBars(QWidget* parent = nullptr);
  void set_rows(std::vector<Row> rows, double threshold_g);
  /// "moves 45 mg", as the row says it.
  [[nodiscard]] static QString row_words(const Row& row, double threshold_g);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Row> rows_;
  double threshold_g_ = 0.02;
};

/// A number that can be read from across the room, in a ring that runs out or fills up.
class CountdownDial : public QWidget {
  Q_OBJECT
 public:
  explicit CountdownDial(QWidget* parent = nullptr);
  void set_state(const QString& text, double fraction, Tone tone);
  [[nodiscard]] const QString& text() const { return text_; }
  /// Height of the figures, device-independent pixels.
  [[nodiscard]] int text_pixels() const;
  [[nodiscard]] QSize sizeHint() const override { return {300, 300}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 200}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString text_;
  double fraction_ = 0.0;
  Tone tone_ = Tone::kUnknown;
};

/// Shape, word and number of a verdict.
class VerdictBadge : public QWidget {
  Q_OBJECT
 public:
  explicit VerdictBadge(QWidget* parent = nullptr);
  void set_state(const CalibrationState& state);
  [[nodiscard]] QString text() const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  CalibrationState state_;
};

}  // namespace limbwave::ui
