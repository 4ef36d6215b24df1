// Which parts of a skeleton may stand on the ground.
#include "estimate/soles.h"
#include "support/worn_boards.h"

namespace limbwave::estimate {
namespace {

using namespace testing_support;

TEST(Soles, OfABodyAreItsFeetWithTheirBoards) {
  const BodyModel model = eight_boards();
  const std::vector<Sole> soles = find_soles(model);
  ASSERT_EQ(soles.size(), 2U);
  EXPECT_EQ(soles[0].name, "left_foot");
  EXPECT_EQ(soles[1].name, "right_foot");
  for (const Sole& sole : soles) {
    EXPECT_EQ(model.boards[static_cast<std::size_t>(sole.board)].segment, sole.segment);
    EXPECT_NEAR(sole.p_L.z(), -0.08, 1e-9);
    EXPECT_NEAR((sole.toe_L - sole.heel_L).norm(), 0.22, 1e-9);
    EXPECT_NEAR((sole.heel_L + sole.toe_L - 2.0 * sole.p_L).norm(), 0.0, 1e-9);
  }
}

TEST(Soles, WithoutABoardAreSolesAllTheSame) {
  const std::vector<Sole> soles = find_soles(worn_boards({"pelvis", "left_shin"}));
  ASSERT_EQ(soles.size(), 2U);
  EXPECT_EQ(soles[0].board, -1);
  EXPECT_EQ(soles[1].board, -1);
}

// Nothing is known of a foot's shape: its bone stands.
TEST(Soles, WithoutCapsulesBonesStand) {
  BodyModel model = eight_boards();
  for (body::Segment& segment : model.skeleton.segments) {
    segment.capsules.clear();
  }
  const std::vector<Sole> soles = find_soles(model);
  ASSERT_EQ(soles.size(), 2U);
  EXPECT_NEAR((soles[0].toe_L - soles[0].heel_L).norm(), 0.2, 1e-9);
}

// One foot higher than the other by more than a shoe is no foot that stands; hands are none either.
TEST(Soles, WhatHangsHighIsNone) {
  BodyModel model = eight_boards();
  const auto shin = static_cast<std::size_t>(model.skeleton.find("right_foot"));
  model.skeleton.segments[shin].p_PL.x() -= 0.1;
  const std::vector<Sole> soles = find_soles(model);
  ASSERT_EQ(soles.size(), 1U);
  EXPECT_EQ(soles[0].name, "left_foot");
}

}  // namespace
}  // namespace limbwave::estimate
