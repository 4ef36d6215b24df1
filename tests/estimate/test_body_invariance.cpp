// What must not change the result: where the room faces, the order of sensors, left and right, being cut in two, and
// coming live.
#include "estimate/body_tracker.h"
#include "support/worn_boards.h"

namespace limbwave::estimate {
namespace {

using namespace testing_support;
using Eigen::Quaterniond;

BodyModel with_ranges() {
  BodyModel model = eight_boards();
  for (BodyBoard& board : model.boards) {
    board.microphone = true;
  }
  const int pelvis = model.skeleton.find("pelvis");
  model.sources = {{"a", pelvis, {0.05, 0.08, -0.12}, -Vector3d::UnitZ()},
                   {"b", pelvis, {0.05, -0.08, -0.12}, -Vector3d::UnitZ()}};
  return model;
}

class BodyInvariance : public testing::Test {
 protected:
  void SetUp() override {
    model_ = with_ranges();
    const WalkingPerson person(model_.skeleton);
    readings_ = read_poses([&](double t) { return person.poses(t + 1.0); }, model_, 5.0, 100.0, BoardErrors::worn(), 9);
  }
  static BodyRun solve(const BodyModel& model, const BodyReadings& readings, RootMode root,
                       BodyWatch* watch = nullptr) {
    BodyFilterParameters p;
    p.root = root;
    BodyWatch own(model, {});
    Result<BodyRun> run = filter_body(model, p, readings, 1000.0, {}, watch != nullptr ? watch : &own);
    EXPECT_TRUE(run.ok());
    return *std::move(run);
  }
  // The largest angle between joints, rad, and distance of roots, m, after `map` of the first.
  static double difference(const BodyTrack& a, const BodyTrack& b, std::size_t first_segment = 1) {
    EXPECT_EQ(a.times.size(), b.times.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.times.size(), b.times.size()); ++i) {
      for (std::size_t s = first_segment; s < a.R_joint[i].size(); ++s) {
        const double angle = geometry::geodesic_angle(a.R_joint[i][s], b.R_joint[i][s]);
        largest = std::max(largest, angle);
      }
    }
    return largest;
  }
  BodyModel model_;
  BodyReadings readings_;
};

TEST_F(BodyInvariance, HeadingOfTheRoom) {
  const Quaterniond turn(Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()));
  BodyReadings turned = readings_;
  for (RootReading& root : turned.root) {
    root.R_WL = turn * root.R_WL;
    root.p_W = turn * root.p_W;
  }
  EXPECT_LT(difference(solve(model_, readings_, RootMode::kGiven).track, solve(model_, turned, RootMode::kGiven).track),
            1e-7);
  // Free: who faces elsewhere at rest goes elsewhere, with the same joints.
  BodyModel facing = model_;
  facing.skeleton.segments.front().R_PL_rest = turn * facing.skeleton.segments.front().R_PL_rest;
  const BodyTrack one = solve(model_, readings_, RootMode::kFree).track;
  const BodyTrack other = solve(facing, readings_, RootMode::kFree).track;
  EXPECT_LT(difference(one, other), 1e-6);
  const Eigen::Vector3d start = model_.skeleton.segments.front().p_PL;
  const Eigen::Vector3d way = one.root_p_W.back() - start;
  EXPECT_LT((turn * way - (other.root_p_W.back() - start)).norm(), 1e-5);
  EXPECT_GT(way.norm(), 0.3);
}

TEST_F(BodyInvariance, OrderOfTheSensors) {
  BodyModel other = model_;
  std::reverse(other.boards.begin(), other.boards.end());
  std::reverse(other.sources.begin(), other.sources.end());
  BodyReadings renamed = readings_;
  const int last = static_cast<int>(model_.boards.size()) - 1;
  for (InertialReading& r : renamed.inertial) {
    r.board = last - r.board;
  }
  for (RangeReading& r : renamed.ranges) {
    r.board = last - r.board;
    r.source = 1 - r.source;
  }
  EXPECT_LT(difference(solve(model_, readings_, RootMode::kFree).track, solve(other, renamed, RootMode::kFree).track),
            1e-6);
  // And the order in which readings of one instant come.
  BodyReadings shuffled = readings_;
  for (std::size_t i = 0; i + 8 <= shuffled.inertial.size(); i += 8) {
    std::reverse(shuffled.inertial.begin() + static_cast<std::ptrdiff_t>(i),
                 shuffled.inertial.begin() + static_cast<std::ptrdiff_t>(i + 8));
  }
  EXPECT_LT(difference(solve(model_, readings_, RootMode::kFree).track, solve(model_, shuffled, RootMode::kFree).track),
            1e-6);
}

