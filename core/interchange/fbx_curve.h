/// Animation curves of FBX files: numbers with key times, ways and tangents.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "interchange/fbx_records.h"

namespace limbwave::interchange {

class FbxCurve {
 public:
  /// Reads an AnimationCurve record; `name` says in errors whose it is. Fails when key times and values are not as
  /// many, times do not increase, or numbers are not finite or absurd.
  static Result<FbxCurve> load(FbxRecords& records, const FbxRecord& record, const std::string& name);

  /// Strictly increasing, ticks; at least one.
  [[nodiscard]] const std::vector<std::int64_t>& times() const { return times_; }
  /// The value at a time; held before the first and after the last key.
  [[nodiscard]] double at(std::int64_t ticks) const;
  /// Whether the curve is a straight line after the last key at or before a time; constants are not.
  [[nodiscard]] bool straight_after(std::int64_t ticks) const;
  /// Whether it holds its value there until the next key.
  [[nodiscard]] bool holds_after(std::int64_t ticks) const;

 private:
  struct Key {
    std::int32_t flags = 0;
    /// Slope leaving it, slope arriving at the next (both per second), weights, velocity: as in the file.
    std::array<float, 4> data{};
  };
  [[nodiscard]] std::size_t before(std::int64_t ticks) const;
  [[nodiscard]] double slope(std::size_t i, bool leaving) const;
  [[nodiscard]] double automatic_slope(std::size_t i) const;
  [[nodiscard]] const Key& key(std::size_t index) const { return keys_.size() == 1 ? keys_.front() : keys_[index]; }

  std::vector<std::int64_t> times_;
  std::vector<double> values_;
  std::vector<Key> keys_;  ///< One per key, or one for all.
};

}  // namespace limbwave::interchange
