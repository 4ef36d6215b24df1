// Standing feet hold a free root.
#include "estimate/foot_contacts.h"
#include "support/worn_boards.h"

namespace limbwave::estimate {
namespace {

using namespace testing_support;

struct Drift {
  double end = 0.0, height = 0.0, sigma = 0.0, way = 0.0;
  Diagnostics found;
};

Drift drift(const BodyModel& model, const BodyReadings& readings, bool feet, bool smooth = false) {
  BodyWatchParameters parameters;
  parameters.contacts.feet = feet;
  BodyWatch watch(model, parameters);
  const auto run = smooth ? smooth_body(model, free_root(), readings, 50.0, {}, 1.5, &watch)
                          : filter_body(model, free_root(), readings, 50.0, {}, &watch);
  EXPECT_TRUE(run.ok());
  Drift result;
  const RootReading truth = root_at(readings.root, run->track.times.back());
  result.end = (run->track.root_p_W.back() - truth.p_W).norm();
  result.height = std::abs(run->track.root_p_W.back().z() - truth.p_W.z());
  result.sigma = run->track.root_sigma.back().norm();
  result.way = (truth.p_W - readings.root.front().p_W).norm();
  result.found = watch.findings();
  return result;
}

TEST(FootContacts, AWalkDriftsByAPercentInsteadOfDozens) {
  const BodyModel model = eight_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return person.poses(t); }, model, 15.0, 100.0, BoardErrors::worn(), 3);
  const Drift free = drift(model, readings, false);
  const Drift held = drift(model, readings, true);
  std::printf("way %.2f m; free %.3f m (sigma %.2f), contacts %.3f m (sigma %.2f), height %.3f m\n", held.way, free.end,
              free.sigma, held.end, held.sigma, held.height);
  EXPECT_GT(free.end, 5.0 * held.end);
  EXPECT_LT(held.end, 0.04 * held.way);
  EXPECT_LT(held.height, 0.03);
  // Drift is not hidden.
  EXPECT_LT(free.end, 4.0 * free.sigma);
  EXPECT_LT(held.end, 4.0 * held.sigma + 0.05);
  EXPECT_LT(held.sigma, 0.3 * free.sigma);
  for (const char* foot : {"left_foot", "right_foot"}) {
    EXPECT_TRUE(mentions(held.found, "body.foot-stands", foot));
  }
}

// What is believed of feet never changes what is known of limbs, whether they stand or not.
TEST(FootContacts, JointsAreTheSameWithAndWithoutFeet) {
  const BodyModel model = eight_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return person.poses(t + 1.5); }, model, 5.0, 100.0, BoardErrors::worn(), 3);
  std::vector<BodyTrack> tracks[2];
  for (const bool feet : {false, true}) {
    BodyWatchParameters parameters;
    parameters.contacts.feet = feet;
    BodyWatch forward(model, parameters);
    BodyWatch both(model, parameters);
    tracks[feet ? 1 : 0] = {filter_body(model, free_root(), readings, 50.0, {}, &forward)->track,
                            smooth_body(model, free_root(), readings, 50.0, {}, 1.5, &both)->track};
  }
  for (std::size_t way = 0; way < 2; ++way) {
    ASSERT_EQ(tracks[0][way].times, tracks[1][way].times);
    double apart = 0.0;
    for (std::size_t i = 0; i < tracks[0][way].times.size(); ++i) {
      for (std::size_t s = 0; s < tracks[0][way].R_joint[i].size(); ++s) {
        ASSERT_EQ(tracks[0][way].R_joint[i][s].coeffs(), tracks[1][way].R_joint[i][s].coeffs());
      }
      apart = std::max(apart, (tracks[0][way].root_p_W[i] - tracks[1][way].root_p_W[i]).norm());
    }
    EXPECT_GT(apart, 0.05);
  }
}

// Without boards on the feet the shins' tell: the sole is slow and low.
TEST(FootContacts, ShinsWillDo) {
  const BodyModel model = worn_boards({"pelvis", "chest", "left_thigh", "left_shin", "right_thigh", "right_shin"});
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return person.poses(t); }, model, 12.0, 100.0, BoardErrors::worn(), 5);
  const Drift held = drift(model, readings, true);
  std::printf("way %.2f m; by shins %.3f m, height %.3f m\n", held.way, held.end, held.height);
  EXPECT_LT(held.end, 0.15 * held.way);
  EXPECT_LT(held.height, 0.08);
}

// A stretch that the smoother filters again gets the same contacts.
TEST(FootContacts, SmoothingInOtherStretchesIsTheSame) {
  const BodyModel model = eight_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double t) { return person.poses(t + 1.5); }, model, 5.0, 100.0, BoardErrors::worn(), 3);
  std::vector<BodyTrack> tracks;
  for (const double stretch : {0.4, 20.0}) {
    BodyWatch watch(model, {});
    const auto run = smooth_body(model, free_root(), readings, 50.0, {}, stretch, &watch);
    ASSERT_TRUE(run.ok());
    tracks.push_back(run->track);
  }
  for (std::size_t i = 0; i < tracks[0].times.size(); ++i) {
    EXPECT_LT((tracks[0].root_p_W[i] - tracks[1].root_p_W[i]).norm(), 1e-7);
  }
}

// Somebody who stands: no velocity, in whatever mode.
TEST(FootContacts, WhoStandsStaysWhereHeIs) {
  const BodyModel model = eight_boards();
  const WalkingPerson person(model.skeleton);
  const BodyReadings readings =
      read_poses([&](double) { return person.poses(0.0); }, model, 10.0, 60.0, BoardErrors::worn(), 4);
  EXPECT_LT(drift(model, readings, false).end, 0.05);
  EXPECT_LT(drift(model, readings, true).end, 0.03);
}

TEST(FootContacts, AThingInAHandHasNoFeetAndIsToldSo) {
  BodyModel model = eight_boards();
  model.skeleton.segments.resize(1);
  model.boards.resize(1);
  const FootContacts contacts(model, {});
  EXPECT_TRUE(contacts.soles().empty());
  EXPECT_TRUE(mentions(contacts.findings(), "body.no-feet"));
}

}  // namespace
}  // namespace limbwave::estimate
