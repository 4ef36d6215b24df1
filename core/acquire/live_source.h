/// Where live samples come from: a sound card, a simulator, later a driver box.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "acquire/sample_format.h"
#include "base/result.h"

namespace limbwave::acquire {

/// What can be captured from, as `limbwave devices` lists it.
struct DeviceInfo {
  std::string id;     ///< Stable across starts: "portaudio:ALSA:pulse", "simulator:wave"
  std::string title;  ///< For people.
  int channels = 0;   ///< At most.
  double default_rate_hz = 0;
  std::vector<double> rates_hz;   ///< Those of 44.1 to 192 kHz that it accepts in stereo.
  std::vector<SampleType> types;  ///< Accepted natively.
  bool is_default = false;
};

/// What a source has lost or had to tell since it started. Counters only grow.
struct SourceCounters {
  std::uint64_t overflows = 0;       ///< Times that the device or our ring lost samples.
  std::uint64_t dropped_frames = 0;  ///< Frames known to be lost in our ring.
  /// Where the newest loss is: so many of the frames that can be pulled since the start come before it.
  std::int64_t lost_at = 0;
};

/// A running source. Frames wait in a ring; one consumer thread pulls them.
class LiveSource {
 public:
  virtual ~LiveSource() = default;
  [[nodiscard]] virtual StreamFormat format() const = 0;
  [[nodiscard]] virtual std::string title() const = 0;
  virtual Status start() = 0;
  virtual void stop() = 0;
  /// Copies whole frames that have arrived, as many as fit; returns the bytes written. Never blocks.
  virtual std::size_t pull(std::span<std::byte> out) = 0;
  /// Waits until there may be something to pull, for at most `timeout_s`; the consumer's thread alone. This default
  /// looks again after a millisecond.
  virtual void wait(double timeout_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(timeout_s, 0.001)));
  }
  [[nodiscard]] virtual SourceCounters counters() const = 0;
  /// False once the device is gone (unplugged, server stopped); `pull` then still drains the ring.
  [[nodiscard]] virtual bool alive() const = 0;
  /// Delay of the device's own buffer, seconds, as the device reports it.
  [[nodiscard]] virtual double device_latency_s() const = 0;
  /// Monotonic clock time (std::chrono::steady_clock, seconds) at which the newest frame so far was captured by the
  /// driver; 0 before the first. Told before the frame can be pulled, so that what has been pulled is never newer.
  [[nodiscard]] virtual double newest_frame_time_s() const = 0;
  /// Tells whoever wears the sensors what is asked for now, as the program's screen tells a person: the name of a
  /// stretch of calibration ("range", "pose:GROUP:first"), or nothing. A real device has no ears; a simulated wearer
  /// has.
  virtual void ask(const std::string& /*what*/) {}
};

}  // namespace limbwave::acquire
