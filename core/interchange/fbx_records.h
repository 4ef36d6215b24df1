/// The record tree of a binary FBX file, checked against the file's size before anything is believed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace limbwave::interchange {

/// One property of a record; texts and arrays stay in the file's bytes, which must outlive it.
struct FbxValue {
  char type = 0;             ///< As in the file: Y C I L F D, S R, b i l f d.
  std::uint32_t count = 0;   ///< Of an array's numbers.
  bool compressed = false;   ///< An array in zlib's format.
  std::int64_t integer = 0;  ///< Of Y C I L; F and D rounded.
  double number = 0.0;       ///< Of all scalars.
  std::string_view bytes;    ///< Of texts and arrays.

  [[nodiscard]] bool is_number() const { return type != 'S' && type != 'R' && !is_array(); }
  [[nodiscard]] bool is_text() const { return type == 'S'; }
  [[nodiscard]] bool is_array() const { return type >= 'a' && type <= 'z'; }
};

struct FbxRecord {
  std::string_view name;
  std::size_t offset = 0;  ///< In the file, for errors.
  std::vector<FbxValue> values;
  std::vector<FbxRecord> children;

  /// The first child of a name, or null.
  [[nodiscard]] const FbxRecord* find(std::string_view child) const;
  /// A property, or one of type 0.
  [[nodiscard]] const FbxValue& value(std::size_t index) const;
};

/// A file's records and the memory that its arrays may still take.
class FbxRecords {
 public:
  /// Parses versions 7.1 to 7.7. Fails, with the byte, on what is not FBX, on text FBX and older versions, on records
  /// that reach outside of their parent, and on more or deeper records than any program writes.
  static Result<FbxRecords> parse(std::string_view bytes, const std::string& place);

  [[nodiscard]] const FbxRecord& root() const { return root_; }
  [[nodiscard]] std::uint32_t version() const { return version_; }
  /// Bytes of the file.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The numbers of the array that is a record's first property; `what` names it in errors. Fails when it is none, its
  /// compressed bytes are broken or are not as many numbers as they say, or all arrays together are absurdly large.
  Result<std::vector<double>> numbers(const FbxRecord& record, const std::string& what);
  Result<std::vector<std::int64_t>> integers(const FbxRecord& record, const std::string& what);

  [[nodiscard]] Error error(std::size_t offset, const std::string& message) const;

 private:
  friend class FbxParser;
  template <typename T>
  Result<std::vector<T>> array(const FbxRecord& record, const std::string& what);

  std::string place_;
  FbxRecord root_;
  std::uint32_t version_ = 0;
  std::size_t size_ = 0;
  std::uint64_t unpacked_ = 0;  ///< Bytes of arrays so far.
  std::uint64_t most_unpacked_ = 0;
};

}  // namespace limbwave::interchange
