#include "workspaces/layout_store.h"

#include <QCryptographicHash>
#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>

namespace limbwave::ui {
namespace {

constexpr int kLayoutVersion = 1;
constexpr qsizetype kLargest = 1 << 16;

QByteArray mark() {
  return QByteArrayLiteral("limbwave-layout-1:");
}

QByteArray checksum(const QByteArray& data) {
  return QCryptographicHash::hash(data, QCryptographicHash::Sha1);
}

}  // namespace

QByteArray seal_layout(const QByteArray& state) {
  return mark() + checksum(state) + state;
}

std::optional<QByteArray> unseal_layout(const QByteArray& sealed) {
  const qsizetype head = mark().size() + checksum({}).size();
  if (sealed.size() < head || sealed.size() > kLargest || !sealed.startsWith(mark())) {
    return std::nullopt;
  }
  const QByteArray state = sealed.mid(head);
  if (sealed.mid(mark().size(), head - mark().size()) != checksum(state)) {
    return std::nullopt;
  }
  return state;
}

void save_layout(const QMainWindow& window, QSettings& settings) {
  settings.setValue(QStringLiteral("window/geometry"), seal_layout(window.saveGeometry()));
  settings.setValue(QStringLiteral("window/docks"), seal_layout(window.saveState(kLayoutVersion)));
}

bool restore_layout(QMainWindow& window, QSettings& settings) {
  const auto geometry = unseal_layout(settings.value(QStringLiteral("window/geometry")).toByteArray());
  const auto docks = unseal_layout(settings.value(QStringLiteral("window/docks")).toByteArray());
  if (!geometry || !docks) {
    return false;
  }
  const bool restored = window.restoreGeometry(*geometry) && window.restoreState(*docks, kLayoutVersion);
  // A screen that is gone must not take the window along.
  if (QGuiApplication::screenAt(window.frameGeometry().center()) == nullptr) {
    if (const QScreen* screen = QGuiApplication::primaryScreen()) {
      window.move(screen->availableGeometry().topLeft());
    }
  }
  return restored;
}

}  // namespace limbwave::ui
