#include "plots/plot_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limbwave::ui {

double nice_step(double span, int most) {
  if (!(span > 0.0) || most < 1) {
    return 1.0;
  }
  const double raw = span / most;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * (1.0 - 1e-9)) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

std::vector<double> ticks(double begin, double end, double step) {
  std::vector<double> result;
  if (!(step > 0.0) || !(end >= begin) || (end - begin) / step > 1000.0) {
    return result;
  }
  for (double n = std::ceil(begin / step - 1e-9); n * step <= end + 1e-9 * step; n += 1.0) {
    result.push_back(n * step);
  }
  return result;
}

QPolygonF decimated_line(std::span<const double> times, std::span<const double> values, const AxisMap& x,
                         const AxisMap& y) {
  QPolygonF line;
  const std::size_t count = std::min(times.size(), values.size());
  if (count == 0) {
    return line;
  }
  const double width = std::abs(x.pixel_end - x.pixel_begin);
  const bool all = static_cast<double>(count) < 2.0 * width;
  int column = 0;
  bool open = false;
  double first = 0.0, last = 0.0, low = 0.0, high = 0.0;
  const auto close_column = [&] {
    if (open) {
      for (const double value : {first, low, high, last}) {
        line.append(QPointF(column + 0.5, y.to_pixel(value)));
      }
      open = false;
    }
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double value = values[i];
    const double pixel = x.to_pixel(times[i]);
    if (!std::isfinite(value) || !std::isfinite(pixel)) {
      continue;
    }
    if (all) {
      line.append(QPointF(pixel, y.to_pixel(value)));
      continue;
    }
    const int at = static_cast<int>(std::floor(pixel));
    if (!open || at != column) {
      close_column();
      column = at;
      open = true;
      first = low = high = value;
    }
    low = std::min(low, value);
    high = std::max(high, value);
    last = value;
  }
  close_column();
  return line;
}

double scope_range(double peak) {
  constexpr std::array<double, 11> kSteps{0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0};
  for (const double step : kSteps) {
    if (peak * 1.1 <= step) {
      return step;
    }
  }
  return 1.0;
}

ScopeWindow scope_window(const std::vector<decode::LineInCycle>& cycles, double first_sample, std::size_t frames,
                         double free_samples) {
  const double end = first_sample + static_cast<double>(frames);
  constexpr double kBefore = 0.03, kAfter = 0.06;  // of a cycle
  for (auto cycle = cycles.rbegin(); cycle != cycles.rend(); ++cycle) {
    const double period = cycle->period_samples;
    if (!cycle->valid || !(period > 0.0)) {
      continue;
    }
    ScopeWindow window;
    window.first_sample = cycle->start_sample - kBefore * period;
    window.last_sample = cycle->start_sample + (1.0 + kAfter) * period;
    if (window.first_sample >= first_sample && window.last_sample <= end) {
      window.cycle = *cycle;
      window.period = period;
      return window;
    }
  }
  return {std::max(first_sample, end - free_samples), end, std::nullopt, 0.0};
}

double strip_range(double largest, double present) {
  constexpr std::array<double, 5> kRanges{10.0, 20.0, 30.0, 50.0, 100.0};
  double wanted = kRanges.back();
  for (const double range : kRanges) {
    if (largest <= range * 1.05) {
      wanted = range;
      break;
    }
  }
  // A signal at the border must not make the scale jump to and fro.
  const bool well_inside = largest <= wanted * 0.67;
  return wanted >= present || well_inside || !(present > 0.0) ? wanted : present;
}

QPolygonF min_max_outline(const std::vector<signal::MinMaxPoint>& points, const AxisMap& x, const AxisMap& y) {
  QPolygonF outline;
  const auto middle = [&](const signal::MinMaxPoint& point) {
    return x.to_pixel(static_cast<double>(point.first) + 0.5 * static_cast<double>(point.count));
  };
  for (const signal::MinMaxPoint& point : points) {
    if (std::isfinite(point.maximum)) {
      outline.append(QPointF(middle(point), y.to_pixel(point.maximum)));
    }
  }
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    if (std::isfinite(point->minimum)) {
      outline.append(QPointF(middle(*point), y.to_pixel(point->minimum)));
    }
  }
  return outline;
}

}  // namespace limbwave::ui
