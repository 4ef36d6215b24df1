/// A session and the take that it recorded: what is the same bit by bit, and how near the rest is.
#include <cmath>
#include <cstdio>

#include "base/units.h"
#include "geometry/so3.h"
#include "solve/decoded_take.h"
#include "solve/front_end.h"
#include "solve/live_pose.h"
#include "solve/live_recording.h"

namespace limbwave::solve {
namespace {

using LiveReplay = LiveRecording;

void expect_equal(const std::vector<body::SegmentPose>& a, const std::vector<body::SegmentPose>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].R_WL.coeffs(), b[i].R_WL.coeffs()) << i;
    ASSERT_EQ(a[i].p_WL, b[i].p_WL) << i;
  }
}

// A session and the take that it recorded from its first sample on, at every size of the device's blocks: frames,
// specific forces, the figure on the screen and the solved clip, bit by bit.
TEST_F(LiveReplay, TakesReplayBitForBit) {
  simulate::LineInErrors errors = require(simulate::load_errors("paper"));
  errors.drop_every_s = 3.1;  // sync is lost and found again meanwhile
  errors.drop_frames = 1234;
  SolveSettings raw;
  raw.smoothing = Smoothing::kNone;  // smoothing offline looks ahead, live it cannot
  raw.calibration = "nominal";
  simulate(errors, 8.0, 1, raw);
  for (const std::size_t block : {1U, 17U, 480U, 4096U}) {
    SCOPED_TRACE(testing::Message() << "blocks of " << block);
    if (block > 1) {
      open(block, raw);
    }
    require(session->start_recording(folder / (std::to_string(block) + ".take"), ""));
    for (double at = 0.0; at < 8.0; at += 0.77) {
      feed(at, std::min(at + 0.77, 8.0));
    }
    session->stop();
    const std::shared_ptr<const LiveSnapshot> live = session->snapshot();
    const take::Take take = require(session->stop_recording());

    // Decoding: all frames but the last, which offline need no look-ahead.
    const DecodedTake offline = require(decode_take(take, {}, {}));
    ASSERT_GT(live->frames.size(), 400U);
    ASSERT_LE(live->frames.size(), offline.frames.size());
    ASSERT_LE(offline.frames.size() - live->frames.size(), 3U);
    const calibrate::RigCalibration calibration = calibrate::nominal_calibration(signal.info.rig);
    for (std::size_t i = 0; i < live->frames.size(); ++i) {
      ASSERT_EQ(live->frames[i].time_s, offline.frames[i].time_s) << i;
      ASSERT_EQ(live->frames[i].usable, offline.frames[i].usable) << i;
      for (std::size_t s = 0; s < signal.info.rig.accelerometers.size(); ++s) {
        ASSERT_EQ(live->frames[i].volts[s], offline.frames[i].volts[s]) << i;
        ASSERT_EQ(live->specific_force[s][i], calibration.sensors[s].apply(offline.frames[i].volts[s])) << i;
      }
    }

    // Poses: the clip has what a causal solver makes of the session's frames.
    const Solve solved = require(solve_take(take, raw, {}));
    ASSERT_EQ(solved.clip.joints.front().rotation.times.size(), offline.frames.size());
    LivePose causal(signal.info.rig, signal.info.skeleton, calibration, raw);
    for (std::size_t i = 0; i < live->frames.size(); ++i) {
      causal.push(live->frames[i]);
      for (std::size_t s = 0; s < solved.clip.joints.size(); ++s) {
        const int parent = solved.clip.skeleton.segments[s].parent;
        Eigen::Quaterniond R = causal.pose()[s].R_WL;
        if (parent >= 0) {
          R = causal.pose()[static_cast<std::size_t>(parent)].R_WL.conjugate() * R;
        }
        R.normalize();
        const Eigen::Quaterniond& found = solved.clip.joints[s].rotation.values[i];
        R.coeffs() *= R.dot(found) < 0.0 ? -1.0 : 1.0;  // the same rotation
        ASSERT_EQ(R.coeffs(), found.coeffs()) << i << " " << s;
      }
    }

    // The figure: what the screen showed last is what the take gives when it is played up to there.
    FrontEnd front(take.info.rig, take.info.format.rate, {});
    LivePose replayed(take.info.rig, take.info.skeleton, *take.info.calibration, raw);
    take::TakeReader reader = require(take::TakeReader::open(take));
    std::vector<float> samples(2 * static_cast<std::size_t>(take.info.frames));
    ASSERT_EQ(require(reader.next(samples)), static_cast<std::size_t>(take.info.frames));
    front.push(samples);
    for (const decode::AccelerationFrame& frame : front.take_frames()) {
      replayed.push(frame);
    }
    const std::vector<decode::AccelerationFrame> ahead = front.frames_ahead();
    ASSERT_FALSE(ahead.empty());
    EXPECT_EQ(live->pose_time_s, ahead.back().time_s);
    expect_equal(live->pose, replayed.ahead(ahead));
    session.reset();
  }
}

// A recording out of a session that has run for a while: live has learnt the line, offline learns it from the take.
TEST_F(LiveReplay, ALaterRecordingDecodesAlike) {
  simulate(require(simulate::load_errors("electronics")), 20.0);
  feed(0.0, 11.0);
  require(session->start_recording(folder / "x.take", ""));
  feed(11.0, 20.0);
  session->stop();
  const std::vector<decode::AccelerationFrame> live = session->snapshot()->frames;
  const take::Take take = require(session->stop_recording());
  const DecodedTake offline = require(decode_take(take, {}, {}));
  const double start = signal.info.format.rate.seconds(SampleIndex{frame_at(11.0)}).value;
  const calibrate::RigCalibration calibration = calibrate::nominal_calibration(signal.info.rig);
  std::size_t compared = 0;
  std::size_t identical = 0;
  double sum = 0.0;
  double worst = 0.0;
  for (const decode::AccelerationFrame& frame : offline.frames) {
    const auto same = std::find_if(live.begin(), live.end(), [&](const decode::AccelerationFrame& other) {
      return std::abs(other.time_s - start - frame.time_s) < 1e-4;
    });
    if (same == live.end()) {
      continue;
    }
    for (std::size_t s = 0; s < signal.info.rig.accelerometers.size(); ++s) {
      const double angle = degrees(geometry::angle_between(calibration.sensors[s].apply(frame.volts[s]),
                                                           calibration.sensors[s].apply(same->volts[s])));
      ++compared;
      identical += frame.volts[s] == same->volts[s] ? 1 : 0;
      sum += angle;
      worst = std::max(worst, angle);
    }
  }
  std::printf("live against offline, begun after 11 s: %.4f° mean, %.4f° max of %zu readings, %zu bit for bit\n",
              sum / static_cast<double>(compared), worst, compared, identical);
  ASSERT_GT(compared, 2400U);
  EXPECT_LT(worst, 0.5);
  EXPECT_LT(sum / static_cast<double>(compared), 0.1);
}

}  // namespace
}  // namespace limbwave::solve
