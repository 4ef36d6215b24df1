/// The inertial words of one board as a voltage: readings, coding, the board's own bit clock, smooth edges.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "acquire/inertial_word_format.h"
#include "simulate/random.h"

namespace limbwave::simulate {

using WordReading = std::array<int, acquire::kWordChannels>;  ///< -2048..2047 each.
using WordFrame = std::array<std::uint8_t, acquire::kWordBits>;

/// The extended Golay codeword of 12 bits, by long division (core/acquire/inertial_word_format.h).
std::uint32_t golay_codeword(std::uint32_t data);

/// What a board's processor does to its readings.
class WordEncoder {
 public:
  /// The next frame; tracks what a receiver holds.
  WordFrame next(const WordReading& reading);
  /// What a receiver that lost nothing holds now.
  [[nodiscard]] const WordReading& held() const { return held_; }

 private:
  WordReading held_{};
  int frame_ = 0;  // modulo kScramblingFrames
};

struct WordLineErrors {
  double clock_offset = 0.0;  ///< Relative, of this board.
  double drift = 0.0;         ///< Relative RMS.
  double bit_errors = 0.0;    ///< Probability.
};

/// One board's output. The reading is taken when its frame begins.
class WordLine {
 public:
  using Read = std::function<WordReading(double time_s)>;
  WordLine(double word_rate_hz, const WordLineErrors& errors, std::uint64_t seed, int board, Read read);

  /// Adds `amplitude` times the line's level to `count` samples, which go on where the last call ended.
  void add(float* samples, int count, double sample_rate_hz, double amplitude);

  struct SentFrame {
    double start_s = 0.0;
    WordReading held{};
    int wrong_bits = 0;
  };
  /// What was sent, since the last call: every frame that began.
  std::vector<SentFrame> take_sent();

 private:
  void next_frame();
  [[nodiscard]] int level(int bit) const { return frame_[static_cast<std::size_t>(bit)] != 0 ? 1 : -1; }

  double nominal_bit_s_;
  WordLineErrors errors_;
  Random drift_random_, error_random_;
  Read read_;
  WordEncoder encoder_;
  WordFrame frame_{};
  std::vector<SentFrame> sent_;
  double drift_ = 0.0;
  double bit_s_ = 0.0;          // length of a bit of this frame
  double frame_start_s_ = 0.0;  // of `frame_`
  int bit_ = 0;                 // of `frame_`, at present
  int before_ = 1, now_ = 1, after_ = 1;
  double next_start_s_ = 0.0;  // of the next frame
  std::int64_t sample_ = 0;
  double bit_end_s_ = 0.0;
};

}  // namespace limbwave::simulate
