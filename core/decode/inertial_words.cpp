#include "decode/inertial_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "acquire/inertial_word_format.h"
#include "base/units.h"
#include "decode/inertial_frame.h"
#include "signal/fir_design.h"

namespace limbwave::decode {
namespace {

using acquire::kScramblingFrames;
using acquire::kWordBits;
using acquire::kWordChannels;

constexpr double kCutoffBits = 0.6;    // low pass, as a fraction of the bit rate
constexpr double kStopBits = 1.25;     // nothing of the carrier beyond
constexpr double kAttenuation = 65.0;  // decibels; pulses are up to 30 dB stronger than words
constexpr int kAcquireBits = 128;      // from which the phase of the clock is taken
constexpr int kPhases = 16;            // tried then
constexpr int kMostErrors = 10;        // of two frames, for a lock
constexpr int kLostFrames = 12;        // in a row, then the lock is
// Of 10 bits, four of which are summed up: one of them at its end is enough.
constexpr int kEndSteps = 4;         // of 2048, from the end of a range
constexpr double kPhaseGain = 0.03;  // of the timing loop, per transition
constexpr double kRateGain = 2.5e-4;
constexpr double kAhead = 6.0;  // values that must be there beyond a bit's middle
// Slope of a bit's edge after the low pass, amplitudes per bit.
constexpr double kEdgeSlope = 3.0;

}  // namespace

struct InertialWordDecoder::Impl {
  Impl(const WordFormat& word_format, SampleRate sample_rate, int board_index)
      : format(word_format), rate(sample_rate), board(board_index) {
    const double bit_rate = format.word_rate_hz * kWordBits;
    // At least two and a half values a bit are left.
    step = std::max(1, static_cast<int>(std::floor(rate.hz / (2.5 * bit_rate))));
    const double transition = (kStopBits - kCutoffBits) * bit_rate / rate.hz;
    std::size_t length = signal::kaiser_taps(transition, kAttenuation) | 1U;
    const std::vector<double> h =
        signal::low_pass(length, 0.5 * (kCutoffBits + kStopBits) * bit_rate / rate.hz, kAttenuation);
    delay = 0.5 * static_cast<double>(length - 1);
    length = (length + signal::kDotMultiple - 1) / signal::kDotMultiple * signal::kDotMultiple;
    taps.assign(length, 0.0F);
    std::copy(h.begin(), h.end(), taps.begin());
    input.assign(length - 1, 0.0F);
    nominal_period = rate.hz / bit_rate / step;
    period = nominal_period;
  }

  WordFormat format;
  SampleRate rate;
  int board;
  int step = 4;
  double delay = 0.0;
  std::vector<float> taps;
  std::vector<float> input;    // the last samples, then new ones
  std::int64_t input_end = 0;  // index of the sample after the last one
  std::vector<float> values;   // after the low pass; values[i] has number values_start + i
  std::int64_t values_start = 0;
  std::int64_t next_value = 0;  // value n belongs to sample n · step − delay
  double nominal_period;
  double period;          // of a bit, in values
  double next_bit = 0.0;  // middle of the next bit, as a number of values
  double before = 0.0;    // the last bit's value
  double before_middle = 0.0;
  double amplitude = 0.0;
  bool timed = false;
  bool locked = false;
  int pattern = 0;                 // of the frame being collected
  std::vector<std::uint8_t> bits;  // while searching: all since the clock was found; else of the present frame
  std::vector<double> bit_middles;
  std::vector<std::uint8_t> bit_missing;
  std::vector<std::pair<double, double>> missing;  // stretches of values that were not heard
  std::array<int, kWordChannels> held{};
  std::uint8_t known = 0;
  int lost_in_row = 0;
  std::int64_t number = 0;
  double timing_square = 0.0;
  double expected_start = -1.0;  // of the frame after the last one, while the lock is being found again
  std::vector<InertialReading> readings;
  WordStatus status;

  [[nodiscard]] double seconds_of(double value_number) const { return (value_number * step - delay) / rate.hz; }

