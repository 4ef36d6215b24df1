#include "acquire/sound_card.h"

#include <fmt/format.h>
#include <pa_linux_alsa.h>
#include <portaudio.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include "acquire/alsa_probe.h"
#include "acquire/portaudio_session.h"
#include "base/spsc_ring.h"
#include "base/wake_signal.h"

namespace limbwave::acquire {
namespace {

// One period of the device: what a frame waits at most before the callback gets it.
constexpr double kPeriodSeconds = 0.010;
// Room in the device's buffer and in ours for when the machine is busy elsewhere. Neither adds latency.
constexpr int kPeriods = 64;
constexpr double kRingSeconds = 8.0;
// A device that delivers nothing for so long is gone, whatever it says.
constexpr double kSilenceSeconds = 3.0;

const std::vector<double> kRates{44100.0, 48000.0, 88200.0, 96000.0, 176400.0, 192000.0};

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

PaSampleFormat pa_format(SampleType type) {
  switch (type) {
    case SampleType::kInt16:
      return paInt16;
    case SampleType::kInt24:
      return paInt24;
    case SampleType::kInt32:
      return paInt32;
    case SampleType::kFloat32:
      return paFloat32;
  }
  return paInt16;
}

bool is_alsa(const PaDeviceInfo& device) {
  return Pa_GetHostApiInfo(device.hostApi)->type == paALSA;
}

std::string short_name(PaHostApiIndex api) {
  const PaHostApiInfo& info = *Pa_GetHostApiInfo(api);
  return info.type == paJACK ? "JACK" : info.name;
}

// Stable across starts, as far as the names of the devices are; equal names are numbered.
std::string device_id(PaDeviceIndex index) {
  const PaDeviceInfo& device = *Pa_GetDeviceInfo(index);
  int same = 1;
  for (PaDeviceIndex other = 0; other < index; ++other) {
    const PaDeviceInfo& info = *Pa_GetDeviceInfo(other);
    same += info.hostApi == device.hostApi && std::string_view(info.name) == device.name ? 1 : 0;
  }
  return fmt::format("portaudio:{}:{}{}", short_name(device.hostApi), device.name,
                     same > 1 ? fmt::format("#{}", same) : "");
}

// PortAudio names cards "HDA Intel: ALC (hw:0,0)" and everything else as ALSA does.
std::string alsa_name(const std::string& name) {
  const std::size_t begin = name.rfind("(hw:");
  const bool is_card = begin != std::string::npos && name.back() == ')';
  return is_card ? name.substr(begin + 1, name.size() - begin - 2) : name;
}

PaStreamParameters parameters_for(PaDeviceIndex index, int channels, SampleType type) {
  PaStreamParameters parameters{};
  parameters.device = index;
  parameters.channelCount = channels;
  parameters.sampleFormat = pa_format(type);
  parameters.suggestedLatency = kPeriodSeconds * kPeriods;
  return parameters;
}

DeviceInfo describe(PaDeviceIndex index) {
  const PaDeviceInfo& device = *Pa_GetDeviceInfo(index);
  DeviceInfo info;
  info.id = device_id(index);
  info.title = fmt::format("{} ({})", device.name, short_name(device.hostApi));
  info.channels = device.maxInputChannels;
  info.default_rate_hz = device.defaultSampleRate;
  info.is_default = index == Pa_GetDefaultInputDevice();
  const AlsaOffer offer = is_alsa(device) ? probe_alsa(alsa_name(device.name), 2, kRates) : AlsaOffer{};
  if (offer.answered) {
    info.rates_hz = offer.rates_hz;
    info.types = offer.types;
    return info;
  }
  info.types = {SampleType::kFloat32};  // what JACK has, and what PortAudio can convert everything to
  const PaStreamParameters parameters = parameters_for(index, 2, SampleType::kFloat32);
  std::copy_if(kRates.begin(), kRates.end(), std::back_inserter(info.rates_hz),
               [&](double rate) { return Pa_IsFormatSupported(&parameters, nullptr, rate) == paFormatIsSupported; });
  return info;
}

std::optional<Error> check_format(const DeviceInfo& device, const StreamFormat& wanted) {
  if (wanted.channels < 1 || wanted.channels > device.channels) {
    return Error{fmt::format("has {} channels, not {}", device.channels, wanted.channels), device.id,
                 "choose another device"};
  }
  if (std::find(device.types.begin(), device.types.end(), wanted.type) == device.types.end()) {
    std::string offered;
    for (const SampleType type : device.types) {
      offered += (offered.empty() ? "" : ", ") + std::string(name(type));
    }
    return Error{fmt::format("does not give {} samples", name(wanted.type)), device.id, "it offers " + offered};
  }
  return std::nullopt;
}

// The stream and everything that its callback touches.
struct CardStream {
  CardStream(std::unique_ptr<PortAudioSession> session, DeviceInfo info, StreamFormat stream_format)
      : portaudio(std::move(session)),
        device(std::move(info)),
        format(stream_format),
        ring(static_cast<std::size_t>(kRingSeconds * format.rate.hz) * format.bytes_per_frame()) {}
  ~CardStream() {
    const std::lock_guard guard(portaudio_lock());
    if (stream != nullptr) {
      Pa_CloseStream(stream);
    }
  }
  CardStream(const CardStream&) = delete;
  CardStream& operator=(const CardStream&) = delete;

