#include "timeline/key_model.h"

#include <algorithm>
#include <cmath>

namespace limbwave::ui {

void KeyModel::reset(const std::vector<QString>& lane_names, double duration_s, double frame_s) {
  lanes_.clear();
  for (const QString& name : lane_names) {
    lanes_.push_back({name, {}});
  }
  duration_s_ = duration_s;
  frame_s_ = frame_s;
  next_id_ = 1;
  Q_EMIT lanes_changed();
  Q_EMIT keys_changed();
}

void KeyModel::load(int lane, const std::vector<LaneKey>& keys) {
  std::vector<LaneKey>& mine = lanes_.at(static_cast<std::size_t>(lane)).keys;
  mine.clear();
  for (const LaneKey& key : keys) {
    mine.push_back({new_id(), key.time_s, key.value});
  }
  Q_EMIT keys_changed();
}

const LaneKey* KeyModel::find(int lane, KeyId id) const {
  const int index = index_of(lane, id);
  return index < 0 ? nullptr : &keys(lane)[static_cast<std::size_t>(index)];
}

int KeyModel::index_of(int lane, KeyId id) const {
  if (lane < 0 || lane >= lane_count()) {
    return -1;
  }
  const auto& list = keys(lane);
  const auto found = std::find_if(list.begin(), list.end(), [id](const LaneKey& key) { return key.id == id; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

double KeyModel::value_at(int lane, double time_s) const {
  if (lane < 0 || lane >= lane_count() || keys(lane).empty()) {
    return 0.0;
  }
  const auto& list = keys(lane);
  const auto after = std::upper_bound(list.begin(), list.end(), time_s,
                                      [](double time, const LaneKey& key) { return time < key.time_s; });
  if (after == list.begin()) {
    return list.front().value;
  }
  if (after == list.end()) {
    return list.back().value;
  }
  const LaneKey& before = *(after - 1);
  const double fraction = (time_s - before.time_s) / (after->time_s - before.time_s);
  return before.value + fraction * (after->value - before.value);
}

bool KeyModel::apply(const std::vector<KeyChange>& changes) {
  std::vector<Lane> lanes = lanes_;
  for (const KeyChange& change : changes) {
    if (change.lane < 0 || change.lane >= lane_count()) {
      return false;
    }
    std::vector<LaneKey>& keys = lanes[static_cast<std::size_t>(change.lane)].keys;
    if (change.before) {
      const auto found = std::find(keys.begin(), keys.end(), *change.before);
      if (found == keys.end()) {
        return false;
      }
      keys.erase(found);
    }
    if (change.after) {
      keys.push_back(*change.after);
    }
  }
  for (Lane& lane : lanes) {
    std::stable_sort(lane.keys.begin(), lane.keys.end(),
                     [](const LaneKey& a, const LaneKey& b) { return a.time_s < b.time_s; });
    for (std::size_t i = 0; i < lane.keys.size(); ++i) {
      const LaneKey& key = lane.keys[i];
      const bool inside = std::isfinite(key.value) && key.time_s >= 0.0 && key.time_s <= duration_s_ + 1e-9;
      if (!inside || (i > 0 && key.time_s - lane.keys[i - 1].time_s < smallest_gap_s() - 1e-9)) {
        return false;
      }
    }
  }
  lanes_ = std::move(lanes);
  Q_EMIT keys_changed();
  return true;
}

}  // namespace limbwave::ui
