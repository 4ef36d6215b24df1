/// Sizes of the timeline's rows, in device-independent pixels; shared by drawing and hitting.
#pragma once

#include <QLocale>
#include <QString>

#include "timeline/timeline_geometry.h"

namespace limbwave::ui {

inline constexpr int kLabelWidth = 144;  ///< Column of names at the left.
inline constexpr int kRightMargin = 16;  ///< So that the last key can be caught.
inline constexpr int kRulerHeight = 28;
inline constexpr int kMarkerHeight = 20;
inline constexpr int kLaneHeight = 22;
inline constexpr int kOverviewHeight = 8;
inline constexpr double kKeyHalf = 6.0;     ///< Half the diagonal of a key's diamond.
inline constexpr double kDragStarts = 3.0;  ///< Less is a click that trembled.
inline constexpr double kKeyReach = 8.0;    ///< How far beside a key it can still be caught.

/// `time_label` as the user's language writes decimals.
inline QString time_text(double time_s, double resolution_s) {
  return QString::fromStdString(time_label(time_s, resolution_s)).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

}  // namespace limbwave::ui
