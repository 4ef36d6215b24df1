/// What a driver box's ranging needs beyond the rig: offsets and phases of the sources, and the speed of sound.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/result.h"

namespace limbwave::calibrate {

/// One source. Its phase turns by phase · u² + phase_2 · u³ radians at u = angle off its normal / 60°.
struct SourceCalibration {
  std::string name;
  double delay_s = 0.0;  ///< By which it starts later than its slot, seconds.
  double phase = 0.0, phase_2 = 0.0;
  double level = 1.0;  ///< Of its amplitude, relative to the rig's.
};

struct RangingCalibration {
  std::string method;                      ///< "nominal", "simulated", "rig", for people.
  double speed_of_sound = 344.6;           ///< m/s.
  std::vector<SourceCalibration> sources;  ///< By source of the rig; may be empty: nominal.
};

Result<RangingCalibration> ranging_calibration_from_json(const nlohmann::json& json, const std::string& place);
nlohmann::json ranging_calibration_to_json(const RangingCalibration& calibration);

/// Speed of sound in air at a temperature and a relative humidity (0..1), m/s: 331.3 sqrt(1 + T / 273.15), and 0.16 of
/// the mole fraction of water vapour more (Cramer 1993, to first order).
double speed_of_sound(double temperature_c, double relative_humidity);

}  // namespace limbwave::calibrate
