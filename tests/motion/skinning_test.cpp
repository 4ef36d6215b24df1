#include "motion/skinning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "motion/clip.h"
#include "motion/mannequin.h"

namespace limbwave::motion {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Three bones of 0.4 m along x, and a closed tube around them.
struct Arm {
  body::Skeleton skeleton;
  TriangleMesh mesh;

  explicit Arm(std::uint32_t rings = 53, std::uint32_t sides = 16) {
    for (int i = 0; i < 3; ++i) {
      body::Segment segment;
      segment.name = "bone" + std::to_string(i);
      segment.parent = i - 1;
      segment.p_PL = i == 0 ? Vector3d(0, 0, 1) : Vector3d(0.4, 0, 0);
      segment.length = 0.4;
      skeleton.segments.push_back(segment);
    }
    for (std::uint32_t r = 0; r < rings; ++r) {
      for (std::uint32_t k = 0; k < sides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / sides;
        mesh.positions.emplace_back(
            Vector3d(-0.05 + 1.3 * r / (rings - 1), 0.05 * std::cos(angle), 1.0 + 0.05 * std::sin(angle))
                .cast<float>());
      }
    }
    mesh.positions.emplace_back(-0.06F, 0.0F, 1.0F);
    mesh.positions.emplace_back(1.26F, 0.0F, 1.0F);
    const std::uint32_t begin = rings * sides;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = (k + 1) % sides;
      mesh.triangles.push_back({begin, next, k});
      mesh.triangles.push_back({begin + 1, (rings - 1) * sides + k, (rings - 1) * sides + next});
      for (std::uint32_t r = 0; r + 1 < rings; ++r) {
        const std::uint32_t a = r * sides;
        mesh.triangles.push_back({a + k, a + next, a + sides + k});
        mesh.triangles.push_back({a + next, a + sides + next, a + sides + k});
      }
    }
  }
};

double weight_of(const SkinnedMesh& mesh, std::size_t vertex, std::size_t bone) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kInfluences; ++k) {
    sum += mesh.segments[vertex][k] == bone ? static_cast<double>(mesh.weights[vertex][k]) : 0.0;
  }
  return sum;
}

TEST(Skinning, BonesRuleTheirMiddlesAndBlendAtJoints) {
  const Arm arm;
  const auto skin = skinned(arm.mesh, arm.skeleton, rest_poses(arm.skeleton));
  ASSERT_TRUE(skin.ok()) << skin.error().text();
  ASSERT_TRUE(validate(*skin, arm.skeleton).ok()) << validate(*skin, arm.skeleton).error().text();
  for (std::size_t v = 0; v < skin->positions.size(); ++v) {
    const float x = skin->positions[v].x();
    if (x > 0.15F && x < 0.25F) {
      EXPECT_GT(weight_of(*skin, v, 0), 0.95) << v;
    }
    if (x > 0.55F && x < 0.65F) {
      EXPECT_GT(weight_of(*skin, v, 1), 0.95) << v;
    }
    if (x > 1.0F) {
      EXPECT_GT(weight_of(*skin, v, 2), 0.95) << v;
    }
    if (std::abs(x - 0.4F) < 0.005F) {
      EXPECT_NEAR(weight_of(*skin, v, 0), 0.5, 0.05) << v;
    }
  }
}

TEST(Skinning, WeightsAreSmoothAndTheSameAllAround) {
  const Arm arm(105, 24);
  const auto skin = skinned(arm.mesh, arm.skeleton, rest_poses(arm.skeleton));
  ASSERT_TRUE(skin.ok());
  for (const auto& triangle : arm.mesh.triangles) {
    for (std::size_t bone = 0; bone < 3; ++bone) {
      EXPECT_LT(std::abs(weight_of(*skin, triangle[0], bone) - weight_of(*skin, triangle[1], bone)), 0.35);
    }
  }
  for (std::uint32_t r = 0; r < 105; ++r) {
    for (std::uint32_t k = 1; k < 24; ++k) {
      EXPECT_NEAR(weight_of(*skin, r * 24 + k, 1), weight_of(*skin, r * 24, 1), 0.02) << r;
    }
  }
}

// Two parallel tubes near each other, a bone in each: the wall between them hides the neighbour's bone.
TEST(Skinning, ABoneBehindAWallDoesNotMoveASkinThatIsNearer) {
  const Arm one(41, 12);
  body::Skeleton skeleton;
  TriangleMesh mesh;
  for (int i = 0; i < 3; ++i) {
    body::Segment segment;
    segment.name = "root" + std::to_string(i);
    segment.parent = i == 0 ? -1 : 0;
    segment.p_PL = i == 0 ? Vector3d(0, 0, 1) : Vector3d(0, i == 1 ? 0.0 : 0.12, 0);
    segment.length = i == 0 ? 0.0 : 1.2;
    skeleton.segments.push_back(segment);
  }
  for (int tube = 0; tube < 2; ++tube) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vector3f& p : one.mesh.positions) {
      // The second tube is thick and its bone far from the wall towards the first.
      mesh.positions.push_back(p + Vector3f(0, tube == 0 ? 0.0F : 0.105F, 0));
    }
    for (const auto& [a, b, c] : one.mesh.triangles) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  const auto skin = skinned(mesh, skeleton, rest_poses(skeleton));
  ASSERT_TRUE(skin.ok()) << skin.error().text();
  for (std::size_t v = 0; v < one.mesh.positions.size(); ++v) {
    if (skin->positions[v].x() > 0.2F) {
      EXPECT_GT(weight_of(*skin, v, 1), 0.9) << v;
    }
    const std::size_t other = v + one.mesh.positions.size();
    if (skin->positions[other].x() > 0.2F) {
      EXPECT_GT(weight_of(*skin, other, 2), 0.9) << v;
    }
  }
}

