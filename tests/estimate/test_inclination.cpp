#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "estimate/deviation.h"
#include "estimate/inclination.h"
#include "estimate/inclination_tracker.h"
#include "estimate/synthetic_limb.h"

namespace limbwave::estimate {
namespace {

struct Errors {
  double rms_deg = 0.0, max_deg = 0.0;
  double within_2sd = 0.0;  // fraction of samples within two standard deviations (86 % for two normal axes)
};

Errors errors_of(const std::vector<Inclination>& estimates, const std::vector<Vector3d>& truth, std::size_t begin = 0) {
  Errors errors;
  double square = 0.0;
  double within = 0.0;
  for (std::size_t i = begin; i < truth.size(); ++i) {
    const double error = geometry::angle_between(estimates[i].up_L, truth[i]);
    square += error * error;
    errors.max_deg = std::max(errors.max_deg, degrees(error));
    within += error <= 2.0 * estimates[i].sd_rad ? 1.0 : 0.0;
  }
  const auto n = static_cast<double>(truth.size() - begin);
  errors.rms_deg = degrees(std::sqrt(square / n));
  errors.within_2sd = within / n;
  return errors;
}

std::vector<Inclination> tracked(const std::vector<ForceSample>& samples, Smoothing smoothing) {
  InclinationTracker tracker(smoothing);
  std::vector<Inclination> result;
  for (const ForceSample& sample : samples) {
    result.push_back(tracker.push(sample));
  }
  return result;
}

TEST(Orientation, TurnsTheMeasuredVerticalUpright) {
  for (const Vector3d& up : {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(0.3, -0.8, 0.2), Vector3d(1e-8, 0, 1),
                             Vector3d(0, 0, -1), Vector3d(1e-8, 0, -1), Vector3d(1e-3, -1e-3, -1)}) {
    for (const double heading : {0.0, 1.0, -kPi}) {
      const Quaterniond R_WL = orientation(up.normalized(), heading);
      EXPECT_LT((R_WL * up.normalized() - Vector3d::UnitZ()).norm(), 1e-9);
      const Quaterniond simplest = orientation(up.normalized());
      EXPECT_NEAR(geometry::geodesic_angle(simplest, Quaterniond::Identity()),
                  geometry::angle_between(up, Vector3d::UnitZ()), 1e-9);
      EXPECT_NEAR(geometry::geodesic_angle(R_WL, simplest), std::abs(heading), 1e-9);
    }
  }
}

TEST(Orientation, PassingStraightThroughUpsideDownDoesNotTurn) {
  const Vector3d axis = Vector3d(0.4, 0.9, 0.0).normalized();  // the limb rolls about a horizontal axis
  std::vector<Inclination> series;
  for (int i = 0; i <= 360; ++i) {
    Inclination inclination;
    inclination.up_L = Eigen::AngleAxisd(-radians(i), axis) * Vector3d::UnitZ();
    if (i == 180) {
      inclination.up_L = -Vector3d::UnitZ();
    }
    series.push_back(inclination);
  }
  const std::vector<Quaterniond> R_WL = orientations(series);
  for (std::size_t i = 1; i < R_WL.size(); ++i) {
    EXPECT_NEAR(degrees(geometry::geodesic_angle(R_WL[i - 1], R_WL[i])), 1.0, 1e-6) << i;
  }
}

TEST(Trust, FallsWithTheDeviationFromGravity) {
  EXPECT_EQ(trust_of(Vector3d(0, 0, kStandardGravity)), 1.0);
  EXPECT_EQ(trust_of(Vector3d(0, 0, kStandardGravity + 0.05)), 1.0);
  EXPECT_NEAR(trust_of(Vector3d(0, 1.098 * 0 + kStandardGravity + 0.098 + 0.98, 0)), 0.5, 1e-9);
  EXPECT_LT(trust_of(Vector3d::Zero()), 0.02);
  EXPECT_EQ(trust_of(Vector3d::Constant(std::nan(""))), 0.0);
}

TEST(NoiseFloor, SeesNoiseAndNotMotion) {
  for (const double noise : {0.0, 0.002, 0.02, 0.2}) {
    const auto series = test::felt(20.0, test::slow_turn, test::rest, noise);
    double mean = 0.0;
    for (const double one : noise_around(series.samples, 1.0)) {
      mean += one / static_cast<double>(series.samples.size());
    }
    EXPECT_NEAR(mean, std::max(noise, 1e-4), 0.05 * noise + 1e-9) << noise;
    NoiseFloor live(0.02);
    for (const ForceSample& sample : series.samples) {
      live.push(sample);
    }
    EXPECT_NEAR(live.noise(), std::max(noise, 1e-4), 0.4 * noise + 1e-9) << noise;
  }
}

// Where trust is full and noise is tiny, smoothing must get out of the way.
TEST(Inclinations, ExactSlowMotionIsNotChangedBySmoothing) {
  const auto series = test::felt(30.0, test::slow_turn, test::rest, 0.0);
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
    EXPECT_LT(errors_of(estimate_inclinations(series.samples, smoothing), series.up_L).max_deg, 0.01);
    // Live, the noise floor is learnt within the first seconds; until then a little is smoothed.
    const auto live = tracked(series.samples, smoothing);
    EXPECT_LT(errors_of(live, series.up_L).max_deg, 0.3);
    EXPECT_LT(errors_of(live, series.up_L, 300).max_deg, 0.01);
  }
}

TEST(Inclinations, StillNoiseIsReduced) {
  const auto still = [](double) { return Quaterniond(0.9, 0.3, -0.2, 0.1).normalized(); };
  for (const double noise : {0.02, 0.2}) {
    const auto series = test::felt(30.0, still, test::rest, noise);
    const double raw = errors_of(estimate_inclinations(series.samples, Smoothing::kNone), series.up_L).rms_deg;
    EXPECT_NEAR(raw, degrees(noise * std::sqrt(2.0) / kStandardGravity), 0.1 * raw);
    for (const Smoothing smoothing : {Smoothing::kAdaptive, Smoothing::kBridging}) {
      // A tenth of a degree is not worth an adaptive low pass; one degree is.
      const double bar = smoothing == Smoothing::kAdaptive && noise < 0.1 ? 1.0 : 0.8;
      EXPECT_LT(errors_of(estimate_inclinations(series.samples, smoothing), series.up_L).rms_deg, bar * raw);
      EXPECT_LT(errors_of(tracked(series.samples, smoothing), series.up_L).rms_deg, raw);
    }
  }
}

// Prints RMS and largest error, degrees, and how often the error is within two standard deviations.
std::string described(const Errors& errors) {
  return fmt::format("{:5.2f} {:5.1f} {:3.0f}%", errors.rms_deg, errors.max_deg, 100.0 * errors.within_2sd);
}

struct Burst {
  const char* name;
  std::function<Quaterniond(double)> R_WL;
  std::function<Vector3d(double)> a_W;
};

Quaterniond held(double /*t*/) {
  return Quaterniond(0.9, 0.3, -0.2, 0.1).normalized();
}

// An arm raised and lowered by 80° within 0.7 s, every 2 s.
Quaterniond raised(double t) {
  const double phase = std::fmod(t, 4.0);
  const double rise = 0.5 - 0.5 * std::cos(kPi * std::clamp((phase - 0.5) / 0.7, 0.0, 1.0));
  const double fall = 0.5 - 0.5 * std::cos(kPi * std::clamp((phase - 2.5) / 0.7, 0.0, 1.0));
  return geometry::exp_so3(Vector3d(0.0, 1.4 * (rise - fall), 0.0));
}

TEST(Inclinations, BridgesBurstsOfLimbAcceleration) {
  const auto push = [](double peak) { return [peak](double t) { return test::bursts(t, peak); }; };
  const Burst rows[] = {{"held, bursts of 2 m/s2", held, push(2.0)},
                        {"held, bursts of 8 m/s2", held, push(8.0)},
                        {"slow turning, bursts of 2 m/s2", test::slow_turn, push(2.0)},
                        {"slow turning, bursts of 5 m/s2", test::slow_turn, push(5.0)},
                        {"slow turning, bursts of 12 m/s2", test::slow_turn, push(12.0)},
                        {"arm raised fast, 0.3 m lever", raised, test::lever(raised, Vector3d(0.3, 0.0, 0.03))}};
  for (const Burst& row : rows) {
    const auto series = test::felt(60.0, row.R_WL, row.a_W, 0.02);
    std::map<Smoothing, Errors> offline;
    std::map<Smoothing, Errors> live;
    for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
      offline[smoothing] = errors_of(estimate_inclinations(series.samples, smoothing), series.up_L);
      live[smoothing] = errors_of(tracked(series.samples, smoothing), series.up_L);
    }
    fmt::print("{:32} none {} | adaptive {} live {} | bridging {} live {}\n", row.name,
               described(offline[Smoothing::kNone]), described(offline[Smoothing::kAdaptive]),
               described(live[Smoothing::kAdaptive]), described(offline[Smoothing::kBridging]),
               described(live[Smoothing::kBridging]));
    const double raw = offline[Smoothing::kNone].rms_deg;
    EXPECT_LT(offline[Smoothing::kBridging].rms_deg, 0.7 * raw) << row.name;
    EXPECT_LT(live[Smoothing::kBridging].rms_deg, raw) << row.name;
    EXPECT_LT(offline[Smoothing::kAdaptive].rms_deg, raw) << row.name;
    // Two axes are within two standard deviations in 86 % of cases if the deviation is honest and normal.
    EXPECT_GT(offline[Smoothing::kBridging].within_2sd, 0.7) << row.name;
    EXPECT_GT(offline[Smoothing::kNone].within_2sd, 0.8) << row.name;
  }
}