// Everything seen in a mirror that stands along the way: y becomes −y. Rotations about an axis become rotations about
// its mirror image the other way.
TEST_F(BodyInvariance, LeftAndRightMirrored) {
  const auto point = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), -p.y(), p.z()); };
  const auto axis = [](const Eigen::Vector3d& a) { return Eigen::Vector3d(-a.x(), a.y(), -a.z()); };
  const auto rotation = [](const Quaterniond& q) { return Quaterniond(q.w(), -q.x(), q.y(), -q.z()); };
  BodyModel mirrored = model_;
  for (body::Segment& segment : mirrored.skeleton.segments) {
    segment.p_PL = point(segment.p_PL);
    segment.R_PL_rest = rotation(segment.R_PL_rest);
    for (body::Capsule& capsule : segment.capsules) {
      capsule.from_L = point(capsule.from_L);
      capsule.to_L = point(capsule.to_L);
    }
    body::Joint& joint = segment.joint;
    joint.axis = axis(joint.axis);
    joint.axis2 = axis(joint.axis2);
    if (joint.kind == body::JointKind::kSpherical) {
      for (const int i : {0, 2}) {
        std::swap(joint.minimum[i], joint.maximum[i]);
        joint.minimum[i] *= -1.0;
        joint.maximum[i] *= -1.0;
      }
    }
  }
  for (BodyBoard& board : mirrored.boards) {
    board.R_LS = rotation(board.R_LS);
    board.p_LS = point(board.p_LS);
  }
  for (BodySource& source : mirrored.sources) {
    source.p_LS = point(source.p_LS);
    source.normal_L = point(source.normal_L);
  }
  BodyReadings seen = readings_;
  for (InertialReading& r : seen.inertial) {
    r.w_S = axis(r.w_S);
    r.f_S = point(r.f_S);
  }
  const BodyTrack one = solve(model_, readings_, RootMode::kFree).track;
  BodyTrack other = solve(mirrored, seen, RootMode::kFree).track;
  for (auto& joints : other.R_joint) {
    for (Quaterniond& q : joints) {
      q = rotation(q);
    }
  }
  EXPECT_LT(difference(one, other, 0), 1e-6);
  EXPECT_LT((one.root_p_W.back() - point(other.root_p_W.back())).norm(), 1e-5);
}

// Cut anywhere, saved as text, resumed: to the last bit.
TEST_F(BodyInvariance, CutInTwoAndResumed) {
  BodyWatchParameters parameters;
  parameters.contacts.feet = true;
  // A board dies before the cut, so that there is something to remember.
  std::erase_if(readings_.inertial, [](const InertialReading& r) { return r.board == 4 && r.time_s > 2.0; });
  BodyWatch whole_watch(model_, parameters);
  const BodyRun whole = solve(model_, readings_, RootMode::kFree, &whole_watch);
  for (const double cut : {1.703, 3.0, 4.2}) {
    BodyReadings parts[2];
    for (const InertialReading& r : readings_.inertial) {
      parts[r.time_s < cut ? 0 : 1].inertial.push_back(r);
    }
    for (const RangeReading& r : readings_.ranges) {
      parts[r.time_s < cut ? 0 : 1].ranges.push_back(r);
    }
    BodyWatch first(model_, parameters);
    const BodyRun before = solve(model_, parts[0], RootMode::kFree, &first);
    ASSERT_TRUE(first.last_mind().has_value());
    Result<BodyMind> mind = mind_from_text(mind_to_text(*first.last_mind()), "state");
    ASSERT_TRUE(mind.ok()) << mind.error().text();
    BodyWatch second(model_, parameters);
    second.resume_from(*std::move(mind));
    const BodyRun after = solve(model_, parts[1], RootMode::kFree, &second);
    ASSERT_EQ(before.track.times.size() + after.track.times.size(), whole.track.times.size());
    const std::size_t offset = before.track.times.size();
    for (std::size_t i = 0; i < after.track.times.size(); ++i) {
      for (std::size_t s = 0; s < after.track.R_joint[i].size(); ++s) {
        ASSERT_EQ(after.track.R_joint[i][s].coeffs(), whole.track.R_joint[offset + i][s].coeffs())
            << cut << " " << after.track.times[i];
      }
      ASSERT_EQ(after.track.root_p_W[i], whole.track.root_p_W[offset + i]);
    }
    EXPECT_EQ(mind_to_text(*second.last_mind()), mind_to_text(*whole_watch.last_mind()));
  }
}

TEST_F(BodyInvariance, AStateOfAnotherRigIsRefused) {
  BodyWatch watch(model_, {});
  solve(model_, readings_, RootMode::kFree, &watch);
  const std::string text = mind_to_text(*watch.last_mind());
  BodyModel fewer = model_;
  fewer.boards.pop_back();
  BodyWatch other(fewer, {});
  other.resume_from(*mind_from_text(text, "state"));
  BodyReadings part = readings_;
  std::erase_if(part.inertial, [](const InertialReading& r) { return r.board == 7; });
  std::erase_if(part.ranges, [](const RangeReading& r) { return r.board == 7; });
  const auto refused = filter_body(fewer, free_root(), part, 100.0, {}, &other);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("another rig"), std::string::npos);
  for (const std::string& broken : {std::string("{}"), text.substr(0, text.size() / 2), std::string("[1]"),
                                    std::string(R"({"kind":"something"})")}) {
    EXPECT_FALSE(mind_from_text(broken, "state").ok()) << broken.substr(0, 30);
  }
}

