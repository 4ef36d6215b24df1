#include "estimate/body_parameters.h"

#include <algorithm>
#include <array>

namespace limbwave::estimate {
namespace {

using P = BodyFilterParameters;

constexpr std::array kNames = {
    NamedParameter{"gyroscope_noise", &P::gyroscope_noise},
    NamedParameter{"gyroscope_relative", &P::gyroscope_relative},
    NamedParameter{"accelerometer_noise", &P::accelerometer_noise},
    NamedParameter{"accelerometer_relative", &P::accelerometer_relative},
    NamedParameter{"range_noise", &P::range_noise},
    NamedParameter{"range_model", &P::range_model},
    NamedParameter{"reading_delay_s", &P::reading_delay_s},
    NamedParameter{"acceleration_walk", &P::acceleration_walk},
    NamedParameter{"root_acceleration_walk", &P::root_acceleration_walk},
    NamedParameter{"acceleration_time", &P::acceleration_time},
    NamedParameter{"gyroscope_bias", &P::gyroscope_bias},
    NamedParameter{"gyroscope_bias_walk", &P::gyroscope_bias_walk},
    NamedParameter{"accelerometer_bias", &P::accelerometer_bias},
    NamedParameter{"accelerometer_bias_walk", &P::accelerometer_bias_walk},
    NamedParameter{"mount_rotation", &P::mount_rotation},
    NamedParameter{"mount_rotation_walk", &P::mount_rotation_walk},
    NamedParameter{"mount_place", &P::mount_place},
    NamedParameter{"mount_place_walk", &P::mount_place_walk},
    NamedParameter{"source_place", &P::source_place},
    NamedParameter{"tissue_angle", &P::tissue_angle},
    NamedParameter{"tissue_turn", &P::tissue_turn},
    NamedParameter{"range_offset", &P::range_offset},
    NamedParameter{"range_offset_walk", &P::range_offset_walk},
    NamedParameter{"sound_scale", &P::sound_scale},
    NamedParameter{"sound_scale_walk", &P::sound_scale_walk},
    NamedParameter{"bone_scale", &P::bone_scale},
    NamedParameter{"rest_pose", &P::rest_pose},
    NamedParameter{"start_rate", &P::start_rate},
    NamedParameter{"start_acceleration", &P::start_acceleration},
    NamedParameter{"given_rotation", &P::given_rotation},
    NamedParameter{"given_place", &P::given_place},
    NamedParameter{"root_speed", &P::root_speed},
    NamedParameter{"root_reach", &P::root_reach},
    NamedParameter{"gate_probability", &P::gate_probability},
    NamedParameter{"limit_softness", &P::limit_softness},
};

}  // namespace

std::span<const NamedParameter> body_parameter_names() {
  return kNames;
}

bool set_body_parameter(BodyFilterParameters& parameters, std::string_view name, double value) {
  const auto* at = std::ranges::find(kNames, name, &NamedParameter::name);
  if (at == kNames.end()) {
    return false;
  }
  parameters.*at->member = value;
  return true;
}

}  // namespace limbwave::estimate
