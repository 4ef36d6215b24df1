#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/json_text.h"
#include "base/units.h"
#include "simulate/driver_box_stream.h"
#include "simulate/simulate.h"
#include "simulate/text_file.h"
#include "take/recorder.h"

namespace limbwave::simulate {
namespace {

constexpr double kTruthRateHz = 60.0;

// What happened, kept until the take is whole: 250 bytes a pulse, 40 a frame.
struct Happened {
  std::vector<PulseTruth> pulses;
  std::vector<std::vector<WordLine::SentFrame>> frames;
};

void collect(DriverBoxStream& stream, Happened& happened) {
  for (PulseTruth& pulse : stream.take_pulses()) {
    happened.pulses.push_back(std::move(pulse));
  }
  happened.frames.resize(static_cast<std::size_t>(stream.wires()));
  for (int w = 0; w < stream.wires(); ++w) {
    auto& frames = happened.frames[static_cast<std::size_t>(w)];
    const auto sent = stream.take_frames(w);
    frames.insert(frames.end(), sent.begin(), sent.end());
  }
}

const char* comma(bool first) {
  return first ? "" : ",";
}

Status write_driver_box_truth(const std::filesystem::path& path, const DriverBoxActor& actor,
                              const DriverBoxStream& stream, const Happened& happened, const SimulateSettings& settings,
                              const DriverBoxErrors& errors, const body::Rig& rig, double seconds) {
  TextFile file(path);
  file.add("{{\"schema\":1,\"rate_hz\":{},\n\"segments\":[", kTruthRateHz);
  const auto samples = static_cast<std::int64_t>(std::ceil(seconds * kTruthRateHz));
  std::vector<std::vector<FrameJet>> poses(static_cast<std::size_t>(samples));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    actor.frames(static_cast<double>(i) / kTruthRateHz, poses[i]);
  }
  for (std::size_t s = 0; s < actor.skeleton().segments.size(); ++s) {
    file.add("{}\n{{\"name\":{},\"q_WL\":[", comma(s == 0), json_text(actor.skeleton().segments[s].name));
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Quaterniond& q = poses[i][s].R_W.v;
      file.add("{}[{:.8f},{:.8f},{:.8f},{:.8f}]", comma(i == 0), q.w(), q.x(), q.y(), q.z());
    }
    file.add("],\n\"p_WL\":[");
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Vector3d& p = poses[i][s].p_W.v;
      file.add("{}[{:.6f},{:.6f},{:.6f}]", comma(i == 0), p.x(), p.y(), p.z());
    }
    file.add("]}}");
  }
  // One row per pulse: emission sample, source, then range, rate, loss and angle by wire.
  file.add("],\n\"pulses\":[");
  bool first = true;
  for (const PulseTruth& pulse : happened.pulses) {
    file.add("{}\n[{},{},[", comma(first), pulse.emission, pulse.source);
    first = false;
    for (std::size_t w = 0; w < pulse.pairs.size(); ++w) {
      file.add("{}{:.6f}", comma(w == 0), pulse.pairs[w].range);
    }
    file.add("],[");
    for (std::size_t w = 0; w < pulse.pairs.size(); ++w) {
      file.add("{}{:.3f}", comma(w == 0), pulse.pairs[w].rate);
    }
    file.add("],[");
    for (std::size_t w = 0; w < pulse.pairs.size(); ++w) {
      file.add("{}{:.1f}", comma(w == 0), pulse.pairs[w].loss_db);
    }
    file.add("],[");
    for (std::size_t w = 0; w < pulse.pairs.size(); ++w) {
      file.add("{}{:.0f}", comma(w == 0), degrees(pulse.pairs[w].off_axis));
    }
    file.add("]]");
  }
  // By board: frames as start and the six values that a receiver then holds; bits that were sent wrong.
  file.add("],\n\"words\":[");
  for (std::size_t w = 0; w < happened.frames.size(); ++w) {
    std::int64_t wrong = 0;
    file.add("{}\n{{\"name\":{},\"frames\":[", comma(w == 0), json_text(rig.gyroscopes[w].name));
    for (std::size_t i = 0; i < happened.frames[w].size(); ++i) {
      const WordLine::SentFrame& frame = happened.frames[w][i];
      wrong += frame.wrong_bits;
      file.add("{}[{:.7f},{},{},{},{},{},{}]", comma(i == 0), frame.start_s, frame.held[0], frame.held[1],
               frame.held[2], frame.held[3], frame.held[4], frame.held[5]);
    }
    file.add("],\"wrong_bits\":{}}}", wrong);
  }
  nlohmann::json error_json = driver_box_errors_to_json(errors);
  error_json["name"] = settings.errors_name;
  file.add("],\n\"speed_of_sound_m_s\":{},\"motion\":{},\"seed\":{},\n\"errors\":{}}}\n", stream.speed_of_sound(),
           json_text(settings.motion), settings.seed, json_text(error_json));
  if (!file.close()) {
    return Error{"cannot be written", path.string(), "check the space on the disk"};
  }
  return {};
}

}  // namespace