// The stream in blocks of any size, and the filter over the whole: the same bits.
TEST_F(BodyInvariance, LiveEqualsOffline) {
  BodyWatchParameters parameters;
  parameters.contacts.feet = true;
  BodyWatch watch(model_, parameters);
  Result<BodyRun> offline = filter_body(model_, free_root(), readings_, 60.0, {}, &watch);
  ASSERT_TRUE(offline.ok());
  for (const double block : {0.007, 0.1, 2.0}) {
    BodyTracker tracker(model_, free_root(), parameters, {60.0, 0.0});
    std::vector<TrackedPose> poses;
    std::size_t i = 0;
    std::size_t r = 0;
    for (double until = block; i < readings_.inertial.size() || r < readings_.ranges.size(); until += block) {
      const std::size_t i0 = i;
      const std::size_t r0 = r;
      for (; i < readings_.inertial.size() && readings_.inertial[i].time_s < until; ++i) {
      }
      for (; r < readings_.ranges.size() && readings_.ranges[r].time_s < until; ++r) {
      }
      ASSERT_TRUE(tracker
                      .push(std::span(readings_.inertial).subspan(i0, i - i0),
                            std::span(readings_.ranges).subspan(r0, r - r0), until)
                      .ok());
      for (TrackedPose& pose : tracker.take_poses()) {
        poses.push_back(std::move(pose));
      }
    }
    ASSERT_TRUE(tracker.finish().ok());
    for (TrackedPose& pose : tracker.take_poses()) {
      poses.push_back(std::move(pose));
    }
    EXPECT_EQ(tracker.late(), 0);
    ASSERT_EQ(poses.size(), offline->track.times.size());
    for (std::size_t k = 0; k < poses.size(); ++k) {
      ASSERT_EQ(poses[k].time_s, offline->track.times[k]);
      ASSERT_EQ(poses[k].root_p_W, offline->track.root_p_W[k]);
      for (std::size_t s = 0; s < poses[k].R_joint.size(); ++s) {
        ASSERT_EQ(poses[k].R_joint[s].coeffs(), offline->track.R_joint[k][s].coeffs());
      }
    }
  }
}

// What the fixed-lag smoother gives for an instant is what the smoother gives for it when the recording ends then.
TEST_F(BodyInvariance, FixedLagIsTheSmootherOfWhatHasCome) {
  constexpr double kLag = 0.25;
  BodyTracker tracker(model_, free_root(), {}, {25.0, kLag});
  ASSERT_TRUE(tracker.push(readings_.inertial, readings_.ranges, 100.0).ok());
  ASSERT_TRUE(tracker.finish().ok());
  const std::vector<TrackedPose> poses = tracker.take_poses();
  const std::vector<TrackedPose> smoothed = tracker.take_smoothed();
  ASSERT_EQ(smoothed.size(), poses.size());
  for (const std::size_t k : {std::size_t{40}, std::size_t{75}, smoothed.size() - 1}) {
    const double end = smoothed[k].time_s + kLag - 1e-9;
    BodyReadings part;
    // The first instant that is the lag later is the last one there was.
    bool over = false;
    for (const BodyInstant& instant : instants_of(readings_)) {
      if (over) {
        break;
      }
      part.inertial.insert(part.inertial.end(), instant.inertial, instant.inertial + instant.inertials);
      part.ranges.insert(part.ranges.end(), instant.ranges, instant.ranges + instant.range_count);
      over = instant.time_s >= end;
    }
    BodyWatch watch(model_, {});
    const auto whole = smooth_body(model_, free_root(), part, 25.0, {}, 1.5, &watch);
    ASSERT_TRUE(whole.ok());
    double largest = 0.0;
    double against_filter = 0.0;
    for (std::size_t s = 0; s < smoothed[k].R_joint.size(); ++s) {
      largest = std::max(largest, geometry::geodesic_angle(smoothed[k].R_joint[s], whole->track.R_joint[k][s]));
      against_filter = std::max(against_filter, geometry::geodesic_angle(smoothed[k].R_joint[s], poses[k].R_joint[s]));
    }
    EXPECT_LT(largest, 1e-7) << k;
    if (k + 1 < smoothed.size()) {
      EXPECT_GT(against_filter, 1e-4) << k;
    }
  }
}

TEST_F(BodyInvariance, AStreamThatMayOnlyStartAtRestRefusesWhoMoves) {
  BodyWatchParameters parameters;
  parameters.rest.mode = StartMode::kRest;
  BodyReadings walking = readings_;
  std::erase_if(walking.inertial, [](const InertialReading& r) { return r.time_s < 4.0; });
  BodyTracker tracker(model_, free_root(), parameters, {60.0, 0.0});
  const Status refused = tracker.push(walking.inertial, {}, 100.0);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("moved in the first second"), std::string::npos);
  EXPECT_TRUE(tracker.take_poses().empty());
}

}  // namespace
}  // namespace limbwave::estimate
