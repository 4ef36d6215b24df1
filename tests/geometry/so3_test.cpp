#include "geometry/so3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/units.h"

namespace limbwave::geometry {
namespace {

const std::vector<double> kAngles{0.0, 1e-300, 1e-12, 1e-8, 9.9e-5, 1.01e-4,    1e-3,       0.00999,    0.0101,
                                  0.1, 1.0,    2.0,   3.0,  3.14,   kPi - 1e-4, kPi - 1e-8, kPi - 1e-12};

std::vector<Vector3d> axes() {
  return {Vector3d::UnitX(), -Vector3d::UnitZ(), Vector3d(1, -2, 3).normalized(),
          Vector3d(1e-9, 1, -1e-9).normalized()};
}

// Rodrigues' formula in long double, as a matrix: another way to the same rotation.
Matrix3d rodrigues(const Vector3d& axis, double angle) {
  const long double s = std::sin(static_cast<long double>(angle));
  const long double half = std::sin(static_cast<long double>(angle) / 2);
  const Matrix3d k = skew(axis);
  return Matrix3d::Identity() + static_cast<double>(s) * k + static_cast<double>(2 * half * half) * k * k;
}

TEST(So3, SkewIsTheCrossProduct) {
  const Vector3d a(1, 2, 3);
  const Vector3d b(-4, 5, 0.5);
  EXPECT_EQ((skew(a) * b - a.cross(b)).norm(), 0.0);
}

TEST(So3, ExponentialAgreesWithRodrigues) {
  for (const Vector3d& axis : axes()) {
    for (const double angle : kAngles) {
      const Quaterniond q = exp_so3(angle * axis);
      EXPECT_NEAR(q.norm(), 1.0, 1e-15);
      EXPECT_LT((q.toRotationMatrix() - rodrigues(axis, angle)).norm(), 2e-15) << angle;
    }
    for (const double angle : {kPi, 4.0, 2 * kPi, 100.0}) {  // beyond half a turn
      EXPECT_LT((exp_so3(angle * axis).toRotationMatrix() - rodrigues(axis, angle)).norm(), 4e-14) << angle;
    }
  }
}

TEST(So3, LogarithmUndoesTheExponential) {
  for (const Vector3d& axis : axes()) {
    for (const double angle : kAngles) {
      const Vector3d phi = angle * axis;
      EXPECT_LE((log_so3(exp_so3(phi)) - phi).norm(), 1e-15 * angle * 4 + 1e-320) << angle;
    }
  }
}

TEST(So3, LogarithmOfQAndMinusQAgree) {
  for (const Vector3d& axis : axes()) {
    for (const double angle : kAngles) {
      const Quaterniond q = exp_so3(angle * axis);
      const Quaterniond minus(-q.w(), -q.x(), -q.y(), -q.z());
      EXPECT_EQ(log_so3(q), log_so3(minus)) << angle;
    }
  }
}

TEST(So3, LogarithmOfHalfATurnHasLengthPi) {
  const Vector3d phi = log_so3(Quaterniond(0, 0, 1, 0));
  EXPECT_NEAR(phi.norm(), kPi, 1e-15);
  EXPECT_NEAR(std::abs(phi.y()), kPi, 1e-15);
  EXPECT_EQ(log_so3(Quaterniond::Identity()).norm(), 0.0);
  EXPECT_EQ(log_so3(Quaterniond(-1, 0, 0, 0)).norm(), 0.0);
}

TEST(So3, ShortestArcTurnsOneDirectionIntoAnother) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 1000; ++i) {
    const Vector3d from = vector() * std::exp(10 * normal(random));
    const Vector3d to = vector() * std::exp(10 * normal(random));
    const Quaterniond R = shortest_arc(from, to);
    EXPECT_LT((R * from.normalized() - to.normalized()).norm(), 1e-14);
    EXPECT_NEAR(geodesic_angle(Quaterniond::Identity(), R), angle_between(from, to), 1e-14) << "no longer than needed";
  }
}

TEST(So3, ShortestArcBetweenNearlyEqualDirections) {
  const Vector3d from(0, 0, 1);
  for (const double angle : {0.0, 1e-15, 1e-8, 1e-4}) {
    const Vector3d to(std::sin(angle), 0, std::cos(angle));
    EXPECT_LE((log_so3(shortest_arc(from, to)) - Vector3d(0, angle, 0)).norm(), 1e-15);
  }
}

