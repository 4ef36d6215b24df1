/// A PortAudio stream that plays and captures at once, frame by frame together.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "acquire/portaudio_session.h"
#include "base/result.h"
#include "base/spsc_ring.h"
#include "base/wake_signal.h"

using PaStream = void;
struct PaStreamCallbackTimeInfo;

namespace limbwave::acquire {

/// What outputs play: a round of samples per output, again and again, from sample 0 when the stream starts.
struct DuplexPlan {
  double rate_hz = 192000.0;
  int inputs = 19, outputs = 9;
  std::int64_t round = 12288;               ///< Frames.
  std::vector<std::vector<float>> samples;  ///< By output, `round` each.
  double backlog_s = 8.0;
};

class DuplexStream {
 public:
  /// Opens a device by its id; `client` names us to JACK.
  static Result<std::unique_ptr<DuplexStream>> open(const std::string& id, DuplexPlan plan, const std::string& client);
  ~DuplexStream();
  /// Ends a stream. One whose device is gone is ended beside everything else, on a thread of its own: JACK lets whoever
  /// stops a stream of a server that is gone wait for ten minutes.
  static void retire(std::unique_ptr<DuplexStream> stream);
  DuplexStream(const DuplexStream&) = delete;
  DuplexStream& operator=(const DuplexStream&) = delete;

  Status start();
  void stop();

  /// Frames lost before frame `at` of those that can be read.
  struct Loss {
    std::int64_t at = 0, frames = 0;
  };
  /// Interleaved samples of all inputs, as many whole frames as there are.
  std::size_t read(std::vector<float>& out);
  /// Losses in order; told before the frames behind them can be read.
  bool next_loss(Loss& loss) { return losses_.read({&loss, 1}) == 1; }
  void wait(double timeout_s);
  /// Outputs leave out so many frames.
  void skip_output(std::int64_t frames) { skip_.fetch_add(frames, std::memory_order_relaxed); }
  /// From a frame on an output to the input that hears it, frames, as the device itself says.
  [[nodiscard]] double reported_delay() const { return delay_.load(std::memory_order_relaxed); }
  /// Times that the device or we lost something.
  [[nodiscard]] std::uint64_t overflows() const { return overflows_.load(std::memory_order_relaxed); }
  [[nodiscard]] bool alive() const;

 private:
  DuplexStream(std::unique_ptr<PortAudioSession> session, DuplexPlan plan);
  static int callback(const void* input, void* output, unsigned long frames, const PaStreamCallbackTimeInfo* time,
                      unsigned long flags, void* self);
  void one(const float* input, float* output, std::int64_t frames, const PaStreamCallbackTimeInfo& time, bool xrun);

  std::unique_ptr<PortAudioSession> session_;
  DuplexPlan plan_;
  PaStream* stream_ = nullptr;
  bool running_ = false;
  std::string id_;
  SpscRing<float> ring_;
  SpscRing<Loss> losses_{1024};
  WakeSignal arrived_;
  std::atomic<std::int64_t> skip_{0};
  std::atomic<double> delay_{0.0}, newest_s_{0.0};
  std::atomic<std::uint64_t> overflows_{0};
  std::atomic<bool> finished_{false};
  // The callback's own.
  std::int64_t played_ = 0, written_ = 0, unwritten_ = 0;
  double next_adc_s_ = -1.0;
};

}  // namespace limbwave::acquire
