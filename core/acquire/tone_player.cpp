#include "acquire/tone_player.h"

#include <pa_linux_alsa.h>
#include <portaudio.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <numbers>
#include <string>
#include <thread>
#include <utility>

#include "acquire/portaudio_session.h"

namespace limbwave::acquire {
namespace {

constexpr double kRounding_s = 0.008;
constexpr double kLatency_s = 0.05;
constexpr auto kKeepOpen = std::chrono::seconds(3);
constexpr unsigned long kBlock = 256;
constexpr int kPeriods = 4;
constexpr std::size_t kWaiting = 8;  // cues; older ones are late anyway

/// The default output, opened for mono.
class Output {
 public:
  static Result<std::unique_ptr<Output>> open() {
    Result<std::unique_ptr<PortAudioSession>> session = PortAudioSession::start();
    if (!session) {
      return session.error();
    }
    const std::lock_guard guard(portaudio_lock());
    const PaDeviceIndex index = Pa_GetDefaultOutputDevice();
    if (index == paNoDevice) {
      return Error{"there is no output for sound", "sound card", "connect a loudspeaker or headphones"};
    }
    std::unique_ptr<Output> output(new Output(*std::move(session), Pa_GetDeviceInfo(index)->defaultSampleRate));
    PaStreamParameters parameters{};
    parameters.device = index;
    parameters.channelCount = std::min(2, Pa_GetDeviceInfo(index)->maxOutputChannels);
    parameters.sampleFormat = paFloat32;
    parameters.suggestedLatency = kLatency_s;
    output->channels_ = parameters.channelCount;
    PaAlsa_SetNumPeriods(kPeriods);  // what captures ask for would delay the tones
    const PaError error =
        Pa_OpenStream(&output->stream_, nullptr, &parameters, output->rate_hz_, kBlock, paNoFlag, nullptr, nullptr);
    if (error != paNoError) {
      output->stream_ = nullptr;
      return failure(error);
    }
    return output;
  }
  ~Output() {
    const std::lock_guard guard(portaudio_lock());
    if (stream_ != nullptr) {
      Pa_CloseStream(stream_);
    }
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Returns when it has been heard.
  Status play(const std::vector<Tone>& tones) {
    const std::vector<float> mono = render_tones(tones, rate_hz_);
    std::vector<float> frames;
    for (const float sample : mono) {
      frames.insert(frames.end(), static_cast<std::size_t>(channels_), sample);
    }
    {
      const std::lock_guard guard(portaudio_lock());
      if (const PaError error = Pa_StartStream(stream_); error != paNoError) {
        return failure(error);
      }
    }
    // Writing waits for the device: without the lock, for others may open theirs meanwhile.
    const PaError written = Pa_WriteStream(stream_, frames.data(), static_cast<unsigned long>(mono.size()));
    const std::lock_guard guard(portaudio_lock());
    Pa_StopStream(stream_);  // plays out what is in the buffer
    return written == paNoError || written == paOutputUnderflowed ? Status() : Status(failure(written));
  }

 private:
  Output(std::unique_ptr<PortAudioSession> session, double rate_hz) : session_(std::move(session)), rate_hz_(rate_hz) {}
  static Error failure(PaError error) {
    return Error{std::string("the output cannot be used (") + Pa_GetErrorText(error) + ")", "sound card",
                 "check that sound works in other programs"};
  }
  std::unique_ptr<PortAudioSession> session_;
  PaStream* stream_ = nullptr;
  double rate_hz_;
  int channels_ = 1;
};

}  // namespace

std::vector<float> render_tones(const std::vector<Tone>& tones, double rate_hz) {
  std::vector<float> samples;
  for (const Tone& tone : tones) {
    const auto count = static_cast<std::size_t>(std::max(0.0, tone.seconds) * rate_hz);
    for (std::size_t i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / rate_hz;
      const double from_end = static_cast<double>(count - i) / rate_hz;
      const double edge = std::clamp(std::min(t, from_end) / kRounding_s, 0.0, 1.0);
      const double envelope = 0.5 - 0.5 * std::cos(std::numbers::pi * edge);
      // A little of the octave: small loudspeakers swallow pure low tones.
      const double phase = 2.0 * std::numbers::pi * tone.hz * t;
      const double wave = 0.8 * std::sin(phase) + 0.2 * std::sin(2.0 * phase);
      samples.push_back(static_cast<float>(tone.loudness * envelope * wave));
    }
  }
  return samples;
}

class TonePlayer::Worker {
 public:
  Worker() : thread_([this](const std::stop_token& stop) { run(stop); }) {}
  ~Worker() { thread_.request_stop(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void add(std::vector<Tone> tones, std::function<void(const Status&)> played) {
    {
      const std::lock_guard lock(mutex_);
      while (waiting_.size() >= kWaiting) {
        waiting_.pop_front();
      }
      waiting_.push_back({std::move(tones), std::move(played)});
    }
    arrived_.notify_one();
  }

 private:
  struct Cue {
    std::vector<Tone> tones;
    std::function<void(const Status&)> played;
  };

  void run(const std::stop_token& stop) {
    std::unique_ptr<Output> output;
    while (!stop.stop_requested()) {
      Cue cue;
      {
        std::unique_lock lock(mutex_);
        const auto waits = [this] { return !waiting_.empty(); };
        if (output != nullptr && !arrived_.wait_for(lock, stop, kKeepOpen, waits) && !stop.stop_requested()) {
          lock.unlock();
          output.reset();
          continue;
        }
        arrived_.wait(lock, stop, waits);
        if (stop.stop_requested()) {
          break;
        }
        cue = std::move(waiting_.front());
        waiting_.pop_front();
      }
      Status status;
      if (output == nullptr) {
        Result<std::unique_ptr<Output>> opened = Output::open();
        if (opened) {
          output = std::move(opened).value();
        } else {
          status = opened.error();
        }
      }
      if (output != nullptr) {
        status = output->play(cue.tones);
        if (!status) {
          output.reset();  // Unplugged: the next cue looks for another one.
        }
      }
      if (cue.played) {
        cue.played(status);
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<Cue> waiting_;
  std::jthread thread_;  // last: it uses the others
};

TonePlayer::TonePlayer() : worker_(std::make_unique<Worker>()) {}
TonePlayer::~TonePlayer() = default;

void TonePlayer::play(std::vector<Tone> tones, std::function<void(const Status&)> played) {
  worker_->add(std::move(tones), std::move(played));
}

}  // namespace limbwave::acquire
