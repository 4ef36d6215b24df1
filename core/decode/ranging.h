/// Ultrasonic ranging on one wire: from samples to one reading per pulse. A streaming stage: results do not depend on
/// how the samples are cut into blocks.
#pragma once

#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "base/time.h"
#include "decode/inertial_trace.h"
#include "decode/pulse_listener.h"
#include "decode/range_reading.h"
#include "decode/range_resolver.h"
#include "decode/ranging_format.h"
#include "decode/source_motion.h"

namespace limbwave::decode {

/// Works by itself (`push`, `finish`), or aided by what boards feel: then `listen` takes samples, and `settle` judges
/// the slots for which the movement of the sources is known.
class RangingDecoder {
 public:
  using Predict = RangeResolver::Predict;

  /// The first source fires at sample 0. `receiver` is what readings will carry. Decoders of one box may share a shape.
  RangingDecoder(const RangingFormat& format, SampleRate rate, int receiver, const RangingParameters& parameters = {},
                 std::shared_ptr<const PulseShape> shape = nullptr)
      : RangingDecoder(rate, receiver, {{format, {}}}, parameters, std::move(shape)) {}
  /// In several frames, of which the first has most sources. Every source is resolved in the frame that it is fixed in.
  RangingDecoder(SampleRate rate, int receiver, const std::vector<RangingFrame>& frames,
                 const RangingParameters& parameters, std::shared_ptr<const PulseShape> shape);

  [[nodiscard]] const std::shared_ptr<const PulseShape>& shape() const { return listener_.shape(); }
  /// What a pose filter expects of a source at a time; empty where it does not know.
  void set_prediction(Predict predict) { resolver_.set_prediction(std::move(predict)); }

  /// The next samples of the wire, `stride` apart.
  void push(const float* samples, std::size_t count, std::size_t stride);
  /// Samples are missing here; slots that they cut give readings that say so.
  void gap(SampleCount count);
  /// No more samples: the last slots, as far as they reach.
  void finish();

  void listen(const float* samples, std::size_t count, std::size_t stride) { listener_.push(samples, count, stride); }
  void listen_gap(SampleCount count) { listener_.gap(count); }
  void listen_end() { listener_.finish(); }
  /// Slots up to `until` (exclusive), for which all `frames` have steps, as the board of `wire` felt them.
  void settle(std::int64_t until, const std::vector<SourceMotion>& frames, int wire);
  void settle_end() { resolver_.finish(); }
  /// Slots that have been listened to.
  [[nodiscard]] std::int64_t heard_slots() const { return listener_.slots(); }

  /// One reading per pulse since the last call, in order of emission.
  std::vector<RangeReading> take_readings() { return resolver_.take(); }

 private:
  void settle_alone();

  RangingFormat format_;
  PulseListener listener_;
  SourceMotion alone_;
  RangeResolver resolver_;
  SampleRate rate_;
  std::deque<HeardSlot> waiting_;
};

/// When the middle of the pulse of a slot leaves its source, seconds.
double pulse_middle_s(const RangingFormat& format, SampleRate rate, const PulseShape& shape, std::int64_t slot);

}  // namespace limbwave::decode
