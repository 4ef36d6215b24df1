// Speed of the body filter and the smoother, beside a textbook's dense filter and beside Eigen's updates of a
// covariance alone, all in one run; how the cost grows (--growth), and the memory of ten minutes (--memory).
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <fstream>

#include "estimate/body_tracker.h"
#include "support/body_runs.h"
#include "support/dense_ekf.h"

namespace {

using namespace limbwave;
using estimate::BodyFilter;
using estimate::BodyFilterParameters;

constexpr double kSeconds = 4.0;

testing_support::Wearer boxer(double seconds) {
  auto errors = simulate::load_driver_box_errors("paper");
  auto wearer = testing_support::make_wearer("box", *errors, 1, 1.0, seconds);
  return *std::move(wearer);
}

BodyFilterParameters given_root() {
  BodyFilterParameters p;
  p.root = estimate::RootMode::kGiven;
  return p;
}

void x_real_time(benchmark::State& state) {
  state.counters["x_real_time"] =
      benchmark::Counter(kSeconds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void filter(benchmark::State& state) {
  const auto wearer = boxer(kSeconds);
  const auto model = estimate::body_model(wearer.rig, wearer.skeleton);
  for (auto _ : state) {
    benchmark::DoNotOptimize(estimate::filter_body(model, given_root(), wearer.readings, 60.0, {}));
  }
  x_real_time(state);
}

void smoother(benchmark::State& state) {
  const auto wearer = boxer(kSeconds);
  const auto model = estimate::body_model(wearer.rig, wearer.skeleton);
  for (auto _ : state) {
    benchmark::DoNotOptimize(estimate::smooth_body(model, given_root(), wearer.readings, 60.0, {}));
  }
  x_real_time(state);
}

// Linearisations of some steps, taken beforehand: dense filter and Eigen's updates pay for their algebra alone.
struct Steps {
  Eigen::MatrixXd P;
  std::vector<Eigen::MatrixXd> F, Q, H;
  std::vector<Eigen::VectorXd> nu, R;
  double seconds = 0.0;
};
Steps some_steps(int count) {
  const auto wearer = boxer(1.0);
  BodyFilter filter(estimate::body_model(wearer.rig, wearer.skeleton), given_root());
  filter.start(0.0, &wearer.readings.root.front());
  Steps steps;
  steps.P = filter.covariance().dense();
  for (const auto& instant : estimate::instants_of(wearer.readings)) {
    if (instant.inertials == 0) {
      continue;
    }
    estimate::StepRecord record;
    std::vector<std::vector<estimate::MeasurementGroup>> linearised;
    record.linearised = &linearised;
    const auto root = estimate::root_at(wearer.readings.root, instant.time_s);
    filter.step(instant, &root, &record);
    if (record.predict.dt <= 0.0) {
      continue;  // the first
    }
    std::vector<estimate::MeasurementGroup> all;
    for (const auto& groups : linearised) {
      all.insert(all.end(), groups.begin(), groups.end());
    }
    testing_support::dense_process(filter, record.predict, steps.F.emplace_back(), steps.Q.emplace_back());
    testing_support::dense_rows(all, filter.layout().size, steps.H.emplace_back(), steps.nu.emplace_back(),
                                steps.R.emplace_back());
    if (static_cast<int>(steps.F.size()) == count) {
      steps.seconds = instant.time_s;
      break;
    }
  }
  return steps;
}

void dense_ekf(benchmark::State& state) {
  const Steps steps = some_steps(8);
  for (auto _ : state) {
    testing_support::DenseEkf dense;
    dense.P = steps.P;
    for (std::size_t i = 0; i < steps.F.size(); ++i) {
      dense.predict(steps.F[i], steps.Q[i]);
      dense.update(steps.H[i], steps.nu[i], steps.R[i]);
    }
    benchmark::DoNotOptimize(dense.P.data());
  }
  state.counters["x_real_time"] =
      benchmark::Counter(8.0 / 140.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void eigen_updates_alone(benchmark::State& state) {
  const Steps steps = some_steps(8);
  Eigen::MatrixXd P = steps.P;
  Eigen::MatrixXd W = Eigen::MatrixXd::Random(steps.H.back().rows(), P.rows()) * 1e-6;
  for (auto _ : state) {
    for (std::size_t i = 0; i < steps.H.size(); ++i) {
      P.selfadjointView<Eigen::Lower>().rankUpdate(W.transpose(), -1.0);
    }
    benchmark::DoNotOptimize(P.data());
  }
  state.counters["x_real_time"] =
      benchmark::Counter(8.0 / 140.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

// A tree of ball joints with sensors on it, standing still: microseconds a step.
double microseconds_a_step(int sensors, int dofs) {
  estimate::BodyModel model;
  model.skeleton.name = "tree";
  const int segments = std::max(1, (dofs + 1) / 3);
  for (int s = 0; s < segments; ++s) {
    body::Segment segment;
    segment.name = "s" + std::to_string(s);
    segment.parent = s == 0 ? -1 : (s - 1) / 2;
    segment.joint.kind = body::JointKind::kSpherical;
    segment.p_PL = {s == 0 ? 0.0 : 0.3, 0.0, 0.0};
    segment.length = 0.3;
    model.skeleton.segments.push_back(segment);
  }
  for (int b = 0; b < sensors; ++b) {
    estimate::BodyBoard board;
    board.name = std::to_string(b);
    board.segment = b % segments;
    board.p_LS = {0.15, 0.0, 0.05};
    board.gyroscope = board.accelerometer = true;
    model.boards.push_back(board);
  }
  BodyFilterParameters p;
  p.root = estimate::RootMode::kFixed;
  BodyFilter filter(model, p);
  filter.start(0.0, nullptr);
  std::vector<estimate::InertialReading> readings;
  for (int b = 0; b < sensors; ++b) {
    readings.push_back({0.0, b, {0.0, 0.0, 0.0}, {0.0, 0.0, 9.80665}});
  }
  const int steps = std::max(5, 20000 / (sensors * (dofs + 5 * sensors)));
  double best = 1e300;
  for (int round = 0; round < 3; ++round) {
    const std::clock_t begin = std::clock();
    for (int k = 0; k < steps; ++k) {
      const estimate::BodyInstant instant{filter.state().time_s + 1.0 / 140.0, readings.data(), readings.size(),
                                          nullptr, 0};
      filter.step(instant, nullptr);
    }
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / steps * 1e6);
  }
  return best;
}

void print_growth() {
  const int sensors[] = {5, 10, 18, 36, 72};
  const int dofs[] = {10, 20, 40, 80, 160};
  fmt::print("\nmicroseconds a step, by sensors (down) and degrees of freedom (across)\n        ");
  for (const int d : dofs) {
    fmt::print("{:>9}", d);
  }
  // log t = a + b log(sensors) + c log(dofs), least squares.
  Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
  Eigen::Vector3d y = Eigen::Vector3d::Zero();
  for (const int s : sensors) {
    fmt::print("\n{:>8}", s);
    for (const int d : dofs) {
      const double t = microseconds_a_step(s, d);
      fmt::print("{:9.0f}", t);
      std::fflush(stdout);
      const Eigen::Vector3d row(1.0, std::log(s), std::log(d));
      N += row * row.transpose();
      y += row * std::log(t);
    }
  }
  const Eigen::Vector3d fit = N.inverse() * y;
  fmt::print("\nfitted: cost ~ sensors^{:.2f} x dofs^{:.2f}\n", fit[1], fit[2]);
}

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) {
      return std::atof(line.c_str() + 6) / 1024.0;
    }
  }
  return 0.0;
}

// The filter over so many minutes of readings that come a second at a time, as they do live, and are gone behind it.
void print_memory_of_filter(double minutes) {
  const auto wearer = boxer(20.0);
  const auto model = estimate::body_model(wearer.rig, wearer.skeleton);
  // What he does in twenty seconds again and again: only the times move on. It jumps where it begins anew, which costs
  // no memory.
  const double lap = wearer.readings.inertial.back().time_s + 1.0 / 140.0;
  estimate::BodyTracker tracker(model, given_root(), {}, {});
  std::size_t poses = 0;
  fmt::print("{:.0f} MB at the peak before it starts\n", peak_megabytes());
  for (double begin = 0.0; begin < 60.0 * minutes; begin += lap) {
    estimate::BodyReadings part = wearer.readings;
    for (auto& r : part.inertial) {
      r.time_s += begin;
    }
    for (auto& r : part.ranges) {
      r.time_s += begin;
    }
    for (auto& r : part.root) {
      r.time_s += begin;
    }
    tracker.set_root(part.root);
    std::size_t i = 0;
    std::size_t k = 0;
    for (double second = 1.0; second < lap + 1.0; second += 1.0) {
      const std::size_t from_i = i;
      const std::size_t from_k = k;
      while (i < part.inertial.size() && part.inertial[i].time_s < begin + second) {
        ++i;
      }
      while (k < part.ranges.size() && part.ranges[k].time_s < begin + second) {
        ++k;
      }
      const Status status = tracker.push({part.inertial.data() + from_i, i - from_i},
                                         {part.ranges.data() + from_k, k - from_k}, begin + std::min(second, lap));
      if (!status) {
        fmt::print(stderr, "{}\n", status.error().text());
        return;
      }
      poses += tracker.take_poses().size();
    }
  }
  fmt::print("filter, {} minutes that stream: {:.0f} MB at the peak; {} poses\n", minutes, peak_megabytes(), poses);
}

// The smoother over so many minutes; what the readings take is included.
void print_memory_of_smoother(double minutes) {
  const auto wearer = boxer(60.0 * minutes);
  const auto model = estimate::body_model(wearer.rig, wearer.skeleton);
  fmt::print("{} minutes of readings: {:.0f} MB at the peak\n", minutes, peak_megabytes());
  const auto run = estimate::smooth_body(model, given_root(), wearer.readings, 60.0, {});
  fmt::print("smoother: {:.0f} MB at the peak, readings included; {} poses\n", peak_megabytes(),
             run->track.times.size());
}

}  // namespace

BENCHMARK(filter)->Unit(benchmark::kMillisecond);
BENCHMARK(smoother)->Unit(benchmark::kMillisecond);
BENCHMARK(dense_ekf)->Unit(benchmark::kMillisecond);
BENCHMARK(eigen_updates_alone)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "--memory") == 0) {
    const double minutes = std::atof(argv[3]);
    std::strcmp(argv[2], "smoother") == 0 ? print_memory_of_smoother(minutes) : print_memory_of_filter(minutes);
    return 0;
  }
  if (argc == 2 && std::strcmp(argv[1], "--growth") == 0) {
    print_growth();
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
