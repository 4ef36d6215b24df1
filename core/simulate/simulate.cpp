#include "simulate/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "simulate/simulation.h"
#include "simulate/truth.h"
#include "take/recorder.h"
#include "take/take.h"

namespace limbwave::simulate {
namespace {

constexpr std::int64_t kBlockFrames = 4096;

take::TakeInfo describe(const Simulation& simulation, const SimulateSettings& settings) {
  take::TakeInfo info;
  info.subject = "simulated";
  info.source = fmt::format("simulator: {}, errors {}, seed {}", settings.motion, settings.errors_name, settings.seed);
  info.format = settings.format;
  info.rig = simulation.rig;
  info.skeleton = simulation.skeleton;
  return info;
}

}  // namespace

std::vector<std::string> builtin_motions() {
  return {"arm-raise", "wave", "reach", "walk", "box", "every-joint", "still", "range", "poses", "run", "squat"};
}

Status simulate_take(const std::filesystem::path& folder, const SimulateSettings& settings, const Progress& progress) {
  if (!progress.report(0.0, "preparing the motion")) {
    return cancelled();
  }
  if (const Result<body::Rig> rig = body::load_rig(settings.rig); rig && rig->driver_box) {
    return simulate_driver_box_take(folder, settings, progress);
  }
  const auto made = make_simulation(settings);
  if (!made) {
    return made.error();
  }
  const Simulation& simulation = **made;
  const auto frame = [&](double time_s) {
    return std::max<std::int64_t>(0, std::llround(simulation.stream->frame_at(time_s)));
  };
  const auto frames = frame(simulation.wearer->duration());

  // Not published before `close`: whatever goes wrong below, nothing is left behind.
  take::RecorderSettings recorder_settings;
  recorder_settings.publish_at_close = true;
  auto recorder = take::Recorder::create(folder, describe(simulation, settings), recorder_settings);
  if (!recorder) {
    return recorder.error();
  }
  take::Recorder& out = **recorder;
  const Progress signal = progress.part(0.0, 0.6);
  std::vector<std::byte> block(static_cast<std::size_t>(kBlockFrames) * settings.format.bytes_per_frame());
  std::vector<double> cycle_starts;
  while (simulation.stream->position() < frames) {
    const std::int64_t count = std::min(kBlockFrames, frames - simulation.stream->position());
    const std::span<std::byte> part(block.data(), static_cast<std::size_t>(count) * settings.format.bytes_per_frame());
    simulation.stream->read(part);
    if (Status written = out.write(part); !written) {
      return written;
    }
    const std::vector<double> starts = simulation.stream->take_cycle_starts();
    cycle_starts.insert(cycle_starts.end(), starts.begin(), starts.end());
    if (!signal.report(static_cast<double>(simulation.stream->position()) / static_cast<double>(frames),
                       "simulating the signal")) {
      return cancelled();
    }
  }
  for (const ScriptSegment& segment : simulation.wearer->segments()) {
    const std::int64_t first = std::min(frame(segment.start_s), frames);
    const std::int64_t end = std::min(frame(segment.end_s), frames);
    if (Status added = out.add_segment({segment.name, {first}, {end - first}}); !added) {
      return added;
    }
  }
  if (Status truth = write_truth(out.working_folder() / "truth.json", simulation, settings, frames, cycle_starts,
                                 progress.part(0.6, 1.0));
      !truth) {
    return truth;
  }
  if (!progress.report(1.0, "closing the take")) {
    return cancelled();
  }
  const auto closed = out.close();
  if (!closed) {
    return closed.error();
  }
  return {};
}

}  // namespace limbwave::simulate