  [[nodiscard]] double value_at(double place) const {
    const auto whole = static_cast<std::int64_t>(place);  // never before the first value
    const double u = place - static_cast<double>(whole);
    const std::int64_t at = whole - values_start;
    if (at < 1 || at + 2 >= static_cast<std::int64_t>(values.size())) {
      return 0.0;
    }
    const float* v = values.data() + at;
    // Lagrange, third order.
    const double a = v[-1];
    const double b = v[0];
    const double c = v[1];
    const double d = v[2];
    constexpr double kSixth = 1.0 / 6.0;
    const double c1 = c - 2.0 * kSixth * a - 0.5 * b - kSixth * d;
    const double c2 = 0.5 * (a + c) - b;
    const double c3 = kSixth * (d - a) + 0.5 * (b - c);
    return b + u * (c1 + u * (c2 + u * c3));
  }

  void filter() {
    const std::size_t length = taps.size();
    const std::int64_t first = input_end - static_cast<std::int64_t>(input.size());
    // Value n takes the samples n·step − length + 1 ... n·step. The filter is symmetric but for zeros at its end, so
    // that reversed taps start later by what was padded.
    while (next_value * step < input_end) {
      const std::int64_t newest = next_value * step;
      const std::int64_t oldest = newest - static_cast<std::int64_t>(length) + 1;
      values.push_back(signal::dot(input.data() + (oldest - first), reversed.data(), length));
      ++next_value;
    }
    const std::size_t keep = length - 1 + static_cast<std::size_t>(step);
    if (input.size() > keep) {
      input.erase(input.begin(), input.end() - static_cast<std::ptrdiff_t>(keep));
    }
  }
  std::vector<float> reversed;

  [[nodiscard]] bool is_missing(double place) const {
    return std::any_of(missing.begin(), missing.end(),
                       [&](const auto& gap) { return place >= gap.first && place <= gap.second; });
  }

  [[nodiscard]] double available() const {
    return static_cast<double>(values_start + static_cast<std::int64_t>(values.size())) - 3.0;
  }

  // The phase at which the line is furthest from zero on average.
  bool find_phase() {
    const double start = std::max(next_bit, static_cast<double>(values_start) + 2.0);
    if (available() < start + (kAcquireBits + 2) * period) {
      return false;
    }
    double best = -1.0;
    double phase = 0.0;
    std::array<double, kPhases> levels{};
    for (int p = 0; p < kPhases; ++p) {
      double level = 0.0;
      for (int b = 0; b < kAcquireBits; ++b) {
        level += std::abs(value_at(start + (b + static_cast<double>(p) / kPhases) * period));
      }
      levels[static_cast<std::size_t>(p)] = level;
      if (level > best) {
        best = level;
        phase = p;
      }
    }
    // Between the neighbours by a parabola.
    const auto i = static_cast<std::size_t>(phase);
    const double left = levels[(i + kPhases - 1) % kPhases];
    const double right = levels[(i + 1) % kPhases];
    const double curvature = left - 2.0 * best + right;
    phase += curvature < 0.0 ? std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5) : 0.0;
    next_bit = start + phase / kPhases * period;
    amplitude = best / kAcquireBits;
    before = 0.0;
    before_middle = next_bit - period;
    timed = true;
    bits.clear();
    bit_middles.clear();
    bit_missing.clear();
    return true;
  }

  void one_bit() {
    const double value = value_at(next_bit);
    const bool gone = !missing.empty() && is_missing(next_bit);
    const double between = 0.5 * (before_middle + next_bit);
    double correction = 0.0;
    if (!gone && amplitude > 1e-9) {
      amplitude += 0.01 * (std::abs(value) - amplitude);
      if ((value > 0.0) != (before > 0.0) && before != 0.0) {
        // At a change of sign the middle between two bits is zero: late when it has the sign of the newer bit.
        const double middle = value_at(between);
        const double late = std::clamp((value > 0.0 ? middle : -middle) / (kEdgeSlope * amplitude), -0.25, 0.25);
        correction = -kPhaseGain * late * period;
        period -= kRateGain * late * period;
        const double limit = nominal_period * 1.5 * format.clock_tolerance;
        period = std::clamp(period, nominal_period - limit, nominal_period + limit);
        timing_square += 0.002 * (late * late - timing_square);
      }
    }
    bits.push_back(value > 0.0 ? 1 : 0);
    bit_middles.push_back(next_bit);
    bit_missing.push_back(gone ? 1 : 0);
    before = gone ? 0.0 : value;
    before_middle = next_bit;
    next_bit += period + correction;
  }

