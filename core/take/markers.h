/// Markers of a take and how they are changed. events.jsonl is only ever appended to, so that killing the program at
/// any instant loses no marker: a change is a further line with the marker's number, and the last line of a number
/// counts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "take/take.h"

namespace limbwave::take {

/// Kinds of events: a marker is set (or set anew, elsewhere or with other words), and taken away. Both carry the
/// marker's number in `TakeEvent::count`.
inline constexpr const char* kMarker = "marker";
inline constexpr const char* kMarkerRemoved = "marker-removed";

[[nodiscard]] bool is_marker(const TakeEvent& event);

/// The events in force of what events.jsonl says line by line: of every marker the last state at its first place,
/// without those that were removed. A marker without a number (0, as other programs may write it) gets −n, where n
/// is its line, counted from 1; so it can be changed like any other.
std::vector<TakeEvent> events_in_force(const std::vector<TakeEvent>& lines);

/// A number that none of these markers has; positive.
std::int64_t free_marker_number(const std::vector<TakeEvent>& events);

}  // namespace limbwave::take
