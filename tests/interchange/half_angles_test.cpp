#include "interchange/half_angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace limbwave::interchange {
namespace {

TEST(HalfAngles, AgreeWithTheTrueValues) {
  constexpr long double kRadians = 3.14159265358979323846264338327950288L / 180.0L;
  std::mt19937_64 random(71);
  for (const double range : {1e-9, 1.0, 180.0, 1000.0, 1e8, 1e12}) {
    std::uniform_real_distribution<double> uniform(-range, range);
    // A length that no block fits.
    std::vector<double> angles(10007);
    for (double& angle : angles) {
      angle = uniform(random);
    }
    std::vector<double> sines(angles.size());
    std::vector<double> cosines(angles.size());
    half_angles(angles, sines, cosines);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const long double half = std::fmod(static_cast<long double>(angles[i]), 720.0L) * 0.5L * kRadians;
      ASSERT_NEAR(sines[i], static_cast<double>(std::sin(half)), 2e-16) << angles[i];
      ASSERT_NEAR(cosines[i], static_cast<double>(std::cos(half)), 2e-16) << angles[i];
    }
  }
}

TEST(HalfAngles, QuartersOfATurnAreExact) {
  const std::vector<double> angles = {0, 180, 360, 540, 720, -180, -360, -540, 3.6e15};
  std::vector<double> sines(angles.size());
  std::vector<double> cosines(angles.size());
  half_angles(angles, sines, cosines);
  EXPECT_EQ(sines, (std::vector<double>{0, 1, 0, -1, 0, -1, 0, 1, 0}));
  EXPECT_EQ(cosines, (std::vector<double>{1, 0, -1, 0, 1, 0, -1, 0, 1}));
}

}  // namespace
}  // namespace limbwave::interchange
