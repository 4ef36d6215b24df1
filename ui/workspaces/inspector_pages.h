/// The inspectors of all workspaces in one dock: as wide as the one that is shown needs it, whatever the others need.
#pragma once

#include <QStackedWidget>
#include <algorithm>

#include "common/theme.h"

namespace limbwave::ui {

class InspectorPages : public QStackedWidget {
 public:
  explicit InspectorPages(QWidget* parent = nullptr) : QStackedWidget(parent) {
    connect(this, &QStackedWidget::currentChanged, this, &InspectorPages::make_room);
  }

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) {
      make_room();
    }
    return QStackedWidget::event(event);
  }

 private:
  void make_room() {
    const int needed = currentWidget() == nullptr ? 0 : currentWidget()->minimumSizeHint().width();
    setMinimumWidth(std::max(kLeastWidth, needed));
  }
  static constexpr int kLeastWidth = 32 * kGrid;
};

}  // namespace limbwave::ui