TEST(Inclinations, GapsAreBridgedAndLongOnesStartAnew) {
  auto series = test::felt(20.0, test::slow_turn, test::rest, 0.02);
  for (std::size_t i = 300; i < 318; ++i) {
    series.samples[i].usable = false;  // 0.3 s clipped
    series.samples[i].f_L.setConstant(std::nan(""));
  }
  auto shortened = series;
  const auto cut = [](auto& all) { all.erase(all.begin() + 600, all.begin() + 780); };  // 3 s lost
  cut(shortened.samples);
  cut(shortened.up_L);
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
    const auto offline = estimate_inclinations(shortened.samples, smoothing);
    const auto live = tracked(shortened.samples, smoothing);
    ASSERT_EQ(offline.size(), shortened.samples.size());
    for (std::size_t i = 0; i < offline.size(); ++i) {
      EXPECT_NEAR(offline[i].up_L.norm(), 1.0, 1e-9);
      EXPECT_EQ(offline[i].time_s, shortened.samples[i].time_s);
      EXPECT_EQ(live[i].time_s, shortened.samples[i].time_s);
      EXPECT_TRUE(std::isfinite(offline[i].sd_rad));
    }
    EXPECT_EQ(offline[305].trust, 0.0);
    EXPECT_LT(degrees(geometry::angle_between(offline[630].up_L, shortened.up_L[630])), 0.5);
  }
  const auto bridged = estimate_inclinations(shortened.samples, Smoothing::kBridging);
  EXPECT_LT(errors_of(bridged, shortened.up_L).max_deg, 1.0);
  EXPECT_GT(bridged[309].sd_rad, 2.0 * bridged[280].sd_rad);
}