TEST(Skinning, SeamsOfVerticesAtOnePlaceStayClosed) {
  Arm arm(21, 8);
  // Every triangle with corners of its own, as files with texture seams have them.
  TriangleMesh split;
  for (const auto& triangle : arm.mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(split.positions.size());
    for (const std::uint32_t corner : triangle) {
      split.positions.push_back(arm.mesh.positions[corner]);
    }
    split.triangles.push_back({first, first + 1, first + 2});
  }
  const auto whole = skinned(arm.mesh, arm.skeleton, rest_poses(arm.skeleton));
  const auto apart = skinned(split, arm.skeleton, rest_poses(arm.skeleton));
  ASSERT_TRUE(whole.ok() && apart.ok());
  for (std::size_t t = 0; t < arm.mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(weight_of(*apart, 3 * t + k, 1), weight_of(*whole, arm.mesh.triangles[t][k], 1), 1e-4);
    }
  }
}

TEST(Skinning, RefusesWhatCannotBeSkinnedAndCanBeCancelled) {
  Arm arm(5, 6);
  const auto rest = rest_poses(arm.skeleton);
  TriangleMesh empty;
  EXPECT_FALSE(skinned(empty, arm.skeleton, rest).ok());
  EXPECT_FALSE(skinned(arm.mesh, {}, {}).ok());
  TriangleMesh wrong = arm.mesh;
  wrong.triangles[3][1] = 1000000;
  EXPECT_EQ(skinned(wrong, arm.skeleton, rest).error().message, "triangle 3 has a corner that does not exist");
  wrong = arm.mesh;
  wrong.positions[2].x() = NAN;
  EXPECT_FALSE(skinned(wrong, arm.skeleton, rest).ok());
  const auto stopped =
      skinned(arm.mesh, arm.skeleton, rest, {}, Progress([](double, std::string_view) { return false; }));
  ASSERT_FALSE(stopped.ok());
  EXPECT_TRUE(is_cancelled(stopped.error()));
}

TEST(Skinning, AMeshOfAnotherSizeIsFitted) {
  body::Skeleton skeleton;
  for (const double z : {0.1, 1.5}) {
    body::Segment segment;
    segment.name = std::to_string(z);
    segment.parent = skeleton.segments.empty() ? -1 : 0;
    segment.p_PL = {0, 0, skeleton.segments.empty() ? z : 1.4};
    skeleton.segments.push_back(segment);
  }
  TriangleMesh giant;
  giant.positions = {{0, 500, 0}, {30, 500, 0}, {0, 500, 180}};
  giant.triangles = {{0, 1, 2}};
  const TriangleMesh person = fitted(giant, rest_poses(skeleton));
  EXPECT_NEAR(person.positions[2].z() - person.positions[0].z(), 1.4 * 1.12, 1e-5);
  EXPECT_NEAR(person.positions[0].z(), 0.1 - 0.05 * 1.4, 1e-5);
  EXPECT_NEAR(person.positions[2].y(), 0.0, 1e-5);
  EXPECT_EQ(fitted(person, rest_poses(skeleton)).positions, person.positions);
}

TEST(Mannequin, IsAValidClosedSkinForAnySkeleton) {
  const Arm arm;
  body::Skeleton dot;
  dot.segments.resize(1);
  dot.segments[0].name = "dot";
  for (const body::Skeleton& skeleton : {arm.skeleton, dot}) {
    const auto mesh = mannequin(skeleton);
    ASSERT_TRUE(validate(*mesh, skeleton).ok()) << validate(*mesh, skeleton).error().text();
    EXPECT_FALSE(mesh->triangles.empty());
    // Closed and turned outwards: the volume of all triangles over the origin is positive.
    double volume = 0.0;
    for (const auto& [a, b, c] : mesh->triangles) {
      const Vector3d p = mesh->positions[a].cast<double>() - Vector3d(0, 0, 1);
      const Vector3d q = mesh->positions[b].cast<double>() - Vector3d(0, 0, 1);
      const Vector3d r = mesh->positions[c].cast<double>() - Vector3d(0, 0, 1);
      volume += p.dot(q.cross(r)) / 6.0;
    }
    EXPECT_GT(volume, 0.0);
  }
}

}  // namespace
}  // namespace limbwave::motion
