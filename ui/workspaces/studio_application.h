/// The application: a problem in one handler is told, and the studio lives on.
#pragma once

#include <QApplication>
#include <QPointer>

#include "common/notifications.h"

namespace limbwave::ui {

class StudioApplication : public QApplication {
 public:
  using QApplication::QApplication;
  /// Where problems are told; null: on standard error.
  void set_notifications(Notifications* notifications) { notifications_ = notifications; }
  /// An exception that leaves a handler would end the program, and a recording with it.
  bool notify(QObject* receiver, QEvent* event) override;

 private:
  QPointer<Notifications> notifications_;
};

}  // namespace limbwave::ui
