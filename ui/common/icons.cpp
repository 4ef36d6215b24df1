#include "common/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>
#include <QtDebug>

#include "common/theme.h"

// Resources of a static library are linked only when asked for; the macro must stand outside any namespace.
static void init_icon_resources() {
  Q_INIT_RESOURCE(icons);
}

namespace limbwave::ui {
namespace {

QByteArray load_svg(const QString& name) {
  static const bool initialised = (init_icon_resources(), true);
  Q_UNUSED(initialised);
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) {
    qWarning("no icon named %s", qPrintable(name));
    return {};
  }
  return file.readAll();
}

/// Paints the SVG with "currentColor" replaced by a colour of the present palette.
class ThemedIconEngine : public QIconEngine {
 public:
  explicit ThemedIconEngine(QByteArray svg, bool on_accent = false) : svg_(std::move(svg)), on_accent_(on_accent) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const ThemeColors& theme = theme_colors(QGuiApplication::palette());
    QColor color = theme.text;
    if (mode == QIcon::Disabled) {
      color = theme.dim;
      color.setAlpha(130);
    } else if (on_accent_) {
      color = theme.accent_text;
    } else if (state == QIcon::On) {
      color = theme.accent;
    }
    render(*painter, rect, color);
  }

  void render(QPainter& painter, const QRectF& rect, const QColor& color) const {
    QByteArray svg = svg_;
    svg.replace("currentColor", color.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer(svg);
    painter.save();
    painter.setOpacity(painter.opacity() * color.alphaF());
    renderer.render(&painter, rect);
    painter.restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  bool isNull() override { return svg_.isEmpty(); }
  [[nodiscard]] QIconEngine* clone() const override { return new ThemedIconEngine(svg_, on_accent_); }

 private:
  QByteArray svg_;
  bool on_accent_;
};

}  // namespace

QIcon icon(const QString& name) {
  return QIcon(new ThemedIconEngine(load_svg(name)));
}

QIcon accent_icon(const QString& name) {
  return QIcon(new ThemedIconEngine(load_svg(name), true));
}

QPixmap icon_pixmap(const QString& name, const QColor& color, int size, double device_pixel_ratio) {
  QPixmap pixmap(QSize(size, size) * device_pixel_ratio);
  pixmap.setDevicePixelRatio(device_pixel_ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  ThemedIconEngine(load_svg(name)).render(painter, QRectF(0, 0, size, size), color);
  return pixmap;
}

}  // namespace limbwave::ui
