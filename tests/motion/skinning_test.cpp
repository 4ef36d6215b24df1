#include "motion/skinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "motion/clip.h"
#include "motion/mannequin.h"
#include "motion/meshes.h"

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

// Every vertex: one to four bones, weights that sum to 1, no number that is none.
void expect_whole(const SkinnedMesh& skin, const body::Skeleton& skeleton) {
  ASSERT_TRUE(validate(skin, skeleton).ok()) << validate(skin, skeleton).error().text();
  for (std::size_t v = 0; v < skin.positions.size(); ++v) {
    float sum = 0.0F;
    for (std::size_t k = 0; k < kInfluences; ++k) {
      ASSERT_TRUE(skin.weights[v][k] >= 0.0F && skin.weights[v][k] <= 1.0F) << v;
      ASSERT_LT(skin.segments[v][k], skeleton.segments.size());
      sum += skin.weights[v][k];
    }
    ASSERT_NEAR(sum, 1.0F, 1e-6F) << v;
  }
}

// The steepest solution of w'' = (w - p) / d² along a skin at the distance d from its bones rises by 1 / 2d: twice as
// much is allowed over every edge.
std::size_t steep_edges(const SkinnedMesh& skin, const body::Skeleton& skeleton) {
  const auto pieces = test::bone_pieces(skeleton);
  const auto nearest = [&](std::size_t v) {
    double best = 1e9;
    for (const auto& piece : pieces) {
      best = std::min(best, test::distance(skin.positions[v].cast<double>(), piece));
    }
    return best;
  };
  std::size_t steep = 0;
  for (const auto& triangle : skin.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = triangle[k];
      const std::size_t b = triangle[(k + 1) % 3];
      const double length = static_cast<double>((skin.positions[a] - skin.positions[b]).norm());
      const double most = length / std::min(nearest(a), nearest(b)) + 0.02;
      for (std::size_t bone = 0; bone < skeleton.segments.size(); ++bone) {
        steep += std::abs(weight_of(skin, a, bone) - weight_of(skin, b, bone)) > most ? 1 : 0;
      }
    }
  }
  return steep;
}

TEST(Skinning, APersonOf25BonesIsSmoothAndFollowsTheRightLimbs) {
  const body::Skeleton skeleton = test::person_of_25();
  ASSERT_EQ(skeleton.segments.size(), 25U);
  const auto skin = skinned(test::person_mesh(4000), skeleton, rest_poses(skeleton));
  ASSERT_TRUE(skin.ok()) << skin.error().text();
  expect_whole(*skin, skeleton);
  EXPECT_EQ(steep_edges(*skin, skeleton), 0U);
  const auto bone = [&](const char* name) { return static_cast<std::size_t>(skeleton.find(name)); };
  for (std::size_t v = 0; v < skin->positions.size(); ++v) {
    const Vector3f& p = skin->positions[v];
    // No leg moves the other, no arm a leg.
    if (p.z() < 0.6F) {
      EXPECT_LT(weight_of(*skin, v, bone(p.y() > 0.0F ? "rightThigh" : "leftThigh")), 0.05) << v;
      EXPECT_LT(weight_of(*skin, v, bone("leftHand")), 1e-3) << v;
    }
    // The middle of the forearm, two of its radii from both joints: 1 - exp(-2) of the weight on a straight tube.
    if (p.y() > 0.57F && p.y() < 0.60F) {
      EXPECT_GT(weight_of(*skin, v, bone("leftForeArm")), 0.8) << v;
    }
    if (p.z() > 1.65F) {
      EXPECT_GT(weight_of(*skin, v, bone("head")), 0.8) << v;
    }
  }
}

TEST(Skinning, ABadlyMadeMeshIsSkinnedAsWell) {
  const body::Skeleton skeleton = test::person_of_25();
  const TriangleMesh mesh = test::nasty_mesh(5000);
  const auto skin = skinned(mesh, skeleton, rest_poses(skeleton));
  ASSERT_TRUE(skin.ok()) << skin.error().text();
  ASSERT_EQ(skin->positions.size(), mesh.positions.size());
  expect_whole(*skin, skeleton);
  // Corners at one place move alike, whatever triangles they belong to.
  std::map<std::tuple<float, float, float>, std::size_t> at;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vector3f& p = mesh.positions[v];
    const std::size_t first = at.try_emplace({p.x(), p.y(), p.z()}, v).first->second;
    ASSERT_EQ(skin->weights[v], skin->weights[first]);
    ASSERT_EQ(skin->segments[v], skin->segments[first]);
  }
  // The hat follows the head, which is nearest.
  EXPECT_GT(weight_of(*skin, mesh.positions.size() - 1, static_cast<std::size_t>(skeleton.find("head"))), 0.9);
}

TEST(Skinning, ProgressRisesAndEveryReportCanStopIt) {
  const body::Skeleton skeleton = test::person_of_25();
  const TriangleMesh mesh = test::person_mesh(3000);
  std::vector<double> parts;
  const Progress listening([&](double part, std::string_view) {
    parts.push_back(part);
    return true;
  });
  ASSERT_TRUE(skinned(mesh, skeleton, rest_poses(skeleton), {}, listening).ok());
  EXPECT_GT(parts.size(), 20U);
  EXPECT_TRUE(std::ranges::is_sorted(parts));
  EXPECT_GE(parts.front(), 0.0);
  EXPECT_LE(parts.back(), 1.0);
  for (std::size_t stop = 0; stop < parts.size(); stop += 5) {
    std::size_t reports = 0;
    const auto stopped = skinned(mesh, skeleton, rest_poses(skeleton), {},
                                 Progress([&](double, std::string_view) { return reports++ < stop; }));
    ASSERT_FALSE(stopped.ok());
    EXPECT_TRUE(is_cancelled(stopped.error()));
    EXPECT_EQ(reports, stop + 1);
  }
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
