#include "interchange/fbx_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interchange/fbx_format.h"
#include "interchange/names.h"

namespace limbwave::interchange {
namespace {

using Eigen::Vector3d;

// Further than a light second, or turned a million times, is a mistake.
constexpr double kLargestNumber = 3e8;

// A property of a Properties70 record; its values begin at the fifth place.
const FbxRecord* property(const FbxRecord& object, std::string_view name) {
  const FbxRecord* list = object.find("Properties70");
  if (list == nullptr) {
    return nullptr;
  }
  const auto found = std::ranges::find_if(
      list->children, [&](const FbxRecord& entry) { return entry.value(0).is_text() && entry.value(0).bytes == name; });
  return found == list->children.end() ? nullptr : &*found;
}

}  // namespace

std::string fbx_plain_name(std::string_view name) {
  std::string text = to_utf8(name.substr(0, name.find(kFbxNameSeparator)));
  // Names stand in messages of one line.
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '_');
  return text;
}

void FbxPropertyReader::fail(const FbxRecord& record, const std::string& message) {
  if (!failure_) {
    failure_ = records_.error(record.offset, message);
  }
}

double FbxPropertyReader::number(const FbxRecord& record, std::size_t index, double otherwise) {
  const FbxValue& value = record.value(index);
  if (!value.is_number() || value.type == 0) {
    return otherwise;
  }
  if (!(std::abs(value.number) <= kLargestNumber)) {
    fail(record,
         fmt::format("{} has a number that is absurd or none",
                     record.value(0).is_text() ? fbx_plain_name(record.value(0).bytes) : fbx_plain_name(record.name)));
    return otherwise;
  }
  return value.number;
}
double FbxPropertyReader::property_number(const FbxRecord& object, std::string_view name, double otherwise) {
  const FbxRecord* found = property(object, name);
  return found == nullptr ? otherwise : number(*found, 4, otherwise);
}
Vector3d FbxPropertyReader::property_vector(const FbxRecord& object, std::string_view name, const Vector3d& otherwise) {
  const FbxRecord* found = property(object, name);
  if (found == nullptr) {
    return otherwise;
  }
  return {number(*found, 4, otherwise.x()), number(*found, 5, otherwise.y()), number(*found, 6, otherwise.z())};
}
std::int64_t FbxPropertyReader::property_ticks(const FbxRecord& object, std::string_view name) {
  const FbxRecord* found = property(object, name);
  return found == nullptr ? 0 : found->value(4).integer;
}

}  // namespace limbwave::interchange