TEST(Inclinations, NothingIsKnownBeforeTheFirstUsableSample) {
  auto series = test::felt(2.0, test::slow_turn, test::rest, 0.0);
  for (std::size_t i = 0; i < 10; ++i) {
    series.samples[i].usable = false;
  }
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kBridging}) {
    for (const auto& estimates :
         {estimate_inclinations(series.samples, smoothing), tracked(series.samples, smoothing)}) {
      EXPECT_FALSE(estimates[9].known);
      EXPECT_TRUE(estimates[10].known);
      EXPECT_LT(
          errors_of({estimates.begin() + 10, estimates.end()}, {series.up_L.begin() + 10, series.up_L.end()}).max_deg,
          0.1);
    }
  }
  EXPECT_TRUE(estimate_inclinations({}, Smoothing::kBridging).empty());
  for (ForceSample& sample : series.samples) {
    sample.usable = false;
  }
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
    EXPECT_FALSE(estimate_inclinations(series.samples, smoothing).back().known);
  }
}

TEST(Inclinations, TimesThatStandStillChangeNothing) {
  auto series = test::felt(5.0, test::slow_turn, test::rest, 0.02);
  auto doubled = series.samples;
  doubled.insert(doubled.begin() + 100, doubled[99]);
  doubled[100].f_L *= 3.0;
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
    const auto clean = estimate_inclinations(series.samples, smoothing);
    const auto with_double = estimate_inclinations(doubled, smoothing);
    ASSERT_EQ(with_double.size(), clean.size() + 1);
    EXPECT_EQ(with_double[100].up_L, clean[99].up_L);
    EXPECT_EQ(with_double.back().up_L, clean.back().up_L);
    EXPECT_EQ(tracked(doubled, smoothing).back().up_L, tracked(series.samples, smoothing).back().up_L);
  }
}