TEST(So3, ShortestArcBetweenOppositeDirections) {
  const Vector3d from = Vector3d(0.3, -0.2, 0.9).normalized();
  for (const double off : {0.0, 1e-15, 1e-9, 1e-8, 1e-6, 1e-3}) {
    const Vector3d to = exp_so3(off * from.unitOrthogonal()) * Vector3d(-from);
    const Quaterniond R = shortest_arc(from, to);
    EXPECT_NEAR(R.norm(), 1.0, 1e-15);
    EXPECT_LT((R * from - to).norm(), 1e-15) << off;
  }
  // Which way round is the caller's choice.
  const Quaterniond about_x = shortest_arc(Vector3d::UnitZ(), -Vector3d::UnitZ(), Vector3d(1, 0, 7));
  EXPECT_LT((about_x * Vector3d::UnitX() - Vector3d::UnitX()).norm(), 1e-15);
  const Quaterniond useless_axis = shortest_arc(Vector3d::UnitZ(), -Vector3d::UnitZ(), Vector3d::UnitZ());
  EXPECT_LT((useless_axis * Vector3d::UnitZ() + Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(So3, ShortestArcOfNothingIsTheIdentity) {
  EXPECT_EQ(shortest_arc(Vector3d::Zero(), Vector3d::UnitX()).w(), 1.0);
  EXPECT_EQ(shortest_arc(Vector3d::UnitX(), Vector3d::Zero()).w(), 1.0);
  const double nan = std::nan("");
  EXPECT_EQ(shortest_arc(Vector3d(nan, 0, 0), Vector3d::UnitX()).w(), 1.0);
}

TEST(So3, ShortestArcOfTinyAndHugeVectors) {
  const Quaterniond tiny = shortest_arc(Vector3d(1e-200, 0, 0), Vector3d(0, 1e-200, 0));
  EXPECT_LT((tiny * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
  const Quaterniond huge = shortest_arc(Vector3d(1e200, 0, 0), Vector3d(0, 1e200, 0));
  EXPECT_LT((huge * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
}

TEST(So3, GeodesicAngleIgnoresTheSignOfQuaternions) {
  const Quaterniond a = exp_so3(Vector3d(0.3, 0.1, -2.0));
  for (const double angle : kAngles) {
    const Quaterniond b = a * exp_so3(angle * Vector3d(2, -1, 2) / 3);
    const Quaterniond minus(-b.w(), -b.x(), -b.y(), -b.z());
    EXPECT_NEAR(geodesic_angle(a, b), angle, 2e-15);
    EXPECT_NEAR(geodesic_angle(a, minus), angle, 2e-15);
  }
}

TEST(So3, AngleBetweenIsAccurateEverywhere) {
  for (const double angle : kAngles) {
    const Vector3d a(2, 0, 0);
    const Vector3d b(3 * std::cos(angle), 3 * std::sin(angle), 0);
    EXPECT_NEAR(angle_between(a, b), angle, 1e-15);
  }
}

TEST(So3, NearestRotationOfARotationIsItself) {
  const Matrix3d R = exp_so3(Vector3d(1, -2, 0.5)).toRotationMatrix();
  EXPECT_LT((nearest_rotation(R) - R).norm(), 1e-14);
  EXPECT_LT((nearest_rotation(17.0 * R) - R).norm(), 1e-14);
  // A polar decomposition: stretching along any axes beforehand changes nothing.
  Matrix3d stretch;
  stretch << 2.0, 0.3, 0.1, 0.3, 1.5, -0.2, 0.1, -0.2, 0.8;
  EXPECT_LT((nearest_rotation(R * stretch) - R).norm(), 1e-14);
}

TEST(So3, NearestRotationIsNeverAReflection) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Matrix3d M = Matrix3d::NullaryExpr([&] { return normal(random); });
    const Matrix3d R = nearest_rotation(M);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-13);
    EXPECT_LT((R.transpose() * R - Matrix3d::Identity()).norm(), 1e-13);
    // No rotation close by is nearer.
    for (int k = 0; k < 20; ++k) {
      const Vector3d d = 0.1 * Vector3d(normal(random), normal(random), normal(random));
      EXPECT_GE((R * exp_so3(d).toRotationMatrix() - M).norm(), (R - M).norm() - 1e-12);
    }
  }
}

TEST(So3, HeadingIsWhatWasTurnedAboutTheVertical) {
  for (const double heading : {0.0, 1e-8, 0.5, -2.0, 3.1, -3.1}) {
    for (const Vector3d& tilt :
         {Vector3d(0, 0, 0), Vector3d(1e-8, 0, 0), Vector3d(0.7, -1.1, 0), Vector3d(0, 2.9, 0)}) {
      // A rotation about a level axis is a shortest arc between its images of the vertical.
      const Quaterniond R_WL = exp_so3(Vector3d(0, 0, heading)) * exp_so3(tilt);
      EXPECT_NEAR(heading_about_vertical(R_WL), heading, 1e-9) << heading << " " << tilt.transpose();
      const Quaterniond minus(-R_WL.w(), -R_WL.x(), -R_WL.y(), -R_WL.z());
      EXPECT_NEAR(heading_about_vertical(minus), heading, 1e-9);
    }
  }
}

}  // namespace
}  // namespace limbwave::geometry
