#include "common/notifications.h"

#include <algorithm>

#include "base/progress.h"
#include "common/core_text.h"
#include "common/format.h"

namespace limbwave::ui {

int Notifications::post(Severity severity, const QString& text, const QString& remedy, const QString& action,
                        std::function<void()> act) {
  // The same sentence twice is one sentence.
  all_.erase(std::remove_if(all_.begin(), all_.end(), [&](const Notification& n) { return n.text == text; }),
             all_.end());
  all_.insert(all_.begin(), Notification{next_id_, severity, text, remedy, action, std::move(act)});
  constexpr std::size_t kKept = 20;
  if (all_.size() > kKept) {
    all_.resize(kKept);
  }
  Q_EMIT changed();
  return next_id_++;
}

void Notifications::post_error(const QString& what, const Error& error) {
  if (is_cancelled(error)) {
    return;
  }
  QString text = what;
  while (text.endsWith(QLatin1Char('.'))) {
    text.chop(1);
  }
  text += text.isEmpty() ? QString() : QStringLiteral(": ");
  text += core_text(error.place.empty() ? error.message : error.place + ": " + error.message);
  post(Severity::kError, as_sentence(text), as_sentence(core_text(error.remedy)));
}

void Notifications::dismiss(int id) {
  const auto end = std::remove_if(all_.begin(), all_.end(), [id](const Notification& n) { return n.id == id; });
  if (end != all_.end()) {
    all_.erase(end, all_.end());
    Q_EMIT changed();
  }
}

}  // namespace limbwave::ui
