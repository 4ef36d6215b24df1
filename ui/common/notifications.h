/// Things to tell the user that belong to no control: sentences with a remedy, in one place, newest first.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"

namespace limbwave::ui {

struct Notification {
  int id = 0;
  Severity severity = Severity::kInfo;
  QString text;    ///< What happened.
  QString remedy;  ///< What to do; may be empty.
  QString action;  ///< Verb on the button; empty: none.
  std::function<void()> act;
};

class Notifications : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  int post(Severity severity, const QString& text, const QString& remedy = {}, const QString& action = {},
           std::function<void()> act = {});
  /// An error as the core reports it; a cancelled job is nothing to tell.
  void post_error(const QString& what, const Error& error);
  void dismiss(int id);
  [[nodiscard]] const std::vector<Notification>& all() const { return all_; }

 Q_SIGNALS:
  void changed();

 private:
  std::vector<Notification> all_;
  int next_id_ = 1;
};

}  // namespace limbwave::ui
