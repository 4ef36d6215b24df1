#include "take/take.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/files.h"
#include "base/units.h"
#include "simulate/simulate.h"
#include "simulate/simulation.h"

namespace limbwave::simulate {
namespace {

namespace fs = std::filesystem;

class SimulatedTake : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("limbwave-simulate-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static SimulateSettings short_settings() {
    SimulateSettings settings;
    settings.motion = "wave";
    settings.prologue = false;
    settings.seconds = 4.0;
    settings.seed = 9;
    return settings;
  }
  static nlohmann::json truth(const fs::path& take) {
    const auto text = read_file(take / "truth.json");
    EXPECT_TRUE(text);
    return nlohmann::json::parse(*text);
  }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(SimulatedTake, OpensWithRigSerialsSegmentsAndTruth) {
  SimulateSettings settings;
  settings.motion = "wave";
  settings.seconds = 5.0;
  settings.seed = 9;
  settings.errors = *load_errors("paper");
  settings.errors_name = "paper";
  const Status done = simulate_take(folder_ / "a.take", settings, {});
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(entries(), 1U);
  const auto opened = take::open_take(folder_ / "a.take");
  ASSERT_TRUE(opened) << opened.error().text();
  EXPECT_TRUE(opened->diagnostics.empty());
  EXPECT_TRUE(opened->info.complete);
  EXPECT_EQ(opened->info.rig.accelerometers[2].serial, "SIM-9-3");
  EXPECT_EQ(simulated_rig(*body::load_rig("line-in-arm"), 9).accelerometers[2].serial, "SIM-9-3") << "live as well";
  EXPECT_EQ(opened->info.skeleton.segments.size(), 5U);
  std::vector<std::string> names;
  for (const take::TakeSegment& segment : opened->info.segments) {
    names.push_back(segment.name);
    EXPECT_LE(segment.first.value + segment.count.value, opened->info.frames);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"range", "pose:Right arm:first", "pose:Right arm:second",
                                             "pose:Torso:first", "pose:Torso:second", "capture"}));
  EXPECT_EQ(opened->info.capture().count.value, 5 * 48000);
  const auto verified = take::verify_take(folder_ / "a.take");
  ASSERT_TRUE(verified);
  EXPECT_TRUE(verified->findings.empty()) << verified->findings.front().text();

  const nlohmann::json json = truth(folder_ / "a.take");
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["rate_hz"], 240);
  ASSERT_EQ(json["segments"].size(), 5U);
  const auto samples = static_cast<std::size_t>(std::ceil(static_cast<double>(opened->info.frames) / 200.0));
  for (const auto& segment : json["segments"]) {
    EXPECT_EQ(segment["q_WL"].size(), samples);
    EXPECT_EQ(segment["p_WL"].size(), samples);
    EXPECT_TRUE(segment["q_WL"][240 * 10].is_null());  // in the range calibration
    EXPECT_EQ(segment["q_WL"][samples - 1].size(), 4U);
  }
  EXPECT_EQ(json["sensors"][1]["serial"], "SIM-9-2");
  EXPECT_EQ(json["sensors"][1]["segment"], "upper_arm");
  EXPECT_EQ(json["sensors"][1]["f_S_m_s2"].size(), samples);
  EXPECT_EQ(json["errors"]["name"], "paper");
  EXPECT_DOUBLE_EQ(json["errors"]["coupling_hz"].get<double>(), 5.0);
  EXPECT_NEAR(static_cast<double>(json["cycles"]["start_s"].size()),
              static_cast<double>(opened->info.frames) / 48000.0 * 61.8, 40.0);
}

