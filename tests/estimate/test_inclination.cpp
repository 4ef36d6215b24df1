#include "estimate/inclination.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "estimate/deviation.h"
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
  for (const Vector3d& up :
       {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(0.3, -0.8, 0.2), Vector3d(1e-8, 0, 1), Vector3d(0, 0, -1),
        Vector3d(1e-8, 0, -1), Vector3d(1e-3, -1e-3, -1)}) {
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
  const auto held = [](double) { return Quaterniond(0.9, 0.3, -0.2, 0.1).normalized(); };
  for (const double noise : {0.02, 0.2}) {
    const auto series = test::felt(30.0, held, test::rest, noise);
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

TEST(Inclinations, BridgesBurstsOfLimbAcceleration) {
  struct Row {
    const char* name;
    std::function<Quaterniond(double)> R_WL;
    std::function<Vector3d(double)> a_W;
  };
  const auto held = [](double) { return Quaterniond(0.9, 0.3, -0.2, 0.1).normalized(); };
  const auto raise = [](double t) {  // an arm raised and lowered by 80° within 0.7 s, every 2 s
    const double phase = std::fmod(t, 4.0);
    const double rise = 0.5 - 0.5 * std::cos(kPi * std::clamp((phase - 0.5) / 0.7, 0.0, 1.0));
    const double fall = 0.5 - 0.5 * std::cos(kPi * std::clamp((phase - 2.5) / 0.7, 0.0, 1.0));
    return geometry::exp_so3(Vector3d(0.0, 1.4 * (rise - fall), 0.0));
  };
  const auto swing = [](double t) { return geometry::exp_so3(Vector3d(0.0, 1.2 + 0.4 * std::sin(5.5 * t), 0.0)); };
  const auto push = [](double peak) { return [peak](double t) { return test::bursts(t, peak); }; };
  const Row rows[] = {{"held, bursts of 2 m/s2", held, push(2.0)},
                      {"held, bursts of 8 m/s2", held, push(8.0)},
                      {"slow turning, bursts of 2 m/s2", test::slow_turn, push(2.0)},
                      {"slow turning, bursts of 5 m/s2", test::slow_turn, push(5.0)},
                      {"slow turning, bursts of 12 m/s2", test::slow_turn, push(12.0)},
                      {"arm raised fast, 0.3 m lever", raise, test::lever(raise, Vector3d(0.3, 0.0, 0.03))},
                      {"arm swing, 0.3 m lever", swing, test::lever(swing, Vector3d(0.3, 0.0, 0.03))}};
  for (const Row& row : rows) {
    const auto series = test::felt(60.0, row.R_WL, row.a_W, 0.02);
    std::string line = fmt::format("{:34}", row.name);
    std::vector<Errors> offline;
    for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
      offline.push_back(errors_of(estimate_inclinations(series.samples, smoothing), series.up_L));
      const Errors live = errors_of(tracked(series.samples, smoothing), series.up_L);
      line += fmt::format(" | {:5.2f} {:5.2f} {:2.0f}% live {:5.2f} {:2.0f}%", offline.back().rms_deg,
                          offline.back().max_deg, 100.0 * offline.back().within_2sd, live.rms_deg,
                          100.0 * live.within_2sd);
    }
    std::printf("%s\n", line.c_str());
  }
}

}  // namespace
}  // namespace limbwave::estimate
