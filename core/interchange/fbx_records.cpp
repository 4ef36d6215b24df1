#include "interchange/fbx_records.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "interchange/fbx_format.h"

namespace limbwave::interchange {
namespace {

static_assert(std::endian::native == std::endian::little, "FBX is little-endian");

constexpr int kDeepest = 32;
constexpr std::size_t kMostRecords = 2'000'000;
constexpr std::size_t kMostValues = 8'000'000;
// Arrays together, unpacked: so much, and so many times the file's size; two hours of 60 joints at 60 Hz need less.
constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20;
constexpr std::uint64_t kMostTimes = 100;
// zlib cannot pack more bytes than these into one.
constexpr std::uint64_t kBestPacking = 1032;
constexpr std::uint32_t kWideFrom = 7500;  // 64-bit record headers

std::size_t size_of(char type) {
  switch (type) {
    case 'C':
    case 'B':
    case 'b':
      return 1;
    case 'Y':
      return 2;
    case 'I':
    case 'F':
    case 'i':
    case 'f':
      return 4;
    case 'L':
    case 'D':
    case 'l':
    case 'd':
      return 8;
    default:
      return 0;
  }
}

template <typename T>
T load(const char* p) {
  T value;
  std::memcpy(&value, p, sizeof value);
  return value;
}

// Whole part, held within 64 bits.
std::int64_t to_integer(double value) {
  constexpr double kLimit = 9.2e18;
  return std::isfinite(value) ? static_cast<std::int64_t>(std::clamp(value, -kLimit, kLimit)) : 0;
}

template <typename T>
T element(char type, const char* p) {
  const auto real = [](double value) {
    if constexpr (std::is_same_v<T, double>) {
      return value;
    } else {
      return to_integer(value);
    }
  };
  switch (type) {
    case 'i':
      return static_cast<T>(load<std::int32_t>(p));
    case 'l':
      return static_cast<T>(load<std::int64_t>(p));
    case 'f':
      return real(load<float>(p));
    case 'd':
      return real(load<double>(p));
    default:
      return static_cast<T>(load<std::uint8_t>(p));
  }
}

}  // namespace

class FbxParser {
 public:
  FbxParser(std::string_view bytes, FbxRecords& out) : bytes_(bytes), out_(out) {}

  Status parse() {
    constexpr std::size_t kHeader = 27;
    if (bytes_.substr(0, kFbxMagic.size()) != kFbxMagic || bytes_.size() < kHeader) {
      const bool text = bytes_.substr(0, 1000).find("FBX") != std::string_view::npos;
      return Error{text ? "is FBX as text" : "is not an FBX file", out_.place_,
                   text ? "save it as binary FBX" : "check that it is the right file"};
    }
    out_.version_ = load<std::uint32_t>(bytes_.data() + kFbxMagic.size());
    if (out_.version_ < 7100 || out_.version_ >= 8000) {
      return Error{fmt::format("is FBX of version {}.{}", out_.version_ / 1000, out_.version_ / 100 % 10), out_.place_,
                   "save it as FBX 2011 or newer (7.1 to 7.7)"};
    }
    at_ = kHeader;
    return children(out_.root_, bytes_.size(), 0, true);
  }

 private:
  [[nodiscard]] Error wrong(std::size_t offset, const std::string& message) const {
    return out_.error(offset, message);
  }

  // Records up to a NULL record or, inside others, to `end`.
  Status children(FbxRecord& parent, std::size_t end, int depth, bool top) {
    const std::size_t word = out_.version_ >= kWideFrom ? 8 : 4;
    const std::size_t head = 3 * word + 1;
    while (top || at_ < end) {
      if (end - at_ < head) {
        return wrong(at_, "a record is cut off");
      }
      const auto number = [&](std::size_t index) {
        const char* p = bytes_.data() + at_ + index * word;
        return word == 8 ? load<std::uint64_t>(p) : load<std::uint32_t>(p);
      };
      const std::uint64_t record_end = number(0);
      if (record_end == 0) {
        at_ += head;
        return at_ == end || top ? Status() : wrong(at_, "there is something behind the last record of a group");
      }
      const std::size_t start = at_;
      const std::uint64_t count = number(1);
      const std::uint64_t size = number(2);
      const auto name_size = static_cast<unsigned char>(bytes_[at_ + head - 1]);
      if (record_end > end || record_end < start + head + name_size || size > record_end - start - head - name_size) {
        return wrong(start, "a record reaches beyond its place");
      }
      if (++records_ > kMostRecords || (values_ += count) > kMostValues || count > size) {
        return wrong(start, "there are more records than any program writes");
      }
      if (depth >= kDeepest) {
        return wrong(start, "records lie in each other deeper than any program writes");
      }
      FbxRecord& record = parent.children.emplace_back();
      record.offset = start;
      record.name = bytes_.substr(start + head, name_size);
      at_ = start + head + name_size;
      const std::size_t values_end = at_ + static_cast<std::size_t>(size);
      record.values.reserve(static_cast<std::size_t>(count));
      for (std::uint64_t i = 0; i < count; ++i) {
        if (Status status = value(record, values_end); !status) {
          return status;
        }
      }
      if (at_ != values_end) {
        return wrong(at_, "a record's properties have another size than it says");
      }
      if (Status status = children(record, static_cast<std::size_t>(record_end), depth + 1, false); !status) {
        return status;
      }
      if (at_ != record_end) {
        return wrong(at_, "a record ends elsewhere than it says");
      }
    }
    return {};
  }

