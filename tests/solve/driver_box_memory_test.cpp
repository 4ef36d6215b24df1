// A long take of a driver box opens at once and is decoded in memory that does not grow with it. LIMBWAVE_TAKE_MINUTES
// makes it longer: an hour is 18 GB on the disk.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>

#include "simulate/driver_box_stream.h"
#include "solve/driver_box.h"
#include "support/temporary_folder.h"
#include "take/recorder.h"
#include "take/take_reader.h"

namespace limbwave::solve {
namespace {

// Highest resident memory so far, megabytes.
double high_water() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

struct Loop {
  body::Rig rig;
  body::Skeleton skeleton;
  calibrate::RangingCalibration ranging;
  std::vector<std::int16_t> samples;  // a few seconds, whole rounds
};

Loop make_loop() {
  Loop loop;
  loop.rig = *body::load_rig("driver-box-body");
  loop.skeleton = *body::load_skeleton(loop.rig.skeleton);
  const auto errors = simulate::load_driver_box_errors("calibrated");
  const auto actor = simulate::DriverBoxActor::create("walk", 0.0, loop.rig, loop.skeleton, *errors, 1);
  simulate::DriverBoxStream stream(loop.rig, *actor, *errors, 22.0, 1);
  loop.ranging = simulate::simulated_calibration(loop.rig, stream, *errors, 1);
  std::vector<std::int16_t> slot(static_cast<std::size_t>(stream.slot_samples() * stream.wires()));
  for (int s = 0; s < 8 * 78; ++s) {  // five seconds
    stream.next_slot(slot);
    loop.samples.insert(loop.samples.end(), slot.begin(), slot.end());
  }
  return loop;
}

void write_take(const std::filesystem::path& folder, const Loop& loop, double seconds) {
  take::TakeInfo info;
  info.kind = "driver-box";
  info.format = {SampleRate{140000.0}, 18, acquire::SampleType::kInt16};
  info.rig = loop.rig;
  info.skeleton = loop.skeleton;
  info.ranging = loop.ranging;
  auto recorder = take::Recorder::create(folder, info);
  ASSERT_TRUE(recorder.ok()) << recorder.error().text();
  while ((*recorder)->seconds() < seconds) {
    ASSERT_TRUE((*recorder)->write(std::as_bytes(std::span(loop.samples))).ok());
  }
  ASSERT_TRUE((*recorder)->close().ok());
}

std::size_t decode(const std::filesystem::path& folder, double& opened_s) {
  const auto begin = std::chrono::steady_clock::now();
  const auto take = take::open_take(folder);
  EXPECT_TRUE(take.ok());
  opened_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::size_t readings = 0;
  const auto report = decode_driver_box(
      *take, {},
      [&](std::span<const decode::RangeReading> ranges, std::span<const decode::InertialReading> inertial) -> Status {
        readings += ranges.size() + inertial.size();
        return {};
      },
      {});
  EXPECT_TRUE(report.ok());
  return readings;
}

TEST(DriverBoxMemory, DoesNotGrowWithTheTake) {
  const char* minutes = std::getenv("LIMBWAVE_TAKE_MINUTES");
  const double seconds = minutes != nullptr ? 60.0 * std::atof(minutes) : 40.0;
  const test::TemporaryFolder folder;
  const Loop loop = make_loop();
  write_take(folder.path() / "short.take", loop, 10.0);
  double opened = 0.0;
  EXPECT_GT(decode(folder.path() / "short.take", opened), 10U * 18U * 250U);
  const double before = high_water();
  write_take(folder.path() / "long.take", loop, seconds);
  EXPECT_GT(decode(folder.path() / "long.take", opened), static_cast<std::size_t>(seconds) * 18U * 250U);
  const double after = high_water();
  std::printf("%.0f s: opened in %.0f ms; %.0f MB at most, %.0f MB for ten seconds\n", seconds, 1e3 * opened, after,
              before);
  EXPECT_LT(after, 500.0);
  EXPECT_LT(after, before + 32.0);
}

}  // namespace
}  // namespace limbwave::solve
