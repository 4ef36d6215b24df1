/// Where things stand on the timeline: times and pixels, ticks and their labels, rows, snapping, hits. No widgets.
#pragma once

#include <string>
#include <vector>

namespace limbwave::ui {

/// The map between times (seconds) and horizontal pixels of the part of the timeline that shows time.
struct TimeScale {
  double begin_s = 0.0;
  double end_s = 1.0;
  double left = 0.0;   ///< Pixel of `begin_s`.
  double width = 1.0;  ///< Pixels from `begin_s` to `end_s`; > 0.

  [[nodiscard]] double x(double time_s) const;
  [[nodiscard]] double time(double pixel) const;
  [[nodiscard]] double seconds_per_pixel() const;
};

/// Distances of ticks that people can count with: frames at close range, then 1-2-5 seconds, 10, 15, 30 s, minutes.
struct TickSpacing {
  double major_s = 1.0;  ///< Labelled.
  int minor = 5;         ///< Parts that a major interval is divided into.
};

/// The finest spacing whose labels are at least `label_pixels` apart. `frame_s` > 0 is the length of a frame.
TickSpacing tick_spacing(double seconds_per_pixel, double frame_s, double label_pixels);

struct Tick {
  double time_s = 0.0;
  bool major = false;
};

/// Ticks within the visible part, in order of time, from 0 to `duration_s`.
std::vector<Tick> ticks(const TimeScale& scale, const TickSpacing& spacing, double duration_s);

/// "0:03", "1:02:03"; with as many decimals as `resolution_s` asks for: "0:03.25".
std::string time_label(double time_s, double resolution_s);

/// The time of the frame that is nearest.
double snapped_to_frame(double time_s, double frame_s);

/// The index of the x that is nearest to `pixel` and at most `reach` away; -1: none. Of equally near ones the last
/// wins: it is drawn on top.
int hit(const std::vector<double>& xs, double pixel, double reach);

/// A time kept within 0 .. duration and at least `gap_s` away from all `others`, as near to `wanted_s` as that allows.
/// Returns `fallback_s` when there is no room.
double free_time(double wanted_s, double fallback_s, const std::vector<double>& others, double gap_s,
                 double duration_s);

/// The thumb of the overview bar: the visible part within the whole.
struct Span {
  double begin = 0.0;
  double end = 0.0;
};
/// Pixels of the thumb in a bar from `left` with `width`; at least `smallest` wide so that it can be caught.
Span overview_thumb(double visible_begin_s, double visible_end_s, double duration_s, double left, double width,
                    double smallest);

}  // namespace limbwave::ui
