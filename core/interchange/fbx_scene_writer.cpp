#include "interchange/fbx_scene_writer.h"

#include <array>

namespace limbwave::interchange {

std::string fbx_object_name(std::string_view name, std::string_view kind) {
  return std::string(name).append(kFbxNameSeparator).append(kind);
}

FbxArray fbx_matrix(const Eigen::Quaterniond& R, const Eigen::Vector3d& p) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = R.toRotationMatrix();
  M.topRightCorner<3, 1>() = p;
  return fbx_array(std::span<const double>(M.data(), 16));
}

FbxId FbxSceneWriter::begin_object(std::string_view record, std::string_view name, std::string_view kind,
                                   std::string_view subkind) {
  const FbxId id = next_++;
  out_.begin(record);
  out_.add(id);
  out_.add(fbx_object_name(name, kind));
  out_.add(subkind);
  return id;
}

void FbxSceneWriter::write_connections() {
  out_.begin("Connections");
  for (const Connection& connection : connections_) {
    if (connection.property.empty()) {
      out_.leaf("C", "OO", connection.child, connection.parent);
    } else {
      out_.leaf("C", "OP", connection.child, connection.parent, connection.property);
    }
  }
  out_.end(true);
}

}  // namespace limbwave::interchange
