#include "interchange/fbx_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "interchange/fbx_format.h"

namespace limbwave::interchange {
namespace {

constexpr std::int32_t kUserTangent = 0x400;
constexpr std::int32_t kClamp = 0x1000;
constexpr std::int32_t kClampProgressive = 0x4000;
constexpr std::int32_t kRightWeighted = 0x1000000;
constexpr std::int32_t kNextLeftWeighted = 0x2000000;
constexpr double kWeightScale = 9999.0;
constexpr double kLargestValue = 3e8;
// Three years; and half of what 64 bits hold, so that differences fit.
constexpr double kLatestSeconds = 1e8;

double seconds(std::int64_t ticks) {
  return static_cast<double>(ticks) / kFbxTicksPerSecond;
}

// One coordinate of a cubic Bézier curve.
double bezier(double a, double b, double c, double d, double u) {
  const double v = 1.0 - u;
  return v * v * v * a + 3.0 * v * v * u * b + 3.0 * v * u * u * c + u * u * u * d;
}

}  // namespace

Result<FbxCurve> FbxCurve::load(FbxRecords& records, const FbxRecord& record, const std::string& name) {
  const FbxRecord* time_record = record.find("KeyTime");
  const FbxRecord* value_record = record.find("KeyValueFloat");
  if (time_record == nullptr || value_record == nullptr) {
    return records.error(record.offset, fmt::format("a curve of \"{}\" has no keys", name));
  }
  const std::string whose = fmt::format("a curve of \"{}\"", name);
  Result<std::vector<std::int64_t>> times = records.integers(*time_record, whose);
  if (!times) {
    return times.error();
  }
  Result<std::vector<double>> values = records.numbers(*value_record, whose);
  if (!values) {
    return values.error();
  }
  if (times->size() != values->size() || times->empty()) {
    return records.error(time_record->offset,
                         fmt::format("{} has {} times and {} values", whose, times->size(), values->size()));
  }
  for (std::size_t i = 0; i < times->size(); ++i) {
    if (!(std::abs(static_cast<double>((*times)[i])) < kLatestSeconds * kFbxTicksPerSecond) ||
        (i > 0 && (*times)[i] <= (*times)[i - 1])) {
      return records.error(time_record->offset, fmt::format("the key times of {} do not increase", whose));
    }
    if (!(std::abs((*values)[i]) <= kLargestValue)) {
      return records.error(value_record->offset, fmt::format("{} has a key that is absurd or no number", whose));
    }
  }
  FbxCurve curve;
  curve.times_ = std::move(*times);
  curve.values_ = std::move(*values);
  const std::size_t n = curve.times_.size();

  // Attributes are run-length coded. A file without them, or with wrong ones, is read as straight lines.
  const FbxRecord* flag_record = record.find("KeyAttrFlags");
  const FbxRecord* data_record = record.find("KeyAttrDataFloat");
  const FbxRecord* count_record = record.find("KeyAttrRefCount");
  curve.keys_.assign(1, Key{kFbxLinear, {}});
  if (flag_record == nullptr || data_record == nullptr || count_record == nullptr) {
    return curve;
  }
  const Result<std::vector<std::int64_t>> flags = records.integers(*flag_record, whose);
  const Result<std::vector<double>> data = records.numbers(*data_record, whose);
  const Result<std::vector<std::int64_t>> counts = records.integers(*count_record, whose);
  if (!flags || !data || !counts) {
    return !flags ? flags.error() : !data ? data.error() : counts.error();
  }
  const bool whole = flags->size() == counts->size() && data->size() >= 4 * flags->size() && !flags->empty();
  std::vector<Key> keys;
  for (std::size_t run = 0; whole && run < flags->size(); ++run) {
    Key key{static_cast<std::int32_t>((*flags)[run]), {}};
    for (std::size_t k = 0; k < 4; ++k) {
      const double value = (*data)[4 * run + k];
      key.data[k] = std::abs(value) < 1e30 ? static_cast<float>(value) : 0.0F;
    }
    if (flags->size() == 1) {
      keys.assign(1, key);
      break;
    }
    const std::int64_t count = std::clamp<std::int64_t>((*counts)[run], 0, static_cast<std::int64_t>(n - keys.size()));
    keys.insert(keys.end(), static_cast<std::size_t>(count), key);
  }
  if (keys.size() == n || (whole && flags->size() == 1)) {
    curve.keys_ = std::move(keys);
  }
  return curve;
}

std::size_t FbxCurve::before(std::int64_t ticks) const {
  const auto after = std::upper_bound(times_.begin(), times_.end(), ticks);
  return after == times_.begin() ? 0 : static_cast<std::size_t>(after - times_.begin()) - 1;
}

// The mean slope of both neighbours; flat at the ends and, where the key asks for it, at peaks.
double FbxCurve::automatic_slope(std::size_t i) const {
  if (i == 0 || i + 1 >= times_.size()) {
    return 0.0;
  }
  const double before = values_[i] - values_[i - 1];
  const double after = values_[i + 1] - values_[i];
  const std::int32_t flags = key(i).flags;
  if ((flags & (kClamp | kClampProgressive)) != 0 && before * after <= 0.0) {
    return 0.0;
  }
  return (values_[i + 1] - values_[i - 1]) / seconds(times_[i + 1] - times_[i - 1]);
}

double FbxCurve::slope(std::size_t i, bool leaving) const {
  // Slopes of both sides of a piece stand with its first key; whether they are given, with each key itself.
  const Key& side = key(leaving ? i : i - 1);
  if ((key(i).flags & kUserTangent) == 0) {
    return automatic_slope(i);  // also for tension, continuity and bias, which are nearly always 0
  }
  const double given = side.data[leaving ? 0 : 1];
  return std::isfinite(given) ? given : 0.0;
}

double FbxCurve::at(std::int64_t ticks) const {
  const std::size_t i = before(ticks);
  if (i + 1 >= times_.size() || ticks <= times_[i]) {
    return values_[i];
  }
  const Key& from = key(i);
  if ((from.flags & kFbxConstant) != 0) {
    return values_[i];
  }
  const double h = seconds(times_[i + 1] - times_[i]);
  const double u = seconds(ticks - times_[i]) / h;
  const double a = values_[i];
  const double d = values_[i + 1];
  if ((from.flags & kFbxCubic) == 0) {
    return a + u * (d - a);
  }
  double right = 1.0 / 3.0;
  double left = 1.0 / 3.0;
  const auto weights = std::bit_cast<std::uint32_t>(from.data[2]);
  if ((from.flags & kRightWeighted) != 0) {
    right = std::clamp((weights & 0xFFFFU) / kWeightScale, 1e-4, 1.0);
  }
  if ((from.flags & kNextLeftWeighted) != 0) {
    left = std::clamp((weights >> 16) / kWeightScale, 1e-4, 1.0);
  }
  const double b = a + right * h * slope(i, true);
  const double c = d - left * h * slope(i + 1, false);
  // The parameter at which the curve is at time u: bisection, as time never runs back within a piece.
  double w = u;
  if (right != left || right != 1.0 / 3.0) {
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 50; ++step) {
      w = 0.5 * (low + high);
      (bezier(0.0, right, 1.0 - left, 1.0, w) < u ? low : high) = w;
    }
  }
  return bezier(a, b, c, d, w);
}

bool FbxCurve::straight_after(std::int64_t ticks) const {
  const std::size_t i = before(ticks);
  return i + 1 >= times_.size() || ticks < times_.front() || (key(i).flags & (kFbxConstant | kFbxCubic)) == 0 ||
         ((key(i).flags & kFbxConstant) != 0 && values_[i] == values_[i + 1]);
}

bool FbxCurve::holds_after(std::int64_t ticks) const {
  const std::size_t i = before(ticks);
  return i + 1 >= times_.size() || ticks < times_.front() || (key(i).flags & kFbxConstant) != 0 ||
         values_[i] == values_[i + 1];
}

}  // namespace limbwave::interchange
