#include "acquire/duplex_stream.h"

#include <fmt/format.h>
#include <pa_jack.h>
#include <pa_linux_alsa.h>
#include <portaudio.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <thread>
#include <utility>

#include "acquire/sound_card.h"

namespace limbwave::acquire {
namespace {

constexpr double kLatency = 0.02;  // seconds of the device's own buffers
constexpr int kPeriods = 8;        // of ALSA's buffer
constexpr double kSilence = 2.0;   // seconds without a callback, then the device is gone

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

DuplexStream::DuplexStream(std::unique_ptr<PortAudioSession> session, DuplexPlan plan)
    : session_(std::move(session)),
      plan_(std::move(plan)),
      ring_(static_cast<std::size_t>(plan_.backlog_s * plan_.rate_hz) * static_cast<std::size_t>(plan_.inputs)) {}

DuplexStream::~DuplexStream() {
  stop();
  const std::lock_guard guard(portaudio_lock());
  if (stream_ != nullptr) {
    Pa_CloseStream(stream_);
  }
}

void DuplexStream::retire(std::unique_ptr<DuplexStream> stream) {
  if (stream == nullptr || stream->alive() || !stream->running_) {
    return;  // goes at once
  }
  std::thread([gone = std::move(stream)]() mutable {
    Pa_AbortStream(gone->stream_);  // without the lock, which others need meanwhile
    gone->running_ = false;
    gone.reset();
  }).detach();
}

Result<std::unique_ptr<DuplexStream>> DuplexStream::open(const std::string& id, DuplexPlan plan,
                                                         const std::string& client) {
  const std::lock_guard guard(portaudio_lock());
  if (!client.empty()) {
    PaJack_SetClientName(client.c_str());  // before PortAudio starts; JACK alone shows it
  }
  auto session = PortAudioSession::start();
  if (!session) {
    return session.error();
  }
  const auto index = find_sound_device(id);
  if (!index) {
    return index.error();
  }
  const PaDeviceInfo& device = *Pa_GetDeviceInfo(*index);
  if (device.maxInputChannels < plan.inputs || device.maxOutputChannels < plan.outputs) {
    return Error{fmt::format("has {} inputs and {} outputs, but {} and {} are needed", device.maxInputChannels,
                             device.maxOutputChannels, plan.inputs, plan.outputs),
                 id, "use a larger interface, or a rig with fewer boards"};
  }
  std::unique_ptr<DuplexStream> stream(new DuplexStream(*std::move(session), std::move(plan)));
  stream->id_ = id;
  PaStreamParameters in{};
  in.device = *index;
  in.channelCount = stream->plan_.inputs;
  in.sampleFormat = paFloat32;
  in.suggestedLatency = kLatency;
  PaStreamParameters out = in;
  out.channelCount = stream->plan_.outputs;
  PaAlsa_SetNumPeriods(kPeriods);
  const PaError error = Pa_OpenStream(&stream->stream_, &in, &out, stream->plan_.rate_hz, paFramesPerBufferUnspecified,
                                      paClipOff | paDitherOff, &DuplexStream::callback, stream.get());
  if (error != paNoError) {
    stream->stream_ = nullptr;
    return Error{
        fmt::format("cannot play and capture at {:.0f} Hz ({})", stream->plan_.rate_hz, Pa_GetErrorText(error)), id,
        "check that no other program uses it, and choose a rate that it runs at"};
  }
  if (Pa_GetHostApiInfo(device.hostApi)->type == paALSA) {
    PaAlsa_EnableRealtimeScheduling(stream->stream_, 1);  // where the system allows it
  }
  Pa_SetStreamFinishedCallback(stream->stream_, [](void* self) {
    static_cast<DuplexStream*>(self)->finished_.store(true, std::memory_order_release);
  });
  return stream;
}

Status DuplexStream::start() {
  const std::lock_guard guard(portaudio_lock());
  newest_s_ = now_s();
  if (const PaError error = Pa_StartStream(stream_); error != paNoError) {
    return Error{fmt::format("does not start ({})", Pa_GetErrorText(error)), id_,
                 "check that it is still connected and that no other program uses it"};
  }
  running_ = true;
  return {};
}

void DuplexStream::stop() {
  const std::lock_guard guard(portaudio_lock());
  if (std::exchange(running_, false)) {
    Pa_AbortStream(stream_);
  }
}

bool DuplexStream::alive() const {
  return !finished_.load(std::memory_order_acquire) && now_s() - newest_s_.load(std::memory_order_relaxed) < kSilence;
}

std::size_t DuplexStream::read(std::vector<float>& out) {
  const auto inputs = static_cast<std::size_t>(plan_.inputs);
  out.resize(ring_.available() / inputs * inputs);
  out.resize(ring_.read(out));
  return out.size() / inputs;
}

void DuplexStream::wait(double timeout_s) {
  (void)arrived_.wait_for(std::chrono::duration<double>(timeout_s));
}

int DuplexStream::callback(const void* input, void* output, unsigned long frames, const PaStreamCallbackTimeInfo* time,
                           unsigned long flags, void* self) {
  static_cast<DuplexStream*>(self)->one(static_cast<const float*>(input), static_cast<float*>(output),
                                        static_cast<std::int64_t>(frames), *time,
                                        (flags & (paInputOverflow | paInputUnderflow | paOutputUnderflow)) != 0);
  return paContinue;
}

// On the device's own thread: copies and counts, nothing else.
void DuplexStream::one(const float* input, float* output, std::int64_t frames, const PaStreamCallbackTimeInfo& time,
                       bool xrun) {
  if (frames == 0) {
    return;
  }
  newest_s_.store(now_s(), std::memory_order_relaxed);
  std::int64_t lost = 0;
  if (xrun) {
    overflows_.fetch_add(1, std::memory_order_relaxed);
    // Whole buffers are missing, of inputs and outputs alike; their number shows in the device's clock.
    const double late = next_adc_s_ < 0.0 ? 0.0 : (time.inputBufferAdcTime - next_adc_s_) * plan_.rate_hz;
    lost = std::max<std::int64_t>(0, std::llround(late / static_cast<double>(frames))) * frames;
  }
  next_adc_s_ = time.inputBufferAdcTime + static_cast<double>(frames) / plan_.rate_hz;
  const double delay = (time.outputBufferDacTime - time.inputBufferAdcTime) * plan_.rate_hz;
  if (delay >= 0.0 && delay < 10.0 * plan_.rate_hz) {
    delay_.store(delay, std::memory_order_relaxed);
  }
  played_ += lost + skip_.exchange(0, std::memory_order_relaxed);
  if (output != nullptr) {
    std::int64_t at = played_ % plan_.round;
    for (std::int64_t n = 0; n < frames; ++n) {
      for (const std::vector<float>& channel : plan_.samples) {
        *output++ = channel[static_cast<std::size_t>(at)];
      }
      at = at + 1 == plan_.round ? 0 : at + 1;
    }
    played_ += frames;
  }
  unwritten_ += lost;
  if (input == nullptr) {
    unwritten_ += frames;
    return;
  }
  const std::span samples(input, static_cast<std::size_t>(frames) * static_cast<std::size_t>(plan_.inputs));
  if (unwritten_ > 0) {
    const Loss loss{written_, unwritten_};
    if (ring_.capacity() - ring_.available() < samples.size() || !losses_.write({&loss, 1})) {
      unwritten_ += frames;
      return;
    }
    unwritten_ = 0;
  }
  if (ring_.write(samples)) {
    written_ += frames;
  } else {
    overflows_.fetch_add(1, std::memory_order_relaxed);
    unwritten_ += frames;
  }
  arrived_.notify();
}

}  // namespace limbwave::acquire
