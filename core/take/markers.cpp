#include "take/markers.h"

#include <algorithm>
#include <unordered_map>

namespace limbwave::take {

bool is_marker(const TakeEvent& event) {
  return event.kind == kMarker;
}

std::vector<TakeEvent> events_in_force(const std::vector<TakeEvent>& lines) {
  std::vector<TakeEvent> events;
  events.reserve(lines.size());
  std::vector<bool> removed;
  std::unordered_map<std::int64_t, std::size_t> place_of;  // of a marker's number in `events`
  std::int64_t line = 0;
  for (const TakeEvent& event : lines) {
    ++line;
    const auto known = is_marker(event) || event.kind == kMarkerRemoved ? place_of.find(event.count) : place_of.end();
    if (event.kind == kMarkerRemoved) {
      if (known != place_of.end()) {
        removed[known->second] = true;
        place_of.erase(known);
      }
    } else if (known != place_of.end()) {
      events[known->second] = event;
    } else {
      events.push_back(event);
      removed.push_back(false);
      if (is_marker(event)) {
        events.back().count = event.count == 0 ? -line : event.count;
        place_of[events.back().count] = events.size() - 1;
      }
    }
  }
  std::vector<TakeEvent> left;
  left.reserve(events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!removed[i]) {
      left.push_back(std::move(events[i]));
    }
  }
  return left;
}

std::int64_t free_marker_number(const std::vector<TakeEvent>& events) {
  std::int64_t largest = 0;
  for (const TakeEvent& event : events) {
    if (is_marker(event)) {
      largest = std::max(largest, event.count);
    }
  }
  return largest + 1;
}

}  // namespace limbwave::take
