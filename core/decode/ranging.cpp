#include "decode/ranging.h"

#include <array>
#include <utility>

namespace limbwave::decode {
std::string_view name(RangeVerdict verdict) {
  constexpr std::array<std::string_view, 7> kNames = {"accepted",     "nothing-heard", "too-weak", "ambiguous",
                                                      "inconsistent", "interrupted",   "disturbed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

double pulse_middle_s(const RangingFormat& format, SampleRate rate, const PulseShape& shape, std::int64_t slot) {
  const auto source = static_cast<std::size_t>(slot % static_cast<std::int64_t>(format.sources.size()));
  return rate.seconds(SampleIndex{slot * format.slot_samples}).value + format.sources[source].delay_s +
         shape.centroid_s();
}

RangingDecoder::RangingDecoder(SampleRate rate, int receiver, const std::vector<RangingFrame>& frames,
                               const RangingParameters& parameters, std::shared_ptr<const PulseShape> shape)
    : format_(frames.front().format),
      listener_(format_, rate, parameters, std::move(shape)),
      alone_(format_, {}),
      resolver_(rate, receiver, frames, parameters, listener_.shape()->centroid_s()),
      rate_(rate) {}

void RangingDecoder::push(const float* samples, std::size_t count, std::size_t stride) {
  listener_.push(samples, count, stride);
  settle_alone();
}

void RangingDecoder::gap(SampleCount count) {
  listener_.gap(count);
  settle_alone();
}

void RangingDecoder::finish() {
  listener_.finish();
  settle_alone();
  resolver_.finish();
}

void RangingDecoder::settle_alone() {
  for (const HeardSlot& heard : listener_.take()) {
    alone_.step(heard.source, pulse_middle_s(format_, rate_, *listener_.shape(), heard.slot), {});
    resolver_.add(heard, {{alone_.at(heard.slot), {}}});
    alone_.forget(heard.slot + 1);
  }
}

void RangingDecoder::settle(std::int64_t until, const std::vector<SourceMotion>& frames, int wire) {
  for (HeardSlot& heard : listener_.take()) {
    waiting_.push_back(heard);
  }
  while (!waiting_.empty() && waiting_.front().slot < until) {
    const HeardSlot& heard = waiting_.front();
    std::vector<TrackerStep> steps;
    steps.reserve(frames.size());
    for (const SourceMotion& frame : frames) {
      steps.push_back({frame.at(heard.slot), frame.board(heard.slot, wire)});
    }
    resolver_.add(heard, std::move(steps));
    waiting_.pop_front();
  }
}

}  // namespace limbwave::decode