// Live state can be saved and resumed in mid-stream, and does not depend on how samples arrive.
TEST(InclinationTracker, ResumedFromACopyGoesOnBitForBit) {
  const auto series = test::felt(
      20.0, test::slow_turn, [](double t) { return test::bursts(t, 5.0); }, 0.02);
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
    const auto whole = tracked(series.samples, smoothing);
    InclinationTracker tracker(smoothing);
    for (std::size_t i = 0; i < series.samples.size(); ++i) {
      if (i % 97 == 0) {
        InclinationTracker copy(tracker);
        copy.push(series.samples[i]);
        InclinationTracker resumed(Smoothing::kNone);
        resumed = tracker;
        tracker = std::move(resumed);
      }
      const Inclination now = tracker.push(series.samples[i]);
      ASSERT_EQ(now.up_L, whole[i].up_L);
      ASSERT_EQ(now.sd_rad, whole[i].sd_rad);
    }
  }
}

// Whichever way the wearer faces, and whichever way the limb points, errors are the same.
TEST(Inclinations, DoNotDependOnHeading) {
  const Quaterniond facing(Eigen::AngleAxisd(1.1, Vector3d::UnitZ()));
  const auto burst = [](double t) { return test::bursts(t, 5.0); };
  const auto one = test::felt(10.0, test::slow_turn, burst, 0.0);
  const auto other = test::felt(
      10.0, [&](double t) { return facing * test::slow_turn(t); }, [&](double t) { return facing * burst(t); }, 0.0);
  const auto a = estimate_inclinations(one.samples, Smoothing::kBridging);
  const auto b = estimate_inclinations(other.samples, Smoothing::kBridging);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT((a[i].up_L - b[i].up_L).norm(), 1e-6);
  }
}

// A long take is smoothed in pieces; the seams must not show.
TEST(Inclinations, PiecesOfALongSeriesFitTogether) {
  const auto series = test::felt(
      100.0, test::slow_turn, [](double t) { return test::bursts(t, 5.0); }, 0.02);
  const auto whole = estimate_inclinations(series.samples, Smoothing::kBridging);
  const std::vector<ForceSample> tail(series.samples.begin() + 2500, series.samples.end());
  const auto part = estimate_inclinations(tail, Smoothing::kBridging);
  for (std::size_t i = 1200; i < part.size(); ++i) {  // the seam is at 4096; evidence fades within seconds
    EXPECT_LT(degrees(geometry::angle_between(part[i].up_L, whole[i + 2500].up_L)), 0.05) << i;
  }
}

// Errors "none", slow: the estimate stays with the readings while the limb turns over completely.
TEST(Inclinations, FollowsALimbUpsideDown) {
  const auto roll = [](double t) {
    return Quaterniond(Eigen::AngleAxisd(0.7 * t, Vector3d(1.0, 0.2, 0.0).normalized()));
  };
  const auto series = test::felt(30.0, roll, test::rest, 0.0);
  EXPECT_LT(errors_of(estimate_inclinations(series.samples, Smoothing::kBridging), series.up_L).max_deg, 0.01);
  // Started upside down by a first reading that is wrong, it rights itself.
  auto wrong = series;
  wrong.samples[0].f_L = -wrong.samples[0].f_L;
  EXPECT_LT(errors_of(tracked(wrong.samples, Smoothing::kBridging), wrong.up_L, 60).max_deg, 0.5);
}

}  // namespace
}  // namespace limbwave::estimate
