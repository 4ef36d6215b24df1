/// Ranges and inertial words of a simulated take against its truth.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/result.h"
#include "decode/inertial_reading.h"
#include "decode/range_reading.h"

namespace limbwave::evaluate {

/// The parts "pulses" and "words" of truth.json, as the simulator writes them.
struct DriverBoxTruth {
  struct Pair {
    float range = 0, rate = 0, loss_db = 0, off_axis_deg = 0;
  };
  struct Pulse {
    std::int64_t emission = 0;
    int source = 0;
    std::vector<Pair> pairs;  ///< By wire.
  };
  struct Frame {
    double start_s = 0;
    int held[6] = {};  ///< What a receiver then holds.
  };
  std::vector<Pulse> pulses;
  std::vector<std::vector<Frame>> words;  ///< By board.
  double speed_of_sound = 0.0;            ///< As it was, m/s; 0: not told.
  double snr_db = 300.0;                  ///< In-band peak SNR on a source's axis at 0.6 m; 300: no noise.
};

Result<DriverBoxTruth> load_driver_box_truth(const std::filesystem::path& file);

/// A pair is clear when limbs take less than 1 dB of the straight way and the microphone is at most 60° off the
/// source's normal, occluded when they take more than 12 dB; what is between is neither. Errors are of accepted ranges,
/// as times of flight at the speed of sound as it was: what a wrong thermometer adds is in `speed_error` alone. Mean is
/// that of absolute errors, sd the standard deviation of signed ones, p95 and median of absolute ones.
struct RangeStatistics {
  std::int64_t count = 0, accepted = 0;
  std::int64_t clear = 0, clear_accepted = 0, occluded = 0;
  double median_mm = 0, mean_mm = 0, sd_mm = 0, p95_mm = 0, max_mm = 0;
  double nis = 0;                ///< Mean of squared errors over the variances that were told, below half a wavelength.
  double beyond_3_sd = 0;        ///< Fraction of these beyond three standard deviations; 2.7e-3 of a normal error.
  double speed_error = 0;        ///< Relative, of the speed of sound that decoding was told.
  double slips = 0;              ///< Fraction of accepted ranges off by more than half a wavelength.
  double wrong = 0;              ///< Fraction of accepted ranges off by more than 20 mm.
  double missed_occlusions = 0;  ///< Fraction of occluded pairs with a confidence of 0.1 or more.
  double false_occlusions = 0;   ///< Fraction of clear pairs with less.
};

struct WordStatistics {
  std::int64_t frames = 0;      ///< Since lock, of all boards.
  std::int64_t lost = 0;        ///< Of these.
  std::int64_t bit_errors = 0;  ///< Corrected.
  std::int64_t wrong = 0;       ///< Valid readings that differ from what was sent.
  double latest_lock_s =
      0;  ///< Longest time until a board's words were locked on; of boards that never were, infinite.
  std::vector<decode::InertialCounters> boards;  ///< Counts of every board.
};

/// Takes readings as they come.
class DriverBoxComparison {
 public:
  /// `speed_of_sound`: what decoding used, m/s; `pulse_hz`: the carrier.
  DriverBoxComparison(const DriverBoxTruth& truth, double rate_hz, double pulse_hz, double speed_of_sound,
                      double gyroscope_range_rad_s, double accelerometer_range_m_s2);
  void add(const decode::RangeReading& reading);
  void add(const decode::InertialReading& reading);
  void set_counters(const std::vector<decode::InertialCounters>& counters);
  [[nodiscard]] RangeStatistics ranges() const;
  [[nodiscard]] const WordStatistics& words() const { return words_; }

 private:
  const DriverBoxTruth& truth_;
  double rate_hz_, wavelength_, scale_, gyroscope_range_, accelerometer_range_;
  RangeStatistics ranges_;
  WordStatistics words_;
  std::int64_t missed_ = 0, false_ = 0;
  std::vector<float> errors_;  // metres, of accepted ranges
  double nis_ = 0.0;
  std::int64_t compared_ = 0, beyond_ = 0;
  std::vector<std::size_t> next_frame_;
};

nlohmann::json ranges_to_json(const RangeStatistics& ranges);
nlohmann::json words_to_json(const WordStatistics& words);

}  // namespace limbwave::evaluate
