/// Inclination from a real accelerometer alone, reduced to the 60 Hz of the line-in board, against optical truth.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "estimate/inclination.h"
#include "estimate/inclination_tracker.h"
#include "estimate/synthetic_limb.h"

namespace limbwave::estimate {
namespace {

namespace fs = std::filesystem;

struct Recording {
  std::vector<ForceSample> samples;
  std::vector<Vector3d> up_L;  // zero where it does not count
};

std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  gzFile stream = gzopen(file.c_str(), "rb");
  if (stream == nullptr) {
    return lines;
  }
  char buffer[1024];
  while (gzgets(stream, buffer, sizeof buffer) != nullptr) {
    lines.emplace_back(buffer);
  }
  gzclose(stream);
  return lines;
}

Recording read_recording(const fs::path& file) {
  Recording recording;
  int next = 0;
  for (const std::string& line : lines_of(file)) {
    std::vector<double> cells;
    std::size_t begin = 0;
    while (begin <= line.size()) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      const std::string cell = line.substr(begin, end - begin);
      cells.push_back(cell.empty() ? std::nan("") : std::strtod(cell.c_str(), nullptr));
      begin = end + 1;
    }
    if (cells.size() != 12 || line[0] == 't' || cells[0] < next / 60.0) {
      continue;  // the first reading at or after every sixtieth of a second
    }
    next = static_cast<int>(cells[0] * 60.0) + 1;
    recording.samples.push_back({cells[0], {cells[4], cells[5], cells[6]}, true});
    const Quaterniond R_WS(cells[7], cells[8], cells[9], cells[10]);
    const bool counts = cells[11] > 0.5 && std::isfinite(cells[7]);
    recording.up_L.emplace_back(counts ? Vector3d(R_WS.normalized().conjugate() * Vector3d::UnitZ())
                                       : Vector3d(Vector3d::Zero()));
  }
  return recording;
}

double rms_deg(const std::vector<Inclination>& estimates, const Recording& recording) {
  double square = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    if (recording.up_L[i].norm() > 0.5) {
      square += std::pow(geometry::angle_between(estimates[i].up_L, recording.up_L[i]), 2);
      ++count;
    }
  }
  return degrees(std::sqrt(square / count));
}

// Eight sensors on a walking person, 100 Hz, with lost packets; truth is the maker's own fusion with gyroscopes.
Recording read_walk(const fs::path& file) {
  Recording recording;
  int next = 0;
  double first = -1.0;
  for (const std::string& line : lines_of(file)) {
    std::vector<double> cells;
    std::size_t begin = 0;
    while (begin <= line.size()) {
      const std::size_t end = std::min(line.find('\t', begin), line.size());
      cells.push_back(std::strtod(line.substr(begin, end - begin).c_str(), nullptr));
      begin = end + 1;
    }
    if (cells.size() < 26 || line[0] == 'P') {
      continue;
    }
    first = first < 0.0 ? cells[0] : first;
    const double time_s = std::fmod(cells[0] - first + 65536.0, 65536.0) / 100.0;
    if (time_s < next / 60.0) {
      continue;
    }
    next = static_cast<int>(time_s * 60.0) + 1;
    recording.samples.push_back({time_s, {cells[14], cells[15], cells[16]}, true});
    recording.up_L.emplace_back(cells[19], cells[22], cells[25]);
  }
  return recording;
}

struct Comparison {
  std::map<Smoothing, double> offline, live;  // RMS, degrees
};

Comparison compared(const Recording& recording) {
  Comparison comparison;
  for (const Smoothing smoothing : {Smoothing::kNone, Smoothing::kAdaptive, Smoothing::kBridging}) {
    comparison.offline[smoothing] = rms_deg(estimate_inclinations(recording.samples, smoothing), recording);
    InclinationTracker tracker(smoothing);
    std::vector<Inclination> estimates;
    for (const ForceSample& sample : recording.samples) {
      estimates.push_back(tracker.push(sample));
    }
    comparison.live[smoothing] = rms_deg(estimates, recording);
  }
  return comparison;
}

class RealAccelerations : public ::testing::TestWithParam<const char*> {};

TEST_P(RealAccelerations, BridgingBringsInclinationNearerToTheTruth) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  const fs::path folder = fs::path(data != nullptr ? data : "") / "inertial" / GetParam();
  if (!fs::exists(folder)) {
    GTEST_SKIP() << "LIMBWAVE_DATA does not name a folder with recordings";
  }
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool broad = name.rfind("broad-", 0) == 0;
    if (!broad && name.rfind("MT_", 0) != 0) {
      continue;
    }
    ++files;
    const Recording recording = broad ? read_recording(entry.path()) : read_walk(entry.path());
    ASSERT_GT(recording.samples.size(), 1000U) << name;
    Comparison result = compared(recording);
    fmt::print("{:34} RMS deg: none {:5.2f}, adaptive {:5.2f} (live {:5.2f}), bridging {:5.2f} (live {:5.2f})\n", name,
               result.offline[Smoothing::kNone], result.offline[Smoothing::kAdaptive],
               result.live[Smoothing::kAdaptive], result.offline[Smoothing::kBridging],
               result.live[Smoothing::kBridging]);
    EXPECT_LT(result.offline[Smoothing::kBridging], result.offline[Smoothing::kNone]) << name;
  }
  EXPECT_GT(files, 0);
}

INSTANTIATE_TEST_SUITE_P(Folders, RealAccelerations, ::testing::Values("", "xsens-walk"));

}  // namespace
}  // namespace limbwave::estimate
