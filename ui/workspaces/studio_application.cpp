#include "workspaces/studio_application.h"

#include <cstdio>
#include <exception>

namespace limbwave::ui {

bool StudioApplication::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "limbwave-studio: unexpected problem: %s\n", problem.what());
    if (notifications_) {
      notifications_->post(Severity::kError,
                           tr("Something unexpected happened (%1).").arg(QString::fromUtf8(problem.what())),
                           tr("What is recorded is kept. If it happens again, start the studio anew."));
    }
    return false;
  }
}

}  // namespace limbwave::ui
