/// The remembered layout of the window. What the settings hold may be anything: an old version's, a broken disk's.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <optional>

class QMainWindow;

namespace limbwave::ui {

/// `state` with a mark and a checksum in front.
QByteArray seal_layout(const QByteArray& state);
/// What was sealed, or nothing when mark, size or checksum do not fit.
std::optional<QByteArray> unseal_layout(const QByteArray& sealed);

/// Positions of all named splitters in a widget.
void save_splitters(const QWidget& root, QSettings& settings);
void restore_splitters(QWidget& root, QSettings& settings);

void save_layout(const QMainWindow& window, QSettings& settings);
/// False when nothing usable was stored; the window is then as it was.
bool restore_layout(QMainWindow& window, QSettings& settings);

}  // namespace limbwave::ui
