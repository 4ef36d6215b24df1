#include "timeline/timeline_geometry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace limbwave::ui {

double TimeScale::seconds_per_pixel() const {
  return std::max(end_s - begin_s, 1e-9) / std::max(width, 1.0);
}

double TimeScale::x(double time_s) const {
  return left + (time_s - begin_s) / seconds_per_pixel();
}

double TimeScale::time(double pixel) const {
  return begin_s + (pixel - left) * seconds_per_pixel();
}

TickSpacing tick_spacing(double seconds_per_pixel, double frame_s, double label_pixels) {
  assert(frame_s > 0.0);
  const double wanted = seconds_per_pixel * label_pixels;
  // Whole frames first, as long as they are the finer unit.
  for (const int frames : {1, 2, 5, 10}) {
    if (frames * frame_s >= wanted && frames * frame_s < 0.5) {
      return {frames * frame_s, frames == 1 ? 1 : (frames == 2 ? 2 : 5)};
    }
  }
  struct Step {
    double seconds;
    int minor;
  };
  static constexpr std::array<Step, 19> kSteps{{{0.05, 5},
                                                {0.1, 5},
                                                {0.2, 4},
                                                {0.5, 5},
                                                {1, 5},
                                                {2, 4},
                                                {5, 5},
                                                {10, 5},
                                                {15, 3},
                                                {30, 6},
                                                {60, 6},
                                                {120, 4},
                                                {300, 5},
                                                {600, 5},
                                                {900, 3},
                                                {1800, 6},
                                                {3600, 6},
                                                {7200, 4},
                                                {21600, 6}}};
  for (const Step& step : kSteps) {
    if (step.seconds >= wanted) {
      return {step.seconds, step.minor};
    }
  }
  return {std::ceil(wanted / 21600) * 21600, 6};
}

std::vector<Tick> ticks(const TimeScale& scale, const TickSpacing& spacing, double duration_s) {
  std::vector<Tick> list;
  const double minor = spacing.major_s / spacing.minor;
  const double first = std::max(0.0, scale.begin_s);
  const double last = std::min(duration_s, scale.end_s);
  // Counting in whole minor intervals keeps every tick exact however far from 0 it is.
  for (auto i = static_cast<std::int64_t>(std::ceil(first / minor - 1e-9));
       static_cast<double>(i) * minor <= last + 1e-9; ++i) {
    list.push_back({static_cast<double>(i) * minor, i % spacing.minor == 0});
  }
  return list;
}

std::string time_label(double time_s, double resolution_s) {
  int decimals = 0;
  for (double unit = 1.0; decimals < 3 && resolution_s < unit * 0.999; unit /= 10) {
    ++decimals;
  }
  const std::int64_t scale = std::llround(std::pow(10.0, decimals));
  const auto units = static_cast<std::int64_t>(std::llround(std::max(0.0, time_s) * static_cast<double>(scale)));
  const std::int64_t seconds = units / scale;
  const auto h = static_cast<int>(seconds / 3600);
  const auto m = static_cast<int>(seconds / 60 % 60);
  const auto s = static_cast<int>(seconds % 60);
  std::array<char, 64> text{};
  if (h > 0) {
    std::snprintf(text.data(), text.size(), "%d:%02d:%02d", h, m, s);
  } else {
    std::snprintf(text.data(), text.size(), "%d:%02d", m, s);
  }
  std::string label = text.data();
  if (decimals > 0) {
    std::snprintf(text.data(), text.size(), ".%0*d", decimals, static_cast<int>(units % scale));
    label += text.data();
  }
  return label;
}

double snapped_to_frame(double time_s, double frame_s) {
  assert(frame_s > 0.0);
  return std::round(time_s / frame_s) * frame_s;
}

int hit(const std::vector<double>& xs, double pixel, double reach) {
  int best = -1;
  double best_distance = reach;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double distance = std::abs(xs[i] - pixel);
    if (distance <= best_distance) {
      best = static_cast<int>(i);
      best_distance = distance;
    }
  }
  return best;
}

double free_time(double wanted_s, double fallback_s, const std::vector<double>& others, double gap_s,
                 double duration_s) {
  const auto is_free = [&](double time) {
    return time >= 0.0 && time <= duration_s && std::all_of(others.begin(), others.end(), [&](double other) {
             return std::abs(other - time) >= gap_s - 1e-12;
           });
  };
  const double clamped = std::clamp(wanted_s, 0.0, std::max(0.0, duration_s));
  if (is_free(clamped)) {
    return clamped;
  }
  // The nearest free time lies right beside one of the others, or at an end.
  double best = fallback_s;
  double best_distance = -1.0;
  const auto consider = [&](double time) {
    if (is_free(time) && (best_distance < 0.0 || std::abs(time - clamped) < best_distance)) {
      best = time;
      best_distance = std::abs(time - clamped);
    }
  };
  for (const double other : others) {
    consider(other - gap_s);
    consider(other + gap_s);
  }
  return best;
}

Span overview_thumb(double visible_begin_s, double visible_end_s, double duration_s, double left, double width,
                    double smallest) {
  if (duration_s <= 0.0) {
    return {left, left + width};
  }
  double begin = left + width * visible_begin_s / duration_s;
  double end = left + width * visible_end_s / duration_s;
  if (end - begin < smallest) {
    // Shrinks the way of the thumb, not its place: at both ends of the whole it touches the ends of the bar.
    const double at = visible_begin_s / std::max(1e-12, duration_s - (visible_end_s - visible_begin_s));
    begin = left + (width - smallest) * std::clamp(at, 0.0, 1.0);
    end = begin + smallest;
  }
  return {begin, end};
}

}  // namespace limbwave::ui
