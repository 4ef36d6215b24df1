#include "simulate/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/units.h"

namespace limbwave::simulate {

SensorVoltages::SensorVoltages(std::shared_ptr<const Wearer> wearer, const body::LineInSignal& board,
                               const LineInErrors& errors, std::uint64_t seed)
    : wearer_(std::move(wearer)),
      board_(board),
      noise_g_(errors.accelerometer_noise / kStandardGravity),
      limit_g_(errors.saturates ? board.range_g : std::numeric_limits<double>::infinity()),
      random_(seed, "accelerometer noise") {}

void SensorVoltages::begin_slot() {
  slot_noise_g_ = noise_g_ > 0.0 ? noise_g_ * random_.normal() : 0.0;
}

double SensorVoltages::volts(int sensor, int axis, double time_s) {
  if (sensor != last_sensor_ || time_s != last_time_) {
    const Vector3d force =
        obliging_ ? obliging_->specific_force(sensor, time_s) : wearer_->specific_force(sensor, time_s);
    last_reading_ = wearer_->sensors()[static_cast<std::size_t>(sensor)].reading_g(force);
    last_sensor_ = sensor;
    last_time_ = time_s;
  }
  const double reading = std::clamp(last_reading_[axis] + slot_noise_g_, -limit_g_, limit_g_);
  return board_.zero_g_volts + board_.volts_per_g * reading;
}

body::Rig simulated_rig(body::Rig rig, std::uint64_t seed) {
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    rig.accelerometers[s].serial = simulated_serial(seed, s);
  }
  return rig;
}

Result<std::unique_ptr<Simulation>> make_simulation(const SimulateSettings& settings) {
  const double rate = settings.format.rate.hz;
  if (!(rate >= 8000.0 && rate <= 768000.0)) {
    return Error{fmt::format("is {} Hz", rate), "sample rate", "use 44100 to 192000"};
  }
  if (settings.format.channels != 2) {
    return Error{fmt::format("is {}", settings.format.channels), "number of channels", "the line-in path is stereo"};
  }
  if (!(settings.seconds >= 0.0 && settings.seconds <= 86400.0)) {
    return Error{fmt::format("is {} s", settings.seconds), "length", "use 0 for the motion's own, up to 86400"};
  }
  const Result<body::Rig> rig = body::load_rig(settings.rig);
  if (!rig) {
    return rig.error();
  }
  const Result<body::Skeleton> skeleton = body::load_skeleton(rig->skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  auto simulation = std::make_unique<Simulation>();
  simulation->rig = *rig;
  simulation->skeleton = *skeleton;
  if (rig->accelerometers.empty() || rig->line_in.slots != 3 * static_cast<int>(rig->accelerometers.size()) + 1) {
    return Error{"has no accelerometers on a line-in board", "rig \"" + rig->name + "\"", "use the rig line-in-arm"};
  }
  const auto wearer = Wearer::create(settings, *rig, *skeleton);
  if (!wearer) {
    return wearer.error();
  }
  simulation->wearer = *wearer;
  simulation->rig = simulated_rig(*rig, settings.seed);
  simulation->voltages =
      std::make_unique<SensorVoltages>(simulation->wearer, rig->line_in, settings.errors, settings.seed);
  if (settings.obliging) {
    SimulateSettings asked = settings;
    asked.prologue = false;
    asked.seconds = 0.0;
    asked.motion = "poses";
    const auto poses = Wearer::create(asked, *rig, *skeleton);
    asked.motion = "range";
    const auto range = Wearer::create(asked, *rig, *skeleton);
    if (!poses || !range) {
      return poses ? range.error() : poses.error();
    }
    simulation->obliging = std::make_shared<ObligingWearer>(simulation->wearer, *poses, *range);
    simulation->voltages->follow(simulation->obliging);
  }
  simulation->stream = std::make_unique<LineInStream>(rig->line_in, settings.errors, settings.format, settings.seed,
                                                      *simulation->voltages);
  return simulation;
}

}  // namespace limbwave::simulate
