/// Wearer, sensors and electronics put together: what `simulate_take` and the live simulator both run.
#pragma once

#include <memory>

#include "body/rig.h"
#include "body/skeleton.h"
#include "simulate/electronics.h"
#include "simulate/obliging_wearer.h"
#include "simulate/simulate.h"
#include "simulate/wearer.h"

namespace limbwave::simulate {

/// The outputs of the rig's accelerometers: specific force through every chip's own errors, with noise and saturation.
class SensorVoltages : public SlotVoltages {
 public:
  SensorVoltages(std::shared_ptr<const Wearer> wearer, const body::LineInSignal& board, const LineInErrors& errors,
                 std::uint64_t seed);
  void begin_slot() override;
  double volts(int sensor, int axis, double time_s) override;
  /// From now on readings are this one's, who is the same person with the same sensors.
  void follow(std::shared_ptr<const ObligingWearer> wearer) { obliging_ = std::move(wearer); }

 private:
  std::shared_ptr<const Wearer> wearer_;
  std::shared_ptr<const ObligingWearer> obliging_;
  body::LineInSignal board_;
  double noise_g_, limit_g_;
  Random random_;
  double slot_noise_g_ = 0.0;
  // The end of one slot is the start of the next one of the same sensor.
  int last_sensor_ = -1;
  double last_time_ = 0.0;
  Vector3d last_reading_ = Vector3d::Zero();
};

/// One simulated world. Not copyable; `stream` yields the signal from its beginning on.
struct Simulation {
  body::Rig rig;  ///< With the simulated sensors' serials.
  body::Skeleton skeleton;
  std::shared_ptr<const Wearer> wearer;
  std::shared_ptr<ObligingWearer> obliging;  ///< Null where nobody listens.
  std::unique_ptr<SensorVoltages> voltages;
  std::unique_ptr<LineInStream> stream;
};

/// Checks the settings and builds everything. Fails on an unknown rig, motion or format.
Result<std::unique_ptr<Simulation>> make_simulation(const SimulateSettings& settings);

}  // namespace limbwave::simulate
