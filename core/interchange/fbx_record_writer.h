/// Records of binary FBX 7.4, written to a file one after the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/byte_sink.h"

namespace limbwave::interchange {

/// The bytes of an array property as they stand in a file, to be written several times while compressed once.
using FbxArray = std::string;

/// Packs numbers as an array property. Arrays of more than a few numbers are compressed with zlib (`level` 1 to 9, 0:
/// not).
FbxArray fbx_array(std::span<const std::int32_t> values, int level = 1);
FbxArray fbx_array(std::span<const std::int64_t> values, int level = 1);
FbxArray fbx_array(std::span<const float> values, int level = 1);
FbxArray fbx_array(std::span<const double> values, int level = 1);

/// A record is END OFFSET, PROPERTY COUNT, PROPERTY BYTES (32 bits each), NAME, properties, children, and 13 zero bytes
/// after the children. What is not known when a record begins is filled in when it ends.
class FbxRecordWriter {
 public:
  /// Writes the file header.
  explicit FbxRecordWriter(ByteSink& file);

  void begin(std::string_view name);
  /// Properties of the record that was begun last; only before its children.
  void add(bool value);
  void add(std::int32_t value);
  void add(std::int64_t value);
  void add(double value);
  void add(std::string_view value);
  void add(const char* value) { add(std::string_view(value)); }
  void add_raw(std::string_view bytes);
  void add_array(const FbxArray& array);
  /// Ends the record. Some readers lose what follows unless records that usually have children end in the zero bytes
  /// even when they have none: `block`.
  void end(bool block = false);

  /// A record without children.
  template <typename... Values>
  void leaf(std::string_view name, const Values&... values) {
    begin(name);
    (add(values), ...);
    end();
  }
  void leaf_array(std::string_view name, const FbxArray& array) {
    begin(name);
    add_array(array);
    end();
  }

  /// Writes what must stand at the end of the file. Asserts that all records have ended.
  void finish();
  /// Whether all offsets fit into 32 bits.
  [[nodiscard]] bool fits() const;

 private:
  struct Open {
    std::uint64_t start = 0;
    std::uint64_t properties_start = 0;
    std::uint32_t properties = 0;
    bool children = false;
  };
  void scalar(char type, const void* value, std::size_t size);
  void close_properties(Open& record);

  ByteSink& file_;
  std::vector<Open> open_;
};

}  // namespace limbwave::interchange