  void emit(const DecodedFrame& frame, bool good, double first_middle) {
    InertialReading reading;
    reading.board = board;
    reading.number = number++;
    reading.time = Seconds{seconds_of(first_middle - 0.5 * period)};
    ++status.counters.frames;
    if (good) {
      lost_in_row = 0;
      for (std::size_t c = 0; c < kWordChannels; ++c) {
        const int code = take_bits(frame.payload, 6 * c, 6);
        const int move = acquire::kDeltaSteps[static_cast<std::size_t>(std::abs(code))];
        held[c] = std::clamp(held[c] + (code < 0 ? -move : move), -acquire::kReadingLimit, acquire::kReadingLimit - 1);
      }
      const auto refreshed = static_cast<std::size_t>(pattern % kWordChannels);
      held[refreshed] = take_bits(frame.payload, 36, 12);
      known = static_cast<std::uint8_t>(known | (1U << refreshed));
      status.counters.bit_errors += frame.errors;
      reading.bit_errors = frame.errors;
      reading.valid_channels = known;
      reading.valid = known == 0x3F;
    } else {
      ++lost_in_row;
      ++status.counters.lost;
      known = 0;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const auto axis = static_cast<Eigen::Index>(c);
      reading.w_WS_S[axis] = held[c] * format.gyroscope_range_rad_s / acquire::kReadingLimit;
      reading.f_S[axis] = held[c + 3] * format.accelerometer_range_m_s2 / acquire::kReadingLimit;
    }
    reading.saturated = std::any_of(held.begin(), held.end(), [](int value) {
      return value <= -acquire::kReadingLimit + kEndSteps || value >= acquire::kReadingLimit - 1 - kEndSteps;
    });
    readings.push_back(reading);
    pattern = (pattern + 1) % kScramblingFrames;
  }

  void drop_bits(std::size_t count) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    bits.erase(bits.begin(), bits.begin() + n);
    bit_middles.erase(bit_middles.begin(), bit_middles.begin() + n);
    bit_missing.erase(bit_missing.begin(), bit_missing.begin() + n);
  }

  // Two frames in a row that are Golay words to within a few bits, at any of six places of the scrambling.
  void search() {
    while (!locked && bits.size() >= 2 * kWordBits) {
      for (int m = 0; m < kScramblingFrames && !locked; ++m) {
        const DecodedFrame one = decode_frame(bits.data(), m);
        if (one.errors > kMostErrors) {
          continue;
        }
        const DecodedFrame two = decode_frame(bits.data() + kWordBits, (m + 1) % kScramblingFrames);
        if (one.errors + two.errors <= kMostErrors) {
          locked = true;
          pattern = m;
          count_missed(bit_middles.front());
          if (status.counters.lock_s < 0.0) {
            status.counters.lock_s = (next_bit + kAhead) * step / rate.hz;
          }
        }
      }
      if (!locked) {
        drop_bits(1);
        if (++searched > kWordBits + kWordBits / 4) {  // the clock was found in noise: once more
          timed = false;
          searched = 0;
          return;
        }
      }
    }
    searched = locked ? 0 : searched;
  }
  int searched = 0;

  // Frames that passed while the lock was lost are lost frames.
  void count_missed(double first_middle) {
    if (expected_start < 0.0) {
      return;
    }
    const double frames = (first_middle - 0.5 * period - expected_start) / (nominal_period * kWordBits);
    const auto missed = static_cast<std::int64_t>(std::llround(frames));
    if (missed > 0) {
      number += missed;
      status.counters.frames += missed;
      status.counters.lost += missed;
    }
    expected_start = -1.0;
  }

  void frames() {
    while (locked && bits.size() >= kWordBits) {
      const DecodedFrame frame = decode_frame(bits.data(), pattern);
      const bool whole =
          std::none_of(bit_missing.begin(), bit_missing.begin() + kWordBits, [](auto gone) { return gone != 0; });
      emit(frame, whole && frame.good, bit_middles.front());
      drop_bits(kWordBits);
      if (lost_in_row >= kLostFrames && whole) {
        locked = false;
        timed = false;
        known = 0;
        ++status.counters.relocks;
        expected_start = next_bit - 0.5 * period - static_cast<double>(bits.size()) * period;
        bits.clear();
        bit_middles.clear();
        bit_missing.clear();
        period = nominal_period;
      }
    }
  }

  void advance() {
    while (true) {
      if (!timed && !find_phase()) {
        break;
      }
      if (available() < next_bit + 0.5 * period + 2.0) {
        break;
      }
      one_bit();
      if (!locked) {
        search();
      }
      frames();
    }
    // What lies behind is not needed any more.
    const auto done = static_cast<std::int64_t>(std::floor(next_bit - 2.0 * period)) - 4 - values_start;
    if (done > 4096) {
      const auto drop =
          static_cast<std::ptrdiff_t>(std::min<std::int64_t>(done, static_cast<std::int64_t>(values.size())));
      values.erase(values.begin(), values.begin() + drop);
      values_start += drop;
      std::erase_if(missing, [&](const auto& gap) { return gap.second < static_cast<double>(values_start); });
    }
    status.locked = locked;
    status.clock_offset = nominal_period / period - 1.0;
    status.timing_error = std::sqrt(timing_square);
    status.amplitude = amplitude;
  }
};

