#include "decode/ranging.h"

#include <array>
#include <utility>

namespace limbwave::decode {
namespace {

Eigen::Quaterniond rest_of(const BoxGeometry& geometry, int receiver) {
  const auto w = static_cast<std::size_t>(receiver);
  return w < geometry.R_CS_rest.size() ? geometry.R_CS_rest[w] : Eigen::Quaterniond::Identity();
}

}  // namespace

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

RangingDecoder::RangingDecoder(const RangingFormat& format, SampleRate rate, int receiver,
                               const RangingParameters& parameters, std::shared_ptr<const PulseShape> shape,
                               const BoxGeometry& geometry)
    : format_(format),
      listener_(format, rate, parameters, std::move(shape)),
      alone_(format, {}),
      resolver_(format, rate, receiver, parameters, listener_.shape()->centroid_s(), rest_of(geometry, receiver),
                geometry.reference >= 0 ? geometry.reference_place : Eigen::Vector3d::Zero()),
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
    resolver_.add(heard, {alone_.at(heard.slot), {}});
    alone_.forget(heard.slot + 1);
  }
}

void RangingDecoder::settle(std::int64_t until, const SourceMotion& sources, int wire) {
  for (HeardSlot& heard : listener_.take()) {
    waiting_.push_back(heard);
  }
  while (!waiting_.empty() && waiting_.front().slot < until) {
    const HeardSlot& heard = waiting_.front();
    resolver_.add(heard, {sources.at(heard.slot), sources.board(heard.slot, wire)});
    waiting_.pop_front();
  }
}

}  // namespace limbwave::decode
