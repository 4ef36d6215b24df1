/// The wires of a driver box: one row each, with its level, what it says and what the filter makes of it.
#pragma once

#include <QWidget>
#include <memory>

#include "solve/live_body_session.h"

namespace limbwave::ui {

class WireView : public QWidget {
  Q_OBJECT
 public:
  explicit WireView(QWidget* parent = nullptr);
  /// What the box says now; null: nothing is known.
  void set_snapshot(std::shared_ptr<const solve::LiveBodySnapshot> snapshot);
  void set_selected(int wire);
  /// "locked", "pulled out": the state of a wire in words.
  [[nodiscard]] static QString state_words(const solve::BoxWire& wire);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void wire_clicked(int wire);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] int wires() const;
  [[nodiscard]] double row_height() const;
  [[nodiscard]] int wire_at(double y) const;
  std::shared_ptr<const solve::LiveBodySnapshot> snapshot_;
  int selected_ = -1;
};

}  // namespace limbwave::ui
