#include "decode/driver_box_decoder.h"

#include <algorithm>
#include <functional>
#include <future>

#include "decode/pulse_shape.h"

namespace limbwave::decode {

struct DriverBoxDecoder::Impl {
  DriverBoxParameters parameters;
  std::vector<RangingDecoder> ranging;
  std::vector<InertialWordDecoder> words;
  std::vector<std::vector<RangeReading>> waiting;  // by wire, until every wire has the pulse

  [[nodiscard]] std::size_t wires() const { return waiting.size(); }

  // `work` for every wire, on several threads.
  void each(const std::function<void(std::size_t)>& work) {
    const auto threads = static_cast<std::size_t>(std::clamp(parameters.threads, 1, 64));
    const auto run = [&](std::size_t begin) {
      for (std::size_t w = begin; w < wires(); w += threads) {
        work(w);
      }
    };
    std::vector<std::future<void>> others;
    for (std::size_t t = 1; t < threads; ++t) {
      others.push_back(std::async(std::launch::async, run, t));
    }
    run(0);
    for (auto& other : others) {
      other.get();
    }
  }
};

DriverBoxDecoder::DriverBoxDecoder(const DriverBoxFormat& format, const DriverBoxParameters& parameters)
    : impl_(std::make_unique<Impl>()) {
  impl_->parameters = parameters;
  impl_->waiting.resize(format.wires.size());
  std::shared_ptr<const PulseShape> shape;
  for (int w = 0; w < static_cast<int>(format.wires.size()); ++w) {
    if (parameters.ranges) {
      impl_->ranging.emplace_back(format.wires[static_cast<std::size_t>(w)], format.rate, w, parameters.ranging, shape);
      shape = impl_->ranging.back().shape();
    }
    impl_->words.emplace_back(format.words, format.rate, w);
  }
}
DriverBoxDecoder::~DriverBoxDecoder() = default;

void DriverBoxDecoder::push(std::span<const float> interleaved) {
  Impl& d = *impl_;
  const std::size_t wires = d.wires();
  const std::size_t frames = interleaved.size() / wires;
  d.each([&](std::size_t w) {
    if (d.parameters.ranges) {
      d.ranging[w].push(interleaved.data() + w, frames, wires);
    }
    if (d.parameters.inertial) {
      d.words[w].push(interleaved.data() + w, frames, wires);
    }
  });
}

void DriverBoxDecoder::gap(SampleCount count) {
  Impl& d = *impl_;
  d.each([&](std::size_t w) {
    if (d.parameters.ranges) {
      d.ranging[w].gap(count);
    }
    if (d.parameters.inertial) {
      d.words[w].gap(count);
    }
  });
}

void DriverBoxDecoder::finish() {
  for (RangingDecoder& decoder : impl_->ranging) {
    decoder.finish();
  }
}

void DriverBoxDecoder::set_prediction(int receiver, RangingDecoder::Predict predict) {
  if (impl_->parameters.ranges) {
    impl_->ranging.at(static_cast<std::size_t>(receiver)).set_prediction(std::move(predict));
  }
}

std::vector<RangeReading> DriverBoxDecoder::take_ranges() {
  Impl& d = *impl_;
  std::vector<RangeReading> readings;
  if (d.ranging.empty()) {
    return readings;
  }
  std::size_t whole = SIZE_MAX;
  for (std::size_t w = 0; w < d.wires(); ++w) {
    const std::vector<RangeReading> fresh = d.ranging[w].take_readings();
    d.waiting[w].insert(d.waiting[w].end(), fresh.begin(), fresh.end());
    whole = std::min(whole, d.waiting[w].size());
  }
  readings.reserve(whole * d.wires());
  for (std::size_t i = 0; i < whole; ++i) {
    for (std::size_t w = 0; w < d.wires(); ++w) {
      readings.push_back(d.waiting[w][i]);
    }
  }
  for (auto& waiting : d.waiting) {
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(whole));
  }
  return readings;
}

std::vector<InertialReading> DriverBoxDecoder::take_inertial() {
  std::vector<InertialReading> readings;
  for (InertialWordDecoder& decoder : impl_->words) {
    const std::vector<InertialReading> fresh = decoder.take_readings();
    readings.insert(readings.end(), fresh.begin(), fresh.end());
  }
  std::stable_sort(readings.begin(), readings.end(),
                   [](const InertialReading& a, const InertialReading& b) { return a.time < b.time; });
  return readings;
}

const WordStatus& DriverBoxDecoder::words(int board) const {
  return impl_->words.at(static_cast<std::size_t>(board)).status();
}

}  // namespace limbwave::decode
