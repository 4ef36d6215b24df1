#include "calibrate/ranging_calibration.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"

namespace limbwave::calibrate {

Result<RangingCalibration> ranging_calibration_from_json(const nlohmann::json& json, const std::string& place) {
  JsonReader::State state{place, {}};
  const JsonReader reader(json, "", state);
  reader.allow({"method", "speed_of_sound_m_s", "sources"});
  RangingCalibration calibration;
  calibration.method = reader.string_or("method", "");
  calibration.speed_of_sound = reader.at("speed_of_sound_m_s").number(250.0, 450.0);
  if (reader.has("sources")) {
    for (const JsonReader& entry : reader.at("sources").items()) {
      entry.allow({"name", "delay_s", "phase_rad", "phase_2_rad", "level"});
      SourceCalibration source;
      source.name = entry.string_or("name", "");
      source.delay_s = entry.number_or("delay_s", 0.0, -0.01, 0.01);
      source.phase = entry.number_or("phase_rad", 0.0, -10.0, 10.0);
      source.phase_2 = entry.number_or("phase_2_rad", 0.0, -10.0, 10.0);
      source.level = entry.number_or("level", 1.0, 1e-3, 1e3);
      calibration.sources.push_back(source);
    }
  }
  if (state.error) {
    return *state.error;
  }
  return calibration;
}

nlohmann::json ranging_calibration_to_json(const RangingCalibration& calibration) {
  nlohmann::json sources = nlohmann::json::array();
  for (const SourceCalibration& source : calibration.sources) {
    sources.push_back({{"name", source.name},
                       {"delay_s", source.delay_s},
                       {"phase_rad", source.phase},
                       {"phase_2_rad", source.phase_2},
                       {"level", source.level}});
  }
  return {{"method", calibration.method},
          {"speed_of_sound_m_s", calibration.speed_of_sound},
          {"sources", std::move(sources)}};
}

double speed_of_sound(double temperature_c, double relative_humidity) {
  // Magnus: pressure of saturated vapour over that of the air.
  const double vapour =
      relative_humidity * 611.2 * std::exp(17.62 * temperature_c / (243.12 + temperature_c)) / 101325.0;
  return 331.3 * std::sqrt(1.0 + temperature_c / 273.15) * (1.0 + 0.16 * vapour);
}

}  // namespace limbwave::calibrate
