#include "body/tree_state.h"

#include <algorithm>
#include <cassert>

#include "geometry/so3.h"

namespace limbwave::body {

void Tree::append(TreeLink link, bool ends_segment) {
  const int index = static_cast<int>(links_.size());
  link.first = dofs_;
  dofs_ += link.count;
  std::vector<int> chain;
  std::vector<int> dofs;
  if (link.parent >= 0) {
    chain = this->chain(link.parent);
    dofs = chain_dofs(link.parent);
  }
  if (link.count > 0) {
    chain.push_back(index);
    for (int i = 0; i < link.count; ++i) {
      dofs.push_back(link.first + i);
    }
  }
  chains_.push_back(std::move(chain));
  chain_dofs_.push_back(std::move(dofs));
  if (ends_segment) {
    link_of_segment_[static_cast<std::size_t>(link.segment)] = index;
  }
  links_.push_back(link);
}

Tree::Tree(const Skeleton& skeleton, RootMotion root) : root_(root), link_of_segment_(skeleton.segments.size(), -1) {
  for (std::size_t s = 0; s < skeleton.segments.size(); ++s) {
    const Segment& segment = skeleton.segments[s];
    TreeLink link;
    link.segment = static_cast<int>(s);
    link.parent = segment.parent < 0 ? -1 : link_of(segment.parent);
    link.p_PL = segment.p_PL;
    link.R_rest = segment.R_PL_rest;
    JointKind kind = segment.joint.kind;
    if (segment.parent < 0 && root == RootMotion::kFree) {
      TreeLink translation;
      translation.kind = LinkKind::kTranslation;
      translation.segment = link.segment;
      translation.count = 3;
      append(translation, false);
      link.parent = 0;
      link.p_PL.setZero();
      kind = JointKind::kSpherical;
    }
    switch (kind) {
      case JointKind::kFixed:
        append(link, true);
        break;
      case JointKind::kSpherical:
        link.kind = LinkKind::kBall;
        link.count = 3;
        append(link, true);
        break;
      case JointKind::kHinge:
      case JointKind::kUniversal:
        link.kind = LinkKind::kHinge;
        link.count = 1;
        link.axis = segment.joint.axis;
        append(link, kind == JointKind::kHinge);
        if (kind == JointKind::kUniversal) {
          link.parent = static_cast<int>(links_.size()) - 1;
          link.axis = segment.joint.axis2;
          link.axis_index = 1;
          link.p_PL.setZero();
          link.R_rest.setIdentity();
          append(link, true);
        }
        break;
    }
  }
}

TreeState Tree::rest() const {
  TreeState state;
  state.R_joint.assign(links_.size(), Quaterniond::Identity());
  state.q = state.qd = state.qdd = VectorXd::Zero(dofs_);
  return state;
}

void Tree::add(TreeState& state, const Eigen::Ref<const VectorXd>& delta) const {
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const TreeLink& link = links_[l];
    if (link.kind == LinkKind::kBall) {
      state.R_joint[l] = (state.R_joint[l] * geometry::exp_so3(delta.segment<3>(link.first))).normalized();
    } else if (link.count > 0) {
      state.q.segment(link.first, link.count) += delta.segment(link.first, link.count);
    }
  }
}

VectorXd Tree::difference(const TreeState& a, const TreeState& b) const {
  VectorXd delta = b.q - a.q;
  for (std::size_t l = 0; l < links_.size(); ++l) {
    if (links_[l].kind == LinkKind::kBall) {
      delta.segment<3>(links_[l].first) = geometry::log_so3(a.R_joint[l].conjugate() * b.R_joint[l]);
    }
  }
  return delta;
}

std::vector<Quaterniond> Tree::segment_rotations(const TreeState& state) const {
  std::vector<Quaterniond> R(link_of_segment_.size(), Quaterniond::Identity());
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const TreeLink& link = links_[l];
    Quaterniond& turned = R[static_cast<std::size_t>(link.segment)];
    if (link.kind == LinkKind::kBall) {
      turned = state.R_joint[l];
    } else if (link.kind == LinkKind::kHinge) {
      turned = turned * Quaterniond(Eigen::AngleAxisd(state.q[link.first], link.axis));
    }
  }
  return R;
}

Vector3d Tree::root_position(const TreeState& state) const {
  const TreeLink& root = links_.front();
  return root.kind == LinkKind::kTranslation ? Vector3d(state.q.segment<3>(root.first)) : root.p_PL;
}

void Tree::set_root(TreeState& state, const Quaterniond& R_WL, const Vector3d& p_W) const {
  assert(root_ == RootMotion::kFree);
  state.q.segment<3>(0) = p_W;
  state.R_joint[1] = (links_[1].R_rest.conjugate() * R_WL).normalized();
}

void Tree::set_segment(TreeState& state, int segment, const Quaterniond& R_joint) const {
  const auto last = static_cast<std::size_t>(link_of(segment));
  const TreeLink& link = links_[last];
  if (link.kind == LinkKind::kBall) {
    state.R_joint[last] = R_joint.normalized();
  } else if (link.kind == LinkKind::kHinge && link.axis_index == 0) {
    state.q[link.first] = nearest_angles(R_joint, link.axis, Vector3d::Zero(), {state.q[link.first], 0.0})[0];
  } else if (link.kind == LinkKind::kHinge) {
    state.q.segment<2>(link.first - 1) =
        nearest_angles(R_joint, links_[last - 1].axis, link.axis, state.q.segment<2>(link.first - 1));
  }
}

Eigen::Vector2d nearest_angles(const Quaterniond& R, const Vector3d& a1, const Vector3d& a2,
                               const Eigen::Vector2d& guess) {
  if (a2.isZero()) {
    const double twist = 2.0 * std::atan2(R.vec().dot(a1), R.w());
    // The turn that is nearest to the guess.
    return {twist + 2.0 * EIGEN_PI * std::round((guess[0] - twist) / (2.0 * EIGEN_PI)), 0.0};
  }
  Eigen::Vector2d q = guess;
  for (int iteration = 0; iteration < 12; ++iteration) {
    const Quaterniond R2(Eigen::AngleAxisd(q[1], a2));
    const Vector3d error = geometry::log_so3((Quaterniond(Eigen::AngleAxisd(q[0], a1)) * R2).conjugate() * R);
    Eigen::Matrix<double, 3, 2> J;
    J << R2.conjugate() * a1, a2;
    const Eigen::Matrix2d normal = J.transpose() * J + 1e-12 * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d step = normal.inverse() * (J.transpose() * error);
    q += step;
    if (step.norm() < 1e-12) {
      break;
    }
  }
  return q;
}

}  // namespace limbwave::body
