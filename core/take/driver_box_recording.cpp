#include "take/driver_box_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace limbwave::take {
namespace {

constexpr double kWait = 0.05;           // seconds
constexpr double kLowBattery = 6.4;      // volts of two lithium cells
constexpr std::int64_t kSilence = 4096;  // frames that are written at a time where samples were lost

}  // namespace

Status box_fits(const body::Rig& rig, const acquire::BoxHello& hello) {
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

body::Rig rig_at_rate(body::Rig rig, double rate_hz) {
  if (rig.driver_box) {
    rig.driver_box->slot_samples =
        static_cast<int>(std::lround(rig.driver_box->slot_samples * rate_hz / rig.driver_box->rate_hz));
    rig.driver_box->rate_hz = rate_hz;
  }
  return rig;
}

std::vector<std::uint8_t> rig_schedule(const body::Rig& rig) {
  std::vector<std::uint8_t> schedule(rig.sources.size());
  std::iota(schedule.begin(), schedule.end(), std::uint8_t{0});
  return schedule;
}

BoxRecording::BoxRecording() = default;
BoxRecording::~BoxRecording() = default;

Result<std::unique_ptr<BoxRecording>> BoxRecording::create(const std::filesystem::path& folder,
                                                           const acquire::BoxSource& box, const body::Rig& rig,
                                                           const body::Skeleton& skeleton, const std::string& subject,
                                                           const calibrate::RangingCalibration& ranging) {
  if (Status fits = box_fits(rig, box.hello()); !fits) {
    return fits.error();
  }
  TakeInfo info;
  info.kind = "driver-box";
  info.subject = subject;
  info.source = box.title();
  info.format = box.format();
  info.rig = rig;
  info.skeleton = skeleton;
  info.ranging = ranging;
  std::unique_ptr<BoxRecording> recording(new BoxRecording);
  recording->frame_bytes_ = info.format.bytes_per_frame();
  recording->round_ = std::int64_t{rig.driver_box->slot_samples} *
                      std::max<std::int64_t>(1, static_cast<std::int64_t>(rig.sources.size()));
  auto recorder = Recorder::create(folder, std::move(info));
  if (!recorder) {
    return recorder.error();
  }
  recording->out_ = *std::move(recorder);
  return recording;
}

void BoxRecording::begin_at(SampleIndex position) {
  position_ = position.value;
  first_ = (position_ + round_ - 1) / round_ * round_;
}

Status BoxRecording::write_piece(const acquire::BoxPiece& piece) {
  const std::int64_t lost_end = position_ + piece.lost;
  std::vector<std::byte> silence;
  for (std::int64_t left = lost_end - std::max(position_, first_); left > 0; left -= kSilence) {
    silence.resize(static_cast<std::size_t>(std::min(left, kSilence)) * frame_bytes_);
    if (Status written = out_->write(silence); !written) {
      return written;
    }
  }
  const auto frames = static_cast<std::int64_t>(piece.bytes.size() / frame_bytes_);
  const std::int64_t skip = std::clamp<std::int64_t>(first_ - lost_end, 0, frames);
  position_ = lost_end + frames;
  const auto bytes = std::span(piece.bytes).subspan(static_cast<std::size_t>(skip) * frame_bytes_);
  return bytes.empty() ? Status() : out_->write(bytes);
}

Status BoxRecording::write_event(const acquire::BoxEvent& event) {
  // Of a gap that was there before the take began the take has the rest.
  const std::int64_t before = std::max<std::int64_t>(0, first_ - event.sample.value);
  const bool gap = event.kind == "dropped";
  if (before > 0 && (!gap || before >= event.count)) {
    return {};
  }
  return out_->add_event({SampleIndex{event.sample.value + before - first_}, event.kind, event.text,
                          gap ? event.count - before : event.count});
}

Status BoxRecording::take_in(const acquire::BoxPart& part) {
  // Events first: a crash then leaves a gap that is told rather than zeros that are not.
  for (const acquire::BoxEvent& event : part.events) {
    if (Status written = write_event(event); !written) {
      return written;
    }
  }
  for (const acquire::BoxPiece& piece : part.pieces) {
    if (Status written = write_piece(piece); !written) {
      return written;
    }
  }
  return {};
}

void BoxRecording::note(const acquire::BoxStatus& status) {
  if (!low_told_ && status.sample > 0 && status.battery_volts < kLowBattery) {
    low_told_ = true;
    (void)out_->add_event({SampleIndex{out_->frames()}, "battery",
                           fmt::format("the box's battery is down to {:.1f} V", status.battery_volts), 0});
  }
}

Status BoxRecording::add_event(const TakeEvent& event) {
  return out_->add_event(event);
}

std::int64_t BoxRecording::frames() const {
  return out_->frames();
}

double BoxRecording::seconds() const {
  return out_->seconds();
}

double BoxRecording::disk_left_s() const {
  return out_->disk_left_s();
}

Result<Take> BoxRecording::close() {
  return out_->close();
}

void BoxRecording::discard() {
  out_->discard();
}

Result<Take> record_driver_box(const std::filesystem::path& folder, acquire::BoxSource& box, const body::Rig& rig,
                               const body::Skeleton& skeleton, const std::string& subject,
                               const calibrate::RangingCalibration& ranging,
                               const std::function<bool(const DriverBoxProgress&)>& go_on) {
  if (Status fits = box_fits(rig, box.hello()); !fits) {
    return fits.error();
  }
  if (Status told = rig.sources.empty() ? Status() : box.set_schedule(rig_schedule(rig)); !told) {
    return told.error();
  }
  auto created = BoxRecording::create(folder, box, rig, skeleton, subject, ranging);
  if (!created) {
    return created.error();
  }
  BoxRecording& out = **created;
  if (Status started = box.start(); !started) {
    out.discard();
    return started.error();
  }
  DriverBoxProgress progress;
  Status written;
  while (written) {
    progress.seconds = out.seconds();
    progress.disk_left_s = out.disk_left_s();
    progress.connected = box.connected();
    progress.counters = box.counters();
    progress.status = box.status();
    out.note(progress.status);
    if (!go_on(progress)) {
      break;
    }
    written = out.take_in(box.pull(kWait));
  }
  box.stop();
  if (written) {
    written = out.take_in(box.pull(0.0));
  }
  Result<Take> take = out.close();
  if (!written && take) {
    return written.error();
  }
  return take;
}

}  // namespace limbwave::take
