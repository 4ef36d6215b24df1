#include "decode/source_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/so3.h"

namespace limbwave::decode {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kSlot = 0.008;
constexpr double kGravity = 9.80665;

// A board on C and one on a limb that hangs on C by a joint; at rest all axes are the same, x up.
BoxGeometry two_boards() {
  BoxGeometry geometry;
  geometry.reference = 0;
  geometry.reference_place = Vector3d(0.1, 0.0, 0.0);
  geometry.R_CS_rest = {Quaterniond::Identity(), Quaterniond::Identity()};
  geometry.boards = {{}, {{1, Vector3d(0.0, 0.2, 0.0)}}};
  geometry.board_places = {geometry.reference_place, Vector3d(0.0, 0.5, 0.0)};
  geometry.sources = {{}};
  geometry.complete = {true};
  return geometry;
}

RangingFormat one_source() {
  RangingFormat format;
  format.sources.resize(1);
  return format;
}

// Everything moves as one piece with the acceleration a(t); the limb is turned by `heading` about the vertical.
double heading_found(double heading, double push, double seconds) {
  SourceMotion motion(one_source(), two_boards());
  const Quaterniond R(geometry::exp_so3(Vector3d(heading, 0.0, 0.0)));
  std::vector<InertialTrace> traces(2);
  for (double t = 0.0; t < seconds + 0.05; t += 1.0 / 140.0) {
    const Vector3d a(kGravity, push * std::sin(7.0 * t), push * std::cos(5.0 * t));
    for (int w = 0; w < 2; ++w) {
      InertialReading reading;
      reading.board = w;
      reading.time = Seconds{t};
      reading.f_S = w == 0 ? a : Vector3d(R.conjugate() * a);
      reading.valid = true;
      traces[static_cast<std::size_t>(w)].add(reading);
    }
  }
  Quaterniond found = Quaterniond::Identity();
  for (std::int64_t slot = 0; slot * kSlot < seconds; ++slot) {
    motion.step(0, 0.01 + static_cast<double>(slot) * kSlot, traces);
    found = motion.board(slot, 1).R_CS;
    motion.forget(slot);
  }
  return geometry::log_so3(found).x();
}

TEST(SourceMotion, ForcesAtAJointTellTheHeadingOfALimb) {
  EXPECT_NEAR(heading_found(1.0, 2.0, 6.0), 1.0, 0.03);
  EXPECT_NEAR(heading_found(-2.0, 2.0, 12.0), -2.0, 0.05);
  EXPECT_NEAR(heading_found(0.0, 2.0, 6.0), 0.0, 0.01);
}

TEST(SourceMotion, GravityAloneTellsNoHeading) {
  EXPECT_NEAR(heading_found(1.0, 0.0, 6.0), 0.0, 0.01);
}

// The skeleton's place goes by the headings on the way, and says so while they are unknown.
TEST(SourceMotion, PlacesGetSurerWithHeadings) {
  SourceMotion motion(one_source(), two_boards());
  std::vector<InertialTrace> traces(2);
  for (double t = 0.0; t < 6.0; t += 1.0 / 140.0) {
    for (int w = 0; w < 2; ++w) {
      InertialReading reading;
      reading.time = Seconds{t};
      reading.f_S = Vector3d(kGravity, 2.0 * std::sin(7.0 * t), 0.0);
      reading.valid = true;
      traces[static_cast<std::size_t>(w)].add(reading);
    }
  }
  double first = 0.0;
  double last = 0.0;
  for (std::int64_t slot = 0; slot < 700; ++slot) {
    motion.step(0, 0.01 + static_cast<double>(slot) * kSlot, traces);
    const BoardStep& board = motion.board(slot, 1);
    if (slot > 1) {
      ASSERT_TRUE(board.placed);
      first = slot == 2 ? board.place_sd : first;
      last = board.place_sd;
      EXPECT_LT((board.place - Vector3d(-0.1, 0.5, 0.0)).norm(), 1e-3);
      EXPECT_LT(board.velocity.norm(), 0.05);
    }
  }
  EXPECT_GT(first, 0.2);  // 0.3 m of limb in any direction
  EXPECT_LT(last, 0.04);
}

TEST(SourceMotion, WithoutWordsNothingIsPlaced) {
  SourceMotion motion(one_source(), two_boards());
  const std::vector<InertialTrace> traces(2);
  for (std::int64_t slot = 0; slot < 5; ++slot) {
    motion.step(0, static_cast<double>(slot) * kSlot, traces);
    EXPECT_FALSE(motion.at(slot).known);
    EXPECT_FALSE(motion.board(slot, 1).placed);
  }
}

}  // namespace
}  // namespace limbwave::decode
