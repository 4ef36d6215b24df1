/// Ultrasonic ranging on one wire: from samples to one reading per pulse. A streaming stage: results do not depend on
/// how the samples are cut into blocks.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/time.h"
#include "decode/range_reading.h"
#include "decode/ranging_format.h"

namespace limbwave::decode {

class PulseShape;

class RangingDecoder {
 public:
  /// What a pose filter expects of a source at a time; empty where it does not know.
  using Predict = std::function<std::optional<RangePrediction>(int source, Seconds emission)>;

  /// The first source fires at sample 0. `receiver` is what readings will carry. Decoders of one box may share a shape
  /// (`shared_shape`).
  RangingDecoder(const RangingFormat& format, SampleRate rate, int receiver, const RangingParameters& parameters = {},
                 std::shared_ptr<const PulseShape> shape = nullptr);
  ~RangingDecoder();
  RangingDecoder(RangingDecoder&&) noexcept;
  RangingDecoder& operator=(RangingDecoder&&) noexcept;

  [[nodiscard]] std::shared_ptr<const PulseShape> shape() const;
  void set_prediction(Predict predict);

  /// The next samples of the wire, `stride` apart.
  void push(const float* samples, std::size_t count, std::size_t stride);
  /// Samples are missing here; slots that they cut give readings that say so.
  void gap(SampleCount count);
  /// No more samples: the last slots, as far as they reach.
  void finish();

  /// One reading per pulse since the last call, in order of emission.
  std::vector<RangeReading> take_readings();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::decode
