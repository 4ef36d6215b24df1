#include "simulate/word_line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/units.h"

namespace limbwave::simulate {
namespace {

using acquire::kReadingLimit;
using acquire::kWordBits;
using acquire::kWordChannels;

constexpr double kDriftSeconds = 10.0;
constexpr int kEdgeSteps = 2048;

// A step over one bit: the integral of a Blackman–Harris window, so that nothing of it reaches the carrier.
std::array<float, kEdgeSteps + 2> make_edge() {
  std::array<float, kEdgeSteps + 2> edge{};
  for (int i = 0; i <= kEdgeSteps; ++i) {
    const double x = static_cast<double>(i) / kEdgeSteps;
    const double tau = 2.0 * kPi;
    const double area = 0.35875 * x - 0.48829 / tau * std::sin(tau * x) + 0.14128 / (2 * tau) * std::sin(2 * tau * x) -
                        0.01168 / (3 * tau) * std::sin(3 * tau * x);
    edge[static_cast<std::size_t>(i)] = static_cast<float>(area / 0.35875);
  }
  edge[kEdgeSteps + 1] = 1.0F;
  return edge;
}
const std::array<float, kEdgeSteps + 2> kEdge = make_edge();

float edge(double x) {
  const double place = std::clamp(x, 0.0, 1.0) * kEdgeSteps;
  const auto below = static_cast<std::size_t>(place);
  const auto part = static_cast<float>(place - static_cast<double>(below));
  return kEdge[below] + part * (kEdge[below + 1] - kEdge[below]);
}

}  // namespace

std::uint32_t golay_codeword(std::uint32_t data) {
  std::uint32_t remainder = data << 11U;
  for (int bit = 22; bit >= 11; --bit) {
    if (((remainder >> static_cast<unsigned>(bit)) & 1U) != 0) {
      remainder ^= acquire::kGolayGenerator << static_cast<unsigned>(bit - 11);
    }
  }
  const std::uint32_t word = (data << 11U) | remainder;
  unsigned ones = 0;
  for (std::uint32_t rest = word; rest != 0; rest &= rest - 1) {
    ++ones;
  }
  return (word << 1U) | (ones & 1U);
}

WordFrame WordEncoder::next(const WordReading& reading) {
  std::array<std::uint8_t, 48> payload{};
  std::size_t at = 0;
  const auto put = [&](int value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) {
      payload[at++] = static_cast<std::uint8_t>((static_cast<unsigned>(value) >> static_cast<unsigned>(bit)) & 1U);
    }
  };
  for (std::size_t c = 0; c < kWordChannels; ++c) {
    int best = 0;
    int nearest = held_[c];
    for (int code = -32; code < 32; ++code) {
      const int step = acquire::kDeltaSteps[static_cast<std::size_t>(std::abs(code))];
      const int value = std::clamp(held_[c] + (code < 0 ? -step : step), -kReadingLimit, kReadingLimit - 1);
      if (std::abs(value - reading[c]) < std::abs(nearest - reading[c])) {
        best = code;
        nearest = value;
      }
    }
    held_[c] = nearest;
    put(best, 6);
  }
  put(held_[static_cast<std::size_t>(frame_ % kWordChannels)], 12);
  WordFrame sent{};
  for (std::size_t word = 0; word < acquire::kGolayWords; ++word) {
    std::uint32_t data = 0;
    for (std::size_t bit = 0; bit < 12; ++bit) {
      data = (data << 1U) | payload[12 * word + bit];
    }
    const std::uint32_t code = golay_codeword(data);
    for (std::size_t bit = 0; bit < acquire::kGolayBits; ++bit) {
      const std::size_t i = acquire::kGolayWords * bit + word;
      const auto one = static_cast<std::uint8_t>((code >> (23U - bit)) & 1U);
      sent[i] = one ^ acquire::kScrambling[static_cast<std::size_t>(frame_) * kWordBits + i];
    }
  }
  frame_ = (frame_ + 1) % acquire::kScramblingFrames;
  return sent;
}

WordLine::WordLine(double word_rate_hz, const WordLineErrors& errors, std::uint64_t seed, int board, Read read)
    : nominal_bit_s_(1.0 / (word_rate_hz * kWordBits)),
      errors_(errors),
      drift_random_(seed, "word drift " + std::to_string(board)),
      error_random_(seed, "word errors " + std::to_string(board)),
      read_(std::move(read)) {
  // Every board was switched on at its own time.
  Random start(seed, "word start " + std::to_string(board));
  next_start_s_ = -start.uniform() * nominal_bit_s_ * kWordBits;
  drift_ = errors_.drift * drift_random_.normal();
  next_frame();
  bit_ = 0;
  now_ = level(0);
  after_ = level(1);
  bit_end_s_ = frame_start_s_ + bit_s_;
}

void WordLine::next_frame() {
  const double seconds = nominal_bit_s_ * kWordBits;
  const double keep = std::exp(-seconds / kDriftSeconds);
  drift_ = keep * drift_ + errors_.drift * std::sqrt(1.0 - keep * keep) * drift_random_.normal();
  bit_s_ = nominal_bit_s_ / (1.0 + errors_.clock_offset + drift_);
  frame_start_s_ = next_start_s_;
  next_start_s_ += bit_s_ * kWordBits;
  frame_ = encoder_.next(read_(frame_start_s_));
  int wrong = 0;
  if (errors_.bit_errors > 0.0) {
    for (std::uint8_t& bit : frame_) {
      if (error_random_.uniform() < errors_.bit_errors) {
        bit ^= 1U;
        ++wrong;
      }
    }
  }
  sent_.push_back({frame_start_s_, encoder_.held(), wrong});
}

void WordLine::add(float* samples, int count, double sample_rate_hz, double amplitude) {
  for (int n = 0; n < count; ++n) {
    const double time = static_cast<double>(sample_ + n) / sample_rate_hz;
    while (time >= bit_end_s_) {
      before_ = now_;
      now_ = after_;
      // `frame_` is read one bit ahead of the line.
      if (++bit_ == kWordBits) {
        bit_ = 0;
      }
      if (bit_ + 1 == kWordBits) {
        const double end = frame_start_s_ + bit_s_ * kWordBits;
        next_frame();
        after_ = level(0);
        bit_end_s_ = end;
      } else {
        after_ = level(bit_ + 1);
        bit_end_s_ = frame_start_s_ + bit_s_ * (bit_ + 1);
      }
    }
    const double before_end = (bit_end_s_ - time) / bit_s_;  // bits, 0..1
    const double value = before_end > 0.5 ? before_ + (now_ - before_) * edge(1.5 - before_end)
                                          : now_ + (after_ - now_) * edge(0.5 - before_end);
    samples[n] += static_cast<float>(amplitude * value);
  }
  sample_ += count;
}

std::vector<WordLine::SentFrame> WordLine::take_sent() {
  std::vector<SentFrame> sent;
  std::swap(sent, sent_);
  return sent;
}

}  // namespace limbwave::simulate
