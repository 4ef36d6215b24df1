/// The strip on top of the window: the take, the facts that ruin takes when unseen, and the menus.
#pragma once

#include <QWidget>
#include <vector>

#include "common/studio_context.h"
#include "workspaces/status_facts.h"

class QHBoxLayout;
class QMenu;
class QToolButton;

namespace limbwave::ui {

/// One fact: a shape in its colour and words; a click leads to the cause.
class StatusButton : public QWidget {
  Q_OBJECT
 public:
  explicit StatusButton(QWidget* parent = nullptr);
  void set_fact(const StatusFact& fact);
  [[nodiscard]] const StatusFact& fact() const { return fact_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  void clicked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  StatusFact fact_;
};

class StatusStrip : public QWidget {
  Q_OBJECT
 public:
  StatusStrip(StudioContext& context, QMenu* take_menu, QMenu* main_menu, QWidget* parent = nullptr);
  /// At the right end, before the main menu.
  void add_action_button(QAction* action);

 private:
  void refresh();
  StudioContext& context_;
  QToolButton* take_;
  std::vector<StatusButton*> facts_;
  QHBoxLayout* right_;
};

}  // namespace limbwave::ui
