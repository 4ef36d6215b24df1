#include "take/driver_box_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "take/recorder.h"

namespace limbwave::take {
namespace {

constexpr double kWait = 0.05;           // seconds
constexpr double kLowBattery = 6.4;      // volts of two lithium cells
constexpr std::int64_t kSilence = 4096;  // frames that are written at a time where samples were lost

Status write_piece(Recorder& out, const acquire::BoxPiece& piece, std::size_t frame_bytes) {
  std::vector<std::byte> silence;
  for (std::int64_t left = piece.lost; left > 0; left -= kSilence) {
    silence.resize(static_cast<std::size_t>(std::min(left, kSilence)) * frame_bytes);
    if (Status written = out.write(silence); !written) {
      return written;
    }
  }
  return piece.bytes.empty() ? Status() : out.write(piece.bytes);
}

// The box agrees with what the rig says about it.
Status check(const body::Rig& rig, const acquire::BoxHello& hello) {
  if (!rig.driver_box) {
    return Error{"has no driver box", "rig \"" + rig.name + "\"", "use driver-box-body or another with a driver box"};
  }
  const body::DriverBoxSignal& signal = *rig.driver_box;
  if (static_cast<int>(rig.microphones.size()) != hello.wires || std::abs(signal.rate_hz - hello.rate_hz) > 0.5 ||
      signal.slot_samples != hello.slot_samples || static_cast<int>(rig.sources.size()) != hello.sources) {
    return Error{
        fmt::format("is for {} wires and {} sources at {:g} Hz with {} samples a slot, but the box has {} and {} at "
                    "{:g} Hz with {}",
                    rig.microphones.size(), rig.sources.size(), signal.rate_hz, signal.slot_samples, hello.wires,
                    hello.sources, static_cast<double>(hello.rate_hz), hello.slot_samples),
        "rig \"" + rig.name + "\"", "use the rig that belongs to this box"};
  }
  return {};
}

}  // namespace

body::Rig rig_at_rate(body::Rig rig, double rate_hz) {
  if (rig.driver_box) {
    rig.driver_box->slot_samples =
        static_cast<int>(std::lround(rig.driver_box->slot_samples * rate_hz / rig.driver_box->rate_hz));
    rig.driver_box->rate_hz = rate_hz;
  }
  return rig;
}

Result<Take> record_driver_box(const std::filesystem::path& folder, acquire::BoxSource& box, const body::Rig& rig,
                               const body::Skeleton& skeleton, const std::string& subject,
                               const calibrate::RangingCalibration& ranging,
                               const std::function<bool(const DriverBoxProgress&)>& go_on) {
  const acquire::BoxHello hello = box.hello();
  if (Status fits = check(rig, hello); !fits) {
    return fits.error();
  }
  // Decoders take the sources in the rig's order.
  std::vector<std::uint8_t> schedule(rig.sources.size());
  std::iota(schedule.begin(), schedule.end(), std::uint8_t{0});
  if (Status told = schedule.empty() ? Status() : box.set_schedule(schedule); !told) {
    return told.error();
  }
  TakeInfo info;
  info.kind = "driver-box";
  info.subject = subject;
  info.source = box.title();
  info.format = box.format();
  info.rig = rig;
  info.skeleton = skeleton;
  info.ranging = ranging;
  auto recorder = Recorder::create(folder, std::move(info));
  if (!recorder) {
    return recorder.error();
  }
  Recorder& out = **recorder;
  const std::size_t frame_bytes = box.format().bytes_per_frame();
  if (Status started = box.start(); !started) {
    out.discard();
    return started.error();
  }
  DriverBoxProgress progress;
  bool low_told = false;
  Status written;
  const auto take_in = [&](double wait_s) {
    const acquire::BoxPart part = box.pull(wait_s);
    // Events first: a crash then leaves a gap that is told rather than zeros that are not.
    for (const acquire::BoxEvent& event : part.events) {
      if (Status added = out.add_event({event.sample, event.kind, event.text, event.count}); !added) {
        written = added;
      }
    }
    for (auto piece = part.pieces.begin(); written && piece != part.pieces.end(); ++piece) {
      written = write_piece(out, *piece, frame_bytes);
    }
  };
  while (written) {
    progress.seconds = out.seconds();
    progress.disk_left_s = out.disk_left_s();
    progress.connected = box.connected();
    progress.counters = box.counters();
    progress.status = box.status();
    if (!low_told && progress.status.sample > 0 && progress.status.battery_volts < kLowBattery) {
      low_told = true;
      (void)out.add_event({SampleIndex{out.frames()}, "battery",
                           fmt::format("the box's battery is down to {:.1f} V", progress.status.battery_volts), 0});
    }
    if (!go_on(progress)) {
      break;
    }
    take_in(kWait);
  }
  box.stop();
  if (written) {
    take_in(0.0);
  }
  Result<Take> take = out.close();
  if (!written && take) {
    return written.error();
  }
  return take;
}

}  // namespace limbwave::take