  Status value(FbxRecord& record, std::size_t end) {
    const std::size_t start = at_;
    if (at_ >= end) {
      return wrong(start, "a property is missing");
    }
    FbxValue& value = record.values.emplace_back();
    value.type = bytes_[at_++];
    std::size_t size = size_of(value.type);
    const bool array = value.is_array();
    const bool text = value.type == 'S' || value.type == 'R';
    if (size == 0 && !text) {
      return wrong(start, "a property is of no known type");
    }
    if (array || text) {
      const std::size_t head = array ? 12 : 4;
      if (end - at_ < head) {
        return wrong(start, "a property is cut off");
      }
      value.count = array ? load<std::uint32_t>(bytes_.data() + at_) : 0;
      const std::uint32_t encoding = array ? load<std::uint32_t>(bytes_.data() + at_ + 4) : 0;
      const std::uint32_t packed = load<std::uint32_t>(bytes_.data() + at_ + head - 4);
      at_ += head;
      const std::uint64_t plain = std::uint64_t{value.count} * size;
      value.compressed = encoding == 1;
      if (encoding > 1 || packed > end - at_ ||
          (array && (value.compressed ? plain > kBestPacking * packed : plain != packed))) {
        return wrong(start, "an array does not have the size that it says");
      }
      size = packed;
      value.bytes = bytes_.substr(at_, packed);
    } else {
      if (end - at_ < size) {
        return wrong(start, "a property is cut off");
      }
      const char* p = bytes_.data() + at_;
      switch (value.type) {
        case 'F':
          value.number = load<float>(p);
          break;
        case 'D':
          value.number = load<double>(p);
          break;
        case 'L':
          value.integer = load<std::int64_t>(p);
          break;
        case 'I':
          value.integer = load<std::int32_t>(p);
          break;
        case 'Y':
          value.integer = load<std::int16_t>(p);
          break;
        default:
          value.integer = load<std::uint8_t>(p);  // yes or no
      }
      if (value.type == 'F' || value.type == 'D') {
        value.integer = to_integer(value.number);
      } else {
        value.number = static_cast<double>(value.integer);
      }
    }
    at_ += size;
    return {};
  }

  std::string_view bytes_;
  FbxRecords& out_;
  std::size_t at_ = 0;
  std::size_t records_ = 0;
  std::uint64_t values_ = 0;
};

const FbxRecord* FbxRecord::find(std::string_view child) const {
  const auto found = std::ranges::find_if(children, [&](const FbxRecord& record) { return record.name == child; });
  return found == children.end() ? nullptr : &*found;
}

const FbxValue& FbxRecord::value(std::size_t index) const {
  static const FbxValue kNone;
  return index < values.size() ? values[index] : kNone;
}

Result<FbxRecords> FbxRecords::parse(std::string_view bytes, const std::string& place) {
  FbxRecords records;
  records.place_ = place;
  records.size_ = bytes.size();
  records.most_unpacked_ = kMostBytes + kMostTimes * bytes.size();
  if (Status status = FbxParser(bytes, records).parse(); !status) {
    return status.error();
  }
  return records;
}

Error FbxRecords::error(std::size_t offset, const std::string& message) const {
  return {message, fmt::format("{}, byte {}", place_, offset), "check that the file is whole, or export it again"};
}

template <typename T>
Result<std::vector<T>> FbxRecords::array(const FbxRecord& record, const std::string& what) {
  const FbxValue& value = record.value(0);
  if (!value.is_array()) {
    return error(record.offset, fmt::format("{} is not a list of numbers", what));
  }
  const std::size_t size = size_of(value.type);
  const std::uint64_t plain = std::uint64_t{value.count} * size;
  // Bytes as they are, and as numbers of eight bytes.
  unpacked_ += plain + 8 * std::uint64_t{value.count};
  if (unpacked_ > most_unpacked_) {
    return error(record.offset, "its lists of numbers are too long to be read");
  }
  std::string buffer;
  const char* source = value.bytes.data();
  if (value.compressed) {
    buffer.resize(plain);
    auto got = static_cast<uLongf>(plain);
    const int result = uncompress(reinterpret_cast<Bytef*>(buffer.data()), &got,
                                  reinterpret_cast<const Bytef*>(value.bytes.data()), value.bytes.size());
    if (plain > 0 && (result != Z_OK || got != plain)) {
      return error(record.offset, fmt::format("{} cannot be unpacked to {} numbers", what, value.count));
    }
    source = buffer.data();
  }
  std::vector<T> numbers(value.count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = element<T>(value.type, source + i * size);
  }
  return numbers;
}

Result<std::vector<double>> FbxRecords::numbers(const FbxRecord& record, const std::string& what) {
  return array<double>(record, what);
}
Result<std::vector<std::int64_t>> FbxRecords::integers(const FbxRecord& record, const std::string& what) {
  return array<std::int64_t>(record, what);
}

}  // namespace limbwave::interchange
