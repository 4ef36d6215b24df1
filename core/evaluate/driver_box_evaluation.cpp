#include "evaluate/driver_box_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"

namespace limbwave::evaluate {
namespace {

constexpr double kClearLoss = 1.0;      // decibels
constexpr double kOccludedLoss = 12.0;  // decibels
constexpr double kClearAngle = 60.0;    // degrees
constexpr double kConfident = 0.1;
constexpr double kWrong = 0.020;  // metres

double at_fraction(std::vector<float>& sorted, double fraction) {
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(sorted.size())))];
}

}  // namespace

Result<DriverBoxTruth> load_driver_box_truth(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file.string(), std::size_t{4} << 30U);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, file.string());
  if (!json) {
    return json.error();
  }
  const Error damaged{"has no pulses and words of a driver box", file.string(),
                      "use the truth.json of a simulated take"};
  DriverBoxTruth truth;
  try {
    for (const nlohmann::json& row : json->at("pulses")) {
      DriverBoxTruth::Pulse pulse;
      pulse.emission = row.at(0).get<std::int64_t>();
      pulse.source = row.at(1).get<int>();
      for (std::size_t w = 0; w < row.at(2).size(); ++w) {
        pulse.pairs.push_back({row.at(2).at(w).get<float>(), row.at(3).at(w).get<float>(), row.at(4).at(w).get<float>(),
                               row.at(5).at(w).get<float>()});
      }
      truth.pulses.push_back(std::move(pulse));
    }
    truth.speed_of_sound = json->value("speed_of_sound_m_s", 0.0);
    if (json->contains("errors")) {
      truth.snr_db = json->at("errors").value("snr_db", truth.snr_db);
    }
    for (const nlohmann::json& board : json->at("words")) {
      auto& frames = truth.words.emplace_back();
      for (const nlohmann::json& row : board.at("frames")) {
        DriverBoxTruth::Frame frame;
        frame.start_s = row.at(0).get<double>();
        for (std::size_t c = 0; c < 6; ++c) {
          frame.held[c] = row.at(c + 1).get<int>();
        }
        frames.push_back(frame);
      }
    }
  } catch (const nlohmann::json::exception&) {
    return damaged;
  }
  return truth;
}

DriverBoxComparison::DriverBoxComparison(const DriverBoxTruth& truth, double rate_hz, double pulse_hz,
                                         double speed_of_sound, double gyroscope_range_rad_s,
                                         double accelerometer_range_m_s2)
    : truth_(truth),
      rate_hz_(rate_hz),
      wavelength_((truth.speed_of_sound > 0.0 ? truth.speed_of_sound : speed_of_sound) / pulse_hz),
      scale_(truth.speed_of_sound > 0.0 ? truth.speed_of_sound / speed_of_sound : 1.0),
      gyroscope_range_(gyroscope_range_rad_s),
      accelerometer_range_(accelerometer_range_m_s2),
      next_frame_(truth.words.size()) {}

void DriverBoxComparison::add(const decode::RangeReading& reading) {
  const auto pulse =
      std::lower_bound(truth_.pulses.begin(), truth_.pulses.end(), reading.emission.value,
                       [](const DriverBoxTruth::Pulse& p, std::int64_t emission) { return p.emission < emission; });
  if (pulse == truth_.pulses.end() || pulse->emission != reading.emission.value ||
      static_cast<std::size_t>(reading.receiver) >= pulse->pairs.size() ||
      reading.verdict == decode::RangeVerdict::kInterrupted) {
    return;
  }
  const DriverBoxTruth::Pair& pair = pulse->pairs[static_cast<std::size_t>(reading.receiver)];
  const bool clear = pair.loss_db < kClearLoss && pair.off_axis_deg <= kClearAngle;
  const bool occluded = pair.loss_db > kOccludedLoss;
  const bool accepted = reading.verdict == decode::RangeVerdict::kAccepted;
  const bool confident = reading.confidence() >= kConfident;
  ++ranges_.count;
  ranges_.accepted += accepted ? 1 : 0;
  ranges_.clear += clear ? 1 : 0;
  ranges_.clear_accepted += clear && accepted ? 1 : 0;
  ranges_.occluded += occluded ? 1 : 0;
  missed_ += occluded && confident ? 1 : 0;
  false_ += clear && !confident ? 1 : 0;
  if (accepted) {
    const double later = reading.emission_time.value - static_cast<double>(pulse->emission) / rate_hz_;
    const double error = scale_ * reading.range - (pair.range + later * pair.rate);
    errors_.push_back(static_cast<float>(error));
    if (std::abs(error) < 0.5 * wavelength_ && reading.variance > 0.0) {
      ++compared_;
      nis_ += error * error / reading.variance;
      beyond_ += error * error > 9.0 * reading.variance ? 1 : 0;
    }
  }
}

