/// Sizes and shapes of what the viewer draws, as plain numbers: bones, joints, boxes, letters; and which bone a ray
/// hits. Nothing here knows how the picture is made.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "body/skeleton.h"
#include "viewer/orbit_camera.h"

namespace limbwave::ui {

/// Triangles with one normal per corner; positions in metres (or unit lengths to be scaled), counter-clockwise seen
/// from outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
};

/// A bone from (0,0,0) to (1,0,0), thickest (half-width 1 in y and z) near its joint: the shape animators know.
TriangleMesh bone_mesh();
/// A sphere of radius 1.
TriangleMesh sphere_mesh();
/// A cube from -1 to 1.
TriangleMesh box_mesh();
/// A rod of radius 1 from (0,0,0) to (1,0,0), with a tip like an arrow's when `arrow` is set.
TriangleMesh rod_mesh(bool arrow);
/// The letter X, Y or Z in the plane z = 0, one unit high, about its middle.
TriangleMesh letter_mesh(char letter);

/// Half the width of a segment's bone, metres.
double bone_radius(const body::Segment& segment);

/// A sphere around all bones of these poses: centre and radius, metres.
struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};
Sphere bounds(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses);
/// The same around one segment alone.
Sphere segment_bounds(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses, int segment);

/// The segment whose bone the ray passes nearest to the camera, or -1. Bones count as capsules that are
/// `slack_per_metre` times their distance thicker than drawn, so that thin and far ones can be hit.
int pick_segment(const body::Skeleton& skeleton, const std::vector<body::SegmentPose>& poses, const ViewRay& ray,
                 double slack_per_metre);

}  // namespace limbwave::ui