TEST_F(SimulatedTake, SlotsHoldTheVoltagesOfTheTruth) {
  // From truth.json and signal.wav alone: the mean of a slot's samples is the reading of that sensor at that time.
  SimulateSettings settings = short_settings();
  settings.format.type = acquire::SampleType::kFloat32;
  settings.errors.offset_g = 0.1;
  settings.errors.scale = 0.1;
  settings.errors.cross_axis = 0.01;
  ASSERT_TRUE(simulate_take(folder_ / "a.take", settings, {}));
  const nlohmann::json json = truth(folder_ / "a.take");
  const auto wav = read_file(folder_ / "a.take" / "signal.wav");
  ASSERT_TRUE(wav);
  const std::size_t frames = 4 * 48000;
  std::vector<float> samples(2 * frames);
  std::memcpy(samples.data(), wav->data() + (wav->size() - samples.size() * sizeof(float)), samples.size() * 4);
  const auto f_at = [&](std::size_t sensor, double t) {
    const auto& f = json["sensors"][sensor]["f_S_m_s2"];
    const double x = t * 240.0;
    const auto i = static_cast<std::size_t>(x);
    Vector3d value = Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {  // cubic through four rows
      double weight = 1.0;
      for (int j = 0; j < 4; ++j) {
        weight *= j == k ? 1.0 : (x - (static_cast<double>(i) - 1 + j)) / (k - j);
      }
      const auto& row = f[i - 1 + static_cast<std::size_t>(k)];
      value += weight * Vector3d(row[0], row[1], row[2]);
    }
    return value;
  };
  // The shipped board: 0.45 V/g about 1.65 V, and the reference 1.45 V below reaches 0.7 of full scale.
  int checked = 0;
  for (std::size_t c = 5; c + 10 < json["cycles"]["start_s"].size(); ++c) {
    const double start = json["cycles"]["start_s"][c];
    for (std::size_t slot = 0; slot < 15; ++slot) {
      const double begin = start + static_cast<double>(slot) / 960.0;
      const auto first = static_cast<std::size_t>(std::ceil(begin * 48000.0 + 0.5));
      const auto last = static_cast<std::size_t>(std::floor((begin + 1.0 / 960.0) * 48000.0 - 0.5));
      double volts = 0.0;
      for (std::size_t i = first; i <= last; ++i) {
        volts += (samples[2 * i] / 0.7 * 1.45 + 1.65) / static_cast<double>(last - first + 1);
      }
      const double t = 0.5 * static_cast<double>(first + last) / 48000.0;
      const auto& sensor = json["sensors"][slot / 3];
      const std::size_t axis = slot % 3;
      const Vector3d f_g = f_at(slot / 3, t) / kStandardGravity;
      const double reading = sensor["M"][axis][0].get<double>() * f_g.x() +
                             sensor["M"][axis][1].get<double>() * f_g.y() +
                             sensor["M"][axis][2].get<double>() * f_g.z() + sensor["offset_g"][axis].get<double>();
      ASSERT_NEAR((volts - 1.65) / 0.45, reading, 2e-5) << "cycle " << c << " slot " << slot;
      ++checked;
    }
  }
  EXPECT_GT(checked, 3000);
}

TEST_F(SimulatedTake, IsTheSameForTheSameSeed) {
  SimulateSettings settings = short_settings();
  settings.errors = *load_errors("paper");
  ASSERT_TRUE(simulate_take(folder_ / "a.take", settings, {}));
  ASSERT_TRUE(simulate_take(folder_ / "b.take", settings, {}));
  settings.seed = 10;
  ASSERT_TRUE(simulate_take(folder_ / "c.take", settings, {}));
  for (const char* file : {"signal.wav", "truth.json"}) {
    EXPECT_EQ(*read_file(folder_ / "a.take" / file), *read_file(folder_ / "b.take" / file)) << file;
    EXPECT_NE(*read_file(folder_ / "a.take" / file), *read_file(folder_ / "c.take" / file)) << file;
  }
}

TEST_F(SimulatedTake, LeavesNothingWhenCancelledOrRefused) {
  const SimulateSettings settings = short_settings();
  for (const double when : {0.0, 0.3, 0.7, 0.99, 1.0}) {
    const Status done = simulate_take(folder_ / "a.take", settings,
                                      Progress([&](double fraction, std::string_view) { return fraction < when; }));
    ASSERT_FALSE(done) << when;
    EXPECT_TRUE(is_cancelled(done.error()));
    EXPECT_EQ(entries(), 0U) << when;
  }
  SimulateSettings wrong = settings;
  wrong.motion = "somersault";
  EXPECT_FALSE(simulate_take(folder_ / "a.take", wrong, {}));
  wrong = settings;
  wrong.rig = "nothing";
  EXPECT_FALSE(simulate_take(folder_ / "a.take", wrong, {}));
  wrong = settings;
  wrong.format.channels = 1;
  EXPECT_FALSE(simulate_take(folder_ / "a.take", wrong, {}));
  wrong = settings;
  wrong.format.rate.hz = 0.0;
  EXPECT_FALSE(simulate_take(folder_ / "a.take", wrong, {}));
  EXPECT_EQ(entries(), 0U);
  fs::create_directory(folder_ / "there.take");
  EXPECT_FALSE(simulate_take(folder_ / "there.take", settings, {}));
  EXPECT_TRUE(fs::is_empty(folder_ / "there.take"));
}