void DriverBoxComparison::add(const decode::InertialReading& reading) {
  const auto b = static_cast<std::size_t>(reading.board);
  if (b >= truth_.words.size()) {
    return;
  }
  const auto& frames = truth_.words[b];
  std::size_t& i = next_frame_[b];
  const double half = 0.5 / 140.0;
  while (i < frames.size() && frames[i].start_s < reading.time.value - half) {
    ++i;
  }
  if (!reading.valid) {
    return;
  }
  bool same = i < frames.size() && std::abs(frames[i].start_s - reading.time.value) < half;
  for (std::size_t c = 0; c < 3 && same; ++c) {
    const auto axis = static_cast<Eigen::Index>(c);
    same = std::lround(reading.w_WS_S[axis] / gyroscope_range_ * 2048.0) == frames[i].held[c] &&
           std::lround(reading.f_S[axis] / accelerometer_range_ * 2048.0) == frames[i].held[c + 3];
  }
  words_.wrong += same ? 0 : 1;
}

void DriverBoxComparison::set_counters(const std::vector<decode::InertialCounters>& counters) {
  words_.frames = words_.lost = words_.bit_errors = 0;
  words_.latest_lock_s = 0.0;
  words_.boards = counters;
  for (const decode::InertialCounters& board : counters) {
    words_.frames += board.frames;
    words_.lost += board.lost;
    words_.bit_errors += board.bit_errors;
    const bool locked = board.lock_s >= 0.0;
    words_.latest_lock_s =
        std::max(words_.latest_lock_s, locked ? board.lock_s : std::numeric_limits<double>::infinity());
  }
}

RangeStatistics DriverBoxComparison::ranges() const {
  RangeStatistics result = ranges_;
  const auto fraction = [](std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  result.missed_occlusions = fraction(missed_, ranges_.occluded);
  result.false_occlusions = fraction(false_, ranges_.clear);
  result.speed_error = 1.0 / scale_ - 1.0;
  if (errors_.empty()) {
    return result;
  }
  double sum = 0.0;
  double square = 0.0;
  std::int64_t slips = 0;
  std::int64_t wrong = 0;
  std::vector<float> sorted;
  for (const float error : errors_) {
    sum += error;
    square += static_cast<double>(error) * error;
    sorted.push_back(std::abs(error));
    slips += std::abs(error) > 0.5 * wavelength_ ? 1 : 0;
    wrong += std::abs(error) > kWrong ? 1 : 0;
  }
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(errors_.size());
  double absolute = 0.0;
  for (const float error : sorted) {
    absolute += error;
  }
  result.mean_mm = 1e3 * absolute / n;
  result.sd_mm = 1e3 * std::sqrt(std::max(0.0, square / n - (sum / n) * (sum / n)));
  result.median_mm = 1e3 * at_fraction(sorted, 0.5);
  result.p95_mm = 1e3 * at_fraction(sorted, 0.95);
  result.max_mm = 1e3 * sorted.back();
  result.slips = fraction(slips, static_cast<std::int64_t>(errors_.size()));
  result.nis = compared_ > 0 ? nis_ / static_cast<double>(compared_) : 0.0;
  result.beyond_3_sd = fraction(beyond_, compared_);
  result.wrong = fraction(wrong, static_cast<std::int64_t>(errors_.size()));
  return result;
}

nlohmann::json ranges_to_json(const RangeStatistics& r) {
  return {{"count", r.count},
          {"accepted", r.accepted},
          {"clear", r.clear},
          {"clear_accepted", r.clear_accepted},
          {"occluded", r.occluded},
          {"median_mm", r.median_mm},
          {"mean_mm", r.mean_mm},
          {"sd_mm", r.sd_mm},
          {"p95_mm", r.p95_mm},
          {"max_mm", r.max_mm},
          {"slips", r.slips},
          {"wrong", r.wrong},
          {"nis", r.nis},
          {"beyond_3_sd", r.beyond_3_sd},
          {"speed_error", r.speed_error},
          {"missed_occlusions", r.missed_occlusions},
          {"false_occlusions", r.false_occlusions}};
}

nlohmann::json words_to_json(const WordStatistics& w) {
  nlohmann::json boards = nlohmann::json::array();
  for (const decode::InertialCounters& board : w.boards) {
    boards.push_back({{"frames", board.frames},
                      {"lost", board.lost},
                      {"bit_errors", board.bit_errors},
                      {"relocks", board.relocks},
                      {"lock_s", board.lock_s >= 0.0 ? nlohmann::json(board.lock_s) : nlohmann::json()}});
  }
  return {{"frames", w.frames},
          {"lost", w.lost},
          {"bit_errors", w.bit_errors},
          {"wrong", w.wrong},
          {"latest_lock_s", std::isfinite(w.latest_lock_s) ? nlohmann::json(w.latest_lock_s) : nlohmann::json()},
          {"boards", std::move(boards)}};
}

}  // namespace limbwave::evaluate
