/// The objects of an FBX scene, and how they hang together.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interchange/fbx_format.h"
#include "interchange/fbx_record_writer.h"

namespace limbwave::interchange {

using FbxId = std::int64_t;
inline constexpr FbxId kFbxRoot = 0;

/// "NAME\0\1KIND".
std::string fbx_object_name(std::string_view name, std::string_view kind);
/// 4×4, column after column, in file units.
FbxArray fbx_matrix(const Eigen::Quaterniond& R, const Eigen::Vector3d& p);

/// Writes objects and remembers their connections for the end of the file.
class FbxSceneWriter {
 public:
  explicit FbxSceneWriter(FbxRecordWriter& out) : out_(out) {}

  /// Begins the record of a new object; the caller ends it.
  FbxId begin_object(std::string_view record, std::string_view name, std::string_view kind, std::string_view subkind);
  /// A P record in a Properties70.
  template <typename... Values>
  void property(std::string_view name, std::string_view type, std::string_view label, std::string_view flags,
                const Values&... values) {
    out_.leaf("P", name, type, label, flags, values...);
  }

  void connect(FbxId child, FbxId parent) { connections_.push_back({child, parent, {}}); }
  void connect(FbxId child, FbxId parent, std::string_view property) {
    connections_.push_back({child, parent, std::string(property)});
  }
  void write_connections();

 private:
  struct Connection {
    FbxId child;
    FbxId parent;
    std::string property;
  };
  FbxRecordWriter& out_;
  std::vector<Connection> connections_;
  FbxId next_ = 1000000;
};

}  // namespace limbwave::interchange
