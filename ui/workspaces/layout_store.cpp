#include "workspaces/layout_store.h"

#include <QCryptographicHash>
#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>
#include <QSplitter>

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

void save_splitters(const QWidget& root, QSettings& settings) {
  for (const QSplitter* splitter : root.findChildren<QSplitter*>()) {
    if (!splitter->objectName().isEmpty()) {
      settings.setValue(QStringLiteral("splitter/") + splitter->objectName(), seal_layout(splitter->saveState()));
    }
  }
}

void restore_splitters(QWidget& root, QSettings& settings) {
  for (QSplitter* splitter : root.findChildren<QSplitter*>()) {
    const QString name = splitter->objectName();
    const auto state =
        name.isEmpty() ? std::nullopt : unseal_layout(settings.value(QStringLiteral("splitter/") + name).toByteArray());
    if (state) {
      splitter->restoreState(*state);
    }
  }
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
