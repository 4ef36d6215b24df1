/// All wires of a driver box: ranges and inertial readings, in order. A streaming stage; wires are decoded on several
/// threads, which changes nothing about the results. Ranges are aided by the words: those of the own board tell how the
/// microphone moved, those of the boards beside the sources how these did.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/time.h"
#include "decode/inertial_reading.h"
#include "decode/inertial_words.h"
#include "decode/range_reading.h"
#include "decode/ranging.h"

namespace limbwave::decode {

struct DriverBoxFormat {
  SampleRate rate{140000.0};
  std::vector<RangingFormat> wires;  ///< One per wire, in the frame of the segment that most sources sit on.
  BoxGeometry geometry;              ///< What ranging makes of the words, in that frame.
  /// The same in the frames of other segments with sources and a board of their own.
  struct Frame {
    std::vector<RangingFormat> wires;
    BoxGeometry geometry;
  };
  std::vector<Frame> others;
  WordFormat words;
};

struct DriverBoxParameters {
  RangingParameters ranging;
  bool ranges = true, inertial = true;  ///< What to decode.
  int threads = 2;
  /// Words at most so far apart are joined, and a pulse waits so long for the words around it: 30 ms bridge three lost
  /// words of 140 a second, 7.5 ms none.
  double words_joined_s = 0.030;
};

class DriverBoxDecoder {
 public:
  explicit DriverBoxDecoder(const DriverBoxFormat& format, const DriverBoxParameters& parameters = {});
  ~DriverBoxDecoder();
  DriverBoxDecoder(const DriverBoxDecoder&) = delete;
  DriverBoxDecoder& operator=(const DriverBoxDecoder&) = delete;

  /// Interleaved samples, full scale ±1.
  void push(std::span<const float> interleaved);
  /// Frames are missing on all wires.
  void gap(SampleCount count);
  void finish();

  /// What a pose filter expects, by receiver; see RangingDecoder.
  void set_prediction(int receiver, RangingDecoder::Predict predict);

  /// Readings since the last call: by pulse and wire.
  std::vector<RangeReading> take_ranges();
  /// Readings since the last call, ordered by time and board within what has been pushed.
  std::vector<InertialReading> take_inertial();
  [[nodiscard]] const WordStatus& words(int board) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::decode
