#include "body/tree_kinematics.h"

#include "geometry/so3.h"

namespace limbwave::body {

TreeKinematics::TreeKinematics(const Tree& tree) : tree_(&tree), motion_(tree.links().size()) {}

void TreeKinematics::update(const TreeState& state, const std::vector<double>& place_scale) {
  const LinkMotion world;
  for (std::size_t l = 0; l < motion_.size(); ++l) {
    const TreeLink& link = tree_->links()[l];
    const LinkMotion& parent = link.parent < 0 ? world : motion_[static_cast<std::size_t>(link.parent)];
    LinkMotion& m = motion_[l];
    const Vector3d r = parent.R_WL * (place_scale.empty() ? link.p_PL : Vector3d(place_scale[l] * link.p_PL));
    const Vector3d w_cross_r = parent.w.cross(r);
    m.p = parent.p + r;
    m.v = parent.v + w_cross_r;
    m.a = parent.a + parent.al.cross(r) + parent.w.cross(w_cross_r);
    m.w = m.w_before = parent.w;
    m.al = m.al_before = parent.al;
    switch (link.kind) {
      case LinkKind::kFixed:
        m.R_WL = parent.R_WL * link.R_rest.toRotationMatrix();
        break;
      case LinkKind::kTranslation:
        // Only the root's: its parent is the world, which stands still.
        m.R_WL.setIdentity();
        m.S.setIdentity();
        m.p += state.q.segment<3>(link.first);
        m.v += state.qd.segment<3>(link.first);
        m.a += state.qdd.segment<3>(link.first);
        break;
      case LinkKind::kBall: {
        m.R_WL = parent.R_WL * (link.R_rest * state.R_joint[l]).toRotationMatrix();
        m.S = m.R_WL;
        const Vector3d w_rel = m.R_WL * state.qd.segment<3>(link.first);
        m.w += w_rel;
        m.al += m.R_WL * state.qdd.segment<3>(link.first) + parent.w.cross(w_rel);
        break;
      }
      case LinkKind::kHinge: {
        m.R_WL = parent.R_WL *
                 (link.R_rest * Quaterniond(Eigen::AngleAxisd(state.q[link.first], link.axis))).toRotationMatrix();
        m.S.col(0) = m.R_WL * link.axis;
        const Vector3d w_rel = m.S.col(0) * state.qd[link.first];
        m.w += w_rel;
        m.al += m.S.col(0) * state.qdd[link.first] + parent.w.cross(w_rel);
        break;
      }
    }
  }
}

TreeKinematics::PointMotion TreeKinematics::point(int link, const Vector3d& p_L) const {
  const LinkMotion& m = this->link(link);
  const Vector3d r = m.R_WL * p_L;
  return {m.p + r, m.v + m.w.cross(r), m.a + offset_acceleration(link, r)};
}

// Turning joint k by δθ turns, rigidly and about the joint, everything beyond it together with its motion relative to
// the frame before the joint. Changing its velocity by δθ̇ changes the motion of the frame behind the joint, against
// which everything beyond moves as before. The formulas are those of motion in a moving frame.
void TreeKinematics::jacobians(int link, const PointMotion& point, unsigned need, PointJacobians& j) const {
  const auto columns = static_cast<Eigen::Index>(tree_->chain_dofs(link).size());
  const auto fit = [&](Jacobian& matrix, bool wanted) {
    if (wanted && matrix.cols() != columns) {
      matrix.resize(3, columns);
    }
  };
  const bool velocity = (need & (kVelocity | kAcceleration)) != 0;
  const bool acceleration = (need & kAcceleration) != 0;
  const bool angular = (need & kAngular) != 0;
  fit(j.J_phi_theta, true);
  fit(j.J_p_theta, true);
  fit(j.J_v_theta, velocity);
  fit(j.J_a_theta, acceleration);
  fit(j.J_a_thetad, acceleration);
  fit(j.J_w_theta, true);
  fit(j.J_al_theta, angular);
  fit(j.J_al_thetad, angular);
  const LinkMotion& end = this->link(link);
  Eigen::Index column = 0;
  for (const int k : tree_->chain(link)) {
    const TreeLink& joint = tree_->links()[static_cast<std::size_t>(k)];
    const LinkMotion& m = this->link(k);
    if (joint.kind == LinkKind::kTranslation) {
      j.J_phi_theta.middleCols<3>(column).setZero();
      j.J_p_theta.middleCols<3>(column).setIdentity();
      j.J_w_theta.middleCols<3>(column).setZero();
      for (Jacobian* zero : {velocity ? &j.J_v_theta : nullptr, acceleration ? &j.J_a_theta : nullptr,
                             acceleration ? &j.J_a_thetad : nullptr, angular ? &j.J_al_theta : nullptr,
                             angular ? &j.J_al_thetad : nullptr}) {
        if (zero != nullptr) {
          zero->middleCols<3>(column).setZero();
        }
      }
      column += 3;
      continue;
    }
    const Vector3d& wp = m.w_before;
    const Vector3d& ap = m.al_before;
    const Vector3d rho = point.p - m.p;
    const Vector3d w_rel = end.w - wp;  // seen from before the joint
    const Vector3d v_rel = point.v - m.v - wp.cross(rho);
    const Vector3d v_own = point.v - m.v - m.w.cross(rho);  // seen from behind the joint
    const Vector3d a_rel = point.a - m.a - ap.cross(rho) - wp.cross(wp.cross(rho)) - 2.0 * wp.cross(v_rel);
    const Vector3d al_rel = end.al - ap - wp.cross(w_rel);
    for (int i = 0; i < joint.count; ++i, ++column) {
      const Vector3d s = m.S.col(i);
      const Vector3d p_s = s.cross(rho);
      j.J_phi_theta.col(column) = s;
      j.J_p_theta.col(column) = p_s;
      j.J_w_theta.col(column) = s.cross(w_rel);
      if (velocity) {
        j.J_v_theta.col(column) = wp.cross(p_s) + s.cross(v_rel);
      }
      if (acceleration) {
        const Vector3d wp_s = wp.cross(s);
        j.J_a_theta.col(column) =
            ap.cross(p_s) + wp.cross(wp.cross(p_s)) + 2.0 * wp.cross(s.cross(v_rel)) + s.cross(a_rel);
        j.J_a_thetad.col(column) = wp_s.cross(rho) + s.cross(m.w.cross(rho)) + m.w.cross(p_s) + 2.0 * s.cross(v_own);
      }
      if (angular) {
        j.J_al_theta.col(column) = wp.cross(s.cross(w_rel)) + s.cross(al_rel);
        j.J_al_thetad.col(column) = wp.cross(s) + s.cross(end.w - m.w);
      }
    }
  }
}

}  // namespace limbwave::body
