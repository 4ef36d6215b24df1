/// Rotations: exponential and logarithm of SO(3), their Jacobians, shortest arcs, distances.
/// Convention: R_AB takes a vector from B to A (v_A = R_AB * v_B). Angles in radians.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace limbwave::geometry {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// The matrix with skew(a) * b = a × b.
Matrix3d skew(const Vector3d& a);

/// Rotation by |phi| about phi (Rodrigues). Exact to rounding for every length, also near zero.
Quaterniond exp_so3(const Vector3d& phi);

/// The rotation vector of `R`, of length 0..π. q and −q give the same; at exactly π one of the two signs is chosen.
Vector3d log_so3(const Quaterniond& R);

/// Right Jacobian: exp(phi + d) ≈ exp(phi) exp(right_jacobian(phi) d). 3×3.
Matrix3d right_jacobian(const Vector3d& phi);
/// Inverse of the right Jacobian; defined for |phi| < 2π.
Matrix3d right_jacobian_inverse(const Vector3d& phi);
/// Left Jacobian: exp(phi + d) ≈ exp(left_jacobian(phi) d) exp(phi). 3×3.
Matrix3d left_jacobian(const Vector3d& phi);
/// Inverse of the left Jacobian; defined for |phi| < 2π.
Matrix3d left_jacobian_inverse(const Vector3d& phi);

/// The rotation R with the smallest angle such that R * from is parallel to `to`; lengths do not matter.
/// For opposite directions, where every perpendicular axis serves, the axis is `fallback_axis` made perpendicular to
/// `from` (or any perpendicular one when that vanishes). Input without a direction (zero, not finite) gives the
/// identity.
Quaterniond shortest_arc(const Vector3d& from, const Vector3d& to, const Vector3d& fallback_axis = Vector3d::UnitY());

/// Angle of R1ᵀ R2, 0..π: the error between two orientations.
double geodesic_angle(const Quaterniond& R1, const Quaterniond& R2);

/// Angle between two directions, 0..π, accurate also for nearly parallel and opposite ones.
double angle_between(const Vector3d& a, const Vector3d& b);

/// The rotation matrix nearest to `M` in the Frobenius norm (polar decomposition by SVD, determinant +1).
Matrix3d nearest_rotation(const Matrix3d& M);

/// The heading ψ of R_WL: the angle about the vertical in R_WL = Rz(ψ) · shortest_arc(up_L → z), in −π..π.
double heading_about_vertical(const Quaterniond& R_WL);

}  // namespace limbwave::geometry
