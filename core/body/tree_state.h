/// A skeleton as a tree of elementary joints, and its joint state with two derivatives. Ball joints live on SO(3), so
/// that no pose is singular; hinges and the two hinges of a universal joint keep their angle.
///
/// Joint state of a ball joint: R_joint away from rest; velocity ω and acceleration α = dω/dt as components in the
/// moving (child) frame, so that dR/dt = R [ω]×. A change of state is R exp(δ), ω + δω, α + δα.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "body/skeleton.h"

namespace limbwave::body {

using Eigen::Matrix3d;
using Eigen::VectorXd;

/// How the root moves: as its joint in the skeleton allows about its place, or freely with six degrees of freedom.
enum class RootMotion { kJoint, kFree };

enum class LinkKind { kFixed, kTranslation, kHinge, kBall };

/// One elementary joint. A universal joint is two hinges, a free root a translation and a ball.
struct TreeLink {
  LinkKind kind = LinkKind::kFixed;
  int parent = -1;                               ///< Link it hangs on; -1: the world.
  int segment = 0;                               ///< Segment whose joint this is (a part of).
  int first = 0;                                 ///< First degree of freedom.
  int count = 0;                                 ///< Degrees of freedom: 0, 1 or 3.
  int axis_index = 0;                            ///< Of a hinge: which axis of the segment's joint it is.
  Vector3d p_PL = Vector3d::Zero();              ///< Place in the parent link's frame, metres.
  Quaterniond R_rest = Quaterniond::Identity();  ///< Rest orientation in the parent link's frame.
  Vector3d axis = Vector3d::UnitY();             ///< Of a hinge, in its own frame; unit length.
};

/// Joint state. Vectors have one entry per degree of freedom; `q` is unused (zero) for those of ball joints.
struct TreeState {
  std::vector<Quaterniond> R_joint;  ///< One per link; used by ball joints.
  VectorXd q, qd, qdd;               ///< Angles (rad) or translations (m), and their first and second derivatives.
};

class Tree {
 public:
  Tree(const Skeleton& skeleton, RootMotion root);

  [[nodiscard]] int dofs() const { return dofs_; }
  [[nodiscard]] RootMotion root_motion() const { return root_; }
  [[nodiscard]] const std::vector<TreeLink>& links() const { return links_; }
  [[nodiscard]] int segments() const { return static_cast<int>(link_of_segment_.size()); }
  /// The link that carries a segment: the last of its joint.
  [[nodiscard]] int link_of(int segment) const { return link_of_segment_[static_cast<std::size_t>(segment)]; }
  /// Links with degrees of freedom from the root to `link`, itself included, in that order.
  [[nodiscard]] const std::vector<int>& chain(int link) const { return chains_[static_cast<std::size_t>(link)]; }
  /// Degrees of freedom of `chain(link)`, in that order: the columns of its Jacobians.
  [[nodiscard]] const std::vector<int>& chain_dofs(int link) const {
    return chain_dofs_[static_cast<std::size_t>(link)];
  }

  /// Everything at rest, the root's translation at its place in the skeleton.
  [[nodiscard]] TreeState rest() const;
  /// state ⊞ δ for the pose alone; δ has one entry per degree of freedom.
  void add(TreeState& state, const Eigen::Ref<const VectorXd>& delta) const;
  /// b ⊟ a: the δ with a ⊞ δ = b.
  [[nodiscard]] VectorXd difference(const TreeState& a, const TreeState& b) const;
  /// R_joint of every segment away from rest, as poses_from_joints takes it.
  [[nodiscard]] std::vector<Quaterniond> segment_rotations(const TreeState& state) const;
  /// World position of the root joint.
  [[nodiscard]] Vector3d root_position(const TreeState& state) const;
  /// Sets the free root's pose: R_WL of the root segment and the place of its joint. Asserts RootMotion::kFree.
  void set_root(TreeState& state, const Quaterniond& R_WL, const Vector3d& p_W) const;
  /// Sets a segment's R_joint away from rest, as far as its degrees of freedom go: hinges take the nearest angles.
  void set_segment(TreeState& state, int segment, const Quaterniond& R_joint) const;

 private:
  void append(TreeLink link, bool ends_segment);
  RootMotion root_;
  int dofs_ = 0;
  std::vector<TreeLink> links_;
  std::vector<int> link_of_segment_;
  std::vector<std::vector<int>> chains_, chain_dofs_;
};

/// The angles q with exp(a1 q1) exp(a2 q2) nearest to R, continued from `guess` (two pairs of angles can give the same
/// rotation). With a2 zero, the one angle about a1, within half a turn of the guess.
Eigen::Vector2d nearest_angles(const Quaterniond& R, const Vector3d& a1, const Vector3d& a2,
                               const Eigen::Vector2d& guess);

}  // namespace limbwave::body
