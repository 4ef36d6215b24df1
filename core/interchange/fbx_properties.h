/// Named properties of FBX objects.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "interchange/fbx_records.h"

namespace limbwave::interchange {

/// The part of an object's name that people see, as UTF-8.
std::string fbx_plain_name(std::string_view name);

/// Reads numbers of objects' Properties70 and keeps the first that is absurd as the reason to fail.
class FbxPropertyReader {
 public:
  explicit FbxPropertyReader(const FbxRecords& records) : records_(records) {}

  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }
  void fail(const FbxRecord& record, const std::string& message);

  /// `otherwise` where the object does not have the property.
  double property_number(const FbxRecord& object, std::string_view name, double otherwise);
  Eigen::Vector3d property_vector(const FbxRecord& object, std::string_view name, const Eigen::Vector3d& otherwise);
  /// A time, 0 where it is not said.
  static std::int64_t property_ticks(const FbxRecord& object, std::string_view name);

 private:
  double number(const FbxRecord& record, std::size_t index, double otherwise);

  const FbxRecords& records_;
  std::optional<Error> failure_;
};

}  // namespace limbwave::interchange
