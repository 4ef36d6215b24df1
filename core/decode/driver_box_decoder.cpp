#include "decode/driver_box_decoder.h"

#include <algorithm>
#include <functional>
#include <future>
#include <limits>

#include "decode/pulse_shape.h"

namespace limbwave::decode {

namespace {

constexpr double kWordsLate_s = 0.001;  // beyond that a word joined to the one before is there
constexpr std::size_t kStretch = 4096;  // samples at a time
constexpr double kKept_s = 0.1;         // of words

}  // namespace

struct DriverBoxDecoder::Impl {
  explicit Impl(const DriverBoxFormat& box_format) : format(box_format) {}
  DriverBoxFormat format;
  DriverBoxParameters parameters;
  std::vector<RangingDecoder> ranging;
  std::vector<InertialWordDecoder> words;
  std::vector<InertialTrace> traces;
  std::vector<SourceMotion> frames;                // the first one's sources are most
  std::vector<std::vector<RangeReading>> waiting;  // by wire, until every wire has the pulse
  std::vector<InertialReading> inertial;
  bool ended = false;

  [[nodiscard]] std::size_t wires() const { return waiting.size(); }

  // Judges every slot whose words are all there. What is known of a slot does not depend on when that is.
  void settle() {
    for (std::size_t w = 0; w < words.size(); ++w) {
      for (const InertialReading& reading : words[w].take_readings()) {
        traces[w].add(reading);
        inertial.push_back(reading);
      }
    }
    if (ranging.empty()) {
      return;
    }
    double passed = std::numeric_limits<double>::infinity();
    for (const InertialWordDecoder& decoder : words) {
      passed = parameters.inertial && !ended ? std::min(passed, decoder.passed_s()) : passed;
    }
    std::int64_t heard = INT64_MAX;
    for (const RangingDecoder& decoder : ranging) {
      heard = std::min(heard, decoder.heard_slots());
    }
    const RangingFormat& common = format.wires.front();
    for (std::int64_t slot = frames.front().end(); slot < heard; ++slot) {
      const double time_s = pulse_middle_s(common, format.rate, *ranging.front().shape(), slot);
      if (time_s + parameters.words_joined_s + kWordsLate_s > passed) {
        break;
      }
      for (SourceMotion& frame : frames) {
        frame.step(static_cast<int>(slot % static_cast<std::int64_t>(common.sources.size())), time_s, traces);
      }
    }
    each([&](std::size_t w) {
      ranging[w].settle(frames.front().end(), frames, static_cast<int>(w));
      if (ended) {
        ranging[w].settle_end();
      }
    });
    const std::int64_t next = frames.front().end();
    for (SourceMotion& frame : frames) {
      frame.forget(next);
    }
    if (!common.sources.empty()) {
      const double before = pulse_middle_s(common, format.rate, *ranging.front().shape(), next) - kKept_s;
      for (InertialTrace& trace : traces) {
        trace.forget(before);
      }
    }
  }

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
    : impl_(std::make_unique<Impl>(format)) {
  Impl& d = *impl_;
  d.parameters = parameters;
  d.waiting.resize(format.wires.size());
  d.traces.assign(format.wires.size(), InertialTrace(parameters.words_joined_s));
  const BoxGeometry geometry = parameters.inertial ? format.geometry : BoxGeometry{};
  if (!format.wires.empty()) {
    d.frames.emplace_back(format.wires.front(), geometry);
    // Without words a frame other than that of most sources tells nothing more.
    for (const DriverBoxFormat::Frame& other : format.others) {
      if (parameters.inertial) {
        d.frames.emplace_back(other.wires.front(), other.geometry);
      }
    }
  }
  std::shared_ptr<const PulseShape> shape;
  for (int w = 0; w < static_cast<int>(format.wires.size()); ++w) {
    if (parameters.ranges) {
      const auto wire = static_cast<std::size_t>(w);
      std::vector<RangingFrame> frames{{format.wires[wire], geometry}};
      for (std::size_t f = 1; f < d.frames.size(); ++f) {
        frames.push_back({format.others[f - 1].wires[wire], format.others[f - 1].geometry});
      }
      d.ranging.emplace_back(format.rate, w, frames, parameters.ranging, shape);
      shape = d.ranging.back().shape();
    }
    d.words.emplace_back(format.words, format.rate, w);
  }
}
DriverBoxDecoder::~DriverBoxDecoder() = default;

void DriverBoxDecoder::push(std::span<const float> interleaved) {
  Impl& d = *impl_;
  const std::size_t wires = d.wires();
  const std::size_t frames = interleaved.size() / wires;
  d.each([&](std::size_t w) {
    // Out of the frames once for both decoders.
    std::vector<float> line(std::min(frames, kStretch));
    for (std::size_t at = 0; at < frames; at += kStretch) {
      const std::size_t count = std::min(kStretch, frames - at);
      const float* from = interleaved.data() + at * wires + w;
      for (std::size_t i = 0; i < count; ++i) {
        line[i] = from[i * wires];
      }
      if (d.parameters.ranges) {
        d.ranging[w].listen(line.data(), count, 1);
      }
      if (d.parameters.inertial) {
        d.words[w].push(line.data(), count, 1);
      }
    }
  });
  d.settle();
}

void DriverBoxDecoder::gap(SampleCount count) {
  Impl& d = *impl_;
  d.each([&](std::size_t w) {
    if (d.parameters.ranges) {
      d.ranging[w].listen_gap(count);
    }
    if (d.parameters.inertial) {
      d.words[w].gap(count);
    }
  });
  d.settle();
}

void DriverBoxDecoder::finish() {
  Impl& d = *impl_;
  for (RangingDecoder& decoder : d.ranging) {
    decoder.listen_end();
  }
  d.ended = true;
  d.settle();
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
  std::swap(readings, impl_->inertial);
  std::stable_sort(readings.begin(), readings.end(),
                   [](const InertialReading& a, const InertialReading& b) { return a.time < b.time; });
  return readings;
}

const WordStatus& DriverBoxDecoder::words(int board) const {
  return impl_->words.at(static_cast<std::size_t>(board)).status();
}

}  // namespace limbwave::decode
