/// The level check: a meter per channel and what to do, in words.
#pragma once

#include "common/studio_context.h"
#include "common/widgets.h"
#include "plots/level_meter.h"
#include "workspaces/capture/level_advice.h"

namespace limbwave::ui {

class LevelPanel : public Card {
  Q_OBJECT
 public:
  explicit LevelPanel(StudioContext& context, QWidget* parent = nullptr);
  [[nodiscard]] QString advice_title() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  StudioContext& context_;
  LevelMeter* left_;
  LevelMeter* right_;
  QLabel* icon_;
  QLabel* title_;
  QLabel* remedy_;
  QLabel* others_;
  Tone shown_tone_ = Tone::kUnknown;
  QLabel* learn_ = nullptr;
  bool shown_any_ = false;
};

}  // namespace limbwave::ui
