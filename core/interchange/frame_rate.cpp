#include "interchange/frame_rate.h"

#include <algorithm>
#include <cmath>

namespace limbwave::interchange {

double frame_rate_from_text(double seconds, std::string_view digits) {
  const std::size_t point = digits.find('.');
  const bool plain = digits.find_first_of("eE") == std::string_view::npos;
  // Half a unit of the last digit, and a little for rates whose period was computed in another order.
  double rounding = 1e-9 * seconds;
  if (plain && point != std::string_view::npos) {
    const auto decimals = static_cast<double>(digits.size() - point - 1);
    // Some programs cut digits off instead of rounding: a whole unit.
    rounding += std::pow(10.0, -decimals);
  }
  rounding = std::min(rounding, 0.003 * seconds);
  // Whole rates first: where both fit, they are meant far more often.
  constexpr double kRates[] = {24,  25,  30,  48,   50,   60,         72,         75,         90,         100,
                               120, 144, 150, 160,  180,  200,        240,        250,        300,        360,
                               480, 500, 960, 1000, 12.5, 24 / 1.001, 30 / 1.001, 48 / 1.001, 60 / 1.001, 120 / 1.001};
  double best = 1.0 / seconds;
  double best_distance = rounding;
  bool found = false;
  for (const double rate : kRates) {
    const double distance = std::abs(1.0 / rate - seconds);
    const bool whole = rate == std::floor(rate);
    if (distance <= best_distance && (whole || !found)) {
      best = rate;
      best_distance = distance;
      found = true;
    }
  }
  return best;
}

double exact_frame_rate(double fps) {
  for (const double whole : {24.0, 30.0, 48.0, 60.0, 120.0}) {
    const double ntsc = whole / 1.001;
    // 23.98 is as far as people round.
    if (std::abs(fps - ntsc) < 2e-4 * whole && std::abs(fps - whole) > 5e-4 * whole) {
      return ntsc;
    }
  }
  return fps;
}

double single_time(double time_s, double fps) {
  const auto single = static_cast<float>(time_s);
  const double frame = std::round(time_s * fps) / fps;
  return static_cast<float>(frame) == single ? frame : static_cast<double>(single);
}

}  // namespace limbwave::interchange
