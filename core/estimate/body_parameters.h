/// The body filter's noises by name: for files, tables and automatic tuning.
#pragma once

#include <span>
#include <string_view>

#include "estimate/body_filter.h"

namespace limbwave::estimate {

struct NamedParameter {
  std::string_view name;
  double BodyFilterParameters::*member;
};

/// All parameters that are numbers, by the names of their members.
std::span<const NamedParameter> body_parameter_names();
/// Sets one by name; false where there is none of that name.
bool set_body_parameter(BodyFilterParameters& parameters, std::string_view name, double value);

}  // namespace limbwave::estimate