TEST_F(SimulatedTake, ProgressGrowsFromZeroToOne) {
  double last = -1.0;
  ASSERT_TRUE(simulate_take(folder_ / "a.take", short_settings(), Progress([&](double fraction, std::string_view) {
                              EXPECT_GE(fraction, last - 1e-12);
                              last = fraction;
                              return true;
                            })));
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST_F(SimulatedTake, LostFramesShiftTheTruthWithTheSignal) {
  SimulateSettings settings = short_settings();
  settings.errors.drop_every_s = 1.0;
  settings.errors.drop_frames = 4800;  // 0.1 s
  ASSERT_TRUE(simulate_take(folder_ / "a.take", settings, {}));
  ASSERT_TRUE(simulate_take(folder_ / "b.take", short_settings(), {}));
  const nlohmann::json lossy = truth(folder_ / "a.take");
  const nlohmann::json whole = truth(folder_ / "b.take");
  EXPECT_EQ(lossy["segments"][3]["q_WL"][200], whole["segments"][3]["q_WL"][200]);
  EXPECT_EQ(lossy["segments"][3]["q_WL"][300], whole["segments"][3]["q_WL"][300 + 24]);
  EXPECT_EQ(lossy["segments"][3]["q_WL"][600], whole["segments"][3]["q_WL"][600 + 48]);
}

TEST_F(SimulatedTake, EveryRateAndFormatCanBeWritten) {
  for (const double rate : {44100.0, 48000.0, 88200.0, 96000.0, 176400.0, 192000.0}) {
    for (const auto type : {acquire::SampleType::kInt16, acquire::SampleType::kInt24, acquire::SampleType::kInt32,
                            acquire::SampleType::kFloat32}) {
      SimulateSettings settings = short_settings();
      settings.seconds = 0.2;
      settings.format = {SampleRate{rate}, 2, type};
      const fs::path folder = folder_ / (std::to_string(static_cast<int>(rate)) + std::string(acquire::name(type)));
      ASSERT_TRUE(simulate_take(folder, settings, {}));
      const auto opened = take::open_take(folder);
      ASSERT_TRUE(opened) << opened.error().text();
      EXPECT_EQ(opened->info.frames, std::llround(0.2 * rate));
      EXPECT_EQ(opened->info.format.type, type);
    }
  }
}

TEST(LiveSimulator, DeliversTheSameSamplesAsTheStreamInRealTime) {
  SimulateSettings settings;
  settings.motion = "walk";
  settings.prologue = false;
  settings.errors = *load_errors("electronics");
  auto opened = open_simulator(settings);
  ASSERT_TRUE(opened) << opened.error().text();
  acquire::LiveSource& source = **opened;
  EXPECT_EQ(source.newest_frame_time_s(), 0.0);
  std::vector<std::byte> live;
  std::vector<std::byte> part(4096);
  EXPECT_EQ(source.pull(part), 0U);
  const auto before = std::chrono::steady_clock::now();
  ASSERT_TRUE(source.start());
  while (live.size() < 4 * 24000) {
    const std::size_t count = source.pull(part);
    EXPECT_EQ(count % 4, 0U);
    live.insert(live.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  // Half a second of samples cannot come sooner than half a second after the start.
  EXPECT_GE(std::chrono::steady_clock::now() - before, std::chrono::milliseconds(490));
  EXPECT_GT(source.newest_frame_time_s(), 0.0);
  EXPECT_TRUE(source.alive());
  source.stop();
  const auto again = make_simulation(settings);
  ASSERT_TRUE(again);
  std::vector<std::byte> expected(live.size());
  (*again)->stream->read(expected);
  EXPECT_EQ(live, expected);
}

TEST(LiveSimulator, CountsWhatItHadToDropAndStopsAtOnce) {
  SimulateSettings settings;
  settings.motion = "wave";
  auto opened = open_simulator(settings);
  ASSERT_TRUE(opened);
  EXPECT_EQ((*opened)->counters().overflows, 0U);
  ASSERT_TRUE((*opened)->start());
  ASSERT_TRUE((*opened)->start());  // again: nothing happens
  (*opened)->stop();
  (*opened)->stop();
  ASSERT_TRUE((*opened)->start());
  opened->reset();  // the destructor stops it
  settings.motion = "nothing";
  EXPECT_FALSE(open_simulator(settings));
}

}  // namespace
}  // namespace limbwave::simulate
