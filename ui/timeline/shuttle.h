/// J, K and L as editors know them: L plays forwards and faster with every press, J backwards, K stops.
#pragma once

namespace limbwave::ui {

inline constexpr double kSlowest = 0.1;
inline constexpr double kFastest = 4.0;

/// The speed after a press of L (`direction` 1) or J (-1), given the present one. From standstill and after a change of
/// direction it starts at 1, then doubles up to 4.
constexpr double shuttle_speed(double speed, bool playing, int direction) {
  const double forwards = speed * direction;
  if (!playing || forwards <= 0.0 || forwards < 1.0) {
    return direction;
  }
  const double faster = 2.0 * forwards;
  return direction * (faster < kFastest ? faster : kFastest);
}

}  // namespace limbwave::ui
