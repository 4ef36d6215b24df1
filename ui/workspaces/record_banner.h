/// Over the figure while a take is being recorded: how long, in figures that can be read from across the room, and
/// before that the countdown.
#pragma once

#include <QWidget>

#include "common/health_text.h"
#include "common/studio_context.h"

class QLabel;
class QPushButton;

namespace limbwave::ui {

class CaptureModel;

/// Hides itself while nothing is recorded and nothing is counted down.
class RecordBanner : public QWidget {
  Q_OBJECT
 public:
  explicit RecordBanner(StudioContext& context, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void refresh_time();
  void show_dot();
  [[nodiscard]] Loss loss() const;

  StudioContext& context_;
  CaptureModel& capture_;
  QLabel *dot_, *time_, *state_, *marker_;
  QPushButton *mark_, *stop_;
  Loss shows_loss_ = Loss::kNone;
};

}  // namespace limbwave::ui