  Status open(PaDeviceIndex index);
  [[nodiscard]] bool alive() const {
    return !finished.load(std::memory_order_acquire) &&
           now_s() - newest_s.load(std::memory_order_relaxed) < kSilenceSeconds;
  }
  static int callback(const void* input, void* output, unsigned long frames, const PaStreamCallbackTimeInfo* time,
                      PaStreamCallbackFlags flags, void* self);
  // Samples are missing behind what has been written; `frames` is 0 where the device does not say how many.
  void lost(std::uint64_t frames) {
    lost_at.store(written, std::memory_order_relaxed);
    dropped_frames.fetch_add(frames, std::memory_order_release);
    overflows.fetch_add(1, std::memory_order_release);
  }

  std::unique_ptr<PortAudioSession> portaudio;
  DeviceInfo device;
  StreamFormat format;
  PaStream* stream = nullptr;
  SpscRing<std::byte> ring;
  // Written by the callback alone.
  std::atomic<std::uint64_t> overflows{0};
  std::atomic<std::uint64_t> dropped_frames{0};
  std::atomic<std::int64_t> lost_at{0};
  std::int64_t written = 0;  // frames in the ring so far
  std::atomic<double> newest_s{0.0};
  std::atomic<double> latency_s{0.0};
  std::atomic<bool> has_frames{false};
  std::atomic<bool> finished{false};
  WakeSignal arrived;
};

class SoundCard : public LiveSource {
 public:
  explicit SoundCard(std::shared_ptr<CardStream> stream) : card_(std::move(stream)) {}
  ~SoundCard() override { stop(); }
  SoundCard(const SoundCard&) = delete;
  SoundCard& operator=(const SoundCard&) = delete;

  Status start() override;
  void stop() override;

  [[nodiscard]] StreamFormat format() const override { return card_->format; }
  [[nodiscard]] std::string title() const override { return card_->device.title; }
  std::size_t pull(std::span<std::byte> out) override {
    const std::size_t frame = card_->format.bytes_per_frame();
    return card_->ring.read(out.first(out.size() / frame * frame));
  }
  void wait(double timeout_s) override { (void)card_->arrived.wait_for(std::chrono::duration<double>(timeout_s)); }
  [[nodiscard]] SourceCounters counters() const override {
    // The place last: it is never before the losses that are counted here.
    SourceCounters counters;
    counters.overflows = card_->overflows.load(std::memory_order_acquire);
    counters.dropped_frames = card_->dropped_frames.load(std::memory_order_acquire);
    counters.lost_at = card_->lost_at.load(std::memory_order_relaxed);
    return counters;
  }
  [[nodiscard]] bool alive() const override { return !running_ || card_->alive(); }
  [[nodiscard]] double device_latency_s() const override { return card_->latency_s.load(std::memory_order_relaxed); }
  [[nodiscard]] double newest_frame_time_s() const override {
    return card_->has_frames.load(std::memory_order_acquire) ? card_->newest_s.load(std::memory_order_relaxed) : 0.0;
  }

