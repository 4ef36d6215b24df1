/// How the studio looks: two hand-made palettes, one stylesheet, the colours of data. The interface is quiet, so that
/// signals and the figure are the brightest things on screen.
#pragma once

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QPalette>

namespace limbwave::ui {

enum class ThemeKind { kDark, kLight };

/// Named colours of one theme.
struct ThemeColors {
  bool dark = true;
  QColor window;                 ///< Behind everything.
  QColor panel;                  ///< Cards, docks, the mode bar.
  QColor base;                   ///< Behind signals, lists and text fields.
  QColor raised;                 ///< Buttons.
  QColor line;                   ///< Hairlines.
  QColor grid;                   ///< Lines behind signals, quieter than `line`.
  QColor text;                   ///< Read.
  QColor dim;                    ///< Read when looked for: units, hints, axes.
  QColor accent;                 ///< The one accent: focus, what is chosen, the main action.
  QColor accent_text;            ///< On the accent.
  QColor good, warning, danger;  ///< States. Danger only for "you are losing data".
};

const ThemeColors& dark_theme();
const ThemeColors& light_theme();

/// The theme that a palette belongs to: painting widgets ask with their own `palette()` and follow a change by
/// themselves.
const ThemeColors& theme_colors(const QPalette& palette);

/// Okabe–Ito hues in the order in which series use them, adjusted to the theme's ground; wraps around after seven.
QColor series_color(const ThemeColors& theme, int index);

/// Palette, stylesheet and font of the whole application.
void apply_theme(QApplication& application, ThemeKind kind);

/// `base` with figures of equal width, so that running numbers do not dance; scaled by `scale`.
QFont tabular(QFont base, double scale = 1.0, QFont::Weight weight = QFont::Normal);

inline constexpr int kGrid = 8;  ///< Distances are multiples of this, in device-independent pixels.

}  // namespace limbwave::ui
