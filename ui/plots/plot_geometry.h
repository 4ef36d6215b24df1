/// The arithmetic behind plots, apart from any window, so that it can be tested without one.
#pragma once

#include <QPolygonF>
#include <QRectF>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "decode/line_in.h"
#include "signal/min_max_pyramid.h"

namespace limbwave::ui {

/// A linear map from values to positions on screen.
struct AxisMap {
  double value_begin = 0.0, value_end = 1.0;  ///< Not equal.
  double pixel_begin = 0.0, pixel_end = 1.0;
  [[nodiscard]] double to_pixel(double value) const {
    return pixel_begin + (value - value_begin) / (value_end - value_begin) * (pixel_end - pixel_begin);
  }
  [[nodiscard]] double to_value(double pixel) const {
    return value_begin + (pixel - pixel_begin) / (pixel_end - pixel_begin) * (value_end - value_begin);
  }
};

/// Distance between ticks: 1, 2 or 5 times a power of ten, for at most `most` ticks in `span` > 0.
double nice_step(double span, int most);
/// Ticks on multiples of `step` within [begin, end].
std::vector<double> ticks(double begin, double end, double step);

/// The line through samples at screen resolution: per column of one pixel the first, smallest, largest and last value,
/// so that no peak is lost; all points when there are fewer than two per column. Non-finite values break nothing: they
/// are left out.
QPolygonF decimated_line(std::span<const double> times, std::span<const double> values, const AxisMap& x,
                         const AxisMap& y);

/// The smallest of the steps 1, 0.7, 0.5, 0.3, 0.2, 0.1 ... 0.01 of full scale that shows a peak with a tenth to spare.
double scope_range(double peak);

/// What the scope shows: a piece of the stream that begins shortly before slot 0 of one cycle, so that it stands still.
struct ScopeWindow {
  double first_sample = 0.0, last_sample = 0.0;  ///< Shown, in samples of the stream.
  std::optional<decode::LineInCycle> cycle;      ///< Empty: no sync; the newest piece runs free.
  double period = 0.0;                           ///< Samples of the cycle; 0 without sync.
};

/// The newest cycle that lies wholly within the `frames` samples from `first_sample` on, with a little before and
/// after; without one the newest `free_samples`.
ScopeWindow scope_window(const std::vector<decode::LineInCycle>& cycles, double first_sample, std::size_t frames,
                         double free_samples);

/// Symmetric range of a strip chart in m/s²: 10, 20, 30, 50 or 100, the smallest that shows `largest`; does not shrink
/// below `present` unless the signal is well (a third) inside the smaller one.
double strip_range(double largest, double present);

/// A filled outline through min/max points: along the maxima and back along the minima.
QPolygonF min_max_outline(const std::vector<signal::MinMaxPoint>& points, const AxisMap& x, const AxisMap& y);

}  // namespace limbwave::ui