calibrate::RangingCalibration simulated_calibration(const body::Rig& rig, const DriverBoxStream& stream,
                                                    const DriverBoxErrors& errors, std::uint64_t seed) {
  calibrate::RangingCalibration ranging;
  ranging.method = "simulated";
  ranging.speed_of_sound = stream.entered_speed_of_sound();
  Random left(seed, "phase left");
  for (std::size_t s = 0; s < rig.sources.size(); ++s) {
    const SourceTruth& source = stream.sources()[s];
    const double rest = left.uniform(-1.0, 1.0) * errors.phase_left;
    ranging.sources.push_back({rig.sources[s].name, source.delay_s, source.phase - rest, source.phase_2, source.level});
  }
  return ranging;
}

Status simulate_driver_box_take(const std::filesystem::path& folder, const SimulateSettings& settings,
                                const Progress& progress) {
  auto rig = body::load_rig(settings.rig);
  if (!rig) {
    return rig.error();
  }
  if (!rig->driver_box) {
    return Error{"has no driver box", "rig \"" + rig->name + "\"", "use driver-box-body"};
  }
  if (!(settings.seconds >= 0.0 && settings.seconds <= 86400.0)) {
    return Error{fmt::format("is {} s", settings.seconds), "length", "use 0 for the motion's own, up to 86400"};
  }
  const auto skeleton = body::load_skeleton(rig->skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  DriverBoxErrors errors;
  if (settings.driver_box_errors) {
    errors = *settings.driver_box_errors;
  } else {
    const auto loaded = load_driver_box_errors(settings.errors_name);
    if (!loaded) {
      return loaded.error();
    }
    errors = *loaded;
  }
  for (std::size_t s = 0; s < rig->gyroscopes.size(); ++s) {
    rig->gyroscopes[s].serial = fmt::format("SIM-{}-G{}", settings.seed, s + 1);
    rig->accelerometers[s].serial = fmt::format("SIM-{}-A{}", settings.seed, s + 1);
    rig->microphones[s].serial = fmt::format("SIM-{}-M{}", settings.seed, s + 1);
  }
  const auto actor =
      DriverBoxActor::create(settings.motion, settings.motion_metres_per_unit, *rig, *skeleton, errors, settings.seed);
  if (!actor) {
    return actor.error();
  }
  DriverBoxStream stream(*rig, *actor, errors, settings.temperature_c, settings.seed);
  stream.set_threads(static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 8U)));
  const double seconds = settings.seconds > 0.0 ? settings.seconds : (*actor)->duration();
  const auto slots = static_cast<std::int64_t>(std::ceil(seconds * rig->driver_box->rate_hz / stream.slot_samples()));

  take::TakeInfo info;
  info.kind = "driver-box";
  info.subject = "simulated";
  info.source = fmt::format("simulator: {}, errors {}, seed {}", settings.motion, settings.errors_name, settings.seed);
  info.format = {SampleRate{rig->driver_box->rate_hz}, stream.wires(), acquire::SampleType::kInt16};
  info.rig = *rig;
  info.skeleton = *skeleton;
  info.ranging = simulated_calibration(*rig, stream, errors, settings.seed);
  take::RecorderSettings recorder_settings;
  recorder_settings.publish_at_close = true;
  auto recorder = take::Recorder::create(folder, std::move(info), recorder_settings);
  if (!recorder) {
    return recorder.error();
  }
  take::Recorder& out = **recorder;
  std::vector<std::int16_t> block(static_cast<std::size_t>(stream.slot_samples() * stream.wires()));
  Happened happened;
  for (std::int64_t slot = 0; slot < slots; ++slot) {
    stream.next_slot(block);
    if (Status written = out.write(std::as_bytes(std::span(block))); !written) {
      return written;
    }
    collect(stream, happened);
    if (!progress.report(0.9 * static_cast<double>(slot) / static_cast<double>(slots), "simulating the wires")) {
      return cancelled();
    }
  }
  if (Status added = out.add_segment({"capture", {0}, {slots * stream.slot_samples()}}); !added) {
    return added;
  }
  if (Status truth = write_driver_box_truth(out.working_folder() / "truth.json", **actor, stream, happened, settings,
                                            errors, *rig, seconds);
      !truth) {
    return truth;
  }
  const auto closed = out.close();
  if (!closed) {
    return closed.error();
  }
  return {};
}

}  // namespace limbwave::simulate
