/// Pictures of a take without a window: what `packaging/run.sh` leaves where there is no display, and the pictures of
/// demo takes. Needs a QGuiApplication (the offscreen platform serves).
#pragma once

#include <QImage>
#include <QString>
#include <vector>

#include "base/result.h"
#include "motion/clip.h"
#include "take/take.h"

namespace limbwave::ui {

/// The skeleton at `instants` equally spaced instants of the clip, side by side, on a floor grid.
QImage skeleton_picture(const motion::Clip& clip, int instants = 5, QSize panel = {380, 460});

/// One cycle of the raw signal with its slots, and the accelerations of every sensor over the capture.
Result<QImage> signals_picture(const take::Take& take, QSize size = {1600, 1000});

}  // namespace limbwave::ui
