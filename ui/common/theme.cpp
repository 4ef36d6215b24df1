#include "common/theme.h"

#include <QStyleFactory>
#include <array>

namespace limbwave::ui {
namespace {

QPalette make_palette(const ThemeColors& c) {
  QPalette palette;
  palette.setColor(QPalette::Window, c.window);
  palette.setColor(QPalette::WindowText, c.text);
  palette.setColor(QPalette::Base, c.base);
  palette.setColor(QPalette::AlternateBase, c.panel);
  palette.setColor(QPalette::Text, c.text);
  palette.setColor(QPalette::PlaceholderText, c.dim);
  palette.setColor(QPalette::Button, c.raised);
  palette.setColor(QPalette::ButtonText, c.text);
  palette.setColor(QPalette::BrightText, c.danger);
  palette.setColor(QPalette::ToolTipBase, c.raised);
  palette.setColor(QPalette::ToolTipText, c.text);
  palette.setColor(QPalette::Highlight, c.accent);
  palette.setColor(QPalette::HighlightedText, c.accent_text);
  palette.setColor(QPalette::Link, c.accent);
  palette.setColor(QPalette::LinkVisited, c.accent);
  palette.setColor(QPalette::Light, c.line.lighter(120));
  palette.setColor(QPalette::Midlight, c.line);
  palette.setColor(QPalette::Mid, c.line);
  palette.setColor(QPalette::Dark, c.line.darker(120));
  palette.setColor(QPalette::Shadow, Qt::black);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    QColor faded = c.dim;
    faded.setAlpha(150);
    palette.setColor(QPalette::Disabled, role, faded);
  }
  return palette;
}

QString make_stylesheet(const ThemeColors& c) {
  // Names in %1..%9 order: window, panel, base, raised, line, text, dim, accent, accent_text; then danger, hover,
  // accent at hover, theme, warning.
  const QString hover = (c.dark ? c.raised.lighter(118) : c.raised.darker(106)).name();
  return QStringLiteral(R"(
* { outline: none; }
QToolTip { background: %4; color: %6; border: 1px solid %5; padding: 4px 8px; }
QMainWindow, QDialog { background: %1; }
QMainWindow::separator { background: %5; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: %8; }
QToolBar { border: none; padding: 0; margin: 0; spacing: 0; background: %2; }
QDockWidget { color: %7; }
QDockWidget::title { background: %1; padding: 8px 8px 4px 16px; text-align: left; }
QDockWidget::close-button, QDockWidget::float-button { border: none; background: transparent; padding: 0; icon-size: 16px;
  subcontrol-origin: margin; subcontrol-position: top right; position: absolute; top: 8px; width: 20px; height: 20px; }
QDockWidget::close-button { right: 12px; }
QDockWidget::float-button { right: 40px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: %4; border-radius: 3px; }
QFrame[card="true"] { background: %2; border: none; border-radius: 6px; }
QWidget[strip="true"] { background: %2; }
QLabel[role="dim"] { color: %7; }
QLabel[role="heading"] { color: %7; font-weight: 600; }
QLabel[role="danger"] { color: %10; }
QLabel[role="warning"] { color: %14; }
QPushButton, QToolButton { background: %4; color: %6; border: 1px solid transparent; border-radius: 4px; padding: 6px 14px; }
QPushButton { min-height: 18px; }
QToolButton { padding: 6px; }
QPushButton:hover, QToolButton:hover { background: %11; }
QPushButton:pressed, QToolButton:pressed { background: %5; }
QPushButton:focus, QToolButton:focus { border: 1px solid %8; }
QPushButton:disabled, QToolButton:disabled { color: %7; background: %2; }
QPushButton:disabled { border: 1px solid %5; }
QPushButton[flat="true"]:disabled { border: 1px solid transparent; background: transparent; }
QPushButton[primary="true"] { background: %8; color: %9; font-weight: 600; }
QPushButton[primary="true"]:hover { background: %12; }
QPushButton[primary="true"]:focus { border: 1px solid %6; }
QPushButton[primary="true"]:disabled { background: %4; color: %7; }
QPushButton[danger="true"] { background: %10; color: white; font-weight: 600; }
QPushButton[danger="true"]:focus { border: 1px solid %6; }
QPushButton[flat="true"], QToolButton[flat="true"] { background: transparent; }
QPushButton[flat="true"]:hover, QToolButton[flat="true"]:hover { background: %4; }
QPushButton[flat="true"]:focus, QToolButton[flat="true"]:focus { border: 1px solid %8; }
QToolButton::menu-indicator { image: none; }
QPushButton::menu-indicator { image: url(:/icons/%13/chevron-down.svg); width: 12px; height: 12px; subcontrol-origin: padding;
  subcontrol-position: center right; right: 8px; }
QPushButton[menu="true"] { padding-right: 26px; }
QToolButton[mode="true"] { background: transparent; color: %7; border-radius: 0; border: none; border-left: 3px solid transparent;
  padding: 10px 4px 8px 1px; }
QToolButton[mode="true"]:hover { color: %6; background: %4; }
QToolButton[mode="true"]:checked { color: %6; border-left: 3px solid %8; background: %1; }
QToolButton[mode="true"]:focus { color: %6; border-left: 3px solid %6; }
QToolButton[mode="true"]:disabled { color: %5; }
QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox { background: %3; color: %6; border: 1px solid %5; border-radius: 4px;
  padding: 5px 8px; min-height: 18px; selection-background-color: %8; selection-color: %9; }
QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus { border: 1px solid %8; }
QLineEdit:disabled, QComboBox:disabled, QSpinBox:disabled, QDoubleSpinBox:disabled { color: %7; background: %2; }
QComboBox::drop-down { border: none; width: 24px; }
QComboBox::down-arrow { image: url(:/icons/%13/chevron-down.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: %2; border: 1px solid %5; padding: 4px; outline: none; }
QCheckBox, QRadioButton { spacing: 8px; }
QCheckBox:focus, QRadioButton:focus { color: %8; }
QListView, QTreeView, QTableView { background: %3; border: 1px solid transparent; border-radius: 4px; padding: 4px; }
QListView:focus, QTreeView:focus, QTableView:focus { border: 1px solid %8; }
QListView::item, QTreeView::item { padding: 4px; border-radius: 3px; }
QListView::item:selected, QTreeView::item:selected { background: %8; color: %9; }
QHeaderView::section { background: %2; color: %7; border: none; border-bottom: 1px solid %5; padding: 4px 8px; }
QMenu { background: %2; border: 1px solid %5; padding: 4px; }
QMenu::item { padding: 6px 24px 6px 12px; border-radius: 3px; }
QMenu::item:selected { background: %8; color: %9; }
QMenu::item:disabled { color: %7; background: transparent; }
QMenu::separator { height: 1px; background: %5; margin: 4px 8px; }
QProgressBar { background: %3; border: none; border-radius: 3px; height: 6px; max-height: 6px; text-align: center; }
QProgressBar::chunk { background: %8; border-radius: 3px; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: %5; border-radius: 4px; min-height: 24px; min-width: 24px; margin: 1px; }
QScrollBar::handle:hover { background: %7; }
QScrollBar::add-line, QScrollBar::sub-line, QScrollBar::add-page, QScrollBar::sub-page { background: none; border: none;
  width: 0; height: 0; }
QScrollArea, QScrollArea > QWidget > QWidget[scroll="true"] { background: transparent; border: none; }
QSplitter::handle { background: %1; }
QSplitter::handle:hover { background: %8; }
QTabBar::tab { background: transparent; color: %7; padding: 6px 12px; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: %6; border-bottom: 2px solid %8; }
QTabWidget::pane { border: none; }
QSlider::groove:horizontal { background: %5; height: 4px; border-radius: 2px; }
QSlider::handle:horizontal { background: %6; width: 12px; margin: -4px 0; border-radius: 6px; }
QSlider::handle:horizontal:focus { background: %8; }
QSlider::handle:horizontal:disabled { background: %7; }
)")
      .arg(c.window.name(), c.panel.name(), c.base.name(), c.raised.name(), c.line.name(), c.text.name(), c.dim.name(),
           c.accent.name(), c.accent_text.name())
      .arg(c.danger.name(), hover, (c.dark ? c.accent.lighter(112) : c.accent.darker(112)).name(),
           c.dark ? QStringLiteral("dark") : QStringLiteral("light"), c.warning.name());
}

}  // namespace

const ThemeColors& dark_theme() {
  static const ThemeColors colors{.dark = true,
                                  .window = QColor(0x14, 0x16, 0x19),
                                  .panel = QColor(0x1b, 0x1e, 0x22),
                                  .base = QColor(0x0e, 0x10, 0x12),
                                  .raised = QColor(0x2a, 0x2e, 0x34),
                                  .line = QColor(0x33, 0x38, 0x3f),
                                  .grid = QColor(0x22, 0x26, 0x2b),
                                  .text = QColor(0xdd, 0xe1, 0xe6),
                                  .dim = QColor(0x93, 0x9b, 0xa5),
                                  .accent = QColor(0x7c, 0x9c, 0xff),
                                  .accent_text = QColor(0x0b, 0x0f, 0x1c),
                                  .good = QColor(0x2f, 0xb8, 0x8f),
                                  .warning = QColor(0xe6, 0x9f, 0x00),
                                  .danger = QColor(0xe0, 0x3c, 0x31)};
  return colors;
}

const ThemeColors& light_theme() {
  static const ThemeColors colors{.dark = false,
                                  .window = QColor(0xee, 0xf0, 0xf2),
                                  .panel = QColor(0xf9, 0xfa, 0xfb),
                                  .base = QColor(0xff, 0xff, 0xff),
                                  .raised = QColor(0xe2, 0xe5, 0xe9),
                                  .line = QColor(0xc9, 0xce, 0xd4),
                                  .grid = QColor(0xe6, 0xe9, 0xec),
                                  .text = QColor(0x1a, 0x1d, 0x21),
                                  .dim = QColor(0x5b, 0x63, 0x6d),
                                  .accent = QColor(0x35, 0x57, 0xd6),
                                  .accent_text = QColor(0xff, 0xff, 0xff),
                                  .good = QColor(0x00, 0x7f, 0x5c),
                                  .warning = QColor(0xa8, 0x6a, 0x00),
                                  .danger = QColor(0xc6, 0x28, 0x1e)};
  return colors;
}

const ThemeColors& theme_colors(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? dark_theme() : light_theme();
}

QColor series_color(const ThemeColors& theme, int index) {
  // Okabe and Ito, "Color Universal Design"; yellow and blue change places with darker or lighter kin, because yellow
  // vanishes on white and blue on black.
  static const std::array<QColor, 7> dark{QColor(0xe6, 0x9f, 0x00), QColor(0x56, 0xb4, 0xe9), QColor(0x00, 0xb4, 0x84),
                                          QColor(0xcc, 0x79, 0xa7), QColor(0xf0, 0xe4, 0x42), QColor(0xd5, 0x5e, 0x00),
                                          QColor(0x3f, 0x97, 0xd6)};
  static const std::array<QColor, 7> light{QColor(0xc7, 0x7f, 0x00), QColor(0x1f, 0x86, 0xc4), QColor(0x00, 0x8a, 0x64),
                                           QColor(0xb1, 0x55, 0x8a), QColor(0x00, 0x5a, 0x90), QColor(0xd5, 0x5e, 0x00),
                                           QColor(0x8c, 0x7d, 0x00)};
  const auto at = static_cast<std::size_t>(index < 0 ? 0 : index) % dark.size();
  return theme.dark ? dark.at(at) : light.at(at);
}

void apply_theme(QApplication& application, ThemeKind kind) {
  const ThemeColors& colors = kind == ThemeKind::kDark ? dark_theme() : light_theme();
  if (QStyle* fusion = QStyleFactory::create(QStringLiteral("Fusion"))) {
    QApplication::setStyle(fusion);
  }
  QFont font = QApplication::font();
  font.setPixelSize(13);
  QApplication::setFont(font);
  QApplication::setPalette(make_palette(colors));
  application.setStyleSheet(make_stylesheet(colors));
}

QFont tabular(QFont base, double scale, QFont::Weight weight) {
  // Qt 6.4 cannot switch OpenType features on; the families of the platforms we ship for have figures of equal width.
  const int pixels = base.pixelSize() > 0 ? base.pixelSize() : 13;
  base.setPixelSize(qRound(pixels * scale));
  base.setWeight(weight);
  base.setKerning(false);
  return base;
}

}  // namespace limbwave::ui