 private:
  std::shared_ptr<CardStream> card_;
  std::atomic<bool> running_{false};
  std::atomic<bool> gone_{false};
};

// On the device's own thread: copies, counts and rings the bell, nothing else.
int CardStream::callback(const void* input, void* /*output*/, unsigned long frames,
                         const PaStreamCallbackTimeInfo* time, PaStreamCallbackFlags flags, void* self_pointer) {
  auto& self = *static_cast<CardStream*>(self_pointer);
  if ((flags & paInputOverflow) != 0) {
    self.lost(0);
  }
  if (input == nullptr || frames == 0) {
    return paContinue;
  }
  // Before the frames are there for the other side: what it has pulled is then never newer than this.
  self.newest_s.store(now_s(), std::memory_order_relaxed);
  const std::span bytes(static_cast<const std::byte*>(input), frames * self.format.bytes_per_frame());
  if (self.ring.write(bytes)) {
    self.written += static_cast<std::int64_t>(frames);
  } else {
    self.lost(frames);
  }
  const double delay = time->currentTime - time->inputBufferAdcTime;
  if (delay > 0.0 && delay < 10.0) {
    const double before = self.latency_s.load(std::memory_order_relaxed);
    self.latency_s.store(before == 0.0 ? delay : before + 0.05 * (delay - before), std::memory_order_relaxed);
  }
  self.has_frames.store(true, std::memory_order_release);
  self.arrived.notify();
  return paContinue;
}

Status CardStream::open(PaDeviceIndex index) {
  const PaStreamParameters parameters = parameters_for(index, format.channels, format.type);
  PaAlsa_SetNumPeriods(kPeriods);
  // Without dithering and clipping the samples arrive as they are.
  const PaError error = Pa_OpenStream(&stream, &parameters, nullptr, format.rate.hz, paFramesPerBufferUnspecified,
                                      paClipOff | paDitherOff, &CardStream::callback, this);
  if (error == paInvalidSampleRate) {
    std::string offered;
    for (const double rate : device.rates_hz) {
      offered += fmt::format("{}{:.0f}", offered.empty() ? "" : ", ", rate);
    }
    return Error{fmt::format("does not run at {:.0f} Hz", format.rate.hz), device.id,
                 "it offers " + (offered.empty() ? "nothing just now" : offered)};
  }
  if (error != paNoError) {
    return Error{fmt::format("cannot be opened ({})", Pa_GetErrorText(error)), device.id,
                 "check that no other program uses it"};
  }
  if (Pa_GetHostApiInfo(Pa_GetDeviceInfo(index)->hostApi)->type == paALSA) {
    PaAlsa_EnableRealtimeScheduling(stream, 1);  // where the system allows it
  }
  Pa_SetStreamFinishedCallback(
      stream, [](void* self) { static_cast<CardStream*>(self)->finished.store(true, std::memory_order_release); });
  return {};
}

Status SoundCard::start() {
  const std::lock_guard guard(portaudio_lock());
  if (running_) {
    return {};
  }
  if (gone_) {
    return Error{"is gone", card_->device.id, "check that it is still connected, and open it again"};
  }
  card_->finished.store(false, std::memory_order_release);
  card_->newest_s.store(now_s(), std::memory_order_relaxed);  // silence is counted from here
  const PaError error = Pa_StartStream(card_->stream);
  if (error != paNoError) {
    return Error{fmt::format("does not start ({})", Pa_GetErrorText(error)), card_->device.id,
                 "check that it is still connected and that no other program uses it"};
  }
  running_ = true;
  return {};
}

// A stream whose device is gone is ended beside everything else, on a thread of its own and without the lock, which
// others need meanwhile: JACK lets whoever stops a stream of a server that is gone wait for ten minutes.
void SoundCard::stop() {
  if (!running_.exchange(false)) {
    return;
  }
  if (card_->alive()) {
    const std::lock_guard guard(portaudio_lock());
    Pa_AbortStream(card_->stream);
    return;
  }
  gone_ = true;
  std::thread([gone = card_] { Pa_AbortStream(gone->stream); }).detach();
}

}  // namespace

Result<std::vector<DeviceInfo>> list_devices() {
  const std::lock_guard guard(portaudio_lock());
  const Result<std::unique_ptr<PortAudioSession>> portaudio = PortAudioSession::start();
  if (!portaudio) {
    return portaudio.error();
  }
  std::vector<DeviceInfo> devices;
  for (PaDeviceIndex index = 0; index < Pa_GetDeviceCount(); ++index) {
    if (Pa_GetDeviceInfo(index)->maxInputChannels >= 2) {
      devices.push_back(describe(index));
    }
  }
  std::stable_partition(devices.begin(), devices.end(), [](const DeviceInfo& device) { return device.is_default; });
  return devices;
}

Result<int> find_sound_device(const std::string& id) {
  if (id == "default") {
    const PaDeviceIndex index = Pa_GetDefaultInputDevice();
    return index != paNoDevice ? Result<int>(index)
                               : Error{"there is no sound card to capture from", id, "connect one"};
  }
  for (PaDeviceIndex index = 0; index < Pa_GetDeviceCount(); ++index) {
    if (device_id(index) == id) {
      return index;
    }
  }
  return Error{"there is no such device", id, "connect it, or choose one that `limbwave devices` lists"};
}

Result<std::unique_ptr<LiveSource>> open_sound_card(const std::string& id, const StreamFormat& wanted) {
  const std::lock_guard guard(portaudio_lock());
  Result<std::unique_ptr<PortAudioSession>> portaudio = PortAudioSession::start();
  if (!portaudio) {
    return portaudio.error();
  }
  const Result<int> index = find_sound_device(id);
  if (!index) {
    return index.error();
  }
  DeviceInfo device = describe(*index);
  if (std::optional<Error> error = check_format(device, wanted)) {
    return *std::move(error);
  }
  auto stream = std::make_shared<CardStream>(*std::move(portaudio), std::move(device), wanted);
  if (Status status = stream->open(*index); !status) {
    return status.error();
  }
  return std::unique_ptr<LiveSource>(std::make_unique<SoundCard>(std::move(stream)));
}

}  // namespace limbwave::acquire
