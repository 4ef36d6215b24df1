#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::geometry {
namespace {

// Central differences, Richardson-extrapolated: errors of the order h⁴.
Matrix3d numerical(const std::function<Vector3d(const Vector3d&)>& f) {
  constexpr double h = 1e-3;
  Matrix3d J;
  for (int i = 0; i < 3; ++i) {
    const Vector3d d = Vector3d::Unit(i);
    const Vector3d wide = (f(h * d) - f(-h * d)) / (2 * h);
    const Vector3d narrow = (f(0.5 * h * d) - f(-0.5 * h * d)) / h;
    J.col(i) = (4.0 * narrow - wide) / 3.0;
  }
  return J;
}

class So3Jacobian : public testing::TestWithParam<double> {};

TEST_P(So3Jacobian, AgreesWithNumericalOnes) {
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(Vector3d(1, -2, 3).normalized())}) {
    const Vector3d phi = GetParam() * axis;
    const Quaterniond q = exp_so3(phi);
    const Matrix3d right = numerical([&](const Vector3d& d) { return log_so3(q.conjugate() * exp_so3(phi + d)); });
    const Matrix3d left = numerical([&](const Vector3d& d) { return log_so3(exp_so3(phi + d) * q.conjugate()); });
    EXPECT_LT((right_jacobian(phi) - right).norm(), 1e-10);
    EXPECT_LT((left_jacobian(phi) - left).norm(), 1e-10);
  }
}

TEST_P(So3Jacobian, InversesAreInverses) {
  for (const Vector3d& axis : {Vector3d(0, 1, 0), Vector3d(Vector3d(-3, 2, 1).normalized())}) {
    const Vector3d phi = GetParam() * axis;
    EXPECT_LT((right_jacobian(phi) * right_jacobian_inverse(phi) - Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_LT((left_jacobian_inverse(phi) * left_jacobian(phi) - Matrix3d::Identity()).norm(), 1e-13);
  }
}

TEST_P(So3Jacobian, InverseIsTheDerivativeOfTheLogarithm) {
  if (GetParam() > kPi - 0.01) {
    GTEST_SKIP() << "the logarithm jumps at half a turn";
  }
  const Vector3d phi = GetParam() * Vector3d(2, 1, -2) / 3;
  const Quaterniond q = exp_so3(phi);
  const Matrix3d J = numerical([&](const Vector3d& d) { return log_so3(q * exp_so3(d)); });
  EXPECT_LT((right_jacobian_inverse(phi) - J).norm(), 1e-10);
}

TEST_P(So3Jacobian, RotationTakesTheRightOneToTheLeftOne) {
  const Vector3d phi = GetParam() * Vector3d(2, 1, -2) / 3;
  EXPECT_LT((left_jacobian(phi) - exp_so3(phi).toRotationMatrix() * right_jacobian(phi)).norm(), 4e-15);
}

INSTANTIATE_TEST_SUITE_P(Angles, So3Jacobian,
                         testing::Values(0.0, 1e-300, 1e-12, 1e-8, 1e-5, 1e-3, 0.00999, 0.0101, 0.1, 1.0, 2.0, 3.0,
                                         kPi - 1e-4, kPi - 1e-8, kPi, 4.0, 5.0));

}  // namespace
}  // namespace limbwave::geometry
