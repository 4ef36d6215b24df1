/// The place of notifications: a line above the workspace, errors first, then the newest, each with its remedy and a
/// way to act.
#pragma once

#include <QWidget>

#include "common/notifications.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace limbwave::ui {

class MessageBar : public QWidget {
  Q_OBJECT
 public:
  MessageBar(Notifications& notifications, QWidget* parent = nullptr);
  [[nodiscard]] QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  Notifications& notifications_;
  QLabel* icon_;
  QLabel* text_;
  QPushButton* more_;
  QPushButton* action_;
  QToolButton* close_;
  std::size_t turn_ = 0;  ///< How many messages the user went on from the most important one.
  int shown_ = 0;         ///< Id of the message in view.
};

}  // namespace limbwave::ui
