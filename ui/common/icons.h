/// The studio's own icons: SVGs in resources/icons that take the colour of the text they stand beside.
#pragma once

#include <QIcon>
#include <QPixmap>
#include <QString>

namespace limbwave::ui {

/// Icon by file name without ending ("record"). Follows the theme by itself; switched-on parts use the accent. A name
/// without a file gives an empty icon and a warning on the console.
QIcon icon(const QString& name);

/// The same for the ground of the accent: a main action's button.
QIcon accent_icon(const QString& name);

/// The same as a picture of one colour, `size` device-independent pixels wide and high.
QPixmap icon_pixmap(const QString& name, const QColor& color, int size, double device_pixel_ratio);

}  // namespace limbwave::ui
