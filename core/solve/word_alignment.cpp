#include "solve/word_alignment.h"

#include <cmath>
#include <cstdint>

namespace limbwave::solve {
namespace {

constexpr double kLongest = 1.6;    // of the usual interval, between two words that follow each other
constexpr double kClipped = 0.998;  // of the range, as the filter has it

Eigen::Vector3d between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double s, double range) {
  Eigen::Vector3d value = (1.0 - s) * a + s * b;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double end = kClipped * range;
    const bool a_clips = std::abs(a[i]) >= end;
    if (a_clips || std::abs(b[i]) >= end) {
      value[i] = a_clips ? a[i] : b[i];
    }
  }
  return value;
}

}  // namespace

WordAligner::WordAligner(const estimate::BodyModel& model, double rate_hz)
    : rate_hz_(rate_hz),
      gyroscope_range_(model.gyroscope_range),
      accelerometer_range_(model.accelerometer_range),
      last_(model.boards.size()) {
  for (estimate::InertialReading& none : last_) {
    none.board = -1;
  }
}

std::vector<estimate::InertialReading> WordAligner::push(std::span<const estimate::InertialReading> words) {
  std::vector<estimate::InertialReading> aligned;
  for (const estimate::InertialReading& word : words) {
    estimate::InertialReading& last = last_.at(static_cast<std::size_t>(word.board));
    const double interval = word.time_s - last.time_s;
    if (last.board >= 0 && interval > 0.0 && interval * rate_hz_ <= kLongest) {
      // Instants behind the last word, up to this one.
      for (auto k = static_cast<std::int64_t>(std::floor(last.time_s * rate_hz_)) + 1;
           static_cast<double>(k) / rate_hz_ <= word.time_s; ++k) {
        const double time_s = static_cast<double>(k) / rate_hz_;
        const double s = (time_s - last.time_s) / interval;
        aligned.push_back({time_s, word.board, between(last.w_S, word.w_S, s, gyroscope_range_),
                           between(last.f_S, word.f_S, s, accelerometer_range_)});
      }
    }
    last = word;
  }
  return aligned;
}

}  // namespace limbwave::solve
