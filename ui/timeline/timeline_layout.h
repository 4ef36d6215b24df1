/// Sizes of the timeline's rows, in device-independent pixels; shared by drawing and hitting.
#pragma once

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

}  // namespace limbwave::ui
