#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "interchange/fbx_format.h"
#include "interchange/fbx_playback.h"

namespace limbwave::interchange {
namespace {

constexpr double kLargestValue = 3e8;
constexpr std::int32_t kUserTangent = 0x400;

// The numbers of an array one after another; packed ones are unpacked a block at a time.
template <typename T>
class NumberStream {
 public:
  explicit NumberStream(const FbxValue& value) : value_(value), left_(value.count) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(value.bytes.data()));  // zlib only reads there
    stream_.avail_in = static_cast<uInt>(value.bytes.size());
    good_ = !value.compressed || inflateInit(&stream_) == Z_OK;
    open_ = value.compressed && good_;
  }
  NumberStream(const NumberStream&) = delete;
  NumberStream& operator=(const NumberStream&) = delete;
  ~NumberStream() {
    if (open_) {
      inflateEnd(&stream_);
    }
  }

  [[nodiscard]] std::size_t left() const { return left_; }
  // The next number; nothing when there is none or it cannot be unpacked.
  std::optional<T> next() {
    if (left_ == 0 || (at_ == filled_ && !fill())) {
      return {};
    }
    --left_;
    return block_[at_++];
  }

 private:
  bool fill() {
    const std::size_t wanted = std::min(block_.size(), left_);
    at_ = 0;
    filled_ = 0;
    if (!value_.compressed) {
      std::memcpy(block_.data(), value_.bytes.data() + (value_.count - left_) * sizeof(T), wanted * sizeof(T));
    } else {
      stream_.next_out = reinterpret_cast<Bytef*>(block_.data());
      stream_.avail_out = static_cast<uInt>(wanted * sizeof(T));
      while (good_ && stream_.avail_out > 0) {
        const int result = inflate(&stream_, Z_NO_FLUSH);
        good_ = result == Z_OK || (result == Z_STREAM_END && stream_.avail_out == 0);
      }
      // The check sum stands behind the last number.
      Bytef none = 0;
      if (good_ && wanted == left_) {
        stream_.next_out = &none;
        stream_.avail_out = 1;
        good_ = inflate(&stream_, Z_FINISH) == Z_STREAM_END && stream_.avail_out == 1;
      }
    }
    filled_ = good_ ? wanted : 0;
    return good_;
  }

  const FbxValue& value_;
  z_stream stream_{};
  std::array<T, 1024> block_{};
  std::size_t at_ = 0;
  std::size_t filled_ = 0;
  std::size_t left_ = 0;
  bool open_ = false;
  bool good_ = true;
};

}  // namespace

struct FbxCurveStream::State {
  struct Key {
    std::int64_t time = 0;
    double value = 0.0;
  };
  // Keys of the same kind that follow each other.
  struct Run {
    std::int64_t keys = 0;
    std::int32_t flags = kFbxLinear;
    double leaving = 0.0;
    double arriving = 0.0;
  };

  State(const FbxRecord& times_record, const FbxRecord& values_record)
      : times(times_record.value(0)), values(values_record.value(0)) {}

  // Takes the next key from the file into `next`.
  bool read() {
    const std::optional<std::int64_t> time = times.next();
    const std::optional<float> value = values.next();
    if (!time || !value || !std::isfinite(*value) || std::abs(*value) > kLargestValue ||
        (has_from && *time <= from.time)) {
      return false;
    }
    next = {*time, static_cast<double>(*value)};
    return true;
  }

  // `next` becomes the key that time has passed.
  bool step() {
    from = next;
    has_from = true;
    while (run + 1 < runs.size() && keys_of_run >= runs[run].keys) {
      ++run;
      keys_of_run = 0;
    }
    ++keys_of_run;
    has_next = times.left() > 0;
    return !has_next || read();
  }

  NumberStream<std::int64_t> times;
  NumberStream<float> values;
  std::vector<Run> runs;
  std::size_t run = 0;
  std::int64_t keys_of_run = 0;
  Key from;
  Key next;
  bool has_from = false;
  bool has_next = true;
  Error broken;
};

FbxCurveStream::FbxCurveStream(std::unique_ptr<State> state) : state_(std::move(state)) {}
FbxCurveStream::FbxCurveStream(FbxCurveStream&&) noexcept = default;
FbxCurveStream::~FbxCurveStream() = default;

Result<FbxCurveStream> FbxCurveStream::open(FbxRecords& records, const FbxRecord& record, const std::string& name) {
  const FbxRecord* times = record.find("KeyTime");
  const FbxRecord* values = record.find("KeyValueFloat");
  const FbxRecord* flag_record = record.find("KeyAttrFlags");
  const FbxRecord* data_record = record.find("KeyAttrDataFloat");
  const FbxRecord* count_record = record.find("KeyAttrRefCount");
  const std::string whose = fmt::format("a curve of \"{}\"", name);
  if (times == nullptr || values == nullptr || flag_record == nullptr || data_record == nullptr ||
      count_record == nullptr || times->value(0).type != 'l' || values->value(0).type != 'f' ||
      times->value(0).count != values->value(0).count || times->value(0).count == 0) {
    return records.error(record.offset, whose + " has no whole keys");
  }
  const Result<std::vector<std::int64_t>> flags = records.integers(*flag_record, whose);
  const Result<std::vector<double>> data = records.numbers(*data_record, whose);
  const Result<std::vector<std::int64_t>> counts = records.integers(*count_record, whose);
  if (!flags || !data || !counts) {
    return !flags ? flags.error() : !data ? data.error() : counts.error();
  }
  if (flags->empty() || counts->size() != flags->size() || data->size() != 4 * flags->size()) {
    return records.error(flag_record->offset, whose + " does not say how it goes from key to key");
  }
  auto state = std::make_unique<State>(*times, *values);
  state->broken = records.error(record.offset, whose + " has keys that cannot be unpacked or do not increase");
  std::int64_t keys = 0;
  for (std::size_t i = 0; i < flags->size(); ++i) {
    const auto flag = static_cast<std::int32_t>((*flags)[i]);
    if ((flag & kFbxCubic) != 0 && (flag & kUserTangent) == 0) {
      return records.error(flag_record->offset, whose + " has tangents that are not given");
    }
    state->runs.push_back({(*counts)[i], flag, (*data)[4 * i], (*data)[4 * i + 1]});
    keys += std::clamp<std::int64_t>((*counts)[i], 0, times->value(0).count);
  }
  if (keys != static_cast<std::int64_t>(times->value(0).count)) {
    return records.error(count_record->offset, whose + " does not say how it goes on after every key");
  }
  if (!state->read() || !state->step()) {
    return state->broken;
  }
  return FbxCurveStream(std::move(state));
}

Result<double> FbxCurveStream::at(std::int64_t ticks) {
  State& s = *state_;
  while (s.has_next && s.next.time <= ticks) {
    if (!s.step()) {
      return s.broken;
    }
  }
  const State::Run& run = s.runs[s.run];
  if (!s.has_next || ticks <= s.from.time || (run.flags & kFbxConstant) != 0) {
    return s.from.value;
  }
  const double h = static_cast<double>(s.next.time - s.from.time) / kFbxTicksPerSecond;
  const double u = static_cast<double>(ticks - s.from.time) / kFbxTicksPerSecond / h;
  const double rise = s.next.value - s.from.value;
  if ((run.flags & kFbxCubic) == 0) {
    return s.from.value + u * rise;
  }
  // Cubic Hermite: Bézier with weights of a third.
  const double v = 1.0 - u;
  return s.from.value + u * u * (3.0 - 2.0 * u) * rise + u * v * h * (v * run.leaving - u * run.arriving);
}

}  // namespace limbwave::interchange