InertialWordDecoder::InertialWordDecoder(const WordFormat& format, SampleRate rate, int board)
    : impl_(std::make_unique<Impl>(format, rate, board)) {
  impl_->reversed.assign(impl_->taps.rbegin(), impl_->taps.rend());
}
InertialWordDecoder::~InertialWordDecoder() = default;
InertialWordDecoder::InertialWordDecoder(InertialWordDecoder&&) noexcept = default;
InertialWordDecoder& InertialWordDecoder::operator=(InertialWordDecoder&&) noexcept = default;

void InertialWordDecoder::push(const float* samples, std::size_t count, std::size_t stride) {
  Impl& d = *impl_;
  // Fixed stretches of the stream, so that memory does not depend on the block.
  while (count > 0) {
    const std::size_t part = std::min<std::size_t>(count, 4096);
    const std::size_t old = d.input.size();
    d.input.resize(old + part);
    for (std::size_t i = 0; i < part; ++i) {
      const float sample = samples[i * stride];
      d.input[old + i] = std::isfinite(sample) ? sample : 0.0F;
    }
    d.input_end += static_cast<std::int64_t>(part);
    samples += part * stride;
    count -= part;
    d.filter();
    d.advance();
  }
}

void InertialWordDecoder::gap(SampleCount count) {
  if (count.value <= 0) {
    return;
  }
  Impl& d = *impl_;
  const double reach = static_cast<double>(d.taps.size()) / d.step;
  d.missing.emplace_back(static_cast<double>(d.input_end) / d.step - 1.0,
                         static_cast<double>(d.input_end + count.value) / d.step + reach + 1.0);
  const std::vector<float> silence(4096, 0.0F);
  for (std::int64_t left = count.value; left > 0; left -= 4096) {
    push(silence.data(), static_cast<std::size_t>(std::min<std::int64_t>(left, 4096)), 1);
  }
}

std::vector<InertialReading> InertialWordDecoder::take_readings() {
  std::vector<InertialReading> readings;
  std::swap(readings, impl_->readings);
  return readings;
}

double InertialWordDecoder::passed_s() const {
  const Impl& d = *impl_;
  // Bits from before the clock was lost are never read.
  return d.seconds_of((!d.timed || d.bit_middles.empty() ? d.next_bit : d.bit_middles.front()) - d.period);
}

const WordStatus& InertialWordDecoder::status() const {
  return impl_->status;
}

}  // namespace limbwave::decode
