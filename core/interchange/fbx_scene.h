/// What an FBX file holds of skeletons, skins and animation, found in its records.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "interchange/fbx_records.h"

namespace limbwave::interchange {

/// A node's placement under its parent: x_P = translation + R · diag(scale) · x.
struct FbxPlacement {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// The three properties of a node that move, in the file's units and degrees.
using FbxChannels = std::array<Eigen::Vector3d, 3>;
enum FbxChannelIndex : std::size_t { kFbxTranslation, kFbxRotation, kFbxScaling };

/// A node of the scene (FBX calls it Model) with everything that FBX lets take part in its placement.
struct FbxModel {
  std::string name;
  std::string type;        ///< "LimbNode", "Null", "Mesh", ...
  std::size_t offset = 0;  ///< In the file.
  int parent = -1;         ///< Index, smaller than the own; -1: the scene's root.
  FbxChannels rest;        ///< Values when nothing is animated.
  int rotation_order = 0;  ///< 0 XYZ, 1 XZY, 2 YZX, 3 YXZ, 4 ZXY, 5 ZYX; the first letter turns first.
  Eigen::Quaterniond pre = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond post = Eigen::Quaterniond::Identity();
  Eigen::Vector3d rotation_offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_pivot = Eigen::Vector3d::Zero();
  Eigen::Vector3d scaling_offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d scaling_pivot = Eigen::Vector3d::Zero();
  Eigen::Affine3d geometric = Eigen::Affine3d::Identity();  ///< Of its mesh alone.
  bool inherits_scale = true;
  double length_m = -1.0;  ///< Of the bone, when Limbwave wrote it.
  bool joint = false;      ///< A bone, or what a skin says moves it.

  [[nodiscard]] FbxPlacement placement(const FbxChannels& values) const;
};

struct FbxCluster {
  int model = -1;  ///< The bone.
  const FbxRecord* record = nullptr;
};

struct FbxSkin {
  std::string name;
  const FbxRecord* geometry = nullptr;
  int model = -1;  ///< The mesh's node.
  std::vector<FbxCluster> clusters;
};

/// Curves of one property of one node.
struct FbxCurveNode {
  int model = -1;
  FbxChannelIndex channel = kFbxTranslation;
  std::array<const FbxRecord*, 3> curves{};  ///< Null: stays at `constant`.
  Eigen::Vector3d constant;
};

struct FbxLayer {
  double weight = 1.0;
  bool additive = false;  ///< Adds to the layers before it; else replaces them.
  std::vector<FbxCurveNode> nodes;
};

struct FbxStack {
  std::string name;
  std::int64_t start = 0;  ///< Ticks; both 0: not said.
  std::int64_t stop = 0;
  std::vector<FbxLayer> layers;
};

/// Its pointers lead into the records that it was made from.
struct FbxScene {
  Eigen::Matrix3d R_WF;  ///< Our world from the file's.
  double metres_per_unit = 0.01;
  double fps = 30.0;
  std::vector<FbxModel> models;  ///< Parents before children.
  std::vector<FbxSkin> skins;
  std::vector<FbxStack> stacks;
};

/// Fails, with the byte, on nodes that hang on each other in a circle, numbers that are not finite or absurd, and lists
/// of the wrong length. What hangs nowhere is left out.
Result<FbxScene> fbx_scene(const FbxRecords& records);

}  // namespace limbwave::interchange
